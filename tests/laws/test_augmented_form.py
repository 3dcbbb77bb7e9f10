"""The augmented form as a path of its own: it agrees with the condensed one, and drifts."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from runtime import reference_solution
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.support.augmented import augmented_run

TIMES = np.linspace(0.0, 1.0, 11)


def test_augmented_path_follows_the_condensed_one(built_in: Callable[[str], Model]) -> None:
    model = built_in("four_bar")
    condensed = reference_solution(model, t_end=1.0, times=TIMES, rtol=1e-10, atol=1e-12)
    augmented = augmented_run(model, t_end=1.0, times=TIMES)
    assert augmented.status.ok
    assert np.abs(augmented.q - condensed.q).max() < 1e-6
    assert np.abs(augmented.lam - condensed.lam).max() < 1e-4 * np.abs(condensed.lam).max()


def test_the_augmented_form_drifts(built_in: Callable[[str], Model]) -> None:
    """Constraints are satisfied by accelerations only, whose errors are integrated; the condensed form closes."""
    loose = {"rtol": 1e-5, "atol": 1e-7}
    drifting = augmented_run(built_in("four_bar"), t_end=1.0, times=TIMES, **loose)
    condensed = reference_solution(built_in("four_bar"), t_end=1.0, times=TIMES, **loose)
    assert drifting.constraint_error[-1] > 1e-6 and condensed.constraint_error.max() < 1e-12


def test_joint_forces_carry_the_weight(model_of: Callable[[SceneRecord], Model]) -> None:
    """A hanging rod welded to the ground: the weld carries its weight and its moment about the marker."""
    scene = Scene("shelf").gravity(0, -10.0)
    scene.rigid("rod", mass=2.0, inertia=0.1, center_of_mass=(0.5, 0), markers={"tip": {"position": (1.0, 0)}})
    scene.rigid("ball", mass=1.0, inertia=0.1)
    scene.weld("wall", "ground.origin", "rod.origin").revolute("pin", "rod.tip", "ball.origin")
    solution = reference_solution(model_of(scene.build()), t_end=0.1)
    np.testing.assert_allclose(solution.joint_force("wall")[-1], [0.0, 30.0, 20.0 * 0.5 + 10.0 * 1.0], atol=1e-12)
    np.testing.assert_allclose(solution.joint_force("pin")[-1], [0.0, 10.0, 0.0], atol=1e-12)
