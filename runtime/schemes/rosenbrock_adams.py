"""Exponential Rosenbrock steps with what the last step saw: one Jacobian and two evaluations a step, order 4.

As in exponential.py D is what forces at a state are beside the linear system of the start of a step, where D is 0 with
its first derivative. Seen from there, what the last step began with gives D(-h) for products of matrices and vectors.

    Y    to 5/6 h, by G2 of the parabola through D(-h),
    end  to h,     by G2 and G3 of the cubic through D(-h) and D of Y.

With Y at c h the cubic leaves D4 tau^2 (tau + h) (tau - c h) / 24 of D, D4 its fourth derivative. The mean of that over
a step, by which motion that the step resolves is off, is zero for c = 27/35 and -D4 h^4 / 665 for 5/6; decays that are
much faster than the step see the end of it, where less is left the nearer c is to 1. To 1e-3 5/6 takes a tenth fewer
steps than 27/35 with an overdamped joint, and no more than 9/10 with slider-cranks. Nothing linear is remembered: of a
linear system D is zero, and the step is the rational approximation of all of it by which exponential_adams.py follows
stiff deflections.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from runtime.contract.model import Model
from runtime.engine.program import Fields, Program
from runtime.schemes.charts import Charts
from runtime.schemes.exponential import NODES
from runtime.schemes.grid import Grid
from runtime.schemes.linear_propagation import Factors, LinearSystem, factors_of, polynomial, propagate
from runtime.schemes.linear_solve import solve_symmetric
from runtime.schemes.options import SchemeError
from runtime.schemes.partial_fractions import poles
from runtime.schemes.remembering_step import ExponentialAdamsOptions, RememberingStep, bends, loops_ahead
from runtime.schemes.stage_equations import LONG_TREE, ClosedConfiguration, StageEquations
from runtime.schemes.state_fields import StateField, state
from runtime.schemes.stiff_motion import WHOLE_DEGREE

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
