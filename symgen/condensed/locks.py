"""Stiction and closed stops: the condensed equations with the directions of elements that stick locked (38).

Element k is a row G_k of q_i with v_k = G_k q_i' and v_k' = G_k q_i'' + b_k; w_k is one where it sticks, else zero.
With

    Pi = T G,    G T G = G for the rows that stick,    P = 1 - Pi,    a_0 = -T b,

a motion that keeps them is q_i'' = P y + a_0, and both conditions together, P^T (M_hat q_i'' - Q_hat) = 0 and
Pi q_i'' = a_0, are a system of the same form

    (P^T M_hat P + Pi^T D Pi) q_i'' = P^T (Q_hat - M_hat a_0) + Pi^T D a_0,    D = diag M_hat,

positive definite for every set of modes, so that whoever solves M_hat q_i'' = Q_hat solves it. The force of a stuck
element is what is left over, f = T^T (M_hat q_i'' - Q_hat).

Where G is constant and of full rank, as of joints of a tree, T is a right inverse of it in whole numbers where those of
G are, times w: a coordinate of its own is then decoupled by its w alone, without any rounding. Otherwise the rows that
stick are reduced to echelon form, one after the other, each by its largest entry: Pi is the sum of e_j R_k, where row
R_k is one at its own column j and zero at those of others, to the last bit, so that what is held whole gets exactly
a_0. Rows of which nothing is left follow from others, and lock nothing: they hold the same motion once more. The forces
share what is to be held so that the sum of (f / holds)^2 is least: with C = H G E of the own columns E and
H = diag(holds w), f = H C (C^T C)^-1 E^T (M_hat q_i'' - Q_hat). A stop holds like the strongest friction there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ZERO, add, mul, sub, total
from symgen.condensed.condensation import Condensed
from symgen.system.constraint import DerivationError
from symgen.system.equations import Element

FOLLOWS = 1e-9  # of the largest entry of a row: what is left of one that follows from others


@dataclass(frozen=True)
class Locks:
    """The elements of a system by q_i: G rows by column of q, bias (n_e,) b."""

    system: Condensed
    elements: Sequence[Element]
    rows: Sequence[Row]
    bias: Sequence[ca.SX]

    @cached_property
    def G(self) -> ca.SX:
        """(n_e, n_i)."""
        columns = self.system.choice.independent
        return ca.vertcat(*(ca.horzcat(*(row.get(c, ZERO) for c in columns)) for row in self.rows))

    @cached_property
    def stuck(self) -> ca.SX:
        """(n_e,) w."""
        return ca.vertcat(*(one.stuck for one in self.elements))

    @cached_property
    def right_inverse(self) -> np.ndarray | None:
        """(n_i, n_e) numbers with G T = 1; None where G is not constant, or has rows that follow from others."""
        if not self.G.is_constant():
            return None
        G = np.array(ca.DM(self.G))
        pivots = _pivots(G)
        if len(pivots) < len(G):
            return None
        T = np.zeros(G.T.shape)
        T[pivots] = np.linalg.inv(G[:, pivots])
        whole = np.round(T)
        return whole if np.abs(G @ whole - np.eye(len(G))).max() == 0 else T

    @cached_property
    def T(self) -> ca.SX:
        """(n_i, n_e) with f = T^T (M_hat q_i'' - Q_hat), zero in the columns of elements that move."""
        if self.right_inverse is not None:
            return ca.sparsify(ca.SX(ca.DM(self.right_inverse))) @ ca.diag(self.stuck)
        H = ca.diag(self._shares)
        E = ca.horzcat(*self._echelon[0])
        C = H @ self.G @ E
        gram = C.T @ C + ca.diag(1 - ca.sum1(E).T)
        return E @ ca.inv(ca.densify(gram)) @ C.T @ H

    @property
    def _shares(self) -> ca.SX:
        """(n_e,) holds w; of what has no bound, a stop, the largest of them, or 1 where there is none."""
        own = self.stuck * ca.vertcat(*(one.share for one in self.elements))
        largest = ca.mmax(own)
        return self.stuck * ca.if_else(own > 0, own, ca.if_else(largest > 0, largest, 1))

    @cached_property
    def _echelon(self) -> tuple[list[ca.SX], list[ca.SX]]:
        return echelon(self.stuck, self.G, ca.vertcat(*self.bias))

    @cached_property
    def _projection(self) -> tuple[ca.SX, ca.SX]:
        """(Pi (n_i, n_i), a_0 (n_i,))."""
        if self.right_inverse is not None:
            return ca.sparsify(self.T @ ca.sparsify(self.G)), -self.T @ ca.vertcat(*self.bias)
        columns, rows = self._echelon
        Pi = ca.horzcat(*columns) @ ca.vertcat(*(row[:, :-1] for row in rows))
        return Pi, -ca.horzcat(*columns) @ ca.vertcat(*(row[:, -1] for row in rows))

    def locked(self) -> tuple[ca.SX, ca.SX]:
        """M_hat and Q_hat with what sticks locked."""
        M_hat, Q_hat = self.system.M_hat(), self.system.generalised_force({})
        M, D = ca.sparsify(M_hat), ca.diag(ca.diag(M_hat))
        Pi, a = self._projection
        P = ca.SX.eye(M.shape[0]) - Pi
        left = P.T @ M @ P + Pi.T @ D @ Pi
        if all(value.is_zero() for value in self.bias):
            return ca.densify(left), ca.densify(P.T @ Q_hat)
        return ca.densify(left), ca.densify(P.T @ (Q_hat - M @ a) + Pi.T @ D @ a)

    def rates_left(self, change: ca.SX) -> ca.SX:
        """P^T of derivatives of Q_hat - M_hat q_i'' (n_i, any) at fixed q_i''."""
        return ca.densify(change - ca.sparsify(self.G).T @ (self.T.T @ change))

    def forces(self, residual: ca.SX) -> ca.SX:
        """(n_e,) of what sticks, zero of the others; residual (n_i,): Q_hat - M_hat q_i''."""
        return -self.T.T @ residual


def echelon(stuck: ca.SX, G: ca.SX, bias: ca.SX) -> tuple[list[ca.SX], list[ca.SX]]:
    """Of rows that stick: own columns (n_i, 1), one there and zero elsewhere, and the reduced rows (1, n_i + 1) with
    their bias; zero where a row does not stick or follows from others.
    """
    n, columns, rows = G.shape[1], list[ca.SX](), list[ca.SX]()
    for k in range(G.shape[0]):
        given = stuck[k] * ca.horzcat(G[k, :], bias[k])
        left = given
        for own, row in zip(columns, rows, strict=True):
            left = (left - (left[:, :n] @ own) * row) * ca.horzcat(1 - own.T, 1)
        size, whole = (ca.mmax(ca.fabs(one[:, :n])) for one in (left, given))
        open_ = size > FOLLOWS * whole
        entries = list[ca.SX]()
        for j in range(n):  # the first of the largest
            here = open_ * (ca.fabs(left[j]) >= size)
            entries.append(here)
            open_ = open_ * (1 - here)
        own = ca.vertcat(*entries)
        lives = ca.sum1(own)
        row = left / (left[:, :n] @ own + (1 - lives))
        row = lives * (row * ca.horzcat(1 - own.T, 1) + ca.horzcat(own.T, 0))
        rows = [(one - (one[:, :n] @ own) * row) * ca.horzcat(1 - own.T, 1) for one in rows] + [row]
        columns.append(own)
    return columns, rows


def locks(system: Condensed) -> Locks:
    """Of a system with elements. Raises DerivationError for a stop on a way that is prescribed."""
    elements, still = system.reduced.elements, system.accelerations({})
    rows = [system.projected(one.row) for one in elements]
    for one, row in zip(elements, rows, strict=True):
        if one.stops and all(row.get(c, ZERO).is_zero() for c in system.choice.independent):
            remedy = "leave the limits out, or let the joint move by forces"
            raise DerivationError(
                f"{one.joint}.limits", "are along a prescribed motion, which no stop can hold", remedy
            )
    bias = [
        sub(total(mul(value, still[c]) for c, value in one.row.items() if c in still), one.gamma) for one in elements
    ]
    return Locks(system, elements, rows, [add(b, ZERO) for b in bias])


def add_held_forces(system: Condensed, force: Row, held: ca.SX | None = None) -> None:
    """The forces that hold elements join the force Q* - M q'' that is left in all coordinates, by column.

    held (n_e,): these forces; None: of the elements that stick, what the accelerations leave for them.
    """
    own = locks(system)
    forces = own.forces(_residual(system, force)) if held is None else held
    for k, element in enumerate(own.elements):
        add_scaled(force, forces[k], element.row)


def _residual(system: Condensed, force: Row) -> ca.SX:
    """(n_i,) Q_hat - M_hat q_i'' of the force Q* - M q'' in all coordinates, by column."""
    work = dict(force)
    for one in reversed(system.substitutions):
        value = work.pop(one.column, ZERO)
        if not value.is_zero():
            add_scaled(work, value, one.e)
    return ca.densify(ca.vertcat(*(work.get(c, ZERO) for c in system.choice.independent)))


def _pivots(G: np.ndarray) -> list[int]:
    """Columns in which the rows are independent, of each row the last that is."""
    left, found = G.copy(), list[int]()
    for k in range(len(left)):
        places = np.flatnonzero(np.abs(left[k]) > 1e-9)
        if not len(places):
            return found
        column = int(places[-1])
        found.append(column)
        for other in range(len(left)):
            if other != k:
                left[other] -= left[k] * (left[other, column] / left[k, column])
    return found
