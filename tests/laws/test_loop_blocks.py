"""Loop rows and unknowns in block-triangular order: the order itself, and Newton and multipliers solved along it."""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from runtime import load_model
from runtime.model import Model
from symgen.algebra.small_systems import solve_small
from symgen.condensed.loops import order_blocks
from symgen.generate import generate
from symgen.pipeline import derive
from symgen.scene import Scene, SceneRecord
from symgen.scenes.linkages import n_four_bar
from tests.support.model_values import (
    augmented_solution,
    condensed_accelerations,
    evaluate,
    make_state,
    random_states,
    reactions,
    relative_error,
)

FUNCTIONS = frozenset({"condensed", "closure", "velocities", "accelerations", "constraints", "augmented", "reactions"})


def coupled_loops() -> SceneRecord:
    """Two loops through a coupler with three joints, driven at the far end: four unknowns that cannot be parted."""
    builder = Scene("coupled").gravity(0, -9.81)
    builder.ground(markers={"b": {"position": (1.1, 0.1)}, "e": {"position": (2.0, -0.2)}})
    for name, length in (("a", 0.6), ("b", 0.8), ("d", 1.5), ("e", 0.5)):
        builder.rigid(
            name, mass=1.0, inertia=0.05, center_of_mass=(length / 2, 0.02), markers={"tip": {"position": (length, 0)}}
        )
    builder.rigid(
        "c",
        mass=2.0,
        inertia=0.2,
        center_of_mass=(0.5, 0.2),
        markers={"p": {"position": (1.0, 0)}, "r": {"position": (0.6, 0.5)}},
    )
    builder.revolute("A", "ground.origin", "a.origin").revolute("AC", "a.tip", "c.origin")
    builder.revolute("B", "ground.b", "b.origin").revolute("BC", "b.tip", "c.p")
    builder.revolute("E", "ground.e", "e.origin").revolute("DE", "e.tip", "d.origin").revolute("DC", "d.tip", "c.r")
    builder.initial({"a.theta": 1.2, "b.theta": 1.1, "c.theta": 0.1, "e.theta": 1.4, "d.theta": 2.58})
    return builder.independent("e.theta").build()


SCENES = {"three windows": n_four_bar(3), "coupled loops": coupled_loops()}


@pytest.fixture(scope="module", params=list(SCENES))
def model(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Model:
    return load_model(generate(SCENES[request.param], tmp_path_factory.mktemp("loops"), FUNCTIONS))


def test_the_order_is_the_finest_block_triangular_one() -> None:
    """Rows 0-4, columns 10-14: row 3 has column 13 alone, rows 0 and 4 need each other, row 1 needs both."""
    one = ca.SX(1)
    entries = {
        0: {10: one, 12: one, 13: one},
        1: {11: one, 10: one},
        2: {14: one, 11: one},
        3: {13: one},
        4: {10: one, 12: one},
    }
    blocks = order_blocks([0, 1, 2, 3, 4], [10, 11, 12, 13, 14], entries)
    assert [(block.rows, block.columns) for block in blocks] == [
        ([3], [13]),
        ([0, 4], [10, 12]),
        ([1], [11]),
        ([2], [14]),
    ]


def test_each_window_is_a_block_of_its_own() -> None:
    system = derive(n_four_bar(3), frozenset({"closure"})).system
    known = set(system.choice.independent)
    assert [len(block.rows) for block in system.loops.blocks] == [2, 2, 2]
    for block in system.loops.blocks:
        known |= set(block.columns)
        assert all(set(system.loops.rows[row].entries) <= known for row in block.rows)


@pytest.mark.parametrize("windows", [1, 2, 4])
def test_windows_move_as_one_upright(windows: int, tmp_path: Path) -> None:
    """I theta'' = -w cos(theta) with I = (N + 1)/3 + N and w = ((N + 1)/2 + N) g, whatever the number of loops."""
    model = load_model(generate(n_four_bar(windows), tmp_path / "windows", FUNCTIONS))
    for angle in (0.3, 1.2, -2.0):
        start = np.where([name.startswith("upright") for name in model.coordinates], angle, 0.0)
        found = evaluate(model, "condensed", **make_state(model, [angle], [1.7], guess=start).values())
        assert found["M_hat"] == pytest.approx((windows + 1) / 3 + windows, rel=1e-12)
        assert found["Q_hat"] == pytest.approx(-((windows + 1) / 2 + windows) * 9.81 * np.cos(angle), rel=1e-11)


def test_loops_that_need_each_other_stay_together() -> None:
    system = derive(coupled_loops(), frozenset({"closure"})).system
    assert [len(block.rows) for block in system.loops.blocks] == [4]


def test_the_closure_is_a_newton_step(model: Model) -> None:
    """From loop unknowns off by 1e-2, closed-form rows satisfied, it moves as C_qd dq_d = -C says."""
    columns = model.independent_columns
    q = make_state(model, model.initial_q[columns] + 0.05, np.zeros(len(columns))).q
    loops = [model.coordinates.index(name) for name in model.loop_unknowns]
    q[loops] += 1e-2 * np.random.default_rng(1).uniform(-1, 1, len(loops))
    structural, solved = [k for k in model.dependent_columns if k not in loops], _solved(model)

    def constraints() -> tuple[np.ndarray, np.ndarray]:
        result = evaluate(model, "constraints", q=q, q_dot=0 * q, t=0.0)
        return result["C"], result["C_q"].reshape(len(model.constraints), -1)

    for _ in range(3):  # the structural rows are linear in the structural coordinates; repeated for rounding
        C, C_q = constraints()
        q[structural] -= np.linalg.solve(C_q[np.ix_(solved, structural)], C[solved])
    C, C_q = constraints()
    assert np.abs(C).max() > 1e-4 and np.abs(C[solved]).max() < 1e-15
    step = np.linalg.solve(C_q[:, model.dependent_columns], C)
    loop = [model.q_d.index(name) for name in model.loop_unknowns]
    found = evaluate(model, "closure", q_i=q[columns], q_d=q[model.dependent_columns], t=0.0)
    assert relative_error(found["q_d_next"][loop], q[loops] - step[loop]) < 1e-13
    assert relative_error(found["C_loop"], np.delete(C, solved)) < 1e-9


def _solved(model: Model) -> list[int]:
    """Rows from which structural coordinates are solved."""
    scene = next(scene for scene in SCENES.values() if scene.name == model.name)
    return sorted(row for row, _ in derive(scene, frozenset({"closure"})).system.choice.structural)


def test_det_loop_is_the_determinant_of_the_dependent_columns(model: Model) -> None:
    """Up to sign and the constant pivots of the closed-form rows, which are 1 here."""
    for state in random_states(model, 3, rigid=0.1):
        C_q = evaluate(model, "constraints", **state.values())["C_q"].reshape(len(model.constraints), -1)
        expected = abs(np.linalg.det(C_q[:, model.dependent_columns]))
        found = evaluate(model, "closure", **state.values())["det_loop"]
        assert abs(np.prod(found)) == pytest.approx(expected, rel=1e-9)


def test_det_loop_vanishes_where_the_window_is_flat(tmp_path: Path) -> None:
    model = load_model(generate(n_four_bar(2), tmp_path / "flat", FUNCTIONS))
    near, far = (make_state(model, [angle], [0.0]) for angle in (1e-3, np.pi / 2))
    small, large = (np.abs(evaluate(model, "closure", **state.values())["det_loop"]) for state in (near, far))
    assert np.all(small < 2e-3) and np.all(large > 0.9)


def test_condensed_equals_augmented(model: Model) -> None:
    for state in random_states(model, 3, rigid=0.1):
        expected, lam = augmented_solution(model, state)
        q_ddot = condensed_accelerations(model, state)
        assert relative_error(q_ddot, expected) < 1e-10
        assert relative_error(reactions(model, state, q_ddot), lam) < 1e-9


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 6, 7])
def test_small_systems_give_solution_and_determinant(n: int) -> None:
    """Against NumPy; beyond 6x6 the determinant's size only."""
    U = ca.SX.sym("U", n, n)
    entries = [[U[i, j] for j in range(n)] for i in range(n)]
    solutions, determinant = solve_small(entries, [[ca.SX(k + 1.0) for k in range(n)]])
    function = ca.Function("solved", [U], [ca.vertcat(*solutions[0]), determinant])
    rng = np.random.default_rng(n)
    signs = set()
    for _ in range(8):
        matrix = rng.normal(size=(n, n))
        x, found = (np.asarray(value).ravel() for value in function(matrix))
        assert np.allclose(x, np.linalg.solve(matrix, np.arange(1.0, n + 1)), rtol=1e-9)
        expected = np.linalg.det(matrix)
        assert found[0] == pytest.approx(expected if n <= 6 else abs(expected), rel=1e-10)
        signs.add(np.sign(expected))
    assert signs == {-1.0, 1.0}
