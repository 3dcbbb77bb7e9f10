"""The paper's sub-cycling: Fig. 5 in its order, for any number of nested groups (72).

    step of Fig. 5               Eqs.        here                        its equations in
    (6) start-up                 (68)-(71)   CentralDifference.start     start_up.py
    (7) common update            (44)-(57)   Printed._common_update      common_update.py
    (8) sub-steps                (58)-(67)   Printed._sub_step           sub_step.py, slow_interpolation.py
    (9) next cycle               (40)-(43)   Printed._next_cycle         differences.py

Fields of z besides those of central_difference.py: s, time since the start of the running major step; q_L, q_L_dot,
q_L_ddot and t_L, state of each slow coordinate and time since the start of the major step when its group's running
step began; x is then the value at the end of that step. unconverged: 1 until the sweep has converged; change: the
largest change of q_ddot of each group by the last sweep.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from runtime.engine.program import Fields, Program, Repeat, Sequence, Until
from runtime.schemes.central_difference import CentralDifference, CentralDifferenceOptions
from runtime.schemes.common_update import (
    allowed_change,
    newton_step,
    rounding_of_sweep,
    solved_at_once,
    starting_guess,
    sweep,
)
from runtime.schemes.differences import replaced, velocity
from runtime.schemes.options import MOST_ITERATIONS, one_of, tolerances, whole_number
from runtime.schemes.scheme import LARGEST
from runtime.schemes.slow_interpolation import INTERPOLATIONS
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, velocity_dependent
from runtime.schemes.state_fields import StateField, control, work
from runtime.schemes.sub_step import Known, at_sub_step, rows

RUN_AWAY = 1e6  # increments [m or rad] of a step that were out of hand before the sweep


@dataclass(frozen=True)
class PrintedOptions(CentralDifferenceOptions):
    """closure_iterations, common_velocity, newton_iterations: see CentralDifferenceOptions.

    common_update: `fixed_point` is the sweep (52)-(55) with the test (56)-(57); `direct` solves (39) at once, with
        Newton on dQ_hat/dq_i_dot where forces depend on velocity.
    guess: `taylor` (50)-(51) or `previous` (48)-(49).
    slow_interpolation: how slow variables move during sub-steps, see slow_interpolation.py.
    sub_step_velocity: `predictor` takes q_S_dot with the last acceleration (explicit, second order); `newton` solves
        (43) with the emitted Jacobian.
    eps: one tolerance per group, slow to fast (eps_L, eps_S); a single one serves all.
    stopping: `relative` compares the change of q(t + h) by a sweep with the group's largest h^2 q_ddot, so that
        small steps converge too; `absolute` is (56)-(57) as printed, in the coordinates' own unit.
    max_iterations: the most sweeps of a step.
    """

    common_update: str = one_of("fixed_point", "direct")
    guess: str = one_of("taylor", "previous")
    slow_interpolation: str = one_of(*INTERPOLATIONS)
    sub_step_velocity: str = one_of("predictor", "newton")
    eps: tuple[float, ...] = tolerances(1e-13)
    stopping: str = one_of("relative", "absolute")
    max_iterations: int = whole_number(500, most=MOST_ITERATIONS)


class Printed(CentralDifference):
    """Major steps of the paper's scheme on one model and grid."""

    options: PrintedOptions

    def fields(self) -> dict[str, StateField]:
        """See the module's text."""
        n, groups = len(self.model.q_i), len(self.grid.groups)
        own = {"s": work(1), "q_L": work(n), "q_L_dot": work(n), "q_L_ddot": work(n), "t_L": work(groups)}
        swept = {"unconverged": control(1), "change": control(groups)} if self.sweeps else {}
        return {**super().fields(), **own, **swept}

    @property
    def sweeps(self) -> bool:
        """Is the common update the printed sweep?"""
        return self.options.common_update == "fixed_point"

    @property
    def predicts_velocity(self) -> bool:
        """Neither the sweep nor Newton's steps do; sub-steps do unless they take Newton's."""
        common = self.sweeps or self.solves_velocity
        sub_steps = all(ratio == 1 for ratio in self.grid.m) or self.options.sub_step_velocity == "newton"
        return velocity_dependent(self.model) and not (common and sub_steps)

    @property
    def iteration_limit(self) -> int:
        """The option max_iterations."""
        return self.options.max_iterations

    def evaluations(self) -> tuple[int, int]:
        """One common update, or its Newton steps, and the sub-steps; a run counts its own sweeps."""
        per_step = 1
        for ratio in self.grid.m:
            per_step *= ratio
        newton = self.solves_velocity and not self.sweeps
        return self.options.newton_iterations if newton else 1, per_step - 1

    def program(self) -> Program:
        """One major step: steps (7)-(9) of Fig. 5."""
        return self._interval(0)

    def _interval(self, level: int) -> Program:
        """Advance the groups from `level` on by the step of `level`, nested as (72) says."""
        parts: list[Program] = [self._common_update() if level == 0 else self._sub_step(level)]
        for inner in range(len(self.grid.groups) - 2, level - 1, -1):
            sub_steps = self.grid.m[inner] - 1
            if sub_steps:
                parts.append(Repeat(self._interval(inner + 1), sub_steps))
        return Sequence(tuple(parts)) if len(parts) > 1 else parts[0]

    # ---- (7) common update ----------------------------------------------------------------------------------

    def _common_update(self) -> Program:
        """Step (7): guess (48)-(51), sweep (52)-(55) until (56)-(57) hold; or (44)-(45) solved at once."""
        if not self.sweeps:
            return self.stage("common_update", self._solve_at_once)
        start = self.stage("common_start", self._guess)
        flag = self.layout.slice("unconverged").start
        sweeps = Until(self.stage("common_sweep", self._sweep), flag, self.options.max_iterations)
        return Sequence((start, sweeps, self.stage("common_finish", self._finish)))

    def _solve_at_once(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        return self._next_cycle(z, equations, *self.solved(z, equations), 0)

    def _guess(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        guess = starting_guess(self.options.guess, z["d"], z["a"], self.steps(equations))
        changes = LARGEST * ca.SX.ones(len(self.grid.groups))
        return {"a": guess, "unconverged": self.alive(z), "change": changes}

    def _sweep(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        motion, v = self._now_swept(z, equations)
        M_hat, Q_hat = equations.condensed(motion, v)
        new, settled, changes = sweep(M_hat, Q_hat, z["a"], self.grid.groups), ca.SX(1), []
        for g, group in enumerate(self.grid.groups):
            h, change = equations.h[g], ca.norm_inf(new[group] - z["a"][group])
            allowed = allowed_change(new[group], z["d"][group], h, self.options.eps[g], self.options.stopping)
            rounding = rounding_of_sweep(M_hat, z["a"], z["x"], h, group)
            arrived = ca.logic_and(change >= z["change"][g], change <= rounding)
            settled = settled * ca.logic_or(change <= allowed, arrived)
            changes.append(change)
        settled = settled * (ca.sum1(ca.fabs(new)) < LARGEST)  # false for NaN, which a largest value hides
        return {
            "a": new,
            "unconverged": 1 - settled,
            "change": ca.vertcat(*changes),
            "iterations": z["iterations"] + 1,
        }

    def _finish(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        motion, v = self._now_swept(z, equations)
        moving = ca.sum1(ca.fabs(z["d"])) < RUN_AWAY  # no sweep can be blamed for what came from elsewhere
        moved = self._next_cycle(z, equations, motion, v, z["a"], 0)
        return {**moved, "failures": z["failures"] + z["unconverged"] * moving}

    def _now_swept(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX]:
        """(motion, q_i_dot) at time t with the last iterate of q_i_ddot."""
        h = self.steps(equations)
        motion = self.motion(z, equations, z["x"], self.now(z, equations))
        return motion, velocity(z["d"] / h, z["a"], h)

    # ---- (8) sub-steps --------------------------------------------------------------------------------------

    def _sub_step(self, level: int) -> Program:
        """Step (8): one sub-step of the groups from `level` on."""
        return self.stage(f"sub_step_{level + 1}", lambda z, equations: self._sub_stepped(z, equations, level))

    def _sub_stepped(self, z: Fields, equations: StageEquations, level: int) -> Mapping[str, ca.SX]:
        S, L, h = self.grid.from_level(level), self.grid.first_of(level), self.steps(equations)
        interpolate = INTERPOLATIONS[self.options.slow_interpolation]
        known = at_sub_step(z, equations.h, Known(z["x"], z["d"] / h, z["a"]), self.grid, level, interpolate)
        t = z["t0"] + (z["n"] - 1) * equations.h[0] + z["s"]
        motion, a = self.motion(z, equations, known.q, t), known.q_ddot
        newton = velocity_dependent(self.model) and self.options.sub_step_velocity == "newton"
        for _ in range(self.options.newton_iterations if newton else 1):
            v = self._sub_step_velocity(known, a, h, S)
            M_hat_SS, force = rows(equations, level, motion, v, a[L])
            if newton:
                new = newton_step(M_hat_SS, force, equations.damping(motion, v)[S, S], a[S], h[S])
            else:
                new = solved_at_once(M_hat_SS, force)
            a = replaced(a, S, new)
        return self._next_cycle(z, equations, motion, self._sub_step_velocity(known, a, h, S), a, level)

    @staticmethod
    def _sub_step_velocity(known: Known, a: ca.SX, h: ca.SX, S: list[int]) -> ca.SX:
        """q_i_dot with (43) for q_S."""
        return replaced(known.half, S, velocity(known.half, a, h)[S])

    # ---- (9) next cycle -------------------------------------------------------------------------------------

    def _next_cycle(
        self, z: Fields, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX, a: ca.SX, level: int
    ) -> dict[str, ca.SX]:
        """Step (9): the groups from `level` on move by their own steps; slow ones keep where their step began."""
        members, s = self.grid.from_level(level), ca.SX(0) if level == 0 else z["s"]
        slow = [k for group in self.grid.groups[level:-1] for k in group]
        out = {
            **self.moved(z, equations, motion, v, a, members),
            "q_L": replaced(z["q_L"], slow, self.charts.zeroed(z["x"])[slow]),
            "q_L_dot": replaced(z["q_L_dot"], slow, v[slow]),
            "q_L_ddot": replaced(z["q_L_ddot"], slow, a[slow]),
            "t_L": replaced(
                z["t_L"], list(range(level, len(self.grid.groups))), ca.repmat(s, len(self.grid.groups), 1)
            ),
            "s": s + equations.h[-1],
        }
        return out if level > 0 else {**out, "n": z["n"] + 1}
