"""Start in quasi-static elastic equilibrium: elastic coordinates follow the loads without vibrating.

The equilibrium is one that small vibrations do not leave, unless others are asked for: a beam beyond its buckling
load has a straight one too.

At given rigid coordinates and rates the elastic coordinates q_e are those for which q_e_ddot = 0 satisfies the
equations of motion; their rates are those of this equilibrium along the rigid motion. What vibration is left is of
the order of (rigid rate / elastic frequency)^2.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState, InitialStateError
from runtime.contract.coordinates import dependent_part, independent, joined, loop_part, whole
from runtime.contract.model import EmittedModel
from runtime.operating.equilibrium import NoEquilibrium, equilibrium
from runtime.operating.functions import PointFunctions
from runtime.operating.linearise import rigid_rates
from runtime.operating.newton import (
    LARGEST_STEP,
    LEAST_SCALE,
    NEWTON_TOLERANCE,
    NO_SINGULAR_VALUE,
    STAGNANT_CORRECTION,
    Balance,
    balanced,
)
from runtime.schemes.scheme import LARGEST_NUMBER
from runtime.schemes.sparse_lu import Number, factor, solve, solve_symmetric
from runtime.schemes.stage_equations import StageEquations
from runtime.schemes.switching.times import conditions

# ---- What is left of the equations of motion where elastic coordinates have no acceleration.

STATIC_CLOSURE_ITERATIONS = 4


def positions(model: EmittedModel) -> list[int]:
    """Where the elastic coordinates stand in q_i."""
    return [k for k, name in enumerate(model.q_i) if name in model.elastic]


def elastic_residual(model: EmittedModel) -> ca.Function:
    """(t, q_i, q_i_dot, loop unknowns, c) -> residual r, dr/dq_e, mass of q_e, q_d, q_d_dot; built once for a model."""
    return model.derived("elastic_equilibrium", lambda: _built(model, positions(model)))


def _built(model: EmittedModel, elastic: list[int]) -> ca.Function:
    n = len(model.q_i)
    rigid = [k for k in range(n) if k not in elastic]
    t, q, v = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n)
    loop, constants = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
    equations = StageEquations(model, constants)
    motion = equations.close(q, loop, t, STATIC_CLOSURE_ITERATIONS)
    M_hat, Q_hat = equations.condensed(motion, v)
    residual, mass = Q_hat[elastic], M_hat[elastic, elastic]
    if rigid:
        sides = ca.horzcat(Q_hat[rigid], M_hat[rigid, elastic])
        columns = [solve_symmetric(M_hat[rigid, rigid], sides[:, k]) for k in range(sides.size2())]
        residual = residual - ca.mtimes(M_hat[elastic, rigid], columns[0])
        mass = mass - ca.mtimes(M_hat[elastic, rigid], ca.horzcat(*columns[1:]))
    inputs = [t, q, v, loop, constants]
    outputs = [residual, ca.jacobian(residual, q)[:, elastic], mass, motion.q_d, equations.rates(motion, v)]
    return ca.Function("residual", inputs, [ca.densify(output) for output in outputs])


# ---- Quasi-static starts by pure functions, so that runs in lanes share the bits of a run by itself.
#
# Newton's method on r(q_e) = 0, as long as it stays in one valley of the potential: the symmetric part of -dr/dq_e
# is positive definite at every step, no step is long, and each takes at most a quarter of the work r^T d of the one
# before until only rounding is left. There the method of runtime/operating/newton.py makes the same steps, and the
# equilibrium is one that small vibrations do not leave. Where it does not stay, that method decides.

SETTLING_PASSES = 3  # equilibrium and rates depend on each other weakly
SMALL_MOTION = 1e-4  # rad or m that rigid coordinates move between the two equilibria whose difference is the rate
MAX_SETTLING_STEPS = 30
MOST_ELASTIC = 20  # coordinates, above which the slope is not factorised in straight-line code
NEWTON_CONTRACTION = 0.25


def settles(model: EmittedModel) -> bool:
    """Is this for the model?"""
    return 0 < len(positions(model)) <= MOST_ELASTIC and model.has("condensed")


def settling(model: EmittedModel) -> ca.Function:
    """One step of q_e: (t, q_i, q_i_dot, loop, c, work before) -> (q_i, is it open?, is it in its valley?, work).

    The work before the first step is LARGEST_NUMBER. Built once for a model.
    """

    def build() -> ca.Function:
        n, elastic = len(model.q_i), positions(model)
        t, q, v, before = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("before")
        loop, c = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
        r, slope = elastic_residual(model)(t, q, v, loop, c)[:2]
        K = -slope
        step = solve(factor(Number(K)), Number(ca.densify(r))).re
        size, scale, work = ca.norm_inf(step), ca.fmax(LEAST_SCALE, ca.norm_inf(q[elastic])), ca.dot(r, step)
        less = work <= NEWTON_CONTRACTION * before
        not_given = ca.logic_and(size > NEWTON_TOLERANCE * scale, ca.logic_or(less, size > STAGNANT_CORRECTION * scale))
        usual = ca.logic_and(size <= LARGEST_STEP, ca.logic_or(less, size <= STAGNANT_CORRECTION * scale))
        valley = ca.logic_and(
            usual, ca.logic_and(_is_positive(0.5 * (K + K.T)), ca.sum1(ca.fabs(step)) < LARGEST_NUMBER)
        )
        q_next = ca.SX(q)
        q_next[elastic] = q[elastic] + step
        values = [ca.densify(value) for value in (q_next, not_given, valley, work)]
        return ca.Function("settling", [t, q, v, loop, c, before], values)

    return model.derived("settling", build)


def _is_positive(S: ca.SX) -> ca.SX:
    """Is a symmetric matrix positive definite, by more than rounding?"""
    reciprocals = ca.diag(factor(Number(S), symmetric=True).re)
    most = 1 / (NO_SINGULAR_VALUE * ca.norm_inf(ca.diag(S)))
    found = ca.SX(1)
    for k in range(S.size1()):
        found = ca.logic_and(found, ca.logic_and(reciprocals[k] > 0, reciprocals[k] < most))
    return found


def leading(model: EmittedModel) -> ca.Function:
    """(q_i, q_i_dot, q_d, t, c) -> time [s] in which the fastest coordinate but the elastic ones moves by SMALL_MOTION.

    0 at rest. Built once for a model.
    """

    def build() -> ca.Function:
        n_i, n_d = len(model.q_i), len(model.q_d)
        q_i, v, q_d, t = ca.SX.sym("q_i", n_i), ca.SX.sym("v", n_i), ca.SX.sym("q_d", n_d), ca.SX.sym("t")
        c = ca.SX.sym("c", model.c_size)
        q_d_dot = ca.SX(0, 1)
        if n_d:
            q_d_dot = model.evaluate("velocities", q_i=q_i, q_d=q_d, q_i_dot=v, t=t, c=c)["q_d_dot"]
        q_dot = joined(model, v, q_d_dot)
        fastest = ca.norm_inf(
            ca.vertcat(*(q_dot[k] for k, name in enumerate(model.coordinates) if name not in model.elastic))
        )
        return ca.Function("leading", [q_i, v, q_d, t, c], [ca.if_else(fastest > 0, SMALL_MOTION / fastest, 0)])

    return model.derived("leading", build)


def smooth_sides(model: EmittedModel) -> ca.Function:
    """(t, lead, c) -> (1 where nothing jumps in time from t to a lead [s] later, the same to a lead before).

    Rates are differences of two equilibria, and a jump between them is not a rate. Built once for a model.
    """

    def build() -> ca.Function:
        t, lead, c = ca.SX.sym("t"), ca.SX.sym("lead"), ca.SX.sym("c", model.c_size)
        here, later, before = (
            ca.vertcat(ca.SX(1), *(value for _, value in conditions(model, c, at))) for at in (t, t + lead, t - lead)
        )
        # at the very time of a jump it is what lies behind it that begins
        jumped = ca.fmax(here * before < 0, ca.logic_and(here == 0, later * before < 0))
        sides = [1 - ca.mmax(here * later < 0), 1 - ca.mmax(jumped)]
        return ca.Function("smooth_sides", [t, lead, c], sides)

    return model.derived("smooth_sides", build)


def settled(
    model: EmittedModel, c: np.ndarray, t: float, q_i: np.ndarray, v: np.ndarray, q_d: np.ndarray
) -> tuple[np.ndarray, np.ndarray] | None:
    """(q, q_dot) with the elastic coordinates in equilibrium; None where they leave their valley.

    q_i, v (n_i,) and q_d (n_d,): a state that fits. The steps are those of runtime/studies/ensemble/lane_programs.py.
    """
    if not settles(model):
        return None
    loop = q_d[[model.q_d.index(name) for name in model.loop_unknowns]]

    def solved(t: float, start: np.ndarray, v: np.ndarray) -> np.ndarray | None:
        q, before = start, LARGEST_NUMBER
        for _ in range(MAX_SETTLING_STEPS):
            q, not_given, valley, before = settling(model)(t, q, v, loop, c, before)
            if not float(valley) > 0:
                return None
            if not float(not_given) > 0:
                return np.asarray(q).ravel()
        return None

    return _along(model, c, t, (q_i, v, q_d), solved)


Solve = Callable[[float, np.ndarray, np.ndarray], np.ndarray | None]  # (t, q_i, q_i_dot) -> q_i in equilibrium


def _along(
    model: EmittedModel, c: np.ndarray, t: float, start: tuple[np.ndarray, np.ndarray, np.ndarray], solve: Solve
) -> tuple[np.ndarray, np.ndarray] | None:
    """(q, q_dot) with elastic coordinates in equilibrium and its rates along the motion; None where `solve` gives none.

    start: q_i, q_i_dot, q_d.
    """
    (q_i, v), q_d = (part.copy() for part in start[:2]), start[2]
    elastic = positions(model)
    rigid = [k for k in range(len(q_i)) if k not in elastic]
    lead = float(leading(model)(q_i, v, q_d, t, c))
    later, before = (float(side) for side in smooth_sides(model)(t, lead, c))
    for _ in range(SETTLING_PASSES):
        found = solve(t, q_i, v)
        if found is None:
            return None
        q_i = found
        if lead > 0 and later + before > 0:
            ends = []
            for at in (later * lead, -before * lead):
                moved = q_i.copy()
                moved[rigid] = moved[rigid] + at * v[rigid]
                end = solve(t + at, moved, v)
                if end is None:
                    return None
                ends.append(end[elastic])
            v[elastic] = (ends[0] - ends[1]) / ((later + before) * lead)
    loop = q_d[[model.q_d.index(name) for name in model.loop_unknowns]]
    q_d, q_d_dot = elastic_residual(model)(t, q_i, v, loop, c)[3:]
    return whole(model, q_i, np.asarray(q_d).ravel()), whole(model, v, np.asarray(q_d_dot).ravel())


UNSETTLED = 1e-3  # rad or m that a spring would move a rigid coordinate
UNSTABLE_CURVATURE = 1e-10  # curvature, relative to the largest one, beyond which it is more than rounding


def quasi_static_state(
    model: EmittedModel, c: np.ndarray, t: float, state: ConsistentState, unstable: bool = False
) -> ConsistentState:
    """The state with elastic coordinates in equilibrium. Raises InitialStateError where there is none in reach.

    unstable: may the equilibrium be one that the elastic coordinates leave (a buckled body, straight)?
    """
    elastic = positions(model)
    if not elastic:
        return state
    q_i, v = independent(model, state.q, state.q_dot)
    q_d, loop = dependent_part(model, state.q), loop_part(model, state.q)
    found = settled(model, c, t, q_i, v, q_d)
    if found is None:
        solver = ElasticEquilibrium(model, elastic, c, unstable)
        found = _along(model, c, t, (q_i, v, q_d), lambda t, q_i, v: solver.solve(t, q_i, v, loop))
    assert found is not None
    return _with_settling(model, c, t, _with_elastic(model, state, *found))


def _with_elastic(model: EmittedModel, state: ConsistentState, q: np.ndarray, q_dot: np.ndarray) -> ConsistentState:
    """q and q_dot, and what of the state's elastic coordinates they change."""
    changed = {
        name: (float(state.q[k]), float(q[k]))
        for k, name in enumerate(model.coordinates)
        if name in model.elastic and q[k] != state.q[k]
    }
    not_given = state.not_given | changed.keys()  # the start asks for their places
    return replace(state, q=q, q_dot=q_dot, changed={**state.changed, **changed}, not_given=not_given)


def _with_settling(model: EmittedModel, c: np.ndarray, t: float, state: ConsistentState) -> ConsistentState:
    """The state, with rigid coordinates that springs pull away from it named."""
    off = unsettled(model, c, t, state)
    if not off:
        return state
    text = ", ".join(f"{name} (by about {by:.3g})" for name, by in off.items())
    text = f"quasi_static settles elastic coordinates only, and springs pull {text}: start = equilibrium settles all"
    return replace(state, reported=(*state.reported, ("not_settled", text)))


def unsettled(model: EmittedModel, c: np.ndarray, t: float, state: ConsistentState) -> dict[str, float]:
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


def small_motion(model: EmittedModel, q_dot: np.ndarray) -> tuple[float, int]:
    """(time [s] in which the fastest coordinate but the elastic ones moves by SMALL_MOTION, its column); 0: at rest."""
    speeds = np.abs(q_dot)
    speeds[[model.coordinates.index(name) for name in model.elastic]] = 0.0
    fastest = int(speeds.argmax())
    return (SMALL_MOTION / float(speeds[fastest]) if speeds[fastest] > 0 else 0.0), fastest


class ElasticEquilibrium:
    """Elastic coordinates (positions in q_i) for which q_e_ddot = 0 satisfies the equations, constants c (c_size,)."""

    def __init__(self, model: EmittedModel, elastic: list[int], c: np.ndarray, unstable: bool) -> None:
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
                "there is no quasi-static elastic equilibrium near the initial state (a soft or buckled "
                "body, or rigid bodies on stiff springs?): start = equilibrium, which settles these, too, "
                "or given, with elastic coordinates of your own"
            )
        if not self.unstable and float(_curvatures(at).max()) > UNSTABLE_CURVATURE * float(
            np.abs(_curvatures(at)).max()
        ):
            raise InitialStateError(
                "the quasi-static elastic equilibrium is unstable (a body beyond its buckling load or speed?): give an "
                "elastic coordinate a small value to start from, or ask for it with start = quasi_static_unstable"
            )
        return q


def _curvatures(at: Balance) -> np.ndarray:
    """Real parts of the squares of the rates at which small deviations grow or, negative, vibrate [1/s^2]."""
    return np.asarray(np.linalg.eigvals(np.linalg.solve(at[2], at[1])).real)


def _soft(at: Balance) -> bool:
    """Is there an elastic coordinate without stiffness?"""
    return bool(np.linalg.matrix_rank(at[1]) < len(at[1]))


def equilibrium_state(
    model: EmittedModel, p: np.ndarray, c: np.ndarray, t0: float, state: ConsistentState
) -> ConsistentState:
    """The equilibrium reached from a state: all coordinates settle but those that turn, which keep their rates.

    Prescribed motions are held while it is sought, and begin with their rates. Raises InitialStateError.
    """
    rates = rigid_rates(model, state.q, state.q_dot)
    values = {one.name: float(value) for one, value in zip(model.parameters, p, strict=True) if value != one.default}
    place = {name: float(state.q[k]) for k, name in enumerate(model.coordinates)}
    try:
        found = equilibrium(model, rates=rates, parameters=values, initial=place, t=t0)
    except NoEquilibrium as error:
        raise InitialStateError(f"start = equilibrium: {error}") from error
    q, q_dot = found.q, PointFunctions(model, c)(found.state).q_dot
    changed = {
        name: (float(before), float(after))
        for name, before, after in zip(model.coordinates, state.q, q, strict=True)
        if before != after
    }
    not_given = state.not_given | changed.keys()  # the start asks for their places
    return replace(state, q=q, q_dot=q_dot, changed={**state.changed, **changed}, not_given=not_given)
