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

from runtime.contract.model import Model
from runtime.engine.program import Fields, Program, Repeat, Sequence, Until
from runtime.schemes.grid import Grid
from runtime.schemes.kernels import Motion, StepKernels, velocity_dependent
from runtime.schemes.linear_solve import solve_general, solve_symmetric
from runtime.schemes.options import LARGE_SYSTEM, Options
from runtime.schemes.scheme import Scheme
from runtime.schemes.slow_interpolation import INTERPOLATIONS
from runtime.schemes.step_limit import PREDICTED_DECAY_REACH, StepLimit, central_difference_limit

START_CLOSURE_ITERATIONS = 4
OBSERVE_ITERATIONS = 2  # Newton steps, or sweeps from the predictor
ROUNDING = 4e-16
LARGEST = 1e300
RUN_AWAY = 1e6  # increments [m or rad] of a step that were out of hand before the sweep


class CentralDifference(Scheme):
    """Program, start-up and observation of a central-difference scheme on one model and grid."""

    reach = 2.0
    memory = ("x", "d", "a", "loop", "loop_old", "loop_dot")
    history = ("d", "a")

    def __init__(self, model: Model, grid: Grid, options: Options) -> None:
        super().__init__(model, grid, options)
        common = self.options.common_update == "fixed_point" or self._solves_velocity
        sub_steps = all(ratio == 1 for ratio in grid.m) or self.options.sub_step_velocity == "newton"
        if velocity_dependent(model) and not (common and sub_steps):  # else the damping is implicit
            self.decay_reach = PREDICTED_DECAY_REACH

    def fields(self) -> dict[str, int]:
        """See the module's text."""
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        return {
            "s": 1,
            "d": n,
            "a": n,
            "base_q": n,
            "base_v": n,
            "base_a": n,
            "base_s": len(self.grid.groups),
            "loop_old": loops,
            "loop_dot": loops,
            "unconverged": 1,
        }

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of central difference, with or without predicted velocities."""
        return central_difference_limit(A_q, A_v, predicted=self.decay_reach is not None)

    def rates(self, z: np.ndarray) -> np.ndarray:
        """Increments over steps."""
        return np.asarray(z[self.layout.slice("d")] / self.step_sizes)

    def evaluations(self) -> tuple[int, int]:
        """One common update, or its Newton steps, and the sub-steps."""
        per_step = 1
        for ratio in self.grid.m:
            per_step *= ratio
        return (max(1, self.options.newton_iterations) if self.newton else 1), per_step - 1

    def _h(self, kernels: StepKernels) -> ca.SX:
        """Step of each coordinate."""
        return ca.vertcat(*(kernels.h[self.group_of(k)] for k in range(len(self.model.q_i))))

    @property
    def _solves_velocity(self) -> bool:
        """Is q_dot of (41), (43) found by Newton where forces depend on it, rather than predicted?"""
        chosen = self.options.common_velocity
        wanted = chosen == "newton" or (chosen == "auto" and len(self.model.q_i) <= LARGE_SYSTEM)
        return wanted and velocity_dependent(self.model)

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
            start = self.stage("common_start", self._sweep_start)
            sweep = self.stage("common_sweep", self._sweep)
            finish = self.stage("common_finish", self._sweep_finish)
            flag = self.layout.slice("unconverged").start
            return Sequence((start, Until(sweep, flag, self.options.max_iterations), finish))
        name = "common_update" if level == 0 else f"sub_step_{level + 1}"
        return self.stage(name, lambda z, k: self._direct_update(z, k, level))

    # ---- the printed common update, Eqs. (46)-(57) ----------------------------------------------------------

    def _sweep_start(self, z: Fields, kernels: StepKernels) -> Mapping[str, ca.SX]:
        """Starting guess: q(t + h) = q(t) is q_ddot = -d / h^2 (48)-(49); Taylor is the last q_ddot (50)-(51)."""
        guess = z["a"] if self.options.guess == "taylor" else -z["d"] / self._h(kernels) ** 2
        return {"a": guess, "unconverged": ca.SX(1)}

    def _sweep(self, z: Fields, kernels: StepKernels) -> Mapping[str, ca.SX]:
        """(52)-(53): every group from the last iterate of the others, forces at the last iterate's velocity."""
        q, v, a = self._slow_state(z, kernels, 0)
        motion = self._motion(z, kernels, q, self._now(z, kernels, 0))
        M_hat, Q_hat = kernels.condensed(motion, v + self._h(kernels) / 2 * a)
        new = ca.SX(a)
        settled = ca.SX(1)
        for g, group in enumerate(self.grid.groups):
            others = [k for k in range(len(self.model.q_i)) if k not in group]
            force = Q_hat[group] - ca.mtimes(M_hat[group, others], a[others]) if others else Q_hat
            solved = solve_symmetric(M_hat[group, group], force)
            for position, k in enumerate(group):
                new[k] = solved[position]
            excess = self._excess(g, new[group], a[group], z["d"][group], kernels.h[g])
            settled = settled * (excess <= 0)
        settled = settled * (ca.sum1(ca.fabs(new)) < LARGEST)  # false for NaN, which a largest value hides
        return {"a": new, "unconverged": 1 - settled, "iterations": z["iterations"] + 1}

    def _excess(self, g: int, new: ca.SX, old: ca.SX, d: ca.SX, h: ca.SX) -> ca.SX:
        """By how much q_ddot of a group changed more than (56)-(57) allow; h^2 times that is the change of q(t + h)."""
        if self.options.stopping == "relative":
            # rounding of the increment d is below what a position can show
            allowed = self.options.eps[g] * ca.norm_inf(new) + ROUNDING / h**2 * ca.norm_inf(d)
        else:
            allowed = ca.SX(self.options.eps[g] / h**2)
        return ca.norm_inf(new - old) - allowed

    def _sweep_finish(self, z: Fields, kernels: StepKernels) -> Mapping[str, ca.SX]:
        q, v, a = self._slow_state(z, kernels, 0)
        motion = self._motion(z, kernels, q, self._now(z, kernels, 0))
        moved = self._advance(z, kernels, motion, v + self._h(kernels) / 2 * a, a, 0)
        moving = ca.sum1(ca.fabs(z["d"])) < RUN_AWAY  # no sweep can be blamed for what came from elsewhere
        return {**moved, "failures": z["failures"] + z["unconverged"] * moving}

    # ---- one update -----------------------------------------------------------------------------------------

    def _now(self, z: Fields, kernels: StepKernels, level: int) -> ca.SX:
        if level == 0:
            return self.now(z, kernels)
        return z["t0"] + (z["n"] - 1) * kernels.h[0] + z["s"]

    def _slow_state(self, z: Fields, kernels: StepKernels, level: int) -> tuple[ca.SX, ca.SX, ca.SX]:
        """(q_i, half-step q_i_dot, q_i_ddot guess) at the time of the update; groups below `level` interpolated."""
        q, v, a = ca.SX(z["x"]), z["d"] / self._h(kernels), ca.SX(z["a"])
        interpolate = INTERPOLATIONS[self.options.slow_interpolation]
        for g in range(level):
            for k in self.grid.groups[g]:
                s = z["s"] - z["base_s"][g] if g else z["s"]  # the slowest group's step is the major step
                q[k], v[k] = interpolate(
                    z["base_q"][k], z["base_v"][k], z["base_a"][k], s, kernels.h[level], kernels.h[g], z["x"][k]
                )
                a[k] = z["base_a"][k]
        return q, v, a

    def _motion(self, z: Fields, kernels: StepKernels, q_i: ca.SX, t: ca.SX) -> Motion:
        """Closure from a leapfrog guess of the loop unknowns: x(t - h) + 2 h x_dot(t), third order."""
        return kernels.close(q_i, z["loop_old"] + 2 * kernels.h[-1] * z["loop_dot"], t, self.options.closure_iterations)

    def _direct_update(self, z: Fields, kernels: StepKernels, level: int) -> Mapping[str, ca.SX]:
        """Accelerations of the active groups solved at once, with Newton on their velocities where needed."""
        q, v_half, a = self._slow_state(z, kernels, level)
        motion = self._motion(z, kernels, q, self._now(z, kernels, level))
        active, h = self.grid.from_level(level), self._h(kernels)
        v = ca.SX(v_half)
        newton = (
            self.newton
            if level == 0
            else (velocity_dependent(self.model) and self.options.sub_step_velocity == "newton")
        )
        for _ in range(self.options.newton_iterations if newton else 1):
            for k in active:
                v[k] = v_half[k] + h[k] / 2 * a[k]
            solved = self._solve_active(kernels, motion, v, a, level, newton)
            for position, k in enumerate(active):
                a[k] = solved[position]
        for k in active:
            v[k] = v_half[k] + h[k] / 2 * a[k]
        return self._advance(z, kernels, motion, v, a, level)

    def _solve_active(
        self, kernels: StepKernels, motion: Motion, v: ca.SX, a: ca.SX, level: int, newton: bool
    ) -> ca.SX:
        """(M_hat - h/2 dQ/dv) (a_new - a) = Q - M_hat a on the active rows; M_hat a_new = Q without Newton."""
        active, slow = self.grid.from_level(level), self.grid.first_of(level)
        if level == 0 and self._by_tree:
            return kernels.tree_accelerations(motion, v)
        if level == 0:
            M_hat, force = kernels.condensed(motion, v)
        else:
            M_hat, force = kernels.substep(level, motion, v, ca.vertcat(*(a[k] for k in slow)))
        if not newton:
            return solve_symmetric(M_hat, force)
        J = kernels.damping(motion, v)[active, active]
        half = ca.diag(self._h(kernels)[active] / 2)
        a_active = ca.vertcat(*(a[k] for k in active))
        return solve_general(M_hat - ca.mtimes(J, half), force - ca.mtimes(J, ca.mtimes(half, a_active)))

    def _advance(
        self, z: Fields, kernels: StepKernels, motion: Motion, v: ca.SX, a: ca.SX, level: int
    ) -> dict[str, ca.SX]:
        """Move the active groups by their own steps; slow ones remember where their step began."""
        last, h = len(self.grid.groups) - 1, self._h(kernels)
        s = ca.SX(0) if level == 0 else z["s"]
        out = {name: ca.SX(z[name]) for name in ("x", "d", "a", "base_q", "base_v", "base_a", "base_s")}
        for g in range(level, last + 1):
            out["base_s"][g] = s
            for k in self.grid.groups[g]:
                out["d"][k] = z["d"][k] + h[k] ** 2 * a[k]
                out["x"][k] = z["x"][k] + out["d"][k]
                out["a"][k] = a[k]
                if g < last:
                    out["base_q"][k], out["base_v"][k], out["base_a"][k] = z["x"][k], v[k], a[k]
        out["s"] = s + kernels.h[-1]
        if level == 0:
            out["n"] = z["n"] + 1
        if kernels.loops:
            out["loop_old"], out["loop"] = z["loop"], kernels.loop_part(motion.q_d)
            out["loop_dot"] = kernels.loop_part(kernels.rates(motion, v))
            out |= self.closed(z, motion)
        return out

    # ---- start-up and observation ---------------------------------------------------------------------------

    def start(self) -> ca.Function:
        """(t0, q_i, q_i_dot, loop unknowns, c) -> z (Eqs. 68-71)."""
        return self.start_function(self._started)

    def _started(self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, kernels: StepKernels) -> dict[str, ca.SX]:
        motion, h = kernels.close(q_i, loop, t0, START_CLOSURE_ITERATIONS), self._h(kernels)
        a = self._solve_active(kernels, motion, q_i_dot, ca.SX.zeros(len(self.model.q_i)), 0, newton=False)  # (68)
        closed = kernels.loop_part(motion.q_d)
        before = closed - kernels.h[-1] * kernels.loop_part(kernels.rates(motion, q_i_dot))
        return {
            "a": a,
            "d": h * q_i_dot - h**2 / 2 * a,  # (69)-(71): q(t) - q(t - h)
            "loop": before,
            "loop_old": closed,
        }

    def observe(self) -> ca.Function:
        """(z, c) -> OBSERVED between two major steps."""
        return self.observe_function(self._observed)

    def _observed(self, z: Fields, kernels: StepKernels) -> tuple[Motion, ca.SX, ca.SX]:
        q, v_half, a = self._slow_state(z, kernels, 0)
        motion, h = self._motion(z, kernels, q, self._now(z, kernels, 0)), self._h(kernels)
        for _ in range(OBSERVE_ITERATIONS if velocity_dependent(self.model) else 1):
            a = self._solve_active(kernels, motion, v_half + h / 2 * a, a, 0, self._solves_velocity)
        return motion, v_half + h / 2 * a, a
