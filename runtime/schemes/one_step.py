"""One-step schemes on z = (q_i, q_i_dot, loop unknowns): what Runge-Kutta and linearised schemes share.

The loop unknowns are integrated like coordinates; that only gives the guess from which each evaluation closes them.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from runtime.engine.program import Fields
from runtime.schemes.scheme import Scheme
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.state_fields import StateField, state


class OneStep(Scheme):
    """Start, observation and evaluation of one-step schemes. Field v holds q_i_dot."""

    def fields(self) -> dict[str, StateField]:
        """The velocities, and what a scheme adds."""
        return {"v": state(len(self.model.q_i)), **self.further_fields()}

    def further_fields(self) -> dict[str, StateField]:
        """Fields besides x, v and loop."""
        return {}

    def rates(self, z: np.ndarray) -> np.ndarray:
        """The velocities."""
        return np.asarray(z[self.layout.slice("v")])

    def start(self) -> ca.Function:
        """(t0, q_i, q_i_dot, loop unknowns, c) -> z."""
        return self.start_function(self.started)

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """Fields of z at the start."""
        motion = equations.close_well(q_i, loop, t0)
        return {"v": q_i_dot, "loop": equations.loop_part(motion.q_d)}

    def observe(self) -> ca.Function:
        """(z, c) -> OBSERVED between two major steps."""
        return self.observe_function(self._observed)

    def _observed(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX, ca.SX]:
        motion = equations.close_well(z["x"], z["loop"], self.now(z, equations))
        return motion, z["v"], equations.accelerations(motion, z["v"])
