"""Schemes whose sub-steps run on the linear system of the major step: what `linearised` and `exponential` share.

Fields: w = q_i - x and u = q_i_dot since the start of the major step, tau the time since then, G0, G1, ... the forces,
and the linear system.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.engine.program import Call, Fields
from runtime.schemes.linear_propagation import LinearSystem, StoredSystem, factors_of, polynomial, propagate
from runtime.schemes.one_step import OneStep
from runtime.schemes.options import HALVES, ClosureOptions, Grid, Options, SchemeError, one_of
from runtime.schemes.partial_fractions import poles
from runtime.schemes.scheme import StateField, work
from runtime.schemes.sparse_lu import solve_symmetric
from runtime.schemes.stage_equations import LinearisedEquations, StageEquations
from runtime.schemes.step_limit import StepLimit, central_difference_limit


@dataclass(frozen=True)
class LinearSubStepOptions(ClosureOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation.

    propagation: the sub-steps of the linear system: `rational` (of order 6, stable for any stiffness), `decaying` (of
        order 5; decays that are much faster than a sub-step die out in it) or `central_difference` (matrix-vector
        products, stable up to h w = 2).
    """

    propagation: str = one_of("rational", "decaying", "central_difference")


def refuse_varying(grid: Grid, options: LinearSubStepOptions) -> None:
    """Raises SchemeError for sub-steps that steps of a tolerance do not take."""
    if options.propagation == "central_difference":
        raise SchemeError("tolerance", "needs sub-steps without a limit", "take propagation = rational or decaying")
    if list(grid.m) != [HALVES]:
        raise SchemeError("tolerance", f"takes {HALVES} sub-steps, not m = {list(grid.m)}", "leave m out")


class LinearSubSteps(OneStep):
    """m sub-steps of all coordinates in a major step; grid.h is (major step, sub-step)."""

    options: LinearSubStepOptions
    forces: tuple[str, ...] = ("G0", "G1", "G2")

    def __init__(self, model: Model, grid: Grid, options: LinearSubStepOptions) -> None:
        self.by_central_difference = self.limited(options)
        self.decaying = options.propagation == "decaying"
        self.shifts = () if self.by_central_difference else tuple(one.r for one in poles(decaying=self.decaying))
        self.stored = StoredSystem(model, self.shifts)
        super().__init__(model, grid, options)

    def further_fields(self) -> dict[str, StateField]:
        """See the module's text; `acceleration` is what a central difference goes by."""
        n = len(self.model.q_i)
        sizes = {"w": n, "u": n, "tau": 1, **dict.fromkeys(self.forces, n), **self.stored.sizes()}
        if self.by_central_difference:
            sizes["acceleration"] = n
        return {name: work(size) for name, size in sizes.items()}

    @classmethod
    def limited(cls, options: Options) -> bool:
        """Only where the sub-steps are central differences."""
        return isinstance(options, LinearSubStepOptions) and options.propagation == "central_difference"

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of central-difference sub-steps with predicted velocities; few sub-steps a major step take more damping."""
        return central_difference_limit(A_q, A_v, predicted=True) if self.by_central_difference else None

    def begin(
        self, z: Fields, equations: StageEquations, found: LinearisedEquations, G0: ca.SX, G1: ca.SX
    ) -> dict[str, ca.SX]:
        """The linear system at the start of a major step."""
        system = LinearSystem(found.M_hat, found.J_q, found.J_v)
        zero = ca.SX.zeros(len(self.model.q_i))
        forces = {**dict.fromkeys(self.forces, zero), "G0": G0, "G1": G1}
        out = {**self.stored.pack(system), "w": zero, "u": z["v"], "tau": ca.SX(0), **forces}
        if not self.by_central_difference:
            out |= self.stored.pack_factors(factors_of(system, equations.h[1], self.shifts))
        else:
            out["acceleration"] = solve_symmetric(found.M_hat, G0 + ca.mtimes(found.J_v, z["v"]))
        return out

    def sub_step(self, part: float = 1.0) -> Call:
        """A sub-step, or the given part of one, of w and u."""
        return self.stage("sub_step" if part == 1.0 else "part_of_sub_step", partial(self._sub_step, part=part))

    def _sub_step(
        self, z: Fields, equations: StageEquations, part: float, echo: tuple[float, ca.SX] | None = None
    ) -> Mapping[str, ca.SX]:
        system, G, h = self.stored.unpack(z), [z[name] for name in self.forces], part * equations.h[1]
        tau = z["tau"] + h
        if not self.by_central_difference:
            factors, whole = self.stored.unpack_factors(z), equations.h[1]
            w, u = propagate(
                system, factors, z["w"], z["u"], G, z["tau"], whole, part, self.decaying, echo, self.charts.independent
            )
            return {"w": w, "u": u, "tau": tau}
        half = z["u"] + h / 2 * z["acceleration"]
        w = z["w"] + h * half
        predicted = half + h / 2 * z["acceleration"]
        force = polynomial(G, tau) + ca.mtimes(system.J_q, w) + ca.mtimes(system.J_v, predicted)
        a = solve_symmetric(system.M, force)
        return {"w": w, "u": half + h / 2 * a, "tau": tau, "acceleration": a}
