"""Comparisons with other programs: what is read off runs at one error, and that the mechanisms are the same."""

from __future__ import annotations

from collections.abc import Callable
from math import inf

import numpy as np
import pytest

from benchmarks.contenders.exudyn_arm import MODULUS
from benchmarks.contenders.exudyn_floating_arm import Mesh
from benchmarks.harness.matched import Attempt, match
from benchmarks.scenes.arm import arm
from runtime.model import Model

pytestmark = pytest.mark.long

SETTINGS = (10.0, 20.0, 40.0, 80.0, 160.0)


class Runs:
    """Errors of second order, 1 at 10 steps, and a millisecond a step; fails below some steps."""

    def __init__(self, least: float = 0.0) -> None:
        self.least, self.tried = least, list[float]()

    def __call__(self, steps: float) -> Attempt:
        self.tried.append(steps)
        if steps < self.least:
            return Attempt(steps, inf, 0.0, round(steps), "did not converge")
        return Attempt(steps, (10 / steps) ** 2, 1e-3 * steps, round(steps))


@pytest.mark.parametrize("start", [0, 2, 4])
def test_time_at_an_error_lies_on_the_line_between_its_neighbours(start: int) -> None:
    """From a loose and from a tight start: 10 / sqrt(0.03) steps."""
    found = match(Runs(), SETTINGS, start, 0.03, inf)
    assert found.seconds == pytest.approx(1e-2 / 0.03**0.5, rel=1e-12)
    assert found.coarse is not None and found.fine is not None
    assert found.coarse.error > 0.03 >= found.fine.error and found.fine.setting / found.coarse.setting < 1.5


def test_nothing_is_read_off_a_failed_run() -> None:
    found = match(Runs(least=60.0), SETTINGS, 0, 0.03, inf)
    assert found.met and found.seconds == pytest.approx(0.08) and found.told(1.0).startswith("1.6e-02 in 80 steps")


def test_the_loosest_setting_may_be_enough() -> None:
    found = match(Runs(), SETTINGS, 1, 2.0, inf)
    assert found.coarse is None and found.seconds == pytest.approx(1e-2)


def test_a_contender_that_is_too_slow_is_given_up_by_name() -> None:
    runs = Runs()
    found = match(runs, SETTINGS, 0, 1e-3, longest=0.03)
    assert not found.met and found.seconds == inf and runs.tried == [10.0, 20.0, 40.0]
    assert found.told(1.0) == "not met: 6.2e-02 in 40 steps, 40 ms/s"
    refused = match(Runs(least=1e9), SETTINGS, 0, 1e-3, inf)
    assert refused.told(1.0) == "did not converge"


def test_the_floating_frame_has_the_beam_of_the_arm(model_of: Callable[..., Model]) -> None:
    """Mass, its first and second moment, the modes' part in all of them and their stiffness, from points."""
    model, mesh = model_of(arm(2, stiffening=100.0)), Mesh(3, 100 * MODULUS)
    c = model.constants(model.parameter_vector())
    q = np.zeros(len(model.coordinates))  # the last link along x
    M = np.asarray(model.evaluate("augmented", q=q, q_dot=0 * q, t=0.0, c=c)["M"])
    of = [model.coordinates.index(f"link2.{name}") for name in ("x", "y", "theta", "q1", "q2", "q3")]
    x, masses = mesh.GetNodePositionsAsArray()[:, 0], mesh.GetMassMatrix().diagonal()[1::3]
    across = mesh.modeBasis["matrix"][1::3]
    motions = np.column_stack([np.ones_like(x), x, across])  # of the points across the beam
    np.testing.assert_allclose(
        motions.T @ (masses[:, None] * motions), M[np.ix_(of[1:], of[1:])], rtol=1e-12, atol=1e-15
    )
    np.testing.assert_allclose(mesh.stiffness, np.asarray(model.evaluate("deflections", c=c)["K_s"]), rtol=1e-12)
