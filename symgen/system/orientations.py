"""Bodies whose orientation has velocities of its own: the absolute angular velocity in body axes, not rates of q.

Such a body is placed by no joint: it floats, a spherical joint holds it, or it is part of a closed loop, where some of
its turns are independent and the others loop unknowns. Its coordinates are a rotation vector theta from a chart, a unit
quaternion that is data of a run, with omega for theta' at theta = 0,

    e = chart o exp(theta),    e' = e o (0, omega) / 2,    e'' = e o (0, omega') / 2 - (omega.omega / 4) e,

so that its Euler parameters e depend on them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import casadi as ca

from runtime.contract.records import Coordinate
from symgen.algebra.rows import nonzero
from symgen.algebra.scalar import ONE, ZERO, div, dot, mul, neg
from symgen.algebra.vectors import Vector, identity, quaternion_product, rotation_of, scaled, zeros
from symgen.system.constraint import ConstraintRow
from symgen.system.topology import Topology

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord

AXES = "xyz"
LEAST_SQUARED_ANGLE = 1e-300  # of a squared angle: keeps its root from zero, where exp has no derivative


@dataclass(frozen=True)
class BallPlacement:
    """A spherical joint of the tree; forward: the child is the body of marker b."""

    parent: str
    child: str
    forward: bool


@dataclass(frozen=True)
class Orientations:
    """bodies: names, in scene order. balls: the spherical joints that hold some of them, by name."""

    bodies: tuple[str, ...] = ()
    balls: Mapping[str, BallPlacement] = field(default_factory=dict)

    @property
    def children(self) -> dict[str, str]:
        """The body that each of these joints holds."""
        return {name: ball.child for name, ball in self.balls.items()}


@dataclass(frozen=True)
class RotationVector:
    """Columns of q of one such body: theta (3) and e (4) with its symbols, omega, and the chart's symbols (4)."""

    body: str
    columns: list[int]
    parameters: list[int]
    e: Vector
    omega: Vector
    chart: Vector

    @property
    def A(self) -> list[Vector]:
        """Rotation matrix of the body by rows, from e of unit length."""
        return rotation_of(self.e)

    def rows(self, theta: Vector) -> list[ConstraintRow]:
        """e - chart o exp(theta) = 0, with C_q along the angular velocity."""
        half, share = _half(theta)
        turn = [ca.cos(half), *scaled(share / 2, theta)]
        reached = quaternion_product(self.chart, turn)
        slopes = [quaternion_product(self.e, [ZERO, *(div(one, ca.SX(2)) for one in unit)]) for unit in identity()]
        fading = div(dot(self.omega, self.omega), ca.SX(4))
        return [
            ConstraintRow(
                f"{self.body}.turn{k}",
                "",
                "quaternion",
                self.e[k] - reached[k],
                nonzero({self.parameters[k]: ONE, **{c: neg(s[k]) for c, s in zip(self.columns, slopes, strict=True)}}),
                ZERO,
                neg(mul(fading, self.e[k])),
                tuple(zeros(6)),
            )
            for k in range(4)
        ]

    def T(self, theta: Vector) -> list[Vector]:
        """By rows: omega = T theta', T = 1 - (1 - cos s)/s^2 theta~ + (1 - sin s/s)/s^2 theta~^2, s = |theta|."""
        half, share = _half(theta)
        first, second = mul(share, share) / 2, (1 - mul(share, ca.cos(half))) / (4 * mul(half, half))
        square = dot(theta, theta)
        tilde = [[ZERO, neg(theta[2]), theta[1]], [theta[2], ZERO, neg(theta[0])], [neg(theta[1]), theta[0], ZERO]]
        return [
            [
                one - mul(first, tilde[i][j]) + mul(second, mul(theta[i], theta[j]) - mul(square, one))
                for j, one in enumerate(unit)
            ]
            for i, unit in enumerate(identity())
        ]


def _half(theta: Vector) -> tuple[ca.SX, ca.SX]:
    """(|theta| / 2, its sine over it)."""
    half = ca.sqrt(div(dot(theta, theta), ca.SX(4)) + LEAST_SQUARED_ANGLE)
    return half, ca.sin(half) / half


def turn_coordinates(body: str) -> list[Coordinate]:
    """theta of a body as independent coordinates; their velocities are omega [rad/s]."""
    return [Coordinate(f"{body}.turn_{axis}", body, "angle", "rad") for axis in AXES]


def orientations_of(scene: SceneRecord, topology: Topology) -> Orientations:
    """Those of a spatial scene."""
    described = {body.name: body for body in scene.moving_bodies}
    spherical = {joint.name for joint in scene.joints if joint.is_ball()}
    balls, _ = _tree(topology, list(described), spherical)
    free = [name for name in described if name not in topology.placed]
    return Orientations(tuple(free), {joint: ball for joint, ball in balls.items() if ball.child in free})


def _tree(
    topology: Topology, bodies: list[str], spherical: set[str]
) -> tuple[dict[str, BallPlacement], dict[str, str]]:
    """(spherical joints of a spanning tree, parent of each body but of those that float).

    Placing joints come first: a ball may hold only a body that none of them places.
    """
    parents = {placement.child: placement.parent for placement in topology.placements.values()}
    roots = ["ground", *(name for name in bodies if name not in parents)]
    balls: dict[str, BallPlacement] = {}
    reached: set[str] = set()
    while len(reached) < len(bodies) + 1:
        reached.add(next(root for root in roots if root not in reached))
        growing = True
        while growing:
            before = len(reached)
            reached |= {child for child, parent in parents.items() if parent in reached}
            for link in topology.links:
                for near, far in ((link.a, link.b), (link.b, link.a)):
                    new = near in reached and far in roots and far not in reached
                    if new and link.joint in spherical:
                        balls[link.joint], parents[far] = BallPlacement(near, far, far == link.b), near
                        reached.add(far)
            growing = len(reached) > before
    return balls, parents
