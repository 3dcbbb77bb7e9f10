"""What a run does when a determinant of the closure becomes small: find the step, then exchange a coordinate of q_i
where another choice is better, step over the position where none is, or go on where neither is needed.

All of it depends on states only, never on how many steps a native call made, so that runs stay reproducible.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.coordinates import mechanism_length
from runtime.contract.status import Event, Status, StatusName
from runtime.running.singular.crossing import BranchLost, TightIntegrator, approach, cross
from runtime.running.singular.exchange import CLEARLY, Exchange, NoVariant, best_exchange, carried, variant_of
from runtime.running.singular.over import CrossingPath, Over
from runtime.running.singular.singularity_monitor import (
    LAST_THRESHOLD,
    LEAST_THRESHOLD,
    LoopDeterminants,
    SingularityMonitor,
)
from runtime.running.stepped_model import SteppedModel
from runtime.schemes.options import SchemeError
from runtime.solutions.solution import Solution

if TYPE_CHECKING:
    from runtime.running.run import Run

FOLLOWED_DETERMINANT = 0.02  # of the largest determinant: how far a motion is followed to see where it leads


@dataclass(frozen=True)
class Continuation:
    """How a run goes on: at z on a segment (another one after an exchange), with samples of the steps in between.

    drop_from: the first step whose earlier samples do not hold; None: all hold. earlier: a state of the segment before
    z, if one is known. monitored: are determinants looked at in the next step? Else it is the last that is tried.
    """

    segment: SteppedModel
    z: np.ndarray
    samples: list[np.ndarray]
    drop_from: int | None = None
    event: Event | None = None
    status: Status | None = None
    earlier: np.ndarray | None = None
    monitored: bool = True


def locate(
    segment: SteppedModel, monitor: SingularityMonitor, earlier: np.ndarray | None, before: np.ndarray, steps: int
) -> tuple[np.ndarray, np.ndarray | None, bool]:
    """(z before the first near-singular step, z one step earlier if there is one, is there one at all?).

    The monitor accepts the steps that lead there. Without one z is where the search ended: go on from there.
    """
    low_z, previous = before.copy(), None
    low, high = 0, steps
    while high - low > 1:
        middle = (low + high) // 2
        z = low_z.copy()
        segment.run(z, middle - low)
        if monitor.near_singular(*segment.determinants(z)):
            high = middle
        else:
            monitor.accept(*segment.determinants(z))
            low_z, low = z, middle
    z = low_z.copy()
    segment.run(z, 1)
    if not monitor.near_singular(*segment.determinants(z)):
        monitor.accept(*segment.determinants(z))
        return z, None, False
    for start in (before, earlier):
        distance = -1 if start is None else int(low_z[1]) - 1 - int(start[1])
        if start is not None and distance >= 0:
            previous = start.copy()
            if distance:
                segment.run(previous, distance)
            break
    return low_z, previous, True


def continuation(run: Run, before: np.ndarray, n: int) -> Continuation:
    """Decide how a run goes on from `before`, within n steps of which a determinant of a loop block is small."""
    z, previous, near_singular = locate(run.segment, run.singularity, run.earlier, before, n)
    if not near_singular:
        return Continuation(run.segment, z, [], earlier=before)
    if run.singularity.threshold < LEAST_THRESHOLD:
        return Continuation(run.segment, z, [], monitored=False)
    last = z if previous is None else previous
    found = SingularCrossing(run).go_on(last)
    if run.left.get(id(found.segment)) == int(found.z[1]):  # exchanges would go in a circle
        return Continuation(run.segment, last, [], monitored=False)
    if found.drop_from is None and found.status is None:  # look again later
        return replace(found, segment=run.segment, z=z, earlier=previous)
    return found


class SingularCrossing:
    """Looks at a place where a run came near a singular position, and decides."""

    def __init__(self, run: Run) -> None:
        self.segment, self.singularity = run.segment, run.singularity
        self.segments, self.engine = run.record.segments, run.problem.engine
        self.asked, self.event_handler = lambda: run.interrupts.asked, run.event_handler
        self.loops = LoopDeterminants(run.segment.model, run.segment.c)
        self.length = mechanism_length(run.segment.model, self.loops.jacobian(0.0, self.segments[0].model.initial_q))

    def go_on(self, z: np.ndarray) -> Continuation:
        """From z, the last state whose determinants were good, if it passes the other checks."""
        status = self.segment.monitor.after(self.segment.state(z), last=True)
        if status is not None:
            return Continuation(self.segment, z, [], None, None, status)
        observed = self.segment.observed([self.segment.state(z)])
        t, q, v = float(observed.t[0]), observed.q[0], observed.q_dot[0]
        values, _ = self.loops.determinants(t, q, v)
        if not (np.isfinite(q).all() and np.isfinite(v).all() and np.isfinite(values).all()):
            return self._look_later(z)
        block = self.singularity.worst(values)
        exchange = best_exchange(self.segment.model, q, self.loops.jacobian(t, q), self.length)
        if exchange is not None and exchange.gain >= CLEARLY:
            return self._exchanged(z, observed, exchange)
        return self._ahead(z, observed, block, abs(float(values[block])))

    def _ahead(self, z: np.ndarray, observed: Solution, block: int, height: float) -> Continuation:
        """Follow the motion with tight tolerances to see whether it leads to a singular position."""
        integrator = TightIntegrator(self.segment.model, self.segment.p, self.segment.c, self.asked)
        t, y = float(observed.t[0]), integrator.pack(observed.q[0], observed.q_dot[0])
        largest = float(self.singularity.largest[block]) or height
        try:
            near = approach(integrator, t, y, block, min(FOLLOWED_DETERMINANT * largest, 0.3 * height))
        except BranchLost:  # whatever stops the motion, it is not the closure: other checks name it
            self.singularity.give_up()
            return Continuation(self.segment, z, [])
        if near is None:
            return self._look_later(z)
        there = integrator.observed(np.array([near[0]]), near[1][None, :])
        exchange = best_exchange(self.segment.model, there.q[0], self.loops.jacobian(near[0], there.q[0]), self.length)
        if exchange is not None and exchange.gain >= CLEARLY:
            return self._exchanged(z, observed, exchange)
        try:
            crossing = cross(integrator, t, y, block, largest)
            over = Over(self.segment, self.segments, self.event_handler, block, largest, self.asked)
            samples, status = over.go(z, CrossingPath(integrator, t, y, crossing, integrator))
        except BranchLost as error:
            return self._lost(
                "branch_lost",
                z,
                f"a singular position lies ahead, and the branch of the motion cannot be told behind it: {error}",
                "Start elsewhere, change a length a little, or stop the run before it.",
            )
        self.singularity.passed()
        first, event = int(z[1]) + 1, over.event()
        return Continuation(self.segment, samples[-1].copy(), samples, first, event, status)

    # ---- another q_i ----------------------------------------------------------------------------------------

    def _exchanged(self, z: np.ndarray, observed: Solution, exchange: Exchange) -> Continuation:
        names = exchange.apply(list(self.segment.model.q_i))
        try:
            segment = self._segment_with(names, observed.q[0])
        except (NoVariant, SchemeError) as error:
            if self.singularity.threshold > LAST_THRESHOLD:
                return self._look_later(z, Event(float(observed.t[0]), "no_variant", str(error)))
            return self._lost(
                "partition_lost",
                z,
                f"{exchange.out} no longer determines the mechanism, {exchange.into} would",
                str(error),
            )
        new = carried(self.segment, z, segment, observed)
        segment.monitor.resume(segment.state(new), self.segment.monitor.memory())
        event = Event(
            float(observed.t[0]),
            "repartition",
            f"{exchange.into} took the place of {exchange.out} in q_i, "
            f"which makes the closure {exchange.gain:.3g} times better determined",
        )
        return Continuation(segment, new, [], int(new[1]) + 1, event)

    def _segment_with(self, names: list[str], q: np.ndarray) -> SteppedModel:
        """One that the run has had, or a new one. Raises NoVariant or SchemeError."""
        known = next((segment for segment in self.segments if list(segment.model.q_i) == names), None)
        if known is not None:
            return known
        model = variant_of(self.segments[0].model, names, q)
        own = self.segment
        return SteppedModel.of_run(model, own.plan.on(model), own.p, self.engine, own.start_state)

    # ---- neither --------------------------------------------------------------------------------------------

    def _look_later(self, z: np.ndarray, event: Event | None = None) -> Continuation:
        """Nothing to be done yet: go on, and look again when the determinant is smaller."""
        self.singularity.lower()
        return Continuation(self.segment, z, [], None, event)

    def _lost(self, name: StatusName, z: np.ndarray, cause: str, advice: str) -> Continuation:
        time = self.segment.plan.time(int(z[1]))
        return Continuation(self.segment, z, [], None, None, Status(name, time, None, cause, advice))
