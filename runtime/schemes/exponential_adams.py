"""Exponential Adams steps of order 4 on the stiff deflections, with a point in the middle: two evaluations a step.

A multistep method: accelerations of the last step are used again.

As those of exponential_rk4.py they follow the stiff deflections beside a polynomial, which here goes through what was
seen in the last step, too. With d for accelerations beside a_n and what the stiff part accounts for, half steps apart,

    Y2   to h/2, by the polynomial through d at the last start, at the last middle and 0 at this start,
    end  to h,   by the polynomial through these and d of Y2.

Such hybrid methods are Gragg and Stetter's (1964) and Butcher's (1965), exponential general linear methods those of
Ostermann, Thalhammer and Wright (2006). For q'' = -w^2 q the step is stable up to h w = 2 and its phase is off by
(h w)^4 / 190, after four evaluations of the classical method by (h w)^4 / 120. Decays are stable up to h d = 0.29, 0.62
where nothing else acts on the coordinate. Modes that are not resolved would feed on what is extrapolated; the
approximation lets them die out: by 2e-9, 2e-6 and 1e-3 a step at h w = 1, 2 and 4.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import factorial

import casadi as ca
import numpy as np

from runtime.engine.program import Fields, Program
from runtime.schemes.exponential_rk4 import krogstad
from runtime.schemes.linear_propagation import polynomial
from runtime.schemes.options import MOST_UNROLLED, ClosureOptions, whole_number
from runtime.schemes.scheme import Scheme, StateField, state
from runtime.schemes.stage_equations import StageEquations, stiff_directions
from runtime.schemes.step_limit import StepLimit, limit_beside_deflections
from runtime.schemes.stiff_motion import Along, MotionStage, StiffMotion

IMAGINARY_REACH, REAL_REACH = 2.0, 0.29  # h w and h d up to which the explicit part is stable
LAST_STEP_NODES = (-0.5, -1.0)  # where accelerations of the last step were seen, in steps from the start of this one
MIDDLE = 0.5


@dataclass(frozen=True)
class ExponentialAdamsOptions(ClosureOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation, from a guess that is right to h^4."""

    closure_iterations: int = whole_number(1, most=MOST_UNROLLED)


def through(nodes: Sequence[float], values: Sequence[Along], h: ca.SX) -> list[Along]:
    """b_1, b_2, ... of the polynomial sum_k b_k tau^k / k! through 0 at 0 and values at nodes [in h]."""
    powers = range(1, 1 + len(nodes))
    weights = np.linalg.inv([[node**power / factorial(power) for power in powers] for node in nodes])
    found: list[Along] = []
    for row, power in zip(weights, powers, strict=True):
        total = values[0] * (float(row[0]) / h**power)
        for weight, one in zip(row[1:], values[1:], strict=True):
            total = total + one * (float(weight) / h**power)
        found.append(total)
    return found


class ExponentialAdams(Scheme):
    """Two evaluations a step in one stage. a_middle, a_before: accelerations seen in the middle and at the start of the
    last step, those of turns as second rates in the charts at its end; s_*, s_*_dot: the deflections there and their
    rates; loop_third: third rate of the loop unknowns.

    References
    ----------
    W. B. Gragg and H. J. Stetter, Generalized multistep predictor-corrector methods, Journal of the ACM 11 (2), 1964,
    188-209.
    J. C. Butcher, A modified multistep method for the numerical integration of ordinary differential equations, Journal
    of the ACM 12 (1), 1965, 124-135.
    A. Ostermann, M. Thalhammer and W. M. Wright, A class of explicit exponential general linear methods, BIT Numerical
    Mathematics 46 (2), 2006, 409-431.
    """

    options: ExponentialAdamsOptions
    order, damps = 4, True

    def evaluations(self) -> tuple[int, int]:
        """Two."""
        return 2, 0

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of the explicit part, for the motion in which the stiff deflections follow as in equilibrium."""
        return limit_beside_deflections(A_q, A_v, stiff_directions(self.model), IMAGINARY_REACH, REAL_REACH)

    def fields(self) -> dict[str, StateField]:
        """See above."""
        n, n_s = stiff_directions(self.model).shape
        sizes = {
            "a_middle": n,
            "a_before": n,
            **dict.fromkeys(("s_middle", "s_middle_dot", "s_before", "s_before_dot"), n_s),
            "loop_third": len(self.model.loop_unknowns),
        }
        return {**super().fields(), **{name: state(size) for name, size in sizes.items()}}

    def program(self) -> Program:
        """One stage."""
        return self.stage("exponential_adams", self._step)

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """What the polynomial of a step of order 4 says of times before the start: loads may have jumped there."""
        fields, h = super().started(t0, q_i, q_i_dot, loop, equations), equations.h[0]
        start = equations.close_well(q_i, loop, t0)
        found = equations.stiff_response(start, q_i_dot)
        motion = StiffMotion(q_i, q_i_dot, found, h)

        def d(stage: MotionStage) -> Along:
            at = equations.close_well(stage.q, fields["loop"], t0 + stage.tau)
            return motion.remainder(equations.chart_accelerations(at, stage.v), stage)

        first = krogstad(motion, d)
        s, s_dot = (ca.mtimes(found.B.T, one) for one in (q_i, q_i_dot))
        out = {"s_middle": s, "s_before": s, "s_middle_dot": s_dot, "s_before_dot": s_dot}
        for name, share in zip(("a_middle", "a_before"), LAST_STEP_NODES, strict=True):
            out[name] = polynomial([found.a, first.b1, first.b2], share * h)
        return {**fields, **out}

    def _step(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h, t, x, v = equations.h[0], self.now(z, equations), z["x"], z["v"]
        start = equations.close(x, z["loop"], t, self.options.closure_iterations)
        found = equations.stiff_response(start, v)
        motion = StiffMotion(x, v, found, h, decaying=True)
        s, s_dot = (ca.mtimes(found.B.T, one) for one in (x, v))

        def resolved(when: str) -> Along:
            return motion.resolved(z[f"a_{when}"], z[f"s_{when}"] - s, z[f"s_{when}_dot"] - s_dot)

        last = [resolved("middle"), resolved("before")]
        there = motion.to(1, *through(LAST_STEP_NODES, last, h))
        loop = [
            equations.loop_part(start.q_d),
            equations.loop_part(equations.rates(start, v)),
            equations.loop_accelerations(start, v, found.a),
        ]
        guess = polynomial([*loop, z["loop_third"]], there.tau)
        middle = equations.close(there.q, guess, t + there.tau, self.options.closure_iterations)
        v_there = equations.velocities(middle, there.v)
        a = equations.accelerations(middle, v_there)
        a_chart = equations.coordinate_accelerations(middle, there.v, v_there, a)
        end = motion.to(2, *through((*LAST_STEP_NODES, MIDDLE), [*last, motion.remainder(a_chart, there)], h))
        third = (equations.loop_part(middle.q_d) - polynomial(loop, there.tau)) * (factorial(3) / there.tau**3)
        ahead = polynomial([*loop, third], h)
        at = self.arrived(equations, end.q, ahead, t + h)
        remembered = {
            "a_middle": equations.accelerations_from(at, middle, v_there, a),
            "a_before": equations.accelerations_from(at, start, v, found.a),
            "s_middle": ca.mtimes(found.B.T, there.q),
            "s_middle_dot": ca.mtimes(found.B.T, there.v),
            "s_before": s,
            "s_before_dot": s_dot,
            "loop_third": third,
        }
        ends = {**self.rebased(z, at, ahead), "v": equations.velocities(at, end.v), "n": z["n"] + 1}
        return {**ends, **remembered, **self.closed(z, start, middle)}
