"""How runs fail: the named status, the last good state kept, and what happens without a working compiler."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from benchmarks.contenders.by_c_compiler import CompiledProgram, compile_source, program_source
from runtime import load_model, simulate
from runtime.contract.errors import CompilerError
from runtime.engine import c_source, llvm_code
from runtime.engine.c_source import find_compiler
from runtime.engine.interpreted import InterpretedProgram
from runtime.engine.llvm_code import NoLlvm
from runtime.engine.prepare import prepare
from runtime.model import Model
from runtime.running.monitor import Monitor
from runtime.running.planning import make_plan
from runtime.schemes.stepper import start_vector
from symgen.generate import generate
from symgen.scene import Scene, SceneRecord
from symgen.scenes import generated_folder

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")


def scaled_slider_crank(size: float) -> SceneRecord:
    """Crank and rod of the given size, spun so fast that a step turns the crank by most of a radian."""
    scene = Scene("small")
    for name, length in (("crank", size), ("rod", 2 * size)):
        scene.rigid(
            name,
            mass=1.0,
            inertia=size**2 / 12,
            center_of_mass=(length / 2, 0),
            markers={"tip": {"position": (length, 0)}},
        )
    scene.rigid("slider", mass=1.0, inertia=size**2)
    scene.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.origin")
    scene.prismatic("slide", "ground.origin", "slider.origin").revolute("C", "rod.tip", "slider.origin")
    scene.independent("crank.theta").initial({"crank.theta": 0.3}).rates({"crank.theta": 40.0})
    return scene.simulation(t_end=2.0, dt=2e-2, scheme="single_rate").build()


@pytest.mark.parametrize("size", [1.0, 1e-2, 1e-4])
def test_lost_constraints_are_seen_at_every_size(model_of: Build, size: float) -> None:
    solution = simulate(model_of(scaled_slider_crank(size)))
    assert solution.status.name == "constraints_lost"
    assert solution.constraint_error.max() < 1e-6 * size * 2
    assert solution.t[-1] == solution.status.time


def test_last_good_state_is_kept_though_it_was_not_to_be_saved(built_in: Load) -> None:
    model = built_in("two_oscillators")
    solution = simulate(model, parameters={"zeta": 0.0}, scheme="printed", m=[4], t_end=200.0, samples=1)
    assert solution.status.name == "diverged"
    assert len(solution.t) == 2
    assert solution.t[-1] == solution.status.time > 0
    assert solution.stats["steps"] == round(solution.t[-1] / solution.dt)


def test_driven_mechanism_above_its_limit_does_not_start(built_in: Load) -> None:
    model = built_in("flexible_slider_crank")
    solution = simulate(model, scheme="single_rate", dt=1e-4, t_end=1.5e-3)
    assert solution.status.name == "step_too_long"
    assert solution.stats["step_limit_at_start"] == pytest.approx(8.2e-5, rel=0.1)
    assert simulate(model, scheme="single_rate", dt=8e-5, t_end=1.6e-3).status.ok


def test_a_sweep_of_too_few_iterations_goes_on_in_parts(built_in: Load) -> None:
    model = built_in("hub_beam")
    solution = simulate(model, scheme="printed", m=[1], t_end=0.1, options={"max_iterations": 5})
    right = simulate(model, scheme="rk4", dt=1e-5, t_end=0.1, error="off", samples=1)
    assert solution.status.ok and solution.stats["divided_steps"] > 10
    assert np.abs(solution.q[-1] - right.q[-1]).max() < 1e-6


def test_start_that_is_not_finite(tmp_path: Path) -> None:
    """M_hat is singular for the changed parameter, which no sign rule catches."""
    scene = (
        Scene("pair")
        .parameter("c", 0.5)
        .structure(coordinates=["a", "b"], mass=[[1.0, "c"], ["c", 1.0]], stiffness=[[1.0, 0.0], [0.0, 1.0]])
    )
    model = load_model(generate(scene.initial({"a": 1.0}).build(), tmp_path / "pair"))
    solution = simulate(model, parameters={"c": 1.0}, scheme="single_rate", t_end=1.0, dt=0.1)
    assert solution.status.name == "not_finite"
    assert "M_hat" in solution.status.advice


def test_deflection_beyond_second_order_stiffening(model_of: Build) -> None:
    """The truncated kinetic energy loses its sign at about a fifth of the length; a run says so."""
    arm = Scene("arm").beam(
        "arm",
        length=0.6,
        density=2700.0,
        area=4e-5,
        second_moment=1.3e-11,
        youngs_modulus=7e10,
        lateral={"ends": "clamped-free", "modes": 2},
        stiffening=True,
    )
    arm.revolute("hinge", "ground.origin", "arm.start").simulation(t_end=0.1, dt=2e-5, scheme="single_rate")
    model = model_of(arm.build())
    assert simulate(model, initial={"arm.q1": 0.05}, t_end=0.01).status.ok
    solution = simulate(model, initial={"arm.q1": 0.2})
    assert solution.status.name == "mass_not_positive"
    assert "stiffening" in solution.status.advice


@pytest.mark.usefixtures("ctrl_c")
def test_interrupted_run_keeps_what_it_has(built_in: Load) -> None:
    calls = 0

    def progress(t: float, t_end: float) -> None:
        nonlocal calls
        calls += 1
        if calls == 20:
            signal.raise_signal(signal.SIGINT)

    solution = simulate(built_in("pendulum"), t_end=1000.0, dt=1e-3, seen_every=0.0, progress=progress)
    assert solution.status.name == "interrupted"
    assert solution.t[-1] == pytest.approx(solution.status.time)
    assert len(solution.t) >= 20


def test_no_saved_state_is_missing_before_an_interruption(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """Ctrl-C that stops at once, in the middle of the states that are saved between two looks."""
    advance, calls = InterpretedProgram.run, [0]

    def interrupted(self: InterpretedProgram, z: np.ndarray, c: np.ndarray, n: int) -> None:
        calls[0] += 1
        if calls[0] == 300:
            raise KeyboardInterrupt
        advance(self, z, c, n)

    monkeypatch.setattr(InterpretedProgram, "run", interrupted)
    settings = {"scheme": "single_rate", "dt": 1e-3, "t_end": 2.0, "seen_every": 0.0, "engine": "interpreted"}
    run = simulate(built_in("pendulum"), **settings)
    assert run.status.name == "interrupted" and 20 < len(run.t) < 300
    np.testing.assert_allclose(np.diff(run.t), 1e-3, rtol=1e-9)


def test_auto_interprets_where_there_is_no_llvm(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing() -> None:
        raise NoLlvm("llvmlite cannot be used: not installed")

    monkeypatch.setattr(llvm_code, "_llvm", missing)
    model = load_model(generated_folder("pendulum"))
    solution = simulate(model, t_end=0.1)
    assert solution.stats["engine"] == "interpreted"
    assert "llvmlite cannot be used" in str(solution.stats["engine_note"])
    with pytest.raises(CompilerError, match="llvmlite"):
        simulate(model, engine="compiled", t_end=0.1)


def test_engines_that_cannot_be_had(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "/no/such/compiler")
    assert simulate(built_in("pendulum"), t_end=0.1).stats["engine"] == "compiled"
    with pytest.raises(ValueError, match="auto, compiled, interpreted"):
        simulate(built_in("pendulum"), engine="gpu", t_end=0.1)


@needs_compiler
def test_damaged_cache_is_built_again(built_in: Load, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path))
    program = make_plan(built_in("pendulum"), 1.0, 1e-3, None, "single_rate", 1, None, 0.0).scheme.program()
    compile_source(program_source(program)).write_bytes(b"")  # not loaded yet: a loader remembers paths
    assert CompiledProgram(program).library.stat().st_size > 0


@pytest.mark.every_push("flexible_slider_crank")
@needs_compiler
@pytest.mark.parametrize("name", ["flexible_slider_crank", "chain"])
def test_chunked_code_agrees_bit_for_bit(built_in: Load, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Long stages are split; small limits split short ones too. Four threads must not disturb each other."""
    monkeypatch.setattr(c_source, "MAX_CODE_OPERATIONS", 20)
    monkeypatch.setattr(c_source, "STATEMENTS_OF_CHUNK", 7)
    model = built_in(name)
    plan = make_plan(model, 0.01, None, None, "single_rate", 1, None, 0.0)
    c = model.constants(model.parameter_vector())
    prepared = prepare(plan.scheme.program(), plan.scheme.layout.size, plan.scheme.c_size)
    ready = prepared.ready(plan.scheme.constants(c))
    start = prepared.widened(start_vector(plan.scheme, 0.0, model.initial_q, model.initial_q_dot, c))
    expected = start.copy()
    InterpretedProgram(prepared.program, len(start), len(ready)).run(expected, ready, 200)
    compiled = CompiledProgram(prepared.program)
    states = [start.copy() for _ in range(4)]
    threads = [threading.Thread(target=compiled.run, args=(state, ready, 200)) for state in states]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for state in states:
        assert np.array_equal(state, expected)


@pytest.mark.long
def test_printed_scheme_with_default_tolerance_keeps_its_order(built_in: Load) -> None:
    """m = 1 with strong inertia coupling: the stopping test must not spoil small steps."""
    model = built_in("hub_beam")
    exact = simulate(model, scheme="single_rate", dt=1e-5, t_end=0.2, samples=1).q_i[-1]
    steps = np.array([8e-4, 4e-4, 2e-4])
    errors = [
        np.abs(simulate(model, scheme="printed", m=[1], dt=float(dt), t_end=0.2, samples=1).q_i[-1] - exact).max()
        for dt in steps
    ]
    assert abs(np.polyfit(np.log(steps), np.log(errors), 1)[0] - 2.0) < 0.1
    assert errors[-1] < 5e-8


def test_nan_behind_a_finite_state_is_seen(built_in: Load) -> None:
    """The state of the scheme is finite, what follows from it is not: that must not pass as good."""
    model = built_in("four_bar")
    scheme = make_plan(model, 0.1, 1e-3, None, "single_rate", 1, None, 0.0).scheme
    c = model.constants(model.parameter_vector())
    z = start_vector(scheme, 0.0, model.initial_q, model.initial_q_dot, c)
    assert Monitor(model, scheme, c).first(z) is None
    status = Monitor(model, scheme, np.full_like(c, np.nan)).first(z)
    assert status is not None
    assert status.name == "mass_not_positive"


@pytest.mark.parametrize("friction, word", [(0.0, "frequency"), (2000.0, "A damper makes a motion decay")])
def test_a_body_bent_by_too_long_a_step_names_the_step_first(
    model_of: Callable[[SceneRecord], Model], friction: float, word: str
) -> None:
    """A slider-crank with an elastic rod, a stiff Coulomb law on its slider, steps above the limit of the scheme."""
    scene = Scene("rubbed").gravity(0, -9.81)
    scene.rigid("crank", mass=1.0, inertia=0.01, markers={"tip": {"position": (0.1, 0)}})
    steel = {"density": 7800, "area": 1e-4, "second_moment": 1e-9, "youngs_modulus": 2e11}
    scene.beam("strut", length=0.4, **steel, lateral={"modes": 2}).rigid("slider", mass=0.5, inertia=0.01)
    scene.revolute("a", "ground.origin", "crank.origin").revolute("b", "crank.tip", "strut.start")
    scene.revolute("c", "strut.end", "slider.origin").prismatic("d", "ground.origin", "slider.origin")
    scene.measure("x", "x", "slider.origin").force("mu", "slider.origin", f"-{friction!r}*tanh(x_dot/1e-4)", 0)
    scene.torque("drive", "crank.origin", 8.0).initial({"crank.theta": 0.5}).rates({"crank.theta": 2.0})
    run = simulate(model_of(scene.build()), scheme="single_rate", dt=1e-3, t_end=0.5, force=True)
    assert run.status.name == "deflection_too_large"
    assert run.status.advice.startswith("The step of 0.001 s is too long here.") and word in run.status.advice


@pytest.mark.parametrize("scheme", ["rk4", "single_rate", "auto"])
def test_a_spring_whose_ends_meet_is_named(model_of: Build, scheme: str) -> None:
    """Its force has no direction there; a little turned, the same scene runs."""
    scene = Scene("meet").ground(markers={"peg": {"position": (0.5, 0.0)}})
    scene.rigid("bar", mass=1.0, inertia=0.1, markers={"tip": {"position": (0.5, 0.0)}})
    scene.revolute("pin", "ground.origin", "bar.origin")
    scene.spring_damper("spring", "ground.peg", "bar.tip", stiffness=100.0, free_length=0.2)
    model = model_of(scene.simulation(t_end=0.1, dt=1e-3, scheme="rk4").build())
    met = simulate(model, scheme=scheme)
    assert met.status.name == "not_finite" and "'spring'" in met.status.cause and met.status.time == 0.0
    assert simulate(model, scheme=scheme, initial={"bar.theta": 0.4}).status.ok
