"""Exponential Runge-Kutta steps of order 4 on the stiff deflections, as long as a tolerance asks for.

The stages are those of runtime/schemes/exponential_rk4.py. The error estimate is nearly free: the end less Y4,
which follows the stiff part in one sub-step that damps where the end takes two, so that it sees modes that are not
resolved. A rejected step keeps a_n, X and the tangent. The polynomial a_n + b1 tau + b2 tau^2/2 that leads to the end
leads to any time before it, with an error of h^4 in q_i_dot.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from runtime.engine.program import Fields
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps, Attempt
from runtime.schemes.exponential_rk4 import (
    ExponentialRungeKuttaOptions,
    along_tree,
    krogstad,
    motion_along_tree,
    tangent_of,
)
from runtime.schemes.linear_propagation import polynomial
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.state_fields import StateField, state
from runtime.schemes.stiff_deflections import StiffResponse
from runtime.schemes.stiff_motion import Along, MotionStage, StiffMotion
from runtime.schemes.stiff_tree_motion import StiffTreeMotion


class AdaptiveExponentialRungeKutta(AdaptiveSteps):
    """One evaluation at the start of a step, three more an attempt."""

    options: ExponentialRungeKuttaOptions
    order, error_order, counted_evaluations = 4, 4, (1, 3)
    strictness = 1.5

    def method_fields(self) -> dict[str, StateField]:
        """X = M_hat^-1 B, the polynomial of the accelerations, rates of the loop unknowns, and the tangent."""
        n, n_s = StageEquations(self.model, ca.SX.zeros(self.model.c_size + 1)).deflections().B.shape
        n_s = 0 if along_tree(self.model, self.options) else n_s
        tangent = {"A": n * n_s, "A_v": n * n_s} if self.options.linearisation == "tangent" and n_s else {}
        sizes = {
            "X": n * n_s,
            **tangent,
            **dict.fromkeys(("loop_dot", "loop_bend"), len(self.model.loop_unknowns)),
            "b1": n,
            "b2": n,
        }
        return {name: state(size) for name, size in sizes.items()}

    def begun(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX, Mapping[str, ca.SX]]:
        """Accelerations, and what forces along the stiff deflections do."""
        t = self.time_in_step(z, ca.SX(0), 0)
        start = equations.close(z["q_from"], z["loop_from"], t, self.options.closure_iterations)
        rates = equations.loop_part(equations.rates(start, z["v_from"]))
        if along_tree(self.model, self.options):
            return start, equations.accelerations(start, z["v_from"]), {"loop_dot": rates, "loop_bend": rates}  # none
        found = equations.stiff_response(start, z["v_from"])
        bends = equations.loop_accelerations(start, z["v_from"], found.a)
        fields = {"loop_dot": rates, "loop_bend": bends, "X": ca.vec(ca.densify(found.X))}
        tangent = tangent_of(self.options, equations, start, z["v_from"], found)
        if tangent is not None:
            fields |= {"A": ca.vec(tangent[0]), "A_v": ca.vec(tangent[1])}
        return start, found.a, fields

    def attempted(self, z: Fields, equations: StageEquations, h: ca.SX) -> Attempt:
        """Three evaluations."""
        motion = self._motion(z, equations, h)
        seen: list[ClosedConfiguration] = []

        def d(stage: MotionStage) -> Along:
            share = (0.5, 0.5, 1.0)[len(seen)]
            guess = polynomial([z["loop_from"], z["loop_dot"], z["loop_bend"]], stage.tau)
            at = equations.close(stage.q, guess, self.time_in_step(z, h, share), self.options.closure_iterations)
            seen.append(at)
            v = equations.velocities(at, stage.v)
            a = equations.accelerations(at, v)
            return motion.remainder(equations.bent(at, stage.v, v, a), stage)

        found = krogstad(motion, d, rough=True)
        kept = {"b1": found.b1, "b2": found.b2}
        end, loop = found.end, equations.loop_part(seen[-1].q_d)
        v = self.velocities_at(z, equations, h, end.q, end.v)
        return Attempt(end.q, v, loop, end.q - found.before.q, end.v - found.before.v, kept, tuple(seen))

    def between(self, z: Fields, equations: StageEquations, tau: ca.SX, h: ca.SX | None = None) -> tuple[ca.SX, ca.SX]:
        """The same motion, ended sooner."""
        motion = self._motion(z, equations, tau)
        stage = motion.to(2, motion.beside(z["b1"]), motion.beside(z["b2"]))
        return stage.q, self.velocities_at(z, equations, tau, stage.q, stage.v)

    def _motion(self, z: Fields, equations: StageEquations, h: ca.SX) -> StiffMotion | StiffTreeMotion:
        if along_tree(self.model, self.options):
            t = self.time_in_step(z, ca.SX(0), 0)
            start = equations.close(z["q_from"], z["loop_from"], t, self.options.closure_iterations)
            return motion_along_tree(equations, start, z["q_from"], z["v_from"], z["a_from"], h)
        stiff = equations.deflections()
        n, n_s = stiff.B.shape
        found = StiffResponse(stiff.B, stiff.K, stiff.D, z["a_from"], ca.reshape(z["X"], n, n_s))
        tangent = (ca.reshape(z["A"], n, n_s), ca.reshape(z["A_v"], n, n_s)) if "A" in z else None
        return StiffMotion(z["q_from"], z["v_from"], found, h, tangent, halves=tangent is not None)
