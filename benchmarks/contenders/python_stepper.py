"""The same major step as a plain Python loop: NumPy arrays, one call of a CasADi Function per kernel."""

from __future__ import annotations

from typing import Any, Self

import numpy as np

from runtime.model import Model
from runtime.schemes.scheme import Scheme


class PythonStepper:
    """Two groups, one Newton step on loops and on common velocities, predictor in sub-steps; no time dependence."""

    def __init__(self, model: Model, scheme: Scheme, c: np.ndarray) -> None:
        self.model, self.scheme, self.c = model, scheme, c
        self.slow, self.fast = scheme.grid.groups
        self.h = np.array([scheme.grid.h[0 if k in self.slow else 1] for k in range(len(model.q_i))])
        self.loops = [model.q_d.index(name) for name in model.loop_unknowns]

    def restart(self, z: np.ndarray) -> Self:
        """State from the z of the scheme."""
        layout = self.scheme.layout
        self.x, self.d, self.a = (z[layout.slice(name)].copy() for name in ("x", "d", "a"))
        self.loop, self.loop_old, self.loop_dot = (
            z[layout.slice(name)].copy() for name in ("loop", "loop_old", "loop_dot")
        )
        return self

    def run(self, n: int) -> None:
        """n major steps."""
        for _ in range(n):
            self._common_update()
            for j in range(1, self.scheme.grid.m[0]):
                self._sub_step(j)

    def _call(self, name: str, **values: np.ndarray) -> dict[str, np.ndarray]:
        kernel = self.model.kernel(name)
        arguments: dict[str, Any] = {**values, "c": self.c, "t": 0.0}
        result = kernel.call({key: arguments[key] for key in kernel.name_in()})
        return {key: np.asarray(value) for key, value in result.items()}

    def _close(self, q_i: np.ndarray) -> np.ndarray:
        q_d = np.zeros(len(self.model.q_d))
        q_d[self.loops] = self.loop_old + 2 * self.h[-1] * self.loop_dot
        q_d = self._call("closure", q_i=q_i, q_d=q_d)["q_d_next"].ravel()
        self.loop_old, self.loop = self.loop, q_d[self.loops]
        return q_d

    def _rates(self, q_i: np.ndarray, q_d: np.ndarray, q_i_dot: np.ndarray) -> np.ndarray:
        return self._call("velocities", q_i=q_i, q_d=q_d, q_i_dot=q_i_dot)["q_d_dot"].ravel()

    def _common_update(self) -> None:
        q_d, half, a = self._close(self.x), self.h / 2, self.a
        v = self.d / self.h + half * a
        state = {"q_i": self.x, "q_d": q_d, "q_i_dot": v, "q_d_dot": self._rates(self.x, q_d, v)}
        result, J = self._call("condensed", **state), self._call("dQ_hat_dq_i_dot", **state)["dQ_hat_dq_i_dot"]
        force = result["Q_hat"].ravel() - J @ (half * a)
        self.a = np.linalg.solve(result["M_hat"] - J * half, force)
        v = self.d / self.h + half * self.a
        self.base = self.x[self.slow].copy(), v[self.slow], self.a[self.slow]
        self.loop_dot = self._rates(self.x, q_d, v)[self.loops]
        self.d += self.h**2 * self.a
        self.x += self.d

    def _sub_step(self, j: int) -> None:
        h, (q, v_slow, a_slow), fast = self.h[-1], self.base, self.fast
        q_i, v, s = self.x.copy(), self.d / self.h, j * self.h[-1]
        q_i[self.slow], v[self.slow] = q + s * v_slow + (s * s + s * h) / 2 * a_slow, v_slow + s * a_slow
        v_half = v[fast].copy()
        v[fast] += h / 2 * self.a[fast]
        q_d = self._close(q_i)
        result = self._call("substep_2", q_i=q_i, q_d=q_d, q_i_dot=v, q_d_dot=self._rates(q_i, q_d, v), q_L_ddot=a_slow)
        self.a[fast] = np.linalg.solve(result["M_hat_SS"], result["rhs_S"].ravel())
        v[fast] = v_half + h / 2 * self.a[fast]
        self.loop_dot = self._rates(q_i, q_d, v)[self.loops]
        self.d[fast] += h**2 * self.a[fast]
        self.x[fast] += self.d[fast]
