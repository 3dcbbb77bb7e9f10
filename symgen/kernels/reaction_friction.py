"""Friction by the joint's own reaction: forces mu r R of which R, the size of the reaction, depends on them in turn.

With forces c_k R_k on the elements that slide, accelerations and reactions F_k (components by axes) are linear in R:

    M_hat q_i'' = Q_0 + Q_R R,    F = F_0 + F_a q_i'' + F_R R = m + N R,    R_k = |F_k|.

The right-hand side is a contraction where the sum over j of |N_kj| is below one; beyond 1/2 it is refused: near one
there may be two accelerations or none (Painleve). It is solved by four steps of Newton's method from R = |m| on, all
with one factorisation of M_hat; four plain turns would leave 1/32 of an error at the bound.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial

import casadi as ca

from symgen.condensed.locks import Locks
from symgen.kernels.all_coordinates import reactions
from symgen.kernels.kernel import Kernel
from symgen.system.constraint import DerivationError
from symgen.system.equations import Element

FRICTION_ITERATIONS = 4
FRICTION_CONTRACTION = 0.5
NONE = 1e-300  # N^2: so that what is zero has a slope


@dataclass(frozen=True)
class Grips:
    """Of the locked elements whose friction has a reaction R, a symbol of each."""

    locks: Locks

    @cached_property
    def own(self) -> list[Element]:
        """In the order of the elements."""
        return [one for one in self.locks.elements if one.friction is not None and one.friction.reaction is not None]

    @cached_property
    def R(self) -> ca.SX:
        """(n_r,) the symbols."""
        return _symbols(self.locks.elements)

    @cached_property
    def R_outside(self) -> ca.SX:
        """(n_r,) the same in the equations of all coordinates, which in space have symbols of their own."""
        return _symbols(self.locks.system.equations.elements)

    @cached_property
    def F(self) -> tuple[ca.SX, ca.SX, ca.SX]:
        """(F_0, F_a, F_R): components of each joint's force one below the other, with what sticks held by what the
        accelerations leave for it.
        """
        F_0, F_a, F_R, _ = self._forces(None)
        return F_0, F_a, F_R

    @cached_property
    def F_given(self) -> tuple[ca.SX, ca.SX, ca.SX, ca.SX]:
        """(F_0, F_a, F_R, F_f): the same where the forces f (n_e,) on the elements are given: how elements that hold
        one motion share a force is seen by the joints between them.
        """
        return self._forces(ca.SX.sym("f", len(self.locks.elements)))

    def _forces(self, held: ca.SX | None) -> tuple[ca.SX, ca.SX, ca.SX, ca.SX]:
        """See `F` and `F_given`. Raises DerivationError."""
        system, a = self.locks.system, ca.SX.sym("a", len(self.locks.system.choice.independent))
        if system.choice.redundant:
            joint = self.own[0].joint
            remedy = "give coulomb in place of mu, or free the joints that hold the same twice"
            raise DerivationError(
                f"{joint}.friction.mu", "needs a reaction, and redundant joints leave it open", remedy
            )
        kernel, joints = reactions(system, held), system.equations.joints
        outside = ca.vertcat(kernel.inputs["q_ddot"], self.R_outside)
        found = system.accelerations(dict(zip(system.choice.independent, ca.vertsplit(a), strict=True)))
        q_ddot = ca.vertcat(*(found.get(c, ca.SX(0)) for c in range(len(system.equations.names))))
        forces = ca.substitute(kernel.outputs["joint_forces"], outside, ca.vertcat(q_ddot, self.R))
        size = 2 if forces.shape[0] == 3 else 3
        F = ca.densify(ca.vertcat(*(forces[:size, joints.index(one.joint)] for one in self.own)))
        f = ca.SX(0, 1) if held is None else held
        none = ca.vertcat(a, self.R, f)
        F_0 = ca.substitute(F, none, ca.SX.zeros(none.shape))
        return F_0, ca.jacobian(F, a), ca.jacobian(F, self.R), ca.jacobian(F, f)

    @cached_property
    def _affine(self) -> tuple[ca.SX, ca.SX]:
        """(m, N), with what sticks locked."""
        M_hat, Q_hat = self.locks.locked()
        Q_0, Q_R = self.split(Q_hat)
        F_0, F_a, F_R = self.F
        D, L, p = ca.ldl(ca.sparsify(M_hat))
        by = ca.ldl_solve(ca.horzcat(Q_0, Q_R), D, L, p)
        return F_0 + F_a @ by[:, 0], F_R + F_a @ by[:, 1:]

    def split(self, Q: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Q = Q_0 + Q_R R."""
        return ca.substitute(Q, self.R, ca.SX.zeros(self.R.shape)), ca.densify(ca.jacobian(Q, self.R))

    def _sizes(self, forces: ca.SX) -> tuple[ca.SX, ca.SX]:
        """|F_k| (n_r,), and of each its unit vector in its rows (n_r, d n_r)."""
        parts = ca.vertsplit(forces, forces.numel() // len(self.own))
        sizes = [ca.sqrt(ca.dot(part, part) + NONE) for part in parts]
        return ca.vertcat(*sizes), ca.diagcat(*((part / size).T for part, size in zip(parts, sizes, strict=True)))

    @cached_property
    def values(self) -> ca.SX:
        """(n_r,) R of a state."""
        m, N = self._affine
        R = self._sizes(m)[0]
        for _ in range(FRICTION_ITERATIONS):
            sizes, along = self._sizes(m + N @ R)
            R = R + ca.solve(ca.SX.eye(R.numel()) - along @ N, sizes - R)
        return self._sizes(m + N @ R)[0]

    @cached_property
    def margins(self) -> ca.SX:
        """(n_r,) how far each is from the bound of the contraction."""
        N, n = self._affine[1], len(self.own)
        columns = [self._sizes(N[:, k])[0] for k in range(n)]
        return FRICTION_CONTRACTION - sum(columns, ca.SX.zeros(n, 1))

    def known(self, values: list[ca.SX]) -> list[ca.SX]:
        """With R of the state in place of its symbols."""
        return list(ca.substitute(list(ca.substitute(values, [self.R_outside], [self.R])), [self.R], [self.values]))

    def in_kernels(self, builders: Mapping[str, Callable[[], Kernel]]) -> dict[str, Callable[[], Kernel]]:
        """The same builders, whose kernels know R."""
        return {name: partial(self._kernel, build) for name, build in builders.items()}

    def _kernel(self, build: Callable[[], Kernel]) -> Kernel:
        kernel = build()
        outputs = self.known(list(kernel.outputs.values()))
        others = tuple(self._kernel(lambda one=one: one) for one in kernel.others)  # type: ignore[misc]
        return replace(kernel, outputs=dict(zip(kernel.outputs, outputs, strict=True)), others=others)


def _symbols(elements: Sequence[Element]) -> ca.SX:
    frictions = [one.friction for one in elements if one.friction is not None]
    return ca.vertcat(*(one.reaction for one in frictions if one.reaction is not None))
