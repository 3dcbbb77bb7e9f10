"""Events (zero crossings) in the state of a scheme: their values after the last step, and the first step of a crossing.

An event with a cool-down is not looked for until `event_quiet`, the time at which that of its last happening is over.
Where a load kinks by the motion is watched as events are, behind those that the scene declares: steps end there. Kinks
are seen by the ends of steps alone; what events do between them is looked at, see event_search.py.

The last stages of a step that ends where a load jumps lie on either side of it, by their errors; of the far side they
would add the jump to the error. So a step holds the side on which it begins, for all its stages, as event-driven
methods hold modes until an event (Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, II.6; Acary &
Brogliato, Numerical Methods for Nonsmooth Dynamical Systems, 8.3).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from runtime.contract.records import EventRecord
from runtime.engine.program import Fields, Program, Sequence, Until
from runtime.schemes.scheme import SIDES, Scheme, direct
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.switching.event_search import dips
from runtime.schemes.switching.times import may_jump


class Acted(NamedTuple):
    """What events did: do they end the run?, and what is added to q_i' (n_i,)."""

    ends: bool
    push: np.ndarray


NEVER = 1e300
STEPS_TO_ZERO = 8.0  # steps in which a value comes to zero at its present rate, or at that of the step before


def watch_events(scheme: Scheme) -> None:
    """Give z the fields, where the model has events. Before anything of the scheme is built.

    event_change: by what values changed in the last step; steps of a tolerance end where an event is flagged.
    """
    events = watched_events(scheme)
    if not events or watches(scheme):
        return
    sizes = {"event_values": len(events), "event_step": 1, "event_change": len(events), "event_near": 1}
    declared = len(scheme.model.description.events)
    sizes |= {"event_before": len(events)} if scheme.adaptive else {"event_slopes": declared}
    if any(event.cool_down for event in events) or locates_kinks(scheme):
        sizes["event_quiet"] = len(events)
    scheme.keep_account(sizes, dict.fromkeys(SIDES, len(scheme.model.description.held)) if holds_sides(scheme) else {})


def locates_kinks(scheme: Scheme) -> bool:
    """Do steps end where a load kinks by the motion?"""
    return bool(scheme.model.description.kinks) and scheme.options.kinks == "located"


def holds_sides(scheme: Scheme) -> bool:
    """Do steps hold the sides of jumps by the motion until they end there?"""
    return locates_kinks(scheme) and bool(scheme.model.description.held)


def held_kinks(scheme: Scheme) -> list[int]:
    """Which of the watched events are the kinks whose sides are held, in the order of these."""
    first = len(scheme.model.description.events)
    return [first + k for k in scheme.model.description.held] if holds_sides(scheme) else []


def awake_sides(scheme: Scheme, z: Fields, side: ca.SX, t: ca.SX) -> ca.SX:
    """(n_side,) of these sides zero where a kink is not looked for at t [s], so that steps cross it as it is."""
    first = len(scheme.model.description.events)
    quiet = z["event_quiet"][[first + k for k in scheme.model.description.held]]
    return ca.if_else(quiet > t, 0, side)


def watched_events(scheme: Scheme) -> list[EventRecord]:
    """Those that the scene declares, and behind them the kinks of its loads, by unique names."""
    declared, owners = scheme.model.description.events, scheme.model.description.kinks
    if not locates_kinks(scheme):
        return declared
    kinks = [EventRecord(f"{owner}, kink {owners[:k].count(owner) + 1}", "either") for k, owner in enumerate(owners)]
    return [*declared, *kinks]


def may_break(scheme: Scheme) -> bool:
    """Do steps end at jumps, at events or at kinks of loads?"""
    return bool(watched_events(scheme)) or may_jump(scheme.model)


def are_kinks(scheme: Scheme) -> np.ndarray:
    """(n_e,) which of the watched events are kinks of loads."""
    return np.arange(len(watched_events(scheme))) >= len(scheme.model.description.events)


def sleep(scheme: Scheme, z: np.ndarray, k: int, until: float) -> None:
    """Kink k is not looked for until then [s], in z (n_z,)."""
    z[scheme.layout.slice("event_quiet")][k] = until


def watches(scheme: Scheme) -> bool:
    """Has z the fields?"""
    return "event_step" in scheme.layout.sizes


def event_values(scheme: Scheme, z: np.ndarray, c: np.ndarray) -> np.ndarray:
    """(n_e,) at a state z (at least the scheme's part, flat); c as the stages read it."""
    return _observed(scheme, z, c, "events")


def event_slopes(scheme: Scheme, z: np.ndarray, c: np.ndarray) -> np.ndarray:
    """(n_e,) rates of these values [1/s]."""
    return _observed(scheme, z, c, "slopes")


def _observed(scheme: Scheme, z: np.ndarray, c: np.ndarray, name: str) -> np.ndarray:
    return direct(scheme, name, lambda: observed_function(scheme, name))(z[: scheme.layout.size], c)


def observed_function(scheme: Scheme, name: str) -> ca.Function:
    """(z, c) -> `events`, `slopes` or `actions` at a state; c as the stages read it."""
    symbols = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
    equations = scheme.equations(symbols[1], scheme.layout.unpack(symbols[0]))
    found = values_at(scheme, symbols[0], equations).get(name, ca.SX(0, 1))
    return ca.Function(name, list(symbols), [ca.densify(found)])


def action_values(scheme: Scheme, z: np.ndarray, c: np.ndarray) -> np.ndarray:
    """(n_a,) what inputs become by the events' actions, event by event."""
    return _observed(scheme, z, c, "actions")


def begin_events(scheme: Scheme, z: np.ndarray, c: np.ndarray, shown: np.ndarray | None = None) -> None:
    """Look from a state z (n_z,) on, at least the scheme's part; c as the stages read it.

    shown: the same state as it is seen, where z is at the end of a step that nobody has seen yet.
    """
    if watches(scheme):
        z[scheme.layout.slice("event_values")] = event_values(scheme, z if shown is None else shown, c)
        z[scheme.layout.slice("event_step")] = z[scheme.layout.slice("event_change")] = NEVER
        if "event_slopes" in scheme.layout.sizes:
            slopes = scheme.layout.slice("event_slopes")
            z[slopes] = event_slopes(scheme, z, c)[: slopes.stop - slopes.start]
        if holds_sides(scheme):
            first = len(scheme.model.description.events)
            sides = _observed(scheme, z if shown is None else shown, c, "sides")
            quiet = quiet_until(scheme, z)[[first + k for k in scheme.model.description.held]]
            for name in SIDES:
                z[scheme.layout.slice(name)] = np.where(quiet > scheme.reached(z), 0.0, sides)


def looking(scheme: Scheme, z: Fields, c: ca.SX) -> Fields:
    """Fields of z as expressions, looked at from there on as if no event had happened yet; c as the stages read it."""
    if not watches(scheme):
        return z
    observed, none = (
        values_at(scheme, scheme.layout.pack(z), scheme.equations(c, z)),
        ca.SX.ones(z["event_values"].numel()),
    )
    begun = {
        "event_values": observed["events"],
        "event_slopes": observed["slopes"][: z["event_slopes"].numel()],
        "event_step": ca.SX(NEVER),
    }
    begun |= {"event_change": NEVER * none, "event_quiet": -NEVER * none}
    begun |= {name: observed["sides"] for name in SIDES if "sides" in observed}
    return z | {name: value for name, value in begun.items() if name in z}


def cool_down(scheme: Scheme, z: np.ndarray, happened: list[int], t: float) -> None:
    """These events have happened at t [s], the time of z (n_z,)."""
    if "event_quiet" in scheme.layout.sizes:
        quiet, events = z[scheme.layout.slice("event_quiet")], watched_events(scheme)
        for k in happened:
            quiet[k] = t + events[k].cool_down if events[k].cool_down else -NEVER


def quiet_until(scheme: Scheme, z: np.ndarray) -> np.ndarray:
    """(n_e,) until when events are not looked for [s]."""
    if "event_quiet" in scheme.layout.sizes:
        return z[scheme.layout.slice("event_quiet")]
    return np.full(len(watched_events(scheme)), -NEVER)


def with_events(scheme: Scheme, program: Program) -> Program:
    """A major step, and a look at the events where z has their fields; steps of a tolerance look themselves."""
    if not watches(scheme) or scheme.adaptive:
        return program
    declared = len(scheme.model.description.events)

    def looked(z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        held = {"side_before": z["side"]} if "side" in z else {}
        observed = values_at(scheme, scheme.layout.pack({**z, **held}), equations)
        if held:
            held["side"] = awake_sides(scheme, z, observed["sides"], observed["t"])
        flag = flagged(scheme, z, z["event_values"], observed["events"], observed["t"])
        step = ca.fmin(z["event_step"], ca.if_else(flag, z["n"], NEVER))
        looks = next_values(scheme, z, observed["events"])
        slopes = {"event_slopes": z["event_slopes"] * looks["event_near"]} if declared else {}
        return {**looks, **slopes, **held, "event_step": step}

    def sloped(z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        observed, values = values_at(scheme, scheme.layout.pack(z), equations), z["event_values"]
        new, change, slopes = values[:declared], z["event_change"][:declared], observed["slopes"][:declared]
        dip = dips(new - change, z["event_slopes"], new, slopes, equations.h[0])
        flag = flagged(scheme, z, values, values, observed["t"], dip)
        step = ca.fmin(z["event_step"], ca.if_else(flag, z["n"], NEVER))
        return {"event_slopes": slopes, "event_step": step}

    looking = Sequence((program, scheme.stage("events", looked)))
    if not declared:
        return looking
    near = scheme.layout.slice("event_near").start
    return Sequence((*looking.parts, Until(scheme.stage("event_slopes", sloped), near, 1, usual=0)))


def next_values(scheme: Scheme, z: Fields, new: ca.SX) -> dict[str, ca.SX]:
    """The fields of values (n_e,) after a step. Only of events that may come to zero soon more is looked at."""
    change, near, declared = new - z["event_values"], ca.SX(0), len(scheme.model.description.events)
    for e, now, before in [*zip(*map(ca.vertsplit, (new, change, z["event_change"])), strict=True)][:declared]:
        near = ca.fmax(near, ca.fabs(e) <= STEPS_TO_ZERO * ca.fmax(ca.fabs(now), ca.fabs(before)))
    return {"event_values": new, "event_change": change, "event_near": near}


def flagged(scheme: Scheme, z: Fields, old: ca.SX, new: ca.SX, t: ca.SX, between: ca.SX | None = None) -> ca.SX:
    """Does an event whose cool-down is over by t pass zero between two sets of values (n_e,)?

    between: may it there and back?, of those that the scene declares; see event_search.py.
    """
    found = ca.SX(0)
    for k, event in enumerate(watched_events(scheme)):
        one = passes(old[k], new[k], event.direction)
        one = one if between is None else ca.fmax(one, between[k] if k < between.numel() else 0)
        found = ca.fmax(found, one * (t > z["event_quiet"][k]) if "event_quiet" in z else one)
    return found > 0


def passes(old: Any, new: Any, direction: str) -> Any:
    """Does a value pass zero that way from old to new (SX, or arrays)? One that begins at zero does not."""
    rising, falling = (old < 0) * (new >= 0), (old > 0) * (new <= 0)
    return {"rising": rising, "falling": falling}.get(direction, rising + falling)


def passed(scheme: Scheme, old: np.ndarray, new: np.ndarray, asleep: np.ndarray | None = None) -> list[int]:
    """Which events happen between two sets of values (n_e,); asleep (n_e,): those that do not."""
    events = watched_events(scheme)
    found = [k for k, event in enumerate(events) if passes(old[k], new[k], event.direction)]
    return found if asleep is None else [k for k in found if not asleep[k]]


def values_at(scheme: Scheme, z: ca.SX, equations: StageEquations) -> dict[str, ca.SX]:
    """`events`, their `slopes` (n_e,), what `actions` set, its rates (`drifts`), `sides`, at what z shows, at `t`."""
    observed = scheme.observer(z=z, c=ca.vertcat(equations.c, equations.h))
    names = [f"{part}{end}" for end in ("", "_dot", "_ddot") for part in ("q_i", "q_d")]
    here, along = (ca.vertcat(*(observed[name] for name in own)) for own in (names[:4], names[2:]))
    here, along = ca.vertcat(here, observed["t"]), ca.vertcat(along, 1)
    at = ca.SX.sym("at", here.numel())
    q_i, q_d, v, v_d, t = ca.vertsplit(at, np.cumsum([0, *(observed[name].numel() for name in names[:4]), 1]).tolist())
    found = event_outputs(scheme, equations, ClosedConfiguration(q_i, q_d, t, ca.SX(0), ca.SX(0, 1)), v, v_d)
    rates = {"slopes": "events", "drifts": "actions"}
    found |= {rate: ca.densify(ca.jtimes(found[name], at, along)) for rate, name in rates.items() if name in found}
    new = ca.substitute(list(found.values()), [at], [here])
    return {**dict(zip(found, new, strict=True)), "t": observed["t"]}


def event_outputs(
    scheme: Scheme, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX, v_d: ca.SX
) -> dict[str, ca.SX]:
    """`events` (n_e,), `actions` and `sides` where there are any, at rates v (n_i,), v_d (n_d,).

    A kink without a value there, as that of a root beyond its end, is none.
    """
    model, found, own = scheme.model, dict[str, ca.SX](), ca.SX(0, 1)
    if model.has("events"):
        q, q_dot = equations.joined(motion.q_i, motion.q_d), equations.joined(v, v_d)
        found = model.evaluate("events", q=q, q_dot=q_dot, t=motion.t, c=equations.c)
    if model.element_modes.size:
        at = {"q_i": motion.q_i, "q_d": motion.q_d, "q_i_dot": v, "q_d_dot": v_d, "t": motion.t, "c": equations.c}
        own = model.evaluate("element_forces", **at, q_i_ddot=equations.accelerations(motion, v))["mode_left"]
    values = ca.vertsplit(ca.densify(found["events"])) if found else []
    declared = len(model.description.events) - own.numel()
    kinks = [ca.if_else(ca.fabs(e) < NEVER, e, 1) for e in values[declared:]] if locates_kinks(scheme) else []
    found = {name: ca.densify(value) for name, value in found.items()} | {
        "events": ca.vertcat(*values[:declared], own, *kinks)
    }
    if holds_sides(scheme):
        held = [values[declared + k] for k in model.description.held]
        found["sides"] = ca.vertcat(*(ca.if_else(ca.fabs(e) < NEVER, NEVER * ca.sign(e), 0) for e in held))
    return found
