"""A scheme on a model with parameters, compiled: steps, steps with stops, restarts, samples on the way.

A run steps one for each choice of q_i (most runs have one, and may come back to one); steppers in Python, derivatives
and comparisons are built on it, too.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple, Self

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.model import EmittedModel
from runtime.contract.status import Status
from runtime.running.monitor import Monitor
from runtime.running.powers import MAX_CHANGES, Change, tell_powers
from runtime.running.problem import Plan
from runtime.running.time_functions import all_stops
from runtime.schemes.stepper import Stepper, kept_stepper
from runtime.schemes.switching.impulse import Impulse
from runtime.schemes.switching.times import CONDITION_ROUNDING, SwitchTime, switches_by_inputs, switching_times
from runtime.schemes.switching.watched import NEVER, begin_events, watches
from runtime.solutions.observe import observe_samples
from runtime.solutions.solution import Solution

MOST_HALVINGS = 10  # of a step whose iteration does not converge
MOST_IN_A_ROW = 100  # steps that are halved for that: then dt is too long for the motion, not for a place in it
NO_LOWEST, NO_HIGHEST = 1e300, -1e300  # of no determinant at all; finite, as all of z


class Divisions(NamedTuple):
    """Of steps whose iteration does not converge: the last one, how often it was halved, how many were made so, and how
    many of these in a row.
    """

    step: int = -1
    halvings: int = 0
    steps: int = 0
    in_a_row: int = 0


@dataclass(eq=False)
class SteppedModel:
    """model, plan and compiled stepper; p (n_p,), c (c_size,) and `ready`, what the compiled program reads.

    The arrays stay where they are and change in place: compiled code that was bound to them sees it. States z (flat)
    belong to whoever steps. start_state: where a run starts; None: as the model does. switches: times at which loads or
    motions jump or kink, where they were looked for; broken: who steps across them. given: impulses of steps of a
    tolerance so far, by time. changes: of inputs and rates so far, see powers.py. divisions: steps that were made in
    parts.
    """

    model: EmittedModel
    plan: Plan
    stepper: Stepper
    p: np.ndarray
    c: np.ndarray
    ready: np.ndarray
    start_state: ConsistentState | None = None
    given: dict[float, Impulse] = field(default_factory=dict)
    switches: list[SwitchTime] = field(default_factory=list, init=False)
    broken: Any = field(default=None, init=False)
    changes: list[Change] = field(default_factory=list, init=False)
    divisions: Divisions = field(default=Divisions(), init=False)

    @classmethod
    def prepared(cls, model: EmittedModel, plan: Plan, p: np.ndarray, engine: str, wait: bool = False) -> Self:
        """Prepare and compile, for parameters p (n_p,); wait: for the best code. Raises ModelError or CompilerError."""
        c = model.constants(p)
        stepper = kept_stepper(plan.scheme, engine, wait)
        return cls(model, plan, stepper, p.copy(), c, stepper.ready(c, plan.grid.dt_L).copy())

    @classmethod
    def of_run(
        cls, model: EmittedModel, plan: Plan, p: np.ndarray, engine: str, start_state: ConsistentState | None = None
    ) -> SteppedModel:
        """With stops found over the time of the plan. Raises what `prepared` does."""
        found = cls.prepared(model, plan, p, engine)
        found.start_state = start_state or ConsistentState(model.initial_q, model.initial_q_dot, {})
        found.find_switches(plan.t0, plan.t_end)
        return found

    @cached_property
    def monitor(self) -> Monitor:
        """Who looks at its states."""
        plan = self.plan
        refined = plan.name if plan.refined else ""
        return Monitor(self.model, plan.scheme, self.c, force=plan.force, p=self.p, refined=refined)

    def take(self, p: np.ndarray) -> None:
        """From now on these parameters (n_p,)."""
        self.p[:], self.c[:] = p, self.model.constants(p)
        self.ready[:] = self.stepper.ready(self.c, self.plan.grid.dt_L)

    def advance(self, z: np.ndarray, steps: int) -> None:
        """Make so many major steps in place, in one native call where nothing jumps."""
        if self.plan.scheme.adaptive:
            self._advance_adaptively(z, steps)
        elif self.broken is None:
            self.stepper.run(z, self.ready, steps)
        else:
            self.broken.run(z, self.ready, self.c, steps)

    def _advance_adaptively(self, z: np.ndarray, steps: int) -> None:
        """So many states that are seen; the last one of a run may be nearer to the one before it."""
        from runtime.schemes.adaptive_jumps import advance_across_jumps

        plan = self.plan
        around = self.with_inputs(z), plan.grid.dt_L, self.switches, self.given
        whole = min(steps, plan.whole_steps - int(z[1]))
        if whole > 0:
            advance_across_jumps(self.stepper, z, whole, self.ready, *around)
        at_last = whole < steps and int(z[1]) == plan.whole_steps
        if plan.end is not None and at_last and self.first_event(z) is None:
            z[0] = plan.end - plan.steps * plan.grid.dt_L
            advance_across_jumps(self.stepper, z, 1, self.ready, *around)

    def hold(self, z: np.ndarray, w: np.ndarray) -> None:
        """From now on z (n_z,) has these numbers (n_w,) of the inputs; where they change, forces jump."""
        now = z[self._inputs]
        if not self.plan.scheme.multistep or (now == w).all():
            now[:] = w
            return
        self.restart(z, w, np.zeros(len(self.model.q_i)))

    def restart(self, z: np.ndarray, w: np.ndarray, push: np.ndarray) -> None:
        """From now on z (n_z,) has these inputs (n_w,) and rates with push (n_i,) added; what it remembers is anew."""
        layout = self.plan.scheme.layout
        if not self.plan.scheme.multistep:
            z[self._inputs] = w
            self.plan.scheme.add_to_rates(z, push)
            return
        clock, dt, size = z[:2].copy(), self.plan.grid.dt_L, layout.size
        t = float(clock[0] + clock[1] * dt)
        from runtime.schemes.switching.steps_with_stops import restart_of

        restart = restart_of(self.stepper)
        z[:size] = restart(z[:size], self.plan.scheme.constants(self.c), dt, dt, t, push, w)
        z[:2] = clock

    @cached_property
    def _inputs(self) -> slice:
        return self.plan.scheme.layout.slice("inputs")

    def with_inputs(self, z: np.ndarray) -> np.ndarray:
        """(c_size,) the constants with the inputs that z holds."""
        layout = self.plan.scheme.layout
        if "inputs" not in layout.sizes:
            return self.c
        held = z[layout.slice("inputs")]
        return np.concatenate([self.c[: len(self.c) - len(held)], held])

    def find_switches(self, t0: float, t_end: float) -> None:
        """Look where something jumps on the grid of steps from t0 on, for the inputs as they are. Raises ModelError."""
        scheme = self.plan.scheme
        if self.start_state is None:
            self.switches = switching_times(self.model, self.c, t0, t_end)
        else:  # of a run: places within short pulses of loads, too
            step = np.inf if scheme.adaptive else self.plan.grid.h[-1]
            self.switches = all_stops(self.model, self.c, t0, t_end, self.start_state, step)
        self.broken = None
        broken = self.switches or self.watches_events or self.plan.end is not None
        if broken and not scheme.adaptive:  # who chooses ends of steps puts them there
            self._break(self.switches, t0, t_end, self.c)

    def _break(self, stops: Sequence[SwitchTime], t0: float, t_end: float, c: np.ndarray) -> None:
        """Steps from t0 to t_end [s] end at these times, too; c (c_size,): with the inputs there."""
        from runtime.schemes.switching.steps_with_stops import StepsWithStops

        end, length = self.plan.end, self.plan.grid.dt_L
        known = round((t_end - t0) / length) if end is None else self.plan.steps
        self.broken = StepsWithStops(self.stepper, t0, length, stops, c, known, end)

    def divide_step(self, z: np.ndarray) -> bool:
        """Make the step from z (flat) in parts half as long as before: its iteration has not converged.

        False where its parts are as short as they may be, or too many steps in a row had to be made so.
        """
        plan, step = self.plan, int(z[1])
        last, again = self.divisions, self.divisions.step == step
        halvings = last.halvings + 1 if again else 1
        in_a_row = last.in_a_row if again else last.in_a_row + 1 if last.step == step - 1 else 1
        if plan.scheme.iteration_limit is None or halvings > MOST_HALVINGS or in_a_row > MOST_IN_A_ROW:
            self.divisions = last._replace(in_a_row=in_a_row)
            return False
        self.divisions = Divisions(step, halvings, last.steps + (not again), in_a_row)
        given, unresolved = self.impulses, self.unresolved
        t0 = plan.t0 if self.broken is None else self.broken.t0  # a stepper's is not that of its plan
        begin, end = (plan.time(one) + (t0 - plan.t0) for one in (step, step + 1))
        times = np.linspace(begin, end, 2**halvings + 1)[1:-1]
        margin = CONDITION_ROUNDING * max(abs(begin), abs(end))
        parts = [SwitchTime(float(t), float(t) - margin, float(t) + margin, ()) for t in times]
        stops = sorted([*self.switches, *parts], key=lambda one: one.time)
        self._break(stops, t0, t0 + (plan.t_end - plan.t0), self.with_inputs(z))
        self.broken.impulses.update(given)
        self.broken.unresolved = unresolved
        return True

    def begin_events(self, z: np.ndarray) -> None:
        """Look for events from a state z (n_z,) on as if none had happened yet."""
        layout = self.plan.scheme.layout
        if "event_quiet" in layout.sizes:
            z[layout.slice("event_quiet")] = -NEVER
        self.look_anew(z)

    def look_anew(self, z: np.ndarray) -> None:
        """From a state z (n_z,) on whose inputs have changed: an event that they move does not happen."""
        begin_events(self.plan.scheme, z, self.plan.scheme.constants(self.c))

    @property
    def watches_events(self) -> bool:
        """Has z their fields?"""
        return watches(self.plan.scheme)

    def first_event(self, z: np.ndarray) -> int | None:
        """The step in which an event was flagged first since z (n_z,) was last looked at, if one was."""
        if not self.watches_events:
            return None
        found = float(z[self.plan.scheme.layout.slice("event_step")][0])
        return int(found) if found < NEVER else None

    def bound(self, z: np.ndarray) -> Callable[[int], None]:
        """`advance` of a z that stays where it is: a call costs nothing but its steps."""
        return self.stepper.engine.bound(z, self.ready)

    def state(self, z: np.ndarray) -> np.ndarray:
        """The scheme's part of z, as a view."""
        return z[: self.plan.scheme.layout.size]

    def observed(self, samples: Sequence[np.ndarray] | np.ndarray, status: Status | None = None) -> Solution:
        """Samples of the scheme's part of z as a Solution."""
        plan, status = self.plan, status or Status("completed", self.plan.t_end)
        return observe_samples(self.model, plan.scheme, np.array(samples), self.p, self.c, plan.name, {}, status)

    # ---- of a run --------------------------------------------------------------------------------------------

    def start(self, q: np.ndarray, q_dot: np.ndarray, step: int = 0, at: float | None = None) -> np.ndarray:
        """The whole z at a consistent state of all coordinates (n,) after so many steps of the run (Eqs. 68-71).

        at [s]: its time where that is not of the grid.
        """
        grid = self.plan.on_grid(step)
        start = at if at is not None else grid if self.broken is None else self.broken.grid.clock(step)
        z = self.stepper.start(start, q, q_dot, self.c, self.plan.grid.dt_L)
        z[0], z[1] = self.plan.t0 + (start - grid), step  # the grid of times is the run's
        self.forget_determinants(z)
        self.begin_events(z)
        return z

    def note_change(self, t: float, z: np.ndarray, c: np.ndarray, w: np.ndarray, push: np.ndarray) -> None:
        """Keep what `powers` tells of a change at t [s], see there."""
        if len(self.changes) < MAX_CHANGES and self._tells_powers:
            self.changes.append(Change(t, z[: self.plan.scheme.layout.size].copy(), c.copy(), w.copy(), push.copy()))

    @cached_property
    def _tells_powers(self) -> bool:
        return tell_powers(self.plan.scheme)

    def take_inputs(self, w: np.ndarray) -> None:
        """From now on p and c have these numbers (n_w,) of the inputs; z has its own."""
        self.p[-len(w) :] = self.c[-len(w) :] = w
        if self._switches_by_inputs:
            self.find_switches(self.plan.t0, self.plan.t_end)

    @cached_property
    def _switches_by_inputs(self) -> bool:
        return switches_by_inputs(self.model)

    def run(self, z: np.ndarray, steps: int) -> None:
        """Advance z in place."""
        self.forget_determinants(z)
        self.advance(z, steps)

    def run_and_save(self, z: np.ndarray, ends: Sequence[int]) -> np.ndarray:
        """Advance z in place to the last of these steps; (N, n_z) whole states at them, the last of which is z.

        Fewer where steps cannot be made whole. Ctrl-C leaves z where it began, so that no saved state is missing.
        """
        counts, start_state = np.diff([int(z[1]), *ends]).astype(np.int64), z.copy()
        rows = np.empty((len(counts), len(z)))
        try:
            whole = self.broken is None or self.broken.is_whole(z, int(ends[-1]))
            if whole and not self.plan.scheme.adaptive:
                self.stepper.engine.run_rows(z, self.ready, counts, rows)
                return rows
            for k, end in enumerate(ends):
                self.advance(z, int(counts[k]))
                rows[k] = z
                if int(z[1]) < end:
                    return rows[: k + 1]
            return rows
        except KeyboardInterrupt:
            z[:] = start_state
            raise

    @property
    def impulses(self) -> dict[float, Impulse]:
        """Of prescribed motions whose velocity has jumped so far, by time [s]."""
        return self.given if self.broken is None else self.broken.impulses

    @property
    def unresolved(self) -> float:
        """Error of a rate behind loads that act for less than two steps, the largest so far [m/s, rad/s]."""
        return 0.0 if self.broken is None else self.broken.unresolved

    def forget_determinants(self, z: np.ndarray) -> None:
        """Let det_low and det_high begin anew."""
        layout = self.plan.scheme.layout
        z[layout.slice("det_low")], z[layout.slice("det_high")] = NO_LOWEST, NO_HIGHEST

    def determinants(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(smallest, largest) of each loop block during the last `run`."""
        layout = self.plan.scheme.layout
        return z[layout.slice("det_low")], z[layout.slice("det_high")]
