"""Exported C of joints that stick and slide: modes decided where they are open, with the bits of the runtime."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime.engine.c_source import find_compiler
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.export.bundles import bundle

Build = Callable[[SceneRecord], Model]
pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
STRIBECK = {"coulomb": 0.6, "breakaway": 1.0, "stribeck_velocity": 0.1, "viscous": 0.05}


def block(pull: str = "25 * sin(pi * t / 2)") -> Scene:
    """1 kg on a rail, with an input and an event that sets it."""
    law = {"coulomb": 5.0, "stribeck": 10.0, "breakaway": 15.015, "stribeck_velocity": 0.5, "viscous": 1.0}
    builder = Scene("block").input("more", 0.0, "N").ground().rigid("block", mass=1.0, inertia=0.1)
    builder.prismatic("rail", "ground.origin", "block.origin", friction=law).measure("x", "x", "block.origin")
    builder.force("pull", "block.origin", f"more + {pull}", 0.0)
    return builder.event("far", "x - 1.5", direction="rising", action={"more": "more - 3"})


def links(n: int) -> Scene:
    """A chain with friction in all joints, driven by two torques."""
    builder = Scene("links").ground()
    last = "ground.origin"
    for k in range(n):
        tip = {"tip": {"position": [0.6, 0.0]}}
        builder.rigid(f"link{k}", mass=1.0, inertia=0.1, center_of_mass=[0.3, 0.0], markers=tip)
        builder.revolute(f"joint{k}", last, f"link{k}.origin", friction=STRIBECK)
        last = f"link{k}.tip"
    builder.effort("drive", coordinate="joint0.angle", value="2.2 * sin(3 * t)")
    return builder.effort("drive2", coordinate="joint1.angle", value="1.8 * sin(7.1 * t)")


def four_bar(joints: str = "ad") -> Scene:
    """A loop in which some joints rub, two or all four, under a torque that swings and one that jumps."""
    builder = Scene("rubbing_loop").gravity(0.0, -9.81)
    builder.ground(markers={"far": {"position": [1.0, 0.0]}})
    for name, length in (("crank", 0.3), ("coupler", 0.9), ("rocker", 0.6)):
        tip = {"tip": {"position": [length, 0.0]}}
        builder.rigid(name, mass=length, inertia=length**3 / 12, center_of_mass=[length / 2, 0.0], markers=tip)
    builder.revolute("a", "ground.origin", "crank.origin", friction={"coulomb": 0.4})
    between = {name: {"friction": {"coulomb": 0.1}} if name in joints else {} for name in "bc"}
    builder.revolute("b", "crank.tip", "coupler.origin", **between["b"])
    builder.revolute("c", "coupler.tip", "rocker.tip", **between["c"])
    builder.revolute("d", "ground.far", "rocker.origin", friction=STRIBECK)
    builder.initial({"crank.theta": 0.9, "coupler.theta": 0.3, "rocker.theta": 1.7})
    return builder.effort("drive", coordinate="a.angle", value="2.5 * sin(9 * t) + where(t < 0.7123, 0, 1)")


def arm() -> Scene:
    """A beam on a joint that rubs."""
    flat = {"lateral": {"ends": "clamped-free", "modes": 2}, "second_moment": 1e-10}
    builder = Scene("held_arm").gravity(0.0, -9.81).ground()
    builder.beam("arm", length=1.0, density=2700.0, area=1e-4, youngs_modulus=7e10, **flat)
    return builder.revolute("pin", "ground.origin", "arm.start", friction={"coulomb": 0.5})


def slippery() -> Scene:
    """A coefficient of zero: nothing holds when the pull begins."""
    builder = Scene("slippery").parameter("mu", 0.0, "N").ground().rigid("block", mass=1.0, inertia=0.1)
    builder.prismatic("rail", "ground.origin", "block.origin", friction={"coulomb": "mu"})
    return builder.force("pull", "block.origin", "2 * max(t - 1, 0)", 0.0)


def clutches() -> Scene:
    """A clutch by an input, one by ramps of time, a brake by the motion; what lets go falls to coulomb at once."""
    builder = Scene("clutches").input("lim", 5.0, "N m").measure("turn", "angle", "A.origin").ground()
    for name, inertia in zip("ABC", (1.0, 0.7, 0.4), strict=True):
        builder.rigid(name, mass=1.0, inertia=inertia)
    builder.revolute("c0", "ground.origin", "A.origin", friction={"coulomb": "abs(turn)"})
    builder.revolute("c1", "A.origin", "B.origin", friction={"coulomb": "lim * step(t - 0.2)"})
    falls = {"coulomb": "min(20*t, 5)", "breakaway": "1.2 * min(20*t, 5)", "stribeck": 0.0}
    builder.revolute("c2", "B.origin", "C.origin", friction=falls)
    builder.event("far", "turn - 0.7", direction="rising", action={"lim": 0.5})
    return builder.torque("drive", "A.origin", "4*sin(6*t) + 1").torque("other", "C.origin", "6*sin(7.3*t)")


CASES: list[Any] = [
    (clutches, "rk4", 0.002, 2000, 8),
    (clutches, "single_rate", 0.002, 2000, 8),
    (block, "rk4", 0.01, 1000, 5),
    (block, "single_rate", 0.01, 1000, 5),
    (lambda: links(2), "rk4", 0.01, 600, 39),
    (lambda: links(4), "rk4", 0.01, 600, 50),
    (four_bar, "rk4", 1e-3, 1500, 10),
    (four_bar, "single_rate", 1e-3, 1500, 10),
    (lambda: four_bar("abcd"), "rk4", 1e-3, 1500, 10),
    (arm, "exponential", 1e-3, 1000, 1),
    (lambda: block("20 * step(t - 0.433)"), "rk4", 0.01, 100, 1),
    (slippery, "rk4", 0.01, 200, 1),
]


@pytest.mark.every_push("clutches-rk4-0.002-2000-8", "block-rk4-0.01-1000-5", "slippery-rk4-0.01-200-1")
@pytest.mark.parametrize(("scene", "scheme", "dt", "steps", "changes"), CASES)
def test_modes_have_the_bits_of_the_runtime(
    model_of: Build, tmp_path: Path, scene: Callable[[], Scene], scheme: str, dt: float, steps: int, changes: int
) -> None:
    """As many changes of mode as the case has at least, states compared on the way."""
    model = model_of(scene().simulation(t_end=1.0, dt=dt, scheme=scheme).build())
    own, stepper = bundle(model, tmp_path, scheme=scheme, dt=dt), model.stepper(scheme=scheme, dt=dt)
    size = len(stepper.save().z)
    np.testing.assert_array_equal(own.z[:size], stepper.save().z)
    started = np.zeros_like(own.z)
    own.call("start", started, own.c, 0.0, np.array([one.start for one in own.one.x]), own.w)
    np.testing.assert_array_equal(started[:size], own.z[:size])
    for _ in range(4):
        assert own.call("step", own.z, own.c, own.w, steps // 4) == 0
        stepper.step(steps // 4)
        np.testing.assert_array_equal(own.z[:size], stepper.save().z)
    assert sum(event.kind == "mode" for event in stepper.events) >= changes


@pytest.mark.every_push("flags0")
@pytest.mark.parametrize("flags", [("-O0",), ("-std=gnu11", "-O3", "-march=native")])
def test_flags_change_no_mode(model_of: Build, tmp_path: Path, flags: tuple[str, ...]) -> None:
    model = model_of(four_bar().simulation(t_end=1.0, dt=1e-3, scheme="rk4").build())
    own, stepper = bundle(model, tmp_path, *flags), model.stepper()
    own.step(1500)
    stepper.step(1500)
    z = stepper.save().z
    np.testing.assert_array_equal(own.z[: len(z)], z)


@pytest.mark.every_push("rk4")
@pytest.mark.parametrize("scheme", ["rk4", "single_rate"])
def test_an_input_that_jumps_decides_anew(model_of: Build, tmp_path: Path, scheme: str) -> None:
    """15.015 N hold the block: 15 N do not move it, 16 N do."""
    model = model_of(block("0").simulation(t_end=1.0, dt=0.01, scheme=scheme).build())
    own, stepper = bundle(model, tmp_path), model.stepper()
    u, x = np.zeros(len(own.one.inputs)), [one.name for one in own.one.outputs].index("x")
    for value, moves in ((15.0, False), (16.0, True), (0.0, False), (-20.0, True)):
        own.call("held", u, own.z)
        u[[one.name for one in own.one.inputs].index("more")] = value
        own.call("hold", own.z, own.c, u, own.w)
        before = own.observe()[x]
        own.step(300)
        stepper.step({"more": value}, 300)
        z = stepper.save().z
        np.testing.assert_array_equal(own.z[: len(z)], z)
        assert (own.observe()[x] != before) == moves or value == 0.0
