"""Efforts on coordinates of joints: their definition, and the torques and pairs of forces that they stand for."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime.model import Model
from symgen.scene import Scene, SceneError, SceneRecord
from tests.support.model_values import evaluate, random_states

Build = Callable[[SceneRecord], Model]
VALUE = "3 + t - 0.5*swing_dot"
COORDINATES = ["revolute.angle", "prismatic.travel", "cylindrical.travel", "universal.angle2", "planar.y"]


def links(space: str, kind: str) -> Scene:
    """A hinged link with a second one on it by a joint of some kind."""
    three, inertia = ((0.1,), [0.3, 0.5, 0.4]) if space == "spatial" else ((), 0.4)
    tip: dict[str, Any] = {"position": (0.4, 0.2, *three)}
    tip |= {"axis": (0.3, 1.0, 0.2), "x_axis": (1.0, 0.0, 0.0)} if space == "spatial" else {"angle": 0.3}
    builder = Scene("links", space=space).gravity(0.0, -9.81)
    builder.rigid("a", mass=2.0, inertia=inertia, center_of_mass=(0.2, 0.1, *three), markers={"tip": tip})
    builder.rigid("b", mass=1.5, inertia=inertia, center_of_mass=(0.3, -0.1, *three), markers={"tip": tip})
    builder.revolute("hinge", "ground.origin", "a.origin").joint(kind, "j", "a.tip", "b.tip")
    return builder.measure("swing", "angle", "a.origin").simulation(t_end=0.1, dt=1e-3, scheme="rk4")


def jack(space: str) -> Scene:
    """A lever that the rod of a hydraulic jack turns; in space the slide of the jack closes the loop."""
    three, inertia = ((0.0,), [0.3, 0.5, 0.4]) if space == "spatial" else ((), 0.4)
    along = {"axis": (1.0, 0.0, 0.0)} if space == "spatial" else {}
    tip = {"position": (0.5, 0.0, *three)}
    slide = {"position": (0.0, 0.0, *three), **along}
    builder = Scene("jack", space=space).ground(markers={"foot": {"position": (0.6, 0.0, *three)}})
    builder.rigid("lever", mass=2.0, inertia=inertia, center_of_mass=(0.2, 0.1, *three), markers={"tip": tip})
    builder.rigid("barrel", mass=1.0, inertia=inertia, markers={"slide": slide})
    builder.rigid("rod", mass=1.5, inertia=inertia, markers={"slide": slide, "eye": slide | {"axis": (0.0, 0.0, 1.0)}}
                  if space == "spatial" else {"slide": slide})  # fmt: skip
    builder.revolute("pivot", "ground.origin", "lever.origin").revolute("foot", "ground.foot", "barrel.origin")
    builder.revolute("eye", "lever.tip", "rod.origin").prismatic("jack", "barrel.slide", "rod.slide")
    start = {"pivot.angle": 1.2} if space == "spatial" else {"lever.theta": 1.2, "barrel.theta": 2.1, "rod.theta": 2.1}
    builder.measure("swing", "angle", "lever.origin").initial(start)
    return builder.simulation(t_end=0.1, dt=1e-3, scheme="rk4")


def forces(model: Model) -> list[np.ndarray]:
    return [evaluate(model, "condensed", **state.values())["Q_hat"] for state in random_states(model, 3, rigid=0.1)]


@pytest.mark.long
@pytest.mark.parametrize("coordinate", COORDINATES)
def test_in_space_it_is_the_force_on_that_coordinate(model_of: Build, coordinate: str) -> None:
    """Q_hat rises by the value in the row of the coordinate and in no other; the power is the value times its rate."""
    kind, _, part = coordinate.partition(".")
    bare = model_of(links("spatial", kind).build())
    driven = model_of(links("spatial", kind).effort("motor", f"j.{part}", 2.5).build())
    expected = [2.5 if name == f"j.{part}" else 0.0 for name in driven.q_i]
    for one, other in zip(forces(bare), forces(driven), strict=True):
        assert other - one == pytest.approx(expected, abs=1e-12)
    for state in random_states(driven, 3):
        power = evaluate(driven, "energy", **state.values())["power_applied"]
        assert power == pytest.approx(2.5 * state.q_dot[driven.coordinates.index(f"j.{part}")])


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_on_a_hinge_it_is_a_torque_with_its_reaction(model_of: Build, space: str) -> None:
    plain = links(space, "revolute").torque("motor", "b.tip", VALUE, reaction="a.tip").build()
    own = links(space, "revolute").effort("motor", "j.angle", VALUE).build()
    for one, other in zip(forces(model_of(plain)), forces(model_of(own)), strict=True):
        assert other == pytest.approx(one, rel=1e-12, abs=1e-12)


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_on_the_slide_of_a_jack_it_is_two_forces(model_of: Build, space: str) -> None:
    """F along the slide on the rod, -F on the barrel."""
    push = (0.0, 0.0, VALUE) if space == "spatial" else (VALUE, 0.0)
    pull = tuple(f"-({part})" if part else part for part in push)
    plain = jack(space).force("on_rod", "rod.slide", *push, frame="body")
    plain.force("on_barrel", "barrel.slide", *pull, frame="body")
    own = jack(space).effort("motor", "jack.travel", VALUE)
    assert model_of(own.build()).loop_unknowns
    for one, other in zip(forces(model_of(plain.build())), forces(model_of(own.build())), strict=True):
        assert other == pytest.approx(one, rel=1e-10, abs=1e-10)


@pytest.mark.parametrize(
    ("coordinate", "problem"),
    [
        ("elbow.angle", "there is no joint 'elbow'"),
        ("j.travel", "the revolute joint 'j' has no coordinate 'travel' here"),
        ("j", "has no coordinate ''"),
    ],
)
def test_what_no_joint_has_is_refused(coordinate: str, problem: str) -> None:
    with pytest.raises(SceneError, match=problem):
        links("spatial", "revolute").effort("motor", coordinate, 1.0).build()
