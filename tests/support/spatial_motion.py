"""Motion of the bodies of a spatial model as frames and velocities, whatever its coordinates are; lumped masses.

Everything here is derived anew from rotation matrices, by automatic differentiation along a path in time, so that
models with other coordinates can be compared with each other and with Newton's and Euler's equations.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import casadi as ca
import numpy as np
from scipy.spatial.transform import Rotation

from runtime.contract.coordinates import parts, rate_parts
from runtime.model import Model
from symgen.scene import SceneRecord
from tests.hand_derived.spatial.twin_flexible_nodes import Nodes
from tests.support.model_values import Array, State, augmented_solution, evaluate, joint_forces


@dataclass(frozen=True, eq=False)
class Frame:
    """A body's frame in world axes, with q_f: position, rotation matrix, and their first and second rates."""

    R: Array
    A: Array
    v: Array
    omega: Array
    a: Array
    alpha: Array
    q_f: Array
    q_f_dot: Array
    q_f_ddot: Array


def rotation(e: ca.SX) -> ca.SX:
    """A of unit Euler parameters."""
    tilde = ca.skew(e[1:])
    return ca.SX.eye(3) + 2 * e[0] * tilde + 2 * ca.mtimes(tilde, tilde)


@cache
def _rotation_vector() -> ca.Function:
    """(e, e_dot, e_ddot) -> A, omega, alpha."""
    e, rate, second, s = ca.SX.sym("x", 4), ca.SX.sym("v", 4), ca.SX.sym("a", 4), ca.SX.sym("s")
    A = rotation(e + s * rate + s**2 / 2 * second)
    A_dot = ca.reshape(ca.jacobian(ca.vec(A), s), 3, 3)
    omega = ca.inv_skew(ca.mtimes(A_dot, A.T))
    found = ca.substitute([A, omega, ca.jacobian(omega, s)], [s], [ca.SX(0)])
    return ca.Function("turning", [e, rate, second], found)


def frames(scene: SceneRecord, q: Array, q_dot: Array, q_ddot: Array) -> dict[str, Frame]:
    """Every moving body's frame at full coordinate vectors."""
    found, first = {}, 0
    for body in scene.moving_bodies:
        n = len(scene.frame_coordinates(body))
        rotation, elastic = slice(first + 3, first + n), slice(first + n, first + n + body.nf)
        moved = _rotation_vector()(q[rotation], q_dot[rotation], q_ddot[rotation])
        A, omega, alpha = (np.asarray(part) for part in moved)
        R = slice(first, first + 3)
        found[body.name] = Frame(
            q[R], A, q_dot[R], omega.ravel(), q_ddot[R], alpha.ravel(), q[elastic], q_dot[elastic], q_ddot[elastic]
        )
        first += n + body.nf
    return found


def orient(A: Array, omega: Array) -> tuple[Array, Array]:
    """Euler parameters and rates of a frame."""
    e = np.roll(Rotation.from_matrix(A).as_quat(), 1)
    e = e if e[0] >= 0 else -e
    return e, _product(np.concatenate([[0.0], omega / 2]), e)


def _product(p: Array, q: Array) -> Array:
    return np.concatenate([[p[0] * q[0] - p[1:] @ q[1:]], p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])])


def place(scene: SceneRecord, model: Model, moving: Mapping[str, Frame], t: float) -> State:
    """The state of a model without joint coordinates whose bodies are at the given frames."""
    q, q_dot = [], []
    for body in scene.moving_bodies:
        frame = moving[body.name]
        theta, theta_dot = orient(frame.A, frame.omega)
        q += [*frame.R, *theta, *frame.q_f]
        q_dot += [*frame.v, *theta_dot, *frame.q_f_dot]
    return full_state(model, np.array(q), np.array(q_dot), t)


def full_state(model: Model, q: Array, q_dot: Array, t: float) -> State:
    """State of full coordinate vectors."""
    (q_i, q_d), (q_i_dot, q_d_dot) = parts(model, q), rate_parts(model, q, q_dot)
    return State(q_i, q_d, q_i_dot, q_d_dot, q, q_dot, t)


def assembled(model: Model, q: Array, q_dot: Array, t: float) -> State:
    """The nearest state that satisfies all constraints, whatever coordinates are independent."""
    for _ in range(30):
        out = evaluate(model, "constraints", q=q, q_dot=q_dot, t=t)
        C_q = out["C_q"].reshape(-1, len(q))
        q = q - np.linalg.lstsq(C_q, out["C"], rcond=None)[0]
    q_dot = q_dot - np.linalg.lstsq(C_q, C_q @ q_dot + out["C_t"], rcond=None)[0]
    assert np.max(np.abs(evaluate(model, "constraints", q=q, q_dot=q_dot, t=t)["C"])) < 1e-12
    return full_state(model, q, q_dot, t)


def solve(scene: SceneRecord, model: Model, state: State) -> tuple[dict[str, Frame], Array, dict[str, Array]]:
    """(frames with accelerations, q_ddot, {joint: (force, moment) on its body b at marker b}) by the augmented form."""
    q_ddot, _ = augmented_solution(model, state)
    return frames(scene, state.q, state.q_dot, q_ddot), q_ddot, joint_forces(model, state, q_ddot)


@dataclass(frozen=True, eq=False)
class Rate:
    """Rate of momentum of a body: linear [N], and angular about the world's origin [N m]; mass [kg], centre [m]."""

    linear: Array
    angular: Array
    mass: float
    centre: Array


def momentum_rate(nodes: Nodes, frame: Frame) -> Rate:
    """Sum of m a and r x m a over the masses of a body."""
    place, drift = nodes.places(frame.q_f), nodes.drift(frame.q_f_dot)
    arm, relative, push = (vectors @ frame.A.T for vectors in (place, drift, nodes.shapes @ frame.q_f_ddot))
    a = frame.a + np.cross(frame.alpha, arm) + np.cross(frame.omega, np.cross(frame.omega, arm) + 2 * relative) + push
    at, m = frame.R + arm, nodes.masses
    return Rate(m @ a, m @ np.cross(at, a), float(m.sum()), (m @ at) / m.sum())


def momentum(nodes: Nodes, frame: Frame) -> tuple[Array, Array]:
    """Linear and angular momentum of a body about the world's origin."""
    arm = nodes.places(frame.q_f) @ frame.A.T
    v = frame.v + np.cross(frame.omega, arm) + nodes.drift(frame.q_f_dot) @ frame.A.T
    return nodes.masses @ v, nodes.masses @ np.cross(frame.R + arm, v)
