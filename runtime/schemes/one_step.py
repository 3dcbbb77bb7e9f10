"""A one-step method, written once: what it evaluates at the start of a step, the step itself, and its dense output.

Dense output is the continuous extension of a step: an interpolant of the method itself.

How long steps are is not its concern. Its own program is a step of the grid in one stage; adaptive_scheme.py wraps the
same method in steps that follow its estimate of the error. Fields of the start of a step: q_from, v_from, loop_from,
t_from, a_from, and what `step_start` gives; side_offset [s]: how near to its ends time is looked at, where forces
may jump.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from runtime.engine.program import Fields, Program
from runtime.schemes.scheme import Scheme, StateField
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations


@dataclass(frozen=True)
class Attempt:
    """The end of a step: q_i, v (rates in the charts of the step, or velocities, see `by_rates`), guess of the loop
    unknowns; embedded estimates of its error dq, dv (n_i each).

    kept: fields of z that dense output or the next step takes. configurations: closed configurations on the way;
    end: of the end, where that is evaluated.
    """

    q: ca.SX
    v: ca.SX
    loop: ca.SX
    dq: ca.SX
    dv: ca.SX
    kept: Mapping[str, ca.SX]
    configurations: tuple[ClosedConfiguration, ...]
    end: ClosedConfiguration | None = None


class Method(Scheme):
    """Steps of the grid. A subclass gives `step_start` and `attempted`; where steps may follow its estimate,
    `between`.
    """

    stage_name = "step"
    by_rates = True  # are the v of an attempt rates in the charts, with rotation vectors and not angular velocities?
    error_order: int  # the estimate is of h to this power
    strictness: float = 1.0  # what the estimate is multiplied by, so that all methods deliver about the same
    counted_evaluations: tuple[int, int]  # at the start of a step, and in an attempt
    first_same_as_last = (
        False  # FSAL: is the end of an attempt evaluated, so that the next step need not evaluate its start?
    )

    @abstractmethod
    def step_start(
        self, z: Fields, equations: StageEquations
    ) -> tuple[ClosedConfiguration, ca.SX, Mapping[str, ca.SX]]:
        """(configuration, q_i_ddot, fields) at the start of a step: what does not depend on its length."""

    @abstractmethod
    def attempted(self, z: Fields, equations: StageEquations, h: ca.SX) -> Attempt:
        """A step of h [s] from q_from, v_from."""

    def between(self, z: Fields, equations: StageEquations, tau: ca.SX, h: ca.SX | None = None) -> tuple[ca.SX, ca.SX]:
        """(q_i, q_i_dot) at tau [s] after the start of a step of h [s] (None: the last one), of the method's order."""
        raise NotImplementedError(f"{type(self).__name__} has no dense output: no option asks it for one")

    def moved(self, z: Fields) -> Mapping[str, ca.SX]:
        """Of a method whose first evaluation is the last of the step before: its fields at the start of a step."""
        return {}

    def method_fields(self) -> dict[str, StateField]:
        """Fields of z that `step_start` and `attempted` fill, of steps that follow their estimate."""
        return {}

    def evaluations(self) -> tuple[int, int]:
        """Those of a start and of an attempt."""
        return sum(self.counted_evaluations), 0

    def program(self) -> Program:
        """One stage."""
        return self.stage(self.stage_name, self._step)

    def _step(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h, t = equations.h[0], self.now(z, equations)
        at = {"q_from": z["x"], "v_from": z["v"], "loop_from": z["loop"], "t_from": t, "side_offset": ca.SX(0)}
        start, a, fields = self.step_start(at, equations)
        found = self.attempted({**at, "a_from": a, "loop_from": equations.loop_part(start.q_d), **fields}, equations, h)
        end = self.arrived(equations, found.q, found.loop, t + h)
        v = equations.velocities(end, found.v) if self.by_rates else found.v
        ends = {**self.rebased(z, end, found.loop), "v": v, "n": z["n"] + 1}
        return {**ends, **self.closed(z, start, *found.configurations)}

    def time_in_step(self, z: Fields, h: ca.SX, share: float) -> ca.SX:
        """Time at a share of a step of h [s]: just behind its start and just before its end, where it may jump."""
        t = z["t_from"] + share * h
        return t + (z["side_offset"] if share == 0 else -z["side_offset"] if share == 1 else 0)

    def velocities_at(self, z: Fields, equations: StageEquations, tau: ca.SX, q: ca.SX, rate: ca.SX) -> ca.SX:
        """q_i_dot of the rates of q, tau after the start of a step."""
        if not self.charts.split:
            return self.charts.velocities(q, rate)
        guess = z["loop_from"] + tau * z["loop_dot"]
        return equations.velocities(equations.close_well(q, guess, z["t_from"] + tau), rate)
