"""Across a singular position (a singular configuration) in one step of order 8, none of whose stages comes near it.

At a singular position of the mechanism C_q loses rank, and with it every choice of q_i; the motion on its branch is
smooth all the same. So the right-hand side is evaluated before and after it only: the singular time t_s is placed in
the largest gap between the nodes of DOP853, 1/3 and 0.6 of the step. Loop unknowns are integrated along, which gives
the closure a guess on the branch that the motion is on.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from runtime.baselines.condensed_ode import CondensedOde, integrated
from runtime.contract.coordinates import whole
from runtime.contract.model import EmittedModel
from runtime.contract.status import Status
from runtime.engine.rows import evaluate
from runtime.running.singular.singularity_monitor import LoopDeterminants
from runtime.solutions.observe import assemble_solution
from runtime.solutions.solution import Solution

IN_THE_GAP = 7 / 15  # of the step, in the middle of the gap
# determinants, of the largest, from which the step over the position is tried; rounding of q_ddot goes as det^-3
CLOSEST = (0.1, 0.05, 0.02, 0.004, 0.0008)
STEP_ERROR = 1e-9  # error estimate of the step over the position, relative
CONTINUITY = 1e-5  # by how much q may miss the integral of q_dot over the step, relative to its way
ENERGY = 1e-8  # change of energy in the step, of the largest energy in motion
TIMES_AHEAD = 3.0  # times the time that the determinant takes to zero at its present rate


@dataclass(frozen=True)
class Crossing:
    """One step over a singular position at t_s [s], from (t_near, y_near) before it to (t, y) behind it.

    y = (q_i, q_i_dot, loop unknowns) (size,); energy_change [J]: of the whole step.
    """

    t_s: float
    t: float
    y: np.ndarray
    energy_change: float
    t_near: float
    y_near: np.ndarray

    def ends(self, integrator: TightIntegrator) -> Solution:
        """The two states between which the step over the position lies."""
        return integrator.observed(np.array([self.t_near, self.t]), np.array([self.y_near, self.y]))


def turned_back(t: float, y: np.ndarray) -> Crossing:
    """Of a motion that from t [s] on does not reach the position: nothing to step over, and t_near = t."""
    return Crossing(t, t, y, 0.0, t, y)


def between(over: Solution, t: float) -> tuple[np.ndarray, np.ndarray]:
    """(q, q_dot) at a time inside the step, by the polynomial through q, q_dot and q_ddot at its ends."""
    H = float(over.t[1] - over.t[0])
    s = (t - float(over.t[0])) / H
    q, v, a = over.q, over.q_dot * H, over.q_ddot * H * H
    rest = (q[1] - q[0] - v[0] - a[0] / 2, v[1] - v[0] - a[0], a[1] - a[0])
    c3 = 10 * rest[0] - 4 * rest[1] + rest[2] / 2
    c4 = -15 * rest[0] + 7 * rest[1] - rest[2]
    c5 = 6 * rest[0] - 3 * rest[1] + rest[2] / 2
    position = q[0] + s * (v[0] + s * (a[0] / 2 + s * (c3 + s * (c4 + s * c5))))
    rate = v[0] + s * (a[0] + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))
    return position, rate / H


def approach(
    integrator: TightIntegrator, t: float, y: np.ndarray, block: int, height: float
) -> tuple[float, np.ndarray] | None:
    """(t, y) where the determinant has come down to `height` on its way to zero; None if it turns before that."""
    left = integrator.time_left(t, y, block)
    if not np.isfinite(left):
        return None
    now = abs(float(integrator.determinants(t, y)[0][block]))
    if now <= height:
        return (t, y) if now > 0.5 * height else None
    return integrator.until(t, y, t + TIMES_AHEAD * left, block, height, -1)


def cross(integrator: TightIntegrator, t: float, y: np.ndarray, block: int, largest: float) -> Crossing:
    """Over the singular position that lies ahead of (t, y). Raises BranchLost."""
    reason = "it could not be approached"
    for closest in CLOSEST:
        try:
            near = approach(integrator, t, y, block, closest * largest)
            if near is None:
                continue
            return _step_over(integrator, *near, block)
        except BranchLost as error:
            reason = str(error)
    raise BranchLost(reason)


def _step_over(integrator: TightIntegrator, t: float, y: np.ndarray, block: int) -> Crossing:
    """One step, placed twice: the second time by the determinants on both sides."""
    ahead = _time_to_zero(integrator, t, y, block)
    end, error = _step(integrator, t, y, ahead / IN_THE_GAP)
    H = ahead / IN_THE_GAP
    ahead = _zero_between(integrator, (t, y), (t + H, end), block)
    if not 0.3 * H < ahead < 0.7 * H:
        raise BranchLost("the singular time is not where the determinant leads to")
    H = ahead / IN_THE_GAP
    end, error = _step(integrator, t, y, H)
    if error > STEP_ERROR:
        raise BranchLost(f"a step of {H:.3g} s over it is not accurate (error {error:.2g})")
    found = Crossing(t + ahead, t + H, end, _checked(integrator, t, y, H, end), t, y)
    return replace(found, t_s=_zero_inside(integrator, found, block))


def _zero_inside(integrator: TightIntegrator, crossing: Crossing, block: int) -> float:
    """The singular time, by the motion inside the step; that of the placement where the determinant has no sign."""
    from scipy.optimize import brentq  # when it is needed: importing it takes long

    over = crossing.ends(integrator)

    def determinant(t: float) -> float:
        return float(integrator.loops.determinants(t, *between(over, t))[0][block])

    if determinant(crossing.t_near) * determinant(crossing.t) > 0:
        return crossing.t_s
    return float(brentq(determinant, crossing.t_near, crossing.t, xtol=1e-13))


def _step(integrator: TightIntegrator, t: float, y: np.ndarray, H: float) -> tuple[np.ndarray, float]:
    """(y after one step of DOP853, its error estimate relative to y)."""
    from scipy.integrate import DOP853  # when it is needed: importing it takes a third of a second

    K: list[np.ndarray] = []
    for row, node in zip(DOP853.A, DOP853.C, strict=True):
        at = y + H * sum((w * k for w, k in zip(row, K, strict=False)), np.zeros_like(y))
        K.append(integrator.slope(t + node * H, at))
    end = y + H * sum((w * k for w, k in zip(DOP853.B, K, strict=True)), np.zeros_like(y))
    K.append(integrator.slope(t + H, end))
    if not np.isfinite(end).all() or not np.isfinite(K[-1]).all():
        raise BranchLost("the equations are not finite beside it")
    fifth, third = (
        H * sum((w * k for w, k in zip(E, K, strict=True)), np.zeros_like(y)) / (1.0 + np.abs(y))
        for E in (DOP853.E5, DOP853.E3)
    )
    size = np.linalg.norm(fifth)  # SciPy's combination of the two estimates
    return end, float(size**2 / np.hypot(size, 0.1 * np.linalg.norm(third))) if size > 0 else 0.0


def _time_to_zero(integrator: TightIntegrator, t: float, y: np.ndarray, block: int) -> float:
    """By u = det / det', which falls linearly to zero at a root of any multiplicity."""
    left = integrator.time_left(t, y, block)
    earlier = t - 0.5 * left
    before = integrator.solved(t, y, earlier).y[:, -1].copy()
    slope = (integrator.time_left(earlier, before, block) - left) / (t - earlier)
    return left / slope if 0.2 < slope < 2 else left


def _zero_between(
    integrator: TightIntegrator, before: tuple[float, np.ndarray], after: tuple[float, np.ndarray], block: int
) -> float:
    """Time from `before` to the zero of the determinant; of a cubic where it changes sign, else of det / det'."""
    H = after[0] - before[0]
    (f0, g0), (f1, g1) = (
        (value[block], rate[block] * H) for value, rate in (integrator.determinants(t, y) for t, y in (before, after))
    )
    if f0 * f1 < 0:
        roots = np.roots([2 * (f0 - f1) + g0 + g1, 3 * (f1 - f0) - 2 * g0 - g1, g0, f0])
        inside = [root.real for root in roots if abs(root.imag) < 1e-9 and 0 <= root.real <= 1]
        if inside:
            return float(inside[0] * H)
    u0, u1 = f0 / g0, f1 / g1
    return float(-u0 * H / (u1 - u0)) if u1 != u0 else 0.0


def _checked(integrator: TightIntegrator, t: float, y: np.ndarray, H: float, end: np.ndarray) -> float:
    """The change of energy [J] over a step that kept the branch. Raises BranchLost."""
    observed = integrator.observed(np.array([t, t + H]), np.array([y, end]))
    if not np.isfinite(observed.q).all() or observed.constraint_error.max() > 1e-9:
        raise BranchLost("the constraints do not hold behind it")
    q, v, a = observed.q, observed.q_dot, observed.q_ddot
    missed = np.abs(q[1] - q[0] - H / 2 * (v[0] + v[1]) + H**2 / 12 * (a[1] - a[0])).max()
    if not missed <= CONTINUITY * H * np.abs(v).max() + 1e-13:
        raise BranchLost(f"the velocities behind it do not continue those before it ({missed:.2g})")
    change = float(observed.energy_balance()[-1])
    motion = float((observed.energy["kinetic"] + observed.energy["elastic"]).max())
    power = np.abs(
        observed.energy["power_applied"] + observed.energy["power_driven"] - observed.energy["power_dissipated"]
    )
    if not abs(change) <= ENERGY * motion + 1e-2 * H * float(np.ptp(power)) + 1e-14:
        raise BranchLost(f"energy changes by {change:.3g} J")
    return change


# The condensed equations integrated tightly for short times: to see where a motion near a singular position leads.

STAGE_CLOSURES = 5  # Newton steps: stages lie near the position, and guesses of early stages are of low order
TIGHT_RTOL, TIGHT_ATOL = 1e-11, 1e-13
MOST_CROSSING_EVALUATIONS = 3_000  # of one question; a way to a singular position takes some hundreds
DETERMINANT_LOOKS = 12  # steps at least while the determinant is followed down


class BranchLost(Exception):
    """No step over the singular position keeps the branch and the energy; the message says why."""


class TightIntegrator:
    """Integrates the condensed equations of a model tightly, for short times.

    asked: was Ctrl-C pressed? Then KeyboardInterrupt is raised from where it is.
    """

    def __init__(
        self, model: EmittedModel, p: np.ndarray, c: np.ndarray, asked: Callable[[], bool] = lambda: False
    ) -> None:
        self.model, self.p, self.c, self.asked = model, p.copy(), c.copy(), asked  # events change those of the run
        self._rhs = model.derived("integrator", lambda: CondensedOde(model, STAGE_CLOSURES).right_hand_side())
        self._observe = model.derived("tight_observe", lambda: CondensedOde(model, STAGE_CLOSURES).observe())
        self.loops = LoopDeterminants(model, c)
        self._left = MOST_CROSSING_EVALUATIONS

    def pack(self, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
        """y of a consistent state."""
        return integrated(self.model, q, q_dot)

    def slope(self, t: float, y: np.ndarray) -> np.ndarray:
        """y_dot (size,). Raises BranchLost after MOST_CROSSING_EVALUATIONS of one question: steps shrink for ever."""
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
            name: whole(self.model, found[f"q_i{end}"], found[f"q_d{end}"])
            for name, end in (("q", ""), ("q_dot", "_dot"), ("q_ddot", "_ddot"))
        }

    def observed(self, t: np.ndarray, y: np.ndarray) -> Solution:
        """Closed states with energies at times t (N,), y (N, size)."""
        at, ended = self.states(t, y), Status("completed", float(t[-1]))
        motion = at["q"], at["q_dot"], at["q_ddot"]
        return assemble_solution(self.model, t, *motion, self.p, self.c, "integrator", 0.0, [], {}, ended)

    def determinants(self, t: float, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Of the loop blocks, and their rates."""
        state = self.states(np.array([t]), y[None, :])
        return self.loops.determinants(t, state["q"][0], state["q_dot"][0])

    def path(self, t: float, y: np.ndarray, times: np.ndarray) -> np.ndarray:
        """y (N, size) at ascending times (N,) from t on. Raises BranchLost."""
        if not len(times) or times[-1] == t:
            return np.repeat(y[None, :], len(times), axis=0)
        return np.asarray(self.solved(t, y, float(times[-1]), t_eval=times).y.T)

    def until(
        self, t: float, y: np.ndarray, t_end: float, block: int, height: float, direction: int
    ) -> tuple[float, np.ndarray] | None:
        """(t, y) where the magnitude of the determinant of a block has come to `height`; None if not before t_end.

        direction: -1 down, 1 up. Raises BranchLost where the motion cannot be followed.
        """
        sign = float(np.sign(self.determinants(t, y)[0][block]))

        def above(t: float, y: np.ndarray) -> float:
            return float(sign * self.determinants(t, y)[0][block] - height)

        above.terminal, above.direction = True, direction  # type: ignore[attr-defined]
        try:
            found = self.solved(t, y, t_end, events=above, max_step=(t_end - t) / DETERMINANT_LOOKS)
        except ValueError:  # not finite
            return None
        return (float(found.t[-1]), found.y[:, -1].copy()) if found.status == 1 else None

    def solved(self, t: float, y: np.ndarray, t_end: float, **settings: Any) -> Any:
        """What SciPy's solve_ivp gives. Raises BranchLost."""
        from scipy.integrate import solve_ivp  # when it is needed: importing it takes a third of a second

        self._left = MOST_CROSSING_EVALUATIONS
        found = solve_ivp(self.slope, (t, t_end), y, method="DOP853", rtol=TIGHT_RTOL, atol=TIGHT_ATOL, **settings)
        if not found.success or not np.isfinite(found.y[:, -1]).all():
            raise BranchLost("the equations cannot be integrated near the singular position")
        return found

    def time_left(self, t: float, y: np.ndarray, block: int) -> float:
        """Time until the determinant of a block is zero, at its present rate [s]; infinite if it grows."""
        value, rate = (part[block] for part in self.determinants(t, y))
        return float(-value / rate) if value * rate < 0 else np.inf
