"""The augmented form as a path of its own: it agrees with the condensed one, drifts, and Baumgarte stops the drift."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import augmented_solution, reference_solution
from runtime.contract.model import Model
from symgen.scene import Scene, SceneRecord
from symgen.scenes import SCENES
from tests.support.scenes import on_hinge

TIMES = np.linspace(0.0, 1.0, 11)


def linkage(alpha: float | None) -> SceneRecord:
    scene = SCENES["four_bar"]()
    changed = {**scene.to_dict(), "baumgarte": None if alpha is None else {"alpha": alpha, "beta": alpha}}
    return SceneRecord.from_dict({key: value for key, value in changed.items() if value is not None})


def test_augmented_path_follows_the_condensed_one(model_of: Callable[[SceneRecord], Model]) -> None:
    model = model_of(linkage(None))
    condensed = reference_solution(model, t_end=1.0, times=TIMES, rtol=1e-10, atol=1e-12)
    augmented = augmented_solution(model, t_end=1.0, times=TIMES)
    assert augmented.status.ok
    assert np.abs(augmented.q - condensed.q).max() < 1e-6
    assert np.abs(augmented.lam - condensed.lam).max() < 1e-4 * np.abs(condensed.lam).max()


@pytest.mark.long
def test_drift_and_baumgarte(model_of: Callable[[SceneRecord], Model]) -> None:
    """Without the terms the constraint error grows by the integration error; with them it stays far below."""
    loose = {"rtol": 1e-5, "atol": 1e-7}
    drifting = augmented_solution(model_of(linkage(None)), t_end=1.0, times=TIMES, **loose)
    held = augmented_solution(model_of(linkage(50.0)), t_end=1.0, times=TIMES, **loose)
    assert drifting.constraint_error[-1] > 1e-6
    assert held.constraint_error[-1] < 0.05 * drifting.constraint_error[-1]


def test_terms_are_run_time_inputs(model_of: Callable[[SceneRecord], Model]) -> None:
    model = model_of(linkage(50.0))
    assert {"baumgarte.alpha", "baumgarte.beta"} <= {parameter.name for parameter in model.parameters}
    plain = on_hinge("plain", "rod", "hinge", mass=1.0, inertia=0.1)
    assert not any("baumgarte" in parameter.name for parameter in model_of(plain.build()).parameters)


def test_joint_forces_carry_the_weight(model_of: Callable[[SceneRecord], Model]) -> None:
    """A hanging rod welded to the ground: the weld carries its weight and its moment about the marker."""
    scene = Scene("shelf").gravity(0, -10.0)
    scene.rigid("rod", mass=2.0, inertia=0.1, center_of_mass=(0.5, 0), markers={"tip": {"position": (1.0, 0)}})
    scene.rigid("ball", mass=1.0, inertia=0.1)
    scene.weld("wall", "ground.origin", "rod.origin").revolute("pin", "rod.tip", "ball.origin")
    solution = reference_solution(model_of(scene.build()), t_end=0.1)
    np.testing.assert_allclose(solution.joint_force("wall")[-1], [0.0, 30.0, 20.0 * 0.5 + 10.0 * 1.0], atol=1e-12)
    np.testing.assert_allclose(solution.joint_force("pin")[-1], [0.0, 10.0, 0.0], atol=1e-12)
