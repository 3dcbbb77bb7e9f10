"""Exponential Rosenbrock steps of order 4: two evaluations and one Jacobian a major step, whatever the stiffness.

Luan and Ostermann's (2014) exprb42, for y' = F(y) linearised at the start of the step, N(y) = F(y) - A y:

    Y = y_n + c h phi_1(c h A) F(y_n),  c = 3/4
    y_{n+1} = y_n + h phi_1(h A) F(y_n) + (32/9) h phi_3(h A) (N(Y) - N(y_n))

Both lines are the motion of the linear system of linear_propagation.py, the second with the force
G2 tau^2 / 2, G2 = (32/9) M (N(Y) - N(y_n)) / h^2, run by m sub-steps. Forces that depend on time enter by
G1 = d(Q_hat - M_hat a)/dt. So the linear part of the motion, stiff modes included, is free of the major step's error,
and what limits the major step is the nonlinearity of the mechanism.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import ceil

import casadi as ca

from runtime.engine.program import Fields, Program, Repeat, Sequence
from runtime.schemes.linear_solve import solve_symmetric
from runtime.schemes.linear_sub_steps import LinearSubSteps
from runtime.schemes.stage_equations import StageEquations
from runtime.schemes.state_fields import StateField, work

NODE = 0.75  # c
WEIGHT = 32 / 9


class Exponential(LinearSubSteps):
    """exprb42 with m sub-steps; the inner stage ends inside one of them, on the same factors."""

    order = 4
    counts_powers = True

    def further_fields(self) -> dict[str, StateField]:
        """And the rates of the loop unknowns at the start of the step."""
        return {**super().further_fields(), "loop_dot": work(len(self.model.loop_unknowns))}

    def program(self) -> Program:
        """Linearise, run to 3/4 of the step, correct, run to its end."""
        m, sub_step = self.grid.m[0], self.sub_step()
        whole = int(NODE * m)
        inner: tuple[Program, ...] = (Repeat(sub_step, whole),) if whole else ()
        if NODE * m > whole:
            inner = (*inner, self.sub_step(NODE * m - whole))
        return Sequence(
            (
                self.stage("linearise", self._linearise),
                *inner,
                self.stage("correct", self._correct),
                Repeat(sub_step, m),
                self.stage("finish", self._finish),
            )
        )

    def evaluations(self) -> tuple[int, int]:
        """Two, and the sub-steps."""
        return 2, ceil(NODE * self.grid.m[0]) + self.grid.m[0]

    def _linearise(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        v, t = z["v"], self.now(z, equations)
        motion = equations.close(z["x"], z["loop"], t, self.options.closure_iterations)
        found = equations.linearised(motion, v)
        G0 = found.Q_hat - ca.mtimes(found.J_v, v)
        return {
            **self.begin(z, equations, found, G0, equations.force_rate(motion, v, found.a)),
            "loop": equations.loop_part(motion.q_d),
            "loop_dot": equations.loop_part(equations.rates(motion, v)),
            **self.closed(z, motion),
            **self.worked(z, equations, motion, v, found.a),
        }

    def _correct(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h, system = equations.h[0], self.stored.unpack(z)
        tau = NODE * h
        motion = equations.close(
            z["x"] + z["w"],
            z["loop"] + tau * z["loop_dot"],
            self.now(z, equations) + tau,
            self.options.closure_iterations,
        )
        a = equations.chart_accelerations(motion, z["u"])
        linear = z["G0"] + tau * z["G1"] + ca.mtimes(system.J_q, z["w"]) + ca.mtimes(system.J_v, z["u"])
        bend = equations.loop_part(motion.q_d) - z["loop"] - tau * z["loop_dot"]
        out = {
            "G2": WEIGHT / (h * h) * (ca.mtimes(system.M, a) - linear),
            "w": ca.SX.zeros(len(self.model.q_i)),
            "u": z["v"],
            "tau": ca.SX(0),
            "loop": z["loop"] + h * z["loop_dot"] + bend / NODE**2,
            **self.closed(z, motion),
        }
        if self.by_central_difference:
            out["acceleration"] = solve_symmetric(system.M, z["G0"] + ca.mtimes(system.J_v, z["v"]))
        return out

    def _finish(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        x = z["x"] + z["w"]
        return {**self.rebased(z, x), "v": self.charts.velocities(x, z["u"]), "n": z["n"] + 1}
