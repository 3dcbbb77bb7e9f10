"""Numbers of a model along a motion: C_q, and the determinants of the loop blocks with their rates."""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.coordinates import parts, rate_parts
from runtime.contract.model import Model


class LoopDeterminants:
    """Evaluations on all coordinates q and q_dot of one model with constants c."""

    def __init__(self, model: Model, c: np.ndarray) -> None:
        self.model, self.c = model, c
        self._determinants = model.derived("determinants_along", lambda: _determinants(model))

    def jacobian(self, t: float, q: np.ndarray) -> np.ndarray:
        """C_q (rows x coordinates)."""
        found = self.model.evaluate("constraints", q=q, q_dot=np.zeros(len(q)), t=t, c=self.c)["C_q"]
        return np.asarray(found).reshape(len(self.model.constraints), len(q))

    def determinants(self, t: float, q: np.ndarray, q_dot: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(determinant of each loop block, its rate [1/s])."""
        found = self._determinants(t, *parts(self.model, q), *rate_parts(self.model, q, q_dot), self.c)
        values, slopes = found
        return np.asarray(values).ravel(), np.asarray(slopes).ravel()


def _determinants(model: Model) -> ca.Function:
    """(t, q_i, q_d, q_i_dot, q_d_dot, c) -> det_loop and its rate."""
    t, c = ca.SX.sym("t"), ca.SX.sym("c", model.c_size)
    q_i, q_d = ca.SX.sym("q_i", len(model.q_i)), ca.SX.sym("q_d", len(model.q_d))
    v_i, v_d = ca.SX.sym("v_i", len(model.q_i)), ca.SX.sym("v_d", len(model.q_d))
    found = model.evaluate("closure", q_i=q_i, q_d=q_d, t=t, c=c)["det_loop"]
    rate = ca.jtimes(found, q_i, v_i) + ca.jtimes(found, q_d, v_d) + ca.jtimes(found, t, ca.SX(1))
    return ca.Function("determinants_along", [t, q_i, q_d, v_i, v_d, c], [found, rate])
