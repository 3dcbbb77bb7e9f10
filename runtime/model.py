"""A generated model in memory: names, partition, parameters, and its CasADi Functions (built on demand)."""

from __future__ import annotations

import hashlib
import importlib.util
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any

import casadi as ca
import numpy as np

FORMAT = 1


class ModelError(ValueError):
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


@dataclass(frozen=True)
class Model:
    """The equations of one scene. `builders` maps a function name to what builds it from the emitted code.

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
    outlines: list[tuple[str, int]]
    parameters: list[Parameter]
    initial_q: np.ndarray
    initial_q_dot: np.ndarray
    builders: Mapping[str, Callable[[], ca.Function]]
    simulation: Mapping[str, Any] = field(default_factory=dict)
    operations: Mapping[str, int] = field(default_factory=dict)
    _kernels: dict[str, ca.Function] = field(default_factory=dict, repr=False)

    def kernel(self, name: str) -> ca.Function:
        """The emitted Function `name`, with c as its last argument. Raises ModelError if it was not generated."""
        if name not in self._kernels:
            if name not in self.builders:
                raise ModelError(f"model {self.name} has no function {name!r}; it has {', '.join(self.builders)}. "
                                 "Regenerate the scene with that function")
            self._kernels[name] = self.builders[name]()
        return self._kernels[name]

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
        return ca.Function(name, [*inputs.values(), p], [outputs[key] for key in kernel.name_out()],
                           [*names, "p"], kernel.name_out())

    def structurally_zero(self, name: str, output: str) -> bool:
        """Is an output of a kernel zero whatever its arguments are?"""
        kernel = self.kernel(name)
        arguments = [ca.SX.sym(argument, *kernel.size_in(argument)) for argument in kernel.name_in()]
        values = kernel.call(arguments)
        return bool(ca.SX(values[kernel.name_out().index(output)]).is_zero())

    @cached_property
    def independent_columns(self) -> np.ndarray:
        """Columns of q_i in q."""
        return np.array([self.coordinates.index(name) for name in self.q_i], dtype=int)

    @cached_property
    def dependent_columns(self) -> np.ndarray:
        """Columns of q_d in q."""
        return np.array([self.coordinates.index(name) for name in self.q_d], dtype=int)

    def parameter_vector(self, changes: Mapping[str, float] | None = None) -> np.ndarray:
        """p with some entries changed by name. Raises ModelError for a name the model does not have."""
        p = np.array([parameter.default for parameter in self.parameters])
        index = {parameter.name: k for k, parameter in enumerate(self.parameters)}
        for name, value in (changes or {}).items():
            if name not in index:
                known = ", ".join(q.name for q in self.parameters if q.kind != "data")
                raise ModelError(f"model {self.name} has no parameter {name!r}; it has {known}")
            if not np.isfinite(value):
                raise ModelError(f"parameter {name!r} must be finite, not {value}")
            p[index[name]] = value
        return p

    def constants(self, p: np.ndarray) -> np.ndarray:
        """c for a parameter vector p. Raises ModelError if a parameter makes one of them infinite or NaN."""
        c = np.asarray(self.kernel("constants")(p)).ravel()
        if not np.all(np.isfinite(c)):
            raise ModelError(f"model {self.name}: a parameter makes the constants infinite (division by zero?)")
        return c


def load_model(folder: str | Path) -> Model:
    """Load a folder written by `symgen generate`, after comparing its files with the manifest's hashes.

    Raises ModelError if files are missing, were edited since generation, or belong to another format.
    """
    path = Path(folder)
    manifest = _manifest(path)
    texts = {name: _checked_text(path, name, expected) for name, expected in manifest["files"].items()}
    data = json.loads(texts["data.json"])
    module = _module(path / "model.py", manifest["files"]["model.py"])
    return _model(manifest, data, module)


def _manifest(path: Path) -> dict[str, Any]:
    try:
        manifest = json.loads((path / "manifest.json").read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise ModelError(f"{path} is not a generated model (manifest.json: {error}); "
                         f"generate it with: symgen generate SCENE --out {path}") from error
    if not isinstance(manifest, dict) or manifest.get("format") != FORMAT:
        raise ModelError(f"{path} was generated in another format; regenerate it with: symgen generate {path}")
    return manifest


def _checked_text(path: Path, name: str, expected: str) -> str:
    try:
        text = (path / name).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise ModelError(f"{path / name} cannot be read ({error}); regenerate with: symgen generate {path}") from error
    if hashlib.sha256(text.encode()).hexdigest() != expected:
        raise ModelError(f"{path / name} was edited since it was generated (its hash differs from manifest.json); "
                         f"regenerate with: symgen generate {path}")
    return text


def _module(path: Path, digest: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"generated_model_{digest[:16]}", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _model(manifest: dict[str, Any], data: dict[str, Any], module: ModuleType) -> Model:
    q_i = manifest["q_i"]
    groups = [Group(group["name"], [q_i.index(name) for name in group["coordinates"]]) for group in manifest["groups"]]
    parameters = [Parameter(**entry, default=data["p"][entry["name"]]) for entry in manifest["parameters"]]
    names = manifest["coordinates"]
    return Model(
        name=manifest["scene"], title=manifest["title"], coordinates=names, elastic=manifest["elastic"], q_i=q_i,
        q_d=manifest["q_d"], loop_unknowns=manifest["loop_unknowns"], groups=groups,
        constraints=manifest["constraints"], joints=manifest["joints"], measures=manifest["measures"],
        outlines=[(body, count) for body, count in manifest["outlines"]], parameters=parameters,
        initial_q=np.array([data["q"][name] for name in names]),
        initial_q_dot=np.array([data["q_dot"][name] for name in names]),
        builders=module.FUNCTIONS, simulation=manifest["simulation"],
        operations={name: entry["operations"] for name, entry in manifest["functions"].items()})
