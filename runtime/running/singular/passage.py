"""What a run does when a determinant of the closure becomes small: find the step, then exchange a coordinate of q_i
where another choice is better, step over the position where none is, or go on where neither is needed.

All of it depends on states only, never on how many steps a native call made, so that runs stay reproducible.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil

import numpy as np

from runtime.contract.status import Event, Status, StatusName
from runtime.contract.units import mechanism_length
from runtime.results.sampling import evaluate
from runtime.results.solution import Solution
from runtime.running.segment import Segment
from runtime.running.singular.carry import COUNTERS, carried
from runtime.running.singular.crossing import Crossing, approach, between, cross
from runtime.running.singular.exchange import CLEARLY, Exchange, best_exchange
from runtime.running.singular.guard import LAST, NEAR, Guard
from runtime.running.singular.loop_determinants import LoopDeterminants
from runtime.running.singular.tight_integrator import BranchLost, TightIntegrator
from runtime.running.singular.variants import NoVariant, variant_of
from runtime.schemes.options import SchemeError

FOLLOWED = 0.02  # of the largest determinant: how far a motion is followed to see where it leads
LONGEST_LEAVE = 10_000  # steps that the neighbourhood of a singular position may take after it


@dataclass
class Continuation:
    """How a run goes on: at z on a segment (another one after an exchange), with samples of the steps in between.

    drop_from: the first step whose earlier samples do not hold; None: all hold.
    """

    segment: Segment
    z: np.ndarray
    samples: list[np.ndarray]
    drop_from: int | None = None
    event: Event | None = None
    status: Status | None = None


def locate(
    segment: Segment, guard: Guard, earlier: np.ndarray | None, before: np.ndarray, steps: int
) -> tuple[np.ndarray, np.ndarray | None, bool]:
    """(z before the first step that raises the alarm, z one step earlier if there is one, was there an alarm at all?).

    The guard accepts the steps that lead there. Without an alarm z is where the search ended: go on from there.
    """
    low_z, previous = before.copy(), None
    low, high = 0, steps
    while high - low > 1:
        middle = (low + high) // 2
        z = low_z.copy()
        segment.run(z, middle - low)
        if guard.alarm(*segment.determinants(z)):
            high = middle
        else:
            guard.accept(*segment.determinants(z))
            low_z, low = z, middle
    z = low_z.copy()
    segment.run(z, 1)
    if not guard.alarm(*segment.determinants(z)):
        guard.accept(*segment.determinants(z))
        return z, None, False
    for start in (before, earlier):
        distance = -1 if start is None else segment.step_of(low_z) - 1 - segment.step_of(start)
        if start is not None and distance >= 0:
            previous = start.copy()
            if distance:
                segment.run(previous, distance)
            break
    return low_z, previous, True


class Passage:
    """Looks at a place where the alarm was raised, and decides. asked: was Ctrl-C pressed?"""

    def __init__(
        self, segment: Segment, guard: Guard, segments: list[Segment], engine: str, asked: Callable[[], bool]
    ) -> None:
        self.segment, self.guard, self.segments, self.engine = segment, guard, segments, engine
        self.asked = asked
        self.loops = LoopDeterminants(segment.model, segment.c)
        self.length = mechanism_length(segment.model, self.loops.jacobian(0.0, segments[0].model.initial_q))

    def go_on(self, z: np.ndarray) -> Continuation:
        """From z, the last state whose determinants were good, if it passes the other checks."""
        status = self.segment.monitor.after(self.segment.stepper.state(z), last=True)
        if status is not None:
            return Continuation(self.segment, z, [], None, None, status)
        seen = self.segment.observed([self.segment.stepper.state(z)])
        t, q, v = float(seen.t[0]), seen.q[0], seen.q_dot[0]
        values, _ = self.loops.determinants(t, q, v)
        if not (np.isfinite(q).all() and np.isfinite(v).all() and np.isfinite(values).all()):
            return self._look_later(z)
        block = self.guard.worst(values)
        exchange = best_exchange(self.segment.model, q, self.loops.jacobian(t, q), self.length)
        if exchange is not None and exchange.gain >= CLEARLY:
            return self._exchanged(z, seen, exchange)
        return self._ahead(z, seen, block, abs(float(values[block])))

    def _ahead(self, z: np.ndarray, seen: Solution, block: int, height: float) -> Continuation:
        """Follow the motion with tight tolerances to see whether it leads to a singular position."""
        integrator = TightIntegrator(self.segment.model, self.segment.p, self.segment.c, self.asked)
        t, y = float(seen.t[0]), integrator.pack(seen.q[0], seen.q_dot[0])
        largest = float(self.guard.largest[block]) or height
        try:
            near = approach(integrator, t, y, block, min(FOLLOWED * largest, 0.3 * height))
        except BranchLost:  # whatever stops the motion, it is not the closure: other checks name it
            self.guard.give_up()
            return Continuation(self.segment, z, [])
        if near is None:
            return self._look_later(z)
        there = integrator.seen(np.array([near[0]]), near[1][None, :])
        exchange = best_exchange(self.segment.model, there.q[0], self.loops.jacobian(near[0], there.q[0]), self.length)
        if exchange is not None and exchange.gain >= CLEARLY:
            return self._exchanged(z, seen, exchange)
        try:
            crossing = cross(integrator, t, y, block, largest)
            return self._behind(z, integrator, (t, y), crossing, block, largest)
        except BranchLost as error:
            return self._lost(
                "branch_lost",
                z,
                f"a singular position lies ahead, and the branch of the motion cannot be told behind it: {error}",
                "Start elsewhere, change a length a little, or stop the run before it.",
            )

    # ---- another q_i ----------------------------------------------------------------------------------------

    def _exchanged(self, z: np.ndarray, seen: Solution, exchange: Exchange) -> Continuation:
        names = exchange.apply(list(self.segment.model.q_i))
        try:
            segment = self._segment_with(names, seen.q[0])
        except (NoVariant, SchemeError) as error:
            if self.guard.threshold > LAST:
                return self._look_later(z, Event(float(seen.t[0]), "no_variant", str(error)))
            return self._lost(
                "partition_lost",
                z,
                f"{exchange.out} no longer determines the mechanism, {exchange.into} would",
                str(error),
            )
        new = carried(self.segment, z, segment, seen)
        segment.monitor.resume(segment.stepper.state(new), self.segment.monitor.memory())
        event = Event(
            float(seen.t[0]),
            "repartition",
            f"{exchange.into} took the place of {exchange.out} in q_i, "
            f"which makes the closure {exchange.gain:.3g} times better determined",
        )
        return Continuation(segment, new, [], segment.step_of(new) + 1, event)

    def _segment_with(self, names: list[str], q: np.ndarray) -> Segment:
        """One that the run has had, or a new one. Raises NoVariant or SchemeError."""
        known = next((segment for segment in self.segments if list(segment.model.q_i) == names), None)
        if known is not None:
            return known
        model = variant_of(self.segments[0].model, names, q)
        return Segment.build(model, self.segment.plan.on(model), self.segment.p, self.engine)

    # ---- over the position ----------------------------------------------------------------------------------

    def _behind(
        self,
        z: np.ndarray,
        integrator: TightIntegrator,
        before: tuple[float, np.ndarray],
        crossing: Crossing,
        block: int,
        largest: float,
    ) -> Continuation:
        """Samples up to the first step whose determinant is good again, where the scheme starts anew."""
        plan, first = self.segment.plan, self.segment.step_of(z)
        last = self._last_step(integrator, crossing, block, 1.2 * NEAR * largest, first)
        steps = [k for k in range(first + 1, last + 1) if k == last or k % plan.save_every == 0]
        times, over = np.array([plan.time(step) for step in steps]), crossing.ends(integrator)
        ahead, behind = times <= over.t[0], times >= over.t[1]
        q, q_dot = np.zeros((len(times), over.q.shape[1])), np.zeros((len(times), over.q.shape[1]))
        for part, start in ((ahead, before), (behind, (crossing.t, crossing.y))):
            if part.any():
                found = integrator.states(times[part], integrator.path(*start, times[part]))
                q[part], q_dot[part] = found["q"], found["q_dot"]
        for k in np.flatnonzero(~ahead & ~behind):
            q[k], q_dot[k] = between(over, float(times[k]))
        works = self._works(z, q, q_dot, times)
        samples = [self._state(z, *state) for state in zip(q, q_dot, steps, works, strict=True)]
        event = Event(
            crossing.t_s,
            "singular_position",
            f"passed a singular position at t = {crossing.t_s:.9g}; branch kept by continuity, energy to "
            f"{abs(crossing.energy_change):.2g} J",
        )
        self.guard.passed()
        return Continuation(self.segment, samples[-1].copy(), samples, first + 1, event)

    def _last_step(self, integrator: TightIntegrator, crossing: Crossing, block: int, height: float, first: int) -> int:
        """The first step behind the position whose determinant is good again; the last one allowed if there is none."""
        plan = self.segment.plan
        allowed = min(plan.steps, first + LONGEST_LEAVE)
        if plan.time(allowed) <= crossing.t:
            return allowed
        t, y = crossing.t, crossing.y
        if abs(float(integrator.determinants(t, y)[0][block])) <= height:
            found = integrator.rise(t, y, plan.time(allowed), block, height)
            if found is None:
                return allowed
            t = found[0]
        return min(allowed, max(first + 1, ceil((t - plan.t0) / plan.grid.dt_L)))

    def _works(self, z: np.ndarray, q: np.ndarray, q_dot: np.ndarray, times: np.ndarray) -> np.ndarray:
        """(N,) work done until samples (N, n) behind z [J]: on so short a way it is what the energy changed by."""
        seen = self.segment.observed([self.segment.stepper.state(z)])
        motion = {"q": np.vstack([seen.q, q]), "q_dot": np.vstack([seen.q_dot, q_dot])}
        at = {**motion, "t": np.concatenate([seen.t, times])[:, None]}
        energy = evaluate(self.segment.model.kernel("energy"), at, self.segment.c)
        total = np.asarray((energy["kinetic"] + energy["elastic"] + energy["potential"])[:, 0])
        return np.asarray(self.segment.account(z)[0] + total[1:] - total[0])

    def _state(self, z: np.ndarray, q: np.ndarray, q_dot: np.ndarray, step: int, work: float) -> np.ndarray:
        result = self.segment.start(q, q_dot, step, work)
        layout = self.segment.plan.scheme.layout
        for name in COUNTERS:
            result[layout.slice(name)] = z[layout.slice(name)]
        return result

    # ---- neither --------------------------------------------------------------------------------------------

    def _look_later(self, z: np.ndarray, event: Event | None = None) -> Continuation:
        """Nothing to be done yet: go on, and look again when the determinant is smaller."""
        self.guard.lower()
        return Continuation(self.segment, z, [], None, event)

    def _lost(self, name: StatusName, z: np.ndarray, cause: str, advice: str) -> Continuation:
        time = self.segment.plan.time(self.segment.step_of(z))
        return Continuation(self.segment, z, [], None, None, Status(name, time, None, cause, advice))
