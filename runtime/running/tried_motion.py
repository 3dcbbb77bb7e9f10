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
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.adaptive.error_norm import FLOOR, LEAST
from runtime.schemes.adaptive.impulses import run_across
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.impulse import Impulse, moves_in_time
from runtime.schemes.switching.times import SwitchTime

SEEN = 100  # states of a trial
EARLY = 8  # states, before which the length of a trial is not told from its beginning
OPERATIONS = 3e9  # of all trials of a method, at most: some seconds


@dataclass(frozen=True)
class TriedMotion:
    """A trial: a motion with steps to a tolerance, or of one length (steady [s], else 0).

    seen (SEEN + 1, n): what tells the motion. low, high (n_i): its ranges. first, longest [s]: a step at its start, and
    the longest. steps: made; operations: of all of them. sizes (SEEN,): of estimated errors of steps on the way.
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


class TrialRuns:
    """Makes trials by a scheme that is compiled, from z (flat) over `span` [s]; c (c_size,) are the model's constants.

    switches: times that no step crosses. budget: operations that all trials together may take. spent: by them so far;
    expected: of the coarsest, also where it was given up. alarmed: did the first one come near a singular position?
    begins: tolerances of steps of the first trial, the next one where it is lost. passes: are such positions passed?
    """

    begins: tuple[float, ...] = (0.1,)
    passes = False

    def __init__(
        self,
        stepper: Stepper,
        z: np.ndarray,
        c: np.ndarray,
        span: float,
        switches: list[SwitchTime],
        budget: float = OPERATIONS,
    ) -> None:
        scheme = stepper.scheme
        assert isinstance(scheme, AdaptiveSteps)
        self.scheme, self.stepper, self.z, self.c, self.span = scheme, stepper, z, c, span
        self.switches, self.budget = switches, budget
        self._impulses: dict[float, Impulse] | None = {} if moves_in_time(scheme.model) else None  # nobody asks
        self.spent, self.tries, self.expected = 0.0, 0, np.inf
        self.alarmed = False

    @property
    def model(self) -> Model:
        """Of the scheme."""
        return self.scheme.model

    def of_tolerance(self, tolerance: float, known: TriedMotion | None) -> TriedMotion | None:
        """With steps to a tolerance; known: a trial that tells its ranges. None where the motion is lost."""
        z, layout = self.z.copy(), self.scheme.layout
        if known is not None:
            longer = (tolerance / known.tolerance) ** (1 / self.scheme.error_order)
            self._ranged(z, known)
            z[layout.slice("h_next")] = known.first * min(1.0, longer)
        return self._made(z, tolerance)

    def of_length(self, h: float, known: TriedMotion) -> TriedMotion | None:
        """With steps of h [s]."""
        z = self.z.copy()
        self._ranged(z, known)
        z[self.scheme.layout.slice("steady")] = h
        return self._made(z, known.tolerance)

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

    def _ranged(self, z: np.ndarray, known: TriedMotion) -> None:
        for name, value in (("q_low", known.low), ("q_high", known.high), ("ranging", 0.0)):
            z[self.scheme.layout.slice(name)] = value

    def _made(self, z: np.ndarray, tolerance: float) -> TriedMotion | None:
        """The motion from z (flat), None where it is lost or takes too much."""
        scheme, layout = self.scheme, self.scheme.layout
        ready = self.stepper.ready_for(scheme.constants(self.c, self.span / SEEN, tolerance))
        guard = Guard.of(layout.sizes["det_low"]) if self.tries == 0 else Guard()
        states, first, spent = [self.stepper.state(z).copy()], 0.0, [0.0]
        self.tries += 1
        while len(states) <= SEEN:
            z[layout.slice("det_low")], z[layout.slice("det_high")] = LOWEST, HIGHEST
            run_across(self.stepper, z, 1, ready, self.c, self.span / SEEN, self.switches, self._impulses)
            self.alarmed |= self._is_near(z, guard)
            spent = [*spent[: len(states)], scheme.operations_taken(z, self.stepper.program)]
            if int(z[1]) == len(states):
                states.append(self.stepper.state(z).copy())
            first = first or float(z[layout.slice("h_next")][0])
            if scheme.is_stuck(z) or self._too_much(spent):
                return None
        self.spent += spent[-1]
        kept = np.array(states)
        seen, low, high = self._seen(kept), z[layout.slice("q_low")], z[layout.slice("q_high")]
        steady = float(z[layout.slice("steady")][0])
        if not scheme.charts.size and not steady:  # narrower than those of a coarse trial that went astray
            low, high = seen.min(axis=0), seen.max(axis=0)
        if not np.isfinite([*low, *high]).all():
            return None
        taken, longest = int(z[layout.slice("accepted")][0]), float(scheme.longest(z))
        made = (low.copy(), high.copy(), steady or first, longest, taken, spent[-1], self._sizes(kept[1:], layout))
        return TriedMotion(tolerance, steady, seen, *made)

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

    def _too_much(self, spent: list[float]) -> bool:
        """Will a trial that has taken these operations from state to state need more than is left of the budget?"""
        seen = len(spent) - 1
        if seen < EARLY and spent[-1] < self.budget / 2:
            return False
        half = seen // 2
        expected = spent[-1] + (SEEN - seen) * (spent[-1] - spent[half]) / max(1, seen - half)
        if self.tries == 1:
            self.expected = expected
        return self.spent + expected > self.budget

    def _seen(self, states: np.ndarray) -> np.ndarray:
        """What tells the motion (N, n) of the scheme's states (N, n_z)."""
        if not self.scheme.charts.size:
            return states[:, self.scheme.layout.slice("x")]
        found = evaluate(self.scheme.observer, {"z": states}, self.scheme.constants(self.c, self.span / SEEN))
        return whole(self.model, found["q_i"], found["q_d"])[:, followed(self.model)[1]]
