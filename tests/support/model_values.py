"""Numbers out of a generated model, for tests: kernels by name, assembled random states, the augmented solution."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from runtime.contract.coordinates import dependent_part, independent_part, whole
from runtime.model import Model
from runtime.solutions.observe import joint_reactions

Array = NDArray[Any]


@dataclass(frozen=True, eq=False)
class State:
    """A consistent state; q and q_dot in the order of model.coordinates, q_i and q_d in the model's own order."""

    q_i: Array
    q_d: Array
    q_i_dot: Array
    q_d_dot: Array
    q: Array
    q_dot: Array
    t: float

    def values(self) -> dict[str, Any]:
        """Kernel arguments by name."""
        return dict(self.__dict__)


def evaluate(model: Model, name: str, p: Array | None = None, **values: Any) -> dict[str, Array]:
    """Outputs of a kernel at default parameters (or p); arguments it does not take are ignored."""
    kernel = model.kernel(name)
    c = model.constants(model.parameter_vector() if p is None else p)
    result = kernel.call({key: (c if key == "c" else values[key]) for key in kernel.name_in()})
    shapes = {key: kernel.size_out(key) for key in kernel.name_out()}
    return {
        key: np.asarray(value).reshape(shapes[key]) if shapes[key][1] != 1 else np.asarray(value).ravel()
        for key, value in result.items()
    }


def positions(model: Model, q_i: Array, t: float, guess: Array, iterations: int = 30) -> Array:
    """q_d = f(q_i, t) by the closure kernel, from a guess of q_d (used for loop unknowns only)."""
    q_d = np.array(guess, dtype=float)
    if not model.q_d:
        return np.zeros(0)
    for _ in range(iterations if model.loop_unknowns else 1):
        q_d = evaluate(model, "closure", q_i=q_i, q_d=q_d, t=t)["q_d_next"]
    return q_d


def make_state(model: Model, q_i: Array, q_i_dot: Array, t: float = 0.0, guess: Array | None = None) -> State:
    """Assembled state with consistent velocities. guess: full q (the model's initial one by default)."""
    q_i, q_i_dot = np.asarray(q_i, dtype=float), np.asarray(q_i_dot, dtype=float)
    start = model.initial_q if guess is None else np.asarray(guess)
    q_d = positions(model, q_i, t, dependent_part(model, start))
    q_d_dot = np.zeros(0)
    if model.q_d:
        q_d_dot = evaluate(model, "velocities", q_i=q_i, q_d=q_d, q_i_dot=q_i_dot, t=t)["q_d_dot"]
    return State(q_i, q_d, q_i_dot, q_d_dot, join(model, q_i, q_d), join(model, q_i_dot, q_d_dot), t)


def join(model: Model, independent: Array, dependent: Array) -> Array:
    """A vector in the order of model.coordinates."""
    return whole(model, independent, dependent)


def random_states(
    model: Model,
    count: int,
    seed: int = 1,
    rigid: float = 0.4,
    elastic: float = 2e-3,
    rate: float = 2.0,
    t: float = 0.37,
) -> list[State]:
    """Random states around the initial one: rigid coordinates by +-rigid, elastic ones by +-elastic."""
    rng = np.random.default_rng(seed)
    soft = np.array([name in model.elastic for name in model.q_i])
    reach, speed = np.where(soft, elastic, rigid), np.where(soft, 0.1 * rate, rate)
    n, start = len(model.q_i), independent_part(model, model.initial_q)
    return [
        make_state(model, start + rng.uniform(-1, 1, n) * reach, rng.uniform(-1, 1, n) * speed, t) for _ in range(count)
    ]


def condensed_accelerations(model: Model, state: State) -> Array:
    """q_ddot of all coordinates by M_hat q_i_ddot = Q_hat (Eq. 38) and Eq. (35)."""
    result = evaluate(model, "condensed", **state.values())
    q_i_ddot = np.linalg.solve(result["M_hat"].reshape(len(model.q_i), -1), result["Q_hat"])
    q_d_ddot = np.zeros(0)
    if model.q_d:
        q_d_ddot = evaluate(model, "accelerations", **state.values(), q_i_ddot=q_i_ddot)["q_d_ddot"]
    return join(model, q_i_ddot, q_d_ddot)


def augmented_solution(model: Model, state: State) -> tuple[Array, Array]:
    """(q_ddot, lam) of Eq. (28), rows and columns scaled before the solution; lam of least norm."""
    result = evaluate(model, "augmented", **state.values())
    n, rows = len(model.coordinates), len(model.kept_rows)
    M, side = result["M"].reshape(n, n), result["Q_star"]
    if rows == 0:
        return np.linalg.solve(M, side), np.zeros(0)
    constraint = evaluate(model, "constraints", **state.values())
    all_C_q = constraint["C_q"].reshape(-1, n)
    C_q = all_C_q[model.kept_rows]
    matrix = np.block([[M, C_q.T], [C_q, np.zeros((rows, rows))]])
    side = np.concatenate([side, constraint["gamma"][model.kept_rows]])
    # masses of elastic and rigid coordinates differ by orders of magnitude: scale symmetrically, then refine once
    scale = np.ones(n + rows)
    for _ in range(5):
        scale /= np.sqrt(np.abs(matrix * np.outer(scale, scale)).max(axis=1))
    scaled = matrix * np.outer(scale, scale)
    solution = np.linalg.solve(scaled, scale * side)
    solution += np.linalg.solve(scaled, scale * side - scaled @ solution)
    solution *= scale
    lam = solution[n:]
    if model.redundant:  # the same force C_q^T lam from all rows
        lam = np.linalg.lstsq(all_C_q.T, C_q.T @ lam, rcond=1e-11)[0]
    return solution[:n], lam


def reactions(model: Model, state: State, q_ddot: Array) -> Array:
    """lam of all constraint rows (Eq. 37), of least norm."""
    return _reactions(model, state, q_ddot)[0]


def joint_forces(model: Model, state: State, q_ddot: Array) -> dict[str, Array]:
    """World force and moment of each joint on its body b, at marker b; with redundant rows those of least norm."""
    return dict(zip(model.joints, _reactions(model, state, q_ddot)[1], strict=True))


def _reactions(model: Model, state: State, q_ddot: Array) -> tuple[Array, Array]:
    values = {"q": state.q, "q_dot": state.q_dot, "q_ddot": q_ddot, "t": np.array([state.t])}
    C_q = np.asarray(evaluate(model, "constraints", **state.values())["C_q"]).reshape(-1, len(model.coordinates))
    lam, forces = joint_reactions(
        model,
        {key: value[None, :] for key, value in values.items()},
        C_q.T.reshape(1, -1),
        model.constants(model.parameter_vector()),
    )
    return lam[0], forces[0]


def power_gap(model: Model, state: State, q_ddot: Array, lam: Array) -> float:
    """Rate of all energy minus the power of loads, driven joints and dampers, over the sum of all parts of the rate."""
    kernel, n = model.kernel("energy"), len(model.coordinates)
    q, q_dot, t = ca.SX.sym("q", n), ca.SX.sym("q_dot", n), ca.SX.sym("t")
    values = {"q": q, "q_dot": q_dot, "t": t, "c": model.constants(model.parameter_vector())}
    found = kernel.call({name: values[name] for name in kernel.name_in()})
    stored = found["kinetic"] + found["elastic"] + found["potential"]
    slope = ca.Function("slope", [q, q_dot, t], [ca.jacobian(stored, ca.vertcat(q, q_dot, t))])
    parts = np.asarray(slope(state.q, state.q_dot, state.t)).ravel() * np.concatenate([state.q_dot, q_ddot, [1.0]])
    power = evaluate(model, "energy", **state.values())
    driven = float(lam @ evaluate(model, "constraints", **state.values())["C_t"]) if model.constraints else 0.0
    given = float(power["power_applied"][0]) + driven - float(power["power_dissipated"][0])
    assert float(power["power_dissipated"][0]) >= 0
    return abs(float(np.sum(parts)) - given) / (float(np.sum(np.abs(parts))) + 1e-2)


def relative_error(value: Array, reference: Array) -> float:
    """Largest difference over the largest entry of the reference (1e-300 if that is zero)."""
    value, reference = np.asarray(value, dtype=float), np.asarray(reference, dtype=float)
    assert value.shape == reference.shape, (value.shape, reference.shape)
    if value.size == 0:
        return 0.0
    return float(np.max(np.abs(value - reference)) / max(np.max(np.abs(reference)), 1e-300))
