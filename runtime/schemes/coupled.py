"""Coupled sub-steps: the whole condensed system is solved in each, with the slow coordinates held.

In a major step the equations see the slow coordinates q_L where they will be at the middle of the sub-steps; so what
depends on them only is computed once (runtime/engine/prepare.py takes it out of the sub-step). All coordinates are
advanced by every sub-step with its own acceleration:

    v_half = v + h a / 2,   x = x + h v_half,   a = accelerations(held q_L, x_S, v_half + h a_last / 2),
    v = v_half + h a / 2

so q_L moves with the sum of the sub-step accelerations, and the momentum of the fast coordinates is not lost. With
one sub-step this is central difference up to the held position.

The middle is extrapolated along the secant of the last major step: second order for what the step resolves, and
bounded for what it does not (a velocity or acceleration would be multiplied by the step).

The solution eliminates q_L: (M_SS - M_SL M_LL^-1 M_LS) a_S = Q_S - M_SL M_LL^-1 Q_L, a_L = M_LL^-1 (Q_L - M_LS a_S);
on large trees the elimination is that of the tree, in O(N).
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import casadi as ca
import numpy as np

from runtime.engine.program import Fields, Program, Repeat, Sequence
from runtime.schemes.options import ClosureOptions
from runtime.schemes.scheme import Scheme, StateField, history, state, work
from runtime.schemes.sparse_lu import solve_symmetric
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.step_limit import StepLimit, central_difference_limit


class Coupled(Scheme):
    """Any number of nested groups: each is held over the sub-steps of the next faster one.

    References
    ----------
    Of this project, after the sub-cycling of T. Belytschko, H.-J. Yen and R. Mullen, Mixed methods for time
    integration, Computer Methods in Applied Mechanics and Engineering 17-18, 1979, 259-275.
    """

    options: ClosureOptions

    def fields(self) -> dict[str, StateField]:
        """Held positions, ends of the secants (of one group nothing is held), s: time in the running major step.

        What no step would ever write again must not be called state: it would be a mode of the step that neither grows
        nor decays.
        """
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        found = {**super().fields(), "s": work(1), "a": history(n)}
        if len(self.grid.groups) > 1:
            found |= {"hold_q": work(n), "x_last": history(n), "v_last": history(n)}
            found |= {"loop_old": state(loops), "loop_dot": state(loops)}
        return found

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of central difference with predicted velocities."""
        return central_difference_limit(A_q, A_v, predicted=True)

    @property
    def slow(self) -> list[int]:
        """Coordinates that are held: those with a longer step than the fastest group."""
        return [k for g, group in enumerate(self.grid.groups) for k in group if self.grid.h[g] > self.grid.h[-1]]

    @property
    def fast(self) -> list[int]:
        """The others."""
        return [k for k in range(len(self.model.q_i)) if k not in self.slow]

    def program(self) -> Program:
        """One major step."""
        last = len(self.grid.groups) - 1
        body: Program = self.stage("sub_step", self._sub_step)
        for level in reversed(range(last)):
            hold = self.stage(f"hold_{level + 1}", partial(self._hold, level=level))
            body = Sequence((hold, Repeat(body, self.grid.m[level])))
        return Sequence((body, self.stage("finish", self._finish)))

    def evaluations(self) -> tuple[int, int]:
        """Holds and sub-steps."""
        per_step, holds = 1, 0
        for ratio in self.grid.m:
            holds += per_step
            per_step *= ratio
        return holds, per_step

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """Accelerations at the start, and secants along the rates and accelerations there."""
        fields = super().started(t0, q_i, q_i_dot, loop, equations)
        motion = equations.close(q_i, fields["loop"], t0, 1)
        a, H = equations.accelerations(motion, q_i_dot), self._own_steps(equations)
        if len(self.grid.groups) == 1:
            return {**fields, "a": a}
        loop_dot = equations.loop_part(equations.rates(motion, q_i_dot))
        return {
            **fields,
            "a": a,
            "x_last": q_i - H * q_i_dot + H * H / 2 * a,
            "v_last": q_i_dot - H * a,
            "loop_dot": loop_dot,
            "loop_old": fields["loop"] - equations.h[0] * loop_dot,
        }

    def _own_steps(self, equations: StageEquations) -> ca.SX:
        """Time between two holds of each coordinate; the fastest group's secant is the slowest one's."""
        last = len(self.grid.groups) - 1
        groups = (self.group_of(k) for k in range(len(self.model.q_i)))
        return ca.vertcat(*(equations.h[0 if g == last else g] for g in groups))

    def _hold(self, z: Fields, equations: StageEquations, level: int) -> Mapping[str, ca.SX]:
        """Hold a group where it will be at the mean time of its finest sub-steps, (H + h) / 2 from now."""
        ahead = (equations.h[level] + equations.h[-1]) / 2
        share = ahead / self._own_steps(equations)
        x_ahead = z["x"] + share * (z["x"] - z["x_last"])
        v_ahead = z["v"] + share * (z["v"] - z["v_last"])
        out = {name: ca.SX(z[name]) for name in ("hold_q", "x_last", "v_last")}
        for k in self.grid.groups[level]:
            out["hold_q"][k] = x_ahead[k]
        for k in [*self.grid.groups[level], *(self.grid.groups[-1] if level == 0 else [])]:
            out["x_last"][k], out["v_last"][k] = z["x"][k], z["v"][k]
        if level > 0:
            return out
        motion = equations.close(
            x_ahead,
            z["loop_old"] + 2 * equations.h[0] * z["loop_dot"],
            self.now(z, equations) + ahead,
            self.options.closure_iterations,
        )
        if equations.loops:
            out |= {
                "loop_old": z["loop"],
                "loop": equations.loop_part(motion.q_d),
                "loop_dot": equations.loop_part(equations.rates(motion, v_ahead)),
                **self.closed(z, motion),
            }
        return out

    def _sub_step(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h = equations.h[-1]
        half = z["v"] + h / 2 * z["a"]
        x, v, s = z["x"] + h * self.turning(z, equations, half), half + h / 2 * z["a"], z["s"] + h
        held = ca.SX(x)
        for k in self.slow:
            held[k] = z["hold_q"][k]
        motion = equations.close(held, z["loop"], self.now(z, equations) + s, self.options.closure_iterations)
        a = self.accelerations(equations, motion, v)
        out = {"x": x, "v": half + h / 2 * a, "a": a, "s": s}
        if equations.loops:
            out |= {"loop": equations.loop_part(motion.q_d), **self.closed(z, motion)}
        return out

    def turning(self, z: Fields, equations: StageEquations, half: ca.SX) -> ca.SX:
        """Rates of x in the middle of a sub-step with the velocities half there."""
        h = equations.h[-1]
        there = z["x"] + h / 2 * half
        if not self.charts.split:
            return self.charts.rates(there, half)
        t = self.now(z, equations) + z["s"] + h / 2
        return equations.turning(equations.close(there, z["loop"], t, self.options.closure_iterations), half)

    def accelerations(self, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
        """q_i_ddot at the seen motion and the rates of the sub-step, from M_hat and Q_hat there."""
        if equations.tree_is_shorter:
            return equations.tree_accelerations(motion, v)
        M_hat, Q_hat = equations.condensed(motion, v)
        order = [*self.fast, *self.slow]  # the last are eliminated first: q_L
        solved = solve_symmetric(M_hat[order, order], Q_hat[order])
        a = ca.SX(len(order), 1)
        for position, k in enumerate(order):
            a[k] = solved[position]
        return a

    def _finish(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        end = self.arrived(equations, z["x"], z["loop"], self.now(z, equations) + equations.h[0])
        before, loops = (tuple(name for name in (one,) if name in z) for one in ("x_last", "loop_old"))
        moved = self.rebased(z, end, z["loop"], since=before, loops_since=loops)
        return {**moved, "n": z["n"] + 1, "s": ca.SX(0)}
