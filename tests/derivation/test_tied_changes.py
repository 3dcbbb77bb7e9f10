"""Residual Jacobians of spherical loops along directions, against the ones with each dependent coordinate taken out."""

from __future__ import annotations

import numpy as np
import pytest

from symgen.scene import Scene, SceneRecord
from symgen.scenes import SCENES
from tests.derivation.test_force_changes import bent_chain
from tests.support.jacobian_forms import assert_equal_forms, values_of_forms


def twice_tied() -> SceneRecord:
    """Three rigid bodies on universal joints, the last one tied to the ground and to a body that slides there."""
    builder, rng = Scene("tied", space="spatial").gravity(0.3, 0.5, -9.81), np.random.default_rng(2)
    builder.ground(markers={"near": {"position": [1.5, 0.2, 0.1]}})
    for k in range(4):
        ends = {name: {"position": rng.normal(size=3), "axis": rng.normal(size=3)} for name in ("start", "end", "side")}
        data = {"mass": 1.0 + k, "inertia": [0.2, 0.3, 0.4], "center_of_mass": rng.normal(size=3)}
        builder.rigid(f"link{k}", **data, markers=ends)
        near = f"link{k - 1}.end" if 0 < k < 3 else "ground.origin"
        builder.joint("universal" if k < 3 else "planar", f"joint{k}", near, f"link{k}.start")
    builder.spherical("first", "ground.near", "link2.end").spherical("second", "link2.side", "link3.end")
    return builder.build()


@pytest.mark.long
def test_directions_give_the_jacobians_of_elimination(monkeypatch: pytest.MonkeyPatch) -> None:
    """At random positions and rates: the forms are equal whether or not these close the loops."""
    assert_equal_forms(values_of_forms(twice_tied(), monkeypatch))


def on_a_turntable() -> SceneRecord:
    """Two rigid bodies on universal joints, the second tied to the turning body that carries the first."""
    builder, rng = Scene("turntable", space="spatial").gravity(0.3, 0.5, -9.81), np.random.default_rng(4)
    for name in ("table", "near", "far"):
        ends = {end: {"position": rng.normal(size=3), "axis": rng.normal(size=3)} for end in ("start", "end", "side")}
        builder.rigid(name, mass=1.0, inertia=[0.2, 0.3, 0.4], center_of_mass=rng.normal(size=3), markers=ends)
    builder.revolute("pivot", "ground.origin", "table.start")
    builder.universal("first", "table.end", "near.start").universal("second", "near.end", "far.start")
    builder.spherical("tie", "far.end", "table.side").rates({"pivot.angle": 2.0, "first.angle1": 1.0})
    return builder.build()


@pytest.mark.every_push("turntable", "bricard")
@pytest.mark.parametrize(
    ("scene", "at_start"),
    [
        (on_a_turntable(), True),
        (bent_chain(("universal", "revolute"), "spherical"), False),
        (SCENES["bricard"](), False),
        (SCENES["flexible_four_bar"](), True),
    ],
    ids=["turntable", "bent chain", "bricard", "in the plane"],
)
def test_changes_along_directions(scene: SceneRecord, at_start: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of loops, one of them seen from a turning body that carries it: the Jacobians are those of elimination."""
    assert_equal_forms(values_of_forms(scene, monkeypatch, at_start))
