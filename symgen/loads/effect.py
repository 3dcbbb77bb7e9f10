"""What a load does: generalised force, stored energy, dissipated and applied power (Q_F of Eq. 20)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import casadi as ca

from symgen.algebra.rows import Row


@dataclass(frozen=True)
class LinearSpring:
    """A spring and damper on the deflection row . q [rad]: stiffness [N m/rad] and damping [N m s/rad]."""

    row: Row
    stiffness: ca.SX
    damping: ca.SX


@dataclass(frozen=True)
class LoadEffect:
    """Generalised force by system column [N, N m]; potential [J]; dissipated and applied power [W].

    spring: what of it is linear in the coordinates, if it is that.
    action: force [N] and moment [N m] in world axes on the load's marker, or on marker b: x, y and about z in a plane,
    three and three in space.
    """

    force: Row = field(default_factory=dict)
    potential: ca.SX = field(default_factory=lambda: ca.SX(0))
    dissipated: ca.SX = field(default_factory=lambda: ca.SX(0))
    applied: ca.SX = field(default_factory=lambda: ca.SX(0))
    spring: LinearSpring | None = None
    action: Sequence[ca.SX] = ()
