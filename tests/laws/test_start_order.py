"""Which coordinates move to satisfy constraints: what was left open, then reluctant, given, elastic ones; fixed never.

Coordinates (open, reluctant, given, elastic, fixed) from zero, and one constraint: the sum of some of them is 1.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from runtime import InitialStateError, Model
from runtime.contract.consistent_state import Assembly, ConsistentState, GivenValues, consistent_state
from runtime.operating.given_state import given_state
from symgen.scene import Scene, SceneRecord

NAMES = ["open", "reluctant", "given", "elastic", "fixed"]


def moved(*members: str) -> ConsistentState:
    """The state whose named coordinates, and rates, add up to 1."""
    row = np.array([[float(name in members) for name in NAMES]])
    given = GivenValues({"given": 0.0, "fixed": 0.0}, frozenset({"fixed"}))
    task = Assembly(
        NAMES,
        frozenset({3}),
        ["sum"],
        lambda q: (row @ q - 1.0, row),
        lambda q: (row, np.ones(1)),
        given,
        given,
        reluctant=frozenset({1}),
    )
    return consistent_state(task)


@pytest.mark.parametrize("first", range(4))
def test_the_first_that_can_moves_alone(first: int) -> None:
    """The sum of this kind and all later ones: this kind alone takes the whole."""
    found = moved(*NAMES[first:])
    expected = np.eye(5)[first]
    assert found.q == pytest.approx(expected, abs=1e-14) and found.q_dot == pytest.approx(expected, abs=1e-14)
    assert ("given" in found.changed) == (first == 2) and ("elastic" in found.changed) == (first == 3)


def test_what_is_fixed_stays() -> None:
    with pytest.raises(InitialStateError, match="sum"):
        moved("fixed")


def test_alike_ones_share() -> None:
    """Two elastic coordinates, or two that were left open, move by half each: the least change."""
    task = Assembly(
        ["a", "b"],
        frozenset(),
        ["sum"],
        lambda q: (np.array([q.sum() - 1.0]), np.ones((1, 2))),
        lambda q: (np.ones((1, 2)), np.ones(1)),
    )
    found = consistent_state(task)
    assert found.q == pytest.approx([0.5, 0.5]) and found.q_dot == pytest.approx([0.5, 0.5])


Build = Callable[[SceneRecord], Model]


def test_a_rate_of_what_depends_takes_the_place_of_the_rates_of_the_scene(model_of: Build) -> None:
    """Bars of 1 m at 0.3 and 0.8 rad: x' = -sin(0.3) w of the hinge gives w; the other rate is left open: none."""
    builder = Scene("two")
    for name in ("upper", "lower"):
        builder.rigid(name, mass=1.0, inertia=0.1, markers={"tip": {"position": (1.0, 0.0)}})
    builder.revolute("a", "ground.origin", "upper.origin").revolute("b", "upper.tip", "lower.origin")
    builder.initial({"upper.theta": 0.3, "lower.theta": 0.8}).rates({"upper.theta": 1.0, "lower.theta": 2.0})
    model = model_of(builder.simulation(t_end=0.1, dt=0.01, scheme="printed").build())
    p = model.parameter_vector()
    found = given_state(model, p, model.constants(p), 0.0, {"lower.x_dot": -0.5})
    rate = dict(zip(model.coordinates, found.q_dot, strict=True))
    assert rate["lower.x"] == pytest.approx(-0.5, abs=1e-14)
    assert rate["upper.theta"] == pytest.approx(0.5 / math.sin(0.3)) and abs(rate["lower.theta"]) < 1e-14
