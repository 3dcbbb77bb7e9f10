"""Words mean one thing each: class names over both packages, and the stages of the compiler as its folders."""

from __future__ import annotations

import re
from pathlib import Path

import symgen
from symgen import pipeline

ROOT = Path(__file__).resolve().parents[2]


def folders() -> set[str]:
    return {path.parent.name for path in (ROOT / "symgen").glob("*/__init__.py")}


def test_the_pipeline_names_its_stages_as_the_folders() -> None:
    assert pipeline.__doc__ is not None
    assert set(re.findall(r"^([a-z]+)  ", pipeline.__doc__, re.MULTILINE)) == folders()


def test_the_package_says_its_map() -> None:
    assert symgen.__doc__ is not None
    assert set(re.findall(r"`([a-z]+)`", symgen.__doc__)) >= folders() - {"bodies", "couplings", "joints", "loads"}
