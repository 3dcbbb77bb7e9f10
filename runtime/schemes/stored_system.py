"""A linear system kept in fields of z between the stages of a major step: sparse, so that zeros cost nothing."""

from __future__ import annotations

import casadi as ca

from runtime.engine.program import Fields
from runtime.model import Model
from runtime.schemes.kernels import StepKernels
from runtime.schemes.linear_propagation import Factors, LinearSystem, factors_of
from runtime.schemes.sparse_lu import Complex, Entries, Number, Real, pattern

Cells = list[tuple[int, int]]


class StoredSystem:
    """Patterns of M_hat, J_q, J_v and of the factors, and how they lie in z; factors for one or more step sizes.

    shifts: see factors_of. matrices: those that are kept beside the factors.
    """

    def __init__(self, model: Model, sets: tuple[str, ...], shifts: tuple[complex, ...] | None = None,
                 matrices: tuple[str, ...] = ("M", "J_q", "J_v")) -> None:
        self.n, self.sets = len(model.q_i), sets
        q, v, t = ca.SX.sym("q", self.n), ca.SX.sym("v", self.n), ca.SX.sym("t")
        kernels = StepKernels(model, ca.SX.sym("c", model.c_size + 1))
        motion = kernels.close(q, ca.SX.sym("loop", len(model.loop_unknowns)), t, 1)
        found = kernels.linearised(motion, v)
        system = LinearSystem(found.M_hat, found.J_q, found.J_v)
        self._cells: dict[str, Cells] = {name: pattern(getattr(system, name)) for name in matrices}
        factors = factors_of(system, ca.SX(1), shifts)
        self._factor_cells: list[Cells] = [list(entries) for entries in factors]
        self._complex = [isinstance(next(iter(entries.values())), Complex) for entries in factors]

    def fields(self) -> dict[str, int]:
        """Sizes of the fields of z."""
        sizes = {name: len(cells) for name, cells in self._cells.items()}
        for name in self.sets:
            for k, cells in enumerate(self._factor_cells):
                sizes[f"{name}_{k}"] = len(cells) * (2 if self._complex[k] else 1)
        return sizes

    def pack(self, system: LinearSystem) -> dict[str, ca.SX]:
        """Fields of the matrices."""
        return {name: _column([getattr(system, name)[i, j] for i, j in cells]) for name, cells in self._cells.items()}

    def pack_factors(self, name: str, factors: Factors) -> dict[str, ca.SX]:
        """Fields of a set of factors."""
        return {f"{name}_{k}": _column([part for value in entries.values() for part in _parts(value)])
                for k, entries in enumerate(factors)}

    def unpack(self, z: Fields) -> LinearSystem:
        """All three matrices."""
        return LinearSystem(**self.unpack_matrices(z))

    def unpack_matrices(self, z: Fields) -> dict[str, ca.SX]:
        """The matrices that are kept."""
        matrices = {}
        for name, cells in self._cells.items():
            matrix = ca.SX(self.n, self.n)
            for k, (i, j) in enumerate(cells):
                matrix[i, j] = z[name][k]
            matrices[name] = matrix
        return matrices

    def unpack_factors(self, name: str, z: Fields) -> Factors:
        """A set of factors."""
        return tuple(self._entries(k, z[f"{name}_{k}"]) for k in range(len(self._factor_cells)))

    def _entries(self, k: int, values: ca.SX) -> Entries:
        if self._complex[k]:
            return {cell: Complex(values[2 * p], values[2 * p + 1]) for p, cell in enumerate(self._factor_cells[k])}
        return {cell: Real(values[p]) for p, cell in enumerate(self._factor_cells[k])}


def _parts(value: Number) -> list[ca.SX]:
    return [value.re, value.im] if isinstance(value, Complex) else [value.re]


def _column(entries: list[ca.SX]) -> ca.SX:
    return ca.vertcat(*entries) if entries else ca.SX(0, 1)
