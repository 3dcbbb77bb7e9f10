"""What the C that decides on events has to know of a model: the numbers, tables and functions of `struct Model`
(model.h), for compiled runs (native_events.py) and for exported C.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import prod
from typing import NamedTuple

import casadi as ca

from runtime.contract.tape import shared
from runtime.engine.prepare import Prepared
from runtime.schemes.scheme import SIDES, Scheme
from runtime.schemes.switching.consistency import with_modes
from runtime.schemes.switching.settle import weights
from runtime.schemes.switching.stop_program import StopProgram, restarted
from runtime.schemes.switching.times import may_jump
from runtime.schemes.switching.watched import holds_sides, may_break, observed_function, watched_events, watches

KEPT_OF_A_KINK = 22
MOST_CLOSE = 502
MOST_STOPS = 64
PARTS = 2 * MOST_STOPS + 2
WAYS = {"rising": 1, "falling": -1, "either": 0}
AT = ("q_i", "q_d", "q_i_dot", "q_d_dot", "t")
# functions of `struct Model` that are called behind the step itself, in its order
FUNCTIONS = (
    *("steps", "set_out", "to_grid", "again", "events", "slopes", "actions", "sides", "seen", "weights"),
    *("with_modes", "velocities", "conditions"),
)


class DecisionFunction(NamedTuple):
    """A function of `struct Model`: of arrays by these names; output: the name of its own array, or "" where the first
    one is changed in place, as by steps, with their mathematics.
    """

    function: ca.Function
    inputs: tuple[str, ...]
    output: str = ""


def kept(scheme: Scheme) -> int:
    """How many numbers z has behind those of the step: of the grid, and of kinks that come ever again."""
    if not may_break(scheme):
        return 0
    kinks = len(watched_events(scheme)) - len(scheme.model.description.events)
    return 2 + KEPT_OF_A_KINK * kinks


def decision_functions(scheme: Scheme, prepared: Prepared) -> dict[str, DecisionFunction]:
    """Those that a model has, by name, but for `again` and what tells conditions of time."""
    stages = {stage.name(): stage for stage in StopProgram(scheme, prepared).program().stages()}
    found = {name: DecisionFunction(stages[name], ("z", "c")) for name in ("set_out", "to_grid")}
    if watches(scheme):
        names = ["events", "slopes", *(["actions"] if sets_of(scheme) else [])]
        names += ["sides"] if holds_sides(scheme) else []
        found |= {name: DecisionFunction(observed_function(scheme, name), ("z", "c"), "y") for name in names}
        found["seen"] = DecisionFunction(_seen(scheme), ("z", "c"), "at")
    return found | (_of_elements(scheme) if scheme.model.element_modes.size else {})


def _seen(scheme: Scheme) -> ca.Function:
    """(z, c) -> AT."""
    z, c = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
    shown = scheme.observer(z=z, c=c)
    return ca.Function("seen", [z, c], [ca.densify(ca.vertcat(*(shown[name] for name in AT)))])


def _of_elements(scheme: Scheme) -> dict[str, DecisionFunction]:
    """`weights`, `with_modes`, `velocities` of AT and the model's c: what settle.c calls."""
    model = scheme.model
    n_i, n_d, c = len(model.q_i), len(model.q_d), ca.SX.sym("c", model.c_size)
    at = ca.SX.sym("at", 2 * (n_i + n_d) + 1)
    parts = ca.vertsplit(at, [0, n_i, n_i + n_d, 2 * n_i + n_d, 2 * (n_i + n_d), at.numel()])
    given = {**dict(zip(AT, parts, strict=True)), "c": c}
    found = dict[str, DecisionFunction]()
    for name, of in (("weights", weights(model)), ("with_modes", with_modes(model))):
        there = of.call(given)
        y = ca.vertcat(*(ca.vec(there[output]) for output in of.name_out()))
        found[name] = DecisionFunction(ca.Function("y", [at, c], [y]), ("at", "c"), "y")
    if n_d:
        rates = ca.Function("v", [at, c], [ca.densify(model.evaluate("velocities", **given)["q_d_dot"])])
        found["velocities"] = DecisionFunction(rates, ("at", "c"), "rates")
    return found


def restart_function(scheme: Scheme) -> ca.Function:
    """([state, dt before, dt, clock, inputs, push], c) -> the same with the state as the start of steps dt [s]."""
    size, n_w = scheme.layout.size, scheme.layout.sizes.get("inputs", 0)
    n_v = len(scheme.model.q_i) if watches(scheme) else 0
    z, c = ca.SX.sym("z", size + 3 + n_w + n_v), ca.SX.sym("c", scheme.c_size)
    inputs, push = z[size + 3 : size + 3 + n_w] if n_w else None, z[size + 3 + n_w :] if n_v else None
    found = restarted(scheme, z[:size], c, z[size], z[size + 1], z[size + 2], push, inputs)
    return ca.Function("again", [z, c], shared([ca.densify(ca.vertcat(found, z[size:]))]))


def sets_of(scheme: Scheme) -> list[int]:
    """Which inputs actions set, event by event."""
    names = scheme.model.signals.names
    return [names.index(name) for event in watched_events(scheme) for name in event.sets]


def tables(scheme: Scheme) -> dict[str, list[int]]:
    """The tables of whole numbers of `struct Model`, by name."""
    modes = scheme.model.mode_events
    found = {"sets_of": sets_of(scheme), "modes_at": scheme.model.element_modes.tolist()}
    return found | {f"{name}_of": [getattr(one, name) for one in modes] for name in ("row", "side")}


def sizes(scheme: Scheme, prepared: Prepared, timed: bool = True) -> dict[str, int]:
    """The whole numbers of `struct Model`, by name; timed: are jumps in time looked for as it goes?"""
    made, model, own = StopProgram(scheme, prepared), scheme.model, scheme.layout.slice
    place, events = made.layout.slice, watched_events(scheme)
    jumps = len(model.description.switching) if timed and may_jump(model) else 0
    push = len(model.q_i) if "push" in made.layout.sizes else 0
    ready, n_e, n_d = made.n_ready, len(events), len(model.description.events)
    numbers = {"NZ": prepared.z_size, "NOWN": scheme.layout.size, "NS": made.layout.size, "NREADY": ready}
    numbers |= {"NC": scheme.c_size, "DT_AT": model.c_size, "NU": model.signals.size, "NE": n_e, "ND": n_d}
    numbers |= {"NT": jumps, "NSETS": len(sets_of(scheme)), "NPUSH": push, "KEPT": kept(scheme)}
    numbers |= {"SUB_STEPS": prod(scheme.grid.m)}
    numbers |= {"INPUTS_AT": own("inputs").start if model.signals.size else 0}
    fields = {"VALUES_AT": "event_values", "STEP_AT": "event_step", "CHANGE_AT": "event_change"}
    numbers |= {key: own(name).start for key, name in fields.items() if n_e}
    numbers |= {"SLOPES_AT": own("event_slopes").start} if n_d else {"SLOPES_AT": 0}
    held = len(model.description.held) if holds_sides(scheme) else 0
    numbers |= {"NSIDES": held} | (
        {key: own(n).start for key, n in zip(("SIDE", "BEFORE"), SIDES, strict=True)} if held else {}
    )
    numbers["QUIET_AT"] = own("event_quiet").start if "event_quiet" in scheme.layout.sizes else -1
    names = {"NUMBER": "number", "SEEN": "dt_seen", "START": "start", "LENGTH": "length", "SHARE": "share"}
    numbers |= {key: place(name).start for key, name in names.items()}
    numbers |= {"EVENT_BEFORE": place("event_before").start, "READY": place("ready").start}
    numbers |= {"INPUTS": place("inputs").start, "PUSH": place("push").start if push else 0}
    numbers |= {"CLOCK": place("clock").stop - 1, "ORIGIN": place("origin").stop - 1}
    modes, n_i, n_q = model.mode_events, len(model.q_i), len(model.coordinates)
    n_m, n_v = len(modes), 1 + max((one.row for one in modes), default=-1)
    numbers |= {"NM": n_m, "NV": n_v, "NSTOPS": sum(one.side != 0 for one in modes), "NI": n_i, "NQD": n_q - n_i}
    numbers |= {"NAT": 2 * n_q + 1, "NSEEN": weights(model).nnz_out() if n_m else 0}
    numbers["NTHERE"] = 2 * numbers["NAT"] + numbers["NSEEN"] + model.c_size + n_i * n_v if n_m else 0
    return numbers | _room(numbers)


def _room(of: Mapping[str, int]) -> dict[str, int]:
    """How much of w functions of `stops.c` take: an upper bound, the sum of all that may be in use at one time."""
    row, n_m, n_v, n_t = of["NE"] + 1, of["NM"], of["NV"], of["NT"]
    reals = 3 * of["NZ"] + of["KEPT"] + 4 * PARTS + 28 * row + of["NSIDES"] + of["NU"] + of["NSETS"] + 2
    reals += 4 * of["NI"] + of["NQD"] + 2 * of["NAT"] + 10 * n_v + 5 * n_m**2 + 20 * n_m
    wholes = 4 * row + 14 * n_m + 4 * n_v
    fixed = 3 * of["NS"] + of["NZ"] + of["NREADY"] + 2 * of["NC"] + MOST_CLOSE * row + of["NTHERE"]
    return {
        "NREALS": reals,
        "NWHOLES": wholes,
        "KEPT_IN_W": fixed + 2 * row + 5 * n_t + 3 * MOST_STOPS + reals + wholes,
    }
