"""Field types shared by all parts of a scene: names, numbers, quantities, references.

A *quantity* is a number or an expression in the declared parameters. What it measures, its unit, the sign
it must have and the names its expression may use are declared beside the field with `Meaning`; the checks and
the JSON Schema read them from there.
"""

from __future__ import annotations

import keyword
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, TypeVar

from pydantic import BaseModel, ConfigDict, Field, PlainValidator, Strict, model_validator
from pydantic_core import PydanticCustomError

from symgen.schema.errors import did_you_mean, show
from symgen.schema.texts import line

NAME_PATTERN = r"^[A-Za-z][A-Za-z0-9_]{0,63}$"


def refuse(problem: str, remedy: str, key: str = "") -> PydanticCustomError:
    """An error that `translate.scene_errors` turns into a `SceneError` without changing its words."""
    return PydanticCustomError("scene", "{problem}; {remedy}", {"problem": problem, "remedy": remedy, "key": key})


class Fault(NamedTuple):
    """What a record finds wrong with itself: at which of its fields ("": all of it), what it is, what to do."""

    key: str
    problem: str
    remedy: str


class StrictModel(BaseModel):
    """Base of every part of a scene: immutable, and an unknown key is an error with a suggestion."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)
    example: ClassVar[str] = ""  # what one writes, where others are tempted to write a number or a list
    references: ClassVar[tuple[str, ...]] = ()  # publications that its law or method follows

    @model_validator(mode="before")
    @classmethod
    def _known_keys(cls, data: Any) -> Any:
        if cls.example and not isinstance(data, dict | cls):
            raise refuse(f"{show(data)} is not a table of entries", f"write {cls.example}")
        if isinstance(data, dict):
            for key, value in data.items():
                if not isinstance(key, str) or key not in cls.model_fields:
                    name = key if isinstance(key, str) else show(key)
                    raise refuse(f"unknown key {show(key)}", did_you_mean(key, cls.model_fields), name)
                if isinstance(value, set | frozenset):
                    raise refuse(f"{show(value)} has no order", "give a list instead of a set", key)
        return data

    def faults(self, scene: Any) -> Iterator[Fault]:
        """What its fields alone do not show; scene: the parts around it."""
        return iter(())

    @classmethod
    def meaning(cls, key: str) -> Meaning:
        """What the quantity field `key` stands for."""
        return next(entry for entry in cls.model_fields[key].metadata if isinstance(entry, Meaning))


class Bound(Enum):
    """The sign a quantity must have."""

    value: Literal["any", "positive", "not negative"]
    ANY = "any"
    POSITIVE = "positive"
    NON_NEGATIVE = "not negative"


class Scope(Enum):
    """The names an expression may use."""

    PARAMETERS = "parameters"
    TIME = "parameters, inputs and t"
    MEASURES = "parameters, inputs, t, measures, states and their rates"
    LINE = "parameters, inputs, t, measures, states and their rates, and length and rate of the line"
    PLACE = "parameters, inputs, t, measures, states and their rates, and the place s along the beam"
    STATES = "parameters, inputs, t, measures, their rates and states"
    MOTION = "parameters, inputs, t, measures and their rates, states, coordinates and their rates"
    EVENTS = "parameters, inputs, t, measures, forces of loads, states and their rates"


@dataclass(frozen=True)
class Meaning:
    """What a quantity field stands for: description, SI unit, sign and the names it may use.

    remedy: what to do where the sign is wrong, if giving another value is not all.
    """

    description: str
    unit: str = "1"
    bound: Bound = Bound.ANY
    scope: Scope = Scope.PARAMETERS
    remedy: str = ""

    def __get_pydantic_json_schema__(self, core_schema: Any, handler: Any) -> dict[str, Any]:
        schema: dict[str, Any] = handler(core_schema)
        schema.update(description=f"{self.description} [{self.unit}]; expressions may use {self.scope.value}")
        if self.bound is not Bound.ANY:
            schema["description"] += f"; {self.bound.value}"
        return schema


def about(description: str) -> Any:
    """What a field is that is no quantity: the JSON Schema says it, and the method of `Scene` that adds the entry."""
    return Field(description=description)


N = -1  # in a `Size`: as many as the flexible body has modes, or the structure coordinates


@dataclass(frozen=True)
class Size:
    """Lengths of a field's lists, from the outer one to the inner one. form: what a matrix is, as mechanics demands."""

    lengths: tuple[int, ...]
    form: Literal["", "symmetric", "positive", "semidefinite", "skew"] = ""


def size(*lengths: int, form: Literal["", "symmetric", "positive", "semidefinite", "skew"] = "") -> Size:
    """`Size` of these lengths."""
    return Size(lengths, form)


def sized(model: BaseModel, path: str = "") -> Iterator[tuple[str, Any, Size]]:
    """Every field with a size in a record and in those inside it, if it is given: (path, value, size)."""
    for key, field in type(model).model_fields.items():
        value, where = getattr(model, key), f"{path}{key}"
        found = next((entry for entry in field.metadata if isinstance(entry, Size)), None)
        if found is not None and value is not None and not value == () == field.default:
            yield where, value, found
        elif isinstance(value, BaseModel):
            yield from sized(value, f"{where}.")
        elif isinstance(value, dict):
            for name, part in value.items():
                if isinstance(part, BaseModel):
                    yield from sized(part, f"{where}.{name}.")


def size_faults(model: BaseModel, n: int) -> Iterator[Fault]:
    """Lists whose length is not that of their `Size`, of which N is n."""
    for path, value, wanted in sized(model):
        yield from _length_faults(path, value, [n if length == N else length for length in wanted.lengths])


def _length_faults(path: str, value: Any, lengths: list[int], inside: str = "") -> Iterator[Fault]:
    kind = "rows" if len(lengths) > 1 else "entries"
    if len(value) != lengths[0]:
        yield Fault(path, f"has {len(value)} {kind} instead of {lengths[0]}", f"give {lengths[0]} {kind}{inside}")
    elif len(lengths) > 1:
        for index, entry in enumerate(value):
            yield from _length_faults(f"{path}[{index}]", entry, lengths[1:], " a row")


def components_fault(key: str, values: tuple[Any, ...], scene: Any) -> Iterator[Fault]:
    """Of a vector with more or fewer components than the scene has axes."""
    if scene.space == "planar" and len(values) != 2:
        remedy = "give (x, y)" + ("" if len(values) < 2 else ', or set space = "spatial"')
        yield Fault(key, f"has {len(values)} components in a planar scene", remedy)
    elif scene.space == "spatial" and len(values) not in (2, 3):
        yield Fault(key, f"has {len(values)} components", "give (x, y, z); a z left out is zero")


def _name(value: object) -> str:
    if not isinstance(value, str) or not re.fullmatch(NAME_PATTERN, value) or value.endswith("\n"):
        raise refuse(
            f"{show(value)} is not a valid name",
            "use a letter followed by up to 63 letters, digits or underscores",
        )
    if keyword.iskeyword(value):
        raise refuse(f"'{value}' is a reserved word", "choose another name")
    return value


def _number(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise refuse(f"{show(value)} is not a number", "give a number such as 0.15")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise refuse(f"{show(value)} is not a finite number", "give a finite number below 1e308")
    return number


def _quantity(value: object) -> float | str:
    if isinstance(value, str):
        return " ".join(str(line(re.sub(r"[\t\r\n]", " ", value))).split())  # line breaks mean nothing in an expression
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise refuse(
            f"{show(value)} is neither a number nor an expression",
            'give a number such as 0.15 or an expression in quotes such as "density*length"',
        )
    return _number(value)


def _inertia(value: object) -> float | str | tuple[float | str, ...]:
    """One quantity, or three in a list."""
    if not isinstance(value, list | tuple):
        return _quantity(value)
    if len(value) != 3:
        raise refuse(
            f"{show(value)} has {len(value)} entries", "give one moment of inertia (planar) or three (spatial)"
        )
    if any(isinstance(entry, list | tuple) for entry in value):
        raise refuse("is a matrix", "give inertia = [xx, yy, zz] and products = [xy, xz, yz]")
    return tuple(_quantity(entry) for entry in value)


WORLD = "world"  # axes in which a vector is resolved, if not in those of a marker


def _two_names(value: object, what: str, example: str) -> str:
    parts = value.split(".") if isinstance(value, str) else []
    if len(parts) != 2 or not all(re.fullmatch(NAME_PATTERN, part) for part in parts):
        raise refuse(f"{show(value)} does not name a {what}", f"write {example}")
    return str(value)


def _reference(what: str, example: str) -> PlainValidator:
    """Text of two names with a dot between them."""
    return PlainValidator(partial(_two_names, what=what, example=example), json_schema_input_type=str)


def _axes(value: object) -> str:
    """World axes, or those of a marker."""
    return WORLD if value == WORLD else _two_names(value, "marker", f'"{WORLD}", or "body.marker" whose axes are meant')


def _coordinate(value: object) -> str:
    if not isinstance(value, str) or not re.fullmatch(r"[A-Za-z0-9_.*?]{1,140}", value):
        raise refuse(f"{show(value)} is not a coordinate", 'write "body.coordinate", for instance "crank.theta"')
    return value


Name = Annotated[str, PlainValidator(_name, json_schema_input_type=Annotated[str, Field(pattern=NAME_PATTERN)])]
Number = Annotated[float, PlainValidator(_number, json_schema_input_type=float)]
Quantity = Annotated[float | str, PlainValidator(_quantity, json_schema_input_type=float | str)]
Inertia = Annotated[
    float | str | tuple[float | str, ...],
    PlainValidator(_inertia, json_schema_input_type=float | str | list[float | str]),
]
MarkerRef = Annotated[str, _reference("marker", '"body.marker", for instance "crank.origin"')]
AxesRef = Annotated[str, PlainValidator(_axes, json_schema_input_type=str)]
GaugeRef = Annotated[str, _reference("gauge", '"body.gauge", or "body.all" for the largest')]
Coordinate = Annotated[str, PlainValidator(_coordinate, json_schema_input_type=str)]
Flag = Annotated[bool, Strict()]
Vector = tuple[Quantity, ...]
Matrix = tuple[tuple[Quantity, ...], ...]


SPATIAL = 'set space = "spatial", or use what a planar scene has'
MARKER_ANGLE = Meaning("angle of the marker's x-axis against the body's x-axis, counter-clockwise", "rad")


def quantities(model: BaseModel, path: str) -> Iterator[tuple[str, float | str, Meaning]]:
    """Every quantity in ``model`` and the models inside it: (item path, value, meaning)."""
    for key, field in type(model).model_fields.items():
        value = getattr(model, key)
        meaning = next((entry for entry in field.metadata if isinstance(entry, Meaning)), None)
        if meaning is not None:
            yield from ((item, entry, meaning) for item, entry in _entries(value, f"{path}.{key}"))
        elif isinstance(value, BaseModel):
            yield from quantities(value, f"{path}.{key}")
        elif isinstance(value, dict):
            for name, part in value.items():
                if isinstance(part, BaseModel):
                    yield from quantities(part, f"{path}.{key}.{name}")


def _entries(value: object, path: str) -> Iterator[tuple[str, float | str]]:
    if isinstance(value, tuple):
        for index, entry in enumerate(value):
            yield from _entries(entry, f"{path}[{index}]")
    elif isinstance(value, dict):
        for name, entry in value.items():
            yield from _entries(entry, f"{path}.{name}")
    elif isinstance(value, float | str):
        yield path, value


Record = TypeVar("Record", bound=StrictModel)


def types_of(package: str, folder: str, base: type[Record]) -> dict[str, type[Record]]:
    """The records that the files of a package state, built on `base`, by their name in a scene."""
    for path in sorted(Path(folder).parent.glob("*.py")):
        if path.stem != "__init__":
            import_module(f"{package}.{path.stem}")
    return {cls.model_fields["type"].default: cls for cls in base.__subclasses__()}
