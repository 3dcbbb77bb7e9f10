"""How the motion of a frame, and the powers of a wrench on the move that leads there, change by the move's coordinates.

A coordinate displaces the frame after its move by a twist, tau and v in the axes of that frame. With D the rate as seen
from the ground, D x = x' + omega x x, D^2 x = x'' + 2 omega x x' + G x, the changes (u, beta, d) of that frame are

    by position    u = D tau,   beta = D^2 tau,    d = D^2 v - tau x a
    by rate        u = tau,     beta = 2 D tau,    d = 2 D v.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import add, dot, mul, neg, sub
from symgen.algebra.vectors import (
    Vector,
    combination,
    cross,
    minus,
    negative,
    plus,
    scaled,
    times,
    transposed_times,
    zeros,
)
from symgen.bodies.deformation import Bent, Deformation
from symgen.system.frames.motion import Motion, Wrench
from symgen.system.frames.moves import Slide, Turn, unit
from symgen.system.frames.tangents import Change

HALF, TWO = ca.SX(0.5), ca.SX(2)


@dataclass(frozen=True)
class Spot:
    """A move with the motion before and after it, and the rates and accelerations of the coordinates by column."""

    before: Motion
    after: Motion
    rates: Row
    accelerations: Row


def turn_changes(move: Turn, spot: Spot) -> tuple[dict[int, Change], dict[int, Change]]:
    """By position and by rate, by column."""
    if move.column is None:
        return {}, {}
    z, omega = unit(move.axis, move.sign), spot.after.omega
    by_position = Change(cross(omega, z), times(spot.after.G, z), cross(spot.after.a, z))
    return {move.column: by_position}, {move.column: Change(z, cross(scaled(TWO, omega), z), zeros())}


def slide_changes(move: Slide, spot: Spot) -> tuple[dict[int, Change], dict[int, Change]]:
    """By position and by rate, by column."""
    if move.column is None:
        return {}, {}
    e, none = unit(move.axis, move.factor), zeros()
    by_rate = Change(none, none, cross(scaled(TWO, spot.after.omega), e))
    return {move.column: Change(none, none, times(spot.after.G, e))}, {move.column: by_rate}


@dataclass(frozen=True)
class _Bending:
    """A marker's place rho and turning as the modes of its body move them, in body axes, which move with `body`."""

    deformation: Deformation
    body: Motion
    rates: Row
    accelerations: Row

    @cached_property
    def bent(self) -> Bent:
        return self.deformation.at(self.rates)

    @cached_property
    def _own(self) -> tuple[Vector, Vector]:
        return self.deformation.of(self.rates), self.deformation.of(self.accelerations)

    @cached_property
    def _turning(self) -> tuple[Vector, Vector, ca.SX, ca.SX]:
        """psi' and psi'' with 1 / (2 k), k' / k and k'' / k, where k = 1 + psi.psi / 4."""
        turns, (speeds, own) = self.deformation.point.turns, self._own
        first, second, bent = combination(turns, speeds), combination(turns, own), self.bent
        half = mul(HALF, bent.inverse)
        rate = mul(half, dot(bent.psi, first))
        bending = mul(half, add(dot(first, first), dot(bent.psi, second)))
        return scaled(half, first), scaled(half, second), rate, bending

    def turned(self, b: int) -> tuple[Vector, Vector, Vector]:
        """The axis about which mode b turns the marker, its D and D^2."""
        value = self.bent.turned[b]
        if self.bent.inverse.is_zero():
            return value, zeros(), zeros()
        first, second, rate, bending = self._turning
        theta = self.deformation.point.turns[b]
        own = minus(cross(first, theta), scaled(rate, value))
        more = minus(cross(second, theta), plus(scaled(mul(TWO, rate), own), scaled(bending, value)))
        return self._seen(value, own, more)

    def shape(self, b: int) -> tuple[Vector, Vector, Vector]:
        """By which mode b moves the marker, its D and D^2."""
        speeds, own = self._own
        H = self.deformation.point.H
        fading = [[neg(dot(block[b], values)) for block in H] or zeros() for values in (speeds, own)]
        return self._seen(self.bent.shapes[b], *fading)

    def _seen(self, value: Vector, rate: Vector, second: Vector) -> tuple[Vector, Vector, Vector]:
        omega = self.body.omega
        first = plus(rate, cross(omega, value))
        return value, first, plus(second, cross(scaled(TWO, omega), rate), times(self.body.G, value))

    @property
    def speed(self) -> Vector:
        """D rho."""
        return plus(self.bent.rho_dot, cross(self.body.omega, self.bent.rho))

    def twice_turning(self, b: int, moment: Vector) -> Vector:
        """d(on_turns(moment)) / dq_b but for what goes with on_turns itself: moment x turn_b / (2 k)."""
        theta = self.deformation.point.turns[b]
        return scaled(mul(HALF, self.bent.inverse), cross(moment, theta))

    def share(self, b: int) -> ca.SX:
        """-(d(1/k) / dq_b) k = psi . turn_b / (2 k)."""
        return mul(mul(HALF, self.bent.inverse), dot(self.bent.psi, self.deformation.point.turns[b]))


@dataclass(frozen=True)
class OwnChange:
    """Change of a wrench by a coordinate of the move before it: as seen before that move, and of the powers there."""

    before: Wrench
    powers: Row


class BendChanges:
    """From the frame of a flexible body to a marker, or with `back` from such a marker to the frame."""

    def __init__(self, deformation: Deformation, spot: Spot, back: bool) -> None:
        self._back = back
        body = spot.after if back else spot.before
        self._bending = _Bending(deformation, body, spot.rates, spot.accelerations)
        R = self._bending.bent.R
        self._a = times(R, (spot.before if back else spot.after).a)  # of the marker, in body axes
        self._R, self._columns = R, deformation.columns

    def changes(self) -> tuple[dict[int, Change], dict[int, Change]]:
        """By position and by rate, by column."""
        by_position, by_rate = {}, {}
        for b, column in enumerate(self._columns):
            by_position[column], by_rate[column] = self._unbent(b) if self._back else self._bent(b)
        return by_position, by_rate

    def _bent(self, b: int) -> tuple[Change, Change]:
        t, t1, t2 = self._bending.turned(b)
        s, s1, s2 = self._bending.shape(b)
        place = (t1, t2, minus(s2, cross(t, self._a)))
        rate = (t, scaled(TWO, t1), scaled(TWO, s1))
        first, second = (Change(*(transposed_times(self._R, vector) for vector in one)) for one in (place, rate))
        return first, second

    def _unbent(self, b: int) -> tuple[Change, Change]:
        t, t1, t2 = self._bending.turned(b)
        _, s1, s2 = self._bending.shape(b)
        rho, speed = self._bending.bent.rho, self._bending.speed
        held = plus(cross(t2, rho), cross(scaled(TWO, t1), speed))
        place = Change(negative(t1), negative(t2), minus(plus(held, cross(t, self._a)), s2))
        d = minus(plus(cross(t1, rho), cross(t, speed)), s1)
        return place, Change(negative(t), scaled(TWO, negative(t1)), scaled(TWO, d))

    def own(self, column: int, wrench: Wrench, change: Wrench) -> OwnChange:
        """For the wrench after the move and its change by one of the move's coordinates, both in the axes there."""
        b, bending, R = self._columns.index(column), self._bending, self._R
        bent, t = bending.bent, bending.bent.turned[b]
        if self._back:
            f, df = wrench.f, change.f
            moment = minus(wrench.n, cross(bent.rho, f))
            dn = minus(change.n, plus(cross(bent.rho, df), cross(bent.shapes[b], f)))
            powers = self._powers(b, f, moment, df, dn)
            before = (minus(df, cross(t, f)), minus(dn, cross(t, moment)))
            f_b, n_b = (transposed_times(R, vector) for vector in before)
            return OwnChange(Wrench(f_b, n_b), {column: neg(value) for column, value in powers.items()})
        f, moment = times(R, wrench.f), times(R, wrench.n)
        df, dn = plus(times(R, change.f), cross(t, f)), plus(times(R, change.n), cross(t, moment))
        n = plus(dn, cross(bent.rho, df), cross(bent.shapes[b], f))
        return OwnChange(Wrench(df, n), self._powers(b, f, moment, df, dn))

    def _powers(self, b: int, f: Vector, moment: Vector, df: Vector, dn: Vector) -> Row:
        """Of the change of f and of the moment about the marker, and of shapes and turns as q_b changes them."""
        bending, bent, point = self._bending, self._bending.bent, self._bending.deformation.point
        turning = plus(bent.on_turns(dn), bending.twice_turning(b, moment))
        known, share = bent.on_turns(moment), bending.share(b)
        found = {}
        for a, column in enumerate(self._columns):
            value = add(dot(bent.shapes[a], df), dot(point.turns[a], turning))
            value = sub(value, mul(share, dot(point.turns[a], known)))
            for i, H in enumerate(point.H):
                value = sub(value, mul(H[a][b], f[i]))
            found[column] = value
        return found
