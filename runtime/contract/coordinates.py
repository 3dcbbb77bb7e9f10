"""q from q_i and q_d and back, with the rates of turns as angular velocities; which coordinates are lengths, which
angles; initial values by name.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol

import casadi as ca
import numpy as np

from runtime.contract.model import EmittedModel
from runtime.contract.orientations import angular_velocity, chart_rates, exponential, product, rotation_vector

# Vectors of q_i and q_d from those of all coordinates and back; angular velocities stand for the rates of turns.

OMEGA = ("omega_x", "omega_y", "omega_z")


def sides_in(model: EmittedModel) -> slice:
    """Where the sides of jumps by the motion stand in c, before the charts."""
    return slice(model.emitted_c_size, model.emitted_c_size + len(model.description.held))


def charts_in(model: EmittedModel) -> slice:
    """Where the charts of orientations stand in c, before the numbers of inputs."""
    first = sides_in(model).stop
    return slice(first, first + 4 * len(model.description.orientations))


def followed(model: EmittedModel) -> tuple[list[str], np.ndarray]:
    """(names, columns of q) of what tells a motion: q_i, with Euler parameters in place of turns."""
    at, turns = model.places, model.description.orientations
    return model.derived(
        "what tells a motion",
        lambda: (
            [*(model.q_i[k] for k in at.plain), *(name for record in turns for name in record.parameters)],
            np.concatenate([at.columns, at.parameters.ravel()]),
        ),
    )


def _parts(
    model: EmittedModel, q: np.ndarray, of_turns: Callable[[np.ndarray], np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """(independent, dependent) part of a vector (..., n) of all coordinates; of_turns: columns of e -> (..., 3)."""
    at = model.places
    found = np.zeros((*q.shape[:-1], at.n_i + len(model.q_d)), dtype=q.dtype)
    found[..., at.plain], found[..., at.n_i + at.dependent_plain] = q[..., at.columns], q[..., at.dependent]
    for turns, e in zip(at.turns, at.parameters, strict=True):
        found[..., turns] = of_turns(e)
    return found[..., : at.n_i], found[..., at.n_i :]


def parts(model: EmittedModel, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(q_i (..., n_i), q_d (..., n_d)) of all coordinates q (..., n).

    Turns are rotation vectors, below 2 pi, from charts that are 1.
    """
    q = np.asarray(q)
    return _parts(model, q, lambda e: rotation_vector(q[..., e]))


def rate_parts(model: EmittedModel, q: np.ndarray, q_dot: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(q_i_dot, q_d_dot) of all coordinates and rates (..., n): angular velocities for the turns."""
    q, q_dot = np.asarray(q), np.asarray(q_dot)
    return _parts(model, q_dot, lambda e: angular_velocity(q[..., e], q_dot[..., e]))


def independent_part(model: EmittedModel, q: np.ndarray) -> np.ndarray:
    """q_i (..., n_i) of all coordinates, see `parts`."""
    return parts(model, q)[0]


def dependent_part(model: EmittedModel, q: np.ndarray) -> np.ndarray:
    """q_d (..., n_d) of all coordinates, see `parts`."""
    return parts(model, q)[1]


def loop_part(model: EmittedModel, q: np.ndarray) -> np.ndarray:
    """The loop unknowns (..., n_l) of all coordinates, see `parts`."""
    return parts(model, q)[1][..., model.places.loops]


def independent_rates(model: EmittedModel, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
    """q_i_dot (..., n_i) of all coordinates and rates, see `rate_parts`."""
    return rate_parts(model, q, q_dot)[0]


def independent(model: EmittedModel, q: np.ndarray, q_dot: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(q_i, q_i_dot) of all coordinates and rates, see `independent_part` and `independent_rates`."""
    return independent_part(model, q), independent_rates(model, q, q_dot)


def angular_velocities(model: EmittedModel, q: np.ndarray, q_dot: np.ndarray) -> dict[str, np.ndarray]:
    """(...) angular velocities in body axes [rad/s] by name at q, q_dot (..., n), of bodies with Euler parameters."""
    found: dict[str, np.ndarray] = {}
    for body, columns in parameter_columns(model).items():
        omega = angular_velocity(q[..., columns], q_dot[..., columns])
        found |= {f"{body}.{axis}": omega[..., k] for k, axis in enumerate(OMEGA)}
    return found


def parameter_columns(model: EmittedModel) -> dict[str, list[int]]:
    """Columns of q of each body's Euler parameters, by body."""
    found: dict[str, list[int]] = {}
    for column, entry in enumerate(model.description.coordinates):
        if entry.kind == "euler_parameter":
            found.setdefault(entry.owner, []).append(column)
    return found


def euler_angles(model: EmittedModel) -> dict[str, str]:
    """Sequence of axes of each body whose Euler angles are input and output, by body."""
    return {one.name: one.orientation for one in model.description.bodies if one.angles}


def whole(model: EmittedModel, independent: np.ndarray, dependent: np.ndarray) -> np.ndarray:
    """A vector (..., n) in the order of the model's coordinates of its parts (..., n_i) and (..., n_d)."""
    at, independent, dependent = model.places, np.asarray(independent), np.asarray(dependent)
    found = np.zeros((*independent.shape[:-1], len(model.coordinates)), dtype=independent.dtype)
    found[..., at.columns] = independent[..., at.plain]
    found[..., at.dependent] = dependent[..., at.dependent_plain]
    return found


def joined(model: EmittedModel, independent: ca.SX, dependent: ca.SX) -> ca.SX:
    """`whole` of symbols (n_i) and (n_d)."""
    found, at = ca.SX(len(model.coordinates), 1), model.places
    for position, column in zip(at.plain, at.columns, strict=True):
        found[int(column)] = independent[int(position)]
    for position, column in zip(at.dependent_plain, at.dependent, strict=True):
        found[int(column)] = dependent[int(position)]
    return found


def turned_by(
    model: EmittedModel, q: np.ndarray, change: np.ndarray, q_i: np.ndarray, step: np.ndarray, loop: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(q_i (n_i,), guess of the loop unknowns) after a step (n_i,) whose turns are rotations in axes of their bodies.

    q, change (n,): all coordinates before, and what the step does to them; charts are 1.
    """
    at = model.places
    found, following = q_i + step, np.zeros(len(model.q_d))
    following[at.loops] = loop
    whole_ = np.concatenate([found, following])
    for turns, e in zip(at.turns, at.parameters, strict=True):
        turn = angular_velocity(q[e], change[e])
        before = exponential(rotation_vector(q[e]))
        whole_[turns] = rotation_vector(product(before, exponential(turn)))
    return whole_[: at.n_i], whole_[at.n_i :][at.loops]


def at_home(model: EmittedModel, c: np.ndarray, q_d: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """c (..., c_size) and q_d (..., n_d) with charts where the bodies are; independent turns are zero there."""
    at = model.places
    if not len(at.turns):
        return c, q_d
    c, q_d = np.array(np.broadcast_to(c, (*q_d.shape[:-1], c.shape[-1]))), q_d.copy()
    q = whole(model, np.zeros((*q_d.shape[:-1], at.n_i)), q_d)
    c[..., charts_in(model)] = q[..., at.parameters.ravel()]
    q_d[..., [k - at.n_i for k in at.turns.ravel() if k >= at.n_i]] = 0.0
    return c, q_d


def independent_slopes(
    model: EmittedModel, q: np.ndarray, q_dot: np.ndarray, dq: np.ndarray, dq_dot: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Derivatives (., k) of q_i, q_i_dot and the loop unknowns at q, q_dot (n,) by those of q and q_dot (n, k)."""
    at = model.places
    di, dv = (np.zeros((at.n_i + len(model.q_d), dq.shape[1])) for _ in range(2))
    plain, columns = [*at.plain, *(at.n_i + at.dependent_plain)], [*at.columns, *at.dependent]
    di[plain], dv[plain] = dq[columns], dq_dot[columns]
    for turns, e in zip(at.turns, at.parameters, strict=True):
        di[turns] = chart_rates(rotation_vector(q[e])) @ angular_velocity(q[e], dq[e].T).T
        dv[turns] = (angular_velocity(q[e], dq_dot[e].T) + angular_velocity(dq[e].T, q_dot[e])).T
    return di[: at.n_i], dv[: at.n_i], di[at.n_i :][at.loops]


# Lengths and angles in one measure: which rows are distances, and the size of a mechanism.

SMALLEST_ARM = 1e-9  # m: less is the rounding dust of an arm that is zero


def length_rows(model: EmittedModel) -> np.ndarray:
    """(n_c,) which constraint rows are distances [m]."""
    return np.array([row.unit == "m" for row in model.description.constraints], dtype=bool)


def turning_columns(model: EmittedModel) -> np.ndarray:
    """(n,) which coordinates are angles or Euler parameters."""
    return np.array([coordinate.turns for coordinate in model.description.coordinates], dtype=bool)


def mechanism_length(model: EmittedModel, C_q: np.ndarray) -> float:
    """The largest lever arm in C_q (n_c x n) [m], 1 if there is none."""
    return longest_arm(np.asarray(C_q)[np.ix_(length_rows(model), turning_columns(model))])


def longest_arm(arms: np.ndarray) -> float:
    """The largest of lever arms [m], 1 if there is none."""
    longest = float(np.abs(arms).max(initial=0.0))
    return longest if longest > SMALLEST_ARM else 1.0


# Initial values as a run takes them: by name, or from what has a state, an equilibrium or a solution.


class HasState(Protocol):
    """An equilibrium, or a solution, of which it is the last sample."""

    def initial_values(self) -> dict[str, float]:
        """All coordinates and rates by name."""


Initial = Mapping[str, float] | HasState | None


def values_by_name(initial: Initial) -> Mapping[str, float] | None:
    """Initial values by name."""
    return initial if initial is None or isinstance(initial, Mapping) else initial.initial_values()


def named_values(model: EmittedModel, q: np.ndarray, q_dot: np.ndarray) -> dict[str, float]:
    """Coordinates (n,) and rates (n,) by name; of the state of a controller its value alone, which is a rate."""
    values: dict[str, float] = {}
    for entry, place, rate in zip(model.description.coordinates, q.tolist(), q_dot.tolist(), strict=True):
        values |= {entry.owner: rate} if entry.kind == "state" else {entry.name: place, f"{entry.name}_dot": rate}
    return values
