"""Derivatives of one stage of a step program, and of an iteration at what it has converged to.

Of a stage z' = S(z, c), with dots along a direction and bars for the derivative of a number by what stands below:

    tangent   dz' = S_z dz + S_c dc
    adjoint   zbar = S_z^T zbar',   cbar = cbar' + S_c^T cbar'

An iteration x <- G(x, r, c) on the entries x that its body changes is differentiated by the implicit-function theorem
at its end, however it got there: (1 - G_x) dx = G_r dr + G_c dc, and for the adjoint (1 - G_x)^T l = xbar',
rbar = rbar' + G_r^T l, cbar = cbar' + G_c^T l, xbar = 0.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from runtime.contract.tape import read_tape, shared
from runtime.engine.program import Call, Program, Repeat


@dataclass(frozen=True)
class Active:
    """Entries of z (z_size) and c (c_size) by which is differentiated, ascending: all others count as fixed."""

    z: tuple[int, ...]
    c: tuple[int, ...]
    z_size: int
    c_size: int

    @property
    def size(self) -> int:
        """Entries of a tangent [dz, dc], or of an adjoint state [zbar, cbar]."""
        return len(self.z) + len(self.c)

    def spread(self, dz: ca.SX, dc: ca.SX) -> ca.SX:
        """(z_size + c_size,) with structural zeros in what is fixed."""
        whole = ca.SX(self.z_size + self.c_size, 1)
        whole[list(self.z)] = dz
        whole[[self.z_size + k for k in self.c]] = dc
        return whole


@dataclass(frozen=True)
class AdjointStage:
    """function: ([zbar, cbar], c, saved) -> [zbar, cbar] before the stage; saved: the entries of z that it reads.

    They are those before the stage, of an iteration those after it.
    """

    function: ca.Function
    saved: tuple[int, ...]


class StageDerivatives:
    """The derivatives of a stage by what is active; iterated: the stage is the body of an iteration."""

    def __init__(self, stage: ca.Function, active: Active, iterated: bool = False) -> None:
        self.name, self.active = stage.name(), active
        self.z, self.c = ca.SX.sym("z", active.z_size), ca.SX.sym("c", active.c_size)
        self.by = ca.vertcat(self.z, self.c)
        self.next = stage(self.z, self.c)
        rows = list(active.z)
        self.moving = self.next[rows]
        self.iterated = [n for n, k in enumerate(rows) if not _passed_on(self.next, k, self.z)] if iterated else []

    def tangent(self) -> ca.Function:
        """([z, dz], [c, dc]) -> [z', dz']; of an iteration [z, dz'], for it has been made before."""
        dz, dc = ca.SX.sym("dz", len(self.active.z)), ca.SX.sym("dc", len(self.active.c))
        if not self.iterated:
            after, following = self._along(self.moving, dz, dc), self.next
        else:
            kept, after = ca.SX(dz), ca.SX(dz)
            kept[self.iterated] = 0
            pushed = self._along(self.moving[self.iterated], ca.sparsify(kept), dc)
            after[self.iterated] = ca.solve(self._of_iteration(), pushed)
            following = self.z
        return _function(
            f"{self.name}_tangent",
            [ca.vertcat(self.z, dz), ca.vertcat(self.c, dc)],
            ca.vertcat(following, after),
            ["z", "c"],
        )

    def adjoint(self) -> AdjointStage:
        """See AdjointStage."""
        zbar, cbar = ca.SX.sym("zbar", len(self.active.z)), ca.SX.sym("cbar", len(self.active.c))
        if not self.iterated:
            pulled = ca.jtimes(self.moving, self.by, zbar, True)
        else:
            multipliers = ca.solve(self._of_iteration().T, zbar[self.iterated])
            pulled = ca.jtimes(self.moving[self.iterated], self.by, multipliers, True)
            through = ca.SX(zbar)
            through[self.iterated] = 0
            columns = [self.active.z[n] for n in self.iterated]
            pulled[columns] = 0
            pulled += self.active.spread(through, ca.SX.zeros(len(self.active.c)))
        before = ca.vertcat(pulled[list(self.active.z)], cbar + pulled[[self.active.z_size + k for k in self.active.c]])
        before = shared([ca.densify(before)])[0]
        read = {symbol.name() for symbol in ca.symvar(before)}
        entries = ca.vertsplit(self.z) if self.active.z_size else []
        saved = tuple(k for k, entry in enumerate(entries) if entry.name() in read)
        seen = ca.vertcat(*(entries[k] for k in saved)) if saved else ca.SX(0, 1)
        inputs = [ca.vertcat(zbar, cbar), self.c, seen]
        return AdjointStage(_function(f"{self.name}_adjoint", inputs, before, ["z", "c", "s"]), saved)

    def _along(self, rows: ca.SX, dz: ca.SX, dc: ca.SX) -> ca.SX:
        return ca.jtimes(rows, self.by, self.active.spread(dz, dc))

    def _of_iteration(self) -> ca.SX:
        """1 - G_x."""
        x = ca.vertcat(*(self.z[self.active.z[n]] for n in self.iterated))
        return ca.SX.eye(len(self.iterated)) - ca.jacobian(self.moving[self.iterated], x)


def body_of(program: Program) -> ca.Function:
    """The stages of a part of a program as one Function (z, c) -> z. Raises TypeError for an iteration inside it."""
    if isinstance(program, Call):
        return program.stage
    parts = [program.body] * program.count if isinstance(program, Repeat) else list(getattr(program, "parts", ()))
    if not parts:
        raise TypeError("an iteration inside an iteration has no derivative here")
    bodies = [body_of(part) for part in parts]
    z, c = ca.SX.sym("z", bodies[0].size1_in(0)), ca.SX.sym("c", bodies[0].size1_in(1))
    following = z
    for body in bodies:
        following = body(following, c)
    return ca.Function(bodies[0].name(), [z, c], [following], ["z", "c"], ["z_next"])


def _passed_on(following: ca.SX, k: int, z: ca.SX) -> bool:
    """Is an entry what it was?"""
    return bool(ca.is_equal(following[k], z[k], 0))


def _function(name: str, inputs: list[ca.SX], output: ca.SX, names: list[str]) -> ca.Function:
    function = ca.Function(name, inputs, shared([ca.densify(output)]), names, ["z_next"])
    read_tape(function)  # raises where an operation has none
    return function
