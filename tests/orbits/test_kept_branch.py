"""A continuation that was interrupted goes on from its last point; points tell how far they are off."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from runtime import ArgumentError, Model, periodic, periodic_over
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
HOW = {"speed": "omega", "steps": 60, "scheme": "rk4"}
SPAN = (0.5, 1.0)


@pytest.fixture(scope="module")
def duffing(model_of: Build) -> Model:
    builder = Scene("bent").parameter("omega", 0.5).rigid("mass", mass=1.0, inertia=1.0)
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    builder.force("f", "mass.origin", "-0.2*x_dot-x-x*x*x+0.3*cos(omega*t)", 0.0)
    return model_of(builder.simulation(t_end=10.0, dt=1e-2, scheme="rk4").build())


def test_an_interrupted_branch_goes_on_from_its_folder(duffing: Model, tmp_path: Path) -> None:
    def stop(value: float, end: float) -> None:
        if value > 0.7:
            raise KeyboardInterrupt

    part = periodic_over(duffing, "omega", SPAN, resume=tmp_path, progress=stop, **HOW)
    assert part.stopped == "interrupted" and part.values[-1] > 0.7
    began: list[float] = []
    rest = periodic_over(duffing, "omega", SPAN, resume=tmp_path, progress=lambda at, _: began.append(at), **HOW)
    assert began[0] == part.values[-1] and not rest.stopped and rest.values[-1] == SPAN[1]
    assert rest.values[: len(part.points)] == pytest.approx(part.values, abs=0)
    assert rest.multipliers[: len(part.points)] == pytest.approx(part.multipliers, abs=1e-12)
    whole = periodic_over(duffing, "omega", SPAN, **HOW)
    assert rest.points[-1].x == pytest.approx(whole.points[-1].x, abs=1e-9)
    again = periodic_over(duffing, "omega", SPAN, resume=tmp_path, progress=lambda at, _: began.append(-at), **HOW)
    assert min(began) > 0 and again.values == pytest.approx(rest.values, abs=0)
    with pytest.raises(ArgumentError, match="holds the branch of another"):
        periodic_over(duffing, "omega", (0.5, 0.9), resume=tmp_path, **HOW)
    (tmp_path / "branch.npz").write_bytes(b"half a file")
    with pytest.raises(ArgumentError, match="cannot be read"):
        periodic_over(duffing, "omega", SPAN, resume=tmp_path, **HOW)


def test_points_of_a_branch_tell_their_own_error(duffing: Model) -> None:
    """Against the motions of 2,000 steps a period at the same values, whose errors are 1e4 times as small."""
    how = {**HOW, "steps": 200}
    branch = periodic_over(duffing, "omega", SPAN, **how)
    for k in range(0, len(branch.points), 3):
        point = branch.points[k]
        near = {"parameters": {"omega": point.value}, "start": branch.motion(k), "speed": "omega"}
        fine = periodic(duffing, steps=2000, scheme="rk4", **near)
        off = abs(point.x[0, 0] - fine.x[0]) / point.conditions.scale[0]
        assert off / 3 < point.error < 3 * off
        coarse = periodic(duffing, **how, parameters={"omega": point.value}, start=fine)
        assert point.floquet.margin == pytest.approx(coarse.floquet.margin, rel=0.2, abs=1e-8)
    assert branch.errors.max() > 1.2 * branch.errors.min()  # each has its own
