"""Tables of two values: surfaces over a grid in expressions, from arrays and from files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.interpolate import CubicSpline, RegularGridInterpolator

from runtime import simulate
from runtime.contract.tape import read_tape
from runtime.model import Model
from symgen.scene import Scene, SceneError, SceneRecord, SurfaceTable

Build = Callable[[SceneRecord], Model]
X = np.array([-1.3, -0.2, 0.1, 0.9, 1.4, 2.2])
Y = np.array([0.0, 0.5, 2.0, 3.0])
Z = np.array([[np.sin(2 * x) + x * y - 0.3 * y**2 for y in Y] for x in X])
RANDOM = np.random.default_rng(5)


def surface(interpolation: Any) -> SurfaceTable:
    return SurfaceTable(x=tuple(X), y=tuple(Y), z=tuple(map(tuple, Z)), interpolation=interpolation)


def reference(interpolation: str, x: float, y: float) -> float:
    """SciPy: lines along both, or the natural spline along y of natural splines along x."""
    if interpolation == "linear":
        return float(RegularGridInterpolator((X, Y), Z)((x, y)))
    along_x = CubicSpline(X, Z, axis=0, bc_type="natural")(x)
    return float(CubicSpline(Y, along_x, bc_type="natural")(y))


@pytest.mark.parametrize("interpolation", ["linear", "cubic"])
def test_values_and_slopes(interpolation: Any) -> None:
    """Against SciPy, on the grid, between and outside; slopes against differences."""
    one = surface(interpolation)
    s = ca.SX.sym("s", 2)
    z = one.symbol(s[0], s[1])
    function = ca.Function("z", [s], [z, ca.jacobian(z, s)])
    grid = [(x, y) for x in X for y in Y]
    for x, y in [*grid, *RANDOM.uniform((-2, -1), (3, 4), (60, 2))]:
        inside = np.clip(x, X[0], X[-1]), np.clip(y, Y[0], Y[-1])
        expected = reference(interpolation, *inside)
        value, slope = (np.asarray(part).ravel() for part in function([x, y]))
        assert abs(value[0] - expected) < 1e-13
        if min(np.abs(x - X).min(), np.abs(y - Y).min()) > 1e-4:
            h = 1e-6
            by_x = float((function([x + h, y])[0] - function([x - h, y])[0]) / (2 * h))
            by_y = float((function([x, y + h])[0] - function([x, y - h])[0]) / (2 * h))
            np.testing.assert_allclose(slope, [by_x, by_y], atol=1e-8)


def test_the_price_does_not_depend_on_the_size() -> None:
    """100 x 100 values cost the operations of 4 x 4."""

    def price(n: int) -> int:
        points = tuple(np.linspace(0.0, 1.0, n))
        one = SurfaceTable(x=points, y=points, z=tuple(tuple(RANDOM.normal(size=n)) for _ in range(n)))
        s = ca.SX.sym("s", 2)
        return sum(node.op != ca.OP_CONST for node in read_tape(ca.Function("z", [s], [one.symbol(s[0], s[1])])).nodes)

    assert price(100) == price(4) <= 30


def motor(**table: Any) -> Scene:
    """A shaft with a motor whose torque follows from its speed and from a throttle."""
    return (
        Scene("motor")
        .input("throttle", 0.5)
        .table("torque", **table)
        .rigid("shaft", mass=1.0, inertia=0.2)
        .revolute("bearing", "ground.origin", "shaft.origin")
        .measure("angle", "angle", "shaft.origin")
        .torque("drive", "shaft.origin", 'table("torque", angle_dot, throttle)')
        .simulation(t_end=1.0, dt=1e-3, scheme="rk4")
    )


@pytest.mark.long
def test_a_motor_runs_up_by_its_map(model_of: Build) -> None:
    """Torque throttle (8 - speed): the speed nears 8 rad/s, 8 (1 - exp(-throttle t / J)); bilinear, so exact."""
    speeds, throttles = np.array([-5.0, 0.0, 3.0, 20.0]), np.array([0.0, 0.4, 1.0])
    model = model_of(motor(x=speeds, y=throttles, z=np.outer(8 - speeds, throttles)).build())
    for throttle in (0.5, 0.9):
        run = simulate(model, inputs={"throttle": throttle})
        expected = 8 * (1 - np.exp(-throttle * run.t / 0.2))
        np.testing.assert_allclose(run["shaft.theta_dot"], expected, atol=1e-9)
        compiled, plain = run["shaft.theta"], simulate(model, inputs={"throttle": throttle}, engine="interpreted")
        np.testing.assert_allclose(compiled, plain["shaft.theta"], rtol=1e-13, atol=1e-14)


def test_scenes_hold_it_and_files_give_it(tmp_path: Path) -> None:
    """TOML there and back; a CSV of the grid, its corner empty or not."""
    scene = motor(x=X, y=Y, z=Z, interpolation="cubic").build()
    assert SceneRecord.from_toml_text(scene.to_toml()) == scene
    for corner in ("0", ""):
        rows = [
            [corner, *map(repr, Y.tolist())],
            *([repr(float(x)), *map(repr, z.tolist())] for x, z in zip(X, Z, strict=True)),
        ]
        (tmp_path / "map.csv").write_text("\n".join("; ".join(row) for row in rows))
        assert motor(file=tmp_path / "map.csv", columns="grid", interpolation="cubic").build() == scene


@pytest.mark.parametrize(
    "table, words",
    [
        ({"x": [0, 1], "y": [0, 1, 2], "z": [[0, 1], [2, 3]]}, "tables.torque: its z has 2 rows of 2 values"),
        ({"x": [0, 1], "y": [0, 0], "z": [[0, 1], [2, 3]]}, "tables.torque: its y do not rise"),
        ({"x": [0], "y": [0, 1], "z": [[0, 1]]}, "it has 1 x"),
        ({"x": [0, 1], "y": [0, 1], "z": [[0, 1], [2, np.inf]]}, "tables.torque.z.*finite"),
        ({"x": [0, 1], "y": [0, 1], "z": [[0, 1], [2, 3]], "interpolation": "monotone"}, "tables.torque.interpolation"),
        ({"x": [0, 1], "y": [0, 1]}, "the table 'torque' takes 1 value"),
    ],
)
def test_what_is_no_surface_is_refused(table: dict[str, Any], words: str) -> None:
    with pytest.raises(SceneError, match=words):
        motor(**table).build()


@pytest.mark.parametrize(
    "text, words",
    [("0; 1; 2\n0; 1; 2; 3\n1; 1\n", "is not a grid"), ("speed; 0; 1\n0; 1; 2\n1; 2; 3\n", "line 1 is not")],
)
def test_a_grid_that_is_none_is_refused(tmp_path: Path, text: str, words: str) -> None:
    (tmp_path / "map.csv").write_text(text)
    with pytest.raises(SceneError, match=words):
        motor(file=tmp_path / "map.csv", columns="grid")
