"""Jacobians of planar mechanisms whose masses depend on pairs of coordinates, against elimination."""

from __future__ import annotations

import pytest

from symgen.scene import Scene, SceneRecord
from symgen.scenes.pendulums import chain
from tests.support.jacobian_forms import assert_equal_forms, values_of_forms


def branched() -> SceneRecord:
    """A cart with two arms, one of them carrying a third: masses beside the hinges' lines, dampers, a spring."""
    builder = Scene("branched").gravity(0.4, -9.81)
    builder.rigid(
        "cart", mass=2.0, inertia=0.1, markers={"left": {"position": (-0.3, 0.1)}, "right": {"position": (0.4, 0)}}
    )
    for name, mass in (("a", 1.0), ("b", 0.7), ("c", 0.4)):
        markers = {"start": {"position": (-0.1, 0.05)}, "end": {"position": (0.5, 0.2)}}
        builder.rigid(name, mass=mass, inertia=0.02, center_of_mass=(0.2, -0.1), markers=markers)
    builder.prismatic("slide", "ground.origin", "cart.origin", damping=0.3)
    builder.revolute("A", "cart.left", "a.start", damping=0.2).revolute("B", "cart.right", "b.start")
    builder.revolute("C", "b.end", "c.start", damping=0.1)
    builder.initial({"cart.x": 0.2, "a.theta": 0.4, "b.theta": -0.9, "c.theta": 1.3})
    builder.rates({"cart.x": 0.7, "a.theta": -1.1, "b.theta": 0.6, "c.theta": 1.7})
    return builder.spring_damper("stay", "ground.origin", "c.end", stiffness=30.0, free_length=0.5, damping=0.4).build()


@pytest.mark.parametrize(("scene", "at_start"), [(chain(4), False), (branched(), True)], ids=["chain", "branched"])
def test_pairs_give_the_jacobians_of_elimination(
    scene: SceneRecord, at_start: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert_equal_forms(values_of_forms(scene, monkeypatch, at_start))
