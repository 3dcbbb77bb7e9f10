"""Linearised sub-steps: one evaluation and one Jacobian a major step, at its predicted midpoint. Order 2.

The midpoint is predicted by running the linear system of the last step half a step further, so stiff modes are
predicted as well as slow ones. `corrections` linearise again at the midpoint that the linear system itself leads to.
Once that midpoint no longer changes the step is symmetric in time: the linear system that leads from the start to the
midpoint leads back from the end to the same midpoint.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from runtime.contract.model import Model
from runtime.engine.program import Fields, Program, Repeat, Sequence
from runtime.schemes.linear_sub_steps import LinearSubStepOptions, LinearSubSteps
from runtime.schemes.options import Grid, SchemeError, whole_number
from runtime.schemes.scheme import StateField, history, work
from runtime.schemes.stage_equations import StageEquations


@dataclass(frozen=True)
class LinearisedOptions(LinearSubStepOptions):
    """closure_iterations, propagation: see LinearSubStepOptions.

    corrections: how often a step is linearised again at the better midpoint that its own linear system leads to.
    """

    corrections: int = whole_number(0, least=0, most=100)


class Linearised(LinearSubSteps):
    """m sub-steps on the system linearised at the midpoint, m even."""

    options: LinearisedOptions

    def __init__(self, model: Model, grid: Grid, options: LinearisedOptions) -> None:
        if grid.m[0] % 2:
            raise SchemeError(
                f"linearised needs an even number of sub-steps m, not {grid.m[0]}: half of them lead to "
                "the next midpoint"
            )
        super().__init__(model, grid, options)

    def further_fields(self) -> dict[str, StateField]:
        """And the start of the step, its predicted midpoint, and the rates of the loop unknowns there."""
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        return {
            **super().further_fields(),
            "x_start": work(n),
            "x_mid": history(n),
            "v_mid": history(n),
            "loop_dot": work(loops),
        }

    def program(self) -> Program:
        """Linearise at the midpoint, run to the end of the step, predict the next midpoint."""
        m, sub_step = self.grid.m[0], self.sub_step()
        linearise, half = self.stage("linearise", self._linearise), Repeat(sub_step, m // 2)
        correct = Sequence((half, self.stage("recentre", self._recentre), linearise))
        again = (Repeat(correct, self.options.corrections),) if self.options.corrections else ()
        return Sequence(
            (
                linearise,
                *again,
                Repeat(sub_step, m),
                self.stage("finish", self._finish),
                half,
                self.stage("predict", self._predict),
            )
        )

    def evaluations(self) -> tuple[int, int]:
        """One and the corrections, and the sub-steps."""
        corrections = self.options.corrections
        return 1 + corrections, (3 + corrections) * self.grid.m[0] // 2

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """The first midpoint is taken along the velocity: an acceleration may belong to a mode that has long turned."""
        fields = super().started(t0, q_i, q_i_dot, loop, equations)
        return {**fields, "x_mid": q_i + equations.h[0] / 2 * q_i_dot, "v_mid": q_i_dot}

    def _linearise(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        q, v, t = z["x_mid"], z["v_mid"], self.now(z, equations) + equations.h[0] / 2
        motion = equations.close(q, z["loop"], t, self.options.closure_iterations)
        found = equations.linearised(motion, v)
        G0 = found.Q_hat - ca.mtimes(found.J_q, q - z["x"]) - ca.mtimes(found.J_v, v)
        return {
            **self.begin(z, equations, found, G0, ca.SX.zeros(len(self.model.q_i))),
            "loop": equations.loop_part(motion.q_d),
            "loop_dot": equations.loop_part(equations.rates(motion, v)),
            **self.closed(z, motion),
        }

    def _recentre(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """The midpoint that the linear system itself leads to."""
        return {"x_mid": z["x"] + z["w"], "v_mid": z["u"]}

    def _finish(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        return {"x": z["x"] + z["w"], "v": z["u"], "n": z["n"] + 1, "x_start": z["x"]}

    def _predict(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        ahead = {"x_mid": z["x_start"] + z["w"], "v_mid": z["u"]}
        next_middle, here = (z["loop"] + share * equations.h[0] * z["loop_dot"] for share in (1, 0.5))
        end = self.arrived(equations, z["x"], here, self.now(z, equations))
        return {**ahead, **self.rebased({**z, **ahead}, end, next_middle, since=("x_mid",))}
