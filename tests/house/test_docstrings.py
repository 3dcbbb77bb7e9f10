"""Docstrings of what users ask for: numpydoc sections with every parameter, a reference for every scheme."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from typing import Any, get_overloads

import pytest

from runtime import SCHEMES, DifferentiableRun, Solution
from runtime.contract.lazy_method import LazyMethod
from runtime.model import Model
from runtime.running.stepping import ModelStepper
from symgen import Scene
from symgen.urdf import read

METHODS = [name for name, one in vars(Model).items() if isinstance(one, LazyMethod)]
ENTRIES = [name for name, one in vars(Scene).items() if isinstance(one, LazyMethod)]


def section(text: str, title: str) -> str:
    """What stands below a heading, up to the next one; "" where there is none."""
    found = re.search(rf"^{title}\n-+\n(.*?)(?=^\w+\n-+\n|\Z)", text, re.MULTILINE | re.DOTALL)
    return found.group(1) if found else ""


def documented(text: str) -> set[str]:
    """Names of the parameters, of which several may stand on a line."""
    heads = re.findall(r"^(\**\w[\w*, ]*?)(?: :.*)?$", section(text, "Parameters"), re.MULTILINE)
    return {name.strip(" *") for head in heads for name in head.split(",")}


def parameters(function: Callable[..., Any]) -> set[str]:
    """Names of the arguments, without the object whose method it is; those of an overload that names them."""
    named = get_overloads(function)[:1] or [function]
    return set(inspect.signature(named[0]).parameters) - {"self"}


def public_methods(cls: type) -> list[str]:
    """What can be called by name, constructors by other means included."""
    return [
        name
        for name in dir(cls)
        if not name.startswith("_") and inspect.isfunction(getattr(cls, name)) or inspect.ismethod(getattr(cls, name))
    ]


def assert_documented(function: Callable[..., Any]) -> None:
    """Every parameter and what is returned are said; the first word is a verb, as far as that shows."""
    text = inspect.getdoc(function) or ""
    assert documented(text) == parameters(function)
    assert section(text, "Returns").strip() or inspect.signature(function).return_annotation in (None, "None")
    assert re.match(r"(?!The |A |An |All |What |Of |At )[A-Z][a-z]+ ", text)


DOCUMENTED: list[type] = [Model, Scene, Solution, ModelStepper, DifferentiableRun]
PUBLIC = [(cls, name) for cls in DOCUMENTED for name in public_methods(cls)]


@pytest.mark.parametrize("name", METHODS)
def test_methods_of_models_document_every_parameter(name: str) -> None:
    function = getattr(Model, name)
    text = inspect.getdoc(function) or ""
    assert documented(text) == set(inspect.signature(function).parameters)
    assert section(text, "Returns").strip() and section(text, "Raises").strip()


@pytest.mark.parametrize(("cls", "name"), PUBLIC, ids=[f"{cls.__name__}.{name}" for cls, name in PUBLIC])
def test_public_methods_document_every_parameter(cls: type, name: str) -> None:
    assert_documented(getattr(cls, name))


def test_public_methods_of_flexible_bodies_document_every_parameter() -> None:
    pytest.importorskip("scipy", reason="needs the extra fe")
    from symgen.fe import FlexibleBody

    for name in public_methods(FlexibleBody):
        assert_documented(getattr(FlexibleBody, name))


def test_reading_a_robot_documents_every_parameter() -> None:
    assert_documented(read)


@pytest.mark.parametrize("cls", [ModelStepper, DifferentiableRun])
def test_constructors_document_every_parameter(cls: type) -> None:
    assert documented(inspect.getdoc(cls) or "") == parameters(cls)


@pytest.mark.parametrize("name", ENTRIES)
def test_entries_of_scenes_say_what_each_field_is(name: str) -> None:
    """In a sentence each, so that no record has a field without a description."""
    text = section(inspect.getdoc(getattr(Scene, name)) or "", "Parameters")
    heads = re.findall(r"^\w+ : \S.*\n((?:    .*\n?)+)", text, re.MULTILINE)
    assert len(heads) == len(parameters(getattr(Scene, name)))
    assert all(head.strip().endswith(".") and len(head.split()) > 1 or "[" in head for head in heads)


def test_help_shows_parameters_of_an_entry() -> None:
    text = inspect.getdoc(Scene.revolute) or ""
    assert "damping : float or expression, default 0.0\n    Damping of the rotation [N m s/rad]; not negative." in text
    assert "Keys: lower [m or rad], upper [m or rad]" in text and "Hunt" in section(text, "References")


@pytest.mark.parametrize("name", SCHEMES)
def test_schemes_have_references(name: str) -> None:
    """A full one: authors, title, where it appeared, the year."""
    assert re.search(r", (1[89]|20)\d\d\b", section(inspect.getdoc(SCHEMES[name].make) or "", "References"))


def test_stubs_of_entries_are_those_of_the_records() -> None:
    """Else write them again: python -m symgen.mechanism.entry_stubs."""
    from symgen.mechanism.entry_stubs import STUBS, stub_text

    assert STUBS.read_text(encoding="utf-8") == stub_text()
