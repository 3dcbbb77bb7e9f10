"""The parameter vector p: every physical number of a scene is a run-time input; only its zeros are baked.

Three kinds share one vector: parameters the scene declares, numbers written in the scene (they get a name such
as `crank.mass`), and data computed from a mesh (`beam/...`). A number that is exactly zero stays a zero.

The sign that a number must have belongs to its use: a declared parameter that is taken for a mass must be positive,
and an expression that is taken for one must keep a positive value whatever its parameters become.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Protocol

import casadi as ca
import numpy as np

from runtime.contract.records import Bound, BoundedQuantity, Parameter
from symgen.schema.fields import Meaning

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord

STRICTNESS: tuple[Bound, ...] = ("any", "not negative", "positive")


class Part(Protocol):
    """A named part of a scene that says what its quantities mean."""

    @property
    def name(self) -> str:
        """Unique among its kind."""

    def meaning(self, key: str) -> Meaning:
        """Of one of its quantities."""


class ParameterTable:
    """Collects the entries of p while the scene's bodies, joints and loads are instantiated."""

    def __init__(self, scene: SceneRecord) -> None:
        self._scene = scene
        self._entries: dict[str, Parameter] = {}
        self._symbols: dict[str, ca.SX] = {}
        self._data: dict[str, ca.SX] = {}
        self._bounded: dict[str, tuple[BoundedQuantity, ca.SX]] = {}
        for name, parameter in scene.fixed_parameters().items():
            self._add(Parameter(name, parameter.unit, parameter.description, "declared", parameter.default))

    @property
    def entries(self) -> list[Parameter]:
        """The entries of p, in order."""
        return list(self._entries.values())

    @property
    def bounded(self) -> list[tuple[BoundedQuantity, ca.SX]]:
        """Expressions that must keep a sign, with their SX."""
        return list(self._bounded.values())

    def _add(self, entry: Parameter) -> ca.SX:
        symbol = ca.SX.sym(entry.name)
        self._entries[entry.name] = entry
        self._symbols[entry.name] = symbol
        return symbol

    def quantity(
        self, value: float | str, name: str, unit: str, meaning: str = "", bound: Bound = "any", array: str = ""
    ) -> ca.SX:
        """SX of a scene quantity: 0 for zero, a new entry of p for a number, the expression for a text.

        array: the array that the number is an entry of.
        """
        if isinstance(value, str):
            result = self._scene.expression(value, name).to_casadi(self.environment())
            self._bind(value, name, bound, result)
            return result
        if value == 0:
            return ca.SX(0)
        if name in self._symbols:
            return self._symbols[name]
        return self._add(Parameter(name, unit, meaning, "scene", float(value), bound, array))

    def of(self, part: Part, key: str) -> ca.SX:
        """SX of the quantity `key` of a body, joint or load, with the unit, meaning and bound of its field."""
        meaning = part.meaning(key)
        value, name = getattr(part, key), f"{part.name}.{key}"
        return self.quantity(value, name, meaning.unit, meaning.description, meaning.bound.value)

    def _bind(self, text: str, item: str, bound: Bound, value: ca.SX) -> None:
        """Remember what sign an expression must have: on the parameter itself where it is nothing else."""
        if bound == "any" or not ca.symvar(value):
            return
        parameter = self._entries.get(text.strip())
        if parameter is None:
            self._bounded[item] = BoundedQuantity(item, text, bound), value
        elif STRICTNESS.index(bound) > STRICTNESS.index(parameter.bound):
            self._entries[parameter.name] = replace(parameter, bound=bound)

    def require(self, item: str, text: str, value: ca.SX) -> None:
        """A value that follows from quantities must not be negative, whatever its parameters become."""
        if ca.symvar(value):
            self._bounded[item] = BoundedQuantity(item, text, "not negative"), value

    def data(self, array: np.ndarray, name: str, unit: str, meaning: str) -> ca.SX:
        """SX matrix of computed data (a mesh's shape integrals, dimensionless or SI): zeros baked."""
        table = np.atleast_2d(np.asarray(array, dtype=float))
        known = self._data.get(name)
        if known is not None:
            return known
        result = ca.SX(*table.shape)
        for row, column in zip(*np.nonzero(table), strict=True):
            entry = f"{name}[{row},{column}]"
            value = float(table[row, column])
            result[int(row), int(column)] = self._add(Parameter(entry, unit, meaning, "data", value, array=name))
        self._data[name] = result
        return result

    def environment(self) -> Mapping[str, Any]:
        """Declared parameters by name, and tables as functions, for expressions in the scene."""
        tables = {name: table.symbol for name, table in self._scene.table_names().items()}
        return {**{name: self._symbols[name] for name in self._scene.fixed_parameters()}, **tables}

    def vector(self) -> ca.SX:
        """p as one SX column."""
        return ca.vertcat(*self._symbols.values())
