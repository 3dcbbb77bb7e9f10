"""Equilibria on all coordinates, for where the independent ones lead nowhere.

Near a position at which two links are in line the q_d are no function of the q_i, and the condensed equations end
there. The equilibrium itself need not: with Z an orthonormal basis of the motions that C_q lets (C_q Z = 0),

    Z^T Q* = 0,  slope Z^T d(Q* - C_q^T lambda)/dq Z,  C_q^T lambda = Q* in the least-squares sense,

has no such places. Steps are made along Z and put back on C(q, t) = 0. What is found is a start for the condensed
equations, which have the last word.
"""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.operating.newton import Balance, balanced

DEPENDENT = 1e-10  # singular value of C_q, relative to the largest, of rows that others imply
ON_THE_ROWS = 1e-12  # m or rad
MOST_RETURNS = 30


class AllCoordinates:
    """A model at rest at time t [s] with constants c (c_size,), coordinates `rows` of q clamped at `goal`."""

    def __init__(self, model: Model, c: np.ndarray, t: float, rows: Sequence[int], goal: np.ndarray) -> None:
        self.c, self.t, self.rows, self.goal = c, t, list(rows), goal
        self._function = model.derived("balance_of_all_coordinates", lambda: _built(model))
        self._basis: np.ndarray | None = None

    def solve(self, q: np.ndarray) -> np.ndarray | None:
        """q (n,) in equilibrium, reached from a consistent q; None where none is."""
        try:
            found = balanced(self.balance, q, self.advance)
        except np.linalg.LinAlgError:  # a motion without mass
            return None
        return found.x if found.converged else None

    def balance(self, q: np.ndarray) -> Balance | None:
        """Force, slope and mass in the directions that are free."""
        M, Q, _, C_q = self._values(q, np.zeros(0))[:4]
        if not all(np.isfinite(part).all() for part in (M, Q, C_q)):
            return None
        lam = np.linalg.lstsq(C_q.T, Q, rcond=DEPENDENT)[0]
        H, Z = self._values(q, lam)[4], self._free(C_q)
        return (Z.T @ Q, Z.T @ H @ Z, Z.T @ M @ Z) if np.isfinite(H).all() else None

    def advance(self, q: np.ndarray, step: np.ndarray) -> np.ndarray | None:
        """q after a step in the free directions, put back on the constraints by the least change."""
        self._basis = self._free(self._values(q, np.zeros(0))[3])
        q = q + self._basis @ step
        for _ in range(MOST_RETURNS):
            _, _, C, C_q = self._values(q, np.zeros(0))[:4]
            if not np.isfinite(C).all():
                return None
            if np.abs(C).max(initial=0.0) <= ON_THE_ROWS * max(1.0, float(np.abs(q).max())):
                return q
            q = q - np.linalg.lstsq(C_q, C, rcond=DEPENDENT)[0]
        return None

    def _values(self, q: np.ndarray, lam: np.ndarray) -> tuple[np.ndarray, ...]:
        """M (n, n), Q* (n,), C (n_c + k,), C_q (n_c + k, n) with the k clamped rows, d(Q* - C_q^T lam)/dq (n, n)."""
        n_c = self._function.size1_in(2)
        M, Q, C, C_q, H = (
            np.asarray(part) for part in self._function(self.t, q, lam[:n_c] if len(lam) else np.zeros(n_c), self.c)
        )
        clamped = np.eye(len(q))[self.rows]
        C = np.concatenate([C.ravel(), q[self.rows] - self.goal])
        return M, Q.ravel(), C, np.vstack([C_q.reshape(n_c, len(q)), clamped]), H

    def _free(self, C_q: np.ndarray) -> np.ndarray:
        """Z (n, k), turned to be as near as possible to that of the last step: forces of two places are compared."""
        _, s, V = np.linalg.svd(C_q)
        Z = V[int(np.sum(s > DEPENDENT * s[0])) if len(s) else 0 :].T
        if self._basis is None or self._basis.shape != Z.shape:
            return np.asarray(Z)
        U, _, W = np.linalg.svd(Z.T @ self._basis)
        return np.asarray(Z @ U @ W)


def _built(model: Model) -> ca.Function:
    """(t, q, lam, c) -> M, Q*, C, C_q, d(Q* - C_q^T lam)/dq, all at rest."""
    n, n_c = len(model.coordinates), len(model.constraints)
    t, q, lam, c = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("lam", n_c), ca.SX.sym("c", model.c_size)
    rest = ca.SX.zeros(n)
    found = model.evaluate("augmented", q=q, q_dot=rest, t=t, c=c)
    rows = model.evaluate("constraints", q=q, q_dot=rest, t=t, c=c)
    left = found["Q_star"] - ca.mtimes(rows["C_q"].T, lam)
    outputs = [found["M"], found["Q_star"], rows["C"], rows["C_q"], ca.jacobian(left, q)]
    return ca.Function("all_coordinates", [t, q, lam, c], [ca.densify(part) for part in outputs])
