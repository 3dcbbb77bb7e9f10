"""Exponential Adams steps of order 4 on the stiff deflections, with a point in the middle: two evaluations a step.

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
from dataclasses import dataclass, replace
from math import factorial
from typing import Any, TypeVar

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.engine.choose import operations_per_step
from runtime.engine.program import Fields, Program
from runtime.schemes.charts import Charts
from runtime.schemes.exponential import NODES
from runtime.schemes.exponential_rk4 import krogstad
from runtime.schemes.linear_propagation import Factors, LinearSystem, factors_of, polynomial, propagate
from runtime.schemes.one_step import OneStep
from runtime.schemes.options import MOST_UNROLLED, ClosureOptions, Grid, Options, SchemeError, one_of, whole_number
from runtime.schemes.partial_fractions import poles
from runtime.schemes.scheme import Scheme, StateField, state
from runtime.schemes.sparse_lu import solve_symmetric
from runtime.schemes.stage_equations import LONG_TREE, ClosedConfiguration, StageEquations, stiff_directions
from runtime.schemes.step_limit import StepLimit, limit_beside_deflections
from runtime.schemes.stiff_motion import WHOLE_DEGREE, Along, MotionStage, StiffMotion

# What one-step schemes share that remember what their last step saw, the loop unknowns included.

Vector = TypeVar("Vector", ca.SX, Along)


@dataclass(frozen=True)
class ExponentialAdamsOptions(ClosureOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation, from a guess that is right to h^4.

    linearisation: what is followed by exponentials: `stiffness`, the constant K and D of the stiff deflections, or
        `jacobian`, the Jacobian of all coordinates at the start of the step; `auto` takes the latter where a step
        with it is hardly longer, by their operations.
    """

    closure_iterations: int = whole_number(1, most=MOST_UNROLLED)
    linearisation: str = one_of("auto", "stiffness", "jacobian")


class RememberingStep(OneStep):
    """Field loop_third: third rates of the loop unknowns, as the last step found them."""

    options: ExponentialAdamsOptions
    damps = True

    def further_fields(self) -> dict[str, StateField]:
        """See above."""
        return {"loop_third": state(len(self.model.loop_unknowns))}

    def evaluations(self) -> tuple[int, int]:
        """Two."""
        return 2, 0

    def loop_motion(
        self, equations: StageEquations, start: ClosedConfiguration, v: ca.SX, a: ca.SX
    ) -> tuple[ca.SX, ca.SX, ca.SX]:
        """The loop unknowns at the start of a step, their rates and second rates."""
        rates = equations.loop_part(equations.rates(start, v))
        return equations.loop_part(start.q_d), rates, equations.loop_accelerations(start, v, a)


def loops_ahead(motion: Sequence[ca.SX], seen: ca.SX, tau: ca.SX, h: ca.SX) -> tuple[ca.SX, ca.SX]:
    """The loop unknowns at the end of a step, and their third rates, of the cubic that leads to `seen` at tau."""
    third = (seen - polynomial(motion, tau)) * (factorial(3) / tau**3)
    return polynomial([*motion, third], h), third


def bends(nodes: Sequence[float], values: Sequence[Vector], h: ca.SX, first: int) -> list[Vector]:
    """b_k, k = first, first + 1, ..., of the polynomial sum_k b_k tau^k / k! through values at nodes [in h]."""
    powers = range(first, first + len(nodes))
    weights: Any = (
        np.linalg.inv([[node**power / factorial(power) for power in powers] for node in nodes]) if nodes else []
    )
    found: list[Vector] = []
    for row, power in zip(weights, powers, strict=True):
        total = values[0] * (float(row[0]) / h**power)
        for weight, one in zip(row[1:], values[1:], strict=True):
            total = total + one * (float(weight) / h**power)
        found.append(total)
    return found


# Exponential Rosenbrock steps with what the last step saw: one Jacobian and two evaluations a step, order 4.
#
# As in exponential.py D is what forces at a state are beside the linear system of the start of a step, where D is 0
# with its first derivative. Seen from there, what the last step began with gives D(-h) for products of matrices and
# vectors.
#
#     Y    to 5/6 h, by G2 of the parabola through D(-h),
#     end  to h,     by G2 and G3 of the cubic through D(-h) and D of Y.
#
# With Y at c h the cubic leaves D4 tau^2 (tau + h) (tau - c h) / 24 of D, D4 its fourth derivative. The mean of that
# over a step, by which motion that the step resolves is off, is zero for c = 27/35 and -D4 h^4 / 665 for 5/6; decays
# that are much faster than the step see the end of it, where less is left the nearer c is to 1. To 1e-3 5/6 takes a
# tenth fewer steps than 27/35 with an overdamped joint, and no more than 9/10 with slider-cranks. Nothing linear is
# remembered: of a linear system D is zero, and the step is the rational approximation of all of it by which
# exponential_adams.py follows stiff deflections.

NODE = 5 / 6  # where the second evaluation is, in steps
BENDS = 2  # the first power of the time in D


@dataclass(frozen=True)
class LinearMotion:
    """Motions over parts of a step h from velocities v, with a there and forces G0 + G1 tau beside what is linear."""

    system: LinearSystem
    factors: Factors
    v: ca.SX
    a: ca.SX
    G0: ca.SX
    G1: ca.SX
    h: ca.SX

    @classmethod
    def at(cls, equations: StageEquations, start: ClosedConfiguration, v: ca.SX, h: ca.SX) -> LinearMotion:
        """Linearised at a configuration and velocities."""
        found = equations.linearised(start, v)
        system = LinearSystem(found.M_hat, found.J_q, found.J_v)
        G0, G1 = found.Q_hat - ca.mtimes(found.J_v, v), equations.force_rate(start, v, found.a)
        shifts = tuple(pole.r for pole in poles(WHOLE_DEGREE, decaying=True))
        return cls(system, factors_of(system, h, shifts), v, found.a, G0, G1, h)

    def to(self, part: float, *D: ca.SX) -> tuple[ca.SX, ca.SX]:
        """(w, w') after a part of the step with D[0] tau^2 / 2 + D[1] tau^3 / 6 + ... added to the forces."""
        forces, zero = (self.G0, self.G1, *D), ca.SX.zeros(self.v.numel())
        system, v = self.system, self.v
        return propagate(
            system, self.factors, zero, v, forces, ca.SX(0), self.h, part, decaying=True, degree=WHOLE_DEGREE
        )

    def linear(self, part: float, w: ca.SX, u: ca.SX) -> ca.SX:
        """The linear system's forces after a part of the step."""
        changing = ca.mtimes(self.system.J_q, w) + ca.mtimes(self.system.J_v, u)
        return polynomial([self.G0, self.G1], part * self.h) + changing

    def beside(self, a: ca.SX, part: float, w: ca.SX, u: ca.SX) -> ca.SX:
        """D of accelerations a there."""
        return ca.mtimes(self.system.M, a) - self.linear(part, w, u)


class RosenbrockAdams(RememberingStep):
    """Two evaluations and a Jacobian in one stage. a_before, q_before, v_before: accelerations, coordinates and rates
    at the start of the last step.
    """

    order = 4
    takes_jacobian = True

    def __init__(self, model: Model, grid: Grid, options: ExponentialAdamsOptions) -> None:
        if not self.possible(model):
            raise SchemeError(
                f"linearisation = 'jacobian' takes the Jacobian of up to {LONG_TREE} independent coordinates, turns in "
                f"space not among them, and {model.name} has other ones; take 'stiffness', or scheme exponential"
            )
        super().__init__(model, grid, options)

    @staticmethod
    def possible(model: Model) -> bool:
        """Has the model a Jacobian, of few coordinates, and no turns, which have other components in each step?"""
        return model.has("residual_jacobian") and len(model.q_i) <= LONG_TREE and not Charts(model).size

    def further_fields(self) -> dict[str, StateField]:
        """See above."""
        sizes = dict.fromkeys(("q_before", "v_before", "a_before"), len(self.model.q_i))
        return {**super().further_fields(), **{name: state(size) for name, size in sizes.items()}}

    def program(self) -> Program:
        """One stage."""
        return self.stage("rosenbrock_adams", self._step)

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """What the polynomial of a step of exprb53s3 says of h before the start: loads may have jumped there."""
        fields, h = super().started(t0, q_i, q_i_dot, loop, equations), equations.h[0]
        motion = LinearMotion.at(equations, equations.close_well(q_i, loop, t0), q_i_dot, h)
        nodes, seen = NODES[5], list[ca.SX]()
        for k, node in enumerate(nodes):
            w, u = motion.to(node, *bends(nodes[:k], seen, h, BENDS))
            there = equations.close_well(q_i + w, fields["loop"], t0 + node * h)
            seen.append(motion.beside(equations.accelerations(there, u), node, w, u))
        nothing = ca.SX.zeros(q_i.numel())
        D = polynomial([nothing, nothing, *bends(nodes, seen, h, BENDS)], -h)
        before = solve_symmetric(motion.system.M, motion.linear(-1, nothing, q_i_dot) + D)
        return {**fields, "q_before": q_i, "v_before": q_i_dot, "a_before": before}

    def _step(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h, t, x, v, iterations = equations.h[0], self.now(z, equations), z["x"], z["v"], self.options.closure_iterations
        start = equations.close(x, z["loop"], t, iterations)
        motion = LinearMotion.at(equations, start, v, h)
        last = motion.beside(z["a_before"], -1, z["q_before"] - x, z["v_before"])
        w, u = motion.to(NODE, *bends((-1,), [last], h, BENDS))
        tau, loop = NODE * h, self.loop_motion(equations, start, v, motion.a)
        there = equations.close(x + w, polynomial([*loop, z["loop_third"]], tau), t + tau, iterations)
        D = motion.beside(equations.accelerations(there, u), NODE, w, u)
        end, v_end = motion.to(1, *bends((-1, NODE), [last, D], h, BENDS))
        ahead, third = loops_ahead(loop, equations.loop_part(there.q_d), tau, h)
        return {
            "x": x + end,
            "v": v_end,
            "loop": ahead,
            "loop_third": third,
            "n": z["n"] + 1,
            "q_before": x,
            "v_before": v,
            "a_before": motion.a,
            **self.closed(z, start, there),
        }


IMAGINARY_REACH, REAL_REACH = 2.0, 0.29  # h w and h d up to which the explicit part is stable
LAST = (-0.5, -1.0)  # where accelerations of the last step were seen, in steps from the start of this one
MIDDLE = 0.5
WORTH = 1.2  # a step with the Jacobian is taken up to so many times the operations of one with the stiffness


class ExponentialAdams(RememberingStep):
    """Two evaluations a step in one stage. a_middle, a_before: accelerations seen in the middle and at the start of the
    last step, those of turns as second rates in the charts at its end; s_*, s_*_dot: the deflections there and their
    rates; loop_third: third rate of the loop unknowns.
    """

    order = 4

    @classmethod
    def limited(cls, options: Options) -> bool:
        """Yes, by what is not a stiff deflection."""
        return True

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of the explicit part, for the motion in which the stiff deflections follow as in equilibrium."""
        return limit_beside_deflections(A_q, A_v, stiff_directions(self.model), IMAGINARY_REACH, REAL_REACH)

    def further_fields(self) -> dict[str, StateField]:
        """See above."""
        n, n_s = stiff_directions(self.model).shape
        sizes = {
            "a_middle": n,
            "a_before": n,
            **dict.fromkeys(("s_middle", "s_middle_dot", "s_before", "s_before_dot"), n_s),
        }
        return {**super().further_fields(), **{name: state(size) for name, size in sizes.items()}}

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
        for name, share in zip(("a_middle", "a_before"), LAST, strict=True):
            out[name] = polynomial([found.a, first.b1, first.b2], share * h)
        return {**fields, **out}

    def _step(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h, t, x, v = equations.h[0], self.now(z, equations), z["x"], z["v"]
        start = equations.close(x, z["loop"], t, self.options.closure_iterations)
        found = equations.stiff_response(start, v)
        motion = StiffMotion(x, v, found, h, decaying=True)
        s, s_dot = (ca.mtimes(found.B.T, one) for one in (x, v))

        def seen(when: str) -> Along:
            return motion.seen(z[f"a_{when}"], z[f"s_{when}"] - s, z[f"s_{when}_dot"] - s_dot)

        last = [seen("middle"), seen("before")]
        there = motion.to(1, *bends(LAST, last, h, 1))
        loop = self.loop_motion(equations, start, v, found.a)
        guess = polynomial([*loop, z["loop_third"]], there.tau)
        middle = equations.close(there.q, guess, t + there.tau, self.options.closure_iterations)
        v_there = equations.velocities(middle, there.v)
        a = equations.accelerations(middle, v_there)
        bent = equations.bent(middle, there.v, v_there, a)
        end = motion.to(2, *bends((*LAST, MIDDLE), [*last, motion.remainder(bent, there)], h, 1))
        ahead, third = loops_ahead(loop, equations.loop_part(middle.q_d), there.tau, h)
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


def fitting(model: Model, grid: Grid, options: Options) -> Scheme:
    """Steps with the stiffness of the deflections or with the Jacobian of all coordinates, as the options say."""
    assert isinstance(options, ExponentialAdamsOptions)
    chosen = options.checked(len(grid.groups)).linearisation
    if chosen == "jacobian":
        return RosenbrockAdams(model, grid, options)
    by_stiffness = ExponentialAdams(model, grid, replace(options, linearisation="stiffness"))
    if chosen == "stiffness" or not RosenbrockAdams.possible(model):
        return by_stiffness
    by_jacobian = RosenbrockAdams(model, grid, replace(options, linearisation="jacobian"))
    if "linearisation" not in model.choices:
        usual = ExponentialAdamsOptions()  # so what is chosen depends on the model alone
        kinds = (RosenbrockAdams, "jacobian"), (ExponentialAdams, "stiffness")
        built = (kind(model, grid, replace(usual, linearisation=word)) for kind, word in kinds)
        price, other = (operations_per_step(one.program()) for one in built)
        model.choices["linearisation"] = "jacobian" if price <= WORTH * other else "stiffness"
    return by_jacobian if model.choices["linearisation"] == "jacobian" else by_stiffness
