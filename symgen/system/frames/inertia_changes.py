"""How the inertia force of a body changes with its own modes, their rates, and the motion of its frame."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, add, dot, mul, neg, sub, total
from symgen.algebra.vectors import Vector, axial, combination, cross, minus, plus, product, scaled, times, zeros
from symgen.system.frames.flexible import FlexibleInertia, RigidInertia
from symgen.system.frames.motion import Matrix, Motion, Wrench
from symgen.system.frames.tangents import RowChange, Tangent

TWO = ca.SX(2)


@dataclass(frozen=True)
class ModeChange:
    """Change of the wrench and of the force on each mode, by column."""

    wrench: Wrench
    modes: Row


def tangent_of(inertia: RigidInertia | FlexibleInertia, motion: Motion, rates: Row) -> Tangent:
    """Of the body alone."""
    found = Tangent.of(inertia.rigid, motion)
    if isinstance(inertia, RigidInertia):
        return found
    moments, own = inertia.moments(rates), inertia.own(rates)
    Lambda = _weighted(moments.L, scaled(TWO, own))
    return found.moving(scaled(TWO, moments.hd), Lambda)


def mode_rows(inertia: RigidInertia | FlexibleInertia, motion: Motion, rates: Row) -> dict[int, RowChange]:
    """Of the force on each mode, by column."""
    if isinstance(inertia, RigidInertia):
        return {}
    moments, twice = inertia.moments(rates), scaled(TWO, motion.omega)
    found = {}
    for a, column in enumerate(inertia.columns):
        L, s, B = moments.L[a], moments.s[a], moments.B[a]
        trace = add(add(L[0][0], L[1][1]), L[2][2])
        r = plus(minus(times(L, twice), scaled(trace, twice)), scaled(TWO, moments.Gd[a]))
        found[column] = RowChange(B, s, r)
    return found


def by_modes(inertia: RigidInertia | FlexibleInertia, motion: Motion, rates: Row, a: Row) -> dict[int, ModeChange]:
    """Derivatives by the modes q_f, by column; a: accelerations."""
    if isinstance(inertia, RigidInertia):
        return {}
    data, moments = inertia.data, inertia.moments(rates)
    speeds, own, doubled = inertia.own(rates), inertia.own(a), inertia.doubled
    twice, found = scaled(TWO, motion.omega), {}
    back = [list(column) for column in zip(*motion.G, strict=True)]
    for b, column in enumerate(inertia.columns):
        pairs = [_pair(inertia, a_, b) for a_ in range(data.nf)]  # dL_a / dq_b
        s = [[neg(S_H[a_][b]) for S_H in data.S_H] or zeros() for a_ in range(data.nf)]  # ds_a / dq_b
        f = plus(times(motion.G, moments.s[b]), cross(twice, combination(s, speeds)), combination(s, own))
        moving, turning = _weighted(pairs, speeds), _weighted(pairs, own)
        E = [[add(moving[i][j], moving[j][i]) for j in range(3)] for i in range(3)]
        n = plus(
            cross(moments.s[b], motion.a),
            axial(product(doubled[b], back)),
            minus(scaled(add(add(E[0][0], E[1][1]), E[2][2]), motion.omega), times(E, motion.omega)),
            cross(motion.omega, axial(moving)),
            axial(turning),
        )
        modes = {
            other: add(
                dot(s[k], motion.a),
                total(mul(motion.G[i][j], pairs[k][j][i]) for i in range(3) for j in range(3)),
            )
            for k, other in enumerate(inertia.columns)
        }
        found[column] = ModeChange(Wrench(f, n), modes)
    return found


def by_mode_rates(inertia: RigidInertia | FlexibleInertia, motion: Motion, rates: Row) -> dict[int, ModeChange]:
    """Derivatives by q_f', by column."""
    if isinstance(inertia, RigidInertia):
        return {}
    data, moments, speeds = inertia.data, inertia.moments(rates), inertia.own(rates)
    omega, twice, found = motion.omega, scaled(TWO, motion.omega), {}
    for b, column in enumerate(inertia.columns):
        fading = [neg(mul(TWO, dot(S_H[b], speeds))) for S_H in data.S_H] or zeros()
        E = inertia.doubled[b]
        trace = add(add(E[0][0], E[1][1]), E[2][2])
        n = plus(minus(scaled(trace, omega), times(E, omega)), cross(omega, moments.B[b]))
        modes = {other: dot(twice, axial(data.P[b][k])) if data.P else ZERO for k, other in enumerate(inertia.columns)}
        found[column] = ModeChange(Wrench(plus(cross(twice, moments.s[b]), fading), n), modes)
    return found


def _pair(inertia: FlexibleInertia, a: int, b: int) -> Matrix:
    """dL_a / dq_b."""
    data = inertia.data
    found = [list(row) for row in data.P[b][a]] if data.P else [zeros() for _ in range(3)]
    if data.G_H:
        found = [[sub(found[i][j], data.G_H[i][j][a][b]) for j in range(3)] for i in range(3)]
    return found


def _weighted(blocks: list[Matrix], factors: Vector) -> Matrix:
    return [
        [total(mul(factor, block[i][j]) for block, factor in zip(blocks, factors, strict=True)) for j in range(3)]
        for i in range(3)
    ]
