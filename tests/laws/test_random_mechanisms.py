"""Random trees and closed loops: they generate, M_hat is positive definite, (38) equals (28), energy is kept."""

from __future__ import annotations

import tempfile

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.linalg import eigvals

from runtime import load_model, simulate
from runtime.model import Model
from symgen.generate import generate, model_of
from symgen.scene import SceneRecord
from tests.support.augmented import augmented_run
from tests.support.model_values import (
    augmented_solution,
    condensed_accelerations,
    evaluate,
    make_state,
    reactions,
    relative_error,
)
from tests.support.random_mechanisms import beads_on_beams, four_bars, trees

pytestmark = pytest.mark.long

QUICK = settings(
    deadline=None,
    max_examples=8,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)
# (steps, radians of the fastest motion per step): a loop is followed for 0.1 rad, short of any singular position
TREE_RUN, LOOP_RUN = (200, 0.05), (50, 0.002)


def fastest_rate(model: Model) -> float:
    """Largest coupled frequency or rate of turning at the start [rad/s], at least 5."""
    columns = model.independent_columns
    state = make_state(model, model.initial_q[columns], model.initial_q_dot[columns])
    n = len(model.q_i)
    M = evaluate(model, "condensed", **state.values())["M_hat"].reshape(n, n)
    stiffness = (
        -evaluate(model, "dQ_hat_dq_i", **state.values())["dQ_hat_dq_i"].reshape(n, n)
        if model.has("dQ_hat_dq_i")
        else np.zeros((n, n))
    )
    frequency = float(np.sqrt(np.max(np.abs(eigvals(stiffness, M)))))
    return max(5.0, frequency, float(np.max(np.abs(state.q_dot))))


def check_laws(scene: SceneRecord, steps: int, angle: float) -> Model:
    with tempfile.TemporaryDirectory() as folder:
        model = load_model(generate(scene, folder))
    start, n = model.initial_q[model.independent_columns], len(model.q_i)
    rng = np.random.default_rng(n)
    for spread in (0.0, 1e-3):
        state = make_state(model, start + spread * rng.uniform(-1, 1, n), rng.uniform(-1, 1, n))
        M = evaluate(model, "condensed", **state.values())["M_hat"].reshape(n, n)
        assert relative_error(M, M.T) < 1e-12
        scale = np.sqrt(np.diag(M))
        assert np.min(np.linalg.eigvalsh(M / np.outer(scale, scale))) > 0
        expected, lam = augmented_solution(model, state)
        q_ddot = condensed_accelerations(model, state)
        assert relative_error(q_ddot, expected) < 1e-10
        assert np.max(np.abs(reactions(model, state, q_ddot) - lam)) < 1e-9 * max(1.0, np.max(np.abs(lam)))
    dt = angle / fastest_rate(model)
    solution = simulate(model, t_end=steps * dt, dt=dt, scheme="single_rate", seen_every=0.0, engine="interpreted")
    assert solution.status.ok, solution.status
    exchanged = np.ptp(solution.energy["kinetic"]) + np.max(solution.energy["kinetic"])
    assert np.max(np.abs(solution.total_energy - solution.total_energy[0])) < 5e-3 * exchanged + 1e-12
    assert np.max(solution.constraint_error) <= 1e-10
    return model


@QUICK
@given(trees())
def test_trees(scene: SceneRecord) -> None:
    check_laws(scene, *TREE_RUN)


@QUICK
@given(four_bars())
def test_closed_loops(scene: SceneRecord) -> None:
    check_laws(scene, *LOOP_RUN)


@QUICK
@given(st.one_of(trees(), four_bars()), st.integers(0, 100))
def test_doubled_joints_change_nothing(scene: SceneRecord, which: int) -> None:
    joints = list(scene.to_dict()["joints"])
    again = {**joints[which % len(joints)], "name": "again"}
    model = check_laws(SceneRecord.from_dict({**scene.to_dict(), "joints": [*joints, again]}), *LOOP_RUN)
    rows = sum(label.startswith("again.") for label in model.constraints)
    assert len(model.redundant) == rows > 0


@settings(QUICK, max_examples=6)
@given(beads_on_beams())
def test_beads_on_beams_go_on_wherever_they_lead(scene: SceneRecord) -> None:
    """With no scheme named, and q_i exchanged as often as it takes: the motion of the augmented form, by DOP853."""
    model = model_of(scene)
    run = simulate(model, t_end=1.5, samples=15, error="off")
    assert run.status.ok, run.status
    exact = augmented_run(model, t_end=1.5, times=np.minimum(run.t, 1.5))
    assert np.abs(run.q - exact.q).max() < 1e-3 * np.ptp(exact.q, axis=0).max()
