"""Exponential Rosenbrock steps of order 4, as long as a tolerance asks for.

The method is exprb42, see runtime/schemes/exponential.py. What it evaluates at the start of a step (accelerations, the
linear system with its Jacobian, G0, G1) does not depend on its length, so a rejected step keeps all of it. The error
estimate is the end less the inner stage run on to the end (Rosenbrock-Euler, order 2), which takes one sub-step that
damps, so that it sees modes that are not resolved. The linear motion with the force that leads to the end leads to any
time before it.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from runtime.contract.model import Model
from runtime.engine.program import Fields
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps, Attempt
from runtime.schemes.exponential import NODES, ExponentialOptions
from runtime.schemes.grid import Grid
from runtime.schemes.linear_propagation import LinearSystem, factors_of, propagate
from runtime.schemes.options import SchemeError
from runtime.schemes.partial_fractions import poles
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.state_fields import StateField, state
from runtime.schemes.stored_system import StoredSystem

HALVES = 2  # sub-steps of a step
(NODE,) = NODES[4]


def refuse_what_a_tolerance_cannot(grid: Grid, propagation: str) -> None:
    """Raises SchemeError for sub-steps that steps of a tolerance do not take."""
    if propagation == "central_difference":
        raise SchemeError("tolerance", "needs sub-steps without a limit", "take propagation = rational or decaying")
    if list(grid.m) != [HALVES]:
        raise SchemeError("tolerance", f"takes {HALVES} sub-steps, not m = {list(grid.m)}", "leave m out")


class AdaptiveExponential(AdaptiveSteps):
    """One evaluation with its Jacobian at the start of a step, one more an attempt."""

    options: ExponentialOptions
    order, error_order, counted_evaluations = 4, 4, (1, 1)
    strictness = 6.0

    def __init__(self, model: Model, grid: Grid, options: ExponentialOptions) -> None:
        refuse_what_a_tolerance_cannot(grid, options.propagation)
        if options.order != 4:
            raise SchemeError("tolerance", "has an estimate of the error for order 4 only", "leave order out")
        self.stored = StoredSystem(model, ())
        super().__init__(model, grid, options)

    def method_fields(self) -> dict[str, StateField]:
        """The linear system, its forces, and rates of the loop unknowns."""
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        sizes = {**self.stored.sizes(), "G0": n, "G1": n, "G2": n, "loop_dot": loops, "loop_bend": loops}
        return {name: state(size) for name, size in sizes.items()}

    def begun(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX, Mapping[str, ca.SX]]:
        """The equations to first order about the start."""
        v, t = z["v_from"], self.time_in_step(z, ca.SX(0), 0)
        start = equations.close(z["q_from"], z["loop_from"], t, self.options.closure_iterations)
        found = equations.linearised(start, v)
        fields = {
            **self.stored.pack(LinearSystem(found.M_hat, found.J_q, found.J_v)),
            "G0": found.Q_hat - ca.mtimes(found.J_v, v),
            "G1": equations.force_rate(start, v, found.a),
            "loop_dot": equations.loop_part(equations.rates(start, v)),
            "loop_bend": equations.loop_accelerations(start, v, found.a),
        }
        return start, found.a, fields

    def attempted(self, z: Fields, equations: StageEquations, h: ca.SX) -> Attempt:
        """To 3/4 of the step, and through all of it with the force found there."""
        none = ca.SX.zeros(len(self.model.q_i))
        first, second = self._motion(z, h, none, NODE)[-1], self._at_once(z, h)
        tau, iterations = NODE * h, self.options.closure_iterations
        ahead = z["loop_from"] + tau * z["loop_dot"]
        at = equations.close(
            z["q_from"] + first[0], ahead + tau * tau / 2 * z["loop_bend"], self.time_in_step(z, h, NODE), iterations
        )
        system = self.stored.unpack(z)
        linear = z["G0"] + tau * z["G1"] + ca.mtimes(system.J_q, first[0]) + ca.mtimes(system.J_v, first[1])
        G2 = 2 / (tau * tau) * (ca.mtimes(system.M, equations.chart_accelerations(at, first[1])) - linear)
        w, u = self._motion(z, h, G2, 1.0)[-1]
        bend, end = equations.loop_part(at.q_d) - ahead, z["q_from"] + w
        loop = z["loop_from"] + h * z["loop_dot"] + bend / NODE**2
        v = self.velocities_at(z, equations, h, end, u)
        return Attempt(end, v, loop, w - second[0], u - second[1], {"G2": G2}, (at,))

    def between(self, z: Fields, equations: StageEquations, tau: ca.SX, h: ca.SX | None = None) -> tuple[ca.SX, ca.SX]:
        """The same linear motion, ended sooner."""
        w, u = self._motion(z, tau, z["G2"], 1.0)[-1]
        return z["q_from"] + w, self.velocities_at(z, equations, tau, z["q_from"] + w, u)

    def _motion(self, z: Fields, h: ca.SX, G2: ca.SX, share: float) -> list[tuple[ca.SX, ca.SX]]:
        """(w, w') at the end of each sub-step of h / 2, and at a share of h."""
        system, decaying = self.stored.unpack(z), self.options.propagation == "decaying"
        factors = factors_of(system, h / HALVES, tuple(pole.r for pole in poles(decaying=decaying)))
        w, u = ca.SX.zeros(z["q_from"].numel()), z["v_from"]
        found = []
        for k in range(HALVES):
            part = min(1.0, share * HALVES - k)
            G, tau = (z["G0"], z["G1"], G2), k * h / HALVES
            w, u = propagate(system, factors, w, u, G, tau, h / HALVES, part, decaying, free=self.charts.independent)
            found.append((w, u))
        return found

    def _at_once(self, z: Fields, h: ca.SX) -> tuple[ca.SX, ca.SX]:
        """(w, w') at the end of the step, without the correction of the inner stage and in one sub-step."""
        system, none = self.stored.unpack(z), ca.SX.zeros(z["q_from"].numel())
        factors = factors_of(system, h, tuple(pole.r for pole in poles(decaying=True)))
        return propagate(system, factors, none, z["v_from"], (z["G0"], z["G1"], none), ca.SX(0), h, decaying=True)
