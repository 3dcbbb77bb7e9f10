"""What a type checker sees of a user's file: methods with their signatures, what they give, and misspelt keywords."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

pytestmark = [
    pytest.mark.long,
    pytest.mark.skipif(find_spec("mypy") is None, reason="needs the extra dev: pip install 'symgen[dev]'"),
]

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = """
from runtime import load_model
from symgen import Scene

model = Scene("arm").gravity(0, -9.81).model()
reveal_type(model)  # runtime.model.Model
reveal_type(load_model("arm"))  # runtime.model.Model
reveal_type(model.simulate)  # tolerance: float | None =
reveal_type(model.simulate)  # t_end: float | None =
run = model.simulate(t_end=5.0, tolerance=1e-3)
reveal_type(run)  # Solution
reveal_type(run.plot)  # names: str | typing.Sequence[str] | None =
reveal_type(run.plot("run.png"))  # Figure
reveal_type(run["rod.theta"])  # ndarray
reveal_type(model.modes(model.equilibrium()))  # ModeTable
reveal_type(model.with_inputs({"push": 1.0}))  # runtime.model.Model
reveal_type(model.stepper(dt=1e-3))  # ModelStepper
reveal_type(model.mass_matrix([0.0]))  # ndarray
reveal_type(model.periodic(period=1.0))  # PeriodicMotion
Scene("arm").revolute("hinge", "ground.origin", "rod.origin", damping=0.1, limits={"lower": 0.0})
Scene("arm").rigid("rod", 1.0, "m * l**2", free=True).force("push", "rod.origin", 1.0, "sin(t)").stiff("rod.q")
reveal_type(Scene("arm").rigid)  # inertia: float | str
reveal_type(Scene("arm").weld("clamp", "ground.origin", "rod.origin"))  # Scene
Scene("arm").rigid("rod", 1.0, 0.1, mas=2.0)  # error: Unexpected keyword argument "mas"
Scene("arm").rigid("rod", 1.0)  # error: Missing positional argument "inertia"
Scene("arm").revolut("hinge", "ground.origin", "rod.origin")  # error: "Scene" has no attribute "revolut"
model.simulate(tend=5.0)  # error: Unexpected keyword argument "tend"
model.simulate(t_end=5.0, tolerence=1e-3)  # error: Unexpected keyword argument "tolerence"
model.simulate(t_end="5")  # error: Argument "t_end"
model.stepper(step=1e-3)  # error: Unexpected keyword argument "step"
run.plot(pth="run.png")  # error: Unexpected keyword argument "pth"
model.simulat()  # error: "Model" has no attribute "simulat"
"""


@pytest.fixture(scope="module")
def seen(tmp_path_factory: pytest.TempPathFactory) -> dict[int, str]:
    """What mypy says of each line of the program, without this project's settings."""
    folder = tmp_path_factory.mktemp("user")
    (folder / "program.py").write_text(PROGRAM)
    words = ["-m", "mypy", "--config-file=", "--ignore-missing-imports", "--follow-imports=silent", "program.py"]
    environment = {**os.environ, "MYPYPATH": str(ROOT)}
    done = subprocess.run([sys.executable, *words], cwd=folder, capture_output=True, text=True, env=environment)
    assert done.returncode == 1, done.stdout + done.stderr
    found: dict[int, str] = {}
    for line in done.stdout.splitlines()[:-1]:
        place, number, text = line.split(":", 2)
        assert place == "program.py", line
        found[int(number)] = found.get(int(number), "") + text
    return found


LINES = {k: line.partition("  # ")[2] for k, line in enumerate(PROGRAM.splitlines(), 1) if "  # " in line}


@pytest.mark.parametrize("line", LINES, ids=lambda line: PROGRAM.splitlines()[line - 1].partition("  # ")[0])
def test_a_type_checker_sees(line: int, seen: dict[int, str]) -> None:
    assert LINES[line] in seen[line]


def test_a_type_checker_says_nothing_else(seen: dict[int, str]) -> None:
    assert set(seen) == set(LINES)
