"""The exact Jacobian of a major step, stage by stage: the amplification matrix of the scheme at a state.

Every stage is a CasADi Function, so its Jacobian comes from automatic differentiation; a step is their product along
the states that the step passes. An iteration y <- F(y, z) is differentiated at its fixed point by the implicit-function
theorem, dy = (1 - F_y)^-1 F_z dz: the sweeps that reach it are as many as the value needs (one, at rest), and their
product need not be the derivative of what they reach. Where F is no contraction the iteration fails in a run, and the
matrix is not finite.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import casadi as ca
import numpy as np
from scipy.sparse import csc_array

from runtime.contract.orientations import angular_velocity, chart_rates, parameter_rates, rotation
from runtime.engine.program import Repeat, Until
from runtime.schemes.scheme import Scheme

# (z, dz, c) -> (z after it, dz after it), of a part of the program
Advance = Callable[[np.ndarray, np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]


class TangentStep:
    """One major step of a scheme with its derivative by the fields of z that act on the next step."""

    def __init__(self, scheme: Scheme) -> None:
        self.scheme, self.program = scheme, scheme.program()
        slices = [scheme.layout.slice(name) for name in scheme.memory if name != "chart"]
        self.columns = np.concatenate([np.arange(part.start, part.stop) for part in slices]).astype(int)
        kept = [scheme.layout.slice(name) for name in scheme.bookkeeping]
        self._bookkeeping = np.concatenate([np.arange(part.start, part.stop) for part in kept]).astype(int)
        self._step = self.program.fold(_tangent_of_stage, _in_sequence, self._again)

    def __call__(self, z: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(z after a major step, amplification matrix on `columns`)."""
        tangent = np.zeros((len(z), len(self.columns)))
        tangent[self.columns, np.arange(len(self.columns))] = 1.0
        self._set_out(z, tangent)
        z, tangent = self._step(z, tangent, c)
        self._arrive(z, tangent)
        return z, tangent[self.columns]

    def _orientations(self) -> Iterator[tuple[np.ndarray, slice]]:
        """(places of the turns in z, of the chart) of each orientation; changes are rotations in its axes."""
        layout = self.scheme.layout
        if "chart" in layout.sizes:
            first, at = layout.slice("chart").start, self.scheme.model.places
            where = np.zeros(at.n_i + len(self.scheme.model.q_d), dtype=int)
            where[: at.n_i] = layout.slice("x").start + np.arange(at.n_i)
            where[at.n_i + at.loops] = layout.slice("loop").start + np.arange(len(at.loops))
            for k, turns in enumerate(at.turns):
                yield where[turns], slice(first + 4 * k, first + 4 * k + 4)

    def _set_out(self, z: np.ndarray, tangent: np.ndarray) -> None:
        """Changes of turns put into their charts, from which everything else counts, in place."""
        for turns, chart in self._orientations():
            change = rotation(z[turns]) @ tangent[turns]
            tangent[chart], tangent[turns] = parameter_rates(z[chart], change.T).T, 0.0

    def _arrive(self, z: np.ndarray, tangent: np.ndarray) -> None:
        """Changes of turns and charts together as those of turns, in place; infinite behind a whole turn."""
        for turns, chart in self._orientations():
            if not np.linalg.norm(z[turns]) < 2 * np.pi:
                tangent[turns] = np.inf
                continue
            own = np.linalg.solve(chart_rates(z[turns]), tangent[turns])
            tangent[turns] = own + rotation(z[turns]).T @ angular_velocity(z[chart], tangent[chart].T).T

    def _again(self, body: Advance, node: Repeat | Until) -> Advance:
        if isinstance(node, Repeat):
            return _in_sequence([body] * node.count)

        def advance(z: np.ndarray, tangent: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            for _ in range(node.limit):
                if z[node.flag] <= 0:
                    break
                z, _ = body(z, np.zeros((len(z), 0)), c)
            return z, self._at_fixed_point(body(z, np.eye(len(z)), c)[1], tangent)

        return advance

    def _at_fixed_point(self, jacobian: np.ndarray, tangent: np.ndarray) -> np.ndarray:
        """dz after an iteration with this Jacobian of one pass; rows that a pass leaves alone are not iterated."""
        iterated = np.any(jacobian != np.eye(len(jacobian)), axis=1)
        iterated[self._bookkeeping] = False
        F_y, F_z = jacobian[np.ix_(iterated, iterated)], jacobian[np.ix_(iterated, ~iterated)]
        after = tangent.copy()
        if not np.isfinite(jacobian[iterated]).all() or np.abs(np.linalg.eigvals(F_y)).max(initial=0.0) >= 1:
            after[iterated] = np.inf
        else:
            after[iterated] = np.linalg.solve(np.eye(len(F_y)) - F_y, F_z @ tangent[~iterated])
        return after


def _tangent_of_stage(stage: ca.Function) -> Advance:
    z, c = ca.SX.sym("z", stage.size1_in(0)), ca.SX.sym("c", stage.size1_in(1))
    result = stage(z, c)
    jacobian = ca.jacobian(result, z)
    function = ca.Function("tangent", [z, c], [ca.densify(result), jacobian.nz[:]])
    places = (jacobian.sparsity().row(), jacobian.sparsity().colind())
    given, found = [np.zeros(z.numel()), np.zeros(c.numel())], [np.zeros(z.numel()), np.zeros(jacobian.nnz())]
    matrix = csc_array((found[1].copy(), *places), shape=jacobian.shape)
    buffers: Any = function.buffer()  # as matrices of CasADi, values would cost more than the stage itself
    buffer, evaluate = buffers
    for k in range(2):
        buffer.set_arg(k, given[k].data)
        buffer.set_res(k, found[k].data)
    kept = (function, buffer)  # which the buffer itself does not hold

    def advance(
        z: np.ndarray, tangent: np.ndarray, c: np.ndarray, keep: object = kept
    ) -> tuple[np.ndarray, np.ndarray]:
        if not tangent.shape[1]:
            return np.asarray(stage(z, c)).ravel(), tangent
        given[0][:], given[1][:] = z, c
        evaluate()
        matrix.data[:] = found[1]
        return found[0].copy(), matrix @ tangent

    return advance


def _in_sequence(parts: list[Advance]) -> Advance:
    def advance(z: np.ndarray, tangent: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        for part in parts:
            z, tangent = part(z, tangent, c)
        return z, tangent

    return advance
