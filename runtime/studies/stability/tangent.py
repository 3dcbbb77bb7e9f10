"""The exact Jacobian of a major step, stage by stage: the amplification matrix of the scheme at a state.

Every stage is a CasADi Function, so its Jacobian comes from automatic differentiation; a step is their product along
the states that the step passes.
"""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np

from runtime.engine.program import Call, Program, Repeat, Sequence, stages
from runtime.schemes.scheme import Scheme


class TangentStep:
    """One major step of a scheme with its derivative by the fields of z that act on the next step."""

    def __init__(self, scheme: Scheme) -> None:
        self.scheme, self.program = scheme, scheme.program()
        slices = [scheme.layout.slice(name) for name in scheme.memory]
        self.columns = np.concatenate([np.arange(part.start, part.stop) for part in slices]).astype(int)
        self._stages: dict[str, Any] = {}
        for stage in stages(self.program):
            z, c = ca.SX.sym("z", stage.size1_in(0)), ca.SX.sym("c", stage.size1_in(1))
            result = stage(z, c)
            self._stages[stage.name()] = ca.Function("tangent", [z, c], [result, ca.jacobian(result, z)])

    def __call__(self, z: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(z after a major step, amplification matrix on `columns`)."""
        tangent = np.zeros((len(z), len(self.columns)))
        tangent[self.columns, np.arange(len(self.columns))] = 1.0
        z, tangent = self._advance(self.program, z, tangent, c)
        return z, tangent[self.columns]

    def _advance(
        self, node: Program, z: np.ndarray, tangent: np.ndarray, c: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        if isinstance(node, Call):
            result, jacobian = self._stages[node.stage.name()](z, c)
            return np.asarray(result).ravel(), jacobian.sparse() @ tangent
        if isinstance(node, Sequence):
            for part in node.parts:
                z, tangent = self._advance(part, z, tangent, c)
            return z, tangent
        count = node.count if isinstance(node, Repeat) else node.limit
        for _ in range(count):
            if not isinstance(node, Repeat) and z[node.flag] <= 0:
                break
            z, tangent = self._advance(node.body, z, tangent, c)
        return z, tangent
