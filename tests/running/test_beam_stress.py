"""Measures of stress of beams against the textbook: N / A, M / W, T / W_t and k Q / A, put together after von Mises."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import ModelError, equilibrium, simulate
from runtime.model import Model
from symgen import SceneError
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
HEIGHT, WIDTH, LENGTH = 0.02, 0.01, 1.0
AREA, PULL, PUSH = HEIGHT * WIDTH, 800.0, 20.0
SECTION = {
    "length": LENGTH,
    "density": 1e-3,
    "area": AREA,
    "second_moment": WIDTH * HEIGHT**3 / 12,
    "youngs_modulus": 2e14,
    "section_modulus": WIDTH * HEIGHT**2 / 6,
}


def cantilever() -> SceneRecord:
    """A clamped beam without weight, pulled along and pushed across at its tip, which its end shapes hold."""
    builder = Scene("cantilever").gravity(0, 0)
    builder.beam("arm", **SECTION, lateral={"modes": 2}, axial={"modes": 1}, markers={"middle": {"at": 0.5}})
    builder.weld("root", "ground.origin", "arm.start").force("load", "arm.end", PULL, PUSH)
    for name, of in (("peak", "arm.all"), ("middle", "arm.middle"), ("tip", "arm.end")):
        builder.measure(name, "stress", of=of)
    return builder.build()


def resting(model: Model) -> dict[str, float]:
    """The measures of stress in equilibrium [Pa]."""
    run = simulate(model, initial=equilibrium(model), t_end=1e-6, scheme="rk4", dt=1e-7, force=True)
    assert not run.events
    return {one.name: float(run[one.name][0]) for one in model.description.measures if one.unit == "Pa"}


def test_a_cantilever_pulled_and_pushed(model_of: Build) -> None:
    """|N| / A + F (L - x) / W at the outermost fibre; at the tip the shear stress 3/2 Q / A in the middle decides."""
    found = resting(model_of(cantilever()))
    bending = PUSH * LENGTH / SECTION["section_modulus"]
    assert found["peak"] == pytest.approx(PULL / AREA + bending, rel=1e-4)
    assert found["middle"] == pytest.approx(PULL / AREA + bending / 2, rel=1e-4)
    assert found["tip"] == pytest.approx(np.hypot(PULL / AREA, np.sqrt(3) * 1.5 * PUSH / AREA), rel=1e-4)


@pytest.mark.long
def test_a_shaft_bent_and_twisted_in_space(model_of: Build) -> None:
    """A round bar with a force across and a torque: sqrt((M / W)^2 + 3 (T / W_t)^2), and 4/3 of Q / A."""
    d, torque, push = 0.02, 30.0, 15.0
    area, inertia = np.pi * d**2 / 4, np.pi * d**4 / 64
    builder = Scene("shaft", space="spatial").gravity(0, 0, 0)
    builder.beam(
        "bar",
        **{**SECTION, "area": area, "second_moment": inertia, "section_modulus": 2 * inertia / d},
        second_moment_z=inertia,
        section_modulus_z="W",
        shear_modulus=8e13,
        torsion_constant=2 * inertia,
        torsion_modulus=4 * inertia / d,
        shear_factor=4 / 3,
        lateral={"modes": 2},
        lateral_z={"modes": 2},
        torsion={"modes": 1},
        markers={"tip": {"at": 1.0, "axis": (1, 0, 0)}},
    )
    builder.parameter("W", 2 * inertia / d, "m^3")
    builder.weld("root", "ground.origin", "bar.start").force("push", "bar.end", 0, 0, push)
    builder.torque("twist", "bar.tip", torque)
    for name, of in (("peak", "bar.all"), ("tip", "bar.end")):
        builder.measure(name, "stress", of=of)
    found = resting(model_of(builder.build()))
    bent, twisted = push * LENGTH * d / 2 / inertia, torque * d / 4 / inertia
    assert found["peak"] == pytest.approx(np.hypot(bent, np.sqrt(3) * twisted), rel=1e-4)
    assert found["tip"] == pytest.approx(np.sqrt(3) * (twisted + 4 / 3 * push / area), rel=1e-4)


def test_what_the_shapes_leave_out_of_a_stress_is_told(model_of: Build) -> None:
    """A cantilever under its weight by two cubics: at the root w L^2 / 12 of w L^2 / 2 lack."""
    builder = Scene("heavy").gravity(0, -9.81)
    builder.beam("arm", **{**SECTION, "density": 7800.0}, lateral={"modes": 2, "ends": "welded-welded"})
    builder.weld("root", "ground.origin", "arm.start").measure("peak", "stress", of="arm.all")
    run = simulate(model_of(builder.build()), start="quasi_static", t_end=2e-9, scheme="rk4", dt=1e-9)
    moment = 7800.0 * AREA * 9.81 * LENGTH**2 / 2
    assert run["peak"][0] == pytest.approx(5 / 6 * moment / SECTION["section_modulus"], rel=1e-3)
    assert run.stats["missing_stress.peak"] == pytest.approx(1 / 6, rel=0.01)
    assert any(one.kind == "stresses_missing" and "peak" in one.text for one in run.events)


def test_a_normal_force_that_no_shape_knows(model_of: Build) -> None:
    """Pulled and pushed without axial modes: N / A is by equilibrium, in the measure too."""
    builder = Scene("cantilever").gravity(0, 0).beam("arm", **SECTION, lateral={"modes": 2})
    builder.weld("root", "ground.origin", "arm.start").force("load", "arm.end", PULL, PUSH)
    model = model_of(builder.measure("peak", "stress", of="arm.all").build())
    run = simulate(model, initial=equilibrium(model), t_end=1e-6, scheme="rk4", dt=1e-7, force=True)
    bending, pulled = PUSH * LENGTH / SECTION["section_modulus"], PULL / AREA
    found, shapes = run.beam_stresses("arm"), run.beam_stresses("arm", way="modes")
    tip = PUSH * LENGTH**3 / (3 * SECTION["youngs_modulus"] * SECTION["second_moment"])
    whole = pulled + bending - PULL * tip / SECTION["section_modulus"]  # equilibrium is that of the bent beam
    assert found.von_mises[0, 0] == pytest.approx(whole, rel=1e-5)
    assert found.von_mises[0, -1] == pytest.approx(np.hypot(pulled, np.sqrt(3) * 1.5 * PUSH / AREA), rel=1e-4)
    assert found.largest()[0] == pytest.approx(whole, rel=1e-5) and found.largest()[2] == 0.0
    assert shapes.von_mises[0, 0] == pytest.approx(bending, rel=1e-4)
    assert run["peak"][0] == pytest.approx(pulled + bending, rel=1e-4)  # bending is that of the shapes
    assert run.stats["missing_stress.peak"] == pytest.approx(PULL * tip / SECTION["section_modulus"] / whole, rel=0.05)
    silent = Scene("silent").gravity(0, 0).beam("arm", **SECTION, lateral={"modes": 2})
    silent.weld("root", "ground.origin", "arm.start")
    still = simulate(model_of(silent.build()), t_end=1e-6, scheme="rk4", dt=1e-7)
    with pytest.raises(ModelError, match="section of beam 'arm' is not known.*measure it"):
        still.beam_stresses("arm")
    with pytest.raises(ModelError, match="has no beam 'leg'"):
        still.beam_stresses("leg")


@pytest.mark.parametrize(
    "change, of, word",
    [
        ({"section_modulus": None}, "arm.all", "section_modulus"),
        ({}, "arm.tip", "no marker 'tip'"),
    ],
)
def test_sections_that_are_not_known_are_refused(change: dict[str, object], of: str, word: str) -> None:
    fields = {key: value for key, value in {**SECTION, **change}.items() if value is not None}
    builder = Scene("arm").beam("arm", **fields, lateral={"modes": 2, "ends": "clamped-free"})
    builder.weld("root", "ground.origin", "arm.start").measure("peak", "stress", of=of)
    with pytest.raises(SceneError, match=word):
        builder.build()


def test_a_component_of_a_beam_is_refused() -> None:
    builder = Scene("arm").beam("arm", **SECTION, lateral={"modes": 2})
    builder.weld("root", "ground.origin", "arm.start").measure("peak", "stress", of="arm.all", component="xx")
    with pytest.raises(SceneError, match="von Mises"):
        builder.build()
