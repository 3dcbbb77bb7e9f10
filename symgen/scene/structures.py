"""A structure written as data: sparse matrices, files or a finite-element body, loads as expressions of t (Eqs.
3-5).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import casadi as ca
import numpy as np
import scipy.io
import scipy.sparse as sp
from numpy.typing import NDArray

from symgen.schema.errors import SceneError, show
from symgen.schema.expressions import parse_expression
from symgen.schema.texts import refused_character

if TYPE_CHECKING:
    from runtime.structures import StructureModel
    from runtime.structures.structure import Load
    from symgen.fe import FEStructure, FlexibleBody

Array: TypeAlias = NDArray[np.float64]
MatrixData: TypeAlias = "sp.spmatrix | sp.sparray | NDArray[np.float64] | str | Path"
AXES = "xyz"


class StructureScene:
    """A structure given as data, with its start: `model()` makes it ready to be stepped by regions.

    Made by ``Scene.structure`` of sparse matrices.
    """

    def __init__(self, name: str, title: str, parameters: Mapping[str, float], fields: Mapping[str, Any]) -> None:
        self.name, self._title, self._parameters = name, title, dict(parameters)
        self._fields = {key: value for key, value in fields.items() if value is not None}
        known = (
            "mass",
            "stiffness",
            "damping",
            "force",
            "coordinates",
            "width",
            "points",
            "cells",
            "body",
            "fixed",
            "lump",
        )
        for key in self._fields:
            if key not in known:
                raise SceneError(f"structure.{key}", "is not known", f"give some of {', '.join(known)}")
        _require_line("name", name)
        _require_line("title", title)
        named = self._fields.get("coordinates", ())
        for number, one in enumerate(named if isinstance(named, Sequence) and not isinstance(named, str) else ()):
            _require_line(f"structure.coordinates[{number}]", one)

    def model(self) -> StructureModel:
        """The structure, ready to be simulated.

        Returns
        -------
        StructureModel

        Raises
        ------
        SceneError
            For a file or expression that cannot be read.
        StructureError
            For matrices that no structure has: the entry is named.
        """
        from runtime.structures import LinearStructure, StructureModel

        data = dict(self._fields)
        lump = data.pop("lump", False)
        body, fixed = data.pop("body", None), data.pop("fixed", ())
        if isinstance(fixed, str) or not isinstance(fixed, Sequence | np.ndarray):
            raise SceneError(
                "structure.fixed", f"cannot be {show(fixed)}", "give a list of interfaces and ids of nodes"
            )
        if body is None and len(fixed):
            raise SceneError("structure.fixed", "belongs to a body", "leave out the rows that are held, or give a body")
        if body is not None:
            data = {**_of_body(body, fixed), **data}
        for needed in ("mass", "stiffness"):
            if needed not in data:
                raise SceneError(f"structure.{needed}", "is missing", "give matrices, or a body of symgen.fe")
        mass_damping, damping = _damping(
            data.pop("damping", None), stiffness := _matrix(data["stiffness"], "stiffness")
        )
        structure = LinearStructure(
            stiffness, _matrix(data["mass"], "mass"), damping, mass_damping, data.get("coordinates", ()),
            width=data.get("width", 1), points=data.get("points"), cells=data.get("cells"), name=self.name,
            title=self._title,
        )  # fmt: skip
        loads, texts, laws = self._loads(data.get("force"), structure.names)
        if not isinstance(lump, bool | str):
            raise SceneError("structure.lump", f"cannot be {show(lump)}", 'give True, "row_sum" or "diagonal"')
        if lump and not structure.is_lumped:
            structure = structure.lumped("diagonal" if lump is True else lump)
        return StructureModel(structure.with_loads(loads, texts, laws))

    def _loads(self, force: Any, names: Sequence[str]) -> tuple[tuple[Load, ...], tuple[str, ...], Any]:
        """Patterns and time functions of ``force``: by name, one for each coordinate, or (pattern, expression)
        pairs.
        """
        from runtime.structures.structure import Load

        if force is None:
            return (), (), None
        by_text: dict[str, Array] = {}
        for where, pattern, text in _entries(force, names):
            if not isinstance(text, str | int | float):
                raise SceneError(
                    f"structure.force {where}", f"{show(text)} is not an expression of t", "give a number or text"
                )
            by_text[str(text)] = by_text.get(str(text), np.zeros(len(names))) + pattern
        t = ca.SX.sym("t")
        allowed = frozenset(("t", *self._parameters))
        expressions = [parse_expression(_number(text), allowed, f"structure.force '{text}'") for text in by_text]
        values = [expression.to_casadi({"t": t, **self._parameters}) for expression in expressions]
        function = ca.Function("laws", [t], [ca.horzcat(*values)])

        def laws(times: Array) -> Array:
            return np.asarray(function.map(len(times))(times[None, :])).reshape(len(values), len(times), order="F").T

        loads = tuple(Load(pattern, number) for number, pattern in enumerate(by_text.values()))
        return loads, tuple(by_text), laws


def _require_line(item: str, text: Any) -> None:
    """Raises SceneError for what is no text of one line: it stands in pictures, reports and files."""
    if not isinstance(text, str):
        raise SceneError(item, f"cannot be {show(text)}", "give text")
    if found := refused_character(text):
        raise SceneError(item, *found)


def _number(text: str) -> str | float:
    try:
        return float(text)
    except ValueError:
        return text


def _entries(force: Any, names: Sequence[str]) -> list[tuple[str, Array, Any]]:
    index = {name: k for k, name in enumerate(names)}
    n = len(names)
    if isinstance(force, Mapping):
        found = []
        for name, text in force.items():
            if name not in index:
                raise SceneError(
                    f"structure.force {show(name)}", "is not a coordinate of the structure", "see the names"
                )
            found.append((str(name), np.eye(1, n, index[name])[0], text))
        return found
    if isinstance(force, str) or not isinstance(force, Sequence | np.ndarray):
        raise SceneError(
            "structure.force", f"{show(force)} is not known", "give a mapping of coordinates to expressions"
        )
    if len(force) and isinstance(force[0], tuple) and len(force[0]) == 2:
        found = []
        for number, (pattern, text) in enumerate(force):
            try:
                shape = np.asarray(pattern, dtype=float)
            except (TypeError, ValueError) as error:
                raise SceneError(
                    f"structure.force[{number}]", f"the pattern is {show(pattern)}", f"give {n} numbers"
                ) from error
            if shape.shape != (n,) or not np.all(np.isfinite(shape)):
                raise SceneError(
                    f"structure.force[{number}]", f"the pattern has shape {shape.shape}", f"give {n} numbers"
                )
            found.append((f"[{number}]", shape, text))
        return found
    if len(force) != n:
        raise SceneError(
            "structure.force", f"has {len(force)} entries for {n} coordinates", "give one each, or a mapping"
        )
    return [(name, np.eye(1, n, k)[0], text) for k, (name, text) in enumerate(zip(names, force, strict=True)) if text]


def _matrix(source: Any, item: str) -> Any:
    """A matrix that was given, or is in a file."""
    if not isinstance(source, str | Path):
        return source
    try:
        return scipy.io.mmread(source)
    except (OSError, ValueError, OverflowError) as error:
        raise SceneError(
            f"structure.{item}", f"{source} cannot be read: {error}", "give a MatrixMarket file"
        ) from error


def _damping(given: Any, stiffness: Any) -> tuple[float, Any]:
    """a of a M, and D; {"mass": a [1/s], "stiffness": b [s]} are Rayleigh's."""
    if not isinstance(given, Mapping):
        return 0.0, None if given is None else _matrix(given, "damping")
    for key, value in given.items():
        if key not in ("mass", "stiffness") or not isinstance(value, int | float) or not value >= 0:
            raise SceneError(
                f"structure.damping.{key}", show(value), 'give numbers from 0 for "mass" [1/s] and "stiffness" [s]'
            )
    b = float(given.get("stiffness", 0.0))
    return float(given.get("mass", 0.0)), b * sp.csr_matrix(stiffness) if b else None


def _of_body(given: FlexibleBody | FEStructure, fixed: Sequence[str | int] | NDArray[np.int64]) -> dict[str, Any]:
    """Matrices and names of a solid body of symgen.fe without the nodes that are held: interfaces and ids."""
    body: Any = getattr(given, "structure", given)
    interfaces = getattr(given, "interfaces", {})
    if not all(hasattr(body, name) for name in ("K", "M", "ids", "positions", "component")):
        raise SceneError("structure.body", f"{show(given)} is not a finite-element body", "give one of symgen.fe")
    if body.component.max(initial=0) >= len(AXES):
        raise SceneError("structure.body", "has rotations", "give bodies of solid elements, or matrices")
    place = {int(node): k for k, node in enumerate(body.ids)}
    held = np.zeros(len(body.ids), dtype=bool)
    for one in fixed:
        if isinstance(one, str) and one in interfaces:
            held[interfaces[one].places] = True
        elif isinstance(one, int | np.integer) and int(one) in place:
            held[place[int(one)]] = True
        else:
            remedy = f"give ids of nodes, or some of {', '.join(interfaces) or 'no interfaces'}"
            raise SceneError("structure.fixed", f"{show(one)} is not in the body", remedy)
    rows = body.rows[~held][:, : len(AXES)].ravel()
    names = [f"n{node}.{axis}" for node in body.ids[~held] for axis in AXES]
    free = np.full(len(body.ids), -1)
    free[~held] = np.arange((~held).sum())
    facets = free[body.facets] if len(body.facets) else np.zeros((0, 3), dtype=np.int64)
    return {
        "stiffness": body.K[rows][:, rows], "mass": body.M[rows][:, rows], "coordinates": names, "width": len(AXES),
        "points": body.positions[~held], "cells": facets[(facets >= 0).all(axis=1)] if len(facets) else None,
    }  # fmt: skip
