"""Words mean one thing each: class names over both packages, and the stages of the compiler as its folders."""

from __future__ import annotations

import re
from collections import defaultdict
from importlib import import_module
from pathlib import Path

import pytest

import symgen
from symgen import pipeline
from symgen.scenes import SCENES

ROOT = Path(__file__).resolve().parents[2]

# old public names, kept for a release
RENAMED = {
    "symgen.fe": {"Structure": "FEStructure"},
    "symgen.modes": {"AxialModes": "BarModes", "LateralModes": "BeamModes"},
    "symgen.pipeline": {"Position": "Configuration"},
    "symgen.scene": {
        "FlexibleBody": "SpatialModalBody",
        "Group": "CoordinateGroup",
        "Parameter": "DeclaredParameter",
        "Place": "Placement",
    },
}


@pytest.mark.parametrize(
    "module, old, new", [(m, old, new) for m, names in RENAMED.items() for old, new in names.items()]
)
def test_old_names_are_the_new_ones_with_a_warning(module: str, old: str, new: str) -> None:
    holder = import_module(module)
    with pytest.warns(DeprecationWarning, match=f"{old} is {new}"):
        assert getattr(holder, old) is getattr(holder, new)


def test_places_of_a_scene_are_its_placements() -> None:
    scene = SCENES["bricard"]()
    with pytest.warns(DeprecationWarning, match="placements"):
        assert scene.places() == scene.placements()


def class_names() -> dict[str, list[str]]:
    found: dict[str, list[str]] = defaultdict(list)
    for package in ("symgen", "runtime"):
        for path in sorted((ROOT / package).rglob("*.py")):
            for name in re.findall(r"^ *class (\w+)[(:]", path.read_text(encoding="utf-8"), re.MULTILINE):
                found[name].append(str(path.relative_to(ROOT)))
    return found


def test_no_two_classes_share_a_name() -> None:
    """Private ones neither: a name says what a thing is, wherever it is read."""
    found = class_names()
    assert {"Scene", "Solution"} <= set(found)
    assert not {name: paths for name, paths in found.items() if len(paths) > 1}


def folders() -> set[str]:
    return {path.parent.name for path in (ROOT / "symgen").glob("*/__init__.py")}


def test_the_pipeline_names_its_stages_as_the_folders() -> None:
    assert pipeline.__doc__ is not None
    assert set(re.findall(r"^([a-z]+)  ", pipeline.__doc__, re.MULTILINE)) == folders()


def test_the_package_says_its_map() -> None:
    assert symgen.__doc__ is not None
    assert set(re.findall(r"`([a-z]+)`", symgen.__doc__)) >= folders() - {"bodies", "joints", "loads"}
