"""Ensembles: every case is bit for bit the run by itself, and one that fails disturbs nobody."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import SCHEMES, ArgumentError, ensemble, load_model, simulate
from runtime.engine.llvm_code import host
from runtime.model import Model
from runtime.running.planning import make_plan
from runtime.studies.ensemble import rows
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.lane_programs import LanePrograms, programs_of
from runtime.studies.ensemble.lane_runs import LaneRuns
from runtime.studies.ensemble.native_cases import NativeCases
from runtime.studies.ensemble.rows import run_alone
from runtime.studies.ensemble.starts import CaseStarts, table_of
from symgen.generate import generate
from symgen.scene import Scene, SceneRecord
from tests.support.pendula import SHORT, pendula
from tests.support.scenes import on_rail

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
CASES = 5
OUTPUTS = ["crank.theta", "rod.theta_dot", "slider.x_ddot", "kinetic", "C.force_x"]


def cases_of(model: Model) -> dict[str, Any]:
    """Lengths that change the assembly, and starting angles."""
    length = next(parameter.default for parameter in model.parameters if parameter.name == "rod.tip.x")
    speed = float(model.initial_q_dot[model.coordinates.index("crank.theta")])
    return {
        "parameters": {"rod.tip.x": length * np.linspace(0.98, 1.02, CASES)},
        "initial": {"crank.theta": np.linspace(0.0, 0.4, CASES), "crank.theta_dot": speed},
    }


def alone(model: Model, given: dict[str, Any], case: int, **settings: Any) -> Any:
    """The run of a case by itself."""
    picked: dict[str, Any] = {
        kind: {name: float(np.broadcast_to(values, CASES)[case]) for name, values in table.items()}
        for kind, table in given.items()
    }
    return simulate(model, **picked, **settings)


@pytest.mark.every_push("rk4", "printed", "exponential")
@pytest.mark.parametrize("scheme", SCHEMES)
def test_every_case_is_the_run_by_itself(built_in: Load, scheme: str) -> None:
    """Samples of all kinds of outputs, of cases that are assembled anew in lanes, bit for bit."""
    model = built_in("slider_crank")
    given: dict[str, Any] = cases_of(model)
    settings: dict[str, Any] = {"scheme": scheme, "t_end": 40e-5, "dt": 2e-5, "outputs": OUTPUTS}
    found = ensemble(model, **given, **settings, seen_every=14e-5)
    expected = alone(model, given, CASES - 1, **settings, seen_every=14e-5)
    np.testing.assert_array_equal(found["time"], expected.outputs["t"])
    for name in OUTPUTS:
        np.testing.assert_array_equal(found[name][-1], expected.outputs[name], err_msg=name)
    assert (found["status"] == "completed").all() and (found["time_reached"] == found["time"][-1]).all()
    assert not np.array_equal(found["slider.x_ddot"][0], found["slider.x_ddot"][-1])


@pytest.mark.every_push("2", "8")
@pytest.mark.parametrize("width", [1, 2, 4, 8, 16])
def test_how_many_lanes_changes_no_bit(built_in: Load, width: int) -> None:
    """Nor which lane a case is in: 21 cases leave lanes over at every width above one."""
    model = built_in("pendulum")
    names, table = table_of(model, None, {"rod.theta_dot": np.linspace(0.0, 1.0, 21)})
    plan = make_plan(model, 0.01, 1e-3, None, "printed", None, None, 0.0)
    asked = EnsembleSpec.ask(model, names, plan, None, ["tip_y"], {"tip_y": ["max", "rms"]})
    runs = LaneRuns(asked, width)
    found = runs.run(CaseStarts(asked).of(table))
    expected = ensemble(
        model,
        initial={"rod.theta_dot": table[:, 0]},
        scheme="printed",
        dt=1e-3,
        t_end=0.01,
        reduce={"tip_y": ["max", "rms"]},
        workers=1,
    )
    assert found is not None and runs.programs.width == width
    np.testing.assert_array_equal(found.values, np.column_stack([expected["tip_y_max"], expected["tip_y_rms"]]))


def test_reductions_are_those_of_the_samples(built_in: Load) -> None:
    """Of a state, bit for bit; of a measure, whose every step is computed with own mathematics, to rounding."""
    model = built_in("pendulum")
    samples = pendula(model, 40, seen_every=0.0)
    every = ["max", "min", "peak", "mean", "rms", "end"]
    found = pendula(model, 40, reduce={"rod.theta": every, "tip_y": every})
    for name, tolerance in (("rod.theta", 0.0), ("tip_y", 1e-14)):
        y = np.asarray(samples[name])
        count = y.shape[1]
        expected = {
            "max": y.max(axis=1),
            "min": y.min(axis=1),
            "peak": np.abs(y).max(axis=1),
            "mean": np.cumsum(y, axis=1)[:, -1] / count,  # in the order of time
            "rms": np.sqrt(np.cumsum(y * y, axis=1)[:, -1] / count),
        }
        for reduction, values in expected.items():
            np.testing.assert_allclose(found[f"{name}_{reduction}"], values, rtol=tolerance, atol=0)
        np.testing.assert_array_equal(found[f"{name}_end"], y[:, -1])


def test_threads_change_no_bit(built_in: Load) -> None:
    model = built_in("pendulum")
    one, three = (pendula(model, 700, seen_every=5e-3, workers=workers) for workers in (1, 3))
    assert one.identical(three)


def test_jobs_are_as_long_as_what_python_does_for_them_asks(built_in: Load) -> None:
    """Many short runs a job, never so many that a thread is left without, or that samples take much room."""
    model = built_in("pendulum")

    def job(cases: int, workers: int, t_end: float, seen_every: float | None = None) -> int:
        names, _ = table_of(model, None, {"rod.theta_dot": np.zeros(cases)})
        plan = make_plan(model, t_end, 1e-3, None, "rk4", seen_every, None, 0.0)
        reduce = {"tip_y": ["end"]} if seen_every is None else None
        runs = LaneRuns(EnsembleSpec.ask(model, names, plan, None, ["tip_y"], reduce), 8)
        found = runs.job(cases, workers)
        assert found % 8 == 0
        return found

    assert job(100_000, 2, 0.25) > 2000  # some ms of native code
    assert job(1000, 2, 0.25) == 256 and job(100_000, 2, 25.0) == 256
    assert job(10_000, 2, 0.25) <= 10_000 / 4 and job(10_000, 8, 0.25) < job(10_000, 2, 0.25)
    assert job(100_000, 2, 0.25, seen_every=0.0) * 251 * 8 <= 1 << 23


def test_a_case_that_fails_disturbs_nobody(built_in: Load) -> None:
    """It has its status, the time that it reached and NaN from there on; the others have their bits."""
    model = built_in("pendulum")
    speeds = np.array([0.1, 0.2, 1e200, 0.3])
    found = ensemble(model, initial={"rod.theta_dot": speeds}, **SHORT, outputs=["rod.theta"], seen_every=0.0)
    healthy = ensemble(
        model, initial={"rod.theta_dot": np.delete(speeds, 2)}, **SHORT, outputs=["rod.theta"], seen_every=0.0
    )
    np.testing.assert_array_equal(found["status"] == "completed", [True, True, False, True])
    np.testing.assert_array_equal(np.delete(np.asarray(found["rod.theta"]), 2, axis=0), healthy["rod.theta"])
    reached = float(found["time_reached"][2])
    assert reached < SHORT["t_end"]
    np.testing.assert_array_equal(np.isnan(found["rod.theta"][2]), found["time"] > reached + 1e-9)
    reduced = ensemble(model, initial={"rod.theta_dot": speeds}, **SHORT, reduce={"rod.theta": "max"})
    np.testing.assert_array_equal(np.isnan(reduced["rod.theta_max"]), [False, False, True, False])


@pytest.mark.parametrize("width", [1, 4])
def test_a_lost_lane_is_not_iterated(built_in: Load, width: int) -> None:
    """Sweeps of `printed` stop where x is lost, and in the lane beside it are counted as ever."""
    model = built_in("pendulum")
    names, table = table_of(model, None, {"rod.theta_dot": np.array([0.5, 1e305])})
    plan = make_plan(model, 0.02, 1e-3, None, "printed", 1.0, None, 0.0)
    asked = EnsembleSpec.ask(model, names, plan, None, ["rod.theta"], None)
    counted = []
    for cases in (table, table[:1]):
        runs = LaneRuns(asked, width)
        sweeps = runs.programs.scheme.layout.slice("iterations").start
        blocks = runs.started(CaseStarts(asked).of(cases))
        runs.advance(blocks, 20)
        counted.append(runs.values(blocks, len(cases), "scheme")[:, sweeps])
    assert counted[0][1] < 20 * 3 and counted[0][0] == counted[1][0]


def test_what_cannot_be_assembled_has_a_status(built_in: Load) -> None:
    """A rod that does not reach the slide; its neighbours run."""
    model = built_in("slider_crank")
    given = {"rod.tip.x": np.array([0.3, 0.05, 0.31])}
    settings: dict[str, Any] = {"initial": {"crank.theta": 1.2}, "t_end": 1e-4, "outputs": ["slider.x"]}
    found = ensemble(model, given, **settings, seen_every=0.0)
    assert found["status"].values.tolist() == ["completed", "not_assembled", "completed"]
    assert np.isnan(found["slider.x"][1]).all() and np.isfinite(found["slider.x"][[0, 2]]).all()


@pytest.mark.long
def test_a_singular_position_is_passed_as_a_run_passes_it(built_in: Load) -> None:
    """The crank is longer than the rod: on the way q_i changes. That case is run by itself, its neighbour in lanes."""
    model = built_in("slider_crank")
    settings: dict[str, Any] = {"t_end": 0.017, "outputs": ["slider.x", "crank.theta"]}
    found = ensemble(
        model, {"crank.tip.x": np.array([0.15, 0.32])}, **settings, seen_every=100 * model.simulation["dt"]
    )
    expected = simulate(model, parameters={"crank.tip.x": 0.32}, **settings, seen_every=100 * model.simulation["dt"])
    assert [event.kind for event in expected.events] == ["repartition"]
    for name in settings["outputs"]:
        np.testing.assert_array_equal(found[name][1], expected.outputs[name])
    assert (found["status"] == "completed").all()


def leaving(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The cases that come to an event and go on by native code."""
    left, values = list[int](), NativeCases.values

    def noted(self: NativeCases, starts: Any, case: int) -> np.ndarray | None:
        found = values(self, starts, case)
        if found is not None:
            left.append(case)
        return found

    monkeypatch.setattr(NativeCases, "values", noted)
    return left


@pytest.mark.every_push("0")
@pytest.mark.parametrize("torque", ["0", "where(t < 0.1234, 1, 0)"])
def test_cases_without_an_event_stay_in_their_lanes(model_of: Build, monkeypatch, torque: str) -> None:
    """A pendulum that a brake catches at an angle: only the cases that come there leave, and need no run; same bits."""
    scene = Scene("caught").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0.0))
    scene.revolute("pin", "ground.origin", "rod.origin").initial({"rod.theta": -1.5})
    scene.input("brake", 0.0).measure("angle", "coordinate", "rod.theta")
    scene.torque("drive", "rod.origin", torque).torque("braking", "rod.origin", "-brake * angle_dot")
    scene.event("caught", "angle", direction="rising", action={"brake": "5"})
    model = model_of(scene.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build())
    speeds, left = [1.0, 6.0, 2.0, 7.0, 1.5], leaving(monkeypatch)
    monkeypatch.setattr(rows, "run_alone", None)
    found = ensemble(model, initial={"rod.theta_dot": speeds}, outputs=["rod.theta"], seen_every=0.1)
    runs = [simulate(model, initial={"rod.theta_dot": speed}, seen_every=0.1) for speed in speeds]
    caught = [speed for speed, run in zip(speeds, runs, strict=True) if any(one.kind == "event" for one in run.events)]
    assert caught == [6.0, 7.0] and [speeds[case] for case in left] == caught
    for case, run in enumerate(runs):
        np.testing.assert_array_equal(found["rod.theta"][case], run["rod.theta"])


def test_a_case_that_leaves_its_lane_takes_the_steps_of_the_others(model_of: Build) -> None:
    """Steps of 2.2 / w grow, in lanes and alone: the case with an event is the run that is forced to take them."""
    scene = on_rail("loud", "m", "rail", mass=1.0, inertia=0.1).measure("x", "x", "m.origin").input("late", 1.0, "s")
    scene.input("push", 0.0, "N").force("spring", "m.origin", "push - 5e6 * x", 0.0).initial({"m.x": 1e-6})
    scene.event("pushed", "t - late", action={"push": "1"})
    model = model_of(scene.simulation(t_end=0.01, dt=1e-3, scheme="single_rate").build())
    found = ensemble(model, {"late": [1.0, 0.0043]}, outputs=["m.x"], seen_every=0.0)
    runs = [simulate(model, inputs={"late": late}, force=True, seen_every=0.0, error="off") for late in (1.0, 0.0043)]
    assert list(found["status"]) == ["completed", "completed"]
    assert [len(run.events) for run in runs] == [0, 1]
    np.testing.assert_array_equal(np.asarray(found["m.x"]), np.array([run["m.x"] for run in runs]))
    assert not simulate(model, inputs={"late": 0.0043}).status.ok


@pytest.mark.every_push("rk4")
@pytest.mark.parametrize("scheme", ["rk4", "exponential", "single_rate"])
def test_friction_and_rigid_stops_stay_in_lanes_until_something_changes(
    model_of: Build, monkeypatch: pytest.MonkeyPatch, scheme: str
) -> None:
    """Blocks that are held, slide at once, break away by a load, or strike a stop: only the last two leave their lanes.

    What remembers forces begins anew where it slides at once, which is a run by itself, too.
    """
    scene = Scene("pulled").rigid("block", mass=2.0, inertia=0.1).input("more", 0.0, "N")
    limits = {"upper": 0.2, "restitution": 0.5}
    scene.prismatic("rail", "ground.origin", "block.origin", friction={"coulomb": 3.0}, limits=limits)
    scene.force("pull", "block.origin", "more + 2*t", 0.0)
    model = model_of(scene.simulation(t_end=0.5, dt=0.01, scheme=scheme).build())
    pulls, leave, left = [-1.0, 2.5, 4.0, -9.0, 9.0], list[float](), leaving(monkeypatch)
    monkeypatch.setattr(rows, "run_alone", lambda *given: leave.extend(given[1].tolist()) or run_alone(*given))
    found = ensemble(model, {"more": pulls}, outputs=["block.x"], seen_every=0.1)
    runs = [simulate(model, inputs={"more": pull}, seen_every=0.1) for pull in pulls]
    assert [any(event.time > 0 for event in run.events) for run in runs] == [False, True, False, False, True]
    np.testing.assert_array_equal(np.asarray(found["block.x"]), np.array([run["block.x"] for run in runs]))
    assert [pulls[case] for case in left] == ([2.5, 9.0] if scheme != "single_rate" else [2.5])
    assert leave == ([] if scheme != "single_rate" else [4.0, -9.0, 9.0])


def test_many_discs_that_turn_fast_are_lost_no_sooner_than_one(model_of: Build) -> None:
    """Free discs turn by w t, by hand; a step of each is below the limit of 1e6 rad, of all it is above."""
    scene, discs = Scene("discs"), [f"disc{k}" for k in range(6)]
    for name in discs:
        scene.rigid(name, mass=1.0, inertia=0.1).revolute(f"{name}_axle", "ground.origin", f"{name}.origin")
        scene.rates({f"{name}.theta": 4e5})
    model = model_of(scene.simulation(t_end=3.0, dt=1.0, scheme="rk4").build())
    found = ensemble(model, initial={"disc0.theta_dot": [4e5, -4e5]}, outputs=["disc0.theta", "disc5.theta"])
    assert list(found["status"]) == ["completed", "completed"]
    assert np.asarray(found["disc0.theta"])[:, -1] == pytest.approx([12e5, -12e5], rel=1e-12)
    assert np.asarray(found["disc5.theta"])[:, -1] == pytest.approx([12e5, 12e5], rel=1e-12)


def test_turning_bodies_start_with_their_angular_velocities(built_in: Load) -> None:
    model, spins = built_in("tumbling_body"), [-1.0, 2.5]
    given: dict[str, Any] = {"scheme": "rk4", "dt": 0.01, "t_end": 0.5}
    names = ["body.e1", "body.omega_x", "body.omega_z"]
    found = ensemble(model, initial={"body.omega_x": spins}, reduce={name: ["end"] for name in names}, **given)
    alone = [simulate(model, initial={"body.omega_x": spin}, **given) for spin in spins]
    for name in names:
        values = [run[name][-1] for run in alone]
        assert np.asarray(found[f"{name}_end"]).tolist() == values and values[0] != values[1]


def test_inputs_of_cases_are_those_of_runs(tmp_path: Path) -> None:
    """A cart pushed by a number of each case, along a function of time that all share, from a time of its own."""
    scene = (
        on_rail("pushed", "cart", "rail", mass=2.0, inertia=0.1)
        .input("force", 1.0, "N", "push")
        .input("wind", 0.0, "N", "on all")
        .force("push", "cart.origin", "force + wind", 0.0)
        .simulation(t_end=0.1, dt=1e-2, scheme="rk4")
        .build()
    )
    model = load_model(generate(scene, tmp_path / "pushed"))
    forces = np.array([0.5, 1.0, 2.0])
    settings: dict[str, Any] = {"t0": 0.05, "outputs": ["cart.x", "cart.x_ddot"]}
    found = ensemble(model, inputs={"force": forces, "wind": lambda t: np.sin(30 * t)}, seen_every=3e-2, **settings)
    expected = simulate(model, inputs={"force": 2.0, "wind": lambda t: np.sin(30 * t)}, seen_every=3e-2, **settings)
    for name in settings["outputs"]:
        np.testing.assert_array_equal(found[name][2], expected.outputs[name])
    with pytest.raises(ArgumentError, match="wind.*samples"):
        ensemble(model, inputs={"force": forces, "wind": ([0.0, 1.0], [0.0, 1.0])}, outputs=["cart.x"])


def test_a_loop_makes_programs_once(built_in: Load) -> None:
    """Other samples, names and numbers of cases need no other programs; another output does."""
    model = built_in("pendulum")

    def asked(names: tuple[list[str], list[str]], output: str, dt: float | None = None) -> EnsembleSpec:
        plan = make_plan(model, None, dt, None, None, None, None, 0.0)
        return EnsembleSpec.ask(model, names, plan, None, [output], None)

    first = programs_of(asked(([], ["rod.theta"]), "tip_y"))
    assert programs_of(asked((["length"], []), "tip_y")) is first
    assert programs_of(asked((["length"], []), "tip_x")) is not first
    assert programs_of(asked((["length"], []), "tip_y", 5e-4)) is first  # the step is data


def test_width_follows_the_processor(built_in: Load) -> None:
    """A short program takes two registers a value where they are 512 bits wide."""
    model = built_in("pendulum")
    plan = make_plan(model, None, None, None, None, None, None, 0.0)
    asked = EnsembleSpec.ask(model, ([], ["rod.theta_dot"]), plan, None, ["tip_y"], None)
    features = set(host().features.split(","))
    expected = 16 if "+avx512f" in features else 4 if "+avx" in features else 2
    assert LanePrograms(asked).width == expected


def test_variables_say_their_unit_and_what_they_are(built_in: Load) -> None:
    """Of what is varied, of samples and of reductions, those of the run's own Dataset."""
    pytest.importorskip("xarray")
    model = built_in("slider_crank")
    settings: dict[str, Any] = {**cases_of(model), "scheme": "rk4", "t_end": 40e-5, "dt": 2e-5, "outputs": OUTPUTS}
    sampled, reduced = ensemble(model, **settings), ensemble(model, **settings, reduce={"C.force_x": "peak"})
    run = simulate(model, scheme="rk4", t_end=40e-5, dt=2e-5).to_xarray()
    for name in OUTPUTS:
        assert sampled[name].attrs == run["energy.kinetic" if name == "kinetic" else name].attrs and sampled[name].units
    force = run["C.force_x"].attrs
    assert reduced["C.force_x_peak"].attrs == {"units": "N", "long_name": f"peak of {force['long_name']}"}
    assert reduced["initial.crank.theta_dot"].attrs == {
        "units": "rad/s",
        "long_name": "initial rate of angle crank.theta",
    }
    assert reduced["rod.tip.x"].units == "m" and reduced["time_reached"].units == "s"


@pytest.mark.parametrize("scheme", ["rk4", "single_rate"])
def test_a_model_whose_one_event_is_a_kink_has_the_bits_of_single_runs(scheme: str) -> None:
    """A load that jumps with the motion and no event: cases that come to it run one by one, others in lanes."""
    scene = Scene("pushed_once").parameter("push", 1.0).rigid("cart", mass=1.0, inertia=1.0)
    scene.prismatic("rail", "ground.origin", "cart.origin").measure("place", "x", of="cart.origin")
    model = scene.force("motor", "cart.origin", "where(place > 0.5, push, 0)", 0).rates({"cart.x": 1.0}).model()
    push, place = [2.0, 4.0, 4.0], [0.0, 0.0, -9.0]
    asked = {"scheme": scheme, "dt": 1e-2, "t_end": 1.0}
    found = model.ensemble({"push": push}, {"cart.x": place, "cart.x_dot": 1.0}, **asked, reduce={"cart.x_dot": "end"})
    for case, (force, start) in enumerate(zip(push, place, strict=True)):
        run = model.simulate(parameters={"push": force}, initial={"cart.x": start, "cart.x_dot": 1.0}, **asked)
        assert found["cart.x_dot_end"].values[case] == run["cart.x_dot"][-1]
    assert found["cart.x_dot_end"].values[2] == 1.0  # never there
