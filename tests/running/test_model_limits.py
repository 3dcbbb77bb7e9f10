"""Runs that leave what their model can say: buckled struts, points that meet."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from runtime import Model, simulate
from runtime.contract.coordinates import mechanism_length
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
E, WIDTH, HEIGHT, LENGTH = 2e11, 0.02, 0.005, 1.0


def strut(share: float) -> SceneRecord:
    """A pinned strut under a share of its buckling load pi^2 E I / L^2."""
    second_moment = WIDTH * HEIGHT**3 / 12
    load = share * math.pi**2 * E * second_moment / LENGTH**2
    builder = Scene("strut")
    builder.beam(
        "rod",
        length=LENGTH,
        density=7850.0,
        area=WIDTH * HEIGHT,
        second_moment=second_moment,
        youngs_modulus=E,
        lateral={"ends": "pinned-pinned", "modes": 2},
        stiffening=True,
        damping_ratio=0.02,
    )
    builder.rigid("end", mass=0.01, inertia=1e-4)
    builder.revolute("A", "ground.origin", "rod.start").revolute("C", "rod.end", "end.origin")
    builder.prismatic("slide", "ground.origin", "end.origin").force("push", "end.origin", -load, 0)
    return builder.initial({"rod.q1": 1e-4}).simulation(t_end=1.0, dt=2e-5, scheme="single_rate").build()


@pytest.mark.every_push("1.1-deflection_too_large")
@pytest.mark.parametrize(
    "share, name", [(0.9, "completed"), (1.1, "deflection_too_large"), (1.5, "deflection_too_large")]
)
def test_a_buckled_strut_is_named(model_of: Build, share: float, name: str) -> None:
    """Beyond the buckling load modal coordinates grow to many lengths, which linear modes cannot mean."""
    run = simulate(model_of(strut(share)), seen_every=2e-3)
    assert run.status.name == name
    assert np.abs(run["rod.q1"]).max() < 0.5 * LENGTH


@pytest.mark.parametrize("scheme", ["single_rate", "rk4", "exponential", "radau"])
def test_points_of_a_spring_without_free_length_may_meet(model_of: Build, scheme: str) -> None:
    """x'' = -100 x - 2 x' from x = 0, x' = 1 through zero and back: the force there is regular, with a damper too.

    At the very start the damper knows no line: half a step without it costs h c v / (2 m) = 1e-3 of the velocity.
    """
    builder = Scene("meeting").rigid("a", mass=1.0, inertia=0.1, free=True)
    builder.spring_damper("s", "ground.origin", "a.origin", stiffness=100.0, damping=2.0)
    scene = builder.rates({"a.x": 1.0}).simulation(t_end=1.0, dt=1e-3, scheme="single_rate").build()
    run = simulate(model_of(scene), scheme=scheme, seen_every=0.01)
    w = math.sqrt(99.0)
    assert run.status.ok
    assert run["a.x"] == pytest.approx(np.exp(-run.t) * np.sin(w * run.t) / w, abs=2e-4)
    assert np.abs(run["a.y"]).max() == 0.0


def test_points_that_meet_at_rest_stay(model_of: Build) -> None:
    builder = Scene("rest").rigid("a", mass=1.0, inertia=0.1, free=True)
    builder.spring_damper("s", "ground.origin", "a.origin", stiffness=100.0, damping=2.0)
    run = simulate(model_of(builder.simulation(t_end=0.1, dt=1e-3, scheme="single_rate").build()))
    assert run.status.ok and not run.q.any()


def test_a_mechanism_of_micrometres_has_a_length() -> None:
    """Arms of 1e-7 m are its length; 1e-10 m is what rounding leaves of arms that are zero."""
    coordinate, row = SimpleNamespace(turns=True), SimpleNamespace(unit="m")
    model: Any = SimpleNamespace(description=SimpleNamespace(coordinates=[coordinate], constraints=[row]))
    assert mechanism_length(model, np.array([[-1e-7]])) == 1e-7
    assert mechanism_length(model, np.array([[1e-10]])) == 1.0
