"""A run ends at t_end: where no whole number of steps fits, its last step is shorter, however it is made."""

from __future__ import annotations

import math
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import SCHEMES, DifferentiableRun, Model, Sampled
from runtime.engine.c_source import find_compiler
from symgen import Scene
from tests.export.bundles import STRICT, bundle

K, MASS, SAG = 40.0, 2.0, 0.25  # N/m, kg, m: x = SAG cos(w t)
DT, T_END = 0.01, 0.524  # 52 steps and 0.4 of one
Load = Callable[[str], Model]


def oscillator(**simulation: Any) -> Scene:
    """A mass on a spring along a rail, and a push along it."""
    return (
        Scene("oscillator")
        .input("push", 0.0, "N", "along the rail")
        .rigid("cart", mass=MASS, inertia=0.1)
        .prismatic("rail", "ground.origin", "cart.origin")
        .measure("way", "x", "cart.origin")
        .force("spring", "cart.origin", f"push - {K}*way", 0.0)
        .initial({"cart.x": SAG})
        .simulation(**{"scheme": "rk4", "dt": DT, "t_end": T_END, **simulation})
    )


@pytest.fixture(scope="module")
def model() -> Model:
    return oscillator().model()


def right(t: np.ndarray | float) -> np.ndarray:
    return SAG * np.cos(math.sqrt(K / MASS) * np.asarray(t))


def test_the_last_step_is_shorter(model: Model) -> None:
    """Three steps of 0.3 s, and one of 0.1 s: it ended at 1.2 s."""
    run = model.simulate(scheme="rk4", dt=0.3, t_end=1.0, seen_every=0.0, error="off", force=True)
    np.testing.assert_allclose(run.t, [0.0, 0.3, 0.6, 0.9, 1.0], rtol=1e-15)
    assert run.t[-1] == 1.0 == run.status.time and run.status.ok
    assert run.stats["steps"] == 4 and run.stats["last_step"] == pytest.approx(0.1, rel=1e-12)
    h, state = np.array([0.3, 0.3, 0.3, 0.1]), np.array([SAG, 0.0])
    A = np.array([[0.0, 1.0], [-K / MASS, 0.0]])
    for one in h:  # of a linear system rk4 is the exponential series up to its fourth power
        state = sum(np.linalg.matrix_power(one * A, k) / math.factorial(k) for k in range(5)) @ state
    np.testing.assert_allclose([run["cart.x"][-1], run["cart.x_dot"][-1]], state, rtol=1e-12)


@pytest.mark.parametrize("scheme", ["rk4", "single_rate", "printed", "radau"])
@pytest.mark.parametrize(("t0", "end", "dt", "steps"), [(0.0, 1.0, 0.0999999999, 10), (2.0, 3.0, 0.2500000001, 4)])
def test_steps_that_divide_but_for_their_last_digits_end_at_the_end(
    model: Model, scheme: str, t0: float, end: float, dt: float, steps: int
) -> None:
    """They ended 1e-9 s before it, or 4e-10 s past it."""
    run = model.simulate(scheme=scheme, t0=t0, t_end=end, dt=dt, seen_every=0.0, error="off", force=True)
    assert len(run.t) == steps + 1 and run.t[-1] == pytest.approx(end, rel=1e-15)
    np.testing.assert_allclose(np.diff(run.t), (end - t0) / steps, rtol=1e-13)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_each_method_is_as_right_at_the_end_as_before_it(model: Model, scheme: str) -> None:
    run = model.simulate(scheme=scheme, dt=DT, t_end=T_END, seen_every=0.0)
    assert run.status.name == "completed" and run.t[-1] == T_END and len(run.t) == 54
    off = np.abs(run["cart.x"] - right(run.t))
    assert off[-1] <= 1.5 * off.max(initial=0.0, where=run.t < T_END) + 1e-14
    longer = model.simulate(scheme=scheme, dt=DT, t_end=0.53, seen_every=0.0, error="off")
    np.testing.assert_array_equal(run.q[:-1], longer.q[:-1])  # steps before it are what they are in a longer run
    assert "last_step" not in longer.stats and len(longer.t) == 54


@pytest.mark.every_push("heavy_top-exponential_adams")
@pytest.mark.parametrize(("name", "scheme"), [("flexible_four_bar", "printed"), ("heavy_top", "exponential_adams")])
def test_methods_that_remember_start_anew_for_it(built_in: Load, name: str, scheme: str) -> None:
    model, dt = built_in(name), 1e-5
    run = model.simulate(scheme=scheme, dt=dt, t_end=100.3 * dt, error="off")
    fine = model.simulate(scheme="dopri5", dt=dt / 4, t_end=100.3 * dt, error="off")
    assert run.t[-1] == 100.3 * dt == fine.t[-1]
    between = model.simulate(scheme=scheme, dt=dt, t_end=100 * dt, error="off").q[-1]
    reference = model.simulate(scheme="dopri5", dt=dt / 4, t_end=100 * dt, error="off").q[-1]
    scale = np.abs(fine.q[-1]).max()
    assert np.abs(run.q[-1] - fine.q[-1]).max() <= 3 * np.abs(between - reference).max() + 1e-13 * scale


def test_engines_agree_in_it(model: Model) -> None:
    for scheme in ("single_rate", "dopri5"):
        made = [model.simulate(scheme=scheme, engine=one, error="off") for one in ("compiled", "interpreted")]
        np.testing.assert_array_equal(made[0].q, made[1].q)


def test_samples_streams_and_outputs_end_there(model: Model, tmp_path: Path) -> None:
    every = model.simulate(seen_every=0.0)
    for how in ({"seen_every": 0.1}, {"samples": 3}, {"outputs": ["cart.x"]}, {"stream": tmp_path / "stream"}):
        run = model.simulate(**how)  # type: ignore[arg-type]
        assert run.t[-1] == T_END and run["cart.x"][-1] == every["cart.x"][-1], how


def test_it_is_resumed_with_the_same_bits(model: Model, tmp_path: Path) -> None:
    path, kept = tmp_path / "run.npz", dict[float, bytes]()

    def keep(t: float, t_end: float) -> None:
        kept[t] = path.read_bytes() if path.exists() else b""

    for scheme in ("rk4", "single_rate"):
        kept.clear()
        whole = model.simulate(scheme=scheme, checkpoint=path, checkpoint_every=52, progress=keep)
        assert max(kept) == T_END
        path.write_bytes(kept[52 * DT])
        resumed = model.resume(path)
        np.testing.assert_array_equal(resumed.q, whole.q)
        np.testing.assert_array_equal(resumed.t, whole.t)
        assert resumed.status == whole.status and resumed.error.largest == whole.error.largest


@pytest.mark.every_push("rk4")
@pytest.mark.parametrize("scheme", ["rk4", "single_rate", "exponential"])
def test_ensembles_end_there_with_the_bits_of_single_runs(model: Model, scheme: str) -> None:
    pushes = [0.0, 3.0, -5.0]
    how = {"scheme": scheme, "dt": DT, "t_end": T_END}
    found = model.ensemble({"push": pushes}, outputs=["cart.x"], seen_every=0.1, **how)
    assert found["time"][-1] == T_END
    for k, push in enumerate(pushes):
        alone = model.simulate(parameters={"push": push}, seen_every=0.1, error="off", **how)  # type: ignore[arg-type]
        np.testing.assert_array_equal(np.asarray(found["cart.x"])[k], alone["cart.x"])
    reduced = model.ensemble({"push": pushes}, reduce={"cart.x": ["end", "peak"]}, **how)
    np.testing.assert_array_equal(np.asarray(reduced["cart.x_end"]), np.asarray(found["cart.x"])[:, -1])
    assert (np.asarray(reduced["time_reached"]) == T_END).all()


@pytest.mark.parametrize("scheme", ["rk4", "single_rate"])
def test_derivatives_are_of_the_motion_until_there(model: Model, scheme: str) -> None:
    """x(t_end) = SAG cos(w t_end): by SAG it is cos, by the mass it is SAG sin(w t) w t / 2 m."""
    run = DifferentiableRun(model, ["cart.x"], ["cart.x", "cart.mass"], scheme=scheme, dt=DT / 8, t_end=T_END)
    found, w = run.jacobian(run.x0), math.sqrt(K / MASS)
    assert found.t[-1] == T_END
    assert found["cart.x", "cart.x"][-1] == pytest.approx(math.cos(w * T_END), rel=1e-4)
    by_mass = SAG * math.sin(w * T_END) * w * T_END / (2 * MASS)
    assert found["cart.x", "cart.mass"][-1] == pytest.approx(by_mass, rel=1e-4)
    alone = model.simulate(scheme=scheme, dt=DT / 8, t_end=T_END, error="off")
    np.testing.assert_allclose(found.values[-1, 0], alone["cart.x"][-1], rtol=1e-14)


def test_tolerances_end_there_whatever_the_samples_and_controllers(model: Model) -> None:
    """Samples 0.1 s apart, a controller every 0.05 s: neither fits into 0.524 s. It ended at 0.6 s."""
    for how in ({"seen_every": 0.1}, {"inputs": {"push": Sampled(lambda t, y: 0.0, every=0.05, memory=[])}}, {}):
        for more in ({"tolerance": 1e-5}, {"tolerance": 1e-6, "scheme": "dopri5", "options": {"error_of": "step"}}):
            run = model.simulate(t_end=T_END, **how, **more)  # type: ignore[arg-type]
            assert run.status.name == "completed" and run.t[-1] == pytest.approx(T_END, abs=1e-15), (how, more)
            assert abs(run["cart.x"][-1] - right(T_END)) < 1e-4 * SAG


def test_steps_of_a_tolerance_show_a_last_state_there(model: Model) -> None:
    run = model.simulate(scheme="dopri5", dt=0.1, t_end=T_END, options={"tolerance": 1e-8}, seen_every=0.0)
    np.testing.assert_allclose(run.t, [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, T_END], rtol=1e-14)
    np.testing.assert_allclose(run["cart.x"], right(run.t), atol=1e-6)


@pytest.mark.long
def test_what_jumps_or_happens_in_the_last_step_is_not_lost(model: Model) -> None:
    """A push sets in within the shorter step, an event ends the run in it, and behind t_end nothing happens."""
    for scheme in ("rk4", "single_rate"):
        scene = oscillator(scheme=scheme).force("late", "cart.origin", "where(t >= 0.5225, 400, 0)", 0.0)
        run = scene.model().simulate(seen_every=0.0)
        after = T_END - 0.5225
        w = math.sqrt(K / MASS)
        expected = -SAG * w * math.sin(w * T_END) + 400 / MASS * math.sin(w * after) / w
        assert run.t[-1] == T_END and run["cart.x_dot"][-1] == pytest.approx(expected, rel=2e-3)
    way = float(right(0.5225))
    for level, ends in ((way, True), (float(right(0.526)), False)):
        scene = oscillator().event("level", when=f"way - {level!r}", direction="either", terminal=True)
        adaptive = {"scheme": "dopri5", "options": {"tolerance": 1e-8}}
        for how in ({}, {"scheme": "single_rate", "dt": 1e-3 / 3}, adaptive, {**adaptive, "dt": 0.1}):
            run = scene.model().simulate(seen_every=0.0, **how)  # type: ignore[arg-type]
            assert run.status.name == ("event" if ends else "completed"), how
            assert run.t[-1] == pytest.approx(0.5225 if ends else T_END, abs=1e-6), how


@pytest.mark.parametrize("beside", [-0.0305, -3e-5, 3e-5, 1.5e-3])
def test_a_run_may_end_beside_a_singular_position(built_in: Load, beside: float) -> None:
    """Just before it, where the position is not told, behind it, and where steps are made again: energy is kept."""
    t_end = 0.7143555 + beside
    run = built_in("n_four_bar").simulate(scheme="rk4", dt=1e-3, t_end=t_end, error="off")
    assert run.status.ok and run.t[-1] == t_end
    assert [event.kind for event in run.events] == (["singular_position"] if beside > 0 else [])
    total = run.energy["kinetic"] + run.energy["potential"]
    assert np.ptp(total) < 1e-6 * np.ptp(run.energy["kinetic"])


def test_driven_mechanisms_end_there() -> None:
    scene = (
        Scene("turntable")
        .rigid("disc", mass=1.0, inertia=0.1)
        .revolute("axle", "ground.origin", "disc.origin")
        .prescribed_angle("drive", "ground.origin", "disc.origin", motion="2*t")
        .simulation(t_end=1.0, dt=0.3)
    )
    run = scene.model().simulate(dt=0.3)
    np.testing.assert_allclose(run.t, [0.0, 0.3, 0.6, 0.9, 1.0], rtol=1e-15)
    assert run["disc.theta"][-1] == pytest.approx(2.0, rel=1e-12)


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
@pytest.mark.parametrize("scheme", ["rk4", "single_rate", "exponential"])
def test_exported_code_ends_there_with_the_bits_of_a_run(model: Model, scheme: str, tmp_path: Path) -> None:
    own = bundle(model, tmp_path, scheme=scheme, dt=DT)
    own.step(52)
    assert own.call("finish", own.z, own.c, own.p, T_END, own.w) == 0
    run = model.simulate(scheme=scheme, dt=DT, t_end=T_END, error="off")
    place = [one.name for one in own.one.outputs].index("cart.x")
    assert own.observe()[place] == run["cart.x"][-1]
    command = [str(find_compiler()), *STRICT, "-O1", "oscillator.c", "main.c", "-o", "example", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    lines = subprocess.run(["./example"], cwd=tmp_path, check=True, capture_output=True, text=True).stdout.split("\n")
    rows = np.array([[float(one) for one in line.split(",")] for line in lines[1:] if line])
    assert rows[-1, 0] == T_END and rows[-1, 1 + place] == run["cart.x"][-1] and len(rows) == 54
