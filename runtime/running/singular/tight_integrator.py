"""The condensed equations integrated tightly for short times: to see where a motion near a singular position leads."""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp

from runtime.baselines.condensed_ode import CondensedOde
from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.results.observe import assemble_solution, join
from runtime.results.solution import Solution
from runtime.running.singular.loop_determinants import LoopDeterminants

CLOSURES = 5  # Newton steps: stages lie near the position, and guesses of early stages are of low order
RTOL, ATOL = 1e-11, 1e-13
LOOKS = 12  # steps at least while the determinant is followed down
OBSERVED = ("q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "q_d_ddot")


class BranchLost(Exception):
    """No step over the singular position keeps the branch and the energy; the message says why."""


class TightIntegrator:
    """Integrates the condensed equations of a model tightly, for short times."""

    def __init__(self, model: Model, p: np.ndarray, c: np.ndarray) -> None:
        self.model, self.p, self.c = model, p, c
        ode = model.derived("integrator", lambda: CondensedOde(model, CLOSURES).right_hand_side())
        self._observe = model.derived("tight_observe", lambda: CondensedOde(model, CLOSURES).observe())
        self._rhs = ode
        self.loops = LoopDeterminants(model, c)

    def pack(self, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
        """y of a consistent state."""
        i = self.model.independent_columns
        return np.concatenate([q[i], q_dot[i], q[self.model.loop_columns]])

    def slope(self, t: float, y: np.ndarray) -> np.ndarray:
        """y_dot."""
        return np.asarray(self._rhs(t, y, self.c)).ravel()

    def seen(self, t: np.ndarray, y: np.ndarray) -> Solution:
        """Closed states with energies at times t (N,), y (N, size)."""
        found = [
            [np.asarray(part).ravel() for part in self._observe(one, state, self.c)]
            for one, state in zip(t, y, strict=True)
        ]
        parts = {name: np.array([row[k] for row in found]).reshape(len(t), -1) for k, name in enumerate(OBSERVED)}
        q, v, a = (join(self.model, parts[f"q_i{end}"], parts[f"q_d{end}"]) for end in ("", "_dot", "_ddot"))
        return assemble_solution(
            self.model, t, q, v, a, self.p, self.c, "integrator", 0.0, [], {}, Status("completed", float(t[-1]))
        )

    def determinants(self, t: float, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Of the loop blocks, and their rates."""
        state = self.seen(np.array([t]), y[None, :])
        return self.loops.determinants(t, state.q[0], state.q_dot[0])

    def run(self, t: float, y: np.ndarray, t_end: float) -> tuple[float, np.ndarray]:
        """(t_end, y there)."""
        if t_end == t:
            return t, y
        found = solve_ivp(self.slope, (t, t_end), y, method="DOP853", rtol=RTOL, atol=ATOL)
        if not found.success or not np.isfinite(found.y[:, -1]).all():
            raise BranchLost("the equations cannot be integrated near the singular position")
        return float(found.t[-1]), found.y[:, -1].copy()

    def descend(
        self, t: float, y: np.ndarray, t_end: float, block: int, height: float
    ) -> tuple[float, np.ndarray] | None:
        """(t, y) where the determinant of a block has come down to `height`; None if that is not before t_end."""
        sign = float(np.sign(self.determinants(t, y)[0][block]))

        def above(t: float, y: np.ndarray) -> float:
            return float(sign * self.determinants(t, y)[0][block] - height)

        above.terminal, above.direction = True, -1  # type: ignore[attr-defined]
        try:
            found = solve_ivp(
                self.slope,
                (t, t_end),
                y,
                method="DOP853",
                rtol=RTOL,
                atol=ATOL,
                events=above,
                max_step=(t_end - t) / LOOKS,
            )
        except ValueError:  # not finite
            return None
        return (float(found.t[-1]), found.y[:, -1].copy()) if found.status == 1 else None

    def time_left(self, t: float, y: np.ndarray, block: int) -> float:
        """Time until the determinant of a block is zero, at its present rate [s]; infinite if it grows."""
        value, rate = (part[block] for part in self.determinants(t, y))
        return float(-value / rate) if value * rate < 0 else np.inf
