"""Shape integrals and points of a planar body at its current q_f: the values of the templates' symbols (Eq. 20)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import casadi as ca
import sympy as sp

from symgen.algebra.scalar import ZERO, add, dot, entries, mul, neg, sub, total, vector
from symgen.bodies import planar_template as template
from symgen.bodies.shape_integrals import PointShape, ShapeIntegrals

if TYPE_CHECKING:
    from symgen.bodies.planar_coordinates import BodyCoordinates

HALF = ca.SX(0.5)
Rotation = Callable[[ca.SX, ca.SX], tuple[ca.SX, ca.SX]]


def times(matrix: ca.SX, column: list[ca.SX]) -> list[ca.SX]:
    """matrix @ column on scalars."""
    return [dot(row, column) for row in entries(matrix)]


class LocalPoint:
    """Body-frame quantities of one point: rho, its shapes drho/dq_a, rho_dot and the bias nu = -q_f'^T H q_f'."""

    def __init__(self, shape: PointShape, q_f: list[ca.SX], q_f_dot: list[ca.SX]) -> None:
        along, across = entries(shape.Phi) if q_f else ([], [])
        Hq, Hv = times(shape.H, q_f), times(shape.H, q_f_dot)
        moved = [sub(phi, h) for phi, h in zip(along, Hq, strict=True)]
        self.shapes = list(zip(moved, across, strict=True))
        x, y = vector(shape.position)
        self.rho = (sub(add(x, dot(along, q_f)), mul(HALF, dot(q_f, Hq))), add(y, dot(across, q_f)))
        self.rho_dot = (dot(moved, q_f_dot), dot(across, q_f_dot))
        self.nu = neg(dot(q_f_dot, Hv))
        self.slope = vector(shape.slope)


class Moments:
    """First moments (world) and pair integrals (body frame) of a body, in the symbols of the body template."""

    def __init__(self, coordinates: BodyCoordinates, rotate: Rotation, data: ShapeIntegrals) -> None:
        q_f, q_f_dot = coordinates.q_f, coordinates.q_f_dot
        S_Hq, S_Hv = times(data.S_H, q_f), times(data.S_H, q_f_dot)
        along, across = entries(data.Sb) if q_f else ([], [])
        moved = [sub(s, h) for s, h in zip(along, S_Hq, strict=True)]
        S1_x, S1_y = vector(data.S1)
        i1 = vector(data.i1)
        self.mass = data.mass
        self.h = rotate(sub(add(S1_x, dot(along, q_f)), mul(HALF, dot(q_f, S_Hq))), add(S1_y, dot(across, q_f)))
        self.hd = rotate(dot(moved, q_f_dot), dot(across, q_f_dot))
        self.hn = rotate(neg(dot(q_f_dot, S_Hv)), ZERO)
        self.s = [rotate(x, y) for x, y in zip(moved, across, strict=True)]
        # k_a = 1/2 dI/dq_a and I = I0 + q_f . (i1 + k)
        stretched = [sub(m, g) for m, g in zip(times(data.M_ff, q_f), times(data.G_H, q_f), strict=True)]
        self.k = [add(i, change) for i, change in zip(i1, stretched, strict=True)]
        self.inertia = add(data.I0, total(mul(q, add(i, k)) for q, i, k in zip(q_f, i1, self.k, strict=True)))
        self.kd = dot(self.k, q_f_dot)
        self.g = [sub(B, turn) for B, turn in zip(vector(data.B), times(data.G, q_f), strict=True)]
        self.Gd = times(data.G, q_f_dot)
        self.theta_dot = coordinates.theta_dot

    def values(self, mode: int | None) -> dict[sp.Symbol, ca.SX]:
        """Values of the template's symbols; `mode` selects the representative mode a."""
        t = template
        values = {
            t.m: self.mass,
            t.h_x: self.h[0],
            t.h_y: self.h[1],
            t.hd_x: self.hd[0],
            t.hd_y: self.hd[1],
            t.hn_x: self.hn[0],
            t.hn_y: self.hn[1],
            t.I_theta: self.inertia,
            t.kd: self.kd,
            t.theta_dot: self.theta_dot,
        }
        if mode is not None:
            values |= {
                t.k_a: self.k[mode],
                t.g_a: self.g[mode],
                t.Gd_a: self.Gd[mode],
                t.s_x: self.s[mode][0],
                t.s_y: self.s[mode][1],
            }
        return values
