"""Central difference with one step for all coordinates: the paper's scheme without sub-steps, Eqs. (40)-(45)."""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from runtime.engine.program import Fields, Program
from runtime.schemes.central_difference import CentralDifference
from runtime.schemes.stage_equations import StageEquations


class SingleRate(CentralDifference):
    """One stage: (44)-(45) solved at once, then all coordinates move."""

    def program(self) -> Program:
        """One step."""
        return self.stage("common_update", self._step)

    def evaluations(self) -> tuple[int, int]:
        """One, or its Newton steps."""
        return self.options.newton_iterations if self.solves_velocity else 1, 0

    def _step(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        motion, v, a = self.solved(z, equations)
        everyone = list(range(len(self.model.q_i)))
        return {
            **self.moved(z, equations, motion, v, a, everyone),
            "n": z["n"] + 1,
        }
