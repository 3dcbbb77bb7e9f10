"""Inertia of bodies whose joints are free: f = A a + H^T alpha, n = H a + J alpha with A and J symmetric."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.scalar import ZERO, add, mul, neg
from symgen.algebra.vectors import Vector, cross, plus, product, times, zeros
from symgen.system.frames.motion import Composite, Matrix, Twist, Wrench, both_turned_back, symmetric_of


@dataclass(frozen=True)
class Articulated:
    """Inertia of what is beyond a frame, its joints free: blocks A (a to f), H (a to n) and J (alpha to n)."""

    A: Matrix
    H: Matrix
    J: Matrix

    @staticmethod
    def of(body: Composite) -> Articulated:
        """Of a body without free joints."""
        (x, y, z), S = body.h, body.Sigma
        A = [[body.m if i == j else ZERO for j in range(3)] for i in range(3)]
        H = [[ZERO, neg(z), y], [z, ZERO, neg(x)], [neg(y), x, ZERO]]
        J = [
            [
                add(S[(i + 1) % 3][(i + 1) % 3], S[(i + 2) % 3][(i + 2) % 3]) if i == j else neg(S[i][j])
                for j in range(3)
            ]
            for i in range(3)
        ]
        return Articulated(symmetric_of(A), H, symmetric_of(J))

    def plus(self, other: Articulated) -> Articulated:
        """Of both, about the same origin."""
        A, H, J = (_sum(mine, own) for mine, own in zip(self._blocks, other._blocks, strict=True))
        return Articulated(symmetric_of(A), H, symmetric_of(J))

    @property
    def _blocks(self) -> tuple[Matrix, Matrix, Matrix]:
        return self.A, self.H, self.J

    def turned(self, R: Matrix) -> Articulated:
        """In axes in which those of the frame are the columns of R."""
        back = _transposed(R)
        A, H, J = (product(product(R, block), back) for block in self._blocks)
        return Articulated(symmetric_of(A), H, symmetric_of(J))

    def turned_mass(self, R: Callable[[], Matrix]) -> Articulated:
        """What a freed ball leaves: no moment, whatever the motion. In axes as in `turned`."""
        axes = R()
        A = symmetric_of(product(product(axes, self.A), _transposed(axes)))
        return Articulated(A, [zeros() for _ in range(3)], [zeros() for _ in range(3)])

    def about(self, axis: int, cosine: ca.SX, sine: ca.SX) -> Articulated:
        """In axes from which the frame's are turned about one of them."""
        A, J = (both_turned_back(block, axis, cosine, sine) for block in (self.A, self.J))
        return Articulated(A, both_turned_back(self.H, axis, cosine, sine, symmetric=False), J)

    def shifted(self, arm: Vector) -> Articulated:
        """About the point from which the origin is at `arm`: n gains arm x f, a loses arm x alpha."""
        H = _sum(self.H, _columns(lambda column: cross(arm, column), self.A))
        # n = ... + (J + arm~ H^T - (H + arm~ A) arm~) alpha
        left = _columns(lambda column: cross(arm, column), _transposed(self.H))
        right = _transposed(_columns(lambda column: cross(arm, column), _transposed(H)))
        J = [[add(add(self.J[i][j], left[i][j]), right[i][j]) if i <= j else ZERO for j in range(3)] for i in range(3)]
        return Articulated(self.A, H, symmetric_of(J))

    def momentum(self, twist: Twist) -> Wrench:
        """Wrench for an acceleration."""
        f = plus(times(self.A, twist.v), times(_transposed(self.H), twist.omega))
        return Wrench(f, plus(times(self.H, twist.v), times(self.J, twist.omega)))

    def less(self, wrench: Wrench, over: Wrench) -> Articulated:
        """With a coordinate freed whose unit acceleration takes this wrench; over: by its own force against that."""
        A, H, J = _more(self.A, wrench.f, over.f), _more(self.H, wrench.n, over.f), _more(self.J, wrench.n, over.n)
        return Articulated(symmetric_of(A), H, symmetric_of(J))

    def free_about(self, axis: int) -> Articulated:
        """Without what a freed hinge about an axis leaves at zero: no moment about it, whatever the motion."""
        clear = [k == axis for k in range(3)]
        H = [zeros() if clear[i] else list(row) for i, row in enumerate(self.H)]
        J = [[ZERO if clear[i] or clear[j] else value for j, value in enumerate(row)] for i, row in enumerate(self.J)]
        return Articulated(self.A, H, symmetric_of(J))


def _transposed(block: Matrix) -> Matrix:
    return [list(column) for column in zip(*block, strict=True)]


def _sum(a: Matrix, b: Matrix) -> Matrix:
    return [plus(x, y) for x, y in zip(a, b, strict=True)]


def _columns(apply: Callable[[Vector], Vector], block: Matrix) -> Matrix:
    return _transposed([apply(column) for column in _transposed(block)])


def _more(block: Matrix, left: Vector, right: Vector) -> Matrix:
    return [[add(block[i][j], mul(left[i], right[j])) for j in range(3)] for i in range(3)]
