"""The exact Jacobian of a major step, stage by stage: the amplification matrix of the scheme at a state.

Every stage is a CasADi Function, so its Jacobian comes from automatic differentiation; a step is their product along
the states that the step passes.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np

from runtime.engine.program import Repeat, Until
from runtime.schemes.scheme import Scheme

# (z, dz, c) -> (z after it, dz after it), of a part of the program
Advance = Callable[[np.ndarray, np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]


class TangentStep:
    """One major step of a scheme with its derivative by the fields of z that act on the next step."""

    def __init__(self, scheme: Scheme) -> None:
        self.scheme, self.program = scheme, scheme.program()
        slices = [scheme.layout.slice(name) for name in scheme.memory]
        self.columns = np.concatenate([np.arange(part.start, part.stop) for part in slices]).astype(int)
        self._step = self.program.fold(_tangent_of_stage, _in_sequence, _repeated)

    def __call__(self, z: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(z after a major step, amplification matrix on `columns`)."""
        tangent = np.zeros((len(z), len(self.columns)))
        tangent[self.columns, np.arange(len(self.columns))] = 1.0
        z, tangent = self._step(z, tangent, c)
        return z, tangent[self.columns]


def _tangent_of_stage(stage: ca.Function) -> Advance:
    z, c = ca.SX.sym("z", stage.size1_in(0)), ca.SX.sym("c", stage.size1_in(1))
    result = stage(z, c)
    function = ca.Function("tangent", [z, c], [result, ca.jacobian(result, z)])

    def advance(z: np.ndarray, tangent: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        value, jacobian = function(z, c)
        return np.asarray(value).ravel(), jacobian.sparse() @ tangent

    return advance


def _in_sequence(parts: list[Advance]) -> Advance:
    def advance(z: np.ndarray, tangent: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        for part in parts:
            z, tangent = part(z, tangent, c)
        return z, tangent

    return advance


def _repeated(body: Advance, node: Repeat | Until) -> Advance:
    def advance(z: np.ndarray, tangent: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        for _ in range(node.count if isinstance(node, Repeat) else node.limit):
            if isinstance(node, Until) and z[node.flag] <= 0:
                break
            z, tangent = body(z, tangent, c)
        return z, tangent

    return advance
