"""A linear structure as data: matrices, loads and what its coordinates are called (Eqs. 3-5)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from runtime.contract.arguments import NAMES, WHOLE
from runtime.contract.errors import SymgenError, is_finite_number, shown_value

Array: TypeAlias = NDArray[np.float64]
Laws: TypeAlias = Callable[[Array], Array]  # times (k,) [s] to values (k, number of laws)

SYMMETRY_ROUNDING = 1e-9  # of the largest entry: assembly in another order differs by this much at most


class StructureError(SymgenError, ValueError):
    """A structure that cannot be: the message names the matrix and the entry, what is wrong, and what to do."""


@dataclass(frozen=True)
class Load:
    """F gains pattern * law(t): pattern (n,) [N], law: number of the time function."""

    pattern: Array
    law: int


@dataclass(frozen=True, eq=False)
class LinearStructure:
    """M x'' + (a M + D) x' + K x = F(t).

    Parameters
    ----------
    stiffness : sparse (n, n) [N/m]
        K, symmetric, positive semi-definite.
    mass : (n,) or sparse (n, n) [kg]
        M, lumped or consistent; explicit steps need it lumped.
    damping : sparse (n, n) [N s/m], optional
        D, symmetric.
    mass_damping : float [1/s]
        a, damping in proportion to the mass.
    coordinates : n names
        By default ``x0``, ``x1``, ...
    loads, laws
        F(t) = sum of pattern * law(t); laws gives all time functions at an array of times.
    width : 1, 2 or 3
        Coordinates of a node, which follow each other and share a step.
    points : (nodes, 2 or 3) [m], optional
    cells : (cells, corners), optional
        Nodes of each triangle, quadrilateral, tetrahedron or hexahedron: for pictures only.

    Raises
    ------
    StructureError
        For a size that does not fit, an entry that is not finite, a matrix that is not symmetric, a mass that is not
        positive, a negative diagonal of K.
    """

    stiffness: Any
    mass: Any
    damping: Any = None
    mass_damping: float = 0.0
    coordinates: Sequence[str] = ()
    loads: tuple[Load, ...] = ()
    laws: Laws | None = None
    law_texts: tuple[str, ...] = ()
    width: int = 1
    points: Array | None = None
    cells: NDArray[np.int64] | None = None
    name: str = "structure"
    title: str = ""
    _names: list[str] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        K = _sparse(self.stiffness, "stiffness")
        n = K.shape[0]
        names = _checked_names(self.coordinates, n)
        object.__setattr__(self, "_names", names)
        if not WHOLE.holds(self.width) or self.width not in (1, 2, 3) or n % self.width:
            problem = f"{shown_value(self.width)} coordinates a node do not divide {n} rows"
            raise StructureError("width", problem, "give 1, 2 or 3, with all coordinates of a node side by side")
        self._check_mesh(n // self.width)
        _check(K, "stiffness", names)
        if (where := np.flatnonzero(K.diagonal() < 0)).size:
            problem = f"the diagonal of {names[where[0]]} is {K.diagonal()[where[0]]:g}"
            raise StructureError("stiffness", problem, "K must be positive semi-definite")
        object.__setattr__(self, "stiffness", K)
        object.__setattr__(self, "mass", self._checked_mass(n, names))
        if self.damping is not None:
            D = _sparse(self.damping, "damping")
            _sized(D.shape, (n, n), "damping")
            _check(D, "damping", names)
            object.__setattr__(self, "damping", D if D.nnz else None)
        if not is_finite_number(self.mass_damping) or self.mass_damping < 0:
            raise StructureError("mass_damping", f"{shown_value(self.mass_damping)} [1/s]", "give a number from 0")

    def _check_mesh(self, nodes: int) -> None:
        """Points and cells of the pictures belong to the nodes."""
        if self.points is not None:
            points = _real(self.points, "points")
            if points.ndim != 2 or points.shape[0] != nodes or points.shape[1] not in (2, 3):
                raise StructureError("points", f"have shape {points.shape}", f"give ({nodes}, 2 or 3), a row a node")
            if not np.all(np.isfinite(points)):
                raise StructureError("points", "hold a number that is not finite", "check them")
            object.__setattr__(self, "points", points)
        if self.cells is not None:
            cells = _real(self.cells, "cells")
            if cells.ndim != 2 or cells.shape[1] < 2:
                raise StructureError("cells", f"have shape {cells.shape}", "give the nodes of each cell in a row")
            wrong = np.argwhere(~((cells >= 0) & (cells < nodes) & (cells == np.floor(cells))))
            if len(wrong):
                row, corner = wrong[0]
                problem = f"cell {row} has node {cells[row, corner]:g} of {nodes}"
                raise StructureError("cells", problem, "give whole numbers of nodes, counted from 0")
            object.__setattr__(self, "cells", cells.astype(np.int64))

    def _checked_mass(self, n: int, names: list[str]) -> Any:
        mass = self.mass if sp.issparse(self.mass) else _real(self.mass, "mass")
        if not sp.issparse(mass) and mass.ndim == 1:
            _sized(mass.shape, (n,), "mass")
            lumped = mass
        else:
            M = _sparse(mass, "mass")
            _sized(M.shape, (n, n), "mass")
            _check(M, "mass", names)
            if sp.triu(M, 1).nnz:
                return M
            lumped = M.diagonal()
        wrong = np.flatnonzero(~(np.isfinite(lumped) & (lumped > 0)))
        if wrong.size:
            k = int(wrong[0])
            problem = f"the mass of {names[k]} is {lumped[k]:g} kg"
            raise StructureError("mass", problem, "every coordinate needs a positive mass; condense those without")
        return np.ascontiguousarray(lumped)

    @property
    def names(self) -> list[str]:
        """What the coordinates are called."""
        return self._names

    @property
    def size(self) -> int:
        """n, the number of coordinates."""
        return len(self._names)

    @property
    def is_lumped(self) -> bool:
        """Is M diagonal?"""
        return not sp.issparse(self.mass)

    @cached_property
    def index(self) -> dict[str, int]:
        """The place of each coordinate."""
        return {name: k for k, name in enumerate(self._names)}

    def lumped(self, by: str = "row_sum") -> LinearStructure:
        """The same with a diagonal mass matrix of the same mass.

        by: "row_sum", exact for elements with nodes at their corners; "diagonal", the diagonal scaled, which stays
        positive for quadratic elements too (Hinton, Rock & Zienkiewicz 1976, here for the whole structure). Raises
        StructureError where a row's sum is not positive.
        """
        if self.is_lumped:
            return self
        sums = np.asarray(self.mass.sum(axis=1)).ravel()
        if by == "diagonal":
            diagonal = self.mass.diagonal().reshape(-1, self.width)
            sums = (diagonal * (sums.reshape(-1, self.width).sum(axis=0) / diagonal.sum(axis=0))).ravel()
        elif by != "row_sum":
            raise StructureError("lump", f"{by!r}", 'give "row_sum" or "diagonal"')
        return replace(self, mass=sums, coordinates=self._names)

    def with_loads(self, loads: tuple[Load, ...], texts: tuple[str, ...], laws: Laws | None) -> LinearStructure:
        """The same under other loads."""
        return replace(self, loads=loads, law_texts=texts, laws=laws, coordinates=self._names)

    def place(self, name: str) -> int:
        """The place of a coordinate; raises StructureError with the names nearest to it."""
        if name not in self.index:
            near = get_close_matches(str(name), self._names, 3)
            raise StructureError(
                f"coordinate '{name}'",
                "is not in the structure",
                f"did you mean {', '.join(near)}" if near else "see model.names",
            )
        return self.index[name]

    def force(self, t: Array) -> Array:
        """F (k, n) [N] at times t (k,) [s]."""
        values = self.law_values(t)
        found = np.zeros((len(t), self.size))
        for load in self.loads:
            found += np.outer(values[:, load.law], load.pattern)
        return found

    def law_values(self, t: Array) -> Array:
        """The time functions (k, laws) at times t (k,) [s]. Raises StructureError where one is not finite."""
        if self.laws is None:
            return np.zeros((len(t), 0))
        values = np.ascontiguousarray(self.laws(np.asarray(t, dtype=float)), dtype=float)
        wrong = np.argwhere(~np.isfinite(values))
        if len(wrong):
            row, law = wrong[0]
            text = self.law_texts[law] if law < len(self.law_texts) else f"law {law}"
            raise StructureError(f"load '{text}'", f"is {values[row, law]} at t = {t[row]:g} s", "check its argument")
        return values


def _checked_names(given: Sequence[str], n: int) -> list[str]:
    """What n coordinates are called, x0, x1, ... where nothing was given."""
    if isinstance(given, str) or not NAMES.holds(names := list(given) if np.iterable(given) else given):
        raise StructureError("coordinates", f"cannot be {shown_value(given)}", NAMES.wanted)
    names = names or [f"x{k}" for k in range(n)]
    if len(names) != n:
        raise StructureError("coordinates", f"{len(names)} names for {n} rows of K", "give one name a row")
    if len(set(names)) < n:
        twice = next(name for name in names if names.count(name) > 1)
        raise StructureError("coordinates", f"'{twice}' appears twice", "rename one of them")
    return names


def _real(numbers: Any, label: str) -> Array:
    """An array of real numbers; raises StructureError for text, objects, truth values and complex numbers."""
    try:
        found = np.asarray(numbers)
    except ValueError as error:  # rows of different lengths
        raise StructureError(label, f"cannot be read: {error}", "give an array of numbers") from error
    _require_real(found.dtype, label)
    return found.astype(float)


def _require_real(kind: np.dtype[Any], label: str) -> None:
    if kind.kind not in "iuf":
        raise StructureError(label, f"has entries of type {kind}", "give real numbers")


def _sparse(matrix: Any, label: str) -> sp.csr_matrix:
    if not sp.issparse(matrix):
        dense = _real(matrix, label)
        if dense.ndim != 2:
            raise StructureError(label, f"has shape {dense.shape}", "give a matrix, sparse or dense")
        matrix = dense
    _require_real(matrix.dtype, label)
    found = sp.csr_matrix(matrix, dtype=float)
    if found.shape[0] != found.shape[1] or not found.shape[0]:
        raise StructureError(label, f"has shape {found.shape}", "give a square matrix")
    found.sum_duplicates()
    found.eliminate_zeros()
    return found


def _sized(shape: tuple[int, ...], wanted: tuple[int, ...], label: str) -> None:
    if shape != wanted:
        raise StructureError(label, f"has shape {shape}, K needs {wanted}", "give matrices of one structure")


def _check(matrix: sp.csr_matrix, label: str, names: list[str]) -> None:
    """Finite and symmetric, or StructureError with the entry."""
    wrong = np.flatnonzero(~np.isfinite(matrix.data))
    if wrong.size:
        row = int(np.searchsorted(matrix.indptr, wrong[0], side="right") - 1)
        entry = f"{names[row]}, {names[matrix.indices[wrong[0]]]}"
        raise StructureError(label, f"entry ({entry}) is {matrix.data[wrong[0]]}", "give finite numbers")
    apart = abs(matrix - matrix.T).tocoo()
    largest = abs(matrix.data).max(initial=0.0)
    far = np.flatnonzero(apart.data > SYMMETRY_ROUNDING * largest)
    if far.size:
        k = far[np.argmax(apart.data[far])]
        entry = f"{names[apart.row[k]]}, {names[apart.col[k]]}"
        problem = f"is not symmetric: entries ({entry}) and its mirror differ by {apart.data[k]:g}"
        raise StructureError(label, problem, "give a symmetric matrix; (A + A.T) / 2 if the difference is meant")
