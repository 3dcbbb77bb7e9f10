"""An estimate of the error of a run, from short windows that are stepped again with half the step.

A window of K major steps starts at a state of the run. From there the run's own steps lead to A, and 2 K half steps
from the same positions and velocities to B. With order p the error of the window is about (A - B) 2^p / (2^p - 1).
Where steps follow from a tolerance, B is made with an eighth of it, and with an estimate of order p the error is about
(A - B) 8/7.
Errors of all steps are taken to add up as those of the windows do, which is right for phases of undamped oscillations,
too much where a damper forgets errors, and too little where a motion is unstable in itself: there the motion carries
them on (carried_error.py), and the larger of the two is said. Where a coordinate turns on and on,
an error dE of the energy keeps the mechanism late for the rest of the run, by dE / 2 T of it with the kinetic energy T;
then every coordinate is off by its rate times that delay.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass

import numpy as np

from runtime.contract.coordinates import followed
from runtime.contract.model import Model
from runtime.results.amplitudes import floored
from runtime.running.carried_error import SHARE, SHORTEST, CarriedError
from runtime.running.neighbour import seen_state, small_change
from runtime.running.segment import Segment
from runtime.running.singular.guard import Guard
from runtime.running.window import Window, window_at

WINDOWS = 10  # at most
ROUND = 2 * np.pi  # rad: what has turned further turns on and on
ONE_SIGN = 0.75  # sum of the delays over that of their magnitudes: less is no delay, but energies that go to and fro
WORTH_A_WORD = 0.03  # error relative to an amplitude that a run says, if all of it is as its worst window
GROWN = 1.5  # times what errors would be if none grew: from there the motion itself is to blame

States = tuple[np.ndarray, np.ndarray]  # coordinates and rates, (n,) each


@dataclass
class CoordinateError:
    """Of one coordinate of q_i: error so far, largest rate, the range seen; the worst window's part and time [s]."""

    error: float = 0.0
    fastest: float = 0.0
    worst: float = 0.0
    worst_time: float = 0.0
    low: float = np.inf
    high: float = -np.inf

    def widen(self, values: np.ndarray, rates: np.ndarray) -> None:
        """See positions and rates (N,)."""
        self.low, self.high = min(self.low, float(values.min())), max(self.high, float(values.max()))
        self.fastest = max(self.fastest, float(np.abs(rates).max()))

    @property
    def amplitude(self) -> float:
        """Half the range of the coordinate."""
        return (self.high - self.low) / 2


class Accuracy:
    """Estimates the error of each coordinate of q_i on the way; errors: by name.

    steps: of the run; adaptive: their length follows from a tolerance, and a window is a few of the method's own.
    """

    def __init__(self, steps: int, adaptive: bool = False) -> None:
        self.adaptive = adaptive
        self.late, self.lates = 0.0, 0.0  # by how much what turns is late at the end [s], and the sum of magnitudes
        self.length = max(SHORTEST, round(SHARE * steps / WINDOWS))
        self.count = min(WINDOWS, int(2 * SHARE * steps / self.length)) if steps >= 2 * SHORTEST else 0
        if adaptive:
            self.count = min(WINDOWS, steps)
        self.marks = [steps * k // self.count for k in range(self.count)]
        self.apart = steps / max(1, self.count)
        self.errors: dict[str, CoordinateError] = {}
        self.seen: np.ndarray | None = None  # (3, n) of all coordinates: lowest, highest, fastest
        self.measured: dict[str, float] = {}  # of the whole motion, where that was compared with a finer one
        self.carried = CarriedError(steps)

    def until_next(self, step: int) -> int | None:
        """Steps to where the next window starts or what is carried is looked at; None if there is none behind."""
        ahead = [mark - step for mark in self.marks if mark > step][:1]
        return min([*ahead, *filter(None, [self.carried.until_next(step)])], default=None)

    def look(self, segment: Segment, z: np.ndarray, guard: Guard) -> None:
        """Judge the window that starts at z (whole, flat), if one does; near a singular position it says nothing."""
        with np.errstate(all="ignore"):
            step = segment.step_of(z)
            if step in self.marks or (step in self.carried.marks and not self.carried.ended):
                self.watch(*(part[None] for part in seen_state(segment, z)))
            self.carried.look(segment, z)
            if step in self.marks:
                self._window(segment, z, guard)

    def _window(self, segment: Segment, z: np.ndarray, guard: Guard) -> None:
        """Judge the window from z."""
        window = window_at(segment, z, self.length)
        before = segment.energies(segment.stepper.state(z), segment.plan.scheme.constants(segment.c))[0]
        found = None if window is None else self._judged(segment, window, guard, before)
        if window is None or found is None:
            return
        (dq, dq_dot), (q, q_dot), slower = found
        windows = self.apart * segment.plan.grid.dt_L / window.seconds
        self._count(segment, window, dq * windows, (q, q_dot), slower * windows)
        self.carried.add(*small_change(segment.model, q, q_dot, dq * windows, dq_dot * windows))

    def _count(self, segment: Segment, window: Window, dq: np.ndarray, end: States, slower: float) -> None:
        """Add the errors (n,) and dE / 2 T until the next window, by those of a window; end: its last state."""
        time, (names, columns) = window.t, followed(segment.model)
        late = slower * (segment.plan.t_end - time)
        self.late, self.lates = self.late + late, self.lates + abs(late)
        for name, k in zip(names, columns, strict=True):
            one, error = self.errors.setdefault(name, CoordinateError()), abs(float(dq[k]))
            one.error += error
            one.widen(np.array([window.q[k], end[0][k]]), np.array([window.q_dot[k], end[1][k]]))
            if error > one.worst:
                one.worst, one.worst_time = error, time

    def _judged(
        self, segment: Segment, window: Window, guard: Guard, kinetic_before: float
    ) -> tuple[States, States, float] | None:
        """Errors (n,) of coordinates and rates, both at the end, and dE / 2 T; None if the window tells nothing.

        kinetic_before: T [J] where the window starts.
        """
        if guard.alarm(*segment.determinants(window.own)):
            return None
        ends, energies = [], []
        for z, constants in ((window.own, window.own_constants), (window.finer, window.finer_constants)):
            ends.append(seen_state(segment, z, constants))
            energies.append(segment.energies(segment.stepper.state(z), constants))
        dq, dq_dot = ((own - finer) * window.more for own, finer in zip(*ends, strict=True))
        kinetic = energies[1][0]
        # a long step from rest errs by much of the little energy that is there then, and that tells no delay
        steady = kinetic > 0 and (not self.adaptive or kinetic_before > kinetic / 2)
        slower = (sum(energies[0]) - sum(energies[1])) * window.more / (2 * kinetic) if steady else 0.0
        return ((dq, dq_dot), ends[0], slower) if np.isfinite([*dq, *dq_dot, slower]).all() else None

    def watch(self, q: np.ndarray, q_dot: np.ndarray) -> None:
        """See samples of all coordinates and rates (N, n): ranges must not be those of the windows alone, which may all
        lie at one phase of the motion.
        """
        if len(q):
            seen = np.array([np.fmin.reduce(q), np.fmax.reduce(q), np.fmax.reduce(np.abs(q_dot))])
            if self.seen is not None:
                seen = np.array([np.fmin(seen[0], self.seen[0]), *np.fmax(seen[1:], self.seen[1:])])
            self.seen = seen

    def widen(self, model: Model) -> None:
        """The ranges by all that was seen."""
        seen = np.zeros((3, 0)) if self.seen is None else self.seen
        for name, one in self.errors.items() if seen.size else ():
            of_one = seen[:, model.coordinates.index(name)]
            one.widen(of_one[:2], of_one[2:])

    def error(self, model: Model, name: str) -> float:
        """Of a coordinate at the end of the run [m or rad]: what its motion has made of the errors of windows, at most
        all of the range; where nothing was carried on to the end, or until it was lost, what windows and the delay of
        the mechanism add up to, or more if errors have grown until then. Where the whole motion was measured, what that
        told.
        """
        if name in self.measured:
            return self.measured[name]
        one = self.errors.get(name, CoordinateError(low=0.0, high=0.0))
        carried = min(float(self._carried(model, name).max(initial=0.0)), one.high - one.low)
        if self.carried.arrived or self.carried.lost:
            return carried
        added = one.error
        if abs(self.late) >= ONE_SIGN * self.lates and self._turns(model):
            added = float(np.hypot(added, min(one.fastest * abs(self.late), one.high - one.low)))
        return max(added, carried) if self._growth(model) > GROWN else added

    def _carried(self, model: Model, name: str, first: int = 0) -> np.ndarray:
        """(N,) magnitudes of what was carried of a coordinate, at the times of its course; first: n for what they would
        be if nothing grew.
        """
        return np.array([row[1 + first + model.coordinates.index(name)] for row in self.carried.course])

    def _amplitudes(self, model: Model) -> np.ndarray:
        seen = [self.errors.get(name, CoordinateError(low=0.0, high=0.0)) for name in followed(model)[0]]
        return floored(model, np.array([one.amplitude for one in seen]))

    def _growth(self, model: Model) -> float:
        """By how much errors have grown, seen at the coordinate and the time where they are the largest; 1 at least."""
        if not self.carried.course:
            return 1.0
        names = followed(model)[0]
        courses = np.array([self._carried(model, name) for name in names]) / self._amplitudes(model)[:, None]
        k, at = np.unravel_index(int(courses.argmax()), courses.shape)
        calm = self._carried(model, names[k], len(model.coordinates))[at] / self._amplitudes(model)[k]
        return float(max(1.0, courses[k, at] / calm)) if calm > 0 else 1.0

    def _grown(self, model: Model) -> dict[str, float | int | str]:
        """What to say where the motion itself makes errors grow: by how much, and until when the run is good."""
        growth = self._growth(model)
        if growth < GROWN and not self.carried.lost:
            return {}
        passed = {}
        for name, amplitude in zip(followed(model)[0], self._amplitudes(model), strict=True):
            large = np.flatnonzero(self._carried(model, name) > WORTH_A_WORD * amplitude)
            if len(large):
                passed[name] = float(self.carried.course[large[0]][0])
        if not passed:
            return {"error_growth": growth}
        name = min(passed, key=lambda one: passed[one])
        grows = f"this motion is unstable in itself: small errors grow {growth:.2g} times"
        return {
            "error_growth": growth,
            "reliable_until": passed[name],
            "remark": (
                f"{grows if growth >= GROWN else 'the error of this run is lost'}, and that of {name} passes "
                f"{100 * WORTH_A_WORD:.0f} % of its amplitude at about t = {passed[name]:.4g} s; what follows is not "
                f"to be relied on. A smaller {'tolerance' if self.adaptive else 'step'} or a scheme of higher order "
                "moves that time on, but not far"
            ),
        }

    def _turns(self, model: Model) -> bool:
        angles = {entry.name for entry in model.description.coordinates if entry.unit == "rad" and not entry.elastic}
        return any(name in angles and one.high - one.low > ROUND for name, one in self.errors.items())

    def relative(self, model: Model) -> tuple[dict[str, float], dict[str, float]]:
        """Errors of q_i relative to the amplitudes, and if all windows were as the worst; a still one says nothing."""
        names = followed(model)[0]
        seen = [self.errors.get(name, CoordinateError(low=0.0, high=0.0)) for name in names]
        amplitudes = floored(model, np.array([one.amplitude for one in seen]))
        errors = np.array([self.error(model, name) for name in names])
        at_worst = np.array([0.0 if self.measured else one.worst for one in seen]) * self.count
        likely, most = errors / amplitudes, np.maximum(errors, at_worst) / amplitudes
        return dict(zip(names, likely.tolist(), strict=True)), dict(zip(names, most.tolist(), strict=True))

    def stats(self, model: Model) -> dict[str, float | int | str]:
        """For Solution.stats: of each coordinate its estimated error and the worst time [s]; the worst of all."""
        found: dict[str, float | int | str] = {}
        for name, one in self.errors.items():
            found |= {f"estimated_error.{name}": self.error(model, name), f"worst_time.{name}": one.worst_time}
        if self.errors:
            relative, at_worst = self.relative(model)
            name = max(relative, key=lambda one: relative[one])
            found |= {"estimated_error": relative[name], "estimated_error_of": name}
            name = max(at_worst, key=lambda one: at_worst[one])
            if at_worst[name] > WORTH_A_WORD:
                time = self.errors[name].worst_time
                said = f"is {relative[name]:.2g} of its amplitude, measured by a finer run"
                if not self.measured:
                    said = (
                        f"is estimated at {relative[name]:.2g} of its amplitude, or {at_worst[name]:.2g} if all of "
                        f"the motion is as near t = {time:.4g} s"
                    )
                found["remark"] = (
                    f"the error of {name} {said}: "
                    f"take a smaller {'tolerance' if self.adaptive else 'step'}, or another scheme (symgen advise)"
                )
            if not self.measured or max(relative.values()) > WORTH_A_WORD:
                found |= self._grown(model)
        return found

    def memory(self) -> dict[str, list[float]]:
        """In plain numbers, by coordinate; the delay and what was seen have no name."""
        kept = {name: [float(value) for value in astuple(one)] for name, one in self.errors.items()}
        seen = [] if self.seen is None else self.seen.ravel().tolist()
        return {"": [self.late, self.lates, *seen], **kept}

    def resume(self, memory: Mapping[str, Sequence[float]]) -> None:
        """From `memory`."""
        self.late, self.lates, *seen = memory[""]
        self.seen = np.array(seen).reshape(3, -1) if seen else None
        self.errors = {name: CoordinateError(*values) for name, values in memory.items() if name}
