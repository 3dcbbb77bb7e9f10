"""Forward dynamics of a tree of frames in O(N): the articulated-body algorithm, for a generalised force by column.

R. Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, ch. 7.

From the tips to the ground each place carries the articulated inertia I^A of all beyond it and the wrench p^A (the bias
force) that is left of the forces there. A coordinate whose twist is S, with U = I^A S, D = S.U and u = tau - S.p^A,
is eliminated at the last transform on this way that depends on it, and on the way out its acceleration follows from
that of the frame:

    I^A -= U U^T / D,    p^A += U u / D,    x'' = (u - U.a) / D.

1 / D is multiplied by zero where a coordinate is held: it passes on all that is beyond, and its x'' is zero.

Coordinates that several transforms depend on, as modes, have their U carried along until then, and common masses D_ij.
Rates and weight are in the force already, or in wrenches on the frames: nothing here depends on them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, add, div, mul, neg, sub
from symgen.algebra.vectors import zeros
from symgen.system.equations import NoInertia
from symgen.system.frames.joint_transforms import Float, JointNode, JointTransform
from symgen.system.frames.spatial_algebra import (
    NOTHING,
    ArticulatedInertia,
    Force,
    FrameMotion,
    Motion,
    gather,
    no_masses,
)
from symgen.system.frames.tree import GROUND, FrameTree

Place = tuple[int, int]  # frame, and how many of its transforms lie before


def floats(tree: FrameTree) -> bool:
    """Is there a body that no joint places?"""
    return any(isinstance(transform, Float) for frame in tree.frames for transform in frame.transforms)


def free_joint_accelerations(
    tree: FrameTree, force: Row, free: frozenset[int], masks: Row, wrenches: Sequence[Force] | None = None
) -> Row:
    """x'' of M x'' = force by column; free: the columns that accelerate. Only for a tree in which no body floats.

    masks: by column, one where a coordinate moves and zero where it is held. wrenches: what the masses of each frame
    need at rates and weight, and do not get by `force`. Raises NoInertia.
    """
    frames = [replace(frame, transforms=_rotation_last(frame.transforms)) for frame in tree.frames]
    solution = _ArticulatedBodies(FrameTree(frames, tree.body_frames), {c: force.get(c, ZERO) for c in free}, masks)
    solution.inward(wrenches or [NOTHING] * len(frames))
    return solution.outward()


@dataclass(frozen=True)
class _Subtree:
    """I^A and p^A of what is beyond a place, and U by column."""

    I_A: ArticulatedInertia
    p_A: Force = NOTHING
    U: dict[int, Force] = field(default_factory=dict)


@dataclass(frozen=True)
class _Freed:
    """An eliminated coordinate: x'' = U.a + sum D_j x_j'' - u, all over -D.

    hinge: a turn by itself, against whose axis U has a unit moment.
    """

    column: int
    u: ca.SX
    U: Force
    others: Row
    hinge: JointNode | None


class _ArticulatedBodies:
    """One solution of M x'' = tau; columns that are not in tau do not accelerate."""

    def __init__(self, tree: FrameTree, tau: Row, masks: Row) -> None:
        self._tree, self._tau, self._masks, self._u = tree, tau, masks, dict(tau)
        self._D: dict[tuple[int, int], ca.SX] = {}
        self._freed: dict[Place, list[_Freed]] = {}
        self._last: dict[int, Place] = {}
        for k in reversed(range(len(tree.frames))):
            frame = tree.frames[k]
            self._last |= dict.fromkeys(frame.modes, (k, len(frame.transforms)))
            for place in reversed(range(len(frame.transforms))):
                self._last |= dict.fromkeys(frame.transforms[place].twists, (k, place))

    def inward(self, wrenches: Sequence[Force]) -> None:
        """From the tips to the ground."""
        subtrees = [_Subtree(ArticulatedInertia.of(no_masses())) for _ in self._tree.frames]
        for k in reversed(range(len(self._tree.frames))):
            frame, here = self._tree.frames[k], subtrees[k]
            here = replace(here, p_A=here.p_A.plus(wrenches[k]))
            if frame.inertia is not None:
                here = replace(here, I_A=here.I_A.plus(ArticulatedInertia.of(frame.inertia.rigid)))
                for (row, column), value in frame.inertia.own_masses().items():
                    self._add(row, column, value)
                gather(here.U, {c: momentum for c, momentum in frame.inertia.momenta.items() if c in self._tau})
            here = self._eliminate((k, len(frame.transforms)), here, None)
            for place in reversed(range(len(frame.transforms))):
                here = self._through(frame.transforms[place], (k, place), here)
            if frame.parent != GROUND:
                parent = subtrees[frame.parent]
                gather(parent.U, here.U)
                subtrees[frame.parent] = _Subtree(parent.I_A.plus(here.I_A), parent.p_A.plus(here.p_A), parent.U)

    def _through(self, transform: JointTransform, place: Place, here: _Subtree) -> _Subtree:
        """What is beyond a transform, seen before it."""
        S = {column: twist for column, twist in transform.twists.items() if column in self._tau}
        U = {column: here.I_A.momentum(twist) for column, twist in S.items()}
        alone = (
            isinstance(transform, JointNode)
            and transform.turns
            and transform.column in S.keys() - here.U.keys() - self._masks.keys()
        )
        for position, (column, twist) in enumerate(S.items()):
            self._u[column] = sub(self._u[column], here.p_A.along(twist))
            for other, known in here.U.items():
                value = known.along(twist)
                self._add(column, other, add(value, value) if column == other else value)
            for other in list(S)[position:]:
                self._add(column, other, U[column].along(S[other]))
        gather(here.U, U)
        left = self._eliminate(place, here, transform if alone else None)  # type: ignore[arg-type]
        U = {column: transform.wrench(wrench) for column, wrench in left.U.items()}
        return _Subtree(transform.composite(left.I_A), transform.wrench(left.p_A), U)

    def _eliminate(self, place: Place, here: _Subtree, hinge: JointNode | None) -> _Subtree:
        """Without the columns that are met nowhere nearer to the ground. A hinge passes on its own force as a
        moment.
        """
        I_A, p_A = here.I_A, here.p_A
        for column in sorted(column for column in here.U if self._last[column] == place):
            U, u = here.U.pop(column), self._u.pop(column)
            if (column, column) not in self._D:
                raise NoInertia(column)
            # a product with 1 / D is turned into a division where the emitted text is read, one with -1 / D is not
            inverse = mul(self._masks.get(column, ONE), div(neg(ONE), self._D.pop((column, column))))
            masses = {c: self._D.pop(_pair(c, column)) for c in here.U if _pair(c, column) in self._D}
            others = {other: mul(inverse, mass) for other, mass in masses.items()}
            freed = _Freed(column, mul(inverse, u), U.scaled(inverse), others, hinge)
            self._freed.setdefault(place, []).append(freed)
            p_A, I_A = p_A.minus(U.scaled(freed.u)), I_A.less(U, freed.U)
            if hinge is not None:
                p_A.n[hinge.axis] = mul(hinge.sign, self._tau[column])
                I_A = I_A.free_about(hinge.axis)
            for other, factor in others.items():
                self._u[other] = add(self._u[other], mul(factor, u))
                here.U[other] = here.U[other].plus(U.scaled(factor))
                for second in (second for second in masses if second >= other):
                    self._add(other, second, mul(factor, masses[second]))
        return _Subtree(I_A, p_A, here.U)

    def _add(self, i: int, j: int, value: ca.SX) -> None:
        if i in self._tau and j in self._tau and not value.is_zero():
            self._D[_pair(i, j)] = add(self._D.get(_pair(i, j), ZERO), value)

    def outward(self) -> Row:
        """From the ground to the tips: the accelerations by column."""
        motions: list[FrameMotion] = []
        found: Row = {}
        for k, frame in enumerate(self._tree.frames):
            motion = FrameMotion(zeros(), zeros(), zeros()) if frame.parent == GROUND else motions[frame.parent]
            for place, transform in enumerate(frame.transforms):
                self._solve((k, place), transform.motion(motion, {}, {}), found)
                motion = transform.motion(motion, {}, found)
            self._solve((k, len(frame.transforms)), motion, found)
            motions.append(motion)
        return found

    def _solve(self, place: Place, motion: FrameMotion, found: Row) -> None:
        """The columns eliminated at a place; motion: that of the frame without them."""
        for freed in reversed(self._freed.get(place, [])):
            n, turned = list(freed.U.n), ZERO
            if freed.hinge is not None:
                n[freed.hinge.axis], turned = ZERO, mul(freed.hinge.sign, motion.alpha[freed.hinge.axis])
            value = sub(Force(freed.U.f, n).along(Motion(motion.alpha, motion.a)), freed.u)
            for other, factor in freed.others.items():
                value = add(value, mul(factor, found[other]))
            found[freed.column] = sub(value, turned)


def _rotation_last(transforms: Sequence[JointTransform]) -> list[JointTransform]:
    """A constant shift along the axis of a turn before it: a freed turn passes no moment about its axis on to it."""
    found = list(transforms)
    for k in range(1, len(found)):
        turn, slide = found[k - 1], found[k]
        if not (isinstance(turn, JointNode) and isinstance(slide, JointNode) and turn.turns):
            continue
        if not slide.turns and slide.R is None and turn.axis == slide.axis and slide.column is None:
            found[k - 1 : k + 1] = [slide, turn]
    return found


def _pair(i: int, j: int) -> tuple[int, int]:
    return (i, j) if i <= j else (j, i)
