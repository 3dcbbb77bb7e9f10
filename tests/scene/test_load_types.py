"""The records of the load types: a type is one file, and works from a scene file to a film."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from symgen.loads import LOADS
from symgen.scene import Scene

ROOT = Path(__file__).resolve().parents[2]
USE = """
import sys
import numpy as np
from runtime import load_model, simulate
from runtime.views.film import film
from symgen.generate import generate
from symgen.scene import Scene, SceneRecord

folder, ends = sys.argv[1], []
for space in ("planar", "spatial"):
    scene = SceneRecord.from_toml(f"{folder}/{space}.toml")
    assert "Drag force over speed squared [N s^2/m^2]; not negative." in Scene.drag.__doc__
    found = simulate(load_model(generate(scene, f"{folder}/{space}")), t_end=2.0, dt=1e-3, scheme="rk4")
    assert found.status.name == "completed", found.status
    ends.append(found["ball.y_dot"])
    assert film(found, frames=3)
fall = -np.sqrt(9.81 * 2.0 / 0.7) * np.tanh(np.sqrt(9.81 * 0.7 / 2.0) * found.t)
assert np.abs(np.array(ends) - fall).max() < 1e-8, np.abs(np.array(ends) - fall).max()
"""
SCENE = """
name = "falling"
space = "{space}"
gravity = [0.0, -9.81]
bodies = [{{ type = "rigid", name = "ball", mass = 2.0, inertia = {inertia}, free = true }}]
[[loads]]
type = "drag"
name = "air"
marker = "ball.origin"
coefficient = 0.7
"""


@pytest.mark.parametrize("kind", LOADS)
def test_every_load_type_has_a_method_of_the_builder(kind: str) -> None:
    assert callable(getattr(Scene, kind))


@pytest.mark.long
def test_a_load_is_one_file(tmp_path: Path) -> None:
    """The page's load in a copy of the package: a ball falls as tanh, in the plane and in space."""
    shutil.copytree(ROOT / "symgen", tmp_path / "symgen", ignore=shutil.ignore_patterns("__pycache__"))
    page = (ROOT / "docs" / "inside" / "add-a-load.md").read_text(encoding="utf-8")
    (code,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    (tmp_path / "symgen" / "loads" / "drag.py").write_text(code, encoding="utf-8")
    for space, inertia in (("planar", "0.1"), ("spatial", "[0.1, 0.1, 0.1]")):
        (tmp_path / f"{space}.toml").write_text(SCENE.format(space=space, inertia=inertia), encoding="utf-8")
    (tmp_path / "use.py").write_text(USE, encoding="utf-8")
    command = [sys.executable, str(tmp_path / "use.py"), str(tmp_path)]
    found = subprocess.run(
        command, capture_output=True, text=True, cwd=tmp_path, env={**os.environ, "PYTHONPATH": f"{tmp_path}:{ROOT}"}
    )
    assert found.returncode == 0, found.stderr
