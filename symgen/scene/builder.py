"""A scene written in Python. The builder collects entries; the schema checks them once, in `build`."""

from __future__ import annotations

from collections.abc import Callable
from inspect import Parameter, Signature
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from symgen.couplings import COUPLINGS
from symgen.joints import JOINTS
from symgen.loads import LOADS
from symgen.scene.scene import SceneRecord
from symgen.scene.tables import read_points
from symgen.schema.errors import SceneError, show
from symgen.schema.fields import StrictModel

if TYPE_CHECKING:
    from runtime.contract.model import Model

MAX_NESTING = 20


class Scene:
    """A mechanism as it is written down: each call adds an entry and returns the scene; `model()` derives.

    `Scene("arm", title="...", space="spatial")`. The keyword arguments are the fields of a scene file (SI units), NumPy
    arrays included. Each type of joint, coupling and load has a method of its name:
    `revolute("hinge", "ground.origin", "arm.start", damping=0.1)`. `build`, which `model` calls, raises SceneError for
    everything that is wrong: the item, what is wrong, what to do.
    """

    def __init__(self, name: str, **fields: Any) -> None:
        """``fields``: title, description, space ("planar" or "spatial")."""
        self._data: dict[str, Any] = {"name": name, **_plain(fields, "scene")}

    @classmethod
    def from_toml(cls, path: str | Path) -> Scene:
        """The scene of a TOML file, to which more can be added. Raises SceneError."""
        found = cls("")
        found._data = SceneRecord.from_toml(path).to_dict()
        return found

    def parameter(self, name: str, default: float, unit: str = "", description: str = "") -> Self:
        """Declare a run-time input."""
        parameters = self._data.setdefault("parameters", {})
        if name in parameters:
            raise SceneError(f"parameters.{name}", "is declared twice", "remove one of them")
        parameters[name] = _plain({"default": default, "unit": unit, "description": description}, "parameters")
        return self

    def input(self, name: str, default: float = 0.0, unit: str = "", description: str = "", **fields: Any) -> Self:
        """Declare a number that comes from outside during a run; fields: `rates`, `filter` of `DeclaredInput`."""
        inputs = self._data.setdefault("inputs", {})
        if name in inputs:
            raise SceneError(f"inputs.{name}", "is declared twice", "remove one of them")
        inputs[name] = _plain({"default": default, "unit": unit, "description": description, **fields}, "inputs")
        return self

    def table(self, name: str, **fields: Any) -> Self:
        """A `CurveTable`: x and y, or the file of a CSV, which is read now."""
        tables = self._data.setdefault("tables", {})
        if name in tables:
            raise SceneError(f"tables.{name}", "is declared twice", "remove one of them")
        if "file" in fields:
            path, columns = fields.pop("file"), fields.pop("columns", (0, 1))
            fields |= read_points(path, columns, f"tables.{name}")
        tables[name] = _plain(fields, "tables")
        return self

    def event(self, name: str, when: float | str, **fields: Any) -> Self:
        """Declare a `DeclaredEvent`: direction, terminal, action."""
        events = self._data.setdefault("events", {})
        if name in events:
            raise SceneError(f"events.{name}", "is declared twice", "remove one of them")
        events[name] = _plain({"when": when, **fields}, "events")
        return self

    def state(self, name: str, rate: float | str, initial: float = 0.0, unit: str = "", description: str = "") -> Self:
        """Declare a state s' = rate of a controller, a filter or an actuator."""
        states = self._data.setdefault("states", {})
        if name in states:
            raise SceneError(f"states.{name}", "is declared twice", "remove one of them")
        states[name] = _plain({"rate": rate, "initial": initial, "unit": unit, "description": description}, "states")
        return self

    def gravity(self, *components: float | str) -> Self:
        """Acceleration of gravity [m/s^2] in world axes: x, y and, in a spatial scene, z."""
        return self._set("gravity", list(components))

    def ground(self, **fields: Any) -> Self:
        """Markers on the ground."""
        return self._add("bodies", "ground", "ground", fields)

    def rigid(self, name: str, **fields: Any) -> Self:
        """A `RigidBody`."""
        return self._add("bodies", "rigid", name, fields)

    def beam(self, name: str, **fields: Any) -> Self:
        """A `BeamBody`."""
        return self._add("bodies", "beam", name, fields)

    def modal(self, name: str, **fields: Any) -> Self:
        """A `ModalBody`."""
        return self._add("bodies", "modal", name, fields)

    def flexible(self, name: str, **fields: Any) -> Self:
        """A `SpatialModalBody`."""
        return self._add("bodies", "flexible", name, fields)

    def joint(self, type: str, name: str, marker_a: str, marker_b: str, **fields: Any) -> Self:
        """A joint of any type by its name in a scene file; each type has a method of that name, too."""
        return self._add("joints", type, name, {"marker_a": marker_a, "marker_b": marker_b, **fields})

    if TYPE_CHECKING:

        def __getattr__(self, type: str) -> Callable[..., Self]:
            """A method for each type of joint, coupling and load, see below."""

    def force(self, name: str, marker: str, *components: float | str, **fields: Any) -> Self:
        """A `Force` with components x, y (and z) [N]."""
        return self._add("loads", "force", name, {"marker": marker, "components": list(components), **fields})

    def load(self, type: str, name: str, **fields: Any) -> Self:
        """A load of any type by its name in a scene file; each type has a method of that name, too."""
        return self._add("loads", type, name, fields)

    def measure(self, name: str, type: str, of: str, relative_to: str = "ground.origin", **fields: Any) -> Self:
        """A measure: angle, distance, x, y or z of a marker relative to another one, coordinate of a coordinate,
        normal_force, shear_force, bending_moment, ... of a beam at a marker, or stress of a finite-element body at
        `body.gauge` with its component.
        """
        base = {} if relative_to == "ground.origin" else {"relative_to": relative_to}
        return self._add("measures", type, name, {"of": of, **base, **fields})

    def structure(self, **fields: Any) -> Self:
        """A `Structure`."""
        return self._set("structure", fields)

    def independent(self, *coordinates: str) -> Self:
        """Choose the independent coordinates."""
        return self._merge("partition", {"independent": list(coordinates)})

    def groups(self, **groups: Any) -> Self:
        """Groups by name, slow to fast, each a list of coordinate names or patterns."""
        entries = [{"name": name, "coordinates": coordinates} for name, coordinates in groups.items()]
        return self._merge("partition", {"groups": entries})

    def stiff(self, *names: str) -> Self:
        """Choose the stiff deflections: elastic coordinates and rotational springs, names or patterns."""
        return self._merge("partition", {"stiff": list(names)})

    def initial(self, coordinates: dict[str, Any]) -> Self:
        """Starting coordinates, besides those of earlier calls: numbers or {"value": ..., "fixed": ...}."""
        return self._start("coordinates", coordinates)

    def rates(self, rates: dict[str, Any]) -> Self:
        """Starting rates, besides those of earlier calls: numbers or {"value": ..., "fixed": ...}."""
        return self._start("rates", rates)

    def simulation(self, **fields: Any) -> Self:
        """The fields of `Simulation`."""
        return self._set("simulation", fields)

    def baumgarte(self, alpha: float, beta: float) -> Self:
        """Stabilisation of the augmented form [1/s]."""
        return self._set("baumgarte", {"alpha": alpha, "beta": beta})

    def build(self) -> SceneRecord:
        """The scene, checked and from now on as it is. Raises SceneError."""
        return SceneRecord.from_dict(self._data)

    def model(self) -> Model:
        """The equations, ready to run: derived and generated once, then kept in the cache. Raises SceneError.

        To keep the generated code in a folder of its own: `generate(scene.build(), folder)`, `load_model(folder)`.
        """
        return self.build().model()

    def _set(self, section: str, value: Any) -> Self:
        self._data[section] = _plain(value, section)
        return self

    def _merge(self, section: str, value: dict[str, Any]) -> Self:
        self._data[section] = {**self._data.get(section, {}), **_plain(value, section)}
        return self

    def _start(self, kind: str, values: dict[str, Any]) -> Self:
        start = self._data.setdefault("initial", {})
        start[kind] = {**start.get(kind, {}), **_plain(values, "initial")}
        return self

    def _add(self, section: str, type: str, name: str, fields: dict[str, Any]) -> Self:
        self._data.setdefault(section, []).append(_plain({"type": type, "name": name, **fields}, section))
        return self


def _plain(value: Any, item: str, depth: int = 0) -> Any:
    """NumPy arrays and scalars, and tuples, as the lists and numbers a TOML file would give."""
    if depth > MAX_NESTING:
        raise SceneError(item, "is nested too deeply", "give plain numbers, lists and dictionaries")
    if isinstance(value, set | frozenset):
        raise SceneError(item, f"{show(value)} has no order", "give a list instead of a set")
    if isinstance(value, dict):
        return {key: _plain(part, item, depth + 1) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(part, item, depth + 1) for part in value]
    if hasattr(value, "tolist"):
        return value.tolist()
    return value


def _method(section: str, type: str, record: type[StrictModel]) -> Callable[..., Scene]:
    """Adds an entry of this type: what it needs by place or by name, the rest by name."""
    own = {key: field for key, field in record.model_fields.items() if key not in ("type", "name")}
    needed = [key for key, field in own.items() if field.is_required()]
    free = [key for key in own if key not in needed]

    def add(self: Scene, name: str, *values: Any, **fields: Any) -> Scene:
        placed = dict(zip(needed, values, strict=False))
        if len(values) > len(needed):
            problem = f"{show(values[len(needed)])} is one value too many: {type}({', '.join(['name', *needed])})"
            raise SceneError(f"{section} {show(name)}", problem, f"name it: {', '.join(free) or 'none'}")
        if twice := sorted(placed.keys() & fields.keys()):
            raise SceneError(f"{section} {show(name)}.{twice[0]}", "is given by place and by name", "give it once")
        return self._add(section, type, name, {**placed, **fields})

    either, named = Parameter.POSITIONAL_OR_KEYWORD, Parameter.KEYWORD_ONLY
    known = [Parameter(key, either) for key in ("self", "name", *needed)]
    optional = [Parameter(key, named, default=own[key].default) for key in free]
    add.__name__, add.__doc__ = type, record.__doc__
    add.__signature__ = Signature([*known, *optional])  # type: ignore[attr-defined]
    return add


for _section, _records in (("joints", JOINTS), ("couplings", COUPLINGS), ("loads", LOADS)):
    for _type, _record in _records.items():
        if not hasattr(Scene, _type):
            setattr(Scene, _type, _method(_section, _type, _record))
