"""Start in quasi-static elastic equilibrium: elastic coordinates follow the loads without vibrating.

The equilibrium is one that small vibrations do not leave, unless others are asked for: a beam beyond its buckling
load has a straight one too.

At given rigid coordinates and rates the elastic coordinates q_e are those for which q_e_ddot = 0 satisfies the
equations of motion; their rates are those of this equilibrium along the rigid motion. What vibration is left is of
the order of (rigid rate / elastic frequency)^2.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from runtime.contract.consistent_state import ConsistentState, InitialStateError
from runtime.contract.coordinates import dependent_part, independent, loop_part, whole
from runtime.contract.model import Model
from runtime.operating.newton import Balance, balanced
from runtime.start.elastic_residual import elastic_residual, positions
from runtime.start.settling import PASSES, SMALL_MOTION, settled

UNSETTLED = 1e-3  # rad or m that a spring would move a rigid coordinate
UNSTABLE = 1e-10  # curvature, relative to the largest one, beyond which it is more than rounding


def quasi_static_state(
    model: Model, c: np.ndarray, t: float, state: ConsistentState, unstable: bool = False
) -> ConsistentState:
    """The state with elastic coordinates in equilibrium. Raises InitialStateError where there is none in reach.

    unstable: may the equilibrium be one that the elastic coordinates leave (a buckled body, straight)?
    """
    elastic = positions(model)
    if not elastic:
        return state
    q_i, v = independent(model, state.q, state.q_dot)
    quick = settled(model, c, t, q_i, v, dependent_part(model, state.q))
    if quick is not None:
        return _told(model, c, t, _with_elastic(model, state, *quick))
    solver = ElasticEquilibrium(model, elastic, c, unstable)
    loop = loop_part(model, state.q)
    rigid = [k for k in range(len(q_i)) if k not in elastic]
    step, _ = small_motion(model, state.q_dot)
    for _ in range(PASSES):
        q_i = solver.solve(t, q_i, v, loop)
        if step > 0:
            moved = []
            for sign in (1, -1):
                at = q_i.copy()
                at[rigid] += sign * step * v[rigid]
                moved.append(solver.solve(t + sign * step, at, v, loop)[elastic])
            v[elastic] = (moved[0] - moved[1]) / (2 * step)
    return _told(model, c, t, _with_elastic(model, state, *solver.closed(t, q_i, v, loop)))


def _with_elastic(model: Model, state: ConsistentState, q: np.ndarray, q_dot: np.ndarray) -> ConsistentState:
    """q and q_dot, and what of the state's elastic coordinates they change."""
    changed = {
        name: (float(state.q[k]), float(q[k]))
        for k, name in enumerate(model.coordinates)
        if name in model.elastic and q[k] != state.q[k]
    }
    return replace(state, q=q, q_dot=q_dot, changed={**state.changed, **changed})


def _told(model: Model, c: np.ndarray, t: float, state: ConsistentState) -> ConsistentState:
    """The state, with rigid coordinates that springs pull away from it named."""
    off = unsettled(model, c, t, state)
    if not off:
        return state
    text = ", ".join(f"{name} (by about {by:.3g})" for name, by in off.items())
    text = f"quasi_static settles elastic coordinates only, and springs pull {text}: start = equilibrium settles all"
    return replace(state, told=(*state.told, ("not_settled", text)))


def unsettled(model: Model, c: np.ndarray, t: float, state: ConsistentState) -> dict[str, float]:
    """Rigid coordinates at rest that their springs would move by more than UNSETTLED, and by how much [rad, m]."""
    if not model.has("deflections") or not model.has("condensed"):
        return {}
    found = {name: np.asarray(value) for name, value in model.evaluate("deflections", c=c).items()}
    stiffness = np.einsum("ik,kl,il->i", found["B"], found["K_s"], found["B"])
    q_i, v = independent(model, state.q, state.q_dot)
    at = {"q_i": q_i, "q_d": dependent_part(model, state.q), "t": t, "c": c}
    at |= {"q_i_dot": v, "q_d_dot": dependent_part(model, state.q_dot)}
    Q = np.asarray(model.evaluate("condensed", **at)["Q_hat"]).ravel()
    rigid = [k for k, name in enumerate(model.q_i) if name not in model.elastic and stiffness[k] > 0 and v[k] == 0]
    return {model.q_i[k]: abs(Q[k]) / stiffness[k] for k in rigid if abs(Q[k]) > UNSETTLED * stiffness[k]}


def small_motion(model: Model, q_dot: np.ndarray) -> tuple[float, int]:
    """(time [s] in which the fastest coordinate but the elastic ones moves by SMALL_MOTION, its column); 0: at rest."""
    speeds = np.abs(q_dot)
    speeds[[model.coordinates.index(name) for name in model.elastic]] = 0.0
    fastest = int(speeds.argmax())
    return (SMALL_MOTION / float(speeds[fastest]) if speeds[fastest] > 0 else 0.0), fastest


class ElasticEquilibrium:
    """Elastic coordinates (positions in q_i) for which q_e_ddot = 0 satisfies the equations, constants c (c_size,)."""

    def __init__(self, model: Model, elastic: list[int], c: np.ndarray, unstable: bool) -> None:
        self.model, self.elastic, self.c, self.unstable = model, elastic, c, unstable
        self._residual = elastic_residual(model)

    def solve(self, t: float, q_i: np.ndarray, v: np.ndarray, loop: np.ndarray) -> np.ndarray:
        """q_i with its elastic entries in equilibrium."""
        q = q_i.copy()

        def balance(x: np.ndarray) -> Balance | None:
            q[self.elastic] = x
            residual, slope, mass = (np.asarray(value) for value in self._residual(t, q, v, loop, self.c)[:3])
            finite = all(np.isfinite(value).all() for value in (residual, slope, mass))
            return (residual.ravel(), slope, mass) if finite else None

        found = balanced(balance, q_i[self.elastic])
        at = balance(found.x) if found.converged else None
        if at is None or _soft(at):
            raise InitialStateError(
                "there is no quasi-static elastic equilibrium in reach of the initial state (a soft or buckled "
                "body, or rigid ones that stiff springs throw about?): start = equilibrium, which settles these, too, "
                "or given, with elastic coordinates of your own"
            )
        if not self.unstable and float(_curvatures(at).max()) > UNSTABLE * float(np.abs(_curvatures(at)).max()):
            raise InitialStateError(
                "the quasi-static elastic equilibrium is unstable (a body beyond its buckling load or speed?): give an "
                "elastic coordinate a small value to start from, or ask for it with start = quasi_static_unstable"
            )
        return q

    def closed(self, t: float, q_i: np.ndarray, v: np.ndarray, loop: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """All coordinates and rates."""
        q_d, q_d_dot = self._residual(t, q_i, v, loop, self.c)[3:]
        return whole(self.model, q_i, np.asarray(q_d).ravel()), whole(self.model, v, np.asarray(q_d_dot).ravel())


def _curvatures(at: Balance) -> np.ndarray:
    """Real parts of the squares of the rates at which small deviations grow or, negative, vibrate [1/s^2]."""
    return np.asarray(np.linalg.eigvals(np.linalg.solve(at[2], at[1])).real)


def _soft(at: Balance) -> bool:
    """Is there an elastic coordinate without stiffness?"""
    return bool(np.linalg.matrix_rank(at[1]) < len(at[1]))
