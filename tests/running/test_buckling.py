"""The share of its buckling load that each beam of a run carried, against Euler's columns."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from runtime import Solution, simulate
from runtime.model import Model
from symgen.fe import STEEL, FlexibleBody, LineMesh, Section
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
L, E, SECOND, MASS = 1.5, 2e11, 1e-9, 0.6
FIELDS = {"length": L, "density": MASS / L / 1e-4, "area": 1e-4, "second_moment": SECOND, "youngs_modulus": E}
SECTION, UP = Section(1e-4, 2e-9, 1e-9, 1e-9, y_axis=(1.0, 0.0, 0.0)), (0.0, 1.0, 0.0)
EULER = math.pi**2 * E * SECOND / L**2


def at_rest(model_of: Build, builder: Scene) -> Solution:
    return simulate(model_of(builder.build()), scheme="rk4", dt=1e-8, t_end=2e-8, start="quasi_static")


def test_a_column_between_pins(model_of: Build) -> None:
    """P / P_Euler; pulled it is zero. Beyond 1 the status of the run and an event say so."""
    for push, stiffening in ((0.7, True), (-2.0, True), (1.4, False)):
        builder = Scene("column").ground(markers={"guide": {"position": (L, 0.0)}})
        builder.beam("column", **FIELDS, lateral={"modes": 1}, stiffening=stiffening)
        builder.revolute("pin", "ground.origin", "column.start").point_on_line("roller", "ground.guide", "column.end")
        run = at_rest(model_of, builder.force("push", "column.end", -push * EULER, 0.0))
        assert run.stats["buckling.column"] == pytest.approx(max(0.0, push), rel=1e-9)
        assert run.status.ok and [event.kind for event in run.events] == ["beyond_buckling"] * (push > 1)
        assert ("column is pushed with 1.4 of its buckling load" in str(run.status)) == (push > 1)


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_a_cantilever_under_its_weight_and_a_mass(model_of: Build, space: str) -> None:
    """(m + M / 2) g over pi^2 E I / (2 L)^2 with the weaker second moment; what hangs at its tip holds nothing."""
    tip, g = 2.0, 9.81
    planes: dict[str, Any] = {"lateral": {"modes": 2}}
    if space == "spatial":
        planes |= {"lateral_z": {"modes": 2}, "second_moment_z": SECOND / 4}
    weak = SECOND / 4 if space == "spatial" else SECOND
    builder = Scene("mast", space=space).gravity(-g, 0.0).beam("mast", **FIELDS, **planes, stiffening=True)
    builder.rigid("head", mass=tip, inertia=[1.0] * 3 if space == "spatial" else 1.0)
    builder.weld("foot", "ground.origin", "mast.start").weld("top", "mast.end", "head.origin")
    run = at_rest(model_of, builder)
    expected = (tip + MASS / 2) * g / (math.pi**2 * E * weak / (2 * L) ** 2)
    assert run.stats["buckling.mast"] == pytest.approx(expected, rel=1e-6) and expected < 1


def steel_column(**choices: Any) -> FlexibleBody:
    """Six elements along y, which bend about z more easily."""
    mesh = LineMesh([(0.0, L * k / 6, 0.0) for k in range(7)], [(k, k + 1) for k in range(6)], SECTION)
    ends = {"foot": [0], "head": [6]}
    return FlexibleBody.from_mesh(mesh, STEEL, interface=ends, modes=2, **choices)


@pytest.mark.long
def test_columns_of_finite_elements(model_of: Build) -> None:
    """pi^2 E I / L^2 between a hinge and a slide, a quarter of it for a mast, by the line between the interfaces."""
    euler = math.pi**2 * STEEL.E * SECTION.I_z / L**2
    for push in (0.6, 1.2):
        builder = Scene("column", space="spatial").ground(markers={"top": {"position": (0.0, L, 0.0), "axis": UP}})
        builder.flexible("column", **steel_column().fields()).revolute("pin", "ground.origin", "column.foot")
        builder.point_on_line("guide", "ground.top", "column.head")
        run = at_rest(model_of, builder.force("push", "column.head", 0.0, -push * euler, 0.0))
        assert run.stats["buckling.column"] == pytest.approx(push, rel=1e-3)
        assert run.status.ok and ("of its buckling load" in str(run.status)) == (push > 1)
    builder = Scene("mast", space="spatial").flexible("mast", **steel_column().fields())
    builder.weld("foot", "ground.origin", "mast.foot").force("push", "mast.head", 0.0, -0.1 * euler, 0.0)
    assert at_rest(model_of, builder).stats["buckling.mast"] == pytest.approx(0.4, rel=1e-3)


def test_what_holds_an_end(built_in: Callable[[str], Model]) -> None:
    """A rod between a crank and a slider is held at both ends, a beam on a hub at one."""
    from runtime.running.limits import is_held

    four_bar = built_in("flexible_four_bar").description
    assert is_held(four_bar, "coupler", {"coupler.start"}) and is_held(four_bar, "coupler", {"coupler.end"})
    hub = built_in("hub_beam").description
    assert is_held(hub, "beam", {"beam.start"}) and not is_held(hub, "beam", {"beam.end"})
