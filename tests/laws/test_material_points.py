"""Accelerations of emitted models against Lagrange's equations of the first kind from material points."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from benchmarks.cases.hard_by_points import BY_POINTS
from benchmarks.scenes.hard_suite import HARD_SUITE
from runtime.model import Model
from symgen.scene import SceneRecord
from tests.support.model_values import condensed_accelerations, random_states

Build = Callable[[SceneRecord], Model]


@pytest.mark.every_push("f1_smooth", "joint_arm")
@pytest.mark.parametrize("name", ["f1_smooth", "f2_heavy_hub", "four_bar", "joint_arm"])
def test_accelerations_are_those_of_the_points(model_of: Build, name: str) -> None:
    """All coordinates, bent and turning: modal data, a prescribed motion, shortening, loops, loads, springs."""
    model, mechanism = model_of(HARD_SUITE[name].make()), BY_POINTS[name].make()
    equations, columns = mechanism.equations(), [model.coordinates.index(one) for one in mechanism.names]
    assert len(columns) == len(model.coordinates)
    for state in random_states(model, 2, rigid=0.1, elastic=1e-3):
        M, force, C_q, gamma = (np.asarray(one) for one in equations(state.t, state.q[columns], state.q_dot[columns]))
        k = len(gamma)
        matrix = np.block([[M, C_q.T], [C_q, np.zeros((k, k))]])
        found = np.linalg.solve(matrix, np.concatenate([force, gamma]).ravel())[: len(columns)]
        expected = condensed_accelerations(model, state)[columns]
        assert np.abs(found - expected).max() < 1e-8 * np.abs(expected).max()
