"""The records of the joint types: what each says in several ways says the same."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from runtime import simulate
from runtime.model import Model
from symgen.algebra.scalar import ZERO
from symgen.joints import JOINTS
from symgen.scene import Scene, SceneError, SceneRecord
from symgen.system.joint_templates import JointCoordinate, JointCoordinates

PLACING = [name for name, joint in JOINTS.items() if joint.motions]


@pytest.mark.parametrize("kind", JOINTS)
def test_a_joint_type_places_a_body_or_closes_a_loop(kind: str) -> None:
    joint = JOINTS[kind]
    assert joint.motions is not None or joint.closes_loops()
    assert callable(getattr(Scene, kind))


@pytest.mark.parametrize("kind", PLACING)
def test_the_motion_subspace_is_the_rate_of_the_travel(kind: str) -> None:
    """Rows, rates and the rest of the acceleration of point b, against differences along a motion."""
    motions = JOINTS[kind].motions or ()
    q, v = (ca.SX.sym(name, len(motions)) for name in "qv")
    leads = [ca.SX(0.3) if motion.lead else ZERO for motion in motions]
    own = JointCoordinates(motions, [JointCoordinate(q[k], v[k], k) for k in range(len(motions))], leads)
    travel = own.travel()
    rows = [[row.get(k, ZERO) for k in range(len(motions))] for row in travel.rows]
    found = ca.Function("travel", [q, v], [ca.vertcat(*part) for part in (travel.value, travel.rate, travel.bias)])
    rng, h = np.random.default_rng(1), 1e-5
    at, rate = rng.normal(size=(2, len(motions)))
    ahead, behind = (np.array(found(at + s * h * rate, rate)).squeeze(-1) for s in (1.0, -1.0))
    value, speed, bias = np.array(found(at, rate)).squeeze(-1)
    assert speed == pytest.approx((ahead[0] - behind[0]) / (2 * h), abs=1e-9)
    assert bias == pytest.approx((ahead[1] - behind[1]) / (2 * h), abs=1e-9)
    slopes = ca.Function("rows", [q], [ca.vertcat(*(ca.horzcat(*row) for row in rows))])
    assert np.array(slopes(at)) @ rate == pytest.approx(speed)


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
    assert "Damping of the rotation [N m s/rad]; not negative." in Scene.pin_in_slot.__doc__
    found = simulate(load_model(generate(scene, f"{folder}/{space}")), t_end=0.4, dt=1e-3, scheme="rk4")
    assert found.status.name == "completed", found.status
    ends.append([found[name][-1] for name in ("rod.x", "rod.y", "way")])
    assert film(found, frames=3).line("slot", "slide").xy.shape == (3, 2, 1)
assert "slot.travel" in found.model.q_i and "slot.angle" in found.model.q_i
assert np.allclose(*ends, rtol=0, atol=1e-9) and abs(ends[0][2]) > 0.1, ends
"""
SCENE = """
name = "slotted"
space = "{space}"
gravity = [0.0, -9.81]
bodies = [{{ type = "rigid", name = "rod", mass = 2.0, inertia = {inertia}, center_of_mass = [0.3, 0.1] }}]
[[joints]]
type = "pin_in_slot"
name = "slot"
marker_a = "ground.origin"
marker_b = "rod.origin"
damping = 0.2
[[measures]]
type = "x"
name = "way"
of = "rod.origin"
[[loads]]
type = "force"
name = "push"
marker = "rod.center"
components = ["1 + 0.5*way", 0]
"""


@pytest.mark.long
def test_a_joint_is_one_file(tmp_path: Path) -> None:
    """The page's joint in a copy of the package, from TOML to a film, in the plane and in space: the same motion."""
    shutil.copytree(ROOT / "symgen", tmp_path / "symgen", ignore=shutil.ignore_patterns("__pycache__"))
    page = (ROOT / "docs" / "inside" / "add-a-joint.md").read_text(encoding="utf-8")
    (code,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    (tmp_path / "symgen" / "joints" / "pin_in_slot.py").write_text(code, encoding="utf-8")
    for space, inertia in (("planar", "0.1"), ("spatial", "[0.1, 0.1, 0.1]")):
        (tmp_path / f"{space}.toml").write_text(SCENE.format(space=space, inertia=inertia), encoding="utf-8")
    (tmp_path / "use.py").write_text(USE, encoding="utf-8")
    command = [sys.executable, str(tmp_path / "use.py"), str(tmp_path)]
    found = subprocess.run(
        command, capture_output=True, text=True, cwd=tmp_path, env={**os.environ, "PYTHONPATH": f"{tmp_path}:{ROOT}"}
    )
    assert found.returncode == 0, found.stderr


def gear(*ring: str) -> Scene:
    """Two shafts that drive one nut by screws of different leads; ring: a further screw between the shafts."""
    builder = Scene("gear", space="spatial").ground(markers={"second": {"position": [0.2, 0.0, 0.0]}})
    for name, spin in (("one", 0.2), ("two", 0.3)):
        builder.rigid(name, mass=1.0, inertia=[0.2, 0.2, spin])
    builder.rigid("nut", mass=0.5, inertia=[0.1, 0.1, 0.1], markers={"second": {"position": [0.2, 0.0, 0.0]}})
    builder.revolute("hinge1", "ground.origin", "one.origin").revolute("hinge2", "ground.second", "two.origin")
    builder.prismatic("guide", "ground.origin", "nut.origin")
    builder.screw("fine", "one.origin", "nut.origin", lead=0.1).screw("coarse", "two.origin", "nut.second", lead=0.25)
    for name in ring:
        builder.screw(name, "one.origin", "two.origin", lead=0.3)
    return builder.torque("motor", "one.origin", 1.0, reaction="ground.origin")


@pytest.mark.long
def test_two_screws_are_a_gear(model_of: Callable[[SceneRecord], Model]) -> None:
    """Turns go as the leads: the first shaft feels the second's inertia by the square of their ratio, and the nut's."""
    run = simulate(model_of(gear().build()), t_end=2.0, dt=2e-3, scheme="rk4")
    ratio, feed = 0.1 / 0.25, 0.1 / (2 * np.pi)
    turned = 2.0**2 / 2 / (0.2 + 0.3 * ratio**2 + 0.5 * feed**2)
    assert abs(run["fine.angle"][-1]) == pytest.approx(turned, rel=1e-10)
    assert abs(run["coarse.angle"][-1]) == pytest.approx(ratio * turned, rel=1e-10)
    assert abs(run["nut.z"][-1]) == pytest.approx(feed * turned, rel=1e-10)


def test_a_loop_of_screws_alone_is_refused() -> None:
    with pytest.raises(SceneError, match="closes a loop of such joints alone") as caught:
        gear("third").build()
    assert caught.value.item == "joints[5] 'third'"
