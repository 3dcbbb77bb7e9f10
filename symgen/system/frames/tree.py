"""The tree of frames of a spatial mechanism: data for the recursions.

Inertia of a flexible body in body axes: how its masses move with omega, alpha, a and the modes (Eq. 20).

With L_a = int rho phi_a^T dm, D_a = sym(L_a) and B_a = ax(L_a) (index a: one mode; ' : rates of q_f):

    force      f = m a + G h + 2 omega x h' + nu_h + sum_a s_a q_a''
    moment     n = h x a + ax(J G^T) + 2 (tr(L') - L'^T) omega + sum_a B_a q_a''
    on mode a  s_a.a + B_a.alpha + omega~^2 : D_a + 2 omega . sum_b ax(P_ba) q_b' + sum_b M_ab q_b''

where J = int rho rho^T dm and L' = sum_a L_a q_a'.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, add, dot, mul, sub
from symgen.algebra.vectors import Matrix, Vector, combination, cross, plus, scaled, traced, weighted
from symgen.bodies.spatial_moments import SpatialIntegrals, SpatialMoments
from symgen.system.frames.joint_transforms import JointTransform, Node
from symgen.system.frames.spatial_algebra import SE3, Force, FrameMotion, Inertia


@dataclass(frozen=True)
class FlexibleNode:
    """A flexible body: its integrals, and values and columns of its modal coordinates q_f."""

    data: SpatialIntegrals
    q_f: Vector
    columns: list[int]

    @cached_property
    def _still(self) -> SpatialMoments:
        return self.moments({})

    def own(self, values: Row) -> Vector:
        """The modes' part of a vector by column."""
        return [values.get(column, ZERO) for column in self.columns]

    def moments(self, rates: Row) -> SpatialMoments:
        """With rates by column, zero where absent."""
        return SpatialMoments(self.data, self.q_f, self.own(rates))

    @cached_property
    def rigid(self) -> Inertia:
        """The body as it is deformed."""
        return Inertia(self.data.mass, self._still.h, self._still.J)

    @cached_property
    def momenta(self) -> dict[int, Force]:
        """s_a and B_a: momentum of the body for a unit rate of each mode, by column."""
        return {column: Force(self._still.s[a], self._still.B[a]) for a, column in enumerate(self.columns)}

    def own_masses(self) -> dict[tuple[int, int], ca.SX]:
        """Upper triangle of M_ff by columns."""
        return {
            (row, column): self.data.M_ff[a][a + b]
            for a, row in enumerate(self.columns)
            for b, column in enumerate(self.columns[a:])
        }

    @cached_property
    def doubled(self) -> list[Matrix]:
        """E_a = L_a + L_a^T = 2 D_a."""
        return [[[add(L[i][j], L[j][i]) for j in range(3)] for i in range(3)] for L in self._still.L]

    def inertia_force(self, motion: FrameMotion, rates: Row, accelerations: Row) -> tuple[Force, Row]:
        """(wrench that moves the masses, generalised force on the modes by column)."""
        moments, momenta = self.moments(rates), self.momenta
        speeds, own = self.own(rates), self.own(accelerations)
        wrench = self.rigid.inertia_wrench(motion)
        twice = scaled(ca.SX(2), motion.omega)
        f = plus(wrench.f, cross(twice, moments.hd), moments.hn, combination(moments.s, own))
        n = plus(wrench.n, traced(weighted(moments.L, speeds), twice, False), combination(moments.B, own))
        modes = {}
        for a, column in enumerate(self.columns):
            value = add(dot(momenta[column].f, motion.a), dot(momenta[column].n, motion.alpha))
            value = add(value, self._centrifugal(a, motion.omega))
            value = add(value, dot(twice, moments.Gd[a]))
            modes[column] = add(value, dot(self.data.M_ff[a], own))
        return Force(f, n), modes

    def _centrifugal(self, a: int, omega: Vector) -> ca.SX:
        """omega~^2 : D_a = omega.(D_a omega) - (omega.omega) tr(D_a)."""
        L, E = self._still.L[a], self.doubled[a]
        result = ZERO
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            result = add(result, mul(mul(omega[i], omega[j]), E[i][j]))
            square = add(mul(omega[j], omega[j]), mul(omega[k], omega[k]))
            result = sub(result, mul(square, L[i][i]))
        return result


@dataclass(frozen=True)
class RigidNode:
    """A rigid body, or nothing, at a frame."""

    rigid: Inertia

    @property
    def momenta(self) -> dict[int, Force]:
        """No modes."""
        return {}

    def own_masses(self) -> dict[tuple[int, int], ca.SX]:
        """No modes."""
        return {}

    def inertia_force(self, motion: FrameMotion, rates: Row, accelerations: Row) -> tuple[Force, Row]:
        """(wrench that moves the masses, nothing on modes)."""
        return self.rigid.inertia_wrench(motion), {}


GROUND = -1


@dataclass
class Frame:
    """A frame: its parent (GROUND or an earlier one), the transforms from there, the inertia that goes with it."""

    parent: int
    transforms: list[JointTransform]
    inertia: RigidNode | FlexibleNode | None

    @property
    def nodes(self) -> list[Node]:
        """Its transforms, where all of them are nodes."""
        return [transform for transform in self.transforms if isinstance(transform, Node)]

    @property
    def modes(self) -> set[int]:
        """Columns of the modes of its body."""
        return set() if self.inertia is None else set(self.inertia.momenta)

    @property
    def columns(self) -> set[int]:
        """Columns on which its motion or its inertia depend."""
        return {column for transform in self.transforms for column in transform.twists} | self.modes


@dataclass(frozen=True)
class BodyFrame:
    """Where a body's own frame is: in which frame of the tree, and where in that."""

    frame: int = GROUND
    place: SE3 = field(default_factory=SE3.identity)


@dataclass(frozen=True)
class FrameTree:
    """Frames, parents first, and where the frame of each body is, by name (the ground too)."""

    frames: list[Frame]
    body_frames: dict[str, BodyFrame]

    def path_to(self, frame: int) -> list[int]:
        """The frames from the ground to one, itself included."""
        found: list[int] = []
        while frame != GROUND:
            found.append(frame)
            frame = self.frames[frame].parent
        return found[::-1]

    def common(self, a: str, b: str) -> int:
        """The last frame that the ways to two bodies have in common."""
        shared = [
            first
            for first, second in zip(
                self.path_to(self.body_frames[a].frame), self.path_to(self.body_frames[b].frame), strict=False
            )
            if first == second
        ]
        return shared[-1] if shared else GROUND

    @property
    def flexible(self) -> bool:
        """Has a body modes?"""
        return any(frame.modes for frame in self.frames)
