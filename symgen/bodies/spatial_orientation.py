"""The orientation of one spatial body: its type's SymPy template evaluated with its SX coordinates (Eq. 17)."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from symgen.algebra.scalar import ONE, ZERO
from symgen.algebra.vectors import Vector, combination, cross, plus, times
from symgen.bodies import orientation_template as template


@dataclass(frozen=True)
class Orientation:
    """A (rows), turning axes of each coordinate in body and world axes, omega, and omega_dot without theta''.

    coordinates: SX of theta (angles or Euler parameters). Ground has none and A = 1.
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

    def turned(self, k: int, body_vector: Vector, world_vector: Vector) -> Vector:
        """d(A v)/dtheta_k of a vector v fixed in the body, by the shorter of two ways.

        An axis that is fixed in the body crosses v there, where both have zeros; any other crosses A v in the world.
        """
        if sum(component.is_zero() for component in self.body_axes[k]) == 2:
            return self.rotate(cross(self.body_axes[k], body_vector))
        return cross(self.world_axes[k], world_vector)


def fixed_orientation() -> Orientation:
    """The ground's."""
    zero = [ZERO] * 3
    unit = [[ONE if i == j else ZERO for j in range(3)] for i in range(3)]
    return Orientation([], unit, [], [], zero, zero, zero, zero)


def orientation(kind: str, theta: Vector, theta_dot: Vector) -> Orientation:
    """Orientation by Euler angles of the sequence `kind`, or by euler_parameters."""
    if kind == "euler_parameters":
        form = template.euler_parameters()
        values = dict(zip((*template.e, *template.e_dot), (*theta, *theta_dot), strict=True))
    else:
        form = template.euler_angles(kind)
        values = dict(zip(template.cosines, [ca.cos(angle) for angle in theta], strict=True))
        values |= dict(zip(template.sines, [ca.sin(angle) for angle in theta], strict=True))
        values |= dict(zip(template.angle_rates, theta_dot, strict=True))
    out = form.evaluate(values)
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
