"""A linear system kept in fields of z between the stages of a major step: sparse, so that zeros cost nothing."""

from __future__ import annotations

from collections import Counter

import casadi as ca

from runtime.contract.model import Model
from runtime.engine.program import Fields
from runtime.schemes.linear_propagation import Factors, LinearSystem
from runtime.schemes.options import SchemeError
from runtime.schemes.partial_fractions import poles
from runtime.schemes.sparse_lu import Cells, Number, filled, pattern
from runtime.schemes.stage_equations import StageEquations

MOST_OPERATIONS = 2_000_000  # of the factors: some minutes to compile, and gigabytes
MATRICES = ("M", "J_q", "J_v")


class StoredSystem:
    """Patterns of M_hat, J_q, J_v and of the factors, and how they lie in z.

    shifts: see factors_of; () for no factors. matrices: those that are kept beside the factors.
    """

    def __init__(
        self, model: Model, shifts: tuple[complex, ...] | None = None, matrices: tuple[str, ...] = MATRICES
    ) -> None:
        self.n = len(model.q_i)
        chosen = tuple(pole.r for pole in poles()) if shifts is None else shifts
        self._complex = [bool(r.imag) for r in chosen]
        q, v, t = ca.SX.sym("q", self.n), ca.SX.sym("v", self.n), ca.SX.sym("t")
        equations = StageEquations(model, ca.SX.sym("c", model.c_size + 1))
        motion = equations.close(q, ca.SX.sym("loop", len(model.loop_unknowns)), t, 1)
        if 4 * self.n**3 > MOST_OPERATIONS:  # else even dense factors are short
            self._require_short(model, pattern(equations.condensed(motion, v)[0]))
        found = equations.linearised(motion, v)
        patterns = dict(zip(MATRICES, map(pattern, (found.M_hat, found.J_q, found.J_v)), strict=True))
        self._sparsity = {name: self._of_cells(patterns[name]) for name in matrices}
        self._factors = self._of_cells(filled(set().union(*patterns.values()), self.n))

    def _require_short(self, model: Model, cells: Cells) -> None:
        """Raises SchemeError where the factors of a matrix with these cells take too many operations."""
        factors = filled(cells, self.n)
        below, right = Counter(j for i, j in factors if i < j), Counter(i for i, j in factors if j < i)
        count = sum(below[k] * right[k] for k in range(self.n)) * sum(8 if one else 2 for one in self._complex)
        if count > MOST_OPERATIONS:
            raise SchemeError(
                f"{model.name}: {self.n} independent coordinates",
                f"a scheme that factorises their mass matrix and Jacobians takes {count / 1e6:.0f} million operations "
                f"a step, more than the {MOST_OPERATIONS / 1e6:.0f} that are written out",
                f"take {', '.join(_others(model))}",
            )

    def _of_cells(self, cells: Cells) -> ca.Sparsity:
        ordered = sorted(cells)
        return ca.Sparsity.triplet(self.n, self.n, [i for i, _ in ordered], [j for _, j in ordered])

    def sizes(self) -> dict[str, int]:
        """Sizes of the fields of z."""
        sizes = self.matrix_sizes()
        for k, is_complex in enumerate(self._complex):
            sizes[f"lu_{k}"] = self._factors.nnz() * (2 if is_complex else 1)
        return sizes

    def matrix_sizes(self) -> dict[str, int]:
        """Sizes of those of the matrices that are kept."""
        return {name: sparsity.nnz() for name, sparsity in self._sparsity.items()}

    def pack(self, system: LinearSystem) -> dict[str, ca.SX]:
        """Fields of the matrices."""
        return {name: _entries(getattr(system, name), sparsity) for name, sparsity in self._sparsity.items()}

    def pack_factors(self, factors: Factors) -> dict[str, ca.SX]:
        """Fields of the factors."""
        return {
            f"lu_{k}": ca.vertcat(*(_entries(part, self._factors) for part in (one.re, one.im) if part is not None))
            for k, one in enumerate(factors)
        }

    def unpack(self, z: Fields) -> LinearSystem:
        """All three matrices."""
        return LinearSystem(**self.unpack_matrices(z))

    def unpack_matrices(self, z: Fields) -> dict[str, ca.SX]:
        """The matrices that are kept."""
        return {name: ca.SX(sparsity, z[name]) for name, sparsity in self._sparsity.items()}

    def unpack_factors(self, z: Fields) -> Factors:
        """The factors."""
        found = []
        for k, is_complex in enumerate(self._complex):
            values, size = z[f"lu_{k}"], self._factors.nnz()
            found.append(
                Number(ca.SX(self._factors, values[:size]), ca.SX(self._factors, values[size:]) if is_complex else None)
            )
        return tuple(found)


def _others(model: Model) -> list[str]:
    """Schemes for many coordinates."""
    stiff = ["exponential_rk4", "exponential_midpoint"] if model.has("deflections") else []
    return [*stiff, *(["decoupled", "coupled"] if len(model.groups) == 2 else []), "single_rate", "hht"]


def _entries(matrix: ca.SX, sparsity: ca.Sparsity) -> ca.SX:
    if not sparsity.nnz():  # of nothing CasADi makes a 1 x 1 zero
        return ca.SX(0, 1)
    return ca.SX(ca.project(matrix, sparsity).nz[:])
