"""Sub-steps on large trees: order, and what a sub-step of the printed scheme costs there."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from benchmarks.scenes.arm import arm
from runtime.model import Model
from symgen.scene import SceneRecord
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]


def test_sub_steps_of_a_large_tree_are_second_order(model_of: Build) -> None:
    """Slope and cap on an arm of 8 links: the major step resolves its first mode only."""
    model = model_of(arm(8))
    exact = PreparedRuns(model, "dop853").end(0.1, 2e-4)
    runs = PreparedRuns(model, "coupled", [8])
    steps = [2e-3, 1e-3, 5e-4]
    errors = [float(np.max(np.abs(runs.end(0.1, step) - exact)[:8])) for step in steps]
    assert float(np.polyfit(np.log(steps), np.log(errors), 1)[0]) == pytest.approx(2.0, abs=0.15), errors
    assert errors[-1] < 6e-7, errors
