"""Forces along a line: against a spring-damper, a hand-derived oscillator and the balance of energy."""

from __future__ import annotations

import numpy as np
import pytest

from runtime import simulate
from symgen.generate import model_of
from symgen.scene import Scene


def swing(space: str, kind: str) -> Scene:
    """Two links with a strut between them, as a spring-damper or as a line that says the same."""
    flat = space == "planar"

    def at(*place: float) -> dict[str, object]:
        return {"position": list(place) if flat else [place[0], place[1], 0.1]}

    builder = Scene("swing", space=space).gravity(0.0, -9.81).ground(markers={"foot": at(-0.2, 0.3)})
    for name in ("one", "two"):
        inertia = 0.1 if flat else [0.02, 0.1, 0.1]
        marks = {"end": {"position": [0.5, 0.0][:2] if flat else [0.5, 0.0, 0.0]}, "lug": at(0.3, 0.05)}
        center = [0.25, 0.0] if flat else [0.25, 0.0, 0.0]
        builder.rigid(name, mass=1.0, inertia=inertia, center_of_mass=center, markers=marks)
    builder.revolute("a", "ground.origin", "one.origin").revolute("b", "one.end", "two.origin")
    if kind == "spring_damper":
        builder.spring_damper("strut", "one.lug", "two.lug", stiffness=200.0, damping=3.0, free_length=0.4)
    else:
        builder.line("strut", "one.lug", "two.lug", "200*(length - 0.4) + 3*rate")
    return builder


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_a_line_does_what_a_spring_damper_does(space: str) -> None:
    runs = [
        simulate(model_of(swing(space, kind).build()), t_end=1.0, dt=1e-3, scheme="rk4")
        for kind in ("spring_damper", "line")
    ]
    names = ("one.theta", "two.theta") if space == "planar" else ("a.angle", "b.angle")
    for name in names:
        assert runs[1][name] == pytest.approx(runs[0][name], abs=1e-10)
    assert runs[1].load_force("strut") == pytest.approx(runs[0].load_force("strut"), abs=1e-8)
    assert np.abs(runs[1].balance.error).max() < 1e-6


def test_a_line_by_a_table_pulls_where_it_is_positive() -> None:
    """A mass on a rope by a table that is linear in the length where it is stretched: cos, then free flight."""
    builder = Scene("rope").ground(markers={"far": {"position": [-2.0, 0.0], "angle": 0.0}})
    builder.table("rope", x=[0.0, 1.0, 3.0], y=[0.0, 0.0, 50.0]).rigid("ball", mass=1.0, inertia=1.0)
    builder.prismatic("rail", "ground.far", "ball.origin").line(
        "pull", "ground.far", "ball.origin", 'table("rope", length)'
    )
    builder.initial({"ball.x": 0.0})
    run = simulate(model_of(builder.build()), t_end=0.3, dt=1e-3, scheme="rk4")
    assert run["ball.x"] == pytest.approx(-1.0 + np.cos(5.0 * run.t), abs=1e-9)
