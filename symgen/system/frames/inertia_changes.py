"""How the inertia force of a body changes with its own modes, their rates, and the motion of its frame."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, add, dot, mul, neg, sub, total
from symgen.algebra.vectors import axial, combination, cross, minus, plus, product, scaled, times, zeros
from symgen.system.frames.flexible import FlexibleInertia, RigidInertia, weighted
from symgen.system.frames.motion import Matrix, Motion, Wrench, traced
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
    Lambda = [scaled(TWO, row) for row in weighted(moments.L, own)]
    return found.moving(scaled(TWO, moments.hd), Lambda)


def mode_rows(inertia: RigidInertia | FlexibleInertia, motion: Motion, rates: Row) -> dict[int, RowChange]:
    """Of the force on each mode, by column."""
    if isinstance(inertia, RigidInertia):
        return {}
    moments, twice = inertia.moments(rates), scaled(TWO, motion.omega)
    found = {}
    for a, column in enumerate(inertia.columns):
        r = minus(scaled(TWO, moments.Gd[a]), traced(moments.L[a], twice, True))
        found[column] = RowChange(moments.B[a], moments.s[a], r)
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
        moving, turning = weighted(pairs, speeds), weighted(pairs, own)
        n = plus(
            cross(moments.s[b], motion.a),
            axial(product(doubled[b], back)),
            traced(moving, twice, False),
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
    twice, found = scaled(TWO, motion.omega), {}
    for b, column in enumerate(inertia.columns):
        fading = [neg(mul(TWO, dot(S_H[b], speeds))) for S_H in data.S_H] or zeros()
        n = traced(moments.L[b], twice, False)
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
