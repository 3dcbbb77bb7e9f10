"""Exported C across jumps in time, events and kinks: the bits of the runtime, by parts of steps as it makes them."""

from __future__ import annotations

import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

import runtime.schemes.switching
from runtime import ModelError, simulate
from runtime.engine.c_source import find_compiler
from runtime.export.c_bundle import exported, write_c
from runtime.model import Model
from symgen.scene import Scene, SceneRecord, trapezoid
from tests.export.bundles import STRICT, Bundle, bundle

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
SWITCHING = Path(str(runtime.schemes.switching.__file__)).parent
pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")


def cart(name: str, force: str, x: float = 0.1, v: float = 0.0) -> Scene:
    """1 kg on a rail under a force."""
    builder = Scene(name).rigid("cart", mass=1.0, inertia=0.1).prismatic("rail", "ground.origin", "cart.origin")
    builder.measure("way", "x", "cart.origin").force("drive", "cart.origin", force, 0.0)
    return builder.initial({"cart.x": x}).rates({"cart.x": v})


def jumping() -> Scene:
    """Jumps within steps, on the grid, by less than a step and by nearly nothing, some ever again, one by an input."""
    once = "where(t < 0.0123, 1, -2) + where(t >= 0.05, 1, 2)"
    near = "where(t > 0.05000000001, 1, 2) + where(t > 0.0500003, -4, 2)"
    ever = "where(sin(1000 * t) > 0.2, 1, 0) - 20 * way + step(t - late)"
    return cart("jumping", f"{once} + {near} + {ever}").input("late", 0.5, "s")


def relay() -> Scene:
    """Events that set an input, one of them after a rest, and one that ends the motion."""
    builder = cart("relay", "2 * on - 0.3 * way_dot + where(t < 0.3, 0, 1)").input("on", 1.0, "N")
    builder.event("far", "way - 0.15", direction="rising", action={"on": "-on - 0.1 * way"})
    builder.event("near", "way + 0.1", direction="falling", action={"on": 1.0}, cool_down=0.013)
    return builder.event("over", "t - 3.7654321", terminal=True)


def kinks() -> Scene:
    """A spring that pushes only, and the top of each flight."""
    return cart("kinks", "max(0, -way) * 1e4 - 9.81", 0.05).event("top", "way_dot", direction="falling")


def by_place() -> Scene:
    """A spring beside a force that acts beyond a place, and with a rate only: each is passed there and back."""
    return cart("by_place", "-100 * way + where(way > 0.02, -3, where(way_dot > 0, 1, -1))", 0.05)


def between() -> Scene:
    """What passes zero and comes back within one long step."""
    builder = cart("between", "-100 * way - 0.1 * n").input("n", 0.0).input("m", 0.0)
    builder.event("tip", "way - 0.0999", direction="rising", action={"n": "n + 1"})
    return builder.event("tops", "cos(30 * t) - 0.999", action={"m": "m + 1"})


def before_a_kink() -> Scene:
    """What passes zero twice, of which one way counts, before a wall is met in the same long step."""
    builder = cart("before_a_kink", "-20 * max(0, way - 0.25) + 0 * n", 0.0, 1.0).input("n", 0.0)
    return builder.event("turn", "cos(20 * t + 1.2)", direction="rising", action={"n": "n + 1"})


def chattering() -> Scene:
    """Two events that undo each other."""
    builder = cart("chattering", "n", v=0.1).input("n", -1.0, "N")
    builder.event("up", "way_dot", direction="rising", action={"n": -1.0})
    return builder.event("down", "way_dot", direction="falling", action={"n": 1.0})


def humming() -> Scene:
    """A kink that comes ever again is slept over."""
    return cart("humming", "-20 * sign(way_dot) + 5 * sin(3 * t)", v=0.1)


def travelling() -> Scene:
    """A load on a cart whose velocity is a trapezoid from rest to rest: its acceleration jumps four times."""
    builder = Scene("travelling").rigid("cart", mass=5.0, inertia=0.1)
    builder.rigid("load", mass=2.0, inertia=0.1, markers={"top": {"position": [0.0, 1.0]}}).gravity(0, -9.81)
    builder.prismatic("rail", "ground.origin", "cart.origin").revolute("hinge", "cart.origin", "load.top")
    builder.table("move", **trapezoid(0.5, speed=0.5, acceleration=1.0))
    return builder.prescribed_displacement("drive", "ground.origin", "cart.origin", motion="table('move', t)")


def starting() -> Scene:
    """A hook whose velocity begins from zero where its motion is switched on: nothing gives it an impulse."""
    builder = Scene("starting").rigid("cart", mass=5.0, inertia=0.1).gravity(0, -9.81)
    builder.rigid("load", mass=2.0, inertia=0.1, markers={"top": {"position": [0.0, 1.0]}})
    builder.prismatic("rail", "ground.origin", "cart.origin").revolute("hinge", "cart.origin", "load.top")
    motion = "where(t < 0.25, 0, (t - 0.25) * (t - 0.25))"
    return builder.prescribed_displacement("drive", "ground.origin", "cart.origin", motion=motion)


CASES = [  # scene, scheme, step, steps, how it ends
    (jumping, "rk4", 1e-3, 1500, 0),
    (jumping, "single_rate", 1e-3, 1500, 0),
    (relay, "rk4", 1e-3, 4000, 1),
    (relay, "single_rate", 1e-3, 4000, 1),
    (kinks, "exponential", 1e-3, 2000, 0),
    (between, "rk4", 0.05, 60, 0),
    (before_a_kink, "rk4", 0.3, 8, 0),
    (travelling, "rk4", 3e-3, 600, 0),
    (starting, "rk4", 3e-3, 300, 0),
    (between, "single_rate", 0.05, 60, 0),
    (chattering, "rk4", 0.01, 100, 2),
    (humming, "single_rate", 0.01, 500, 0),
    (by_place, "rk4", 0.01, 300, 0),
    (by_place, "single_rate", 0.01, 300, 0),
]


def same(own: Bundle, stepper: object) -> None:
    """All numbers that the runtime's state has."""
    z = stepper.save().z  # type: ignore[attr-defined]
    np.testing.assert_array_equal(own.z[: len(z)], z)


@pytest.mark.every_push("relay-rk4-0.001-4000-1", "kinks-exponential-0.001-2000-0")
@pytest.mark.parametrize(("scene", "scheme", "dt", "steps", "end"), CASES)
def test_steps_with_stops_have_the_bits_of_the_runtime(
    model_of: Build, tmp_path: Path, scene: Callable[[], Scene], scheme: str, dt: float, steps: int, end: int
) -> None:
    model = model_of(scene().build())
    own, stepper = bundle(model, tmp_path, scheme=scheme, dt=dt), model.stepper(scheme=scheme, dt=dt)
    same(own, stepper)
    started = np.zeros_like(own.z)
    own.call("start", started, own.c, 0.0, np.array([one.start for one in own.one.x]), own.w)
    np.testing.assert_allclose(started, own.z, rtol=0, atol=1e-30)  # a clock at a jump at zero is free by so much
    assert own.call("step", own.z, own.c, own.w, steps // 3) == 0 or end
    assert own.call("step", own.z, own.c, own.w, steps - steps // 3) == end
    stepper.step(steps // 3)
    if stepper.ended is None:
        stepper.step(steps - steps // 3)
    same(own, stepper)
    assert (stepper.ended is not None) == (end > 0)
    if end:
        before = own.z.copy()
        assert own.call("step", own.z, own.c, own.w, 5) == end
        np.testing.assert_array_equal(own.z, before)


@pytest.mark.long
def test_a_load_that_jumps_has_the_bits_of_a_run(built_in: Load, tmp_path: Path) -> None:
    """A flexible mechanism whose torque is switched off, with sub-steps; the samples of simulate."""
    model = built_in("flexible_slider_crank_torque")
    own, run = bundle(model, tmp_path, "-O3", "-march=native"), simulate(model, error="off")
    own.step(round((run.t[-1] - run.t[0]) / own.dt))
    place = [one.name for one in own.one.outputs].index
    seen, names = own.observe(), model.coordinates
    np.testing.assert_array_equal([seen[place(name)] for name in names], run.q[-1])
    np.testing.assert_array_equal([seen[place(f"{name}_dot")] for name in names], run.q_dot[-1])
    assert own.one.model.description.switching


@pytest.mark.every_push("flags1")
@pytest.mark.parametrize("flags", [("-O0",), ("-O2",), ("-std=gnu11", "-O3", "-march=native")])
def test_flags_change_no_event(model_of: Build, tmp_path: Path, flags: tuple[str, ...]) -> None:
    model = model_of(relay().build())
    own, stepper = bundle(model, tmp_path, *flags, scheme="rk4", dt=1e-3), model.stepper(scheme="rk4", dt=1e-3)
    own.step(4000)
    stepper.step(4000)
    same(own, stepper)


@pytest.mark.long
def test_inputs_and_parameters_move_jumps_and_events(model_of: Build, tmp_path: Path) -> None:
    model = model_of(jumping().event("far", "way - 0.2", action={"late": "late + 0.3"}).build())
    own, stepper = bundle(model, tmp_path, scheme="rk4", dt=1e-3), model.stepper(scheme="rk4", dt=1e-3)
    for late in (0.1501, 0.2, 0.31):
        own.call("hold", own.z, own.c, np.array([late]), own.w)
        own.step(100)
        stepper.step({"late": late}, 100)
    own.p[[one.name for one in own.one.parameters].index("cart.mass")] = 1.7
    own.call("constants", own.c, own.p, own.dt, own.w)
    held = np.zeros(1)
    own.call("held", held, own.z)
    own.call("hold", own.z, own.c, held, own.w)
    stepper.change({"cart.mass": 1.7})
    own.step(300)
    stepper.step(300)
    same(own, stepper)


@pytest.mark.skipif(find_spec("ziglang") is None or shutil.which("cc") is None, reason="no zig")
def test_a_second_compiler_gives_the_same_bits(model_of: Build, tmp_path: Path) -> None:
    one = exported(model_of(relay().build()), "rk4", 1e-3)
    write_c(one, tmp_path)
    zig = [sys.executable, "-m", "ziglang", "cc", *STRICT, "-O2"]
    subprocess.run([*zig, "-shared", "-fPIC", "relay.c", "-o", "z.so", "-lm"], cwd=tmp_path, check=True)
    own = Bundle(one, tmp_path / "z.so", (tmp_path / "relay.h").read_text())
    stepper = one.model.stepper(scheme="rk4", dt=1e-3)
    own.step(4000)
    stepper.step(4000)
    same(own, stepper)


def kicked() -> Scene:
    """A crank whose prescribed velocity jumps, with a bob on it."""
    builder = Scene("kicked").rigid("crank", mass=1.0, inertia=0.01, markers={"tip": {"position": (0.5, 0)}})
    builder.rigid("bob", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0))
    builder.revolute("pin", "ground.origin", "crank.origin").revolute("hinge", "crank.tip", "bob.origin")
    return builder.prescribed_angle("drive", "ground.origin", "crank.origin", motion="where(t < 0.25, t, 0.25)")


def test_what_cannot_leave_is_refused_by_name(model_of: Build) -> None:
    refused = {
        "motion of drive of model kicked: has a velocity that jumps at 0.25 s": kicked(),
        "drive of model folded: jumps where a function says": cart("folded", "where(tan(t) > 0.5, 1, 0)"),
    }
    for words, scene in refused.items():
        with pytest.raises(ModelError, match=words):
            exported(model_of(scene.simulation(t_end=1.0).build()), "rk4", 1e-3)


def test_what_decides_is_one_text_for_all_models(tmp_path: Path) -> None:
    """It compiles without a model, keeps arrays in memory of the caller's, and has small frames (a page on Windows)."""
    flags = [*STRICT, "-O1", "-Wvla", "-Wframe-larger-than=4000"]
    command = [
        *shlex.split(find_compiler() or ""),
        *flags,
        "-c",
        str(SWITCHING / "stops.c"),
        "-o",
        str(tmp_path / "stops.o"),
    ]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
