"""A model as C: the bits of the runtime, strict C99, nothing global, and refusals by name."""

from __future__ import annotations

import shutil
import subprocess
import threading
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import ModelError
from runtime.engine import c_source
from runtime.engine.c_source import find_compiler
from runtime.export.c_bundle import exported, write_c
from runtime.model import Model
from symgen.cli import main
from symgen.scene import Scene, SceneRecord
from tests.export.bundles import STRICT, bundle
from tests.support.input_scenes import cart

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
SCENES = [  # flexible with sub-steps, loops with an iteration, a loop in space, turns, a tree
    ("flexible_slider_crank_free", "exponential"),
    ("flexible_slider_crank", "printed"),
    ("bricard", "rk4"),
    ("heavy_top", "single_rate"),
    ("chain", "rk4"),
    ("spatial_slider_crank", "exponential"),  # a finite-element body
]
STEPS = 1000


def on_a_table() -> SceneRecord:
    """A cart under a force from a table over its way, an input and smooth dry friction."""
    x = np.linspace(-1.0, 2.0, 40)
    return (
        Scene("on_a_table")
        .input("push", 0.5, "N", "from outside")
        .table("curve", x=list(x), y=list(np.sin(3 * x)), interpolation="cubic")
        .rigid("cart", mass=1.0, inertia=0.1)
        .prismatic("rail", "ground.origin", "cart.origin")
        .measure("way", "x", "cart.origin")
        .force("drive", "cart.origin", 'push - table("curve", way) - 0.2*tanh(way_dot/0.01)', 0.0)
        .initial({"cart.x": 0.1})
        .simulation(t_end=1.0, dt=1e-3, scheme="rk4")
        .build()
    )


@pytest.mark.every_push("flexible_slider_crank_free-exponential", "flexible_slider_crank-printed")
@needs_compiler
@pytest.mark.parametrize("name, scheme", SCENES)
def test_exported_steps_have_the_bits_of_the_runtime(built_in: Load, name: str, scheme: str, tmp_path: Path) -> None:
    model = built_in(name)
    own, stepper = bundle(model, tmp_path, scheme=scheme), model.stepper(scheme=scheme)
    state = stepper.save().z
    np.testing.assert_array_equal(own.z, state)
    started = np.zeros_like(own.z)
    own.call("start", started, own.c, 0.0, np.array([one.start for one in own.one.x]), own.w)
    np.testing.assert_array_equal(started, state)
    own.step(STEPS)
    stepper.step(STEPS)
    assert not np.array_equal(own.z, state)
    np.testing.assert_array_equal(own.z, stepper.save().z)
    np.testing.assert_array_equal(own.observe(), stepper.reader([one.name for one in own.one.outputs])())


@needs_compiler
def test_inputs_tables_and_parameters_have_the_bits_of_the_runtime(model_of: Build, tmp_path: Path) -> None:
    model = model_of(on_a_table())
    own, stepper = bundle(model, tmp_path), model.stepper()
    for value in (0.3, -0.8, 2.0):
        own.call("hold", own.z, own.c, np.array([value]), own.w)
        own.step(50)
        stepper.step({"push": value}, 50)
    place = [one.name for one in own.one.parameters].index("cart.mass")
    own.p[place] = 1.7
    own.call("constants", own.c, own.p, own.dt, own.w)
    stepper.change({"cart.mass": 1.7})
    own.step(200)
    stepper.step(200)
    np.testing.assert_array_equal(own.z, stepper.save().z)


@needs_compiler
def test_schemes_that_remember_start_anew_where_inputs_change(model_of: Build, tmp_path: Path) -> None:
    model = model_of(cart(scheme="single_rate"))
    own, stepper = bundle(model, tmp_path), model.stepper()
    for value in (1.0, 1.0, -3.0):
        own.call("hold", own.z, own.c, np.array([value]), own.w)
        own.step(7)
        stepper.step({"force": value}, 7)
    np.testing.assert_array_equal(own.z, stepper.save().z)
    assert own.z[own.one.scheme.layout.slice("x")] != 0


@needs_compiler
def test_a_restart_goes_on_with_other_steps(model_of: Build, tmp_path: Path) -> None:
    """Uniform acceleration is exact for either step: x = t^2 / 4, then on from 0.007 s."""
    own = bundle(model_of(cart(scheme="single_rate")), tmp_path)
    own.call("hold", own.z, own.c, np.array([1.0]), own.w)
    own.step(7)
    own.call("restart", own.z, own.c, own.dt, 0.25 * own.dt, own.w)
    own.call("constants", own.c, own.p, 0.25 * own.dt, own.w)
    own.step(13)
    t = 7 * own.dt + 13 * 0.25 * own.dt
    place = [one.name for one in own.one.outputs].index("cart.x")
    assert own.observe()[place] == pytest.approx(t**2 / 4, rel=1e-12)


@pytest.mark.every_push("flags1-flexible_slider_crank")  # compiling the spatial one takes some ten seconds
@needs_compiler
@pytest.mark.parametrize("name", ["flexible_slider_crank", "spatial_slider_crank"])
@pytest.mark.parametrize(
    "flags", [("-O0",), ("-O2",), (*STRICT, "-O3", "-march=native"), ("-std=gnu11", "-O3", "-march=native")]
)
def test_flags_of_the_compiler_change_no_bit(built_in: Load, flags: tuple[str, ...], name: str, tmp_path: Path) -> None:
    """The second one has pairs of sums and differences of products, which gcc 12 joins with contraction off, too."""
    model = built_in(name)
    own, stepper = bundle(model, tmp_path, *flags), model.stepper()
    own.step(STEPS)
    stepper.step(STEPS)
    np.testing.assert_array_equal(own.z, stepper.save().z)


@pytest.mark.long
@needs_compiler
def test_long_stages_pass_values_through_the_callers_array(
    built_in: Load, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Four instances side by side: each has all of its memory."""
    monkeypatch.setattr(c_source, "MAX_CODE_OPERATIONS", 20)
    monkeypatch.setattr(c_source, "STATEMENTS_OF_CHUNK", 7)
    model = built_in("flexible_slider_crank")
    own, stepper = bundle(model, tmp_path), model.stepper()
    states, works = [own.z.copy() for _ in range(4)], [np.zeros(len(own.w)) for _ in range(4)]
    assert len(own.w) > 100
    threads = [
        threading.Thread(target=own.call, args=("step", z, own.c, w, STEPS)) for z, w in zip(states, works, strict=True)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    stepper.step(STEPS)
    for state in states:
        np.testing.assert_array_equal(state, stepper.save().z)


def test_no_model_takes_the_name_of_the_example(built_in: Load, tmp_path: Path) -> None:
    with pytest.raises(ModelError, match=r"name of the example, main\.c"):
        write_c(exported(built_in("double_pendulum"), name="main"), tmp_path)
    assert not list(tmp_path.iterdir())


@needs_compiler
@pytest.mark.skipif(shutil.which("nm") is None, reason="no nm")
def test_names_are_prefixed_and_nothing_is_writable(built_in: Load, tmp_path: Path) -> None:
    write_c(exported(built_in("double_pendulum"), name="two arms"), tmp_path)
    command = [str(find_compiler()), *STRICT, "-fno-pic", "-c", "two_arms.c"]
    subprocess.run(command, cwd=tmp_path, check=True)
    found = subprocess.run(["nm", "--defined-only", "two_arms.o"], cwd=tmp_path, capture_output=True, text=True)
    symbols = [line.split()[-2:] for line in found.stdout.splitlines()]
    outside = [name for kind, name in symbols if kind.isupper()]
    assert outside and all(name.startswith("two_arms_") for name in outside)
    assert {kind for kind, _ in symbols} <= set("TtRr")  # code and constants


@needs_compiler
def test_the_example_runs_as_the_runtime_does(built_in: Load, tmp_path: Path) -> None:
    own = bundle(built_in("pendulum"), tmp_path)
    files = built_in("pendulum").export_c(tmp_path / "again")
    assert files and all(path.read_bytes() == (tmp_path / path.name).read_bytes() for path in files)
    t_end = float(own.one.model.simulation["t_end"])
    assert f"Runs pendulum for {t_end:g} s " in (tmp_path / "main.c").read_text(encoding="utf-8")
    command = [str(find_compiler()), *STRICT, "pendulum.c", "main.c", "-o", "example", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    rows = subprocess.run(["./example"], cwd=tmp_path, check=True, capture_output=True, text=True).stdout.splitlines()
    assert rows[0].split(",") == ["t", *(one.name for one in own.one.outputs)]
    stepper = built_in("pendulum").stepper()
    last = [float(value) for value in rows[-1].split(",")]
    assert last[0] == pytest.approx(t_end)
    stepper.step(round(last[0] / stepper.dt))
    assert last == [stepper.time, *stepper.reader([one.name for one in own.one.outputs])()]


def test_what_cannot_leave_is_refused_by_name(built_in: Load, tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    assert main(["export", "c", "pendulum", "--scheme", "rk5", "--out", str(tmp_path / "there")]) != 0
    assert "rk5" in capsys.readouterr().err
    assert not (tmp_path / "there").exists()
