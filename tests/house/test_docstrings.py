"""Docstrings of what users ask for: numpydoc sections with every parameter, a reference for every scheme."""

from __future__ import annotations

import inspect
import re

import pytest

from runtime.contract.lazy_method import LazyMethod
from runtime.model import Model
from runtime.schemes.catalogue import SCHEMES

METHODS = [name for name, one in vars(Model).items() if isinstance(one, LazyMethod)]


def section(text: str, title: str) -> str:
    """What stands below a heading, up to the next one; "" where there is none."""
    found = re.search(rf"^{title}\n-+\n(.*?)(?=^\w+\n-+\n|\Z)", text, re.MULTILINE | re.DOTALL)
    return found.group(1) if found else ""


def documented(text: str) -> set[str]:
    """Names of the parameters, of which several may stand on a line."""
    heads = re.findall(r"^(\**\w[\w, ]*?)(?: :.*)?$", section(text, "Parameters"), re.MULTILINE)
    return {name.strip(" *") for head in heads for name in head.split(",")}


@pytest.mark.parametrize("name", METHODS)
def test_methods_of_models_document_every_parameter(name: str) -> None:
    function = getattr(Model, name)
    text = inspect.getdoc(function) or ""
    assert documented(text) == set(inspect.signature(function).parameters)
    assert section(text, "Returns").strip() and section(text, "Raises").strip()


@pytest.mark.parametrize("name", SCHEMES)
def test_schemes_have_references(name: str) -> None:
    """A full one: authors, title, where it appeared, the year."""
    assert re.search(r", (1[89]|20)\d\d\b", section(inspect.getdoc(SCHEMES[name].make) or "", "References"))
