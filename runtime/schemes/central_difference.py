"""What `single_rate` and the paper's scheme share: central difference with closed loops, its start and observation.

Central difference is Newmark's method with beta = 0, gamma = 1/2, also called Stormer-Verlet or leapfrog; symplectic
where the mass matrix is constant and forces depend on positions only.

Fields of z besides the common ones: d, the last increment q(t) - q(t - h), and a, the last q_i_ddot (differences.py);
loop_old and loop_dot, the loop unknowns a step of the fastest group ago and their rates.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.engine.program import Fields, Program
from runtime.schemes.options import LARGE_SYSTEM, MOST_UNROLLED, ClosureOptions, one_of, whole_number
from runtime.schemes.scheme import SUM_ROUNDING, Scheme, StateField, history, state
from runtime.schemes.sparse_lu import solve_general, solve_symmetric
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, velocity_dependent
from runtime.schemes.step_limit import StepLimit, central_difference_limit

OBSERVE_ITERATIONS = 2  # Newton steps, or sweeps from the predictor


@dataclass(frozen=True)
class CentralDifferenceOptions(ClosureOptions):
    """closure_iterations: Newton steps on the loop unknowns in each update.

    common_velocity: `newton` solves (41), (43) for q_dot with the emitted Jacobian, `predictor` takes the last q_ddot
        (explicit, second order); `auto` is newton up to LARGE_SYSTEM independent coordinates, predictor beyond.
    newton_iterations: Newton steps on q_dot in each update.
    """

    common_velocity: str = one_of("auto", "newton", "predictor")
    newton_iterations: int = whole_number(1, most=MOST_UNROLLED)


class CentralDifference(Scheme):
    """Central difference on a model and grid; a subclass is the program of its groups."""

    options: CentralDifferenceOptions

    def fields(self) -> dict[str, StateField]:
        """See the module's text."""
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        return {"d": history(n), "a": history(n), "loop_old": state(loops), "loop_dot": state(loops)}

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of central difference, with or without predicted velocities."""
        return central_difference_limit(A_q, A_v, predicted=self.predicts_velocity)

    def rates(self, z: np.ndarray) -> np.ndarray:
        """Increments over steps."""
        return np.asarray(z[self.layout.slice("d")] / self.step_sizes)

    def steps(self, equations: StageEquations) -> ca.SX:
        """Step of each coordinate, n_i [s]."""
        return ca.vertcat(*(equations.h[self.group_of(k)] for k in range(len(self.model.q_i))))

    @property
    def solves_velocity(self) -> bool:
        """Is q_dot of (41), (43) found by Newton where forces depend on it, rather than predicted?"""
        chosen = self.options.common_velocity
        wanted = chosen == "newton" or (chosen == "auto" and len(self.model.q_i) <= LARGE_SYSTEM)
        return wanted and velocity_dependent(self.model)

    @property
    def predicts_velocity(self) -> bool:
        """Does any force see a velocity that is not that of the step itself? Then damping limits the step."""
        return velocity_dependent(self.model) and not self.solves_velocity

    @property
    def by_tree(self) -> bool:
        """A large tree: its accelerations come from the O(N) elimination."""
        large = len(self.model.q_i) > LARGE_SYSTEM
        return large and self.model.has("forward_dynamics") and not self.solves_velocity

    # ---- one update -----------------------------------------------------------------------------------------

    def motion(self, z: Fields, equations: StageEquations, q_i: ca.SX, t: ca.SX) -> ClosedConfiguration:
        """Closure from a leapfrog guess of the loop unknowns: x(t - h) + 2 h x_dot(t), third order."""
        guess = z["loop_old"] + 2 * equations.h[-1] * z["loop_dot"]
        return equations.close(q_i, guess, t, self.options.closure_iterations)

    def solved(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX, ca.SX]:
        """(motion, q_i_dot, q_i_ddot) at time t, where (44)-(45) hold for all groups at once."""
        h = self.steps(equations)
        motion, half = self.motion(z, equations, z["x"], self.now(z, equations)), z["d"] / h
        a = z["a"]
        for _ in range(self.options.newton_iterations if self.solves_velocity else 1):
            a = self._accelerations(equations, motion, velocity(half, a, h), a, self.solves_velocity)
        return motion, velocity(half, a, h), a

    def _accelerations(
        self, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX, a: ca.SX, newton: bool
    ) -> ca.SX:
        """q_i_ddot of (39) with forces at v, or a Newton step from a on (41), (43) too."""
        if self.by_tree:
            return equations.tree_accelerations(motion, v)
        M_hat, Q_hat = equations.condensed(motion, v)
        if not newton:
            return solved_at_once(M_hat, Q_hat)
        return newton_step(M_hat, Q_hat, equations.damping(motion, v), a, self.steps(equations))

    def moved(
        self, z: Fields, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX, a: ca.SX, members: list[int]
    ) -> dict[str, ca.SX]:
        """x, d and a after `members` have made their own steps with the accelerations a, (40) and (42)."""
        d = next_increment(z["d"], a, self.steps(equations))
        restarted = self.rebased(
            z, motion, z["loop"], members, x=z["x"]
        )  # in the new chart the last turn d is what it was
        earlier = restarted.pop("loop")
        out = {
            **restarted,
            "d": replaced(z["d"], members, d[members]),
            "x": replaced(restarted["x"], members, (restarted["x"] + d)[members]),
            "a": replaced(z["a"], members, a[members]),
        }
        if equations.loops:
            now = equations.loop_part(motion.q_d)
            out["loop_old"], out["loop"] = earlier, self.charts.loops_from(now, motion.q_d, members)
            out["loop_dot"] = equations.loop_part(equations.rates(motion, v))
            out |= self.closed(z, motion)
        return out

    # ---- start-up and observation ---------------------------------------------------------------------------

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> dict[str, ca.SX]:
        """Eqs. (68)-(71)."""
        motion, h = equations.close_well(q_i, loop, t0), self.steps(equations)
        if self.by_tree:
            a = equations.tree_accelerations(motion, q_i_dot)
        else:
            a = initial_acceleration(*equations.condensed(motion, q_i_dot))
        now = equations.loop_part(motion.q_d)
        before = now - equations.h[-1] * equations.loop_part(equations.rates(motion, q_i_dot))
        return {"a": a, "d": initial_increment(q_i_dot, a, h), "loop": before, "loop_old": now}

    def observed(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX, ca.SX]:
        """Velocities and accelerations of (39)-(43) at the last position."""
        h, a = self.steps(equations), z["a"]
        motion, half = self.motion(z, equations, z["x"], self.now(z, equations)), z["d"] / h
        for _ in range(OBSERVE_ITERATIONS if velocity_dependent(self.model) else 1):
            a = self._accelerations(equations, motion, velocity(half, a, h), a, self.solves_velocity)
        return motion, velocity(half, a, h), a


# The central differences (40)-(43), on increments.
#
# With d = q(t) - q(t - h) and d_next = q(t + h) - q(t) they read
#
#     q_ddot(t) = (d_next - d) / h^2                                  (40), (42)
#     q_dot(t) = (d_next + d) / (2 h) = d / h + h q_ddot(t) / 2        (41), (43)
#
# Keeping d instead of q(t - h) is the same algorithm with less rounding. Every argument is a vector of coordinates
# [m or rad] or their rates; h [s] is a vector too, the step of each coordinate, or one step for all.


def velocity(half: ca.SX, q_ddot: ca.SX, h: ca.SX) -> ca.SX:
    """q_dot(t) of (41), (43), and of (5), (7), from `half` = d / h, the velocity at t - h / 2."""
    return half + h / 2 * q_ddot


def next_increment(d: ca.SX, q_ddot: ca.SX, h: ca.SX) -> ca.SX:
    """d_next = d + h^2 q_ddot(t): (40) and (42), as (4) and (6), solved for q(t + h)."""
    return d + h**2 * q_ddot


def replaced(vector: ca.SX, positions: list[int], values: ca.SX) -> ca.SX:
    """The vector with other values at some positions."""
    changed = ca.SX(vector)
    for position, k in enumerate(positions):
        changed[k] = values[position]
    return changed


# Step (6) of Fig. 5: start-up, Eqs. (68)-(71).


def initial_acceleration(M_hat: ca.SX, Q_hat: ca.SX) -> ca.SX:
    """q_i_ddot = M_hat^-1 Q_hat (68), of the state that a motion starts from.

    M_hat: n_i x n_i, Q_hat: n_i [SI]. Result: n_i [m/s^2 or rad/s^2].
    """
    return solve_symmetric(M_hat, Q_hat)


def initial_increment(q_i_dot: ca.SX, q_i_ddot: ca.SX, h: ca.SX) -> ca.SX:
    """d = q_i(t) - q_i(t - h) = h q_i_dot - h^2 / 2 q_i_ddot: (69), each group with its own step as (70), (71) say.

    q_i_dot, q_i_ddot: n_i; h: n_i [s], the step of each coordinate. Result: n_i [m or rad].
    """
    return h * q_i_dot - h**2 / 2 * q_i_ddot


# Step (7) of Fig. 5: the common update of all groups at time t, Eqs. (44)-(57).
#
# Unknown is q_i_ddot(t) instead of q_i(t + h); by (40), (42) that is the same. So (44)-(45) read
#
#     M_hat_LL q_L_ddot + M_hat_LS q_S_ddot = Q_hat_L,    M_hat_SL q_L_ddot + M_hat_SS q_S_ddot = Q_hat_S,
#
# which is (39). The paper solves it by a sweep between the groups, (46)-(57); `solved_at_once` and `newton_step` give
# what the sweep converges to. Vectors are n_i long [m/s^2 or rad/s^2] unless something else is said.

STALLED = 16  # a sweep wanders about by so many roundings of its terms


def starting_guess(reading: str, d: ca.SX, q_ddot: ca.SX, h: ca.SX) -> ca.SX:
    """What the sweep starts from, as an acceleration.

    `previous`: q(t + h) = q(t), (48)-(49), is q_ddot = -d / h^2. `taylor`: q(t + h) by (50)-(51) from q, q_dot and the
    last q_ddot. d: last increment [m or rad]; h: step of each coordinate [s].
    """
    return q_ddot if reading == "taylor" else -d / h**2


def sweep(M_hat: ca.SX, Q_hat: ca.SX, q_ddot: ca.SX, groups: list[list[int]]) -> ca.SX:
    """One sweep of (46)-(47): each group from the last iterate of the others, (52)-(53).

    The difference to q_ddot, times h^2, is the increment of the iterate, (54)-(55). M_hat: n_i x n_i, Q_hat: n_i [SI];
    groups: positions in q_i, slow to fast.
    """
    new = ca.SX(q_ddot)
    for group in groups:
        others = [k for k in range(q_ddot.numel()) if k not in group]
        force = Q_hat[group] - ca.mtimes(M_hat[group, others], q_ddot[others]) if others else Q_hat
        solved = solve_symmetric(M_hat[group, group], force)
        for position, k in enumerate(group):
            new[k] = solved[position]
    return new


def allowed_change(new: ca.SX, d: ca.SX, h: ca.SX, eps: float, stopping: str) -> ca.SX:
    """The change of q_ddot of a group by a sweep below which (56) or (57) stops; h^2 times it is that of q(t + h).

    new, d: the group's accelerations and last increments; h: its step [s]. stopping: `absolute` compares
    |q(t + h)_new - q(t + h)_old| with eps [m or rad] as printed, `relative` with eps h^2 |q_ddot|.
    """
    if stopping == "relative":
        # rounding of the increment d is below what a position can show
        return eps * ca.norm_inf(new) + SUM_ROUNDING / h**2 * ca.norm_inf(d)
    return ca.SX(eps / h**2)


def rounding_of_sweep(M_hat: ca.SX, q_ddot: ca.SX, q: ca.SX, h: ca.SX, group: list[int]) -> ca.SX:
    """What rounding of the coupling in (46)-(47), and of the positions, can leave of q_ddot of a group.

    A group whose accelerations pass through zero while the others' do not never meets a test relative to its own; once
    its change no longer falls and is below this, the sweep has arrived. q: n_i; h: the group's step [s].
    """
    others = [k for k in range(q_ddot.numel()) if k not in group]
    scale = ca.norm_inf(q[group]) / h**2
    if others:
        scale = scale + ca.norm_inf(ca.mtimes(M_hat[group, others], q_ddot[others]) / ca.diag(M_hat[group, group]))
    return STALLED * SUM_ROUNDING * scale


def solved_at_once(M_hat: ca.SX, force: ca.SX) -> ca.SX:
    """q_ddot of (44)-(45), forces known: the limit of the sweep. M_hat: n x n, force: n [SI].

    Without inertia coupling that is (10)-(11), and for one group (39) itself.
    """
    return solve_symmetric(M_hat, force)


def newton_step(M_hat: ca.SX, force: ca.SX, J: ca.SX, q_ddot: ca.SX, h: ca.SX) -> ca.SX:
    """q_ddot of (44)-(45) with the force at q_dot of (41), (43), which depends on q_ddot; one Newton step.

        (M_hat - J diag(h / 2)) q_ddot_new = Q_hat - J diag(h / 2) q_ddot,    J = dQ_hat/dq_i_dot

    M_hat, J: n x n, force: Q_hat at the last iterate, n [SI]; q_ddot: the last iterate, n; h: n [s].
    """
    half = ca.diag(h / 2)
    return solve_general(M_hat - ca.mtimes(J, half), force - ca.mtimes(J, ca.mtimes(half, q_ddot)))


# Central difference with one step for all coordinates: the paper's scheme without sub-steps, Eqs. (40)-(45).


class SingleRate(CentralDifference):
    """One stage: (44)-(45) solved at once, then all coordinates move.

    References
    ----------
    N. M. Newmark, A method of computation for structural dynamics, Journal of the Engineering Mechanics Division (ASCE)
    85 (3), 1959, 67-94: beta = 0, gamma = 1/2.
    """

    def program(self) -> Program:
        """One step."""
        return self.stage("common_update", self._step)

    def evaluations(self) -> tuple[int, int]:
        """One, or its Newton steps."""
        return self.options.newton_iterations if self.solves_velocity else 1, 0

    def _step(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        motion, v, a = self.solved(z, equations)
        everyone = list(range(len(self.model.q_i)))
        return {
            **self.moved(z, equations, motion, v, a, everyone),
            "n": z["n"] + 1,
        }
