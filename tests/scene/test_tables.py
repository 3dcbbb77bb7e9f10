"""Tables: curves through points in expressions, from arrays and from files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.interpolate import CubicSpline, PchipInterpolator

from runtime import DifferentiableRun, simulate
from runtime.model import Model
from symgen.scene import CurveTable, Scene, SceneError, SceneRecord

Build = Callable[[SceneRecord], Model]
X = np.array([-1.3, -0.2, 0.1, 0.9, 1.4, 2.2])
Y = np.array([0.5, -0.7, 0.0, 1.1, 1.2, -0.4])


def pushed(force: str, **table: Any) -> SceneRecord:
    """1 kg on a rail under a force from the table `curve` over its way."""
    return (
        Scene("pushed")
        .table("curve", **table)
        .rigid("cart", mass=1.0, inertia=0.1)
        .prismatic("rail", "ground.origin", "cart.origin")
        .measure("way", "x", "cart.origin")
        .force("push", "cart.origin", force, 0.0)
        .initial({"cart.x": 0.1})
        .simulation(t_end=1.0, dt=1e-3, scheme="rk4")
        .build()
    )


def reference(interpolation: str, outside: str) -> Callable[[np.ndarray], np.ndarray]:
    """NumPy's lines, SciPy's natural spline and its monotone pieces; straight on from the ends, or held."""
    spline = PchipInterpolator(X, Y) if interpolation == "monotone" else CubicSpline(X, Y, bc_type="natural")

    def value(x: np.ndarray) -> np.ndarray:
        inside = np.clip(x, X[0], X[-1])
        if interpolation == "linear":
            y, ends = np.interp(x, X, Y), ((Y[1] - Y[0]) / (X[1] - X[0]), (Y[-1] - Y[-2]) / (X[-1] - X[-2]))
        else:
            y, ends = spline(inside), (spline(X[0], 1), spline(X[-1], 1))
        further = np.where(x < X[0], ends[0], ends[1]) * (x - inside)
        return np.asarray(y + further * (outside == "extend"))

    return value


@pytest.mark.parametrize("outside", ["hold", "extend"])
@pytest.mark.parametrize("interpolation", ["linear", "cubic", "monotone"])
def test_values_and_slopes(interpolation: Any, outside: Any) -> None:
    """Against NumPy and SciPy, everywhere; the slope against central differences."""
    expected, x = reference(interpolation, outside), np.sort(np.append(np.linspace(-3, 4, 57), X))
    table = CurveTable(x=tuple(X), y=tuple(Y), interpolation=interpolation, outside=outside)
    s = ca.SX.sym("s")
    y = table.curve.function()(s)
    value, slope = ca.Function("y", [s], [y, ca.jacobian(y, s)])(x[None, :])
    np.testing.assert_allclose(np.asarray(value).ravel(), expected(x), atol=1e-14)
    apart = np.abs(x[:, None] - X).min(axis=1) > 1e-3
    difference = (expected(x + 1e-5) - expected(x - 1e-5)) / 2e-5
    np.testing.assert_allclose(np.asarray(slope).ravel()[apart], difference[apart], atol=1e-8)


@pytest.mark.parametrize("kind, scipy", [("cubic", CubicSpline), ("monotone", PchipInterpolator)])
@pytest.mark.parametrize("points", [2, 3, 100_000])
def test_few_and_many_points_equal_scipy(kind: Any, scipy: Any, points: int) -> None:
    """Wild data on a scattered grid: value, slope and second derivative."""
    random = np.random.default_rng(points)
    x = np.cumsum(random.uniform(0.5, 1.5, points))
    y = random.normal(size=points)
    table = CurveTable(x=tuple(x), y=tuple(y), interpolation=kind)
    expected = scipy(x, y, bc_type="natural") if kind == "cubic" else scipy(x, y)
    at = random.uniform(x[0], x[-1], 1000)
    for order in range(3):
        np.testing.assert_allclose(table.curve(at, order), expected(at, order), rtol=1e-12, atol=1e-12)


def test_a_cart_follows_the_table(model_of: Build) -> None:
    """The force of a run is the table at its way."""
    model = model_of(pushed('table("curve", way)', x=X, y=Y, interpolation="cubic"))
    run = simulate(model)
    np.testing.assert_allclose(run["cart.x_ddot"], reference("cubic", "hold")(run["cart.x"]), atol=1e-13)


def test_a_spring_with_two_rates_has_the_exact_period(model_of: Build) -> None:
    """100 N/m one way, 400 N/m the other: after pi / 10 + pi / 20 s it is back, at rest."""
    model = model_of(pushed('table("curve", way)', x=[-1, 0, 1], y=[400.0, 0.0, -100.0], outside="extend"))
    period = np.pi / 10 + np.pi / 20
    run = simulate(model, t_end=period, dt=period / 4000)
    np.testing.assert_allclose([run["cart.x"][-1], run["cart.x_dot"][-1]], [0.1, 0.0], atol=2e-7)
    np.testing.assert_allclose(run["cart.x"].min(), -0.05, atol=1e-7)


@pytest.mark.every_push("cubic")
@pytest.mark.parametrize("interpolation", ["linear", "cubic"])
def test_derivatives_by_a_point_of_a_table(model_of: Build, interpolation: str) -> None:
    """A curve through points is linear in their y: a table that is one at a point and zero at the others, times a
    parameter, moves that point. Against runs of scenes whose point is moved."""

    def scene(y: np.ndarray, point: bool) -> SceneRecord:
        builder = Scene("pushed").table("curve", x=X, y=y, interpolation=interpolation)
        builder.table("unit", x=X, y=np.eye(len(X))[2], interpolation=interpolation).parameter("moved", 0.0)
        builder.rigid("cart", mass=1.0, inertia=0.1).prismatic("rail", "ground.origin", "cart.origin")
        more = ' + moved * table("unit", way)' if point else ""
        builder.measure("way", "x", "cart.origin").force("push", "cart.origin", f'table("curve", way){more}', 0.0)
        return builder.initial({"cart.x": 0.15}).build()

    at = {"t_end": 0.5, "dt": 5e-3, "scheme": "rk4"}
    run = DifferentiableRun(model_of(scene(Y, True)), by=["moved"], outputs=["cart.x"], **at)
    found = run.jacobian(run.x0)["cart.x", "moved"][-1]
    ends = [simulate(model_of(scene(Y + h * np.eye(len(X))[2], False)), **at)["cart.x"][-1] for h in (-1e-4, 1e-4)]
    assert found == pytest.approx((ends[1] - ends[0]) / 2e-4, rel=1e-6)
    assert abs(found) > 1e-2


def test_a_motion_over_time(model_of: Build) -> None:
    """A cubic table drives a slide: position, rate and acceleration are the spline's."""
    scene = (
        Scene("slide")
        .table("path", x=[0, 0.3, 0.7, 1.0], y=[0, 0.1, 0.05, 0.2], interpolation="cubic", outside="extend")
        .rigid("cart", mass=2.0, inertia=0.1)
        .prismatic("rail", "ground.origin", "cart.origin")
        .prescribed_displacement("drive", "ground.origin", "cart.origin", motion='2 * table("path", t)')
        .simulation(t_end=1.0, dt=0.01)
        .build()
    )
    run = simulate(model_of(scene))
    spline = CubicSpline([0, 0.3, 0.7, 1.0], [0, 0.2, 0.1, 0.4], bc_type="natural")
    for k, name in enumerate(("cart.x", "cart.x_dot", "cart.x_ddot")):
        np.testing.assert_allclose(run[name], spline(run.t, k), atol=1e-13)


def test_files_are_read_with_the_scene(tmp_path: Path) -> None:
    """CSV with a header, comments and other columns; afterwards the scene holds the numbers itself."""
    (tmp_path / "curve.csv").write_text("angle; other; force\n# measured\n0; 9; 1.5\n1; 9; 2.5\n2; 9; 0.5\n")
    scene = pushed('table("curve", way)', file=tmp_path / "curve.csv", columns=[0, 2])
    assert scene.tables["curve"].x == (0.0, 1.0, 2.0) and scene.tables["curve"].y == (1.5, 2.5, 0.5)
    assert SceneRecord.from_toml_text(scene.to_toml()) == scene
    text = scene.to_toml()
    start = text.index("curve = {")
    named = 'curve = { file = "curve.csv", columns = [0, 2] }'
    (tmp_path / "scene.toml").write_text(text[:start] + named + text[text.index("\n", start) :])
    assert SceneRecord.from_toml(tmp_path / "scene.toml") == scene


@pytest.mark.parametrize(
    "force, table, words",
    [
        ('table("curves", way)', {"x": [0, 1], "y": [0, 1]}, "did you mean 'curve'"),
        ("table(curve, way)", {"x": [0, 1], "y": [0, 1]}, "name of a table"),
        ('table("curve")', {"x": [0, 1], "y": [0, 1]}, "name of a table"),
        ("'curve'", {"x": [0, 1], "y": [0, 1]}, "not allowed"),
        ("table", {"x": [0, 1], "y": [0, 1]}, "table"),
        ("0", {"x": [0, 0], "y": [0, 1]}, "tables.curve: its x do not rise from point to point: 0.0 .point 1. comes"),
        ("0", {"x": [0, np.nan], "y": [0, 1]}, "tables.curve.x.*finite"),
        ("0", {"x": [0, 5e-324], "y": [0, 1]}, "tables.curve: its curve is too steep"),
        ("0", {"x": [0], "y": [0]}, "from 2"),
        ("0", {"x": [0, 1], "y": [0]}, "as many"),
        ("0", {"file": "missing.csv"}, "tables.curve.file 'missing.csv': does not exist"),
        ("0", {"x": [0, 1], "y": [0, 1], "interpolation": "quintic"}, "interpolation"),
    ],
)
def test_what_is_no_table_is_refused_by_name(force: str, table: dict[str, Any], words: str) -> None:
    with pytest.raises(SceneError, match=words):
        pushed(force, **table)


@pytest.mark.parametrize(
    "text, words",
    [("0, 1\n1, x\n", "line 2"), ("0, 1\n1, inf\n", "line 2"), ("0\n1\n", "no columns")],
)
def test_damaged_files_are_named(tmp_path: Path, text: str, words: str) -> None:
    (tmp_path / "curve.csv").write_text(text)
    with pytest.raises(SceneError, match=words):
        pushed("0", file=tmp_path / "curve.csv")


def test_a_scene_file_reads_nothing_outside_its_folder(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text('name = "s"\n[tables]\ncurve = { file = "../curve.csv" }\n')
    with pytest.raises(SceneError, match="below the scene's folder"):
        SceneRecord.from_toml(tmp_path / "scene.toml")
    inner = tmp_path / "inner"
    inner.mkdir()
    (tmp_path / "curve.csv").write_text("0,0\n1,1\n")
    (inner / "link.csv").symlink_to(tmp_path / "curve.csv")
    (inner / "circle.csv").symlink_to(inner / "circle.csv")
    (inner / "scene.toml").write_text('name = "s"\n[tables]\ncurve = { file = "x.**" }\n')
    with pytest.raises(SceneError, match="does not exist"):
        SceneRecord.from_toml(inner / "scene.toml")
    for name in ("link.csv", "circle.csv", str(tmp_path / "curve.csv")):
        (inner / "scene.toml").write_text(f'name = "s"\n[tables]\ncurve = {{ file = "{name}" }}\n')
        with pytest.raises(SceneError, match="below the scene's folder"):
            SceneRecord.from_toml(inner / "scene.toml")
