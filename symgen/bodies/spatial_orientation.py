"""The orientation of one spatial body: its type's SymPy template evaluated with its SX coordinates (Eq. 17)."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from runtime.contract.orientations import angles_of
from symgen.algebra.scalar import ONE, ZERO
from symgen.algebra.vectors import Vector, combination, cross, plus, times
from symgen.bodies import orientation_template as template


@dataclass(frozen=True)
class Orientation:
    """A (rows), turning axes of each coordinate in body and world axes, omega, and omega_dot without theta''.

    coordinates: SX of theta, the Euler parameters. Ground has none and A = 1.
    """

    coordinates: Vector
    A: list[Vector]
    body_axes: list[Vector]
    world_axes: list[Vector]
    omega_body: Vector
    omega: Vector
    bias_body: Vector
    bias: Vector

    def rotate(self, body_vector: Vector) -> Vector:
        """World components of a vector in body axes."""
        return times(self.A, body_vector)

    def turned(self, k: int, world_vector: Vector) -> Vector:
        """d(A v)/dtheta_k of a vector v fixed in the body, whose world components are given."""
        return cross(self.world_axes[k], world_vector)


def fixed_orientation() -> Orientation:
    """The ground's."""
    zero = [ZERO] * 3
    unit = [[ONE if i == j else ZERO for j in range(3)] for i in range(3)]
    return Orientation([], unit, [], [], zero, zero, zero, zero)


def orientation(theta: Vector, theta_dot: Vector) -> Orientation:
    """Orientation by Euler parameters."""
    values = dict(zip((*template.e, *template.e_dot), (*theta, *theta_dot), strict=True))
    out = template.euler_parameters().evaluate(values)
    n = len(theta)
    A = [[out[f"A_{i}{j}"] for j in range(3)] for i in range(3)]
    body = [[out[f"gb_{k}_{i}"] for i in range(3)] for k in range(n)]
    world = [[out[f"g_{k}_{i}"] for i in range(3)] for k in range(n)]
    bias_body = [out[f"sb_{i}"] for i in range(3)]
    return Orientation(
        theta,
        A,
        body,
        world,
        combination(body, theta_dot),
        combination(world, theta_dot),
        bias_body,
        plus(times(A, bias_body)),
    )


def euler_angle(kind: str, k: int, e: Vector) -> ca.SX:
    """Angle k of the sequence `kind` at Euler parameters e."""
    value: ca.SX = angles_of(kind, e, ca.atan2, ca.cos, ca.sin)[k]
    return value
