"""How far Euler angles turn in a step near the singular orientation of a body: the largest turn so far, kept in z.

Near that orientation (the cosine of the middle angle of three different axes, its sine of two, below NEAR) the two
other angles turn as fast as its inverse. Only angles among q_i are looked at; without such bodies z has no such fields.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.engine.program import Fields, Program, Sequence
from runtime.schemes.scheme import Scheme

NEAR = 0.2


def _bodies(model: Model) -> list[tuple[list[int], bool]]:
    """(positions of the three angles in q_i, are the axes different?) of each body."""
    found = []
    for body in model.description.bodies:
        if len(body.angles) == 3 and all(name in model.q_i for name in body.angles):
            found.append(([model.q_i.index(name) for name in body.angles], len(set(body.orientation)) == 3))
    return found


def watch_turns(scheme: Scheme) -> None:
    """Give z the fields, where there are such bodies. Before anything of the scheme is built.

    Steps that follow from a tolerance are as short as such a turn asks for.
    """
    bodies = [] if scheme.adaptive else _bodies(scheme.model)
    if bodies and "turn" not in scheme.layout.sizes:
        scheme.keep_account({"turn": 1, "angles_before": 2 * len(bodies)})


def begin_turns(scheme: Scheme, z: np.ndarray) -> None:
    """Count anew from a state z (at least the scheme's part, flat)."""
    if "turn" in scheme.layout.sizes:
        z[scheme.layout.slice("angles_before")] = z[scheme.layout.slice("x")][outer_angles(scheme.model)]


def outer_angles(model: Model) -> list[int]:
    """Positions in q_i of the first and the last angle of each such body."""
    return [position for angles, _ in _bodies(model) for position in (angles[0], angles[2])]


def turn_of(scheme: Scheme, z: np.ndarray) -> float:
    """The largest turn so far [rad]; zero where none is looked at."""
    return float(z[scheme.layout.slice("turn")][0]) if "turn" in scheme.layout.sizes else 0.0


def with_turns(scheme: Scheme, program: Program) -> Program:
    """A major step, and the account of turns where z has its fields."""
    if "turn" not in scheme.layout.sizes:
        return program
    return Sequence((program, scheme.stage("turns", lambda z, equations: _counted(scheme.model, z))))


def _counted(model: Model, z: Fields) -> Mapping[str, ca.SX]:
    turn, outer = z["turn"], []
    for k, (angles, different) in enumerate(_bodies(model)):
        middle = z["x"][angles[1]]
        near = ca.fabs(ca.cos(middle) if different else ca.sin(middle)) < NEAR
        for end, position in enumerate((angles[0], angles[2])):
            now = z["x"][position]
            turn = ca.fmax(turn, near * ca.fabs(now - z["angles_before"][2 * k + end]))
            outer.append(now)
    return {"turn": turn, "angles_before": ca.vertcat(*outer)}
