"""Steps linearised at their predicted midpoint, as long as a tolerance asks for. Order 2.

The method is that of runtime/schemes/linearised.py with two sub-steps and without corrections. The linear system of the
last step, run on over h by one sub-step that damps, predicts the midpoint and the end; what the end is off from that is
the error estimate, which sees modes that are not resolved. At the start, behind a jump and after a rejected step the
system linearised at the start takes its place. The linear motion that leads to the end leads to any time before it.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from runtime.contract.model import Model
from runtime.engine.program import Fields
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.grid import Grid
from runtime.schemes.linear_propagation import LinearSystem, factors_of, propagate
from runtime.schemes.linear_sub_steps import refuse_varying
from runtime.schemes.linearised import LinearisedOptions
from runtime.schemes.method import Attempt
from runtime.schemes.options import HALVES, SchemeError
from runtime.schemes.partial_fractions import poles
from runtime.schemes.stage_equations import ClosedConfiguration, LinearisedEquations, StageEquations
from runtime.schemes.state_fields import StateField, state
from runtime.schemes.stored_system import StoredSystem


class AdaptiveLinearised(AdaptiveSteps):
    """One evaluation with its Jacobian an attempt, and one where steps begin anew."""

    options: LinearisedOptions
    order, error_order, counted_evaluations = 2, 4, (0, 1)
    strictness = 0.1  # the prediction reaches three times as far as the step, and is of its order
    first_same_as_last = True  # a step begins with what the last one has left
    begins_after_rejection = True

    def __init__(self, model: Model, grid: Grid, options: LinearisedOptions) -> None:
        refuse_varying(grid, options)
        if options.corrections:
            raise SchemeError("tolerance", "needs no corrections: steps are as short as it asks for", "leave them out")
        self.stored = StoredSystem(model, ())
        super().__init__(model, grid, options)
        if self.charts.size:
            raise SchemeError(
                "tolerance", "does not go with linearised where bodies turn in space freely", "take exponential"
            )

    def method_fields(self) -> dict[str, StateField]:
        """The linear system, the position that it counts from, and rates of the loop unknowns."""
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        sizes = {**self.stored.sizes(), "G0": n, "q_base": n, "loop_dot": loops}
        return {name: state(size) for name, size in sizes.items()}

    def begun(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX, Mapping[str, ca.SX]]:
        """The equations to first order about the start."""
        q, v = z["q_from"], z["v_from"]
        start = equations.close(q, z["loop_from"], self.time_in_step(z, ca.SX(0), 0), self.options.closure_iterations)
        found = equations.linearised(start, v)
        return start, found.a, self._system(found, q, q, v, equations.loop_part(equations.rates(start, v)))

    def attempted(self, z: Fields, equations: StageEquations, h: ca.SX) -> Attempt:
        """Predict, linearise at the midpoint, run to the end."""
        q, middle, predicted = z["q_from"], *self._predicted(z, h)
        at_middle, u = z["q_base"] + middle[0], middle[1]
        guess, t = z["loop_from"] + h / 2 * z["loop_dot"], self.time_in_step(z, h, 0.5)
        at = equations.close(at_middle, guess, t, self.options.closure_iterations)
        found = equations.linearised(at, u)
        kept = self._system(found, q, at_middle, u, equations.loop_part(equations.rates(at, u)))
        w, v = self._motion({**z, **kept}, h)
        loop = equations.loop_part(at.q_d) + h / 2 * kept["loop_dot"]
        dq = q + w - z["q_base"] - predicted[0]
        return Attempt(q + w, v, loop, dq, v - predicted[1], kept, (at,))

    def between(self, z: Fields, equations: StageEquations, tau: ca.SX, h: ca.SX | None = None) -> tuple[ca.SX, ca.SX]:
        """The same linear motion, ended sooner."""
        w, u = self._motion(z, tau)
        return z["q_from"] + w, u

    def _system(self, found: LinearisedEquations, base: ca.SX, q: ca.SX, v: ca.SX, loop_dot: ca.SX) -> dict[str, ca.SX]:
        """Fields of the linear system found at (q, v), for positions that count from base."""
        G0 = found.Q_hat - ca.mtimes(found.J_q, q - base) - ca.mtimes(found.J_v, v)
        system = LinearSystem(found.M_hat, found.J_q, found.J_v)
        return {**self.stored.pack(system), "G0": G0, "q_base": base, "loop_dot": loop_dot}

    def _predicted(self, z: Fields, h: ca.SX) -> list[tuple[ca.SX, ca.SX]]:
        """(positions less q_base, rates) in the middle and at the end of a step, by the system of the last one."""
        system, none = self.stored.unpack(z), ca.SX.zeros(z["q_from"].numel())
        factors = factors_of(system, h, tuple(pole.r for pole in poles(decaying=True)))
        w, G = z["q_from"] - z["q_base"], (z["G0"], none, none)
        return [propagate(system, factors, w, z["v_from"], G, ca.SX(0), h, part, decaying=True) for part in (0.5, 1.0)]

    def _motion(self, z: Fields, h: ca.SX) -> tuple[ca.SX, ca.SX]:
        """(w, w') after h by the system in z."""
        system, decaying = self.stored.unpack(z), self.options.propagation == "decaying"
        factors = factors_of(system, h / HALVES, tuple(pole.r for pole in poles(decaying=decaying)))
        none = ca.SX.zeros(z["q_from"].numel())
        w, u = none, z["v_from"]
        for _ in range(HALVES):
            w, u = propagate(system, factors, w, u, (z["G0"], none, none), ca.SX(0), h / HALVES, decaying=decaying)
        return w, u
