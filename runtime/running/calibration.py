"""What trials of a motion tell a run to a tolerance: steps of one length or of many, and what they lead to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.stepper import Stepper


@dataclass(frozen=True)
class Calibration:
    """What trials tell a run.

    per_step: tolerance of its steps over that of the motion. steady: the length of all of its steps [s], 0 where they
    vary. low, high (n_i): ranges of the motion. first, longest [s]: steps to be expected at its start, and at most.
    error: expected of the motion; operations: of the run. trials: how many were made; tried: their operations, less
    those of the run where one of them is the run. states (S + 1, n_z): of that one, as `stepper` has made it. alarmed:
    did they come near singular positions? passes: do they pass those as runs do?
    """

    per_step: float
    steady: float
    low: np.ndarray
    high: np.ndarray
    first: float
    longest: float
    error: float
    operations: float
    trials: int
    tried: float
    states: np.ndarray | None = None
    stepper: Stepper | None = None
    alarmed: bool = False
    passes: bool = False

    @classmethod
    def of_none(cls) -> Calibration:
        """Of trials that came near a singular position and told nothing else."""
        none = np.zeros(0)
        return cls(1.0, 0.0, none, none, 0.0, 0.0, np.inf, np.inf, 0, 0.0, alarmed=True)

    def told(self) -> dict[str, float | int | str]:
        """For the statistics of the run."""
        return {
            "trials": self.trials,
            "trial_operations": self.tried,
            "run_operations": self.operations,
            "expected_error": self.error,
            **({"trials_pass": 1} if self.passes else {}),
        }

    def begin(self, scheme: AdaptiveSteps, z: np.ndarray) -> None:
        """Let the motion from z (flat) on follow it."""
        for name, value in (
            ("per_step", self.per_step),
            ("steady", self.steady),
            ("q_low", self.low),
            ("q_high", self.high),
            ("ranging", 0.0),
            ("h_next", self.first),
        ):
            z[scheme.layout.slice(name)] = value
