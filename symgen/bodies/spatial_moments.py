"""Shape integrals of a spatial body and their values at its current q_f (Eq. 20), all in body axes.

A point of a flexible body and the axes there as its modes move them, in body axes (Eq. 19).

The small rotation psi = sum turn_a q_a turns the axes by the quaternion (1, psi/2) made of unit length: with
k = 1 + psi.psi / 4, A_psi = 1 + (psi~ + psi~^2 / 2) / k, exactly a rotation, and in body axes
omega_psi = (psi_dot + psi x psi_dot / 2) / k, whose own rate without q_f_ddot is -(k_dot / k) omega_psi.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, add, div, dot, mul, neg, sub, total
from symgen.algebra.vectors import (
    Matrix,
    Vector,
    axial,
    combination,
    cross,
    identity,
    minus,
    plus,
    product,
    scaled,
    times,
    zeros,
)


@dataclass(frozen=True)
class SpatialIntegrals:
    """Integrals over the mass about the frame origin, nf modes; matrices as lists of rows of SX.

    mass [kg]; S1 = int rho0 dm (3); J0 = int rho0 rho0^T dm (3 x 3); Sb[a] = int phi_a dm (3);
    N[a] = int rho0 phi_a^T dm (3 x 3); P[a][b] = int phi_a phi_b^T dm (3 x 3), empty for none; M_ff, K_ff, D_ff
    (nf x nf); S_H[i] = int H_i dm and G_H[i][j] = int rho0_i H_j dm (nf x nf), empty without second-order shapes.
    """

    mass: ca.SX
    S1: Vector
    J0: Matrix
    Sb: list[Vector]
    N: list[Matrix]
    P: list[list[Matrix]]
    M_ff: Matrix
    K_ff: Matrix
    D_ff: Matrix
    S_H: list[Matrix]
    G_H: list[list[Matrix]]

    @property
    def nf(self) -> int:
        """Number of modes."""
        return len(self.M_ff)

    def about(self, point: SpatialPoint) -> SpatialIntegrals:
        """Of the body as seen from a point that moves with its modes, and with which its axes do not turn.

        rho0 -> rho0 - r, phi_a -> phi_a - f_a; without second-order shapes. The mass matrix of a motion of the body is
        the same, the velocity of the point being in place of that of the origin.
        """
        r, shapes, nf = point.position, point.shapes, self.nf
        first = minus(self.S1, scaled(self.mass, r))
        J0 = [[sub(sub(self.J0[i][j], mul(r[i], self.S1[j])), mul(first[i], r[j])) for j in range(3)] for i in range(3)]
        own = [minus(self.Sb[a], scaled(self.mass, shapes[a])) for a in range(nf)]
        N = [_less(_less(self.N[a], r, self.Sb[a]), first, shapes[a]) for a in range(nf)]
        blank = [zeros() for _ in range(3)]
        P = [
            [
                _less(_less(self.P[a][b] if self.P else blank, shapes[a], self.Sb[b]), own[a], shapes[b])
                for b in range(nf)
            ]
            for a in range(nf)
        ]
        M_ff = [
            [sub(sub(self.M_ff[a][b], dot(shapes[a], self.Sb[b])), dot(own[a], shapes[b])) for b in range(nf)]
            for a in range(nf)
        ]
        return replace(self, S1=first, J0=J0, Sb=own, N=N, P=P, M_ff=M_ff)


@dataclass(frozen=True)
class SpatialPoint:
    """A marker of a body: position (3), shapes[a] (3), turns[a] (3, rotation by mode a), H[i] (nf x nf) or empty.

    axes: columns are the marker's axes in the body frame; quaternion: the same rotation.
    """

    position: Vector
    shapes: list[Vector]
    turns: list[Vector]
    H: list[Matrix]
    axes: Matrix
    quaternion: Vector

    def less(self, other: SpatialPoint) -> SpatialPoint:
        """Seen from another point, as the body in `SpatialIntegrals.about` is."""
        shapes = [minus(own, more) for own, more in zip(self.shapes, other.shapes, strict=True)]
        return replace(self, position=minus(self.position, other.position), shapes=shapes)


class LocalMotion:
    """Body-frame motion of a point: rho, drho/dq_a, rho_dot, nu = -q_f_dot^T H q_f_dot and the small rotation psi."""

    def __init__(self, point: SpatialPoint, q_f: Vector, q_f_dot: Vector) -> None:
        self.shapes = [list(shape) for shape in point.shapes]
        self.rho, self.nu = list(point.position), zeros()
        for a, q in enumerate(q_f):
            self.rho = plus(self.rho, scaled(q, point.shapes[a]))
        for i, H in enumerate(point.H):
            quadratic = times(H, q_f)
            self.rho[i] = sub(self.rho[i], mul(ca.SX(0.5), dot(q_f, quadratic)))
            self.nu[i] = neg(dot(q_f_dot, times(H, q_f_dot)))
            for a in range(len(q_f)):
                self.shapes[a][i] = sub(self.shapes[a][i], quadratic[a])
        self.rho_dot = combination(self.shapes, q_f_dot)
        self.psi, self.psi_dot = combination(point.turns, q_f), combination(point.turns, q_f_dot)

    @staticmethod
    def turn_rows(point: SpatialPoint, columns: list[int]) -> list[Row]:
        """dpsi_i/dq."""
        return [
            {column: point.turns[a][i] for a, column in enumerate(columns) if not point.turns[a][i].is_zero()}
            for i in range(3)
        ]


class SpatialMoments:
    """Of one body as it is deformed: h = int rho dm, J = int rho rho^T dm, s_a = int phi_a dm, L_a = int rho phi_a^T dm
    and B_a = int rho x phi_a dm; hd = int rho' dm, hn what is left of int rho'' dm, Gd_a = int rho' x phi_a dm.
    """

    def __init__(self, data: SpatialIntegrals, q_f: Vector, q_f_dot: Vector) -> None:
        self.data, nf = data, len(q_f)
        self.s = [list(data.Sb[a]) for a in range(nf)]
        self.h, self.hn = plus(data.S1, combination(data.Sb, q_f)), zeros()
        for i, S_H in enumerate(data.S_H):
            quadratic = times(S_H, q_f)
            self.h[i] = sub(self.h[i], mul(ca.SX(0.5), dot(q_f, quadratic)))
            self.hn[i] = neg(dot(q_f_dot, times(S_H, q_f_dot)))
            for a in range(nf):
                self.s[a][i] = sub(self.s[a][i], quadratic[a])
        self.hd = combination(self.s, q_f_dot)
        self.L = [self._pairs(a, q_f) for a in range(nf)]
        self.J = [[data.J0[i][j] for j in range(3)] for i in range(3)]
        for a, q in enumerate(q_f):  # J = J0 + sum q_a sym(N_a + L_a)
            N, L = data.N[a], self.L[a]
            for i in range(3):
                for j in range(i, 3):
                    change = add(add(N[i][j], N[j][i]), add(L[i][j], L[j][i]))
                    self.J[i][j] = self.J[j][i] = add(self.J[i][j], mul(mul(ca.SX(0.5), change), q))
        self.B = [axial(L) for L in self.L]
        self.Gd = [axial(self._rates(a, q_f_dot)) for a in range(nf)]

    def _pairs(self, a: int, q_f: Vector) -> Matrix:
        """L_a = N_a + sum_b q_b (P_ba - G_H_ab)."""
        data = self.data
        result = [list(row) for row in data.N[a]]
        for b, q in enumerate(q_f):
            for i in range(3):
                for j in range(3):
                    value = data.P[b][a][i][j] if data.P else ZERO
                    if data.G_H:
                        value = sub(value, data.G_H[i][j][a][b])
                    result[i][j] = add(result[i][j], mul(q, value))
        return result

    def _rates(self, a: int, q_f_dot: Vector) -> Matrix:
        """int rho_dot phi_a^T dm."""
        P = self.data.P
        return [
            [total(mul(rate, P[b][a][i][j]) for b, rate in enumerate(q_f_dot)) if P else ZERO for j in range(3)]
            for i in range(3)
        ]


def _less(block: Matrix, left: Vector, right: Vector) -> Matrix:
    return [[sub(block[i][j], mul(left[i], right[j])) for j in range(3)] for i in range(3)]


@dataclass(frozen=True)
class DeformedMarker:
    """Place and axes R (by columns) of the point, both by q_f: rho, drho/dq_a = shapes, omega by q_a_dot = spins.

    psi_spins: omega by a rate of each component of psi. psi and inverse are zero where no mode turns the axes.
    rho_dot, omega and the bias terms nu (of rho_ddot) and fading (of omega_dot in body axes) go with q_f_dot.
    """

    point: SpatialPoint
    psi: Vector
    inverse: ca.SX  # 1 / k
    R: Matrix
    rho: Vector
    shapes: list[Vector]
    psi_spins: list[Vector]
    spins: list[Vector]
    rho_dot: Vector
    nu: Vector
    omega: Vector
    fading: Vector

    @cached_property
    def common_axes(self) -> bool:
        """Do more modes turn the marker than there are axes about which they do?"""
        rotation = [turn for turn in self.point.turns if any(not value.is_zero() for value in turn)]
        return sum(any(not turn[k].is_zero() for turn in rotation) for k in range(3)) < len(rotation)

    def on_turns(self, moment: Vector) -> Vector:
        """(moment + moment x psi / 2) / k: its product with turn_a is the power on `spins` of mode a."""
        if self.inverse.is_zero():
            return zeros()
        return scaled(self.inverse, plus(moment, scaled(ca.SX(0.5), cross(moment, self.psi))))

    def drift(self, omega: Vector) -> Vector:
        """2 omega x rho_dot + nu: acceleration of the point by moving in a body that turns with omega."""
        return plus(cross(scaled(ca.SX(2), omega), self.rho_dot), self.nu)


def along_axes(vectors: list[Vector], columns: list[int]) -> dict[int, Row]:
    """Components by axis of the body and column, of the axes along which there are any."""
    found: dict[int, Row] = {}
    for axis in range(3):
        own = {column: one[axis] for column, one in zip(columns, vectors, strict=True) if not one[axis].is_zero()}
        if own:
            found[axis] = own
    return found


@dataclass(frozen=True)
class SharedMotion:
    """A turning theta of psi and a shape of a marker; shares of it: of the modes, by column."""

    shares: Row
    theta: Vector
    shape: Vector

    def spin(self, deformed: DeformedMarker) -> Vector:
        """The angular velocity for a unit rate."""
        return combination(deformed.psi_spins, self.theta)


@dataclass(frozen=True)
class Deformation:
    """A point with the modal coordinates of its body: values, rates and columns of q_f."""

    point: SpatialPoint
    q_f: Vector
    q_f_dot: Vector
    columns: list[int]

    @property
    def rigid(self) -> bool:
        """Do the modes leave the point and its axes where they are?"""
        moved = [component for vectors in (self.point.shapes, self.point.turns) for row in vectors for component in row]
        return all(component.is_zero() for component in moved) and not self.point.H

    @cached_property
    def shared(self) -> list[SharedMotion]:
        """What modes do to the marker: by axis where there are fewer axes than modes that move it, else by mode."""
        point, columns = self.point, self.columns
        turns, shapes = (along_axes(vectors, columns) for vectors in (point.turns, point.shapes))
        pairs = enumerate(zip(point.turns, self.still.shapes, strict=True))
        moving = [a for a, one in pairs if any(not value.is_zero() for vector in one for value in vector)]
        if point.H or len(turns) + len(shapes) >= len(moving):
            return [SharedMotion({columns[a]: ONE}, point.turns[a], self.still.shapes[a]) for a in moving]
        axes, none = identity(), zeros()
        return [SharedMotion(shares, axes[k], none) for k, shares in turns.items()] + [
            SharedMotion(shares, none, axes[k]) for k, shares in shapes.items()
        ]

    @cached_property
    def still(self) -> DeformedMarker:
        """Without rates."""
        return self.at({})

    @property
    def now(self) -> DeformedMarker:
        """With the rates q_f_dot."""
        return self._deformed(self.q_f_dot)

    def at(self, rates: Row) -> DeformedMarker:
        """With rates by column, zero where absent."""
        return self._deformed(self.of(rates))

    def of(self, values: Row) -> Vector:
        """The modes' own part of a vector by column."""
        return [values.get(column, ZERO) for column in self.columns]

    def _deformed(self, rates: Vector) -> DeformedMarker:
        local = LocalMotion(self.point, self.q_f, rates)
        kinds = local.rho, local.shapes, local.rho_dot, local.nu
        if all(component.is_zero() for turn in self.point.turns for component in turn):
            still, none = [zeros() for _ in self.columns], zeros()
            place = self.point, none, ZERO, self.point.axes, kinds[0], kinds[1]
            return DeformedMarker(*place, [none] * 3, still, kinds[2], kinds[3], none, none)
        psi, rate, half = local.psi, local.psi_dot, ca.SX(0.5)
        k = add(ONE, mul(ca.SX(0.25), dot(psi, psi)))
        inverse = div(ONE, k)
        x, y, z = scaled(mul(half, inverse), psi)
        psi_spins = [[inverse, z, neg(y)], [neg(z), inverse, x], [y, neg(x), inverse]]
        spins = [combination(psi_spins, turn) for turn in self.point.turns]
        omega = combination(psi_spins, rate)
        fading = scaled(neg(mul(mul(half, dot(psi, rate)), inverse)), omega)
        R = product(_rotation(psi, inverse), self.point.axes)
        place = self.point, psi, inverse, R, kinds[0], kinds[1]
        return DeformedMarker(*place, psi_spins, spins, kinds[2], kinds[3], omega, fading)


def _rotation(psi: Vector, inverse: ca.SX) -> Matrix:
    """1 + (psi~ + psi~^2 / 2) / k."""
    x, y, z = psi
    tilde = [[ZERO, neg(z), y], [z, ZERO, neg(x)], [neg(y), x, ZERO]]
    square = product(tilde, tilde)
    return [
        [add(ONE if i == j else ZERO, mul(inverse, add(tilde[i][j], mul(ca.SX(0.5), square[i][j])))) for j in range(3)]
        for i in range(3)
    ]
