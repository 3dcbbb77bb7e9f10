"""Central difference with nested groups: the paper's Fig. 5 as stages, single-rate being the case of one group.

State between stages, per coordinate of q_i:

    x        position reached (a fast group's at its sub-step, a slow group's at the end of its step)
    d        last increment q(t) - q(t - h); storing it instead of q(t - h) is the same algorithm with less rounding
    base_q, base_v, base_a, base_s      slow groups: state and time at the start of their running step
    n, s     major steps done; time since the start of the running major step

(40)-(43) read  q_ddot = (d_next - d) / h^2  and  q_dot = (d_next + d) / (2 h) = d / h + h q_ddot / 2.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from runtime.engine.program import Call, Fields, Layout, Program, Repeat, Sequence, Until, make_stage
from runtime.model import Model
from runtime.schemes.grid import Grid
from runtime.schemes.kernels import Motion, StepKernels
from runtime.schemes.linear_solve import solve_general, solve_symmetric
from runtime.schemes.options import LARGE_SYSTEM, Options
from runtime.schemes.slow_interpolation import INTERPOLATIONS

START_CLOSURE_ITERATIONS = 4
OBSERVE_ITERATIONS = 2  # Newton steps, or sweeps from the predictor
ROUNDING = 4e-16


class CentralDifference:
    """Program, start-up and observation of a central-difference scheme on one model and grid."""

    def __init__(self, model: Model, grid: Grid, options: Options) -> None:
        self.model, self.grid = model, grid
        self.options = options.checked(len(grid.groups))
        n, loops = len(model.q_i), len(model.loop_unknowns)
        self.layout = Layout({
            "t0": 1, "n": 1, "s": 1, "x": n, "d": n, "a": n, "base_q": n, "base_v": n, "base_a": n,
            "base_s": len(grid.groups), "loop": loops, "loop_old": loops, "loop_dot": loops,
            "closure_error": 1, "unconverged": 1, "iterations": 1, "failures": 1})
        self.c_size = int(model.kernel("constants").size_out(0)[0])
        self.step_sizes = np.array([grid.h[self._group_of(k)] for k in range(n)])
        self._h = ca.SX(ca.DM(self.step_sizes))

    def _group_of(self, k: int) -> int:
        return next(g for g, group in enumerate(self.grid.groups) if k in group)

    @property
    def _solves_velocity(self) -> bool:
        """Is q_dot of (41), (43) found by Newton where forces depend on it, rather than predicted?"""
        kernels = StepKernels(self.model, ca.SX.sym("c", self.c_size))
        chosen = self.options.common_velocity
        wanted = chosen == "newton" or (chosen == "auto" and len(self.model.q_i) <= LARGE_SYSTEM)
        return wanted and kernels.velocity_dependent

    @property
    def newton(self) -> bool:
        """Does the common update take Newton steps? (The printed sweep does not.)"""
        return self.options.common_update == "direct" and self._solves_velocity

    @property
    def _by_tree(self) -> bool:
        """A large tree in one group: its accelerations come from the O(N) elimination."""
        large = len(self.model.q_i) > LARGE_SYSTEM and len(self.grid.groups) == 1
        return large and self.model.has("forward_dynamics") and not self._solves_velocity

    # ---- the flow chart -------------------------------------------------------------------------------------

    def program(self) -> Program:
        """One major step: steps (7)-(9) of Fig. 5, nested as Eq. (72) says."""
        return self._interval(0)

    def _interval(self, level: int) -> Program:
        """Advance the groups from `level` on by the step of `level`."""
        parts: list[Program] = [self._update(level)]
        for inner in range(len(self.grid.groups) - 2, level - 1, -1):
            sub_steps = self.grid.m[inner] - 1
            if sub_steps:
                parts.append(Repeat(self._interval(inner + 1), sub_steps))
        return Sequence(tuple(parts)) if len(parts) > 1 else parts[0]

    def _update(self, level: int) -> Program:
        """Step (7), the common update, at level 0; step (8), a sub-step, above."""
        if level == 0 and self.options.common_update == "fixed_point":
            start = self._stage("common_start", lambda z, k: self._sweep_start(z, k))
            sweep = self._stage("common_sweep", lambda z, k: self._sweep(z, k))
            finish = self._stage("common_finish", lambda z, k: self._sweep_finish(z, k))
            flag = self.layout.slice("unconverged").start
            return Sequence((start, Until(sweep, flag, self.options.max_iterations), finish))
        name = "common_update" if level == 0 else f"sub_step_{level + 1}"
        return self._stage(name, lambda z, k: self._direct_update(z, k, level))

    def _stage(self, name: str, body) -> Call:  # type: ignore[no-untyped-def]
        return make_stage(name, self.layout, self.c_size, lambda z, c: body(z, StepKernels(self.model, c)))

    # ---- the printed common update, Eqs. (46)-(57) ----------------------------------------------------------

    def _sweep_start(self, z: Fields, kernels: StepKernels) -> Mapping[str, ca.SX]:
        """Starting guess: q(t + h) = q(t) is q_ddot = -d / h^2 (48)-(49); Taylor is the last q_ddot (50)-(51)."""
        guess = z["a"] if self.options.guess == "taylor" else -z["d"] / self._h**2
        return {"a": guess, "unconverged": ca.SX(1)}

    def _sweep(self, z: Fields, kernels: StepKernels) -> Mapping[str, ca.SX]:
        """(52)-(53): every group from the last iterate of the others, forces at the last iterate's velocity."""
        q, v, a = self._slow_state(z, 0)
        motion = self._motion(z, kernels, q, self._now(z, 0))
        M_hat, Q_hat = kernels.condensed(motion, v + self._h / 2 * a)
        new = ca.SX(a)
        worst = ca.SX(0)
        for g, group in enumerate(self.grid.groups):
            others = [k for k in range(len(self.model.q_i)) if k not in group]
            force = Q_hat[group] - ca.mtimes(M_hat[group, others], a[others]) if others else Q_hat
            solved = solve_symmetric(M_hat[group, group], force)
            for position, k in enumerate(group):
                new[k] = solved[position]
            worst = ca.fmax(worst, self._excess(g, new[group], a[group], z["d"][group]))
        return {"a": new, "unconverged": worst > 0, "iterations": z["iterations"] + 1}

    def _excess(self, g: int, new: ca.SX, old: ca.SX, d: ca.SX) -> ca.SX:
        """By how much q_ddot of a group changed more than (56)-(57) allow; h^2 times that is the change of q(t + h)."""
        h = self.grid.h[g]
        if self.options.stopping == "relative":
            # rounding of the increment d is below what a position can show
            allowed = self.options.eps[g] * ca.norm_inf(new) + ROUNDING / h**2 * ca.norm_inf(d)
        else:
            allowed = ca.SX(self.options.eps[g] / h**2)
        return ca.norm_inf(new - old) - allowed

    def _sweep_finish(self, z: Fields, kernels: StepKernels) -> Mapping[str, ca.SX]:
        q, v, a = self._slow_state(z, 0)
        motion = self._motion(z, kernels, q, self._now(z, 0))
        moved = self._advance(z, kernels, motion, v + self._h / 2 * a, a, 0)
        return {**moved, "failures": z["failures"] + z["unconverged"]}

    # ---- one update -----------------------------------------------------------------------------------------

    def _now(self, z: Fields, level: int) -> ca.SX:
        if level == 0:
            return z["t0"] + z["n"] * self.grid.dt_L
        return z["t0"] + (z["n"] - 1) * self.grid.dt_L + z["s"]

    def _slow_state(self, z: Fields, level: int) -> tuple[ca.SX, ca.SX, ca.SX]:
        """(q_i, half-step q_i_dot, q_i_ddot guess) at the time of the update; groups below `level` interpolated."""
        q, v, a = ca.SX(z["x"]), z["d"] / self._h, ca.SX(z["a"])
        interpolate = INTERPOLATIONS[self.options.slow_interpolation]
        for g in range(level):
            for k in self.grid.groups[g]:
                s = z["s"] - z["base_s"][g] if g else z["s"]  # the slowest group's step is the major step
                q[k], v[k] = interpolate(z["base_q"][k], z["base_v"][k], z["base_a"][k], s, self.grid.h[level],
                                         self.grid.h[g], z["x"][k])
                a[k] = z["base_a"][k]
        return q, v, a

    def _motion(self, z: Fields, kernels: StepKernels, q_i: ca.SX, t: ca.SX) -> Motion:
        """Closure from a leapfrog guess of the loop unknowns: x(t - h) + 2 h x_dot(t), third order."""
        return kernels.close(q_i, z["loop_old"] + 2 * self.grid.h[-1] * z["loop_dot"], t,
                             self.options.closure_iterations)

    def _direct_update(self, z: Fields, kernels: StepKernels, level: int) -> Mapping[str, ca.SX]:
        """Accelerations of the active groups solved at once, with Newton on their velocities where needed."""
        q, v_half, a = self._slow_state(z, level)
        motion = self._motion(z, kernels, q, self._now(z, level))
        active = self.grid.from_level(level)
        v = ca.SX(v_half)
        newton = self.newton if level == 0 else (
            kernels.velocity_dependent and self.options.sub_step_velocity == "newton")
        for _ in range(self.options.newton_iterations if newton else 1):
            for k in active:
                v[k] = v_half[k] + self._h[k] / 2 * a[k]
            solved = self._solve_active(kernels, motion, v, a, level, newton)
            for position, k in enumerate(active):
                a[k] = solved[position]
        for k in active:
            v[k] = v_half[k] + self._h[k] / 2 * a[k]
        return self._advance(z, kernels, motion, v, a, level)

    def _solve_active(self, kernels: StepKernels, motion: Motion, v: ca.SX, a: ca.SX, level: int,
                      newton: bool) -> ca.SX:
        """(M_hat - h/2 dQ/dv) (a_new - a) = Q - M_hat a on the active rows; M_hat a_new = Q without Newton."""
        active, slow = self.grid.from_level(level), self.grid.first_of(level)
        if level == 0 and self._by_tree:
            return kernels.accelerations(motion, v)
        if level == 0:
            M_hat, force = kernels.condensed(motion, v)
        else:
            M_hat, force = kernels.substep(level, motion, v, ca.vertcat(*(a[k] for k in slow)))
        if not newton:
            return solve_symmetric(M_hat, force)
        J = kernels.damping(motion, v)[active, active]
        half = ca.diag(ca.vertcat(*(self._h[k] / 2 for k in active)))
        a_active = ca.vertcat(*(a[k] for k in active))
        return solve_general(M_hat - ca.mtimes(J, half), force - ca.mtimes(J, ca.mtimes(half, a_active)))

    def _advance(self, z: Fields, kernels: StepKernels, motion: Motion, v: ca.SX, a: ca.SX,
                 level: int) -> dict[str, ca.SX]:
        """Move the active groups by their own steps; slow ones remember where their step began."""
        last = len(self.grid.groups) - 1
        s = ca.SX(0) if level == 0 else z["s"]
        out = {name: ca.SX(z[name]) for name in ("x", "d", "a", "base_q", "base_v", "base_a", "base_s")}
        for g in range(level, last + 1):
            out["base_s"][g] = s
            for k in self.grid.groups[g]:
                out["d"][k] = z["d"][k] + self._h[k] ** 2 * a[k]
                out["x"][k] = z["x"][k] + out["d"][k]
                out["a"][k] = a[k]
                if g < last:
                    out["base_q"][k], out["base_v"][k], out["base_a"][k] = z["x"][k], v[k], a[k]
        out["s"] = s + self.grid.h[-1]
        if level == 0:
            out["n"] = z["n"] + 1
        if kernels.loops:
            out["loop_old"], out["loop"] = z["loop"], kernels.loop_part(motion.q_d)
            out["loop_dot"] = kernels.loop_part(kernels.rates(motion, v))
            out["closure_error"] = ca.fmax(z["closure_error"], motion.C_loop)
        return out

    # ---- start-up and observation ---------------------------------------------------------------------------

    def start(self) -> ca.Function:
        """(t0, q_i, q_i_dot, loop unknowns, c) -> z (Eqs. 68-71)."""
        t0, c = ca.SX.sym("t0"), ca.SX.sym("c", self.c_size)
        q_i, q_i_dot = ca.SX.sym("q_i", len(self.model.q_i)), ca.SX.sym("q_i_dot", len(self.model.q_i))
        loop = ca.SX.sym("loop", len(self.model.loop_unknowns))
        kernels = StepKernels(self.model, c)
        motion = kernels.close(q_i, loop, t0, START_CLOSURE_ITERATIONS)
        a = self._solve_active(kernels, motion, q_i_dot, ca.SX.zeros(len(self.model.q_i)), 0, newton=False)  # (68)
        d = self._h * q_i_dot - self._h**2 / 2 * a  # (69)-(71): q(t) - q(t - h)
        zero = ca.SX.zeros(len(self.model.q_i))
        closed = kernels.loop_part(motion.q_d)
        before = closed - self.grid.h[-1] * kernels.loop_part(kernels.rates(motion, q_i_dot))
        z = self.layout.pack({
            "t0": t0, "n": ca.SX(0), "s": ca.SX(0), "x": q_i, "d": d, "a": a, "base_q": zero, "base_v": zero,
            "base_a": zero, "base_s": ca.SX.zeros(len(self.grid.groups)), "loop": before, "loop_old": closed,
            "loop_dot": ca.SX.zeros(len(self.model.loop_unknowns)), "closure_error": ca.SX(0),
            "unconverged": ca.SX(0), "iterations": ca.SX(0), "failures": ca.SX(0)})
        return ca.Function("start", [t0, q_i, q_i_dot, loop, c], [z])

    def observe(self) -> ca.Function:
        """(z, c) -> t, q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, q_d_ddot between two major steps."""
        z, c = ca.SX.sym("z", self.layout.size), ca.SX.sym("c", self.c_size)
        fields, kernels = self.layout.unpack(z), StepKernels(self.model, c)
        q, v_half, a = self._slow_state(fields, 0)
        motion = self._motion(fields, kernels, q, self._now(fields, 0))
        newton = self._solves_velocity
        for _ in range(OBSERVE_ITERATIONS if kernels.velocity_dependent else 1):
            a = self._solve_active(kernels, motion, v_half + self._h / 2 * a, a, 0, newton)
        v = v_half + self._h / 2 * a
        v_d = kernels.rates(motion, v)
        a_d = ca.SX(0, 1)
        if self.model.q_d:
            a_d = kernels.call("accelerations", q_i=q, q_d=motion.q_d, q_i_dot=v, q_d_dot=v_d, q_i_ddot=a,
                               t=motion.t)["q_d_ddot"]
        outputs = ca.cse([motion.t, q, motion.q_d, v, v_d, a, a_d])
        names = ["t", "q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "q_d_ddot"]
        return ca.Function("observe", [z, c], outputs, ["z", "c"], names)
