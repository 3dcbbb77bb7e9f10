"""The recursion of articulated bodies solves M x'' = force, what sticks held, and costs the same for each body."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from symgen.scene import Scene, SceneRecord
from symgen.system.build import build_system
from symgen.system.equations import Equations

JOINTS = ("revolute", "universal", "cylindrical", "revolute", "screw", "planar", "prismatic", "revolute")


def mixed_chain() -> SceneRecord:
    """Rigid bodies and beams in turn, on joints of every kind that places a body, each with a twig."""
    rng = np.random.default_rng(4)
    builder = Scene("mixed", space="spatial").gravity(0.0, 0.0, -9.81)
    builder.ground(markers={"tip": {"axis": rng.normal(size=3)}})
    before = "ground.tip"
    for k, kind in enumerate(JOINTS):
        name = f"body{k}"
        if k % 2:
            bent = {"ends": "clamped-free", "modes": 1}
            builder.beam(
                name,
                length=0.5,
                density=2700.0,
                area=1e-4,
                second_moment=1e-9,
                second_moment_z=2e-9,
                youngs_modulus=7e10,
                lateral=bent,
                lateral_z=bent,
                stiffening=k == 3,
                markers={
                    "foot": {"at": 0.7, "axis": rng.normal(size=3)},
                    "tip": {"at": 1.0, "axis": rng.normal(size=3)},
                },
            )
        else:
            markers = {
                label: {"position": rng.uniform(-1, 1, 3), "axis": rng.normal(size=3)} for label in ("foot", "tip")
            }
            builder.rigid(name, mass=1.0, inertia=[0.1, 0.12, 0.15], center_of_mass=[0.1, 0, 0.2], markers=markers)
        lead = {"lead": 0.3} if kind == "screw" else {}
        ends = (before, f"{name}.foot") if k % 3 else (f"{name}.foot", before)
        builder.joint(kind, f"joint{k}", *ends, **lead)
        builder.rigid(f"twig{k}", mass=0.2, inertia=[0.01, 0.02, 0.02], center_of_mass=[0.0, 0.3, 0.0])
        builder.joint("revolute", f"twist{k}", f"{name}.tip", f"twig{k}.origin")
        before = f"{name}.tip"
    return builder.build()


def hinges(n: int) -> SceneRecord:
    rng = np.random.default_rng(5)
    builder = Scene("hinges", space="spatial")
    for k in range(n):
        markers = {"tip": {"position": rng.uniform(-1, 1, 3), "axis": rng.normal(size=3)}}
        builder.rigid(f"body{k}", mass=1.0, inertia=[0.1, 0.12, 0.15], center_of_mass=[0.1, 0, 0.2], markers=markers)
        builder.joint("revolute", f"hinge{k}", f"body{k - 1}.tip" if k else "ground.origin", f"body{k}.origin")
    return builder.build()


def solution(equations: Equations, force: ca.SX, moves: ca.SX | None = None) -> tuple[list[int], ca.SX]:
    """(columns of the tree, accelerations); moves: of each column, zero where it is held."""
    columns = [column for column, row in enumerate(equations.M) if row]
    assert equations.free_joints is not None
    masks = {} if moves is None else {column: moves[k] for k, column in enumerate(columns)}
    found = equations.free_joints({c: force[k] for k, c in enumerate(columns)}, frozenset(columns), masks)
    return columns, ca.vertcat(*(found[column] for column in columns))


@pytest.mark.long
def test_accelerations_give_the_force_back() -> None:
    system = build_system(mixed_chain())
    equations, rng = system.reduced, np.random.default_rng(6)
    size = sum(bool(row) for row in equations.M)
    force = ca.SX.sym("force", size)
    columns, accelerations = solution(equations, force)
    M = ca.SX(size, size)
    for i, row in enumerate(columns):
        for j, column in enumerate(columns):
            M[i, j] = equations.M[row].get(column, ca.SX(0))
    values = ca.Function(
        "values", [ca.vertcat(*equations.q), system.parameters.vector(), force], [ca.densify(M), accelerations]
    )
    defaults = [entry.default for entry in system.parameters.entries]
    for _ in range(3):
        q, f = 0.3 * rng.uniform(-1, 1, len(equations.q)), rng.normal(size=size)
        matrix, found = (np.asarray(value) for value in values(q, defaults, f))
        expected = np.linalg.solve(matrix, f)
        assert np.abs(found.ravel() - expected).max() < 1e-9 * np.abs(expected).max()


def test_each_further_body_costs_the_same() -> None:
    counts = []
    for n in (6, 9, 12):
        equations = build_system(hinges(n)).reduced
        columns, accelerations = solution(equations, ca.SX.sym("force", n))
        counts.append(ca.n_nodes(ca.cse(accelerations)))
    assert abs((counts[2] - counts[1]) - (counts[1] - counts[0])) <= 0.02 * (counts[1] - counts[0])


def test_what_sticks_is_held_as_by_multipliers() -> None:
    """M x'' + S f = force with x'' = 0 of the columns S that stick, at random states, for random modes."""
    n, rng, system = 8, np.random.default_rng(7), build_system(hinges(8))
    equations, force, moves = system.reduced, ca.SX.sym("force", n), ca.SX.sym("moves", n)
    columns, accelerations = solution(equations, force, moves)
    M = [ca.horzcat(*(equations.M[row].get(column, ca.SX(0)) for column in columns)) for row in columns]
    given = [ca.vertcat(*equations.q), system.parameters.vector(), force, moves]
    values = ca.Function("values", given, [ca.vertcat(*M), accelerations])
    defaults = [entry.default for entry in system.parameters.entries]
    for _ in range(20):
        given, free = rng.normal(size=n), rng.permutation([0, 1, *rng.integers(0, 2, n - 2)])
        mass, a = (np.asarray(value) for value in values(rng.normal(size=len(equations.q)), defaults, given, free))
        S = np.eye(n)[:, free == 0]
        whole = np.block([[mass, S], [S.T, np.zeros((S.shape[1], S.shape[1]))]])
        expected = np.linalg.solve(whole, np.concatenate([given, np.zeros(S.shape[1])]))[:n]
        assert np.abs(a.ravel() - expected).max() < 1e-13 * np.abs(expected).max()
        assert not a.ravel()[free == 0].any()
