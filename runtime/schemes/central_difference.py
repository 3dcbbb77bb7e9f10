"""What `single_rate` and the paper's scheme share: central difference with closed loops, its start and observation.

Fields of z besides the common ones: d, the last increment q(t) - q(t - h), and a, the last q_i_ddot (differences.py);
loop_old and loop_dot, the loop unknowns a step of the fastest group ago and their rates.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.engine.program import Fields
from runtime.schemes.common_update import newton_step, solved_at_once
from runtime.schemes.differences import next_increment, replaced, velocity
from runtime.schemes.options import LARGE_SYSTEM, MOST_UNROLLED, ClosureOptions, Options, one_of, whole_number
from runtime.schemes.scheme import Scheme
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, velocity_dependent
from runtime.schemes.start_up import initial_acceleration, initial_increment
from runtime.schemes.state_fields import StateField, history, state
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

    @classmethod
    def limited(cls, options: Options) -> bool:
        """Yes: explicit."""
        return True

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
        begun = self.rebased(z, motion, z["loop"], members, x=z["x"])  # in the new chart the last turn d is what it was
        earlier = begun.pop("loop")
        out = {
            **begun,
            "d": replaced(z["d"], members, d[members]),
            "x": replaced(begun["x"], members, (begun["x"] + d)[members]),
            "a": replaced(z["a"], members, a[members]),
        }
        if equations.loops:
            now = equations.loop_part(motion.q_d)
            out["loop_old"], out["loop"] = earlier, self.charts.loops_from(now, motion.q_d, members)
            out["loop_dot"] = equations.loop_part(equations.rates(motion, v))
            out |= self.closed(z, motion)
        return out

    # ---- start-up and observation ---------------------------------------------------------------------------

    def start(self) -> ca.Function:
        """(t0, q_i, q_i_dot, loop unknowns, c) -> z (Eqs. 68-71)."""
        return self.start_function(self._started)

    def _started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> dict[str, ca.SX]:
        motion, h = equations.close_well(q_i, loop, t0), self.steps(equations)
        if self.by_tree:
            a = equations.tree_accelerations(motion, q_i_dot)
        else:
            a = initial_acceleration(*equations.condensed(motion, q_i_dot))
        now = equations.loop_part(motion.q_d)
        before = now - equations.h[-1] * equations.loop_part(equations.rates(motion, q_i_dot))
        return {"a": a, "d": initial_increment(q_i_dot, a, h), "loop": before, "loop_old": now}

    def observe(self) -> ca.Function:
        """(z, c) -> OBSERVED between two major steps."""
        return self.observe_function(self._observed)

    def _observed(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX, ca.SX]:
        h, a = self.steps(equations), z["a"]
        motion, half = self.motion(z, equations, z["x"], self.now(z, equations)), z["d"] / h
        for _ in range(OBSERVE_ITERATIONS if velocity_dependent(self.model) else 1):
            a = self._accelerations(equations, motion, velocity(half, a, h), a, self.solves_velocity)
        return motion, velocity(half, a, h), a
