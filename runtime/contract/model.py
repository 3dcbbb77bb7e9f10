"""A model in memory: names, partition, parameters, and its CasADi Functions (built on demand)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.errors import SymgenError

# parameters whose sign is part of their meaning, by the last part of their name
POSITIVE = frozenset(("mass", "length", "density", "area", "youngs_modulus", "second_moment"))
NOT_NEGATIVE = frozenset(("inertia", "stiffness", "damping", "damping_ratio", "free_length"))


class ModelError(SymgenError, ValueError):
    """A generated model that cannot be used: missing, edited, stale, or asked for something it does not have."""


@dataclass(frozen=True)
class Group:
    """A group of the partition (Eqs. 39, 72): its name and positions in q_i. Groups run from slow to fast."""

    name: str
    positions: list[int]


@dataclass(frozen=True)
class Parameter:
    """One entry of p: name, SI unit, meaning, kind (declared, scene, data) and default value."""

    name: str
    unit: str
    description: str
    kind: str
    default: float


@dataclass(frozen=True, repr=False)
class Model:
    """The equations of one scene. `builders` maps a function name to what builds it from the emitted code.

    redundant: constraint rows that the others imply; nothing is solved from them, their multipliers are a choice.
    initial_changes: {coordinate or rate: (given, used)} where the scene's initial state had to be corrected.
    digest: SHA-256 of the manifest; scene_toml: the scene that the model was generated from; "" if not known.
    drawing: what the columns of the functions `poses` and `geometry` belong to, joints and loads with their markers.
    Kernels take the run's constants c = constants(p); `function(name)` gives the same function of p.
    """

    name: str
    title: str
    coordinates: list[str]
    elastic: list[str]
    q_i: list[str]
    q_d: list[str]
    loop_unknowns: list[str]
    groups: list[Group]
    constraints: list[str]
    joints: list[str]
    measures: list[str]
    parameters: list[Parameter]
    initial_q: np.ndarray
    initial_q_dot: np.ndarray
    builders: Mapping[str, Callable[[], ca.Function]]
    simulation: Mapping[str, Any] = field(default_factory=dict)
    operations: Mapping[str, int] = field(default_factory=dict)
    initial_changes: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    digest: str = ""
    scene_toml: str = ""
    redundant: list[str] = field(default_factory=list)
    drawing: Mapping[str, Any] = field(default_factory=dict)
    _kernels: dict[str, ca.Function] = field(default_factory=dict, repr=False)
    _derived: dict[str, ca.Function] = field(default_factory=dict, repr=False)

    def __repr__(self) -> str:
        return (
            f"<Model {self.name}: {len(self.coordinates)} coordinates, {len(self.q_i)} independent, "
            f"{len(self.constraints)} constraints>"
        )

    def kernel(self, name: str) -> ca.Function:
        """The emitted Function `name`, with c as its last argument. Raises ModelError if it was not generated."""
        if name not in self._kernels:
            if name not in self.builders:
                raise ModelError(
                    f"model {self.name} has no function {name!r}; it has {', '.join(self.builders)}. "
                    "Regenerate the scene with that function"
                )
            self._kernels[name] = self.builders[name]()
        return self._kernels[name]

    def derived(self, name: str, build: Callable[[], ca.Function]) -> ca.Function:
        """A Function made of the emitted ones, built once for a model."""
        if name not in self._derived:
            self._derived[name] = build()
        return self._derived[name]

    def has(self, name: str) -> bool:
        """Was the function generated? (A tree has no closure iterations, a scene without measures no measures.)"""
        return name in self.builders

    def function(self, name: str) -> ca.Function:
        """The Function `name` of the parameters p instead of c, for use in other CasADi expressions."""
        kernel, constants = self.kernel(name), self.kernel("constants")
        names = [argument for argument in kernel.name_in() if argument != "c"]
        inputs = {argument: ca.SX.sym(argument, *kernel.size_in(argument)) for argument in names}
        p = ca.SX.sym("p", len(self.parameters))
        call: dict[str, Any] = dict(inputs)
        if "c" in kernel.name_in():
            call["c"] = constants(p)
        outputs = kernel(**call)
        return ca.Function(
            name, [*inputs.values(), p], [outputs[key] for key in kernel.name_out()], [*names, "p"], kernel.name_out()
        )

    def structurally_zero(self, name: str, output: str) -> bool:
        """Is an output of a kernel zero whatever its arguments are?"""
        kernel = self.kernel(name)
        arguments = [ca.SX.sym(argument, *kernel.size_in(argument)) for argument in kernel.name_in()]
        values = kernel.call(arguments)
        return bool(ca.SX(values[kernel.name_out().index(output)]).is_zero())

    @cached_property
    def c_size(self) -> int:
        """Length of c."""
        return int(self.kernel("constants").size1_out(0))

    @cached_property
    def independent_columns(self) -> np.ndarray:
        """Columns of q_i in q."""
        return np.array([self.coordinates.index(name) for name in self.q_i], dtype=int)

    @cached_property
    def loop_columns(self) -> np.ndarray:
        """Columns of the loop unknowns in q."""
        return np.array([self.coordinates.index(name) for name in self.loop_unknowns], dtype=int)

    @cached_property
    def dependent_columns(self) -> np.ndarray:
        """Columns of q_d in q."""
        return np.array([self.coordinates.index(name) for name in self.q_d], dtype=int)

    @cached_property
    def redundant_rows(self) -> np.ndarray:
        """Positions of the redundant rows in the constraints."""
        return np.array([self.constraints.index(label) for label in self.redundant], dtype=int)

    @cached_property
    def kept_rows(self) -> np.ndarray:
        """Positions of the constraint rows that are not redundant."""
        return np.setdiff1d(np.arange(len(self.constraints)), self.redundant_rows)

    def parameter_vector(self, changes: Mapping[str, float] | None = None) -> np.ndarray:
        """p with some entries changed by name. Raises ModelError for a name the model does not have."""
        p = np.array([parameter.default for parameter in self.parameters])
        index = {parameter.name: k for k, parameter in enumerate(self.parameters)}
        for name, value in (changes or {}).items():
            if name not in index:
                known = ", ".join(q.name for q in self.parameters if q.kind != "data")
                raise ModelError(f"model {self.name} has no parameter {name!r}; it has {known}")
            p[index[name]] = _checked_value(name, value)
        return p

    def constants(self, p: np.ndarray) -> np.ndarray:
        """c for a parameter vector p. Raises ModelError if a parameter makes one of them infinite or NaN."""
        c = np.asarray(self.kernel("constants")(p)).ravel()
        if not np.all(np.isfinite(c)):
            raise ModelError(f"model {self.name}: a parameter makes the constants infinite (division by zero?)")
        return c


def _checked_value(name: str, value: float) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float | np.number) or not np.isfinite(value):
        raise ModelError(f"parameter {name!r} must be a finite number, not {value!r}")
    kind = name.rpartition(".")[2] if "." in name else ""
    if (kind in POSITIVE and value <= 0) or (kind in NOT_NEGATIVE and value < 0):
        wanted = "positive" if kind in POSITIVE else "at least zero"
        raise ModelError(f"parameter {name!r} must be {wanted}, not {value}")
    return float(value)
