"""Which coordinates move to satisfy constraints: what was left open, then reluctant, given, elastic ones; fixed never.

Coordinates (open, reluctant, given, elastic, fixed) from zero, and one constraint: the sum of some of them is 1.
"""

from __future__ import annotations

import numpy as np
import pytest

from runtime.contract.consistent_state import ConsistentState, GivenValues, InitialStateError, consistent_state

NAMES = ["open", "reluctant", "given", "elastic", "fixed"]


def moved(*members: str) -> ConsistentState:
    """The state whose named coordinates, and rates, add up to 1."""
    row = np.array([[float(name in members) for name in NAMES]])
    given = GivenValues({"given": 0.0, "fixed": 0.0}, frozenset({"fixed"}))
    return consistent_state(
        NAMES,
        frozenset({3}),
        ["sum"],
        lambda q: (row @ q - 1.0, row),
        lambda q: (row, np.ones(1)),
        given,
        given,
        reluctant=frozenset({1}),
    )


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
    found = consistent_state(
        ["a", "b"],
        frozenset(),
        ["sum"],
        lambda q: (np.array([q.sum() - 1.0]), np.ones((1, 2))),
        lambda q: (np.ones((1, 2)), np.ones(1)),
        GivenValues(),
        GivenValues(),
    )
    assert found.q == pytest.approx([0.5, 0.5]) and found.q_dot == pytest.approx([0.5, 0.5])
