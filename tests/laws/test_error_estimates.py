"""On random trees, what a run says of its error is within a factor of 10 of the truth, and no large error is silent."""

from __future__ import annotations

import numpy as np
from hypothesis import given

from runtime import Model, reference_solution, simulate
from symgen.generate import model_of
from symgen.scene import Scene
from tests.laws.test_random_mechanisms import QUICK, fastest_rate
from tests.support.random_mechanisms import trees

WITHIN, STEPS, RADIANS = 10.0, 200, 0.2  # of the fastest motion a step
ROUNDING = 1e-11  # m or rad: errors below this are not estimated
SILENT = 0.1  # of an amplitude


def test_random_trees_know_their_errors() -> None:
    compared = dict.fromkeys(("single_rate", "rk4"), 0)

    @QUICK
    @given(trees())
    def judged(scene: Scene) -> None:
        model = model_of(scene)
        for scheme in compared:
            compared[scheme] += seen(model, scheme)

    def seen(model: Model, scheme: str) -> int:
        """How many coordinates were compared."""
        dt = RADIANS / fastest_rate(model)
        run = simulate(model, scheme=scheme, dt=dt, t_end=STEPS * dt, save_every=10, engine="interpreted")
        if not run.status.ok:  # by name, such as a beam that is bent too far
            return 0
        exact = reference_solution(model, t_end=float(run.t[-1]), times=run.t)
        true = np.abs(run.q_i - exact.q_i).max(axis=0)
        estimated = np.array([run.stats[f"estimated_error.{name}"] for name in model.q_i])
        shown = true > ROUNDING
        assert (estimated[shown] < WITHIN * true[shown]).all(), estimated / true
        assert (true[shown] < WITHIN * estimated[shown]).all(), estimated / true
        off = true / np.maximum(np.ptp(exact.q_i, axis=0) / 2, ROUNDING)
        assert off.max() < SILENT or "remark" in run.stats
        return int(shown.sum())

    judged()
    assert min(compared.values()) > 10
