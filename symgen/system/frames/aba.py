"""Accelerations of a tree of frames in O(N): the articulated-body recursion, for a generalised force given by column.

From the tips to the ground each frame carries the inertia of all beyond it with its joints free, and the wrench that is
left of the forces there. A coordinate is eliminated at the last move on this way that depends on it; on the way out its
acceleration follows from that of the frame. Rates and weight are in the force already, or in wrenches on the frames,
which go to the ground with what is left of the forces: nothing here depends on them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, add, div, mul, neg, sub
from symgen.algebra.vectors import minus, scaled, zeros
from symgen.system.frames.moves import Float, JointNode, Move
from symgen.system.frames.spatial_algebra import NOTHING, ArticulatedInertia, Force, FrameMotion, Motion, no_masses
from symgen.system.frames.tree import GROUND, FrameTree

Place = tuple[int, int]  # frame, and how many of its moves lie before


def floats(tree: FrameTree) -> bool:
    """Is there a body that no joint places?"""
    return any(isinstance(move, Float) for frame in tree.frames for move in frame.moves)


def free_joint_accelerations(
    tree: FrameTree, force: Row, free: frozenset[int], wrenches: Sequence[Force] | None = None
) -> Row:
    """x'' of M x'' = force by column; free: the columns that accelerate. Only for a tree in which no body floats.

    wrenches: what the masses of each frame need at rates and weight, and do not get by `force`.
    """
    return _FreeJoints(tree, force, free, wrenches or [NOTHING] * len(tree.frames)).accelerations


@dataclass(frozen=True)
class _Hinge:
    """A turn by itself: its axis and sign, and the force on it, which is all of the moment that it passes on."""

    axis: int
    sign: ca.SX
    force: ca.SX


@dataclass(frozen=True)
class _Freed:
    """An eliminated coordinate: x'' = wrench . motion + sum others x_j'' - share, all over its negative own mass.

    hinge: where there is one, the wrench has a unit moment against its axis.
    """

    column: int
    share: ca.SX
    wrench: Force
    others: Row
    hinge: _Hinge | None


@dataclass
class _State:
    """What is beyond a place: inertia, and by column momenta, masses and forces; the wrench that is left."""

    inertia: ArticulatedInertia
    momenta: dict[int, Force]
    wrench: Force


class _FreeJoints:
    """One solution of M x'' = force for a tree without bodies that float; `accelerations` is the result.

    free: the columns to solve for; the others do not accelerate here.
    """

    def __init__(self, tree: FrameTree, force: Row, free: frozenset[int], wrenches: Sequence[Force]) -> None:
        frames = [replace(frame, moves=_turning_last(frame.moves)) for frame in tree.frames]
        self._tree, self._free, self._wrenches = FrameTree(frames, tree.seats), free, wrenches
        self._force = {column: force.get(column, ZERO) for column in free}
        self._mass: dict[tuple[int, int], ca.SX] = {}
        self._freed: dict[Place, list[_Freed]] = {}
        self._last = self._last_places()
        self._inward()
        self.accelerations: Row = {}
        self._outward()

    def _last_places(self) -> dict[int, Place]:
        """Where each column is met last on the way to the ground."""
        last: dict[int, Place] = {}
        for k in reversed(range(len(self._tree.frames))):
            frame = self._tree.frames[k]
            for column in [] if frame.inertia is None else frame.inertia.momenta:
                last[column] = (k, len(frame.moves))
            for place in reversed(range(len(frame.moves))):
                for column in frame.moves[place].twists:
                    last[column] = (k, place)
        return last

    # ---- from the tips to the ground -------------------------------------------------------------------------

    def _inward(self) -> None:
        states = [_State(ArticulatedInertia.of(no_masses()), {}, NOTHING) for _ in self._tree.frames]
        for k in reversed(range(len(self._tree.frames))):
            frame, state = self._tree.frames[k], states[k]
            state.wrench = state.wrench.plus(self._wrenches[k])
            if frame.inertia is not None:
                state.inertia = state.inertia.plus(ArticulatedInertia.of(frame.inertia.rigid))
                for (row, column), value in frame.inertia.own_masses().items():
                    self._add(row, column, value)
                for column, wrench in frame.inertia.momenta.items():
                    if column in self._free:
                        _gather(state.momenta, column, wrench)
            self._eliminate((k, len(frame.moves)), state, None)
            for place in reversed(range(len(frame.moves))):
                self._through(frame.moves[place], (k, place), state)
            if frame.parent != GROUND:
                into = states[frame.parent]
                into.inertia = into.inertia.plus(state.inertia)
                into.wrench = into.wrench.plus(state.wrench)
                for column, wrench in state.momenta.items():
                    _gather(into.momenta, column, wrench)

    def _through(self, move: Move, place: Place, state: _State) -> None:
        twists = {column: twist for column, twist in move.twists.items() if column in self._free}
        own = {column: state.inertia.momentum(twist) for column, twist in twists.items()}
        known, hinge = dict(state.momenta), None
        if isinstance(move, JointNode) and move.turns and move.column in twists and move.column not in known:
            hinge = _Hinge(move.axis, move.sign, self._force[move.column])
        for column, twist in twists.items():
            self._force[column] = sub(self._force[column], state.wrench.along(twist))
            for other, wrench in known.items():
                value = wrench.along(twist)
                self._add(column, other, add(value, value) if column == other else value)
        for position, column in enumerate(twists):
            for other in list(twists)[position:]:
                self._add(column, other, own[column].along(twists[other]))
        for column, wrench in own.items():
            _gather(state.momenta, column, wrench)
        self._eliminate(place, state, hinge)
        state.inertia = move.composite(state.inertia)  # type: ignore[arg-type, assignment]
        state.wrench = move.wrench(state.wrench)
        state.momenta = {column: move.wrench(wrench) for column, wrench in state.momenta.items()}

    def _eliminate(self, place: Place, state: _State, hinge: _Hinge | None) -> None:
        """The columns that are met nowhere nearer to the ground. hinge: a turn by itself."""
        for column in sorted(state.momenta):
            if self._last[column] != place:
                continue
            wrench, force = state.momenta.pop(column), self._force.pop(column)
            # a product with 1 / m is turned into a division where the emitted text is read, one with -1 / m is not
            inverse = div(neg(ONE), self._mass.pop((column, column)))
            over, share = Force(scaled(inverse, wrench.f), scaled(inverse, wrench.n)), mul(inverse, force)
            masses = {c: self._mass.pop(_pair(c, column)) for c in state.momenta if _pair(c, column) in self._mass}
            relative = {other: mul(inverse, mass) for other, mass in masses.items()}
            self._freed.setdefault(place, []).append(_Freed(column, share, over, relative, hinge))
            f, n = state.wrench.f, state.wrench.n
            state.wrench = Force(minus(f, scaled(share, wrench.f)), minus(n, scaled(share, wrench.n)))
            state.inertia = state.inertia.less(wrench, over)
            if hinge is not None:
                state.wrench.n[hinge.axis] = mul(hinge.sign, hinge.force)
                state.inertia = state.inertia.free_about(hinge.axis)
            for other, factor in relative.items():
                self._force[other] = add(self._force[other], mul(factor, force))
                mine = state.momenta[other]
                state.momenta[other] = mine.plus(Force(scaled(factor, wrench.f), scaled(factor, wrench.n)))
                for second, mass in masses.items():
                    if second >= other:
                        self._add(other, second, mul(factor, mass))

    def _add(self, i: int, j: int, value: ca.SX) -> None:
        if i in self._free and j in self._free and not value.is_zero():
            self._mass[_pair(i, j)] = add(self._mass.get(_pair(i, j), ZERO), value)

    # ---- and back out ----------------------------------------------------------------------------------------

    def _outward(self) -> None:
        motions: list[FrameMotion] = []
        for k, frame in enumerate(self._tree.frames):
            motion = FrameMotion(zeros(), zeros(), zeros()) if frame.parent == GROUND else motions[frame.parent]
            for place, move in enumerate(frame.moves):
                before = move.motion(motion, {}, {})
                self._solve((k, place), before)
                motion = move.motion(motion, {}, self.accelerations)
            self._solve((k, len(frame.moves)), motion)
            motions.append(motion)

    def _solve(self, place: Place, motion: FrameMotion) -> None:
        """The columns eliminated at a place; motion: that of the frame without them."""
        for freed in reversed(self._freed.get(place, [])):
            n, turned = list(freed.wrench.n), ZERO
            if freed.hinge is not None:
                axis = freed.hinge.axis
                n[axis], turned = ZERO, mul(freed.hinge.sign, motion.alpha[axis])
            value = sub(Force(freed.wrench.f, n).along(Motion(motion.alpha, motion.a)), freed.share)
            for other, factor in freed.others.items():
                value = add(value, mul(factor, self.accelerations[other]))
            self.accelerations[freed.column] = sub(value, turned)


def _turning_last(moves: Sequence[Move]) -> list[Move]:
    """A constant shift along the axis of a turn before it: a freed turn passes no moment about its axis on to it."""
    found = list(moves)
    for k in range(1, len(found)):
        turn, slide = found[k - 1], found[k]
        if not (isinstance(turn, JointNode) and isinstance(slide, JointNode) and turn.turns):
            continue
        along = not slide.turns and slide.R is None and turn.axis == slide.axis
        if along and slide.column is None:
            found[k - 1 : k + 1] = [slide, turn]
    return found


def _pair(i: int, j: int) -> tuple[int, int]:
    return (i, j) if i <= j else (j, i)


def _gather(momenta: dict[int, Force], column: int, wrench: Force) -> None:
    momenta[column] = momenta[column].plus(wrench) if column in momenta else wrench
