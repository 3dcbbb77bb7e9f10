"""From the tolerance of a motion to that of its steps: the whole motion is tried with coarse ones first.

Errors of steps add up over a motion or die out in it, by factors from 10 to 10,000 from mechanism to mechanism, but
nearly in proportion to the tolerance of the steps. A trial is the whole motion, seen at SEEN times. What two trials
differ by is the error of the coarser one. The first trial also tells the amplitudes by which errors are measured, so
that the first steps of the run are not shorter than all of the motion asks for.

    trials      at LOOSEST, for the amplitudes; at COARSER times what is asked, and at what is asked
    further     where the tolerance that is wanted lies far from both: coarser or finer ones, at most MOST in all
    the run     with the tolerance of steps at which the motion's error comes to AIM of what is asked
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import followed, whole
from runtime.contract.model import Model
from runtime.results.sampling import evaluate
from runtime.running.segment import Segment
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.adaptive.error_norm import FLOOR, LEAST
from runtime.schemes.adaptive.impulses import run_across
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.impulse import Impulse, moves_in_time
from runtime.schemes.switching.times import SwitchTime

SEEN = 100  # states of a trial
LOOSEST, FINEST = 1.0, 1e-13  # tolerances of steps
RANGING = 0.1  # of the trial that amplitudes are first told by
COARSER = 10.0  # tolerance of the coarser trial over what is asked
FAR = 10.0  # beyond the finest trial, errors are not taken to be in proportion to the tolerance
NEARER = 100.0  # at most, from one further trial to the next
MOST = 6  # trials that are compared
SLOPES = (0.8, 1.25)  # of an error's power of the tolerance over what the orders of the method say
AIM = 0.4  # of what is asked: the error that is aimed at
EARLY = 8  # states, before which the length of a trial is not told from its beginning
OPERATIONS = 3e9  # of all trials of a method, at most: some seconds


@dataclass(frozen=True)
class TriedMotion:
    """A trial: a motion with steps to a tolerance.

    seen (SEEN + 1, n): what tells the motion. low, high (n_i): its ranges. first, longest [s]: a step at its start, and
    the longest. operations: of all steps.
    """

    tolerance: float
    seen: np.ndarray
    low: np.ndarray
    high: np.ndarray
    first: float
    longest: float
    operations: float


@dataclass(frozen=True)
class Calibration:
    """What trials tell a run.

    per_step: tolerance of its steps over that of the motion. low, high (n_i): ranges of the motion. first, longest
    [s]: steps to be expected at its start, and at most. error: expected of the motion; operations: of the run. trials:
    how many were made; tried: their operations.
    """

    per_step: float
    low: np.ndarray
    high: np.ndarray
    first: float
    longest: float
    error: float
    operations: float
    trials: int
    tried: float

    def told(self) -> dict[str, float | int | str]:
        """For the statistics of the run."""
        return {"trials": self.trials, "trial_operations": self.tried, "expected_error": self.error}

    def begin(self, scheme: AdaptiveSteps, z: np.ndarray) -> None:
        """Let the motion from z (flat) on follow it."""
        for name, value in (
            ("per_step", self.per_step),
            ("q_low", self.low),
            ("q_high", self.high),
            ("ranging", 0.0),
            ("h_next", self.first),
        ):
            z[scheme.layout.slice(name)] = value


class Trials:
    """Trials of a scheme that is compiled, from z (flat) over `span` [s]; c (c_size,) are the model's constants.

    switches: times that no step crosses. budget: operations that all trials together may take. expected: operations
    of the coarsest, also where it was given up.
    """

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
        self.made: list[TriedMotion] = []  # ever finer
        self.spent, self.tries, self.expected = 0.0, 0, np.inf

    @property
    def model(self) -> Model:
        """Of the scheme."""
        return self.scheme.model

    def calibration(self, asked: float) -> Calibration | None:
        """For a motion with that error; None where trials told nothing, or took more than their budget."""
        with np.errstate(all="ignore"):
            first = self._tried(max(RANGING, COARSER * asked), known=None)
            if first is None:
                return None
            for tolerance in dict.fromkeys((min(LOOSEST, COARSER * asked), asked)):
                if not self._add(tolerance, first):
                    return None
            return self._searched(asked, first)

    def _searched(self, asked: float, first: TriedMotion) -> Calibration | None:
        """Further trials where they are needed, and what all of them tell."""
        wanted = self._wanted(AIM * asked)
        while len(self.made) < MOST:
            coarsest, finest = self.made[0].tolerance, self.made[-1].tolerance
            if wanted > 1.5 * coarsest and coarsest < LOOSEST:
                more = min(wanted, NEARER * coarsest, LOOSEST)
            elif wanted < finest / FAR and finest > FINEST:
                more = max(COARSER**0.5 * wanted, finest / NEARER, FINEST)
            else:
                break
            if not self._add(more, first):
                return None
            wanted = self._wanted(AIM * asked)
        wanted = min(max(wanted, self.made[-1].tolerance / NEARER, FINEST), LOOSEST)
        return self._told(asked, wanted)

    def _told(self, asked: float, wanted: float) -> Calibration:
        nearest = min(self.made, key=lambda one: abs(np.log(one.tolerance / wanted)))
        finest, p = self.made[-1], self.scheme.error_order
        longer = (wanted / nearest.tolerance) ** (1 / p)
        tolerance, found, slope = self._line(AIM * asked)
        return Calibration(
            wanted / asked,
            finest.low,
            finest.high,
            nearest.first * min(longer, 1.0),
            nearest.longest * longer,
            float(np.exp(found + slope * (np.log(wanted) - tolerance))),
            nearest.operations / longer,
            self.tries,
            self.spent,
        )

    def _add(self, tolerance: float, first: TriedMotion) -> bool:
        """One more trial, in its place; False where there is none."""
        known = self.made[-1] if self.made else first
        one = self._tried(tolerance, known)
        if one is None:
            return False
        self.made = sorted([*self.made, one], key=lambda trial: -trial.tolerance)
        return True

    def _line(self, error: float) -> tuple[float, float, float]:
        """(log tolerance, log error, slope) of the trial whose error is nearest to this one, of all but the finest.

        The slope is that to the next one, within SLOPES of what the orders of the method say.
        """
        pairs = zip(self.made, self.made[1:], strict=False)
        x = np.log([one.tolerance for one in self.made[:-1]])
        y = np.log([max(self._error(one, finer), 1e-16) for one, finer in pairs])
        order = self.scheme.order / self.scheme.error_order
        k = int(np.argmin(abs(y - np.log(error))))
        slope = order
        if len(x) > 1:
            other = k + 1 if k == 0 or (k + 1 < len(x) and y[k] > np.log(error)) else k - 1
            slope = (y[other] - y[k]) / (x[other] - x[k])
        least, most = SLOPES[0] * order, max(SLOPES[1] * order, 1.0)
        return float(x[k]), float(y[k]), float(min(max(slope, least), most))

    def _wanted(self, error: float) -> float:
        """The tolerance of steps that leads to an error of the motion."""
        tolerance, found, slope = self._line(error)
        return float(np.exp(tolerance + (np.log(error) - found) / slope))

    def _error(self, one: TriedMotion, finer: TriedMotion) -> float:
        """RMS over the motion of the worst coordinate, relative to its RMS amplitude."""
        seen = finer.seen
        amplitude = np.sqrt(np.mean((seen - seen.mean(axis=0)) ** 2, axis=0))
        entries = {entry.name: (entry.kind, entry.unit) for entry in self.model.description.coordinates}
        kinds = [entries[name] for name in followed(self.model)[0]]
        largest = {kind: max(a for a, k in zip(amplitude, kinds, strict=True) if k == kind) for kind in kinds}
        floor = np.array([max(LEAST, FLOOR * largest[kind]) for kind in kinds])
        off = np.sqrt(np.mean((one.seen - seen) ** 2, axis=0)) / np.maximum(amplitude, floor)
        worst = float(off.max())
        return worst if np.isfinite(worst) else 1e16

    def _tried(self, tolerance: float, known: TriedMotion | None) -> TriedMotion | None:
        """The motion with steps to a tolerance, or None where it is lost; known: a trial that tells its ranges."""
        scheme, layout, z = self.scheme, self.scheme.layout, self.z.copy()
        ready = self.stepper.ready_for(scheme.constants(self.c, self.span / SEEN, tolerance))
        if known is not None:
            longer = (tolerance / known.tolerance) ** (1 / scheme.error_order)
            for name, value in (("q_low", known.low), ("q_high", known.high), ("ranging", 0.0)):
                z[layout.slice(name)] = value
            z[layout.slice("h_next")] = known.first * min(1.0, longer)
        states, first, spent = [self.stepper.state(z).copy()], 0.0, [0.0]
        self.tries += 1
        while len(states) <= SEEN:
            run_across(self.stepper, z, 1, ready, self.c, self.span / SEEN, self.switches, self._impulses)
            spent = [*spent[: len(states)], scheme.operations_taken(z, self.stepper.program)]
            if int(z[1]) == len(states):
                states.append(self.stepper.state(z).copy())
            first = first or float(z[layout.slice("h_next")][0])
            if scheme.is_stuck(z) or self._too_much(spent):
                return None
        self.spent += spent[-1]
        seen, low, high = self._seen(np.array(states)), z[layout.slice("q_low")], z[layout.slice("q_high")]
        if not scheme.charts.size:  # narrower than those of a coarse trial that went astray
            low, high = seen.min(axis=0), seen.max(axis=0)
        if not np.isfinite([*low, *high]).all():
            return None
        return TriedMotion(tolerance, seen, low.copy(), high.copy(), first, float(scheme.longest(z)), spent[-1])

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


def trials_of(segment: Segment, state: ConsistentState) -> Calibration | None:
    """What trials from a state tell a run; None where the tolerance is that of steps, or there is none."""
    plan, scheme = segment.plan, segment.plan.scheme
    if not isinstance(scheme, AdaptiveSteps) or scheme.error_of == "step":
        return None
    span = plan.t_end - plan.t0
    z = segment.stepper.start(plan.t0, state.q, state.q_dot, segment.c, span / SEEN)
    return Trials(segment.stepper, z, segment.c, span, segment.switches).calibration(scheme.tolerance)
