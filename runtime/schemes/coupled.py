"""Coupled sub-steps: the whole condensed system is solved in each, with the slow coordinates held.

The solution eliminates q_L: (M_SS - M_SL M_LL^-1 M_LS) a_S = Q_S - M_SL M_LL^-1 Q_L, a_L = M_LL^-1 (Q_L - M_LS a_S);
on large trees the elimination is that of the tree, in O(N).

Where the fast coordinates are in branches of a large tree and their rates act on nothing else, most of that does not
change in the sub-steps of a major step: the bodies that carry the branches move with q_T'' = a_T + X phi, a_T and X
held like their coordinates, phi the forces of the branches. So a sub-step evaluates the branches only, which give phi
with the response of the rest, and q_L is moved once a major step by the sums over its sub-steps k = 1 ... m,

    x_L <- x_L + H v_L + H h/2 a_0 + h^2 sum (m - k) a_k,    v_L <- v_L + h/2 a_0 + h (sum a_k - a_m / 2),

which are the sub-steps' own. The forces see q_L' where it will be at the middle, too, rather than as it is.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from runtime.engine.program import Fields
from runtime.schemes.central_difference import replaced
from runtime.schemes.held_slow import HeldSlow
from runtime.schemes.options import ClosureOptions, one_of
from runtime.schemes.scheme import StateField, work
from runtime.schemes.sparse_lu import solve_symmetric
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.step_limit import StepLimit, shorter, slow_decay_limit


@dataclass(frozen=True)
class CoupledOptions(ClosureOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation.

    slow_velocity: what forces see of the slow velocities in sub-steps. `followed`: their own in each; `auto`: where the
        fast coordinates are in branches of a large tree, those at the middle of the major step, so that a sub-step
        costs the same whatever the tree.
    """

    slow_velocity: str = one_of("auto", "followed")


class Coupled(HeldSlow):
    """Schur complement in every sub-step; of the branches alone where `by_branches`."""

    options: CoupledOptions

    @property
    def by_branches(self) -> bool:
        """Are there kernels of the branches that hold the fast coordinates, and may slow velocities be held?"""
        sub_cycled = len(self.grid.groups) == 2 and bool(self.slow) and not self.model.loop_unknowns
        return sub_cycled and self.model.has("branch_motion") and self.options.slow_velocity == "auto"

    def further_fields(self) -> dict[str, StateField]:
        """And what is held of the trunk, sums over sub-steps of phi and of the slow accelerations of branches."""
        found = super().further_fields()
        if self.by_branches:
            slow, forces, own = len(self.slow), self._forces, len(self._own_slow)
            found |= {"hold_v": work(len(self.model.q_i)), "trunk_ddot": work(slow), "X_trunk": work(slow * forces)}
            found |= {"interface": work(forces * (1 + forces)), "phi": work(forces)}
            found |= {name: work(forces) for name in ("phi_sum", "phi_sums")}
            found |= {name: work(own) for name in ("branch_sum", "branch_sums")}
        return found

    @property
    def _forces(self) -> int:
        """How many forces the branches put on the trunk."""
        return int(self.model.kernel("branch_motion").numel_out("phi"))

    @cached_property
    def _own_slow(self) -> list[int]:
        """Positions in q_L of the branches' slow coordinates: where branch_ddot is not structurally zero."""
        kernel = self.model.kernel("branch_motion")
        inputs = [ca.SX.sym("x", kernel.numel_in(k)) for k in range(kernel.n_in())]
        found = dict(zip(kernel.name_out(), kernel.call(inputs), strict=True))["branch_ddot"]
        return [k for k in range(found.numel()) if not found[k].is_zero()]

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """And of the slow velocities where they are held."""
        found = super().step_limit(A_q, A_v)
        return shorter(found, slow_decay_limit(A_v, self.slow, self.grid.m[0])) if self.by_branches else found

    def accelerations(self, z: Fields, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
        """All accelerations from M_hat and Q_hat of this sub-step."""
        if equations.tree_is_shorter:
            return equations.tree_accelerations(motion, v)
        M_hat, Q_hat = equations.condensed(motion, v)
        order = [*self.fast, *self.slow]  # the last are eliminated first: q_L
        solved = solve_symmetric(M_hat[order, order], Q_hat[order])
        a = ca.SX(len(order), 1)
        for position, k in enumerate(order):
            a[k] = solved[position]
        return a

    # ---- the branches alone ---------------------------------------------------------------------------------

    def renewed(self, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> dict[str, ca.SX]:
        """The trunk's response at the middle."""
        if not self.by_branches:
            return {}
        found = {name: ca.vec(value) for name, value in equations.trunk_response(motion, v).items()}
        sums = ("phi_sum", "phi_sums", "branch_sum", "branch_sums")
        return {**found, "hold_v": v, **{name: ca.SX.zeros(self.layout.sizes[name]) for name in sums}}

    def _hold(self, z: Fields, equations: StageEquations, level: int) -> Mapping[str, ca.SX]:
        """And the slow coordinates as their velocities and last accelerations move them."""
        held = super()._hold(z, equations, level)
        if not self.by_branches:
            return held
        L, H, h = self.slow, equations.h[0], equations.h[-1]
        half = z["v"][L] + h / 2 * z["a"][L]
        moved = {"x": replaced(z["x"], L, z["x"][L] + H * half), "v": replaced(z["v"], L, half)}
        return {**held, **moved}

    def _sub_step(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        if not self.by_branches:
            return super()._sub_step(z, equations)
        L, S, h, s = self.slow, self.fast, equations.h[-1], z["s"] + equations.h[-1]
        half = z["v"][S] + h / 2 * z["a"][S]
        turning = self.turning(z, equations, replaced(z["v"], S, half))[S]
        x, v = z["x"][S] + h * turning, half + h / 2 * z["a"][S]
        motion = equations.close(replaced(z["hold_q"], S, x), z["loop"], self.now(z, equations) + s, 1)
        found = equations.branch_motion(motion, replaced(z["hold_v"], S, v), z["interface"])
        a, phi, branch = found["q_S_ddot"], found["phi"], found["branch_ddot"][self._own_slow]
        return {
            "x": replaced(z["x"], S, x),
            "v": replaced(z["v"], S, half + h / 2 * a),
            "a": replaced(replaced(z["a"], S, a), L, found["branch_ddot"]),
            "s": s,
            "phi": phi,
            "phi_sum": z["phi_sum"] + phi,
            "phi_sums": z["phi_sums"] + z["phi_sum"],
            "branch_sum": z["branch_sum"] + branch,
            "branch_sums": z["branch_sums"] + z["branch_sum"],
        }

    def _finish(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """q_L at the end of the major step; the field a holds the branches' part of the last q_L''."""
        if not self.by_branches:
            return super()._finish(z, equations)
        L, m, h, a_T = self.slow, self.grid.m[0], equations.h[-1], z["trunk_ddot"]
        X = ca.reshape(z["X_trunk"], len(L), z["phi"].numel())
        a = a_T + ca.mtimes(X, z["phi"]) + z["a"][L]
        none = ca.SX.zeros(len(L))
        once = m * a_T + ca.mtimes(X, z["phi_sum"]) + replaced(none, self._own_slow, z["branch_sum"])
        twice = m * (m - 1) / 2 * a_T + ca.mtimes(X, z["phi_sums"]) + replaced(none, self._own_slow, z["branch_sums"])
        moved = {"x": z["x"][L] + h * h * twice, "v": z["v"][L] + h * (once - a / 2), "a": a}
        return {**super()._finish(z, equations), **{name: replaced(z[name], L, one) for name, one in moved.items()}}
