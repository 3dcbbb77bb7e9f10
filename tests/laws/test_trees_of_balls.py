"""Bodies that hang on each other by spherical joints, two of them on one: M_hat and Q_hat by hand.

The centre of mass of a body moves with v = sum_j A_j (omega_j x s_j) over itself and the bodies before it, s_j being
the way on body j. So v = sum_j B_j omega_j with B_j = -A_j s_j~, and by virtual power

    M_hat = sum_k m_k B_k^T B_k + J_k,
    Q_hat = sum_k m_k B_k^T (g - sum_j A_j (omega_j x (omega_j x s_j))) - omega_k x J_k omega_k.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.support.model_values import Array, evaluate, random_states, relative_error

pytestmark = pytest.mark.long

PARENTS = (-1, 0, 1, 0, 3)  # body 0 carries bodies 1 and 3
GRAVITY = np.array([0.3, -0.7, -9.81])


def ways(along_x: bool) -> tuple[Array, Array]:
    """Of each body, from its own ball to its centre of mass and to the balls of those that it carries."""
    rng = np.random.default_rng(8)
    centres, points = rng.normal(size=(5, 3)), rng.normal(size=(5, 3))
    keep = np.array([1, 0, 0]) if along_x else np.ones(3)
    return centres * keep, points * keep


def tensors() -> list[Array]:
    """Inertia about the centre of mass."""
    rng = np.random.default_rng(9)
    half = rng.normal(size=(5, 3, 3))
    return [0.1 * (one + one.T) + 2 * np.eye(3) for one in half]


def tree(along_x: bool) -> SceneRecord:
    builder = Scene("balls", space="spatial").gravity(*GRAVITY)
    centres, points = ways(along_x)
    for k, J in enumerate(tensors()):
        products = [J[0, 1], J[0, 2], J[1, 2]]
        markers = {f"to{j}": {"position": list(points[j])} for j in range(5) if PARENTS[j] == k}
        builder.rigid(
            f"b{k}",
            mass=1.0 + k,
            inertia=list(np.diag(J)),
            products=products,
            center_of_mass=list(centres[k]),
            markers=markers,
        )
        parent = f"b{PARENTS[k]}.to{k}" if k else "ground.origin"
        builder.joint("spherical", f"j{k}", parent, f"b{k}.origin")
    return builder.build()


def rotation(e: Array) -> Array:
    w, v = e[0], e[1:]
    return (w * w - v @ v) * np.eye(3) + 2 * np.outer(v, v) + 2 * w * np.cross(np.eye(3), v)


def by_hand(A: list[Array], omega: Array, along_x: bool) -> tuple[Array, Array]:
    """M_hat and Q_hat."""
    centres, points = ways(along_x)
    M, Q = np.zeros((15, 15)), np.zeros(15)
    for k, J in enumerate(tensors()):
        B, drift, arm, body = np.zeros((3, 15)), np.zeros(3), centres[k], k
        while body >= 0:
            B[:, 3 * body : 3 * body + 3] = A[body] @ np.cross(np.eye(3), arm).T
            drift += A[body] @ np.cross(omega[body], np.cross(omega[body], arm))
            arm, body = points[body], PARENTS[body]
        own = slice(3 * k, 3 * k + 3)
        M += (1.0 + k) * B.T @ B
        M[own, own] += J
        Q += (1.0 + k) * B.T @ (GRAVITY - drift)
        Q[own] -= np.cross(omega[k], J @ omega[k])
    return M, Q


@pytest.mark.parametrize("along_x", [True, False], ids=["along one axis", "in all directions"])
def test_equations_by_hand(build: Callable[[SceneRecord, frozenset[str] | None], Model], along_x: bool) -> None:
    """At random orientations and angular velocities."""
    model = build(tree(along_x), frozenset({"condensed", "closure", "velocities"}))
    for state in random_states(model, 3, rigid=2.0):
        e = [[state.q[model.coordinates.index(f"b{k}.e{i}")] for i in range(4)] for k in range(5)]
        omega = state.q_i_dot.reshape(5, 3)
        out = evaluate(model, "condensed", **state.values())
        M, Q = by_hand([rotation(np.array(one)) for one in e], omega, along_x)
        assert relative_error(out["M_hat"].reshape(15, 15), M) < 1e-13
        assert relative_error(out["Q_hat"], Q) < 1e-12
