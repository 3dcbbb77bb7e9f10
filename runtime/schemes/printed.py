"""The paper's sub-cycling: Fig. 5 in its order, for any number of nested groups (72).

    step of Fig. 5               Eqs.        here                        its equations in
    (6) start-up                 (68)-(71)   CentralDifference.start     central_difference.py
    (7) common update            (44)-(57)   Printed._common_update      central_difference.py
    (8) sub-steps                (58)-(67)   Printed._sub_step           printed.py
    (9) next cycle               (40)-(43)   Printed._next_cycle         central_difference.py

Fields of z besides those of central_difference.py: s, time since the start of the running major step; q_L, q_L_dot,
q_L_ddot and t_L, state of each slow coordinate and time since the start of the major step when its group's running
step began; x is then the value at the end of that step. unconverged: 1 until the sweep has converged; change: the
largest change of q_ddot of each group by the last sweep.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from runtime.contract.model import EmittedModel
from runtime.engine.program import Fields, Program, Repeat, Sequence, Until
from runtime.schemes.central_difference import (
    CentralDifference,
    CentralDifferenceOptions,
    allowed_change,
    newton_step,
    replaced,
    rounding_of_sweep,
    solved_at_once,
    starting_guess,
    sweep,
    velocity,
)
from runtime.schemes.options import MOST_ITERATIONS, Grid, one_of, tolerances, whole_number
from runtime.schemes.scheme import LARGEST_NUMBER, StateField, control, work
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, velocity_dependent

RUN_AWAY = 1e6  # increments [m or rad] of a step that were out of hand before the sweep


NAMES_OF_INTERPOLATIONS = ("end_point_sum", "constant_acceleration", "chord_ahead", "chord")


@dataclass(frozen=True)
class PrintedOptions(CentralDifferenceOptions):
    """closure_iterations, common_velocity, newton_iterations: see CentralDifferenceOptions.

    common_update: `fixed_point` is the sweep (52)-(55) with the test (56)-(57); `direct` solves (39) at once, with
        Newton on dQ_hat/dq_i_dot where forces depend on velocity.
    guess: `taylor` (50)-(51) or `previous` (48)-(49).
    slow_interpolation: how slow variables move during sub-steps, see INTERPOLATIONS; `auto` is `chord` where groups are
        coupled by stiffness alone, as in a structure with lumped mass: the other three grow there without damping; else
        `end_point_sum`, as printed.
    sub_step_velocity: `predictor` takes q_S_dot with the last acceleration (explicit, second order); `newton` solves
        (43) with the emitted Jacobian.
    eps: one tolerance per group, slow to fast (eps_L, eps_S); a single one serves all.
    stopping: `relative` compares the change of q(t + h) by a sweep with the group's largest h^2 q_ddot, so that
        small steps converge too; `absolute` is (56)-(57) as printed, in the coordinates' own unit.
    max_iterations: the most sweeps of a step.
    """

    common_update: str = one_of("fixed_point", "direct")
    guess: str = one_of("taylor", "previous")
    slow_interpolation: str = one_of("auto", *NAMES_OF_INTERPOLATIONS)
    sub_step_velocity: str = one_of("predictor", "newton")
    eps: tuple[float, ...] = tolerances(1e-13)
    stopping: str = one_of("relative", "absolute")
    max_iterations: int = whole_number(500, most=MOST_ITERATIONS)


def coupled_by_stiffness(model: EmittedModel) -> bool:
    """Is this a linear structure whose M_hat is diagonal?"""
    if any(coordinate.owner for coordinate in model.description.coordinates):
        return False
    kernel = model.kernel("condensed")
    M_hat = kernel.call([ca.SX.sym(name, shape) for name, shape in _inputs(kernel)])[kernel.index_out("M_hat")]
    return all(M_hat[i, j].is_zero() for i in range(M_hat.shape[0]) for j in range(M_hat.shape[1]) if i != j)


def _inputs(kernel: ca.Function) -> list[tuple[str, ca.Sparsity]]:
    return [(kernel.name_in(k), kernel.sparsity_in(k)) for k in range(kernel.n_in())]


class Printed(CentralDifference):
    """Major steps of the paper's scheme on one model and grid.

    References
    ----------
    J. C. Miao, P. Zhu, G. L. Shi and G. L. Chen, Study on sub-cycling algorithm for flexible multi-body system -
    integral
    theory and implementation flow chart, Computational Mechanics 41, 2008, 257-268, doi:10.1007/s00466-007-0183-9.
    """

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

    @cached_property
    def interpolation(self) -> str:
        """The reading of (13) and (63) that is taken: a name of INTERPOLATIONS."""
        chosen = self.options.slow_interpolation
        if chosen != "auto":
            return chosen
        return "chord" if coupled_by_stiffness(self.model) else "end_point_sum"

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
        changes = LARGEST_NUMBER * ca.SX.ones(len(self.grid.groups))
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
        settled = settled * (ca.sum1(ca.fabs(new)) < LARGEST_NUMBER)  # false for NaN, which a largest value hides
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
        interpolate = INTERPOLATIONS[self.interpolation]
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


# Step (8) of Fig. 5: the sub-steps j = 2 ... m of the fast coordinates, Eqs. (58)-(67).
#
# At a sub-step the slow coordinates are between their own steps. Their values there, (59)-(63), are readings of the
# paper (INTERPOLATIONS); with them (58) and (62) are (64),
#
#     M_hat_SS q_S_ddot = Q_hat_S - M_hat_SL q_L_ddot,
#
# the matrices being evaluated where (65)-(67) say: at the sub-step's own time, with the interpolated slow values.


@dataclass(frozen=True)
class Known:
    """What is known at the time of an update, n_i each: q_i, its rates (d / h of the fast ones) and accelerations."""

    q: ca.SX
    half: ca.SX
    q_ddot: ca.SX


def at_sub_step(z: Fields, h: ca.SX, known: Known, grid: Grid, level: int, interpolate: Interpolation) -> Known:
    """The values at a sub-step: slow coordinates by (59) and a reading of (60)-(61), (63), fast ones as known.

    z: fields q_L, q_L_dot, q_L_ddot (at the start of the running step of each group), t_L (when that was) and s (time
    since the start of the major step [s]). h: steps of the groups [s]. level: the first group that takes the sub-step.
    """
    q, v, a = ca.SX(known.q), ca.SX(known.half), ca.SX(known.q_ddot)
    for g in range(level):
        s = z["s"] - z["t_L"][g] if g else z["s"]  # the slowest group's step is the major step
        for k in grid.groups[g]:
            q[k], v[k] = interpolate(z["q_L"][k], z["q_L_dot"][k], z["q_L_ddot"][k], s, h[level], h[g], z["x"][k])
            a[k] = z["q_L_ddot"][k]  # (59)
    return Known(q, v, a)


def rows(
    equations: StageEquations, level: int, motion: ClosedConfiguration, q_i_dot: ca.SX, q_L_ddot: ca.SX
) -> tuple[ca.SX, ca.SX]:
    """(M_hat_SS, Q_hat_S - M_hat_SL q_L_ddot) of (58), (62), (64), evaluated as (65)-(67) say.

    For a linear structure that is (12), and (14) with the readings of (13).

    level: the first group of S, 0 the slowest. q_i_dot: n_i, q_L_ddot: n_L, known. Result: n_S x n_S and n_S [SI].
    """
    return equations.substep(level, motion, q_i_dot, q_L_ddot)


# Readings of how slow variables move inside their step (Eqs. 13, 59-63). Each is one named function.
#
# Arguments: the slow variable's q, q_dot, q_ddot at the start of its step, the time s since then, the sub-step h, its
# own step H and its value at the end of its step. Result: (q, q_dot) at s.

Interpolation = Callable[..., tuple[ca.SX, ca.SX]]


def end_point_sum(q: ca.SX, v: ca.SX, a: ca.SX, s: ca.SX, h: ca.SX, H: ca.SX, q_next: ca.SX) -> tuple[ca.SX, ca.SX]:
    """(60)-(61), (63) as printed: the velocity is summed at the end of each sub-step.

    At sub-step k this overshoots constant acceleration by k h^2 a / 2. q_L_dot(t + dt_L) is q_L_dot + dt_L q_L_ddot.
    """
    return q + s * v + (s * s + s * h) / 2 * a, v + s * a


def constant_acceleration(
    q: ca.SX, v: ca.SX, a: ca.SX, s: ca.SX, h: ca.SX, H: ca.SX, q_next: ca.SX
) -> tuple[ca.SX, ca.SX]:
    """Exact polynomial of (59): q + s v + s^2 a / 2."""
    return q + s * v + s * s / 2 * a, v + s * a


def chord_ahead(q: ca.SX, v: ca.SX, a: ca.SX, s: ca.SX, h: ca.SX, H: ca.SX, q_next: ca.SX) -> tuple[ca.SX, ca.SX]:
    """(13) as printed: linear in time, weighted j/m at time (j - 1) h, so one sub-step ahead."""
    weight = (s + h) / H
    return (1 - weight) * q + weight * q_next, (q_next - q) / H


def chord(q: ca.SX, v: ca.SX, a: ca.SX, s: ca.SX, h: ca.SX, H: ca.SX, q_next: ca.SX) -> tuple[ca.SX, ca.SX]:
    """(13) at the right time: linear between the two known values."""
    weight = s / H
    return (1 - weight) * q + weight * q_next, (q_next - q) / H


INTERPOLATIONS: dict[str, Interpolation] = dict(
    zip(NAMES_OF_INTERPOLATIONS, (end_point_sum, constant_acceleration, chord_ahead, chord), strict=True)
)
