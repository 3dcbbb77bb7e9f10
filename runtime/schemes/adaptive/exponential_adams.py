"""Exponential Adams steps of order 4 on the stiff deflections, to a tolerance: steps of one length, found by trials.

The steps are those of runtime/schemes/exponential_adams.py. What the last one saw lies p behind, its length, which is
another one before a time that no step crosses. With d_m, d_b seen p/2 and p before a start and d_h at h/2 after it,
the polynomial b1 tau + b2 tau^2/2 + b3 tau^3/6 through them has

    b1 = (d_b - 4 d_m) / p + c p^2 / 2,   b2 = 4 (d_b - 2 d_m) / p^2 + 3 c p,   b3 = 6 c,

c = 0 without d_h, and else what is missing there over h/2 (h/2 + p/2) (h/2 + p). At such a time, and at the start, a
step of order 4 says what would have been seen before: nothing that may have jumped is asked for. The estimate is the
end less where the polynomial without d_h leads; it serves what is said of a run, not the lengths of its steps.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from runtime.contract.model import Model
from runtime.engine.program import Fields, Program, Until
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.exponential_rk4 import krogstad
from runtime.schemes.grid import Grid
from runtime.schemes.linear_propagation import polynomial
from runtime.schemes.method import Attempt
from runtime.schemes.options import SchemeError
from runtime.schemes.remembering_step import ExponentialAdamsOptions, loops_ahead
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.state_fields import StateField, state
from runtime.schemes.stiff_deflections import StiffResponse
from runtime.schemes.stiff_motion import Along, MotionStage, StiffMotion

LAST = (("middle", -0.5), ("before", -1.0))  # where accelerations of the last step were seen, in steps from its end


class AdaptiveExponentialAdams(AdaptiveSteps):
    """One evaluation at the start of a step, one more an attempt. a_*, s_*, s_*_dot: what the last step saw in its
    middle and at its start; a_there, s_there, ...: what this one has seen in its middle; behind: length of that [s].
    """

    options: ExponentialAdamsOptions
    order, error_order, counted_evaluations = 4, 4, (1, 1)
    strictness = 1.5
    varies = False
    carried = ("q_from", "v_from", "t_from", "a_from", "a_there", "s_there", "s_there_dot", "third_there")

    def __init__(self, model: Model, grid: Grid, options: ExponentialAdamsOptions) -> None:
        super().__init__(model, grid, options)
        if self.charts.size:
            raise SchemeError(
                "exponential_adams", "goes to a tolerance where no body turns freely in space", "take exponential_rk4"
            )
        if self.options.linearisation == "jacobian":
            raise SchemeError(
                "linearisation", "is that of the stiffness where a tolerance is given", "leave it out, or give dt"
            )
        if self.error_of == "step":
            raise SchemeError(
                "error_of", "exponential_adams takes steps of one length", "leave it out, or take exponential_rk4"
            )

    def method_fields(self) -> dict[str, StateField]:
        """What is evaluated at the start, what was seen before it and in the middle, and the polynomial."""
        n, n_s = StageEquations(self.model, ca.SX.zeros(self.model.c_size + 1)).deflections().B.shape
        loops = len(self.model.loop_unknowns)
        sizes = {"X": n * n_s, "behind": 1, "restart": 1, "loop_third": loops, "third_there": loops}
        for when in ("middle", "before", "there"):
            sizes |= {f"a_{when}": n, f"s_{when}": n_s, f"s_{when}_dot": n_s}
        sizes |= dict.fromkeys(("loop_dot", "loop_bend"), loops) | dict.fromkeys(("b1", "b2", "b3"), n)
        return {name: state(size) for name, size in sizes.items()}

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """Nothing was seen before."""
        return {**super().started(t0, q_i, q_i_dot, loop, equations), "restart": ca.SX(1), "behind": ca.SX(1)}

    def after_begin(self) -> tuple[Program, ...]:
        """Where nothing was seen before the start."""
        return (Until(self.stage("restart", self._restart), self.layout.slice("restart").start, 1, usual=0),)

    def moved(self, z: Fields) -> Mapping[str, ca.SX]:
        """What the last step saw."""
        B_T = StageEquations(self.model, ca.SX.zeros(self.model.c_size + 1)).deflections().B.T
        return {
            **{f"{name}_middle{end}": z[f"{name}_there{end}"] for name, end in (("a", ""), ("s", ""), ("s", "_dot"))},
            "a_before": z["a_from"],
            "s_before": ca.mtimes(B_T, z["q_from"]),
            "s_before_dot": ca.mtimes(B_T, z["v_from"]),
            "behind": z["t_to"] - z["t_from"],
            "loop_third": z["third_there"],
        }

    def begun(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX, Mapping[str, ca.SX]]:
        """Accelerations, and what forces along the stiff deflections do."""
        t, v = self.time_in_step(z, ca.SX(0), 0), z["v_from"]
        start = equations.close(z["q_from"], z["loop_from"], t, self.options.closure_iterations)
        found = equations.stiff_response(start, v)
        rates = equations.loop_part(equations.rates(start, v))
        bends = equations.loop_accelerations(start, v, found.a)
        return start, found.a, {"loop_dot": rates, "loop_bend": bends, "X": ca.vec(ca.densify(found.X))}

    def _restart(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """What the polynomial of a step of order 4 says of times before the start."""
        h = z["h_try"]
        motion = self._motion(z, equations, h, decaying=False)

        def d(stage: MotionStage) -> Along:
            t = z["t_from"] + z["beside"] + stage.tau * (1 - 2 * z["beside"] / h)
            return motion.remainder(
                equations.accelerations(equations.close_well(stage.q, z["loop_from"], t), stage.v), stage
            )

        first = krogstad(motion, d)
        s, s_dot = (ca.mtimes(motion.B.T, one) for one in (z["q_from"], z["v_from"]))
        out = {"restart": ca.SX(0), "behind": h, "loop_third": 0 * z["loop_third"]}
        for when, share in LAST:
            out |= {f"s_{when}": s, f"s_{when}_dot": s_dot}
            out[f"a_{when}"] = polynomial([z["a_from"], first.b1, first.b2], share * h)
        return out

    def attempted(self, z: Fields, equations: StageEquations, h: ca.SX) -> Attempt:
        """One evaluation, in the middle."""
        motion = self._motion(z, equations, h)
        s, s_dot = (ca.mtimes(motion.B.T, one) for one in (z["q_from"], z["v_from"]))
        d_m, d_b = (motion.seen(z[f"a_{w}"], z[f"s_{w}"] - s, z[f"s_{w}_dot"] - s_dot) for w, _ in LAST)
        p = z["behind"]
        b1, b2 = (d_b + d_m * ca.SX(-4)) * (1 / p), (d_b + d_m * ca.SX(-2)) * (4 / (p * p))
        there, tau = motion.to(1, b1, b2), h / 2
        loop = [z["loop_from"], z["loop_dot"], z["loop_bend"]]
        guess = polynomial([*loop, z["loop_third"]], tau)
        middle = equations.close(there.q, guess, self.time_in_step(z, h, 0.5), self.options.closure_iterations)
        a = equations.accelerations(middle, there.v)
        missing = motion.remainder(a, there) + b1 * -tau + b2 * (-tau * tau / 2)
        c = missing * (1 / (tau * (tau + p / 2) * (tau + p)))
        found = (b1 + c * (p * p / 2), b2 + c * (3 * p), c * ca.SX(6))
        end, rough = motion.to(2, *found), motion.to(2, b1, b2)
        ahead, third = loops_ahead(loop, equations.loop_part(middle.q_d), tau, h)
        kept = {f"b{k}": motion.all_of(one) for k, one in enumerate(found, start=1)}
        kept |= {"a_there": a, "s_there": ca.mtimes(motion.B.T, there.q), "s_there_dot": ca.mtimes(motion.B.T, there.v)}
        kept["third_there"] = third
        return Attempt(end.q, end.v, ahead, end.q - rough.q, end.v - rough.v, kept, (middle,))

    def between(self, z: Fields, equations: StageEquations, tau: ca.SX, h: ca.SX | None = None) -> tuple[ca.SX, ca.SX]:
        """The same motion, ended sooner."""
        motion = self._motion(z, equations, tau)
        stage = motion.to(2, *(motion.beside(z[f"b{k}"]) for k in (1, 2, 3)))
        return stage.q, stage.v

    def _motion(self, z: Fields, equations: StageEquations, h: ca.SX, decaying: bool = True) -> StiffMotion:
        stiff = equations.deflections()
        n, n_s = stiff.B.shape
        found = StiffResponse(stiff.B, stiff.K, stiff.D, z["a_from"], ca.reshape(z["X"], n, n_s))
        return StiffMotion(z["q_from"], z["v_from"], found, h, decaying=decaying)
