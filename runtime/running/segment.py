"""A segment of a run: what is stepped with one choice of q_i. Most runs have one; a run may come back to one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.model import Model
from runtime.running.monitor import Monitor
from runtime.running.plan import Plan
from runtime.running.singular.guard import Guard
from runtime.running.stepped_model import SteppedModel
from runtime.running.time_functions import all_stops
from runtime.schemes.adaptive.impulses import run_across
from runtime.schemes.switching.impulse import Impulse, moves_in_time
from runtime.schemes.switching.times import SwitchTime, switches_by_inputs
from runtime.schemes.switching.watched import watch_events

LOWEST, HIGHEST = 1e300, -1e300  # of no determinant at all; finite, as all of z


@dataclass(eq=False)
class Segment(SteppedModel):
    """A stepped model, and who watches it."""

    monitor: Monitor
    given: dict[float, Impulse] = field(default_factory=dict)
    begun: ConsistentState | None = None  # where the run starts; None: as the model does

    @classmethod
    def build(
        cls, model: Model, plan: Plan, p: np.ndarray, engine: str, begun: ConsistentState | None = None
    ) -> Segment:
        """Prepare and compile, for parameters p (n_p,). begun: where the run starts. Raises what `prepared` does."""
        watch_events(plan.scheme)
        one = SteppedModel.prepared(model, plan, p, engine)
        plan = one.plan
        monitor = Monitor(model, plan.scheme, one.c, force=plan.force, p=one.p)
        found = cls(model, plan, one.stepper, one.p, one.c, one.ready, monitor, begun=begun)
        found.find_switches(plan.t0, plan.t_end)
        return found

    def start(self, q: np.ndarray, q_dot: np.ndarray, step: int = 0, at: float | None = None) -> np.ndarray:
        """The whole z at a consistent state of all coordinates (n,) after so many steps of the run (Eqs. 68-71).

        at [s]: its time where that is not of the grid.
        """
        grid = self.plan.time(step)
        start = at if at is not None else grid if self.broken is None else self.broken.grid.clock(step)
        z = self.begin(start, q, q_dot)
        z[0], z[1] = self.plan.t0 + (start - grid), step  # the grid of times is the run's
        self.forget_determinants(z)
        self.begin_events(z)
        return z

    def stops(self, t0: float, t_end: float) -> list[SwitchTime]:
        """As of every stepped model, and places within short pulses of loads. Raises ModelError."""
        begun = self.begun or ConsistentState(self.model.initial_q, self.model.initial_q_dot, {})
        grid = self.plan.grid
        step = np.inf if self.plan.scheme.adaptive else grid.h[-1]
        return all_stops(self.model, self.c, t0, t_end, begun, step)

    def take_inputs(self, w: np.ndarray) -> None:
        """From now on p and c have these numbers (n_w,) of the inputs; z has its own."""
        self.p[-len(w) :] = self.c[-len(w) :] = w
        if self._switches_by_inputs:
            self.find_switches(self.plan.t0, self.plan.t_end)

    @cached_property
    def _switches_by_inputs(self) -> bool:
        return switches_by_inputs(self.model)

    def step_of(self, z: np.ndarray) -> int:
        """Major steps that were made when z was reached."""
        return int(z[1])

    def time_of(self, z: np.ndarray) -> float:
        """Time of z by its own clock [s]."""
        return float(z[0] + z[1] * self.plan.grid.dt_L)

    def run(self, z: np.ndarray, steps: int) -> None:
        """Advance z in place."""
        self.forget_determinants(z)
        self._go_on(z, steps)

    def run_and_save(self, z: np.ndarray, steps: int, until_mark: Callable[[int], int] | None = None) -> np.ndarray:
        """Advance z in place; (N, n_z) whole states to be saved, or at marks, on the way, the last one left out.

        Ctrl-C among the steps leaves z where it began, so that no saved state is missing before it.
        """
        self.forget_determinants(z)
        counts, begun = self._counts(self.step_of(z), steps, until_mark), z.copy()
        try:
            if self.broken is None and not self.plan.scheme.adaptive:
                rows = np.empty((len(counts), len(z)))
                self.stepper.engine.run_rows(z, self.ready, counts, rows)
                return rows[:-1]
            return self._one_by_one(z, counts)
        except KeyboardInterrupt:
            z[:] = begun
            raise

    def _one_by_one(self, z: np.ndarray, counts: np.ndarray) -> np.ndarray:
        """The same where there may be steps that cannot be made whole."""
        found, end = list[np.ndarray](), self.step_of(z)
        for count in counts:
            self._go_on(z, int(count))
            end += int(count)
            if self.step_of(z) < end:
                break
            found.append(z.copy())
        whole = found if self.step_of(z) < end else found[:-1]
        return np.array(whole) if whole else np.zeros((0, len(z)))

    def _counts(self, step: int, steps: int, until_mark: Callable[[int], int] | None) -> np.ndarray:
        """(N,) steps from one state that is kept to the next, until so many are made."""
        every, end = self.plan.save_every, step + steps
        stops = set(range(step + every - step % every, end, every)) | {end}
        if until_mark is not None:
            at = step + until_mark(step)
            while at < end:
                stops.add(at)
                at += until_mark(at)
        return np.diff(sorted({step, *stops})).astype(np.int64)

    def _go_on(self, z: np.ndarray, steps: int) -> None:
        if self.plan.scheme.adaptive:
            self.run_varying(z, steps, self.ready, self.plan.grid.dt_L, self.given)
        else:
            self.advance(z, steps)

    def run_varying(
        self, z: np.ndarray, steps: int, ready: np.ndarray, dt: float, given: dict[float, Impulse] | None = None
    ) -> None:
        """Advance z in place by states dt [s] apart, by steps of a tolerance with what their program reads.

        given: impulses on the way are entered here, with their times; None: nobody asks.
        """
        noted = given if given is not None else {}
        run_across(
            self.stepper, z, steps, ready, self.with_inputs(z), dt, self.switches, noted if self._prescribes else None
        )

    @cached_property
    def _prescribes(self) -> bool:
        """Are there prescribed motions that may jump?"""
        return moves_in_time(self.model)

    @property
    def impulses(self) -> dict[float, Impulse]:
        """Of prescribed motions whose velocity has jumped so far, by time [s]."""
        return self.given if self.broken is None else self.broken.impulses

    def impulse_memory(self) -> list[list[float]]:
        """`impulses` in plain numbers."""
        found = sorted(self.impulses.items())
        return [[at, one.energy, *one.jumps.tolist()] for at, one in found]

    def resume_impulses(self, memory: Sequence[Sequence[float]]) -> None:
        """From `impulse_memory`."""
        for at, energy, *jumps in memory:
            self.impulses[at] = Impulse(energy, np.array(jumps))

    def land(self, z: np.ndarray) -> None:
        """From z on every state that is seen is the end of a step: what comes from outside changes there."""
        self.plan.scheme.land(z)

    def new_guard(self) -> Guard:
        """For the determinants that the scheme keeps."""
        return Guard.of(self.plan.scheme.layout.sizes["det_low"])

    def forget_determinants(self, z: np.ndarray) -> None:
        """Let det_low and det_high begin anew."""
        layout = self.plan.scheme.layout
        z[layout.slice("det_low")], z[layout.slice("det_high")] = LOWEST, HIGHEST

    def determinants(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(smallest, largest) of each loop block during the last `run`."""
        layout = self.plan.scheme.layout
        return z[layout.slice("det_low")], z[layout.slice("det_high")]
