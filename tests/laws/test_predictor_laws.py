"""Velocities predicted with the last acceleration: second order too, and the path of large trees."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import reference_solution, simulate
from runtime.contract.model import Model
from runtime.running.simulate import make_plan
from symgen.scene import SceneRecord
from symgen.scenes.chain import chain


def errors(model: Model, steps: np.ndarray, t_end: float, **options: object) -> np.ndarray:
    exact = reference_solution(model, t_end=t_end, rtol=1e-12, atol=1e-13).q_i[-1]
    return np.array(
        [
            np.abs(
                simulate(model, t_end=t_end, dt=float(dt), scheme="single_rate", save_every=10**6, options=options).q_i[
                    -1
                ]
                - exact
            ).max()
            for dt in steps
        ]
    )


@pytest.mark.parametrize(("choice", "cap"), [("newton", 3e-7), ("predictor", 2e-6)])
def test_both_velocities_are_second_order(built_in: Callable[[str], Model], choice: str, cap: float) -> None:
    steps = np.array([1e-3, 5e-4, 2.5e-4])
    found = errors(built_in("double_pendulum"), steps, 1.0, common_velocity=choice)
    assert abs(np.polyfit(np.log(steps), np.log(found), 1)[0] - 2.0) < 0.1
    assert found[-1] < cap


def test_large_trees_take_the_linear_path(model_of: Callable[[SceneRecord], Model]) -> None:
    """14 links: no Jacobian and no M_hat in the step, an order of magnitude fewer operations, second order."""
    model = model_of(chain(14))
    plan = make_plan(model, 0.1, 1e-3, None, "single_rate", 1, None, 0.0)
    newton = make_plan(model, 0.1, 1e-3, None, "single_rate", 1, {"common_velocity": "newton"}, 0.0)
    by_tree, by_mass = (int(p.scheme.program().stage.n_instructions()) for p in (plan, newton))  # type: ignore[union-attr]
    assert by_tree < 0.4 * by_mass
    steps = np.array([1e-3, 5e-4, 2.5e-4])
    found = errors(model, steps, 0.5)
    assert abs(np.polyfit(np.log(steps), np.log(found), 1)[0] - 2.0) < 0.1
    assert found[-1] < 1e-3
