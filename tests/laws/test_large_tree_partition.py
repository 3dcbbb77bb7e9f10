"""Sub-steps on large trees: order, and what a sub-step of the printed scheme costs there."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from benchmarks.scenes.arm import arm
from runtime.contract.model import Model
from runtime.contract.tape import arithmetic
from runtime.engine.prepare import prepare
from runtime.schemes.catalogue import scheme_kind
from symgen.scene import SceneRecord
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]


def test_sub_steps_of_the_printed_scheme_cost_the_same_whatever_the_mechanism(model_of: Build) -> None:
    """With the slow coordinates held at the middle: what moves them grows by 80 operations a link, sub-steps not."""
    held, counts = {"common_update": "direct", "slow_interpolation": "held_at_the_middle"}, []
    for links in (8, 12):
        scheme = scheme_kind("printed").build("printed", model_of(arm(links)), 1.0, [8], held)
        prepared = prepare(scheme.program(), scheme.layout.size, scheme.c_size)
        counts.append({stage.name(): arithmetic(stage) for stage in prepared.program.stages()})
    small, large = counts
    assert small["sub_step_2_1"] == large["sub_step_2_1"] <= 40
    assert large["common_update"] - small["common_update"] <= 4 * 80


def test_sub_steps_of_a_large_tree_are_second_order(model_of: Build) -> None:
    """Slope and cap on an arm of 8 links: the major step resolves its first mode only."""
    model = model_of(arm(8))
    exact = PreparedRuns(model, "dop853").end(0.1, 2e-4)
    runs = PreparedRuns(model, "coupled", [8])
    steps = [2e-3, 1e-3, 5e-4]
    errors = [float(np.max(np.abs(runs.end(0.1, step) - exact)[:8])) for step in steps]
    assert float(np.polyfit(np.log(steps), np.log(errors), 1)[0]) == pytest.approx(2.0, abs=0.15), errors
    assert errors[-1] < 6e-7, errors
