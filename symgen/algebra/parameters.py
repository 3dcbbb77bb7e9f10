"""The parameter vector p: every physical number of a scene is a run-time input; only its zeros are baked.

Three kinds share one vector: parameters the scene declares, numbers written in the scene (they get a name such
as `crank.mass`), and data computed from a mesh (`beam/...`). A number that is exactly zero stays a zero.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, Protocol

import casadi as ca
import numpy as np

Kind = Literal["declared", "scene", "data"]


@dataclass(frozen=True)
class ParameterEntry:
    """One entry of p: name, default value, SI unit, what it is and where it comes from."""

    name: str
    default: float
    unit: str
    description: str
    kind: Kind


class Declaration(Protocol):
    """A declared parameter: default value in its SI unit, and what it is."""

    @property
    def default(self) -> float:
        """Value where nothing else is said."""

    @property
    def unit(self) -> str:
        """SI unit."""

    @property
    def description(self) -> str:
        """What it is."""


class Readable(Protocol):
    """An expression that has been read."""

    def to_casadi(self, environment: Mapping[str, ca.SX]) -> ca.SX:
        """Its value for values of the names in it."""


class Declarations(Protocol):
    """What the table asks of a scene: the declared parameters, and how a text that uses them is read."""

    @property
    def parameters(self) -> Mapping[str, Declaration]:
        """By name."""

    def expression(self, text: str, item: str) -> Readable:
        """The expression in a text; `item` names it in errors."""


class ParameterTable:
    """Collects the entries of p while the scene's bodies, joints and loads are instantiated."""

    def __init__(self, declarations: Declarations) -> None:
        self._declarations = declarations
        self.entries: list[ParameterEntry] = []
        self._symbols: dict[str, ca.SX] = {}
        self._data: dict[str, ca.SX] = {}
        for name, parameter in declarations.parameters.items():
            self._add(ParameterEntry(name, parameter.default, parameter.unit, parameter.description, "declared"))

    def _add(self, entry: ParameterEntry) -> ca.SX:
        symbol = ca.SX.sym(entry.name)
        self.entries.append(entry)
        self._symbols[entry.name] = symbol
        return symbol

    def quantity(self, value: float | str, name: str, unit: str, description: str = "") -> ca.SX:
        """SX of a scene quantity: 0 for zero, a new entry of p for a number, the expression for a text."""
        if isinstance(value, str):
            return self._declarations.expression(value, name).to_casadi(self.environment())
        if value == 0:
            return ca.SX(0)
        if name in self._symbols:
            return self._symbols[name]
        return self._add(ParameterEntry(name, float(value), unit, description, "scene"))

    def data(self, array: np.ndarray, name: str, unit: str, description: str) -> ca.SX:
        """SX matrix of computed data (a mesh's shape integrals, dimensionless or SI): zeros baked."""
        table = np.atleast_2d(np.asarray(array, dtype=float))
        known = self._data.get(name)
        if known is not None:
            return known
        result = ca.SX(*table.shape)
        for row, column in zip(*np.nonzero(table), strict=True):
            entry = f"{name}[{row},{column}]"
            value = float(table[row, column])
            result[int(row), int(column)] = self._add(ParameterEntry(entry, value, unit, description, "data"))
        self._data[name] = result
        return result

    def environment(self) -> Mapping[str, ca.SX]:
        """Declared parameters by name, for expressions in the scene."""
        return {name: self._symbols[name] for name in self._declarations.parameters}

    def vector(self) -> ca.SX:
        """p as one SX column."""
        return ca.vertcat(*(self._symbols[entry.name] for entry in self.entries))
