"""Loads at which finite-element bodies buckle between their interfaces, against Euler's."""

from __future__ import annotations

import numpy as np
import pytest

from symgen.fe import STEEL, FlexibleBody, LineMesh, Section
from symgen.scene import Scene, SceneError
from tests.fe.test_mode_acceleration import MATERIAL, L, Y, Z, bar

SECTION = Section.rectangle(0.02, 0.01)


def test_beams() -> None:
    """pi^2 E I / L^2 between held ends, a quarter of it with one clamped; between the middle and an end likewise."""
    places = np.linspace(0.0, 0.4, 9)[:, None] * np.eye(3)[0]
    mesh, ends = LineMesh(places, [(k, k + 1) for k in range(8)], SECTION), {"a": [0], "b": [8], "c": [4]}
    found = {tuple(one["markers"]): one for one in FlexibleBody.from_mesh(mesh, STEEL, interface=ends, modes=2).struts}
    euler = np.pi**2 * STEEL.E * SECTION.I_y / 0.4**2
    for markers, factor in ((("a", "b"), 1.0), (("a", "c"), 4.0), (("b", "c"), 4.0)):
        assert found[markers]["held"] == pytest.approx(factor * euler, rel=4e-3)
        assert found[markers]["first"] == pytest.approx(factor * euler / 4, rel=1e-3)
        assert found[markers]["second"] == pytest.approx(factor * euler / 4, rel=1e-3)


def test_a_solid() -> None:
    """It shears, and its ends are held on the average: 0.3 % and 1.5 % softer than Euler's strut."""
    (strut,) = bar(2).struts
    euler = np.pi**2 * MATERIAL.E * (Z * Y**3 / 12) / L**2
    assert euler * (1 - 3e-3) < strut["held"] < euler
    assert euler / 4 * (1 - 0.015) < strut["first"] < euler / 4


def test_struts_of_a_scene_name_its_markers() -> None:
    fields = bar(1, cells=2).fields()
    for change, problem in (
        ({"markers": ["root", "toe"]}, r"struts\[0\].markers: there is no marker 'toe'"),
        ({"held": -2.0}, r"struts\[0\].held: -2.0 is out of range; it must be greater than 0"),
    ):
        builder = Scene("bar", space="spatial")
        builder.flexible("bar", **{**fields, "struts": [fields["struts"][0] | change]})
        with pytest.raises(SceneError, match=problem):
            builder.weld("wall", "ground.origin", "bar.root").build()
