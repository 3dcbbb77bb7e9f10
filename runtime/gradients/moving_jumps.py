"""How the times of jumps move with parameters: g(t, c(p)) = 0 gives dt/dp = -g_p / g_t."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy

import casadi as ca
import numpy as np

from runtime.contract.errors import NoResult
from runtime.contract.model import Model
from runtime.gradients.course import Course, EventPassage, across
from runtime.schemes.switching.breaks import Breaks
from runtime.schemes.switching.times import SwitchTime, has_switching_times, switches_by_inputs, switching_times

NEAR = 1e-9  # of a run: a condition whose zero is that near to a jump is of it
ALIKE = 1e-9  # of the largest entry: derivatives of the times of two conditions


class MovingJumps:
    """Of a model; by: the entries of p that are differentiated by. steps, t0 [s], dt [s]: of the run."""

    def __init__(self, model: Model, by: Sequence[int], t0: float, dt: float, steps: int) -> None:
        self._model, self._by = model, list(by)
        self._t0, self._dt, self._end = t0, dt, t0 + steps * dt
        self.possible = has_switching_times(model)
        if model.has("switching"):
            t, p = ca.SX.sym("t"), ca.SX.sym("p", len(model.parameters))
            g = ca.densify(model.evaluate("switching", t=t, c=model.kernel("constants")(p))["switching"])
            slopes = ca.densify(ca.jacobian(g, p)) if self._by else ca.SX.zeros(g.numel(), p.numel())
            self._of = ca.Function("conditions", [t, p], [g, ca.densify(ca.jacobian(g, t)), slopes])

    def over(self, t0: float, dt: float, steps: int) -> MovingJumps:
        """The same of a run with so many steps of dt from t0 on [s]."""
        other = copy(self)
        other._t0, other._dt, other._end = t0, dt, t0 + steps * dt
        return other

    @property
    def reads_inputs(self) -> bool:
        """Do conditions depend on held inputs?"""
        return switches_by_inputs(self._model)

    def broken(self, course: Course, p: np.ndarray, passages: Mapping[int, Sequence[EventPassage]]) -> Course:
        """The course of a run with parameters p (n_p,), its steps broken where something jumps or happens.

        passages: of events, by step. Raises NoResult.
        """
        c, found = self._model.constants(p), list[SwitchTime]()
        if self.possible:
            found = switching_times(self._model, c, self._t0, self._end)
        if not found and not passages:
            return course
        return across(course, Breaks(self._t0, self._dt, found), lambda there: self._moves(there, p), passages)

    def _moves(self, there: Sequence[SwitchTime], p: np.ndarray) -> np.ndarray:
        """(n_p,) the derivative of the time of jumps that are at one time."""
        none = np.zeros(len(p))
        if not self._by or not self._model.has("switching"):
            return none
        found: list[np.ndarray] = []
        for one in there:
            g, g_t, g_p = (np.asarray(value) for value in self._of(one.time, p))
            for k in np.flatnonzero(np.abs(g[:, 0]) <= NEAR * (self._end - self._t0) * np.abs(g_t[:, 0])):
                if g_t[k, 0] != 0:
                    slope = none.copy()
                    slope[self._by] = -g_p[k, self._by] / g_t[k, 0]
                    found.append(slope)
        if not found:
            return none
        scale = max(float(np.abs(one).max()) for one in found)
        if any(np.abs(one - found[0]).max() > ALIKE * scale for one in found[1:]):
            raise NoResult(
                f"model {self._model.name}",
                f"two conditions change at t = {there[0].time:.6g} s and move apart with what is differentiated by "
                f"({', '.join(there[0].owners)})",
                "move one of them a little, or leave out of `by` what moves them",
            )
        return found[0]
