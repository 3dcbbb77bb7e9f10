"""Docstrings of the methods of `Scene` that add an entry, written from the fields of its record.

A quantity has its description, unit and sign in a `Meaning`, another field in `about(...)`; equations and references
stand in the record. `entry_doc` puts them into the sections of numpydoc, `help(Scene.revolute)` shows them, and
`entry_stubs` writes them beside the signatures for type checkers and for the site.
"""

from __future__ import annotations

from inspect import cleandoc
from textwrap import fill
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, NamedTuple, Union, get_args, get_origin

from pydantic.fields import FieldInfo

from symgen.schema.fields import Bound, Meaning, Scope, Size, StrictModel

WIDTH = 108
MOST_WORDS = 6  # of a choice that are named in the line of its type
KINDS = {"bodies": "body", "joints": "joint", "couplings": "coupling", "loads": "load"}
NOTES = {
    "bodies": "Its mass matrix, quadratic velocity forces and stiffness are those of Eqs. 15-20.",
    "joints": "Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).",
    "couplings": "Its row is part of C(q, t) = 0 (Eq. 21), with a constant Jacobian C_q.",
    "loads": "Its generalised force is part of Q in the equations of motion (Eq. 22).",
}
RETURNS = """Returns
-------
Scene
    The scene itself, so that calls can follow one another."""
RAISES = """Raises
------
SceneError
    At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
    what is missing and for values that cannot be used."""
BOUNDS = {Bound.ANY: "", Bound.POSITIVE: "positive", Bound.NON_NEGATIVE: "not negative"}


class EntryField(NamedTuple):
    """A field of a record as a parameter of a method."""

    name: str
    info: FieldInfo

    @property
    def required(self) -> bool:
        """Must it be given?"""
        return self.info.is_required()

    @property
    def default(self) -> str:
        """Its default as text; "" where there is none that one would type."""
        value = None if self.required or self.info.default_factory else self.info.default
        return "" if value is None or value == () else f'"{value}"' if isinstance(value, str) else repr(value)

    @property
    def meaning(self) -> Meaning | None:
        """What it measures, if it is a quantity."""
        return next((one for one in self.info.metadata if isinstance(one, Meaning)), None)

    @property
    def records(self) -> list[type[StrictModel]]:
        """The records that its value holds, with fields of their own."""
        return [
            one for one in _parts_of(self.info.annotation) if isinstance(one, type) and issubclass(one, StrictModel)
        ]


def entry_fields(record: type[StrictModel]) -> list[EntryField]:
    """The parameters after the name: required ones first, which can be given by place; the others by keyword only."""
    fields = [EntryField(key, info) for key, info in record.model_fields.items() if key not in ("type", "name")]
    return sorted(fields, key=lambda field: not field.required)


def entry_doc(section: str, type: str, record: type[StrictModel]) -> str:
    """The docstring of the method that adds an entry of this type.

    Parameters
    ----------
    section : {"bodies", "joints", "couplings", "loads"}
        The list of the scene that the entry goes into.
    type : str
        Name of the type in scenes.
    record : type of StrictModel
        Its fields.

    Returns
    -------
    str
        With the sections Parameters, Returns, Raises, Notes and, where the record has them, References.
    """
    kind = KINDS[section]
    entries = [("name : str", f"Name of the {kind}, by which expressions, results and messages refer to it.")]
    entries += [(f"{field.name} : {_kind_of(field)}", description(field)) for field in entry_fields(record)]
    equation = getattr(record, "equation", "")
    notes = [NOTES[section], *([f"In the plane: ``{equation}``."] if equation else [])]
    parts = [
        f"Add a {kind} of the type `{type}`.",
        cleandoc(record.__doc__ or ""),
        "Parameters\n----------\n" + "\n".join(f"{head}\n{_indented(text)}" for head, text in entries),
        RETURNS,
        RAISES,
        "Notes\n-----\n" + "\n".join(notes),
    ]
    if references := _references(record):
        parts.append("References\n----------\n" + "\n\n".join(fill(one, WIDTH) for one in references))
    return "\n\n".join(parts)


def description(field: EntryField) -> str:
    """A sentence on a parameter: what it is, its unit and sign, the names that its expression may use."""
    if (meaning := field.meaning) is not None:
        said = f"{meaning.description} [{meaning.unit}]"
        bounds = [bound] if (bound := BOUNDS[meaning.bound]) else []
        uses = [] if meaning.scope is Scope.PARAMETERS else [f"expressions may use {meaning.scope.value}"]
        return _sentence("; ".join([said, *bounds, *uses]))
    keys = [_keys(record) for record in field.records]
    return " ".join([_sentence(field.info.description or ""), *(f"Keys: {one}." for one in dict.fromkeys(keys))])


def _keys(record: type[StrictModel]) -> str:
    """The fields of a record inside an entry, with units."""
    fields = [EntryField(key, info) for key, info in record.model_fields.items()]
    return ", ".join(one.name + (f" [{one.meaning.unit}]" if one.meaning else "") for one in fields)


def _kind_of(field: EntryField) -> str:
    """The type of a parameter as numpydoc writes it, with its default."""
    kinds = dict.fromkeys(_kind(one, field) for one in alternatives(field.info.annotation))
    said = " or ".join(kind for kind in kinds if kind)
    if field.required:
        return said
    return f"{said}, default {field.default}" if field.default else f"{said}, optional"


def _kind(annotation: Any, field: EntryField) -> str:
    origin = get_origin(annotation)
    if origin is Literal:
        words = [f'"{word}"' for word in get_args(annotation)]
        return "{" + ", ".join(words if len(words) <= MOST_WORDS else [*words[:MOST_WORDS], "..."]) + "}"
    if origin is tuple:
        return f"sequence{_shape(field)}"
    if origin is dict:
        return "mapping of str to mapping"
    if isinstance(annotation, type) and issubclass(annotation, StrictModel):
        return "mapping"
    if annotation is NoneType:
        return ""
    quantity = field.meaning is not None
    return {float: "float", int: "int", bool: "bool", str: "expression" if quantity else "str"}[annotation]


def _shape(field: EntryField) -> str:
    size = next((one for one in field.info.metadata if isinstance(one, Size)), None)
    if size is None:
        return ""
    lengths = ["nf" if length < 0 else str(length) for length in size.lengths]
    return f", shape ({', '.join(lengths)}{',' if len(lengths) == 1 else ''})"


def alternatives(annotation: Any) -> list[Any]:
    """The members of a union, what is annotated without its marks."""
    if get_origin(annotation) is Annotated:
        return alternatives(get_args(annotation)[0])
    if get_origin(annotation) in (Union, UnionType):
        return [part for one in get_args(annotation) for part in alternatives(one)]
    return [annotation]


def _parts_of(annotation: Any) -> list[Any]:
    """All types that an annotation is made of."""
    arguments = [] if get_origin(annotation) is Literal else get_args(annotation)
    return [annotation, *(part for one in arguments for part in _parts_of(one))]


def _references(record: type[StrictModel]) -> list[str]:
    """Publications behind a record and the records inside it."""
    inside = [one for field in entry_fields(record) for one in field.records]
    return list(dict.fromkeys(reference for one in (record, *inside) for reference in one.references))


def _sentence(text: str) -> str:
    """With a capital and a full stop; an integral begins small."""
    if not text:
        return ""
    return (text if text.startswith("int ") else text[0].upper() + text[1:]) + "."


def _indented(text: str) -> str:
    return fill(text, WIDTH, initial_indent="    ", subsequent_indent="    ", break_long_words=False)
