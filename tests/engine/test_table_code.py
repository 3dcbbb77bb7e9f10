"""Tables as one operation: the same bits in every engine and lane, exact derivatives, a price that hardly grows."""

from __future__ import annotations

import json
from collections.abc import Callable
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest

from benchmarks.contenders.by_c_compiler import CompiledProgram
from runtime import DifferentiableRun, ensemble, load_model, resume, simulate
from runtime.contract.tape import Table, as_function, mark, read_tape, shared
from runtime.engine.c_source import find_compiler
from runtime.engine.llvm_code import BEST, FIRST_EFFORT
from runtime.engine.native import LaneCode, blocks_of, choose_engine
from runtime.engine.program import Call, Form, operations_per_step
from runtime.engine.rows import ManyPoints
from runtime.gradients import End
from runtime.model import Model
from runtime.schemes.switching.enclosure import TableBounds
from symgen.generate import generate
from symgen.scene import CurveTable, Scene, SceneRecord
from tests.support.complex_step import derivatives

Build = Callable[[SceneRecord], Model]
RANDOM = np.random.default_rng(3)
GRIDS = {
    "even": np.linspace(-1.3, 2.1, 40),
    "scattered": np.sort(RANDOM.normal(size=150)),
    "geometric": np.geomspace(1e-7, 1e3, 60),
    "two": np.array([-0.5, 0.25]),
}
KINDS = ("linear", "cubic", "monotone")


def table(x: np.ndarray, interpolation: str, outside: str = "extend") -> Table:
    y = np.sin(3 * x) + 0.1 * x
    fields: dict[str, Any] = {"interpolation": interpolation, "outside": outside}
    return CurveTable(x=tuple(x), y=tuple(y), **fields).curve


def places(x: np.ndarray) -> np.ndarray:
    """On the knots, one float to either side of them, between and outside, and where nothing is."""
    beside = [np.nextafter(x, -np.inf), np.nextafter(x, np.inf)]
    return np.concatenate([x, *beside, np.linspace(2 * x[0] - x[-1], 2 * x[-1] - x[0], 101), [np.nan, 1e300, -1e300]])


def stage(one: Table) -> Call:
    """z = (x, value, slope, second derivative), by CasADi's own differentiation."""
    z, c = ca.SX.sym("z", 4), ca.SX.sym("c", 1)
    y = one.function()(z[0])
    slope = ca.jacobian(y, z[0])
    found = ca.vertcat(z[0], y, slope, ca.jacobian(slope, z[0]))
    return Call(ca.Function("looked_up", [z, c], [ca.densify(found)], ["z", "c"], ["z_next"]))


@pytest.mark.every_push("geometric-cubic", "scattered-monotone")
@pytest.mark.parametrize("interpolation", KINDS)
@pytest.mark.parametrize("grid", GRIDS)
def test_engines_and_lanes_give_the_same_bits(grid: str, interpolation: str) -> None:
    """Value, slope and second derivative: virtual machine, LLVM in lanes of every width, NumPy, and C where it is."""
    one, x = table(GRIDS[grid], interpolation), places(GRIDS[grid])
    program, c = stage(one), np.zeros(1)
    expected = np.array([one(x, order) for order in range(3)]).T
    engines: dict[str, Any] = {
        name: choose_engine(name, program, 4, 1, wait=True) for name in ("interpreted", "compiled")
    }
    for name, engine in (engines | ({"C": CompiledProgram(program)} if find_compiler() else {})).items():
        found = np.zeros((len(x), 4))
        found[:, 0] = x
        for row in found:
            engine.run(row, c, 1)
        np.testing.assert_array_equal(found[:, 1:], expected, err_msg=name)
    for width, effort in ((2, FIRST_EFFORT), (4, BEST), (8, BEST), (16, FIRST_EFFORT)):
        blocks = blocks_of(-(-len(x) // width), 5, width)
        blocks[:, 0] = np.append(x, np.zeros(blocks[:, 0].size - len(x))).reshape(-1, width)
        LaneCode(program, Form(width, "own", 0, effort is BEST), effort).run(blocks, 0, 4, 1)
        found = blocks[:, 1:4].transpose(0, 2, 1).reshape(-1, 3)[: len(x)]
        np.testing.assert_array_equal(found, expected, err_msg=f"{width} lanes")
    many = ManyPoints(_of_x(program))
    np.testing.assert_array_equal(many(x[:, None]), expected)


def _of_x(program: Call) -> ca.Function:
    x = ca.SX.sym("x")
    return ca.Function("of_x", [x], [program.stage(ca.vertcat(x, 0, 0, 0), 0)[1:]])


@pytest.mark.parametrize("interpolation", KINDS)
def test_derivatives_are_those_of_the_curve(interpolation: str) -> None:
    """Of s f(s t): gradient and Hessian against the product rule, forward and back, and against complex numbers."""
    one = table(GRIDS["scattered"], interpolation)
    x, w = ca.SX.sym("x", 2), ca.SX.sym("w")
    y = x[0] * one.function()(x[0] * x[1])
    hessian, gradient = ca.hessian(y, x)
    backward = ca.jtimes(y, x, w, True)
    both = ca.Function("f", [x, w], shared([ca.densify(one) for one in (gradient, hessian, backward, y)]))
    for s, t in RANDOM.uniform(-1, 1, (20, 2)):
        f, g, h = (float(one(np.float64(s * t), order)) for order in range(3))
        found = [np.asarray(part) for part in both([s, t], 2.0)]
        expected = np.array([f + s * t * g, s * s * g])
        np.testing.assert_allclose(found[0].ravel(), expected, rtol=1e-13, atol=1e-14)
        mixed = 2 * s * g + s * s * t * h
        np.testing.assert_allclose(found[1], [[2 * t * g + s * t * t * h, mixed], [mixed, s**3 * h]], atol=1e-12)
        np.testing.assert_allclose(found[2].ravel(), 2 * expected, rtol=1e-13, atol=1e-14)
        assert abs(one(complex(s * t, 1e-40)).imag / 1e-40 - g) <= 1e-14 * abs(g)
    calls = [node for node in read_tape(both).nodes if node.op == ca.OP_CALL]
    assert len(calls) == (2 if interpolation == "linear" else 3)  # each once, though asked for again and again


@pytest.mark.parametrize("interpolation", KINDS)
def test_derivatives_of_every_order(interpolation: str) -> None:
    """Forward, back and as a Jacobian, of the curve and of its derivatives, beyond its degree too, where they are 0."""
    one, x, w = table(GRIDS["even"], interpolation), ca.SX.sym("x"), ca.SX.sym("w")
    for order in range(4):
        y = 3 * one.function(order)(2 * x)
        for further in range(1, 4 - order):
            ways = [ca.jtimes(y, x, w), ca.jtimes(y, x, w, True), ca.jacobian(y, x)]
            as_casadi = ca.Function("ways", [x, w], [ca.densify(way) for way in ways])
            expected = 3 * 2**further * float(one(np.float64(0.62), order + further))
            for function in (as_casadi, as_function("ways", read_tape(as_casadi))):
                found = [float(value) for value in function(0.31, 1.5)]
                np.testing.assert_allclose(found, np.array([1.5, 1.5, 1]) * expected, rtol=1e-12, atol=1e-12)
            y = ways[2]


@pytest.mark.long
def test_many_points_cost_no_more_than_few() -> None:
    few, many = (table(np.linspace(0, 7, n), "cubic") for n in (10, 100_000))
    assert few.instructions(0) == many.instructions(0) <= 30
    x = np.linspace(-1, 8, 1001)
    engine = choose_engine("interpreted", stage(many), 4, 1)
    found = np.column_stack([x, np.zeros((1001, 3))])
    for row in found:
        engine.run(row, np.zeros(1), 1)
    inside = (x > 0) & (x < 7)
    np.testing.assert_allclose(found[inside, 1], np.sin(3 * x[inside]) + 0.1 * x[inside], atol=1e-9)
    scattered = table(np.sort(np.random.default_rng(0).uniform(size=100_000)), "linear")
    assert scattered.instructions(0) <= 40  # O(log) of the most in a bucket
    geometric = table(np.geomspace(1e-30, 1e30, 1000), "linear")
    assert geometric.levels <= 10


@pytest.mark.parametrize("outside", ["hold", "extend"])
@pytest.mark.parametrize("interpolation", KINDS)
def test_bounds_hold(interpolation: str, outside: str) -> None:
    """Over short and long intervals they hold all that is taken, and no more than it where lines are."""
    x = GRIDS["scattered"]
    one = table(x, interpolation, outside)
    low = RANDOM.uniform(x[0] - 1, x[-1] + 1, 200)
    high = low + 10.0 ** RANDOM.uniform(-6, 1, 200)
    for order in range(3):
        bounds = TableBounds(mark(one.key, order))
        least, most, jumps = bounds(low, high)
        values = one(np.linspace(low, high, 300), order)
        assert (least <= values.min(axis=0)).all() and (values.max(axis=0) <= most).all()
        smooth = {"linear": order == 2, "cubic": True, "monotone": order < 2}[interpolation]
        assert smooth or order == 0 or jumps.any()
    assert not TableBounds(mark(one.key, 0)).jumps


def quarter_car(points: int = 241) -> SceneRecord:
    """A wheel on a tyre on a road that a table gives along the way, a body on a spring whose law is a table, too."""
    s = np.linspace(0, 60, points)
    road = 0.02 * np.sin(0.8 * s) + 0.008 * np.sin(2.9 * s)
    return (
        Scene("quarter_car")
        .table("road", x=s, y=road)
        .table("spring", x=[-0.2, -0.05, 0, 0.05, 0.2], y=[9000, 1200, 0, -900, -6000], interpolation="monotone")
        .parameter("speed", 15.0, "m/s")
        .parameter("share", 0.5)
        .rigid("wheel", mass=40.0, inertia=1.0)
        .rigid("body", mass=300.0, inertia=10.0)
        .prismatic("wheel_guide", "ground.origin", "wheel.origin")
        .prismatic("body_guide", "ground.origin", "body.origin")
        .measure("low", "x", "wheel.origin")
        .measure("high", "x", "body.origin")
        .force("tyre", "wheel.origin", 'table("road", share) + 2e5 * (table("road", speed * t) - low)', 0.0)
        .force("strut_low", "wheel.origin", '-table("spring", high - low) + 1500 * (high_dot - low_dot)', 0.0)
        .force("strut_high", "body.origin", 'table("spring", high - low) - 1500 * (high_dot - low_dot)', 0.0)
        .simulation(t_end=0.5, dt=1e-3, scheme="rk4")
        .build()
    )


@pytest.fixture(scope="module")
def car(model_of: Build) -> Model:
    return model_of(quarter_car())


@pytest.mark.long
def test_a_step_over_a_long_road_is_cheap(car: Model) -> None:
    """10,214 operations of a step went into the road's 241 points when every point was looked at."""
    run = simulate(car)
    assert run.status.ok and run.stats["operations_per_step"] < 10_214 / 20
    road, t = table_of_scene(car), run.t
    force = 2e5 * (road(15.0 * t) - run["wheel.x"]) + road(np.float64(0.5))
    strut = 1500 * (run["body.x_dot"] - run["wheel.x_dot"])
    law = quarter_car().tables["spring"].curve(run["body.x"] - run["wheel.x"])
    np.testing.assert_allclose(run["wheel.x_ddot"], (force - law + strut) / 40, atol=1e-10)
    assert np.abs(run["wheel.x"]).max() > 0.01


def table_of_scene(car: Model) -> Table:
    return SceneRecord.from_toml_text(car.scene_toml).tables["road"].curve


def test_a_table_of_what_is_known_is_taken_out(car: Model) -> None:
    """At a parameter it is computed once a run."""
    calls = [node for node in read_tape(car.kernel("condensed")).nodes if node.op == ca.OP_CALL]
    assert len(calls) == 2  # the road at the place, the spring
    assert [node.op for node in read_tape(car.kernel("constants")).nodes].count(ca.OP_CALL) == 1


@pytest.mark.long
def test_runs_have_the_same_bits_however_they_run(car: Model, tmp_path: Path) -> None:
    """Interpreted and compiled, in an ensemble, saved seldom, and resumed behind a checkpoint."""
    whole = simulate(car, engine="compiled-library")
    interpreted = simulate(car, engine="interpreted")
    np.testing.assert_array_equal(interpreted.q, whole.q)
    own = simulate(car)
    cases = ensemble(car, {"speed": [14.0, 15.0]}, outputs=["wheel.x"], seen_every=0.1)
    np.testing.assert_array_equal(cases["wheel.x"][1], own["wheel.x"][::100])
    kept = tmp_path / "run.npz"

    def ctrl_c(t: float, t_end: float) -> None:
        if t > 0.3:
            raise KeyboardInterrupt

    stopped = simulate(car, checkpoint=kept, checkpoint_every=50, progress=ctrl_c)
    assert stopped.status.name == "interrupted"
    np.testing.assert_array_equal(resume(car, kept).q, own.q)


@pytest.mark.every_push("rk4")
@pytest.mark.parametrize("scheme", ["rk4", "exponential"])
def test_gradients_of_runs_through_tables(car: Model, scheme: str) -> None:
    """By the speed, along which the road is read, and by a mass: forward and back, against complex numbers."""
    names = ["speed", "body.mass"]
    run = DifferentiableRun(car, by=names, outputs=["body.x", "wheel.x"], t_end=0.05, dt=1e-3, scheme=scheme)
    jacobian, value = run.jacobian(run.x0), End("body.x")
    back = run.gradient(value, run.x0, mode="reverse")
    for k, name in enumerate(names):
        exact = derivatives(run, name)
        for column, output in enumerate(run.outputs):
            limit = 1e-9 * np.abs(exact[:, column]).max()
            np.testing.assert_allclose(jacobian[output, name], exact[:, column], rtol=0, atol=limit)
        assert back.derivatives[k] == pytest.approx(exact[-1, 0], rel=1e-9)


def test_emitted_text_is_short_and_stands_alone(tmp_path: Path) -> None:
    """It holds no point; with the tables of data.json it gives what the loaded model gives, without this project."""
    folder = generate(quarter_car(5000), tmp_path / "car")
    text = (folder / "model.py").read_text()
    assert len(text) < 30_000 and 'table("road")(' in text
    spec = spec_from_file_location("alone", folder / "model.py")
    assert spec is not None and spec.loader is not None
    code = module_from_spec(spec)
    spec.loader.exec_module(code)
    code.TABLES.update(json.loads((folder / "data.json").read_text())["tables"])
    model = load_model(folder)
    c = model.constants(model.parameter_vector())
    alone, loaded = code.FUNCTIONS["condensed"](), model.kernel("condensed")
    for t in (0.1, 0.7):
        inputs = [c if name == "c" else t if name == "t" else [0.01, -0.02] for name in loaded.name_in()]
        for one, other in zip(alone.call(inputs), loaded.call(inputs), strict=True):
            np.testing.assert_array_equal(np.asarray(one), np.asarray(other))
    assert operations_per_step(Call(loaded)) < 200
