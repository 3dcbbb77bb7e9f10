"""Generated rigid mechanisms equal their hand-derived twins: pendulum, double pendulum, four-bar, slider-crank."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.hand_derived import twin_double_pendulum, twin_four_bar, twin_pendulum, twin_slider_crank
from tests.hand_derived.generated_comparison import compare

Build = Callable[[SceneRecord], Model]
TIMES = (0.0, 0.2, 0.5, 1.1)


def link(builder: Scene, name: str, mass: float, inertia: float, arm: float, tip: float) -> None:
    builder.rigid(name, mass=mass, inertia=inertia, center_of_mass=(arm, 0), markers={"tip": {"position": (tip, 0)}})


@pytest.mark.parametrize("c", [0.0, 0.3])
def test_pendulum(model_of: Build, c: float) -> None:
    p = twin_pendulum.Params(c=c)
    builder = Scene("twin_pendulum").gravity(0, -p.g)
    builder.rigid("rod", mass=p.m, inertia=p.Jc, center_of_mass=(p.a, 0))
    builder.revolute("hinge", "ground.origin", "rod.origin", damping=c)
    compare(model_of(builder.build()), twin_pendulum, p, 3.0, 4.0, TIMES)


@pytest.mark.parametrize("dampers", [(0.0, 0.0), (0.2, 0.1)])
def test_double_pendulum(model_of: Build, dampers: tuple[float, float]) -> None:
    p = twin_double_pendulum.Params(c1=dampers[0], c2=dampers[1])
    builder = Scene("twin_double_pendulum").gravity(0, -p.g)
    link(builder, "upper", p.m1, p.J1, p.a1, p.l1)
    link(builder, "lower", p.m2, p.J2, p.a2, 2 * p.a2)
    builder.revolute("shoulder", "ground.origin", "upper.origin", damping=p.c1)
    builder.revolute("elbow", "upper.tip", "lower.origin", damping=p.c2)
    compare(model_of(builder.build()), twin_double_pendulum, p, 3.0, 4.0, TIMES)


def test_four_bar(model_of: Build) -> None:
    p = twin_four_bar.Params(torque=0.3)
    builder = Scene("twin_four_bar").gravity(0, -p.g).ground(markers={"right": {"position": (p.d, 0)}})
    link(builder, "crank", p.m1, p.J1, p.a1, p.l1)
    link(builder, "coupler", p.m2, p.J2, p.a2, p.l2)
    link(builder, "rocker", p.m3, p.J3, p.a3, p.l3)
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "coupler.origin")
    builder.revolute("C", "coupler.tip", "rocker.tip").revolute("D", "ground.right", "rocker.origin")
    builder.torque("motor", "crank.origin", p.torque).independent("crank.theta")
    builder.initial({"crank.theta": 0.9, "coupler.theta": p.guess[0], "rocker.theta": p.guess[1]})
    compare(model_of(builder.build()), twin_four_bar, p, 3.0, 5.0, TIMES)


def test_slider_crank(model_of: Build) -> None:
    p = twin_slider_crank.Params(torque=0.2)
    builder = Scene("twin_slider_crank").gravity(0, -p.g)
    link(builder, "crank", p.m1, p.J1, p.a1, p.l1)
    link(builder, "rod", p.m2, p.J2, p.a2, p.l2)
    builder.rigid("slider", mass=p.m3, inertia=p.J3)
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.origin")
    builder.prismatic("slide", "ground.origin", "slider.origin").revolute("C", "rod.tip", "slider.origin")
    builder.torque("motor", "crank.origin", p.torque).independent("crank.theta")
    builder.initial({"crank.theta": 0.3, "rod.theta": -0.15})
    compare(model_of(builder.build()), twin_slider_crank, p, 3.0, 20.0, TIMES)
