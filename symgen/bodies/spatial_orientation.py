"""The orientation of a spatial body's frame by Euler parameters e = (e0, e1, e2, e3) of unit length (Eq. 17).

Its angular velocity is 2 e' e^-1 in the world and 2 e^-1 e' in the body (products of quaternions): for a unit rate of
each parameter an axis. What these leave of the angular acceleration, 2 (e^-1)' e', has no vector part.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from runtime.contract.orientations import angles_of
from symgen.algebra.scalar import ONE, ZERO
from symgen.algebra.vectors import (
    Matrix,
    Vector,
    combination,
    conjugate,
    cross,
    identity,
    quaternion_product,
    rotation_of,
    scaled,
    times,
    zeros,
)


@dataclass(frozen=True)
class Orientation:
    """A (rows), turning axes of each Euler parameter in body and world axes, omega. Ground has none and A = 1."""

    A: Matrix
    body_axes: list[Vector]
    world_axes: list[Vector]
    omega_body: Vector
    omega: Vector

    def rotate(self, body_vector: Vector) -> Vector:
        """World components of a vector in body axes."""
        return times(self.A, body_vector)

    def derivative(self, k: int, world_vector: Vector) -> Vector:
        """d(A v)/dtheta_k of a vector v fixed in the body, whose world components are given."""
        return cross(self.world_axes[k], world_vector)


def fixed_orientation() -> Orientation:
    """The ground's."""
    return Orientation(identity(), [], [], zeros(), zeros())


def orientation(e: Vector, e_dot: Vector) -> Orientation:
    """By Euler parameters and their rates."""
    units = [[ONE if i == k else ZERO for i in range(4)] for k in range(4)]
    back, two = conjugate(e), ca.SX(2)
    body = [scaled(two, quaternion_product(back, unit)[1:]) for unit in units]
    world = [scaled(two, quaternion_product(unit, back)[1:]) for unit in units]
    return Orientation(rotation_of(e), body, world, combination(body, e_dot), combination(world, e_dot))


def euler_angle(kind: str, k: int, e: Vector) -> ca.SX:
    """Angle k of the sequence `kind` at Euler parameters e."""
    value: ca.SX = angles_of(kind, e, ca.atan2, ca.cos, ca.sin)[k]
    return value
