"""One trial of a motion: all of it, with coarse steps, seen at SEEN times."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.coordinates import followed, whole
from runtime.contract.model import Model
from runtime.engine.program import Layout
from runtime.results.sampling import evaluate
from runtime.running.segment import HIGHEST, LOWEST
from runtime.running.singular.guard import Guard
from runtime.schemes.adaptive.adaptive_state import FIRST
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.adaptive.error_norm import FLOOR, LEAST
from runtime.schemes.adaptive.impulses import run_across
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.impulse import Impulse, moves_in_time
from runtime.schemes.switching.times import SwitchTime

SEEN = 100  # states of a trial
EARLY = 8  # states, before which the length of a trial is not told from its beginning
OPERATIONS = 3e9  # of all trials of a method, at most: some seconds
RANGING = 0.1  # tolerance of steps of a first trial, at least
LEAST_STEPS = 2
MOST_KEPT = 4_000_000  # numbers of a motion that is kept for a run


@dataclass(frozen=True)
class TriedMotion:
    """A trial: a motion with steps to a tolerance, or of one length (steady [s], else 0).

    seen (SEEN + 1, n): what tells the motion. low, high (n_i): ranges that it was measured by, or has seen. first,
    longest [s]: a step at its start, and the longest. steps: made; operations: of all of them. sizes (SEEN,): of
    estimated errors of steps on the way. seen_low, seen_high (n_i): what q_i were seen between. states (S + 1, n_z): as
    a run that shows as many passes them, where they were kept.
    """

    tolerance: float
    steady: float
    seen: np.ndarray
    low: np.ndarray
    high: np.ndarray
    first: float
    longest: float
    steps: int
    operations: float
    sizes: np.ndarray
    seen_low: np.ndarray
    seen_high: np.ndarray
    states: np.ndarray | None = None


class TrialRuns:
    """Makes trials by a scheme that is compiled, from z (flat) over `span` [s]; c (c_size,) are the model's constants.

    switches: times that no step crosses. budget: operations that all trials together may take. shown: states of the run
    that is to come. least: steps of one length, below which loads may not be seen. spent: operations of trials so far,
    of those that were given up, too; expected: of the last. alarmed: did the last whole one come near a singular
    position? begins: tolerances of steps of a first trial, the next one where it is lost. passes: are such positions
    passed?
    """

    begins: tuple[float, ...] = (RANGING,)
    passes = False

    def __init__(
        self,
        stepper: Stepper,
        z: np.ndarray,
        c: np.ndarray,
        span: float,
        switches: list[SwitchTime],
        budget: float = OPERATIONS,
        shown: int = 0,
        least: int = 0,
    ) -> None:
        scheme = stepper.scheme
        assert isinstance(scheme, AdaptiveSteps)
        self.scheme, self.stepper, self.z, self.c, self.span = scheme, stepper, z, c, span
        self.switches, self.budget, self.least = switches, budget, max(least, LEAST_STEPS)
        self._impulses: dict[float, Impulse] | None = {} if moves_in_time(scheme.model) else None  # nobody asks
        kept = shown if SEEN <= shown and shown * len(z) <= MOST_KEPT else 0
        self.shown = 0 if self._impulses is not None and switches else kept  # impulses are told by who gives them
        self.spent, self.tries, self.expected = 0.0, 0, np.inf
        self.alarmed = False

    @property
    def model(self) -> Model:
        """Of the scheme."""
        return self.scheme.model

    def of_tolerance(
        self, tolerance: float, known: TriedMotion | None, longest: float = np.inf, most: float = np.inf
    ) -> TriedMotion | None:
        """With steps to a tolerance; known: a trial that tells its ranges. None where the motion is lost, where a step
        is as long as `longest` [s], or where it would take more than `most` operations.
        """
        z, layout = self.z.copy(), self.scheme.layout
        z[layout.slice("h_next")] = FIRST * self.span / SEEN
        if known is not None:
            longer = 1.0 if known.steady else (tolerance / known.tolerance) ** (1 / self.scheme.error_order)
            self._ranged(z, known.low, known.high)
            z[layout.slice("h_next")] = known.first * min(1.0, longer)
        return self._made(z, tolerance, longest=longest, most=most)

    def of_length(self, h: float, known: TriedMotion | None, keep: bool = False) -> TriedMotion | None:
        """With steps of h [s]; keep: the states that a run passes."""
        z = self.z.copy()
        if known is not None:
            self._ranged(z, known.seen_low, known.seen_high)
        z[self.scheme.layout.slice("ranging")] = 0.0
        z[self.scheme.layout.slice("steady")] = h
        if self.passes and known is not None:
            return self._made(z, known.tolerance)
        z[self.scheme.layout.slice("h_next")] = h
        return self._made(z, self.scheme.tolerance, keep)

    def again(self, share: float) -> TriedMotion | None:
        """From z as it is, with steps that have a share of the error."""
        z = self.z.copy()
        self.scheme.with_errors(z, share)
        return self._made(z, share * self.scheme.tolerance)

    def error(self, one: TriedMotion, finer: TriedMotion) -> float:
        """RMS over the motion of the worst coordinate, relative to its RMS amplitude."""
        seen = finer.seen
        with np.errstate(all="ignore"):
            amplitude = np.sqrt(np.mean((seen - seen.mean(axis=0)) ** 2, axis=0))
            entries = {entry.name: (entry.kind, entry.unit) for entry in self.model.description.coordinates}
            kinds = [entries[name] for name in followed(self.model)[0]]
            largest = {kind: max(a for a, k in zip(amplitude, kinds, strict=True) if k == kind) for kind in kinds}
            floor = np.array([max(LEAST, FLOOR * largest[kind]) for kind in kinds])
            off = np.sqrt(np.mean((one.seen - seen) ** 2, axis=0)) / np.maximum(amplitude, floor)
        worst = float(off.max())
        return max(worst, 1e-16) if np.isfinite(worst) else 1e16

    def _ranged(self, z: np.ndarray, low: np.ndarray, high: np.ndarray) -> None:
        if np.isfinite([*low, *high]).all():
            for name, value in (("q_low", low), ("q_high", high), ("ranging", 0.0)):
                z[self.scheme.layout.slice(name)] = value

    def _made(
        self, z: np.ndarray, tolerance: float, keep: bool = False, longest: float = np.inf, most: float = np.inf
    ) -> TriedMotion | None:
        """The motion from z (flat), None where it is lost or takes too much."""
        scheme, layout = self.scheme, self.scheme.layout
        count = self.shown if keep and self.shown else SEEN
        dt, low, high, steady = self.span / count, *(z[layout.slice(n)].copy() for n in ("q_low", "q_high", "steady"))
        ready = self.stepper.ready_for(scheme.constants(self.c, dt, tolerance))
        states, at_seen, first, spent = [z.copy()], [z.copy()], 0.0, [0.0]
        self.tries += 1
        guard, alarmed = Guard.of(layout.sizes["det_low"]), False
        while len(states) <= count:
            z[layout.slice("det_low")], z[layout.slice("det_high")] = LOWEST, HIGHEST  # of one state to the next
            run_across(self.stepper, z, 1, ready, self.c, dt, self.switches, self._impulses)
            alarmed |= self._is_near(z, guard)
            first, passed = first or float(z[layout.slice("h_next")][0]), len(at_seen)
            if int(z[1]) == len(states):
                while len(at_seen) * count <= len(states) * SEEN:
                    at_seen.append(self._seen_between(states[-1], z, len(at_seen), count, tolerance))
                states.append(z.copy())
                if len(at_seen) == passed:
                    continue
            spent = [*spent[:passed], scheme.operations_taken(z, self.stepper.program)]
            if scheme.is_stuck(z) or self._too_much(spent, most) or scheme.longest(z) > longest:
                self.spent += spent[-1]
                return None
        self.spent, self.alarmed = self.spent + spent[-1], alarmed
        shown = np.array(at_seen)[:, : layout.size]
        seen = self._seen(shown)
        reached = shown[:, layout.slice("q_seen" if layout.sizes["q_seen"] else "x")]
        if not steady:  # narrower than those of a coarse trial that went astray
            told = [reached.min(axis=0), reached.max(axis=0)]
            low, high = told if not scheme.charts.size else (z[layout.slice("q_low")], z[layout.slice("q_high")])
            if not np.isfinite([*low, *high]).all():
                return None
        made, most = int(z[layout.slice("accepted")][0]), float(scheme.longest(z))
        return TriedMotion(
            tolerance,
            float(steady[0]),
            seen,
            low.copy(),
            high.copy(),
            float(steady[0]) or first,
            most,
            made,
            spent[-1],
            self._sizes(shown[1:], layout),
            reached.min(axis=0),
            reached.max(axis=0),
            np.array(states) if keep and self.shown else None,
        )

    def _seen_between(self, before: np.ndarray, z: np.ndarray, k: int, count: int, tolerance: float) -> np.ndarray:
        """The state k of SEEN, which lies between two of `count`, the second included; its time is its t0."""
        t, dt = z[0] + k * self.span / SEEN, self.span / count
        found = z.copy()
        if k * count != int(z[1]) * SEEN:
            found, program = before.copy(), self.stepper.program
            found[0], found[1] = t - dt, 0
            ready = self.stepper.ready_for(self.scheme.constants(self.c, dt, tolerance))
            run_across(self.stepper, found, 1, ready, self.c, dt, self.switches, self._impulses)
            self.spent += self.scheme.operations_taken(found, program) - self.scheme.operations_taken(before, program)
        found[0], found[1] = t, 0
        return found

    def _is_near(self, z: np.ndarray, guard: Guard) -> bool:
        """Was a determinant of the closure small, or has its sign changed, since z was looked at last?"""
        determinants = z[self.scheme.layout.slice("det_low")], z[self.scheme.layout.slice("det_high")]
        if not len(guard.largest):
            return False
        alarm = guard.alarm(*determinants)
        guard.accept(*determinants)
        return alarm

    @staticmethod
    def _sizes(states: np.ndarray, layout: Layout) -> np.ndarray:
        """(N,) of the estimated errors of the last steps before a scheme's states (N, n_z)."""
        weight, dq, dv, h = (states[:, layout.slice(n)] for n in ("weight", "q_error", "v_error", "h_try"))
        return np.asarray(np.sqrt((weight * (dq * dq + h * h * dv * dv)).sum(axis=1)))

    def _too_much(self, spent: list[float], most: float) -> bool:
        """Will a trial that has taken these operations from state to state need more, or than is left of the budget?"""
        seen = len(spent) - 1
        if seen < EARLY and spent[-1] < min(self.budget, most) / 2:
            return False
        half = seen // 2
        expected = spent[-1] + (SEEN - seen) * (spent[-1] - spent[half]) / max(1, seen - half)
        self.expected = expected
        return expected > min(self.budget - self.spent, most)

    def _seen(self, states: np.ndarray) -> np.ndarray:
        """What tells the motion (N, n) of the scheme's states (N, n_z)."""
        if not self.scheme.charts.size:
            return states[:, self.scheme.layout.slice("x")]
        found = evaluate(self.scheme.observer, {"z": states}, self.scheme.constants(self.c, self.span / SEEN))
        return whole(self.model, found["q_i"], found["q_d"])[:, followed(self.model)[1]]
