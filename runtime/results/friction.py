"""Friction and rigid stops of a joint over the saved samples of a run: forces, modes, velocity, heat, impulses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.coordinates import at_home, parts, rate_parts
from runtime.contract.model import EmittedModel
from runtime.engine.rows import evaluate
from runtime.results.samples import Samples, integrals

PARTS = ("force", "velocity", "power", "heat")


@dataclass(frozen=True, repr=False)
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

    def __repr__(self) -> str:
        largest, stuck = np.abs(self.force).max(initial=0.0), np.count_nonzero(self.mode == 0)
        rest = f"stuck at {stuck} of {len(self.mode)} samples"
        return f"<friction: largest force {largest:.6g}, {self.heat[-1]:.6g} J of heat, {rest}>"


@dataclass(frozen=True, repr=False)
class JointStop:
    """Over N samples: force (N,) on body b along the joint's coordinate [N or N m] while a stop is closed, else zero;
    where friction holds a rigid one there too, of both. impulses (k, 2): time of each impact [s], and what it gave to
    the body along the coordinate [N s or N m s]. at_rest: for how long a stop was closed, between samples [s].
    """

    force: np.ndarray
    impulses: np.ndarray
    at_rest: float

    def __repr__(self) -> str:
        largest, n = np.abs(self.force).max(initial=0.0), len(self.impulses)
        hits = f"{n} impulse{'' if n == 1 else 's'}"
        return f"<stop: largest force {largest:.6g}, {hits}, at rest for {self.at_rest:.6g} s>"


@arguments()
def joint_stop(solution: Samples, joint: str) -> JointStop:
    """Read what the stops of a joint did off a run.

    Parameters
    ----------
    solution : Solution
        N samples.
    joint : str
        Name of the joint.

    Returns
    -------
    JointStop
        Its force [N or N m] at each sample, and its impacts.

    Raises
    ------
    ModelError
        For a joint that has none.

    Notes
    -----
    Impulses of compliant stops follow from the samples, see `run.impacts()`.
    """
    if f"{joint}.stop_force" in solution.model.measures:
        return _compliant_stop(solution, joint)
    rows = stopping(solution.model)
    solution.column_of(joint, list(rows), "joint with rigid stops")
    ends = [one for one in solution.model.mode_events if one.side and one.row == rows[joint]]
    modes = [solution.measures[:, solution.model.measures.index(one.mode)] for one in ends]
    closed, sides = (np.array(modes) == 0).any(axis=0), {one.name: one.side for one in ends}
    hits = [
        (one.time, sides[one.name] * one.impulse)
        for one in solution.events
        if one.kind == "impact" and one.name in sides
    ]
    at_rest = float(np.diff(solution.t)[closed[1:] & closed[:-1]].sum())
    force = np.where(closed, solution.frictions[:, rows[joint], 0], 0.0)
    return JointStop(force, np.array(hits).reshape(-1, 2), at_rest)


def _compliant_stop(solution: Samples, joint: str) -> JointStop:
    """Its force is a measure."""
    from runtime.results.impacts import impacts

    force = solution.measures[:, solution.model.measures.index(f"{joint}.stop_force")]
    pressed = force != 0
    hits = [(one.time, one.side * one.impulse) for one in impacts(solution) if one.where == f"{joint}.stop"]
    at_rest = float(np.diff(solution.t)[pressed[1:] & pressed[:-1]].sum())
    return JointStop(force, np.array(hits).reshape(-1, 2), at_rest)


@arguments()
def joint_friction(solution: Samples, joint: str) -> JointFriction:
    """Read the friction of a joint off a run.

    Parameters
    ----------
    solution : Solution
        N samples.
    joint : str
        Name of the joint.

    Returns
    -------
    JointFriction
        Its force [N or N m], velocity, and where it sticks, at each sample.

    Raises
    ------
    ModelError
        For a joint that has none.
    """
    rows = rubbing(solution.model)
    solution.column_of(joint, list(rows), "joint with friction")
    force, velocity = solution.frictions[:, rows[joint]].T
    power = -force * velocity
    mode = solution.measures[:, solution.model.measures.index(f"{joint}.friction_mode")]
    t, stops = solution.t, np.sort(solution.stops[:, 0])
    within = stops[(stops >= t[0]) & (stops < t[-1])]
    return JointFriction(force, mode, velocity, power, integrals(t, power, within))


def friction_columns(solution: Samples) -> dict[str, np.ndarray]:
    """(N,) `joint.friction_force`, `_velocity`, `_power` and `_heat` of each joint that has friction, by name, and
    `joint.stop_force` of each that has rigid stops.
    """
    found = {joint: joint_friction(solution, joint) for joint in rubbing(solution.model)}
    columns = {f"{joint}.friction_{part}": getattr(one, part) for joint, one in found.items() for part in PARTS}
    return columns | {f"{joint}.stop_force": joint_stop(solution, joint).force for joint in stopping(solution.model)}


def friction_units(model: EmittedModel) -> dict[str, str]:
    """SI units of the columns."""
    slides = {joint.name for joint in model.description.joints if joint.drawing == "slide"}
    units = {True: ("N", "m/s", "W", "J"), False: ("N m", "rad/s", "W", "J")}
    found = {
        f"{joint}.friction_{part}": unit
        for joint in rubbing(model)
        for part, unit in zip(PARTS, units[joint in slides], strict=True)
    }
    return found | {f"{joint}.stop_force": units[joint in slides][0] for joint in stopping(model)}


def rubbing(model: EmittedModel) -> dict[str, int]:
    """Joints with friction that sticks, by name, and the row of each among what may be held."""
    return _rows(model, ("friction",))


def stopping(model: EmittedModel) -> dict[str, int]:
    """The same of joints with rigid stops."""
    return _rows(model, ("limits.lower", "limits.upper"))


def _rows(model: EmittedModel, ends: tuple[str, ...]) -> dict[str, int]:
    joints = {f"{joint.name}.{end}": joint.name for joint in model.description.joints for end in ends}
    return {joints[event.name]: event.row for event in model.mode_events if event.name in joints}


def frictions(model: EmittedModel, values: Mapping[str, np.ndarray], c: np.ndarray) -> np.ndarray:
    """(N, n_e, 2) forces and velocities of what may be held at N states; values: q, q_dot, q_ddot and t, by rows."""
    if not model.mode_events or not model.has("element_forces"):
        return np.zeros((len(values["t"]), max((1 + event.row for event in model.mode_events), default=0), 2))
    at = dict(zip(("q_i", "q_d"), parts(model, values["q"]), strict=True))
    at |= dict(zip(("q_i_dot", "q_d_dot"), rate_parts(model, values["q"], values["q_dot"]), strict=True))
    at |= {"q_i_ddot": rate_parts(model, values["q"], values["q_ddot"])[0], "t": values["t"]}
    at["q_i"][..., [k for k in model.places.turns.ravel() if k < model.places.n_i]] = 0.0
    own, at["q_d"] = at_home(model, c, at["q_d"])
    found = evaluate(model.kernel("element_forces"), at, own)
    return np.stack([found["f_rel"], found["v_rel"]], axis=-1)
