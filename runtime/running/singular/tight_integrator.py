"""The condensed equations integrated tightly for short times: to see where a motion near a singular position leads."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.baselines.condensed_ode import CondensedOde, integrated
from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.engine.rows import evaluate
from runtime.results.observe import assemble_solution, join
from runtime.results.solution import Solution
from runtime.running.singular.loop_determinants import LoopDeterminants

CLOSURES = 5  # Newton steps: stages lie near the position, and guesses of early stages are of low order
RTOL, ATOL = 1e-11, 1e-13
MOST_EVALUATIONS = 3_000  # of one question; a way to a singular position takes some hundreds
LOOKS = 12  # steps at least while the determinant is followed down


class BranchLost(Exception):
    """No step over the singular position keeps the branch and the energy; the message says why."""


@dataclass(frozen=True)
class Integrated:
    """Where an integration ended (t, y), whether an event stopped it, and y (N, size) at the times asked for."""

    end: tuple[float, np.ndarray]
    stopped: bool
    at_times: np.ndarray


class TightIntegrator:
    """Integrates the condensed equations of a model tightly, for short times.

    asked: was Ctrl-C pressed? Then KeyboardInterrupt is raised from where it is.
    """

    def __init__(self, model: Model, p: np.ndarray, c: np.ndarray, asked: Callable[[], bool] = lambda: False) -> None:
        self.model, self.p, self.c, self.asked = model, p.copy(), c.copy(), asked  # events change those of the run
        self._rhs = model.derived("integrator", lambda: CondensedOde(model, CLOSURES).right_hand_side())
        self._observe = model.derived("tight_observe", lambda: CondensedOde(model, CLOSURES).observe())
        self.loops = LoopDeterminants(model, c)
        self._left = MOST_EVALUATIONS

    def pack(self, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
        """y of a consistent state."""
        return integrated(self.model, q, q_dot)

    def slope(self, t: float, y: np.ndarray) -> np.ndarray:
        """y_dot (size,). Raises BranchLost after MOST_EVALUATIONS of one question: steps shrink for ever."""
        if self.asked():
            raise KeyboardInterrupt
        self._left -= 1
        if self._left < 0:
            raise BranchLost("the steps of the integration shrink without end near it")
        return np.asarray(self._rhs(t, y, self.c)).ravel()

    def states(self, t: np.ndarray, y: np.ndarray) -> dict[str, np.ndarray]:
        """Closed q, q_dot, q_ddot (N, n) at times t (N,), y (N, size)."""
        found = evaluate(self._observe, {"t": t[:, None], "y": y}, self.c)
        return {
            name: join(self.model, found[f"q_i{end}"], found[f"q_d{end}"])
            for name, end in (("q", ""), ("q_dot", "_dot"), ("q_ddot", "_ddot"))
        }

    def seen(self, t: np.ndarray, y: np.ndarray) -> Solution:
        """Closed states with energies at times t (N,), y (N, size)."""
        at, ended = self.states(t, y), Status("completed", float(t[-1]))
        motion = at["q"], at["q_dot"], at["q_ddot"]
        return assemble_solution(self.model, t, *motion, self.p, self.c, "integrator", 0.0, [], {}, ended)

    def determinants(self, t: float, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Of the loop blocks, and their rates."""
        state = self.states(np.array([t]), y[None, :])
        return self.loops.determinants(t, state["q"][0], state["q_dot"][0])

    def run(self, t: float, y: np.ndarray, t_end: float) -> tuple[float, np.ndarray]:
        """(t_end, y there). Raises BranchLost."""
        return (t, y) if t_end == t else self._solved(t, y, t_end).end

    def path(self, t: float, y: np.ndarray, times: np.ndarray) -> np.ndarray:
        """y (N, size) at ascending times (N,) from t on. Raises BranchLost."""
        if not len(times) or times[-1] == t:
            return np.repeat(y[None, :], len(times), axis=0)
        return self._solved(t, y, float(times[-1]), times=times).at_times

    def descend(
        self, t: float, y: np.ndarray, t_end: float, block: int, height: float
    ) -> tuple[float, np.ndarray] | None:
        """(t, y) where the determinant of a block has come down to `height`; None if that is not before t_end.

        Raises BranchLost where the motion cannot be followed.
        """
        return self._until(t, y, t_end, block, height, -1)

    def rise(self, t: float, y: np.ndarray, t_end: float, block: int, height: float) -> tuple[float, np.ndarray] | None:
        """(t, y) where the magnitude of the determinant has grown to `height`; None if that is not before t_end."""
        return self._until(t, y, t_end, block, height, 1)

    def _until(
        self, t: float, y: np.ndarray, t_end: float, block: int, height: float, direction: int
    ) -> tuple[float, np.ndarray] | None:
        sign = float(np.sign(self.determinants(t, y)[0][block]))

        def above(t: float, y: np.ndarray) -> float:
            return float(sign * self.determinants(t, y)[0][block] - height)

        above.terminal, above.direction = True, direction  # type: ignore[attr-defined]
        try:
            found = self._solved(t, y, t_end, events=above, max_step=(t_end - t) / LOOKS)
        except ValueError:  # not finite
            return None
        return found.end if found.stopped else None

    def _solved(
        self, t: float, y: np.ndarray, t_end: float, times: np.ndarray | None = None, **more: Any
    ) -> Integrated:
        from scipy.integrate import solve_ivp  # when it is needed: importing it takes a third of a second

        self._left = MOST_EVALUATIONS
        found = solve_ivp(self.slope, (t, t_end), y, t_eval=times, method="DOP853", rtol=RTOL, atol=ATOL, **more)
        if not found.success or not np.isfinite(found.y[:, -1]).all():
            raise BranchLost("the equations cannot be integrated near the singular position")
        return Integrated((float(found.t[-1]), found.y[:, -1].copy()), found.status == 1, found.y.T)

    def time_left(self, t: float, y: np.ndarray, block: int) -> float:
        """Time until the determinant of a block is zero, at its present rate [s]; infinite if it grows."""
        value, rate = (part[block] for part in self.determinants(t, y))
        return float(-value / rate) if value * rate < 0 else np.inf
