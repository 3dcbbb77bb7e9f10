"""Inputs from outside: constants, functions, held samples, controllers, motions with rates and behind filters."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import (
    SCHEMES,
    Sampled,
    SchemeError,
    Solution,
    SymgenError,
    resume,
    simulate,
)
from runtime.model import Model
from symgen.cli import main
from symgen.scene import Scene, SceneError, SceneRecord
from tests.support.input_scenes import cart, crane, wave
from tests.support.scenes import on_rail

Build = Callable[[SceneRecord], Model]


# ---- loads --------------------------------------------------------------------------------------------------


@pytest.mark.every_push("rk4", "printed")
@pytest.mark.parametrize("scheme", SCHEMES)
def test_every_scheme_takes_inputs(model_of: Build, scheme: str) -> None:
    """x = (t - sin(w t) / w) / (m w) for a force sin(w t) from rest."""
    run = simulate(model_of(cart()), scheme=scheme, inputs={"force": lambda t: np.sin(2 * t)}, seen_every=0.025)
    exact = (run.t - np.sin(2 * run.t) / 2) / 4
    assert np.abs(run["cart.x"] - exact).max() < (2e-7 if SCHEMES[scheme].make.order == 2 else 1e-11)
    np.testing.assert_allclose(run["force"], np.sin(2 * run.t), atol=1e-15)
    assert np.abs(run.energy_balance()).max() < 1e-6


def test_held_samples_act_from_their_time_on(model_of: Build) -> None:
    """1 N for half a second, then -1 N: x = 1/16 m then, 1/8 m at the end, at rest."""
    model = model_of(cart())
    samples = ([0.0, 0.5], [1.0, -1.0])
    run = simulate(model, inputs={"force": samples}, seen_every=0.1)
    np.testing.assert_allclose(run["cart.x"][::5], [0, 0.0625, 0.125], atol=1e-14)
    np.testing.assert_allclose(run["cart.x_dot"][::5], [0, 0.25, 0], atol=1e-14)
    assert list(run["force"]) == [1.0] * 6 + [-1.0] * 5  # at a change: what was until then
    assert np.abs(run.energy_balance()).max() < 1e-13  # 1 N over 1/16 m and back
    stepper = model.stepper()
    stepper.step({"force": 1.0}, 500)
    for _ in range(500):
        stepper.step([-1.0])
    np.testing.assert_array_equal(stepper.sample.q[0], run.q[-1])
    assert stepper.measures["force"] == -1.0


def test_a_run_with_samples_is_gone_on_with(model_of: Build, tmp_path: Any) -> None:
    model, inputs = model_of(cart()), {"force": ([0.0, 0.25, 0.5], [1.0, 3.0, -1.0])}
    kept = tmp_path / "run.npz"
    whole = simulate(model, inputs=inputs, checkpoint=kept, checkpoint_every=400)
    np.testing.assert_array_equal(resume(model, kept, inputs=inputs).q, whole.q)
    with pytest.raises(SymgenError, match="driven by other inputs"):
        resume(model, kept, inputs={"force": ([0.0], [1.0])})


@pytest.mark.parametrize("engine", ["interpreted", "auto"])
def test_a_sampled_controller_is_the_discrete_loop(model_of: Build, engine: str) -> None:
    """State feedback held for 20 ms: x_k+1 = (Phi - Gamma k) x_k + Gamma r with the exact Phi and Gamma of the mass."""
    K, wanted, T = np.array([8.0, 6.0]), 2.0, 0.02
    inputs = {"force": Sampled(lambda t, x: K[0] * wanted - K @ x, T, ["cart.x", "cart.x_dot"])}
    run = simulate(model_of(cart()), inputs=inputs, seen_every=0.02, engine=engine)
    x = np.zeros(2)
    for k in range(len(run.t)):
        np.testing.assert_allclose([run["cart.x"][k], run["cart.x_dot"][k]], x, atol=1e-13)
        push = K[0] * wanted - K @ x
        x = np.array([x[0] + T * x[1] + T**2 / 4 * push, x[1] + T / 2 * push])


# ---- prescribed motions -------------------------------------------------------------------------------------


def test_a_function_brings_rate_and_acceleration(model_of: Build) -> None:
    """The trolley is where, as fast and as much accelerated as the function says; the motor pulls both masses."""
    run = simulate(model_of(crane(rates=True)), inputs={"way": wave})
    t = run.t
    np.testing.assert_allclose(run["trolley.x"], wave(t), atol=1e-15)
    np.testing.assert_allclose(run["trolley.x_dot"], 0.3 * np.cos(3 * t), atol=1e-15)
    np.testing.assert_allclose(run["trolley.x_ddot"], -0.9 * np.sin(3 * t), atol=1e-14)
    angle, rate, acceleration = (run[f"load.theta{end}"] for end in ("", "_dot", "_ddot"))
    load = run["trolley.x_ddot"] + np.cos(angle) * acceleration - np.sin(angle) * rate**2
    np.testing.assert_allclose(run.motor("drive"), 2 * run["trolley.x_ddot"] + load, atol=1e-12)


def test_samples_of_a_motion_are_smooth(model_of: Build) -> None:
    """Through every sample, position, rate and acceleration without a jump, at rest at both ends."""
    times = np.linspace(0, 1, 11)
    run = simulate(model_of(crane(rates=True)), t_end=1.2, inputs={"way": (times, wave(times) * times)})
    np.testing.assert_allclose(run["trolley.x"][:1001:100], wave(times) * times, atol=1e-14)
    assert run["trolley.x_dot"][0] == 0 and np.abs(run["trolley.x_dot"][1000:]).max() < 1e-15
    inside = slice(1, 1000)  # at the ends the acceleration begins and stops
    assert np.abs(np.diff(run["trolley.x_dot"])).max() < 2e-3 * np.abs(run["trolley.x_ddot"]).max()
    assert np.abs(np.diff(run["trolley.x_ddot"][inside])).max() < 0.02 * np.abs(run["trolley.x_ddot"]).max()


def test_a_filter_answers_a_step_as_its_law_says(model_of: Build) -> None:
    """x = 1 - (1 + w t) exp(-w t), and back from where it is when the target goes back (by superposition)."""
    w = 12.0
    run = simulate(model_of(crane(filter=w)), inputs={"way": ([0.0, 0.4], [1.0, 0.0])})

    def step(t: np.ndarray) -> np.ndarray:
        return np.where(t < 0, 0.0, 1 - (1 + w * t) * np.exp(-w * np.maximum(t, 0)))

    np.testing.assert_allclose(run["trolley.x"], step(run.t) - step(run.t - 0.4), atol=1e-13)
    np.testing.assert_allclose(run["way_ddot"][0], w**2, rtol=1e-14)


def test_a_stepper_takes_rate_and_acceleration(model_of: Build) -> None:
    stepper = model_of(crane(rates=True)).stepper()
    stepper.reset(t=3.0)
    stepper.step({"way": 0.0, "way_dot": 0.3, "way_ddot": 0.1}, 100)
    assert stepper.state["trolley.x"] == pytest.approx(0.0305, abs=1e-15)
    assert stepper.state["trolley.x_dot"] == pytest.approx(0.31, abs=1e-15)


def test_driven_mechanisms_follow_samples(model_of: Build) -> None:
    scene = (
        on_rail("slide", "cart", "rail", mass=2.0, inertia=0.1)
        .input("way", 0.0, "m", rates=True)
        .prescribed_displacement("drive", "ground.origin", "cart.origin", motion="way")
        .simulation(t_end=1.0, dt=0.01, scheme="printed")
        .build()
    )
    model = model_of(scene)
    free = simulate(model, inputs={"way": wave})
    np.testing.assert_allclose(free.motor("drive"), -1.8 * np.sin(3 * free.t), atol=1e-14)
    times = np.linspace(0, 1, 21)
    held = simulate(model, inputs={"way": (times, wave(times))})
    np.testing.assert_allclose(held["cart.x"][::5], wave(times), atol=1e-14)


# ---- what cannot be -----------------------------------------------------------------------------------------


def test_what_a_scene_does_not_use_costs_nothing(model_of: Build) -> None:
    """An input that nothing takes is in no function but the one that shows it."""
    plain = crane(rates=True).to_dict()
    plain["joints"][1]["motion"] = "0.1 * sin(3 * t)"
    model = model_of(SceneRecord.from_dict(plain))
    assert [name for name, build in model.builders.items() if "u" in build().name_in()] == ["measures"]


@pytest.mark.parametrize(
    "change, words",
    [
        ({"rates": False}, "may jump"),
        ({"motion": "way_dot"}, "own rate"),
        ({"filter": -1.0}, "filter"),
    ],
)
def test_motions_need_rates(model_of: Build, change: dict[str, Any], words: str) -> None:
    data = crane(rates=True).to_dict()
    data["joints"][1]["motion"] = change.pop("motion", "way")
    data["inputs"]["way"] |= change
    with pytest.raises(SceneError, match=words):
        model_of(SceneRecord.from_dict(data))


@pytest.mark.parametrize(
    "inputs, words",
    [
        ({"fork": 1.0}, "no input 'fork'"),
        ({"force": np.nan}, "finite"),
        ({"force": ([0.0, 0.00015], [1.0, 2.0])}, "within a step"),
        ({"force": ([0.0, 0.0], [1.0, 2.0])}, "do not rise"),
        ({"force": ([0.0], [1.0, 2.0])}, "shapes"),
        ({"force": lambda t: 1.0 if t < 0.5 else 0.0}, "cannot be traced"),
        ({"force": lambda t: np.array([t, t])}, "one number"),
        ({"force": Sampled(lambda t, x: 0.0, 0.0)}, "every dt"),
        ({"force": Sampled(lambda t, x: 0.0, 0.01, ["cart.z"])}, "'cart.z'"),
        ({"force": Sampled(lambda t, x: 0.0, np.inf)}, "inf s apart"),
    ],
)
def test_what_cannot_be_an_input_is_refused_by_name(model_of: Build, inputs: dict[str, Any], words: str) -> None:
    with pytest.raises(SymgenError, match=words):
        simulate(model_of(cart()), inputs=inputs)


@pytest.mark.long
def test_on_the_command_line(tmp_path: Any, capsys: pytest.CaptureFixture[str]) -> None:
    """Constants as parameters, samples from a CSV, what is wrong by its row."""
    (tmp_path / "cart.toml").write_text(cart().to_toml(), encoding="utf-8")
    (tmp_path / "push.csv").write_text("t,force\n0,1\n0.5,-1\n", encoding="utf-8")
    words = ["simulate", str(tmp_path / "cart.toml"), "--json"]
    assert main([*words, "--inputs", str(tmp_path / "push.csv"), "--out", str(tmp_path / "run")]) == 0
    run = Solution.load(tmp_path / "run" / "solution.npz")
    assert run.q[-1, 0] == pytest.approx(0.125, abs=1e-14)
    assert main([*words, "--set", "force=3", "--out", str(tmp_path / "again")]) == 0
    assert Solution.load(tmp_path / "again" / "solution.npz").q[-1, 0] == pytest.approx(0.75, abs=1e-12)
    capsys.readouterr()
    (tmp_path / "push.csv").write_text("t,force\n0,1\n0.5\n", encoding="utf-8")
    assert main([*words, "--inputs", str(tmp_path / "push.csv")]) == 2
    assert "row 3" in capsys.readouterr().out


@pytest.mark.every_push("single_rate", "printed")
@pytest.mark.parametrize("scheme", ["single_rate", "printed", "coupled"])
def test_schemes_that_remember_keep_their_order_where_held_values_change(model_of: Build, scheme: str) -> None:
    """x'' = u - 4 x by hand, piece by piece: half a step's delay of a change would be an error of first order."""
    builder = Scene("pulled").input("u", 0.0, "N").rigid("mass", mass=1.0, inertia=0.1)
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    scene = builder.force("pull", "mass.origin", "u - 4 * x", 0.0).simulation(t_end=1.0, dt=0.01, scheme="rk4").build()
    model, values, times = model_of(scene), [3.0, -2.0, 1.0], [0.0, 0.3, 0.7]
    x = v = 0.0
    for u, t in zip(values, (0.3, 0.4, 0.3), strict=True):
        c, s = np.cos(2 * t), np.sin(2 * t)
        x, v = u / 4 + (x - u / 4) * c + v / 2 * s, -2 * (x - u / 4) * s + v * c
    errors = []
    for dt in (0.02, 0.01):
        run = simulate(model, scheme=scheme, dt=dt, inputs={"u": (times, values)}, force=True)
        errors.append(abs(run["mass.x"][-1] - x))
        stepper = model.stepper(scheme=scheme, dt=dt)
        for u, t in zip(values, (0.3, 0.4, 0.3), strict=True):
            stepper.step([u], round(t / dt))
        assert stepper.state["mass.x"] == run["mass.x"][-1]
    assert np.log2(errors[0] / errors[1]) > 1.9 and errors[1] < 5e-6


def counting(memory: Any) -> Sampled:
    """A controller that sums up what it saw; the sum is in `memory`."""

    def decide(t: float, x: np.ndarray, kept: np.ndarray) -> float:
        kept[0] += 0.02 * (1.0 - x[0])
        return float(kept[0] - x[1])

    return Sampled(decide, 0.02, ["cart.x", "cart.x_dot"], memory)


def test_a_controller_with_a_memory_is_gone_on_with(model_of: Build, tmp_path: Any) -> None:
    """Bit for bit, from a checkpoint between two of its samples; each run begins with the memory that was given."""
    model, law, kept = model_of(cart()), counting([0.5]), tmp_path / "run.npz"
    whole = simulate(model, inputs={"force": law}, checkpoint=kept, checkpoint_every=405)
    assert whole["force"][1] == 0.5 + 0.02  # at rest at 0
    np.testing.assert_array_equal(resume(model, kept, inputs={"force": law}).q, whole.q)
    np.testing.assert_array_equal(simulate(model, inputs={"force": law}).q, whole.q)
    with pytest.raises(SymgenError, match="another memory"):
        resume(model, kept, inputs={"force": counting([0.5, 1.0])})
    with pytest.raises(SymgenError, match="driven by other inputs"):
        resume(model, kept, inputs={"force": Sampled(lambda t, x: 0.0, 0.01, memory=())})


def test_a_memory_that_cannot_be_kept_is_refused(model_of: Build, tmp_path: Any) -> None:
    with pytest.raises(SchemeError, match="memory=\\(\\)"):
        simulate(model_of(cart()), inputs={"force": Sampled(lambda t, x: 0.0, 0.01)}, checkpoint=tmp_path / "run.npz")
    with pytest.raises(SymgenError, match="not a list of finite numbers"):
        simulate(model_of(cart()), inputs={"force": counting(["a"])})


def test_a_function_of_a_model_takes_u_and_p(model_of: Build) -> None:
    """theta'' = -(g sin theta + way'' cos theta) of the crane's load; u and p are arguments of their own."""
    model = model_of(crane(rates=True))
    assert model.input_entries == ["way", "way_dot", "way_ddot"]
    p = [entry.default for entry in model.description.parameters]
    values = {"q_i": 0.3, "q_i_dot": 0.7, "t": 0.0, "u": [0.1, 0.2, 1.7], "p": p}
    for key, name in (("q_d", "closure"), ("q_d_dot", "velocities"), ("q_i_ddot", "forward_dynamics")):
        function = model.function(name)
        values[key] = function.call([values[given] for given in function.name_in()])[0]
    assert function.size_in("u") == (3, 1) and function.size_in("p") == (len(p), 1)
    np.testing.assert_allclose(float(values["q_i_ddot"]), -(9.81 * np.sin(0.3) + 1.7 * np.cos(0.3)), rtol=1e-13)
