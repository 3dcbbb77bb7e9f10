"""A good scene with random edits is a scene or a SceneError, never another exception."""

from __future__ import annotations

import copy
import tomllib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from symgen.scene import SceneError, SceneRecord

FILES = sorted((Path(__file__).parents[1] / "bad_scenes" / "good").glob("*.toml"))
GOOD = [tomllib.loads(path.read_text()) for path in FILES]

SCALARS = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.sampled_from([0, -1, 2, 10**12, 10**400, 1e308, 5e-324, -0.0]),
    st.floats(),
    st.text(max_size=12),
    st.sampled_from(["l1", "g*2", "1/0", "9**9**9", "t", "crank.theta", "rod.*", "*", "ground", "m"]),
    st.binary(max_size=3),
)
KEYS = st.one_of(st.text(max_size=8), st.sampled_from(["type", "name", "at", "value"]))
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.dictionaries(KEYS, inner, max_size=3),
        st.tuples(inner, inner),
    ),
    max_leaves=6,
)


def places(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """The paths of everything inside ``value``."""
    lists = enumerate(value) if isinstance(value, list) else ()
    entries = value.items() if isinstance(value, dict) else lists
    return [found for key, part in entries for found in [(*path, key), *places(part, (*path, key))]]


def edit(data: Any, draw: Any) -> None:
    path = draw(st.sampled_from(places(data)))
    for step in path[:-1]:
        data = data[step]
    match draw(st.sampled_from(["replace", "replace", "delete", "rename", "copy"])):
        case "replace":
            data[path[-1]] = draw(VALUES)
        case "delete":
            del data[path[-1]]
        case "rename" if isinstance(data, dict):
            data[draw(st.one_of(st.text(max_size=8), st.integers()))] = data.pop(path[-1])
        case "copy" if isinstance(data, list):
            data.append(copy.deepcopy(data[path[-1]]))


@pytest.mark.long
@settings(max_examples=400, deadline=None, suppress_health_check=list(HealthCheck))
@given(st.data())
def test_edited_scenes(data: st.DataObject) -> None:
    raw = copy.deepcopy(data.draw(st.sampled_from(GOOD)))
    for _ in range(data.draw(st.integers(1, 3))):
        if raw:
            edit(raw, data.draw)
    try:
        scene = SceneRecord.from_dict(raw)
    except SceneError as error:
        assert error.item and error.problem and error.remedy and str(error)
    else:
        assert SceneRecord.from_toml_text(scene.to_toml()) == scene


@settings(max_examples=150, deadline=None)
@given(VALUES)
def test_random_values_are_not_scenes(value: Any) -> None:
    try:
        SceneRecord.from_dict(value)
    except SceneError as error:
        assert str(error)


@settings(max_examples=150, deadline=None)
@given(st.integers(0, len(FILES) - 1), st.data())
def test_damaged_files(index: int, data: st.DataObject) -> None:
    text = FILES[index].read_text()
    start = data.draw(st.integers(0, len(text)))
    damaged = text[:start] + data.draw(st.text(max_size=3)) + text[start + data.draw(st.integers(0, 5)) :]
    try:
        SceneRecord.from_toml_text(damaged)
    except SceneError as error:
        assert str(error)
