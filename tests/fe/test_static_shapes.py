"""Static shapes of loads among the modes: what they hold is exact, and the other modes stay."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from runtime import simulate
from symgen.fe import FiniteElementError
from symgen.generate import model_of
from symgen.scene import Scene
from tests.fe.test_mode_acceleration import MATERIAL, L, bar

HELD = {"mode_set": "mixed", "fixed": ["root"], "cells": 6}
FINER = {**HELD, "cells": 12}


@pytest.mark.long
def test_a_measure_of_a_turning_bar() -> None:
    """rho w^2 (L^2 - x^2) / 2 by the modes themselves, which a bending mode alone does not have and says so.

    In an element of length h the stress is the line that fits the parabola best: at a node L^2 - x^2 + h^2 / 6.
    """
    speed, h = 30.0, L / FINER["cells"]
    expected = MATERIAL.rho * speed**2 / 2 * (L**2 - (L / 2) ** 2 + h**2 / 6)
    for static in ((), ("spin_z",)):
        body = bar(1, static=static, **FINER)
        builder = Scene("arm", space="spatial").revolute("axle", "ground.origin", "bar.root")
        builder.flexible("bar", **body.fields(gauges={"middle": (L / 2, 0.0, 0.0)}))
        builder.prescribed_angle("drive", "ground.origin", "bar.root", motion=f"{speed} * t")
        builder.measure("pulled", "stress", "bar.middle", component="xx")
        run = simulate(model_of(builder.build()), scheme="rk4", dt=1e-8, t_end=2e-8, start="quasi_static")
        told = [event.kind for event in run.events]
        assert run.stresses("bar").at("middle")[0, 0] == pytest.approx(expected, rel=5e-4)
        if static:
            assert run["pulled"][0] == pytest.approx(expected, rel=5e-4) and told == []
            assert run.stats["missing_stress.bar"] < 1e-3
        else:
            assert abs(run["pulled"][0]) < 0.1 * expected and told == ["stresses_missing"]


def test_what_they_hold() -> None:
    """Six loads at the tip lose nothing; frequencies of the modes beside them change by the Ritz method only."""
    plain, held = bar(3, **HELD), bar(3, static=["tip", "tip"], **HELD)
    assert held.nf == 9 and len(plain.losses()) == len(held.losses())
    lost = [np.abs(one.loss).max() for one in (*plain.losses(), *held.losses()) if one.name == "tip"]
    assert lost[0] > 0.5 and lost[1] < 1e-9
    assert_allclose(held.frequencies[:3], plain.frequencies, rtol=1e-6)
    assert_allclose(held.modes.shapes.T @ held.structure.M @ held.modes.shapes, np.eye(9), atol=1e-9)
    weight = bar(1, static=["weight_y", "turn_z"], **HELD)
    load = weight.structure.M @ (weight.structure.component == 1)
    full = weight.modes.elastic(load)
    modes = weight.modes.shapes
    assert_allclose(modes @ (modes.T @ load / weight.modes.eigenvalues), full, atol=1e-9 * np.abs(full).max())


def test_loads_that_make_no_shape() -> None:
    for static, problem in ((["weight_x"], "'weight_x' does not deform"), (["lift_x"], "'lift_x' is not known.*tip")):
        with pytest.raises(FiniteElementError, match=problem):
            bar(1, cells=2, static=static)
    assert bar(1, cells=2, static=["spin_x"]).nf == 2
