"""Random spatial trees, loops and doubled joints: M_hat positive definite, (38) equals (28), energy, Jacobians."""

from __future__ import annotations

import tempfile

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, assume, given, settings

from runtime import load_model
from runtime.contract.coordinates import independent_part, loop_part, turned_by
from runtime.model import Model
from runtime.running.singular.exchange import by_velocities
from symgen.generate import generate
from symgen.scene import SceneRecord
from tests.support.augmented import augmented_accelerations
from tests.support.model_values import (
    Array,
    State,
    condensed_accelerations,
    evaluate,
    join,
    make_state,
    power_gap,
    reactions,
    relative_error,
)
from tests.support.random_spatial import spatial_loops, spatial_trees

pytestmark = pytest.mark.long

QUICK = settings(
    deadline=None,
    max_examples=3,
    derandomize=True,
    phases=(Phase.generate,),
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)
KERNELS = frozenset(
    {"condensed", "closure", "velocities", "accelerations", "constraints", "augmented", "reactions", "energy"}
)
JACOBIANS = frozenset({"dQ_hat_dq_i", "dQ_hat_dq_i_dot"})
WELL_POSED = 0.03  # smallest singular value of C_q on the dependent coordinates, over the largest


def check_laws(scene: SceneRecord, redundant: bool | None = False, jacobians: bool = False) -> None:
    """redundant: whether rows are (None: they may be, where two joints of a loop fall into one point)."""
    with tempfile.TemporaryDirectory() as folder:
        model = load_model(generate(scene, folder, KERNELS | JACOBIANS if jacobians else KERNELS))
        for name in model.builders:
            model.kernel(name)
    assert redundant is None or bool(model.redundant) == redundant
    assume(well_posed(model))
    state, n = random_state(model), len(model.q_i)
    constraint = evaluate(model, "constraints", **state.values())
    C_q = constraint["C_q"].reshape(-1, len(state.q))
    assert np.max(np.abs(constraint["C"])) < 1e-12
    assert np.max(np.abs(C_q @ state.q_dot + constraint["C_t"])) < 1e-11
    M = evaluate(model, "condensed", **state.values())["M_hat"].reshape(n, n)
    assert relative_error(M, M.T) < 1e-12
    scale = np.sqrt(np.diag(M))
    assert np.min(np.linalg.eigvalsh(M / np.outer(scale, scale))) > 0
    q_ddot = condensed_accelerations(model, state)
    assert np.max(np.abs(C_q @ q_ddot - constraint["gamma"])) < 1e-10 * max(1.0, np.abs(q_ddot).max())
    c = model.constants(model.parameter_vector())
    augmented, _ = augmented_accelerations(model)(state.t, state.q, state.q_dot, c)
    assert relative_error(q_ddot, np.asarray(augmented).ravel()) < 1e-9
    assert power_gap(model, state, q_ddot, reactions(model, state, q_ddot)) < 1e-10
    if jacobians:
        check_jacobians(model, state)


def well_posed(model: Model) -> bool:
    """Do the dependent coordinates follow at the start, and in its neighbourhood?"""
    C_q = evaluate(model, "constraints", q=model.initial_q, q_dot=model.initial_q_dot, t=0.0)["C_q"]
    names, slopes, _ = by_velocities(model, model.initial_q, C_q.reshape(-1, len(model.coordinates)), 1.0)
    turned = {name for record in model.description.orientations for name in record.parameters}
    norms = {f"{record.body}.norm" for record in model.description.orientations}
    rows = [row for row in model.kept_rows if model.constraints[row] not in norms]
    part = slopes[np.ix_(rows, [names.index(name) for name in model.q_d if name not in turned])]
    size = np.linalg.svd(part, compute_uv=False)
    return bool(size[-1] > WELL_POSED * size[0])


def random_state(model: Model) -> State:
    rng, n = np.random.default_rng(len(model.coordinates)), len(model.q_i)
    reach = np.where([name in model.elastic for name in model.q_i], 1e-4, 0.01)
    start = independent_part(model, model.initial_q)
    return make_state(model, start + reach * rng.uniform(-1, 1, n), rng.uniform(-1, 1, n), 0.2)


def turned_place(model: Model, state: State, step: Array) -> Array:
    """q_i after a step whose turns are rotations in the axes of their bodies."""
    rates = np.zeros((2, len(model.q_d)))
    if model.q_d:
        moving = [{**state.values(), "q_i_dot": own} for own in (step, 0 * step)]
        rates = np.array([evaluate(model, "velocities", **own)["q_d_dot"] for own in moving])
    change = join(model, step, rates[0] - rates[1])
    return turned_by(model, state.q, change, state.q_i, step, loop_part(model, state.q))[0]


def check_jacobians(model: Model, state: State) -> None:
    """Central differences of Q_hat along a random direction, the loops closed anew."""
    rng, h = np.random.default_rng(1), 1e-5
    along = rng.uniform(-1, 1, len(state.q_i))
    for name in ("dQ_hat_dq_i", "dQ_hat_dq_i_dot"):
        turned = (along, 0 * along) if name == "dQ_hat_dq_i" else (0 * along, along)
        moved = [
            make_state(
                model, turned_place(model, state, s * turned[0]), state.q_i_dot + s * turned[1], state.t, state.q
            )
            for s in (-h, h)
        ]
        behind, ahead = (evaluate(model, "condensed", **at.values())["Q_hat"] for at in moved)
        found = 0 * along
        if model.has(name):
            found = evaluate(model, name, **state.values())[name].reshape(len(along), -1) @ along
        noise = 1e-14 * np.max(np.abs(evaluate(model, "augmented", **state.values())["Q_star"])) / h
        assert np.max(np.abs(found - (ahead - behind) / (2 * h))) <= 1e-6 * np.max(np.abs(found)) + noise, name


@QUICK
@given(spatial_trees())
def test_trees(scene: SceneRecord) -> None:
    check_laws(scene)


@QUICK
@given(spatial_trees(most=2))
def test_jacobians(scene: SceneRecord) -> None:
    """Of M_hat and Q_hat, on one or two bodies, as these are the large ones."""
    check_laws(scene, jacobians=True)


@QUICK
@given(spatial_loops())
def test_closed_loops(scene: SceneRecord) -> None:
    check_laws(scene, redundant=None)


@QUICK
@given(spatial_trees(doubled=True, most=2))
def test_doubled_joints(scene: SceneRecord) -> None:
    """A joint twice: its rows are found redundant and change nothing."""
    check_laws(scene, redundant=True)
