"""Major steps in which something jumps are made of parts that end there, each with its own side of the jump.

The grid of major steps stays as it is. A step from t_k with a jump inside is a step from t_k to the jump and one from
there to t_{k+1}. Schemes of one step go on from positions and rates as they are; those that remember earlier steps are
started anew (Eqs. 68-71), with the acceleration of the right side. A part that ends at a jump runs on clocks before
it, one that begins there on clocks after it, so that no rounding of t decides which side a load is on.
"""

from __future__ import annotations

import sys
from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cached_property

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.breaks import ON_THE_GRID, Breaks
from runtime.schemes.switching.dips import first_bracket, unsure
from runtime.schemes.switching.event_search import first_passage
from runtime.schemes.switching.impulse import Impulse, impulse_at, may_give_impulses, moves_in_time
from runtime.schemes.switching.legs import Acts, Leg, Legs
from runtime.schemes.switching.steps_with_stops import StepsWithStops
from runtime.schemes.switching.times import SwitchTime
from runtime.schemes.switching.watched import (
    NEVER,
    begin_events,
    event_slopes,
    event_values,
    passed,
    quiet_until,
    watches,
)


class BrokenSteps:
    """Runs major steps dt [s] of a stepper from t0 on, breaking those in which something jumps.

    known: of how many steps all jumps are given. impulses: of prescribed motions whose velocity has jumped so far, by
    time.
    """

    def __init__(
        self, stepper: Stepper, t0: float, dt: float, switches: Sequence[SwitchTime], known: int = sys.maxsize
    ) -> None:
        self.stepper, self.t0, self.dt = stepper, t0, dt
        self.legs, self.grid = Legs(stepper), Breaks(t0, dt, switches, known)
        self.impulses: dict[float, Impulse] = {}
        self._moves, self._switches = moves_in_time(self.model), switches
        self._jolted: list[int] | None = None  # broken steps in which there may be impulses
        # compiled before anything is run
        self._native = StepsWithStops(stepper, self.grid) if self.grid.broken and self._by_program else None

    @property
    def model(self) -> Model:
        """Of the scheme."""
        return self.stepper.scheme.model

    def run(self, z: np.ndarray, ready: np.ndarray, c: np.ndarray, steps: int) -> None:
        """Advance z (whole, flat) in place; c (c_size,) are the model's constants, ready what the program reads."""
        end = int(z[1]) + steps
        while (step := int(z[1])) < end:
            broken = self.grid.next_broken(step)
            if broken is not None and broken < end and self._native is not None:
                jolted = self._next_jolted(step, c)
                if jolted != broken:
                    self._native.run(z, ready, c, end if jolted is None else min(end, jolted))
                    continue
            if broken == step:
                self._break(z, c)
            elif z[0] != self.t0:  # the clock was set after a jump at the start of this step
                self.stepper.run(z, ready, 1)
                z[0] = self.t0
            else:
                self.stepper.run(z, ready, (end if broken is None else min(end, broken)) - step)

    def _next_jolted(self, step: int, c: np.ndarray) -> int | None:
        """The first broken step from this one on in which a prescribed motion may give an impulse."""
        if self._jolted is None:
            may = may_give_impulses(self.model, c, self._switches) if self._moves else []
            self._jolted = Breaks(self.t0, self.dt, may).broken
        k = bisect_left(self._jolted, step)
        return self._jolted[k] if k < len(self._jolted) else None

    @cached_property
    def _by_program(self) -> bool:
        """May broken steps be made by one program? By the scheme and the model alone, and so the bits."""
        return not (self.legs.remembers and self.stepper.scheme.charts.size)  # charts move at a start

    def _break(self, z: np.ndarray, c: np.ndarray, acts: Acts | None = None) -> None:
        """One major step in parts; acts: what events do, where they are looked for."""
        step, flagged, layout = int(z[1]), NEVER, self.stepper.scheme.layout
        if watches(self.stepper.scheme):
            flagged, z[layout.slice("event_step")] = float(z[layout.slice("event_step")][0]), NEVER
        c = self.legs.with_inputs(z, c)
        leg = Leg(z, self.dt)
        for start, length, before, after in self.grid.parts(np.array([step])).each():
            leg = self._reach(leg, c, start, length, acts)
            if leg.ends:
                break
            if before is not None:
                leg = self._jumped(c, leg, before, after)
                leg = leg if acts is None else self._passed_by_jump(leg, c, before, after, acts)
                if leg.ends:
                    break
        start, c = leg.reached if leg.ends else self.grid.clock(step + 1), self.legs.with_inputs(leg.z, c)
        z[:] = self.legs.set_out(leg, c, start, self.dt)
        z[0], z[1] = self.t0 + (start - self.grid.time(step + 1)), step + 1
        if watches(self.stepper.scheme):
            old, asleep = z[layout.slice("event_values")].copy(), quiet_until(self.stepper.scheme, z) > start
            seen = z[layout.slice("event_step")][0] < NEVER
            begin_events(self.stepper.scheme, z, self.legs.constants(c, self.dt))
            seen |= bool(passed(self.stepper.scheme, old, z[layout.slice("event_values")], asleep))
            seen &= acts is None
            z[layout.slice("event_step")] = min(flagged, step + 1) if seen else flagged

    def step_with_events(self, z: np.ndarray, ready: np.ndarray, c: np.ndarray, acts: Acts) -> bool:
        """One major step in which events may happen, in place; where one ends the run, z is the state there.

        Does one? Else it is the step that it would have been.
        """
        scheme, happened = self.stepper.scheme, list[int]()
        own = scheme.layout.slice
        z[own("event_step")] = NEVER
        start = z.copy()

        def noted(leg: Leg, found: list[int]) -> Leg:
            happened.extend(found)
            return acts(leg, found)

        self._break(z, c, noted)
        if happened:
            return True
        self.run(start, ready, c, 1)
        if not passed(scheme, z[own("event_values")], start[own("event_values")]):  # not by a rounding of the end
            z[:] = start
            z[own("event_step")] = NEVER
        return False

    def _reach(self, leg: Leg, c: np.ndarray, start: float, length: float, acts: Acts | None) -> Leg:
        """So far [s] from a clock on, through the events on the way; a part ends where a cool-down is over."""
        scheme, legs, end = self.stepper.scheme, self.legs, start + length
        while True:
            c = legs.with_inputs(leg.z, c)
            if acts is None:
                return legs.part(leg, c, start, length)
            quiet = quiet_until(scheme, leg.z).copy()
            asleep = quiet > start
            wakes = min((float(one) for one in quiet[asleep] if one < end - ON_THE_GRID * self.dt), default=None)
            goal = length if wakes is None else wakes - start
            found = legs.part(leg, c, start, goal)
            at = self._looks(leg, c, start, goal, found)
            bracket = self._bracket(leg, c, start, goal, found, asleep, at)
            if bracket is None:
                if wakes is None:
                    return found
                leg, start, length = found, wakes, end - wakes
                continue

            def ask(old: np.ndarray, new: np.ndarray, asleep: np.ndarray = asleep) -> list[int]:
                return passed(scheme, old, new, asleep)

            low, high = ((s, at(s)) for s in bracket)
            s, before = first_passage(ask, at, low, high, found.dt)
            clock = start + s
            happened, there = ask(before, at(s)), legs.part(leg, c, start, clock - start)
            seen = legs.seen(there.z, legs.constants(c, there.dt))  # rates as they are before inputs change
            leg, start, length = acts(replace(there, seen=seen), happened), clock, end - clock
            if leg.ends or length <= ON_THE_GRID * self.dt:
                return leg

    def _looks(self, leg: Leg, c: np.ndarray, start: float, length: float, found: Leg) -> Callable[[float], np.ndarray]:
        """s [s] -> values of events (n_e,) on the way to `found`, so far away [s]: by a step that ends there."""
        scheme, legs = self.stepper.scheme, self.legs
        start_z = legs.set_out(leg, c, start, length)
        known = {
            0.0: event_values(scheme, start_z, legs.constants(c, length)),
            length: event_values(scheme, found.z, legs.constants(c, found.dt)),
        }

        def at(s: float) -> np.ndarray:
            if s not in known:
                z, dt = legs.flown(leg, c, start, s)
                known[s] = event_values(scheme, z, legs.constants(c, dt))
            return known[s]

        return at

    def _bracket(
        self,
        leg: Leg,
        c: np.ndarray,
        start: float,
        length: float,
        found: Leg,
        asleep: np.ndarray,
        at: Callable[[float], np.ndarray],
    ) -> tuple[float, float] | None:
        """Where on the way to `found`, so far away [s], an event that is not asleep happens first [s]."""
        scheme, legs = self.stepper.scheme, self.legs
        constants = legs.constants(c, length)
        slopes = event_slopes(scheme, legs.set_out(leg, c, start, length), constants)
        end = event_slopes(scheme, found.z, legs.constants(c, found.dt))
        open_ = unsure(ca.DM(at(0.0)), ca.DM(slopes), ca.DM(at(length)), ca.DM(end), length)
        if not (np.asarray(open_).ravel() * ~asleep).any():
            return (0.0, length) if passed(scheme, at(0.0), at(length), asleep) else None
        return first_bracket(
            lambda a, b: bool(passed(scheme, a, b, asleep)),
            lambda s: np.array([at(float(one)) for one in s]),
            0.0,
            length,
            seen=1,
        )

    def _jumped(self, c: np.ndarray, leg: Leg, before: float, after: float) -> Leg:
        """With the rates just after a jump."""
        if not self._moves:
            return leg
        q, q_dot = self.legs.seen(leg.z, self.legs.constants(c, leg.dt))
        found = impulse_at(self.model, c, q, q_dot, before, after)
        if found is None:
            return leg
        self.impulses[(before + after) / 2] = found
        return replace(leg, seen=(q, found.q_dot))

    def _passed_by_jump(self, leg: Leg, c: np.ndarray, end: float, after: float, acts: Acts) -> Leg:
        """Through the events that pass zero just where something jumps, between its clocks."""
        scheme, legs = self.stepper.scheme, self.legs
        c = legs.with_inputs(leg.z, c)
        constants = legs.constants(c, leg.dt)
        there = event_values(scheme, legs.set_out(leg, c, after, leg.dt), constants)
        asleep = quiet_until(scheme, leg.z) > end
        happened = passed(scheme, event_values(scheme, leg.z, constants), there, asleep)
        if not happened:
            return leg
        return acts(replace(leg, seen=leg.seen or legs.seen(leg.z, constants), reached=(end + after) / 2), happened)
