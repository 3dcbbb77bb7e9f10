"""Central differences by regions, `printed` with the chord (Eqs. 10-14, 40-71 for M x'' + D x' + K x = F): the
state, its start, its steps.

The steps themselves are central_difference.c, compiled for this machine without a compiler at the user's
(native_text.py).
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import scipy.sparse as sp

from runtime.engine.native_text import load
from runtime.structures.regions import Regions, coordinates_of
from runtime.structures.structure import Array, LinearStructure, StructureError

TEXT = Path(__file__).with_name("central_difference.ll")
SLICE = 512  # steps of the slowest group for which laws are evaluated at once

_INT, _REAL, _AT = ctypes.c_int64, ctypes.c_double, ctypes.c_void_p


class _Group(ctypes.Structure):
    """`Group` of central_difference.c."""

    _fields_ = [
        ("first", _INT), ("last", _INT), ("sub_steps", _INT), ("fastest", _INT), ("rate", _REAL),
        ("row", _AT), ("column", _AT), ("block", _AT),
        ("damper_row", _AT), ("damper_column", _AT), ("damper_block", _AT),
        ("gain", _AT), ("keep", _AT), ("seen", _INT), ("seen_block", _AT),
        ("loads", _INT), ("at", _AT), ("law", _AT), ("factor", _AT), ("laws", _AT),
    ]  # fmt: skip


class _Run(ctypes.Structure):
    """`Run` of central_difference.c."""

    _fields_ = [
        ("group", _AT), ("groups", _INT), ("width", _INT), ("laws", _INT),
        ("x", _AT), ("base", _AT), ("d", _AT), ("last", _AT), ("v", _AT), ("force", _AT),
        ("count", _AT), ("elapsed", _AT),
    ]  # fmt: skip


class CentralDifference:
    """Steps of a structure by regions.

    Parameters
    ----------
    structure
        With lumped mass.
    regions
        Groups of nodes and the step of the fastest.

    Raises
    ------
    StructureError
        Where the mass is not lumped.

    Notes
    -----
    State: x at t and increments d = h x'(t - h/2) of each coordinate's own step h, in the order of the groups. Second
    order in the steps; slow coordinates that fast rows read move along chords (13).

    References
    ----------
    .. [1] Miao, J., Zhu, P., Shi, G., Chen, G., Study on sub-cycling algorithm for flexible multi-body system:
       integral theory and implementation flow chart, Comput. Mech. 41 (2008) 257-268,
       doi:10.1007/s00466-007-0183-9.
    .. [2] Belytschko, T., Yen, H.-J., Mullen, R., Mixed methods for time integration, Comput. Methods Appl. Mech.
       Engrg. 17-18 (1979) 259-275.
    .. [3] Daniel, W. J. T., A study of the stability of subcycling algorithms in structural dynamics, Comput.
       Methods Appl. Mech. Engrg. 156 (1998) 1-13.
    """

    def __init__(self, structure: LinearStructure, regions: Regions) -> None:
        if not structure.is_lumped:
            raise StructureError(
                "mass", "is not diagonal", 'lump it (structure.lumped()), or take scheme "generalized_alpha"'
            )
        self.structure, self.regions, self.t = structure, regions, 0.0
        width = structure.width
        self.order = coordinates_of(np.concatenate([group.nodes for group in regions.groups]), width)
        n = structure.size
        self.steps = np.empty(n)  # [s], in the order of the groups
        self._x, self._d = np.zeros(n), np.zeros(n)
        self._count = np.zeros(len(regions.groups), dtype=np.int64)
        self._keep: list[Any] = []
        K = sp.csr_matrix(structure.stiffness[self.order][:, self.order])
        D = None if structure.damping is None else sp.csr_matrix(structure.damping[self.order][:, self.order])
        self._K, self._D = K, D
        self._mass = np.asarray(structure.mass)[self.order]
        self._groups = (_Group * len(regions.groups))(*self._described(K, D))
        scratch = [np.zeros(n) for _ in range(4)]
        self._last, self._v = scratch[1], scratch[2]
        elapsed = np.zeros(len(regions.groups), dtype=np.int64)
        base, last, v, force = map(self._at, scratch)
        laws = len(structure.law_texts) or (1 + max((load.law for load in structure.loads), default=-1))
        self._laws = laws
        self._run = _Run(
            ctypes.addressof(self._groups), len(regions.groups), width, laws,
            self._at(self._x), base, self._at(self._d), last, v, force, self._at(self._count), self._at(elapsed),
        )  # fmt: skip
        self._engine = load(TEXT)
        call: Callable[..., None] = ctypes.CFUNCTYPE(None, _AT, _INT)(self._engine.get_function_address("advance"))
        self._advance = call

    def _at(self, array: Any) -> int:
        self._keep.append(array)
        return int(array.ctypes.data)

    def _described(self, K: sp.csr_matrix, D: sp.csr_matrix | None) -> list[_Group]:
        structure, regions, width = self.structure, self.regions, self.structure.width
        gain, keep = np.empty(structure.size), np.empty(structure.size)
        bounds = np.cumsum([0, *(len(group.nodes) for group in regions.groups)])
        found = []
        for g, (group, fastest, h) in enumerate(zip(regions.groups, regions.fastest, regions.steps, strict=True)):
            first, last = int(bounds[g]), int(bounds[g + 1])
            rows = slice(first * width, last * width)
            self.steps[rows] = h
            implicit = 1 + structure.mass_damping * h / 2
            gain[rows], keep[rows] = h * h / (self._mass[rows] * implicit), (2 - implicit) / implicit
            read = K[: first * width, rows]
            if D is not None:
                read = abs(read) + abs(D[: first * width, rows])
            seen = np.unique(read.nonzero()[1] // width).astype(np.int32) + np.int32(first)
            at, law, factor = self._loads(rows)
            dampers = (None, None, None) if D is None else self._blocks(D[rows])
            found.append(
                _Group(
                    first,
                    last,
                    group.sub_steps,
                    fastest,
                    1 / h,
                    *self._blocks(K[rows]),
                    *dampers,
                    self._at(gain),
                    self._at(keep),
                    len(seen),
                    self._at(seen),
                    len(at),
                    self._at(at),
                    self._at(law),
                    self._at(factor),
                    None,
                )  # fmt: skip
            )
        return found

    def _loads(self, rows: slice) -> tuple[Any, Any, Array]:
        """Coordinate, law and factor of each entry of F in these rows."""
        entries = [(load.pattern[self.order], load.law) for load in self.structure.loads]
        where = [rows.start + np.flatnonzero(pattern[rows]) for pattern, _ in entries]
        at = np.concatenate([np.zeros(0), *where]).astype(np.int32)
        law = np.concatenate([np.zeros(0), *(np.full(len(own), k) for own, (_, k) in zip(where, entries, strict=True))])
        factor = [pattern[own] for own, (pattern, _) in zip(where, entries, strict=True)]
        return at, law.astype(np.int32), np.concatenate([np.zeros(0), *factor])

    def _blocks(self, rows: sp.csr_matrix) -> tuple[int, int, int]:
        """Addresses of the rows as square blocks, each stored by columns."""
        width = self.structure.width
        blocks = sp.bsr_matrix(rows, blocksize=(width, width))
        blocks.sort_indices()
        data = np.ascontiguousarray(blocks.data.transpose(0, 2, 1))
        return self._at(blocks.indptr.astype(np.int32)), self._at(blocks.indices.astype(np.int32)), self._at(data)

    @property
    def major_step(self) -> float:
        """The step of the slowest group [s]."""
        return self.regions.steps[-1]

    @property
    def x(self) -> Array:
        """Displacements (n,) [m], in the order of the structure."""
        return self._back(self._x)

    @property
    def rates(self) -> Array:
        """x' (n,) [m/s] at t, of second order: d / h + h x'' / 2."""
        force = (
            self._force(self.t) - self._K @ self._x - self.structure.mass_damping * self._mass * self._d / self.steps
        )
        if self._D is not None:
            force -= self._D @ (self._d / self.steps)
        return self._back(self._d / self.steps + self.steps / 2 * force / self._mass)

    def near(self, t: float) -> Array:
        """x (n,) [m] at a time within half a step, to second order in the distance: through the last, this and next
        step.
        """
        rates, away = self.rates, t - self.t
        steps = self._back(self.steps)
        return self.x + away * rates + away**2 * (rates - self._back(self._d) / steps) / steps

    def _back(self, values: Array) -> Array:
        found = np.empty_like(values)
        found[self.order] = values
        return found

    def _force(self, t: float) -> Array:
        return np.asarray(self.structure.force(np.array([t]))[0][self.order])

    def start(self, x: Array, rates: Array, t: float = 0.0) -> None:
        """Begin at x (n,) [m] with rates (n,) [m/s] at t [s]: the increments of the step before (68)-(71)."""
        x, v, h = np.asarray(x)[self.order], np.asarray(rates)[self.order], self.steps
        damper = self.structure.mass_damping * self._mass * v + (0 if self._D is None else self._D @ v)
        a = (self._force(t) - self._K @ x - damper) / self._mass
        self.t, self._x[:], self._d[:] = t, x, h * v - h * h / 2 * a
        self._last[:] = self._d - h * h * a

    def advance(self, steps: int) -> None:
        """So many steps of the slowest group."""
        while steps > 0:
            count = min(steps, SLICE)
            held = []  # alive while the steps read them
            for description, h in zip(self._groups, self.regions.steps, strict=True):
                times = self.t + h * np.arange(count * round(self.major_step / h))
                held.append(self.structure.law_values(np.asarray(times, dtype=np.float64)))
                description.laws = held[-1].ctypes.data
            self._advance(ctypes.addressof(self._run), count)
            self.t += count * self.major_step
            steps -= count

    def energy(self) -> tuple[float, float]:
        """Kinetic and elastic energy [J] at t."""
        v = self.rates[self.order]
        return float((self._mass * v * v).sum() / 2), float(self._x @ (self._K @ self._x) / 2)

    def state(self) -> Array:
        """(x, d and, with dampers, the increments before): what a step maps, for studies of its stability."""
        return np.concatenate([self._x, self._d] + ([] if self._D is None else [self._last]))

    def set_state(self, state: Array) -> None:
        """The inverse of `state`."""
        parts = np.split(np.asarray(state, dtype=float).ravel(), 2 if self._D is None else 3)
        self._x[:], self._d[:] = parts[0], parts[1]
        if self._D is not None:
            self._last[:] = parts[2]
