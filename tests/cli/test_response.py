"""`symgen response`: frequency responses on the command line, against closed forms."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from symgen.cli import main
from symgen.scene import Scene


def test_frequency_response(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """x / F = 1 / (k - m w^2 + i c w) of a damped slider, in JSON and in the file."""
    scene = (
        Scene("slider")
        .input("push", 0.0, "N")
        .rigid("mass", mass=2.0, inertia=0.1)
        .prismatic("rail", "ground.origin", "mass.origin", damping=3.0)
        .measure("x", "x", "mass.origin")
        .force("spring", "mass.origin", "push - 50 * x", 0.0)
        .build()
    )
    (tmp_path / "slider.toml").write_text(scene.to_toml(), encoding="utf-8")
    words = ["response", str(tmp_path / "slider.toml"), "--input", "push", "--output", "x", "--frequencies", "1:20"]
    assert main([*words, "--points", "7", "--json", "--out", str(tmp_path)]) == 0
    found = json.loads(capsys.readouterr().out)
    w = np.geomspace(1, 20, 7)
    exact = 1 / (50 - 2 * w**2 + 3j * w)
    np.testing.assert_allclose(found["omega"], w, rtol=1e-15)
    np.testing.assert_allclose(found["responses"][0]["amplitude"], np.abs(exact), rtol=1e-12)
    np.testing.assert_allclose(found["responses"][0]["phase"], np.angle(exact), rtol=1e-12)
    rows = np.loadtxt(tmp_path / "response.csv", delimiter=",", skiprows=1)
    np.testing.assert_allclose(rows, np.column_stack([w, np.abs(exact), np.angle(exact)]), rtol=1e-12)


@pytest.mark.parametrize(
    "words, told",
    [
        ([], "required: --input, --frequencies"),
        (["--input", "hub.theta", "--frequencies", "5:1"], "rising"),
        (["--input", "hub.theta", "--frequencies", "1:5", "--points", "1"], "at least 2"),
        (["--input", "hub.phi", "--frequencies", "1:5"], "no input 'hub.phi'"),
    ],
)
def test_wrong_words(words: list[str], told: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["response", "hub_beam", *words]) == 2
    assert told in capsys.readouterr().err
