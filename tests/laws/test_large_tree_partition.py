"""Large trees: what crosses between slow and fast coordinates, its price, and schemes that are built on it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime.contract.model import Model
from runtime.engine.choose import arithmetic
from runtime.engine.prepare import prepare
from runtime.schemes.catalogue import scheme_kind
from symgen.pipeline import derive
from symgen.scene import Scene
from symgen.scenes import SCENES
from symgen.scenes.arm import arm
from symgen.scenes.chain import chain
from tests.support.model_values import evaluate, random_states
from tests.support.prepared_runs import PreparedRuns

Build = Callable[[Scene], Model]
KERNELS = {"slow_response", "fast_rows"}


@pytest.mark.parametrize("scene", [arm(8), chain(4, 2)], ids=["arm", "chain of flexible links"])
def test_slow_response_and_fast_rows_are_those_of_the_condensed_equations(model_of: Build, scene: Scene) -> None:
    """(39): y'' = M_LL^-1 Q_L, N = M_LL^-1 M_LS; the rows of q_S are M_SS - M_SL N and Q_S - M_SL y''."""
    model = model_of(scene)
    L, S = (group.positions for group in model.groups)
    n = len(model.q_i)
    for state in random_states(model, 2):
        condensed = evaluate(model, "condensed", **state.values())
        M_hat, Q_hat = condensed["M_hat"].reshape(n, n), condensed["Q_hat"].ravel()
        N = np.linalg.solve(M_hat[np.ix_(L, L)], M_hat[np.ix_(L, S)])
        y_ddot = np.linalg.solve(M_hat[np.ix_(L, L)], Q_hat[L])
        found = evaluate(model, "slow_response", **state.values())
        np.testing.assert_allclose(found["y_ddot"].ravel(), y_ddot, rtol=0, atol=1e-9 * np.abs(y_ddot).max())
        np.testing.assert_allclose(found["N"].reshape(len(L), len(S)), N, rtol=0, atol=1e-10 * np.abs(N).max())
        rows = evaluate(model, "fast_rows", **state.values(), crossing=found["crossing"].ravel())
        M_SL = M_hat[np.ix_(S, L)]
        M_bar, force = M_hat[np.ix_(S, S)] - M_SL @ N, Q_hat[S] - M_SL @ y_ddot
        np.testing.assert_allclose(
            rows["M_bar_SS"].reshape(len(S), len(S)), M_bar, rtol=0, atol=1e-10 * np.abs(M_bar).max()
        )
        np.testing.assert_allclose(rows["rhs_S"].ravel(), force, rtol=0, atol=1e-9 * np.abs(force).max())


def test_scenes_without_a_large_tree_in_two_groups_have_no_such_kernels() -> None:
    for name in ("hub_beam", "flexible_slider_crank_free", "chain"):
        assert not KERNELS & derive(SCENES[name]()).tapes.keys()


def test_sub_steps_cost_the_same_whatever_the_mechanism(model_of: Build) -> None:
    """`decoupled` and `printed` on arms: holds grow by 135 operations a link, sub-steps not at all."""
    held = {"common_update": "direct", "slow_interpolation": "held_at_the_middle"}
    counts: dict[str, list[dict[str, int]]] = {"decoupled": [], "printed": []}
    for links in (8, 12):
        for name, options in (("decoupled", {}), ("printed", held)):
            scheme = scheme_kind(name).build(name, model_of(arm(links)), 1.0, [8], options)
            prepared = prepare(scheme.program(), scheme.layout.size, scheme.c_size)
            counts[name].append({stage.name(): arithmetic(stage) for stage in prepared.program.stages()})
    for name, sub_step, most in (("decoupled", "sub_step_1", 60), ("printed", "sub_step_2_1", 40)):
        small, large = counts[name]
        assert small[sub_step] == large[sub_step] <= most
    small, large = counts["decoupled"]
    assert large["hold_1"] - small["hold_1"] == 4 * 135 and small["hold_1"] <= 1130
    small, large = counts["printed"]
    assert large["common_update"] - small["common_update"] <= 4 * 80


def test_decoupled_steps_of_a_large_tree_are_second_order(model_of: Build) -> None:
    """Slope and cap on an arm of 8 links: the major step resolves its first mode only."""
    model = model_of(arm(8))
    exact = PreparedRuns(model, "dop853").end(0.1, 2e-4)
    runs = PreparedRuns(model, "decoupled", [8])
    steps = [2e-3, 1e-3, 5e-4]
    errors = [float(np.max(np.abs(runs.end(0.1, step) - exact)[:8])) for step in steps]
    assert float(np.polyfit(np.log(steps), np.log(errors), 1)[0]) == pytest.approx(2.0, abs=0.15), errors
    assert errors[-1] < 1e-6, errors
