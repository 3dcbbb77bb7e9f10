"""Major steps in which something jumps are made of parts that end there, each with its own side of the jump.

The grid of major steps stays as it is. A step from t_k with a jump inside is a step from t_k to the jump and one from
there to t_{k+1}. Schemes of one step go on from positions and rates as they are; those that remember earlier steps are
started anew (Eqs. 68-71), with the acceleration of the right side. A part that ends at a jump runs on clocks before
it, one that begins there on clocks after it, so that no rounding of t decides which side a load is on.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import floor, prod

import numpy as np

from runtime.contract.coordinates import independent_rates, whole
from runtime.contract.model import Model
from runtime.schemes.state_fields import Lasting
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.event_search import first_passage
from runtime.schemes.switching.impulse import Impulse, impulse_at, moves_in_time
from runtime.schemes.switching.times import SwitchTime
from runtime.schemes.switching.watched import NEVER, begin_events, event_values, passed, watches
from runtime.schemes.work import account_at, accounted, begin_account, power_of

ON_THE_GRID = 1e-9  # of a step: a jump that near to the end of a step is there
AHEAD = 2  # steps that the account of work looks at in advance
MOST_KEPT = 64  # lengths


@dataclass(frozen=True)
class Leg:
    """Where a part of a step has led: z (whole), its dt [s], work [J]; seen: q and q_dot where rates have jumped.

    reached: its clock [s]; ends: has an event ended the run there?
    """

    z: np.ndarray
    dt: float
    work: float
    seen: tuple[np.ndarray, np.ndarray] | None = None
    reached: float = 0.0
    ends: bool = False


Acts = Callable[[Leg, list[int]], Leg]  # what events (positions) do at a leg's end: inputs in its z, the end of the run


class BrokenSteps:
    """Runs major steps dt [s] of a stepper from t0 on, breaking those in which something jumps.

    impulses: of prescribed motions whose velocity has jumped so far, by time.
    """

    def __init__(self, stepper: Stepper, t0: float, dt: float, switches: Sequence[SwitchTime]) -> None:
        self.stepper, self.t0, self.dt = stepper, t0, dt
        self.impulses: dict[float, Impulse] = {}
        self._moves = moves_in_time(self.model)
        self._remembers = set(stepper.scheme.memory) != {"x", "v", "loop"}
        self._kept: dict[float, np.ndarray] = {}
        self._inside: dict[int, list[SwitchTime]] = {}
        self._on: dict[int, tuple[float, float]] = {}  # step -> clocks on both sides of its start
        for one in switches:
            k = floor((one.time - t0) / dt)
            near = [step for step in (k, k + 1) if abs(one.time - self.time(step)) <= ON_THE_GRID * dt]
            if near:
                before, after = self._on.get(near[0], (np.inf, -np.inf))
                self._on[near[0]] = min(before, one.before), max(after, one.after)
            else:
                self._inside.setdefault(k, []).append(one)
        self._broken = np.unique([*self._inside, *(k - 1 for k in self._on if k > 0)]).astype(int)

    @property
    def model(self) -> Model:
        """Of the scheme."""
        return self.stepper.scheme.model

    def time(self, step: int) -> float:
        """Of the grid [s]."""
        return self.t0 + step * self.dt

    def clock(self, step: int) -> float:
        """The time from which a step starts [s]: after a jump that is there."""
        return max(self.time(step), self._on[step][1]) if step in self._on else self.time(step)

    def next_broken(self, step: int) -> int | None:
        """The first broken step from this one on."""
        k = int(np.searchsorted(self._broken, step))
        return int(self._broken[k]) if k < len(self._broken) else None

    def run(self, z: np.ndarray, ready: np.ndarray, c: np.ndarray, steps: int) -> None:
        """Advance z (whole, flat) in place; c (c_size,) are the model's constants, ready what the program reads."""
        end = int(z[1]) + steps
        while (step := int(z[1])) < end:
            broken = self.next_broken(step)
            if broken == step:
                self._break(z, c)
                continue
            n = end - step if broken is None else min(end, broken) - step
            if z[0] != self.t0:  # the clock was set after a jump at the start of this step
                self.stepper.run(z, ready, 1)
                z[0] = self.t0
            else:
                self.stepper.run(z, ready, n)

    def _break(self, z: np.ndarray, c: np.ndarray, acts: Acts | None = None) -> None:
        """One major step in parts; acts: what events do, where they are looked for."""
        step, flagged, layout = int(z[1]), NEVER, self.stepper.scheme.layout
        if watches(self.stepper.scheme):
            flagged, z[layout.slice("event_step")] = float(z[layout.slice("event_step")][0]), NEVER
        c = self._with_inputs(z, c)
        leg = Leg(z, self.dt, account_at(self.stepper.scheme, z, self._constants(c, self.dt))[0])
        clock = max(z[0] + step * self.dt, self.clock(step))
        on = self._on.get(step + 1)
        ends = [*((one.before, one.after) for one in self._inside.get(step, ())), on or (self.time(step + 1), None)]
        for end, after in ends:
            leg = self._reach(leg, c, clock, end, acts)
            if leg.ends:
                break
            if after is not None:
                leg, clock = self._jumped(c, leg, end, after), after
        start, c = leg.reached if leg.ends else self.clock(step + 1), self._with_inputs(leg.z, c)
        z[:] = self._set_out(leg, c, start, self.dt)
        z[0], z[1] = self.t0 + (start - self.time(step + 1)), step + 1
        if watches(self.stepper.scheme):
            seen = acts is None and z[layout.slice("event_step")][0] < NEVER
            begin_events(self.stepper.scheme, z, self._constants(c, self.dt))
            z[layout.slice("event_step")] = min(flagged, step + 1) if seen else flagged
        self.count_anew(z, c, leg.work)

    def step_with_events(self, z: np.ndarray, c: np.ndarray, acts: Acts) -> None:
        """One major step in which events happen, in place; where one ends the run, z is the state there."""
        z[self.stepper.scheme.layout.slice("event_step")] = NEVER
        self._break(z, c, acts)

    def _reach(self, leg: Leg, c: np.ndarray, start: float, end: float, acts: Acts | None) -> Leg:
        """From one clock to another, through the events on the way."""
        scheme = self.stepper.scheme
        while True:
            c = self._with_inputs(leg.z, c)
            found = self._part(leg, c, start, end)
            if acts is None:
                return found
            start_z, constants = self._set_out(leg, c, start, end - start), self._constants(c, end - start)
            before = event_values(scheme, start_z, constants)
            after = event_values(scheme, found.z, self._constants(c, found.dt))
            if not passed(scheme, before, after):
                return found

            def at(s: float, leg: Leg = leg, start: float = start, c: np.ndarray = c) -> np.ndarray:
                z, length = self._flown(leg, c, start, start + s)
                return event_values(scheme, z, self._constants(c, length))

            s = first_passage(scheme, at, before, after, end - start)
            happened, there = passed(scheme, before, at(s)), self._part(leg, c, start, start + s)
            seen = self._seen(there.z, self._constants(c, there.dt))  # rates as they are before inputs change
            leg, start = acts(replace(there, seen=seen), happened), start + s
            if leg.ends or end - start <= ON_THE_GRID * self.dt:
                return leg

    def _flown(self, leg: Leg, c: np.ndarray, start: float, end: float) -> tuple[np.ndarray, float]:
        """(z, its step) after a step between two clocks, nothing counted."""
        eps = np.finfo(float).eps
        length = (end - start) * (1 - 2 * eps * prod(self.stepper.scheme.grid.m))  # sub-steps add up by rounding
        z = self._set_out(leg, c, start, length)
        self.stepper.run(z, self._ready(c, length), 1)
        return z, length

    def _part(self, leg: Leg, c: np.ndarray, start: float, end: float) -> Leg:
        """A step between two clocks, with the work that is done in it."""
        scheme, work = self.stepper.scheme, leg.work
        z, length = self._flown(leg, c, start, end)
        if accounted(scheme):
            half = self._flown(leg, c, start, start + length / 2)
            seen = [(self._set_out(leg, c, start, length), length), half, (z, length)]
            powers = [power_of(scheme, self.stepper.state(one), self._constants(c, dt)) for one, dt in seen]
            work += length * (powers[0] + 4 * powers[1] + powers[2]) / 6
        return Leg(z, length, work, reached=end)

    def _set_out(self, leg: Leg, c: np.ndarray, t: float, dt: float) -> np.ndarray:
        """z from which steps dt [s] go on at a clock, with the accounts and inputs of the leg before."""
        scheme = self.stepper.scheme
        if self._remembers:
            q, q_dot = leg.seen or self._seen(leg.z, self._constants(c, leg.dt))
            z = self.stepper.start(t, q, q_dot, c, dt)
            for name in scheme.lasting(Lasting.ACCOUNT, Lasting.GIVEN):
                z[scheme.layout.slice(name)] = leg.z[scheme.layout.slice(name)]
        else:
            z = leg.z.copy()
            if leg.seen is not None:
                z[scheme.layout.slice("v")] = independent_rates(self.model, *leg.seen)
        z[0], z[1] = t, 0.0
        return z

    def _seen(self, z: np.ndarray, constants: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """All coordinates and rates (n,) of a state."""
        model, seen = self.model, self.stepper.scheme.observer(z=self.stepper.state(z), c=constants)
        parts = {name: np.asarray(value).ravel() for name, value in seen.items()}
        q, q_dot = (whole(model, parts[f"q_i{rate}"], parts[f"q_d{rate}"]) for rate in ("", "_dot"))
        return q, q_dot

    def _jumped(self, c: np.ndarray, leg: Leg, before: float, after: float) -> Leg:
        """With the rates just after a jump."""
        if not self._moves:
            return leg
        q, q_dot = self._seen(leg.z, self._constants(c, leg.dt))
        found = impulse_at(self.model, c, q, q_dot, before, after)
        if found is None:
            return leg
        self.impulses[(before + after) / 2] = found
        return replace(leg, work=leg.work + found.energy, seen=(q, found.q_dot))

    def count_anew(self, z: np.ndarray, c: np.ndarray, work: float) -> None:
        """Begin the account of work at a state of the grid; what lies behind a jump is not looked at in advance."""
        scheme, broken = self.stepper.scheme, self.next_broken(int(z[1]))
        near = broken is not None and broken < int(z[1]) + AHEAD
        if not accounted(scheme):
            return
        ready = self._ready(c, self.dt)
        ahead = None if near else (lambda state: self.stepper.run(state, ready, 1))
        begin_account(scheme, z, self._constants(c, self.dt), work, ahead)

    def _constants(self, c: np.ndarray, dt: float) -> np.ndarray:
        return self.stepper.scheme.constants(c, dt)

    def _ready(self, c: np.ndarray, dt: float) -> np.ndarray:
        """What the program reads for a length, kept while there are few of them."""
        if dt not in self._kept:
            if len(self._kept) >= MOST_KEPT:
                self._kept.clear()
            self._kept[dt] = self.stepper.ready(c, dt)
        return self._kept[dt]

    def _with_inputs(self, z: np.ndarray, c: np.ndarray) -> np.ndarray:
        """c with the inputs that z holds."""
        layout = self.stepper.scheme.layout
        if "inputs" not in layout.sizes:
            return c
        held = z[layout.slice("inputs")]
        return np.concatenate([c[: len(c) - len(held)], held])
