"""Vectors of q_i and q_d from those of all coordinates and back; angular velocities stand for the rates of turns."""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.angular import angular_velocity, chart_rates, exponential, product, rotation_vector
from runtime.contract.model import Model

OMEGA = ("omega_x", "omega_y", "omega_z")


def charts_in(model: Model) -> slice:
    """Where the charts of orientations stand in c, before the numbers of inputs."""
    first = model.emitted_c_size
    return slice(first, first + 4 * len(model.description.orientations))


def followed(model: Model) -> tuple[list[str], np.ndarray]:
    """(names, columns of q) of what tells a motion: q_i, with Euler parameters in place of turns."""
    e = [name for record in model.description.orientations for name in record.parameters]
    names = [*(model.q_i[k] for k in model.places.plain), *e]
    return names, np.concatenate([model.places.columns, model.places.parameters.ravel()])


def told_state(model: Model, told: np.ndarray) -> np.ndarray:
    """q (..., n) of what tells a motion (..., n_told); dependent coordinates that it does not tell are zero."""
    q = np.zeros((*told.shape[:-1], len(model.coordinates)))
    q[..., followed(model)[1]] = told
    return q


def independent_part(model: Model, q: np.ndarray) -> np.ndarray:
    """q_i (..., n_i) of all coordinates q (..., n); turns are rotation vectors, below 2 pi, from charts that are 1."""
    at, q = model.places, np.asarray(q)
    found = np.zeros((*q.shape[:-1], len(model.q_i)))
    found[..., at.plain] = q[..., at.columns]
    for turns, e in zip(at.turns, at.parameters, strict=True):
        found[..., turns] = rotation_vector(q[..., e])
    return found


def independent_rates(model: Model, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
    """q_i_dot (..., n_i) of all coordinates and rates (..., n): angular velocities for the turns."""
    at, q, q_dot = model.places, np.asarray(q), np.asarray(q_dot)
    found = np.zeros((*q_dot.shape[:-1], len(model.q_i)))
    found[..., at.plain] = q_dot[..., at.columns]
    for turns, e in zip(at.turns, at.parameters, strict=True):
        found[..., turns] = angular_velocity(q[..., e], q_dot[..., e])
    return found


def independent(model: Model, q: np.ndarray, q_dot: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(q_i, q_i_dot) of all coordinates and rates, see `independent_part` and `independent_rates`."""
    return independent_part(model, q), independent_rates(model, q, q_dot)


def angular_velocities(model: Model, q: np.ndarray, q_dot: np.ndarray) -> dict[str, np.ndarray]:
    """(...) angular velocities in body axes [rad/s] by name at q, q_dot (..., n), of bodies with Euler parameters."""
    found: dict[str, np.ndarray] = {}
    for body, columns in parameter_columns(model).items():
        omega = angular_velocity(q[..., columns], q_dot[..., columns])
        found |= {f"{body}.{axis}": omega[..., k] for k, axis in enumerate(OMEGA)}
    return found


def parameter_columns(model: Model) -> dict[str, list[int]]:
    """Columns of q of each body's Euler parameters, by body."""
    found: dict[str, list[int]] = {}
    for column, entry in enumerate(model.description.coordinates):
        if entry.kind == "euler_parameter":
            found.setdefault(entry.owner, []).append(column)
    return found


def whole(model: Model, independent: np.ndarray, dependent: np.ndarray) -> np.ndarray:
    """A vector (..., n) in the order of the model's coordinates of its parts (..., n_i) and (..., n_d)."""
    at, independent = model.places, np.asarray(independent)
    found = np.zeros((*independent.shape[:-1], len(model.coordinates)), dtype=independent.dtype)
    found[..., at.columns] = independent[..., at.plain]
    found[..., at.dependent] = dependent
    return found


def joined(model: Model, independent: ca.SX, dependent: ca.SX) -> ca.SX:
    """`whole` of symbols (n_i) and (n_d)."""
    found, at = ca.SX(len(model.coordinates), 1), model.places
    for position, column in zip(at.plain, at.columns, strict=True):
        found[int(column)] = independent[int(position)]
    for position, column in enumerate(at.dependent):
        found[int(column)] = dependent[position]
    return found


def turned_by(model: Model, q_i: np.ndarray, step: np.ndarray) -> np.ndarray:
    """q_i (n_i,) after a step (n_i,) whose turns are rotations in the axes of their bodies."""
    found = q_i + step
    for turns in model.places.turns:
        found[turns] = rotation_vector(product(exponential(q_i[turns]), exponential(step[turns])))
    return np.asarray(found)


def independent_slopes(
    model: Model, q: np.ndarray, q_dot: np.ndarray, dq: np.ndarray, dq_dot: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Derivatives (n_i, k) of `independent_part` and `independent_rates` at q, q_dot (n,) by those of them (n, k)."""
    at = model.places
    di, dv = (np.zeros((len(model.q_i), dq.shape[1])) for _ in range(2))
    di[at.plain], dv[at.plain] = dq[at.columns], dq_dot[at.columns]
    for turns, e in zip(at.turns, at.parameters, strict=True):
        di[turns] = chart_rates(rotation_vector(q[e])) @ angular_velocity(q[e], dq[e].T).T
        dv[turns] = (angular_velocity(q[e], dq_dot[e].T) + angular_velocity(dq[e].T, q_dot[e])).T
    return di, dv
