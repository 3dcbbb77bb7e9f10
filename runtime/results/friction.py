"""Friction of a joint over the saved samples of a run: force, mode, velocity, and the heat that it makes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from runtime.contract.coordinates import at_home, parts, rate_parts
from runtime.contract.model import Model
from runtime.engine.rows import evaluate
from runtime.results.samples import Samples, integrals

PARTS = ("force", "velocity", "power", "heat")


@dataclass(frozen=True)
class JointFriction:
    """Over N samples: force (N,) on body b along the joint's coordinate [N or N m], against the sliding or what keeps
    the joint at rest, its closed stop too; mode (N,) 0 stuck, 1 or -1 sliding; velocity (N,) [m/s or rad/s]; power
    (N,) that becomes heat [W]; heat (N,) since the first sample [J].
    """

    force: np.ndarray
    mode: np.ndarray
    velocity: np.ndarray
    power: np.ndarray
    heat: np.ndarray


def joint_friction(solution: Samples, joint: str) -> JointFriction:
    """Friction of a joint. Raises ModelError for a joint that has none."""
    names = rubbing(solution.model)
    force, velocity = solution.frictions[:, solution.column_of(joint, names, "joint with friction")].T
    power = -force * velocity
    mode = solution.measures[:, solution.model.measures.index(f"{joint}.friction_mode")]
    t, stops = solution.t, np.sort(solution.stops[:, 0])
    within = stops[(stops >= t[0]) & (stops < t[-1])]
    return JointFriction(force, mode, velocity, power, integrals(t, power, within))


def friction_columns(solution: Samples) -> dict[str, np.ndarray]:
    """(N,) `joint.friction_force`, `_velocity`, `_power` and `_heat` of each joint that has friction, by name."""
    found = {joint: joint_friction(solution, joint) for joint in rubbing(solution.model)}
    return {f"{joint}.friction_{part}": getattr(one, part) for joint, one in found.items() for part in PARTS}


def friction_units(model: Model) -> dict[str, str]:
    """SI units of the columns."""
    slides = {joint.name for joint in model.description.joints if joint.drawing == "slide"}
    units = {True: ("N", "m/s", "W", "J"), False: ("N m", "rad/s", "W", "J")}
    return {
        f"{joint}.friction_{part}": unit
        for joint in rubbing(model)
        for part, unit in zip(PARTS, units[joint in slides], strict=True)
    }


def rubbing(model: Model) -> list[str]:
    """Names of the joints with friction that sticks."""
    joints = {f"{joint.name}.friction": joint.name for joint in model.description.joints}
    return [joints[event.name] for event in model.mode_events if not event.side]


def frictions(model: Model, values: Mapping[str, np.ndarray], c: np.ndarray) -> np.ndarray:
    """(N, n_e, 2) forces and velocities at N states; values: q, q_dot, q_ddot and t, samples by rows."""
    n, names = len(values["t"]), rubbing(model)
    if not names or not model.has("element_forces"):
        return np.zeros((n, len(names), 2))
    at = dict(zip(("q_i", "q_d"), parts(model, values["q"]), strict=True))
    at |= dict(zip(("q_i_dot", "q_d_dot"), rate_parts(model, values["q"], values["q_dot"]), strict=True))
    at |= {"q_i_ddot": rate_parts(model, values["q"], values["q_ddot"])[0], "t": values["t"]}
    at["q_i"][..., [k for k in model.places.turns.ravel() if k < model.places.n_i]] = 0.0
    own, at["q_d"] = at_home(model, c, at["q_d"])
    found = evaluate(model.kernel("element_forces"), at, own)
    rows = [event.row for event in model.mode_events if not event.side]
    return np.stack([found["f_rel"][:, rows], found["v_rel"][:, rows]], axis=-1)
