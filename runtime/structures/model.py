"""A structure with its simulations and studies: what `Scene.structure` of sparse matrices gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl
from numpy.typing import NDArray

from runtime.contract.arguments import (
    ANY,
    BY_NAME,
    COUNTS,
    PLACE,
    WHOLE,
    Kind,
    arguments,
)
from runtime.contract.errors import is_finite_number
from runtime.structures.regions import Regions, choose_regions, named_regions, one_group
from runtime.structures.report import StructureReport, report
from runtime.structures.run import ErrorWish, StructureRun, simulate
from runtime.structures.stability import Growth, growth
from runtime.structures.structure import Array, LinearStructure, StructureError

Scheme = Literal["printed", "single_rate", "generalized_alpha"]
ASSEMBLED_AT_MOST = 5e5  # coordinates for which modes are looked for
GROUPS = Kind(
    lambda value: BY_NAME.holds(value) and all(map(_is_group, value.values())),
    'give a dictionary from slow to fast, such as {"slow": [], "fast": ["x7", "x8"]}',
)
RATIOS = Kind(lambda value: WHOLE.holds(value) or COUNTS.holds(value), "give a whole number, or a list of them")
VALUES = Kind(
    lambda value: BY_NAME.holds(value) and all(map(_is_number, value.values())) or _is_vector(value),
    'give a dictionary, such as {"x7": 0.1}, or a number for each coordinate',
)
FUNCTION = Kind(callable, "give a function")


def _is_number(value: Any) -> bool:
    return is_finite_number(value) or isinstance(value, float)


def _is_vector(value: Any) -> bool:
    return isinstance(value, Sequence | np.ndarray) and np.asarray(value).dtype.kind in "iuf"


def _is_group(members: Any) -> bool:
    """Names, or numbers of nodes."""
    if isinstance(members, str) or not isinstance(members, Sequence | np.ndarray):
        return False
    return all(isinstance(one, str) for one in members) or all(map(WHOLE.holds, members))


class StructureModel:
    """M x'' + (a M + D) x' + K x = F(t), ready to be stepped by regions (Eqs. 3-14).

    Parameters
    ----------
    structure : LinearStructure
        Matrices, loads, names.

    Attributes
    ----------
    names : list of str
        The coordinates [m].
    structure : LinearStructure
        The data.
    """

    def __init__(self, structure: LinearStructure) -> None:
        self.structure = structure
        self._chosen: dict[Any, Regions] = {}

    @property
    def name(self) -> str:
        """Of the scene."""
        return self.structure.name

    @property
    def title(self) -> str:
        """Of the scene, or its name."""
        return self.structure.title or self.structure.name

    @property
    def names(self) -> list[str]:
        """The coordinates, in the order of the matrices."""
        return self.structure.names

    def __repr__(self) -> str:
        s = self.structure
        return f"StructureModel({self.name!r}, {s.size} coordinates, {s.stiffness.nnz} entries of K)"

    @cached_property
    def step_limit(self) -> float:
        """The longest stable step [s] of central differences with one step for all: 2 / w_max without damping."""
        return one_group(self._lumped("step_limit")).groups[0].limit

    def _lumped(self, what: str) -> LinearStructure:
        if not self.structure.is_lumped:
            remedy = 'lump it: model.lumped(); or take scheme="generalized_alpha"'
            raise StructureError(what, "explicit steps need a diagonal mass matrix", remedy)
        return self.structure

    @arguments()
    def lumped(self, by: str = "row_sum") -> StructureModel:
        """The same structure with a diagonal mass matrix: each row summed, or by="diagonal", the diagonal scaled.

        The longest step grows by up to 1.74 and M_SL vanishes. Raises StructureError where a sum is not positive.
        """
        return StructureModel(self.structure.lumped(by))

    @arguments(groups=GROUPS, m=RATIOS)
    def regions(
        self,
        groups: Mapping[str, Sequence[str] | NDArray[np.int64]] | None = None,
        m: Sequence[int] | int | None = None,
    ) -> Regions:
        """Groups of nodes that step together.

        Parameters
        ----------
        groups : mapping, optional
            Slow to fast: name to coordinates (names) or nodes (numbers); what no group names is in the first. By
            default they are found: nodes whose rows ask for shorter steps, with two rings of neighbours.
        m : int or sequence of int, optional
            Sub-steps of each next group, slow to fast. By default the cheapest by operations.

        Returns
        -------
        Regions
            Fastest group first, with the limit of each by Lanczos' method and the step that the fastest takes, 0.9
            of it.

        Raises
        ------
        StructureError
            For a name or node that is not there, a group without nodes, a ratio below 2.
        """
        structure = self._lumped("regions")
        ratios = None if m is None else [m] if isinstance(m, int) else list(m)
        for ratio in ratios or ():
            if not isinstance(ratio, int) or ratio < 2:
                raise StructureError("m", f"{ratio!r}", "give whole numbers from 2")
        if groups is None:
            key = None if ratios is None else tuple(ratios)
            if key not in self._chosen:
                self._chosen[key] = choose_regions(structure, None if ratios is None else ratios[::-1])
            return self._chosen[key]
        nodes = [self._nodes(name, members) for name, members in groups.items()]
        self._require_apart(dict(zip(groups, nodes, strict=True)))
        if len(nodes) < 2:
            raise StructureError("groups", "needs a slow and a fast group", 'such as {"slow": [], "fast": [...]}')
        return named_regions(structure, nodes[::-1], (ratios or [2] * (len(nodes) - 1))[::-1])

    def _nodes(self, group: str, members: Sequence[str] | NDArray[np.int64]) -> NDArray[np.int64]:
        count = self.structure.size // self.structure.width
        if len(members) and isinstance(members[0], str):
            return np.unique([self.structure.place(str(name)) // self.structure.width for name in members])
        nodes = np.asarray(members, dtype=np.int64)
        outside = nodes[(nodes < 0) | (nodes >= count)]
        if len(outside):
            raise StructureError(f"groups {group!r}", f"node {outside[0]} of {count}", "count nodes from 0")
        return nodes

    def _require_apart(self, groups: Mapping[str, NDArray[np.int64]]) -> None:
        """No node is named in two groups."""
        owner: dict[int, str] = {}
        for group, nodes in groups.items():
            for node in nodes.tolist():
                if owner.setdefault(node, group) != group:
                    name = self.names[node * self.structure.width]
                    raise StructureError("groups", f"{name} is in {owner[node]!r} and in {group!r}", "name it in one")

    @arguments(t_end=ANY, m=RATIOS, groups=GROUPS, initial=VALUES, rates=VALUES, progress=FUNCTION)
    def simulate(
        self,
        t_end: float,
        *,
        scheme: Scheme = "printed",
        dt: float | None = None,
        m: Sequence[int] | int | None = None,
        groups: Mapping[str, Sequence[str] | NDArray[np.int64]] | None = None,
        tolerance: float | None = None,
        initial: Mapping[str, float] | Array | None = None,
        rates: Mapping[str, float] | Array | None = None,
        outputs: Sequence[str] | None = None,
        samples: int = 1000,
        fields: int = 40,
        error: ErrorWish = "measured",
        rho_inf: float = 0.8,
        progress: Callable[[float], None] | None = None,
    ) -> StructureRun:
        """Step the structure from t = 0 to `t_end` [s].

        Parameters
        ----------
        t_end : float [s]
        scheme
            ``"printed"``: central differences by regions with slow neighbours on chords (13); ``"single_rate"``:
            one step for all; ``"generalized_alpha"``: implicit, `rho_inf` from 0 to 1.
        dt : float [s], optional
            The step of the slowest group; by default 0.9 of what is stable, t_end / 1000 for generalised-alpha. It is
            shortened so that whole steps end at `t_end`.
        m, groups
            See `regions`.
        tolerance : float, optional
            Refine all steps until the measured error is below.
        initial, rates
            Displacements [m] and rates [m/s] at the start, by name or as (n,) arrays; at rest by default.
        outputs : names, optional
            What is kept at each of the `samples` times; by default all where that is below 20 MB, else what is loaded
            and some 20 others.
        fields : int
            How many times all coordinates are kept: for pictures, and for the error.
        error
            ``"measured"`` by half the steps; ``"off"``.
        progress
            Called with the share done.

        Returns
        -------
        StructureRun
            ``run["n3.y"]`` (samples,) [m], `run.error`, `run.status`.

        Raises
        ------
        StructureError
            For an option that cannot be used; a step beyond its limit is named with the limit.

        Notes
        -----
        Equations (10)-(14) and (72) with the chord of (13), two rings of neighbours, start (68)-(71); the other
        readings of (13) grow without damping.
        """
        return simulate(
            self, t_end, scheme=scheme, dt=dt, m=m, groups=groups, tolerance=tolerance, initial=initial, rates=rates,
            outputs=outputs, samples=samples, fields=fields, error=error, rho_inf=rho_inf, progress=progress,
        )  # fmt: skip

    @arguments(m=RATIOS, groups=GROUPS)
    def stability(
        self,
        dt: float | None = None,
        *,
        m: Sequence[int] | int | None = None,
        groups: Mapping[str, Sequence[str] | NDArray[np.int64]] | None = None,
    ) -> Growth:
        """How much a major step by regions grows: dt [s] of the slowest group, m and groups as in `simulate`.

        Returns
        -------
        Growth
            The largest growth found, below what nothing was looked for, limits of the groups.
        """
        found = self.regions(groups, m)
        return growth(self.structure, found if dt is None else found.with_step(dt / found.fastest[-1]))

    @arguments(folder=PLACE, note=FUNCTION)
    def report(
        self,
        t_end: float,
        folder: str | Path | None = None,
        *,
        note: Callable[[str], None] = lambda text: None,
        **motion: Any,
    ) -> StructureReport:
        """Error against time of every method on one motion up to t_end [s]; initial and rates as in `simulate`.

        Writes methods.md, methods.csv and error_time.png where a folder is given.
        """
        return report(self, t_end, folder, note, **motion)

    @arguments()
    def modes(self, count: int = 6) -> tuple[Array, Array]:
        """The lowest frequencies w (count,) [rad/s] and shapes (n, count), M-orthonormal, by shift and invert."""
        s = self.structure
        if not 0 < count < s.size:
            raise StructureError("count", f"{count!r}", f"give a number from 1 to {s.size - 1}")
        M = sp.csc_matrix(sp.diags(s.mass) if s.is_lumped else s.mass)
        K = sp.csc_matrix(s.stiffness)
        shift = -1e-6 * float(K.diagonal().max() / M.diagonal().max())  # below zero: K may be singular
        if s.size <= 50:
            from scipy.linalg import eigh

            values, shapes = eigh(K.toarray(), M.toarray(), subset_by_index=(0, count - 1))
        else:
            values, shapes = spl.eigsh(K, count, M, sigma=shift)
        order = np.argsort(values)
        return np.sqrt(np.maximum(values[order], 0.0)), shapes[:, order]

    @arguments(force=VALUES)
    def static(self, force: Mapping[str, float] | Array) -> Array:
        """Displacements (n,) [m] under a constant force by name or (n,) [N]. Raises StructureError where K is
        singular.
        """
        F, K = self.vector("force", force), sp.csc_matrix(self.structure.stiffness)
        try:
            found = spl.splu(K).solve(F)
        except RuntimeError:  # SuperLU met a pivot of zero
            found = np.full(len(F), np.nan)
        if not np.all(np.isfinite(found)) or np.abs(K @ found - F).max() > 1e-6 * np.abs(F).max(initial=0.0):
            problem = "is singular: the structure can move as a whole"
            raise StructureError("stiffness", problem, "hold some coordinates")
        return np.asarray(found)

    def vector(self, item: str, values: Mapping[str, float] | Array | None) -> Array:
        """Numbers by name, or of all coordinates, as (n,). Raises StructureError."""
        n = self.structure.size
        if values is None:
            return np.zeros(n)
        if isinstance(values, Mapping):
            found = np.zeros(n)
            for name, value in values.items():
                found[self.structure.place(name)] = value
        else:
            found = np.array(values, dtype=float)
            if found.shape != (n,):
                raise StructureError(item, f"has shape {found.shape}", f"give {n} numbers, or a mapping of names")
        if not np.all(np.isfinite(found)):
            raise StructureError(item, "holds a number that is not finite", "check it")
        return found
