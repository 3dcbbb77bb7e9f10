"""One-step schemes on z = (q_i, q_i_dot, loop unknowns): what Runge-Kutta and linearised schemes share.

The loop unknowns are integrated like coordinates; that only gives the guess from which each evaluation closes them.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from runtime.engine.program import Fields
from runtime.schemes.kernels import Motion, StepKernels
from runtime.schemes.scheme import Scheme

START_CLOSURE_ITERATIONS = 4


class OneStep(Scheme):
    """Start, observation and evaluation of one-step schemes. Field v holds q_i_dot."""

    memory: tuple[str, ...] = ("x", "v", "loop")

    def fields(self) -> dict[str, int]:
        """The velocities, and what a scheme adds."""
        return {"v": len(self.model.q_i), **self.work_fields()}

    def work_fields(self) -> dict[str, int]:
        """Fields that pass values between stages of one step."""
        return {}

    def rates(self, z: np.ndarray) -> np.ndarray:
        """The velocities."""
        return np.asarray(z[self.layout.slice("v")])

    def start(self) -> ca.Function:
        """(t0, q_i, q_i_dot, loop unknowns, c) -> z."""
        return self.start_function(self.started)

    def started(self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, kernels: StepKernels) -> Mapping[str, ca.SX]:
        """Fields of z at the start."""
        motion = kernels.close(q_i, loop, t0, START_CLOSURE_ITERATIONS)
        return {"v": q_i_dot, "loop": kernels.loop_part(motion.q_d)}

    def observe(self) -> ca.Function:
        """(z, c) -> OBSERVED between two major steps."""
        return self.observe_function(self._observed)

    def _observed(self, z: Fields, kernels: StepKernels) -> tuple[Motion, ca.SX, ca.SX]:
        motion = kernels.close(z["x"], z["loop"], self.now(z, kernels), START_CLOSURE_ITERATIONS)
        return motion, z["v"], kernels.accelerations(motion, z["v"])

    def moved(self, z: Fields, x: ca.SX, v: ca.SX, loop: ca.SX, motion: Motion) -> dict[str, ca.SX]:
        """The fields that change at the end of a major step."""
        return {"x": x, "v": v, "loop": loop, "n": z["n"] + 1, **self.closed(z, motion)}
