"""Where a differentiated run starts for values of what is differentiated by, and how that moves with them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState, InitialStateError
from runtime.contract.coordinates import independent, independent_slopes, joined, loop_part, parameter_columns
from runtime.contract.errors import NoResult
from runtime.contract.model import EmittedModel
from runtime.contract.orientations import angular_velocity, chart_rates, exponential, parameter_rates, product
from runtime.contract.tape import shared
from runtime.gradients.impacts import held_at_start, held_slopes
from runtime.gradients.observed_program import ObservedProgram
from runtime.gradients.variables import Variables, independent_turns, parameters_at
from runtime.operating.given_state import given_state
from runtime.running.monitor import Monitor
from runtime.running.problem import Plan
from runtime.running.singular.singularity_monitor import SingularityMonitor
from runtime.running.time_functions import check_time_functions
from runtime.schemes.stage_equations import StageEquations
from runtime.schemes.stepper import start_vector
from runtime.start.quasi_static import (
    SETTLING_PASSES,
    STATIC_CLOSURE_ITERATIONS,
    ElasticEquilibrium,
    elastic_residual,
    small_motion,
    smooth_sides,
)
from runtime.start.start_state import start_state

Given = Mapping[str, float]


class StartOfRun:
    """parameters and initial: values by name that hold where x says nothing else; start: as `simulate` takes it."""

    def __init__(
        self,
        program: ObservedProgram,
        plan: Plan,
        variables: Variables,
        parameters: Given,
        initial: Given,
        start: str | None,
    ) -> None:
        self._program, self._plan, self._variables = program, plan, variables
        self._model = plan.scheme.model
        self._parameters, self._initial = dict(parameters), dict(initial)
        self._start, self._kind = start, self._kind_of(start)

    def on(self, program: ObservedProgram, plan: Plan, parameters: Given | None = None) -> StartOfRun:
        """The same start of a program and plan with other steps, another time and further parameters."""
        own = {**self._parameters, **(parameters or {})}
        return StartOfRun(program, plan, self._variables, own, self._initial, self._start)

    def values(self) -> np.ndarray:
        """(n,) x of the start: what was given, else what the model says. Raises ModelError for a motion that jumps."""
        p = parameters_at(self._model, self._parameters, self._plan.t0)
        c = self._model.constants(p)
        state = start_state(self._model, p, c, self._plan.t0, self._initial, self._kind)
        check_time_functions(self._model, c, self._plan, state)
        x = np.zeros(len(self._variables.names))
        for k, entry, _ in self._variables.parameters:
            x[k] = p[entry]
        for k, column, is_rate in self._variables.initial:
            x[k] = (state.q_dot if is_rate else state.q)[column]
        for k, value in self._variables.samples:
            x[k] = value
        for k, body, axis, is_rate in self._variables.turns:
            e = parameter_columns(self._model)[body]
            x[k] = angular_velocity(state.q[e], state.q_dot[e])[axis] if is_rate else 0.0
        return x

    def started(self, x: np.ndarray, slopes: bool) -> StartedRun:
        """The beginning for values x (n,), with its derivatives if they are asked for. Raises NoResult."""
        parameters, initial = self._variables.named(x)
        given = turned_start(self._model, {**self._initial, **initial}, self._variables, x)
        model, scheme, plan = self._model, self._plan.scheme, self._plan
        p = parameters_at(model, {**self._parameters, **parameters}, plan.t0)
        c = model.constants(p)
        state = start_state(model, p, c, plan.t0, given, self._kind)
        z = self._program.prepared.widened(start_vector(scheme, plan.t0, state.q, state.q_dot, c))
        if (held := held_at_start(scheme, z, c, p)) is not None:
            c = model.constants(p)
            z = self._program.prepared.widened(start_vector(scheme, plan.t0, state.q, state.q_dot, c))
        moved = self._slopes(p, c, given, state, x) if slopes else np.zeros((0, 0))
        checks = RunChecks(plan, c, p)
        checks.begin(z)
        where = np.concatenate([p, *independent(model, state.q, state.q_dot), loop_part(model, state.q)])
        if slopes and held is not None:
            moved = held_slopes(model, plan.t0, where, moved, self._variables.names, held)
        return StartedRun(
            z, self._program.prepared.ready(scheme.constants(c)), where, moved, x, checks, (state.q, state.q_dot)
        )

    def _slopes(self, p: np.ndarray, c: np.ndarray, given: Given, state: ConsistentState, x: np.ndarray) -> np.ndarray:
        """d(p, q_i, q_i_dot, loop unknowns)/dx at the start's state."""
        model, t0 = self._model, self._plan.t0
        assembled = state if self._kind == "given" else given_state(model, p, c, t0, given)
        slopes = start_slopes(model, p, t0, assembled, given, self._variables, x)
        if self._kind == "given" or not set(model.elastic) & set(model.q_i):
            return slopes
        return settled_slopes(model, p, c, t0, assembled, slopes, self._kind == "quasi_static_unstable")

    def _kind_of(self, start: str | None) -> str:
        """As a simulation takes it. Raises InitialStateError for one that does not go with `by`."""
        chosen = start or str(self._model.simulation.get("start", "given"))
        if chosen == "equilibrium":
            raise InitialStateError(
                "start = equilibrium is not differentiated: give its values as initial, or take quasi_static"
            )
        names = {name + end for name in self._model.elastic for end in ("", "_dot")}
        if start is None and names & {*self._initial, *self._variables.names}:
            return "given"
        following = ", ".join(sorted(names & set(self._variables.names)))
        if chosen != "given" and following:
            raise InitialStateError(
                f"start = {chosen}: {following} follow from the equilibrium; do not name them, or take start = given"
            )
        return chosen


# How the start of a run moves with parameters and given initial values.
#
# Where only q_i and their rates are given they stay what they are, and the scheme closes the loops: what that means
# for q_d is in its start. Where other coordinates are given the assembly solves C = 0 and C_q q_dot + C_t = 0 for those
# that are left open, and their slopes follow by the implicit-function theorem:
#
#     C_q dq + C_c dc = 0,    C_q dq_dot + d(C_q q_dot + C_t)/dq dq + d(C_q q_dot + C_t)/dc dc = 0

RANK = 1e-9  # of the largest singular value: less means that the assembly leaves a coordinate open
OPEN = 1e-8  # of the largest slope: more means that what was given had to move


def start_slopes(
    model: EmittedModel,
    p: np.ndarray,
    t0: float,
    state: ConsistentState,
    given: Mapping[str, float],
    by: Variables,
    x: np.ndarray,
) -> np.ndarray:
    """d(p, q_i, q_i_dot, loop unknowns)/d(variables), (n_x, n); given: all initial values by name, the variables' too.

    x (n,): the variables. Raises InitialStateError where the assembly leaves open or moves what would have to be known.
    """
    n, n_p = len(model.coordinates), len(p)
    dp, dq, dv = np.zeros((n_p, len(by.names))), np.zeros((n, len(by.names))), np.zeros((n, len(by.names)))
    for k, entry, _ in by.parameters:
        dp[entry, k] = 1.0
    for k, column, is_rate in by.initial:
        (dv if is_rate else dq)[column, k] = 1.0
    _turn_slopes(model, state, by, x, dq, dv)
    free_q, free_v = _open(model, given, rates=False), _open(model, given, rates=True)
    _require_kept(model, given, free_q, model.initial_q, state.q, "")
    _require_kept(model, given, free_v, model.initial_q_dot, state.q_dot, "_dot")
    dependent = set(map(int, model.dependent_columns)) - set(_independent_parameters(model))
    if model.constraints and (set(free_q) != dependent or set(free_v) != dependent):
        _assembled(model, p, t0, state, dp, dq, dv, free_q, free_v)
    return np.concatenate([dp, *independent_slopes(model, state.q, state.q_dot, dq, dv)])


def _open(model: EmittedModel, given: Mapping[str, float], rates: bool) -> list[int]:
    """Coordinates (or rates) that the assembly finds, in the way of runtime.operating.given_state."""
    end = "_dot" if rates else ""
    named = {name for name in model.coordinates if name + end in given}
    own = {*model.q_i, *(model.coordinates[k] for k in _independent_parameters(model))}
    kept = {name for name in own if named <= own or name in model.elastic}
    return [k for k, name in enumerate(model.coordinates) if name not in named | kept]


def _independent_parameters(model: EmittedModel) -> list[int]:
    """Columns of q of the Euler parameters of orientations that are independent."""
    return [int(column) for k in independent_turns(model) for column in model.places.parameters[k]]


def turned_start(model: EmittedModel, given: Given, by: Variables, x: np.ndarray) -> dict[str, float]:
    """Initial values by name, with the Euler parameters and their rates of orientations that x (n,) turns.

    Raises InitialStateError for an orientation that is given by Euler angles.
    """
    found = dict(given)
    angles_of = {one.name: one.angles for one in model.description.bodies}
    for body in {one[1]: None for one in by.turns}:
        columns = parameter_columns(model)[body]
        names, axes = [model.coordinates[k] for k in columns], [f"{body}.omega_{axis}" for axis in "xyz"]
        angles = [name for name in angles_of.get(body, ()) if name in found]
        if angles:
            raise InitialStateError(
                f"the start is turned further from {angles[0]}: give the orientation of {body} by its Euler parameters"
            )
        e = np.array([found.get(name, value) for name, value in zip(names, model.initial_q[columns], strict=True)])
        e_dot = [found.pop(f"{name}_dot", v) for name, v in zip(names, model.initial_q_dot[columns], strict=True)]
        omega = angular_velocity(e, np.array(e_dot))
        omega = np.array([found.pop(name, value) for name, value in zip(axes, omega, strict=True)])
        for k, owner, axis, is_rate in by.turns:
            if owner == body and is_rate:
                omega[axis] = x[k]
        e = product(e, exponential(_rotation(by, body, x)))
        found |= dict(zip(names, e.tolist(), strict=True))
        found |= {f"{name}_dot": float(v) for name, v in zip(names, parameter_rates(e, omega), strict=True)}
    return found


def _rotation(by: Variables, body: str, x: np.ndarray) -> np.ndarray:
    """(3,) the rotation vector among the variables that turns a body further."""
    found = np.zeros(3)
    for k, owner, axis, is_rate in by.turns:
        if owner == body and not is_rate:
            found[axis] = x[k]
    return found


def _turn_slopes(
    model: EmittedModel, state: ConsistentState, by: Variables, x: np.ndarray, dq: np.ndarray, dv: np.ndarray
) -> None:
    """Fill the rows of Euler parameters: e moves by e o (0, turn) / 2, and the angular velocity is kept."""
    for k, body, axis, is_rate in by.turns:
        e = parameter_columns(model)[body]
        omega = angular_velocity(state.q[e], state.q_dot[e])
        if is_rate:
            dv[e, k] = parameter_rates(state.q[e], np.eye(3)[axis])
        else:
            dq[e, k] = parameter_rates(state.q[e], np.linalg.inv(chart_rates(_rotation(by, body, x)))[:, axis])
            dv[e, k] = parameter_rates(dq[e, k], omega)


def _require_kept(
    model: EmittedModel, given: Mapping[str, float], free: list[int], wanted: np.ndarray, found: np.ndarray, end: str
) -> None:
    """What the assembly was to keep, it kept. Raises InitialStateError."""
    for k, name in enumerate(model.coordinates):
        if k in free or name + end in given:
            continue
        if abs(found[k] - wanted[k]) > OPEN * max(1.0, abs(wanted[k])):
            raise InitialStateError(
                f"the start has no derivative: the assembly moves {name}{end} from {wanted[k]:.9g} to {found[k]:.9g}; "
                f"give it by initial = {{{name + end!r}: ...}}"
            )


def _assembled(
    model: EmittedModel,
    p: np.ndarray,
    t0: float,
    state: ConsistentState,
    dp: np.ndarray,
    dq: np.ndarray,
    dv: np.ndarray,
    free_q: list[int],
    free_v: list[int],
) -> None:
    """Fill the rows of dq and dv (n, k) that are left open."""
    C_q, C_p, rate_q, rate_p = model.derived("assembly_slopes", lambda: _slopes(model))(state.q, state.q_dot, t0, p)
    C_q, C_p, rate_q, rate_p = (np.asarray(value) for value in (C_q, C_p, rate_q, rate_p))
    dq[free_q] = _solved(model, C_q, free_q, -(C_p @ dp + C_q @ dq))
    dv[free_v] = _solved(model, C_q, free_v, -(rate_p @ dp + rate_q @ dq + C_q @ dv))


def _solved(model: EmittedModel, C_q: np.ndarray, free: list[int], side: np.ndarray) -> np.ndarray:
    matrix = C_q[:, free]
    values = np.linalg.svd(matrix, compute_uv=False) if free else np.ones(1)
    if len(values) < len(free) or values[-1] < RANK * values[0]:
        names = ", ".join(model.coordinates[k] for k in free)
        raise InitialStateError(
            f"the start has no derivative: the assembly leaves {names} open; give as many of them as it is free"
        )
    found = np.linalg.lstsq(matrix, side, rcond=None)[0]
    if np.abs(matrix @ found - side).max(initial=0.0) > OPEN * max(1.0, np.abs(side).max(initial=0.0)):
        raise InitialStateError("the start has no derivative: given values do not fit together when parameters change")
    return np.asarray(found)


def _slopes(model: EmittedModel) -> ca.Function:
    """(q, q_dot, t, p) -> C_q, C_p, and the slopes of C_q q_dot + C_t by q and p."""
    n = len(model.coordinates)
    q, v, t, p = ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("t"), ca.SX.sym("p", len(model.parameters))
    found = model.evaluate("constraints", q=q, q_dot=v, t=t, c=model.kernel("constants")(p))
    rate = ca.mtimes(found["C_q"], v) + found["C_t"]
    outputs = [found["C_q"], ca.jacobian(found["C"], p), ca.jacobian(rate, q), ca.jacobian(rate, p)]
    return ca.Function("assembly_slopes", [q, v, t, p], [ca.densify(value) for value in outputs])


# How a quasi-static start moves with parameters and rigid coordinates: the equilibrium of the elastic ones.
#
# R(t, q_i, q_i_dot, c) = 0 for the elastic coordinates, so  R_e dq_e = -(R_r dq_r + R_v dv + R_p dp);  their rates are
# differences of two such equilibria, as runtime.start.quasi_static takes them, and are differentiated as such.


def settled_slopes(
    model: EmittedModel,
    p: np.ndarray,
    c: np.ndarray,
    t: float,
    given: ConsistentState,
    slopes: np.ndarray,
    unstable: bool,
) -> np.ndarray:
    """d(p, q_i, q_i_dot, loop unknowns) (n_x, n) of the quasi-static start, from those of the state that was given."""
    elastic = [k for k, name in enumerate(model.q_i) if name in model.elastic]
    rigid = [k for k in range(len(model.q_i)) if k not in elastic]
    solver = ElasticEquilibrium(model, elastic, c, unstable)
    n_p, n = len(p), len(model.q_i)
    found = slopes.copy()
    dp, dq, dv = found[:n_p], found[n_p : n_p + n], found[n_p + n : n_p + 2 * n]
    (q, v), loop = independent(model, given.q, given.q_dot), loop_part(model, given.q)
    step, coordinate = small_motion(model, given.q_dot)
    rates = model.derived("rate_slopes", lambda: _rate_slopes(model))(t, q, v, loop, p)
    moving = np.asarray(rates)[coordinate] @ np.concatenate([dq, dv, dp])  # of the speed that sets the step
    dstep = -step * moving / given.q_dot[coordinate] if step else np.zeros(found.shape[1])
    function = model.derived("equilibrium_slopes", lambda: _equilibrium_slopes(model, elastic))

    def settled(at: float, place: np.ndarray, dplace: np.ndarray, dt: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(q_i, dq_i) with the elastic ones in equilibrium."""
        reached = solver.solve(at, place, v, loop)
        R_q, R_v, R_p, R_t = (np.asarray(value) for value in function(at, reached, v, loop, p))
        moved = dplace.copy()
        side = R_q[:, rigid] @ dplace[rigid] + R_v @ dv + R_p @ dp + np.outer(R_t, dt)
        moved[elastic] = -np.linalg.solve(R_q[:, elastic], side)
        return reached, moved

    still = np.zeros(found.shape[1])
    later, before = (float(side) for side in smooth_sides(model)(t, step, c))
    span = (later + before) * step
    for _ in range(SETTLING_PASSES):
        q, dq[:] = settled(t, q, dq, still)
        if not span:
            continue
        ends = []
        for sign in (later, -before):
            place, dplace = q.copy(), dq.copy()
            place[rigid] += sign * step * v[rigid]
            dplace[rigid] += sign * (step * dv[rigid] + np.outer(v[rigid], dstep))
            ends.append(settled(t + sign * step, place, dplace, sign * dstep))
        v[elastic] = (ends[0][0] - ends[1][0])[elastic] / span
        dv[elastic] = (ends[0][1] - ends[1][1])[elastic] / span - np.outer(v[elastic], dstep / step)
    return found


def _equilibrium_slopes(model: EmittedModel, elastic: list[int]) -> ca.Function:
    """(t, q_i, q_i_dot, loop unknowns, p) -> the slopes of R by q_i, q_i_dot, p and t."""
    n = len(model.q_i)
    t, q, v = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n)
    loop, p = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("p", len(model.parameters))
    R = elastic_residual(model)(t, q, v, loop, model.kernel("constants")(p))[0]
    outputs = [ca.densify(ca.jacobian(R, by)) for by in (q, v, p, t)]
    return ca.Function("equilibrium_slopes", [t, q, v, loop, p], outputs)


def _rate_slopes(model: EmittedModel) -> ca.Function:
    """(t, q_i, q_i_dot, loop unknowns, p) -> the slopes of all rates by (q_i, q_i_dot, p)."""
    n = len(model.q_i)
    t, q, v = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n)
    loop, p = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("p", len(model.parameters))
    equations = StageEquations(model, model.kernel("constants")(p))
    rates = equations.rates(equations.close(q, loop, t, STATIC_CLOSURE_ITERATIONS), v)
    slopes = ca.jacobian(joined(model, v, rates), ca.vertcat(q, v, p))
    return ca.Function("rate_slopes", [t, q, v, loop, p], [ca.densify(slopes)])


# A run that is differentiated must be one that a simulation would complete: the same checks, by name.

NO_LOWEST, NO_HIGHEST = 1e300, -1e300  # of no determinant at all


class RunChecks:
    """Checks of a run with constants c (c_size,) and parameters p (n_p,)."""

    def __init__(self, plan: Plan, c: np.ndarray, p: np.ndarray) -> None:
        self._scheme = plan.scheme
        self._monitor = Monitor(plan.scheme.model, plan.scheme, c, force=plan.force, p=p)

    def begin(self, z: np.ndarray) -> None:
        """Judge the start, and let the determinants of the loops begin. Raises NoResult."""
        layout = self._scheme.layout
        self._refuse(self._monitor.first(z[: layout.size].copy()))
        z[layout.slice("det_low")], z[layout.slice("det_high")] = NO_LOWEST, NO_HIGHEST

    def end(self, z: np.ndarray) -> None:
        """Judge the run by its last state. Raises NoResult."""
        layout = self._scheme.layout
        low, high = z[layout.slice("det_low")], z[layout.slice("det_high")]
        with np.errstate(all="ignore"):  # a run that has passed there may be lost
            passed = SingularityMonitor.of(len(low)).near_singular(low, high)
        if passed:
            raise NoResult(
                f"model {self._scheme.model.name}",
                "the run comes to where its loops are nearly singular, and a simulation would change coordinates there",
                "differentiate a shorter run, or choose other independent coordinates in the scene",
            )
        self._refuse(self._monitor.after(z[: layout.size].copy(), last=True))

    def _refuse(self, status: object) -> None:
        if status is not None:
            raise NoResult(f"model {self._scheme.model.name}", f"the run has no derivative, it ends: {status}")


# Where a run begins, with its derivatives: z and the prepared constants from parameters and initial values.
#
# x = (p, q_i, q_i_dot, loop unknowns) -> (z, constants): constants(p), the start of the scheme (68)-(71), and what is
# prepared for the run.


@dataclass(frozen=True)
class StartedRun:
    """A run at its start: z, the prepared constants, x (n_x,), slopes of x by the values (n_x, n), the values (n,).

    state: all coordinates and rates (n,).
    """

    z: np.ndarray
    ready: np.ndarray
    x: np.ndarray
    slopes: np.ndarray
    values: np.ndarray
    checks: RunChecks
    state: tuple[np.ndarray, np.ndarray]


class Beginning:
    """The derivative of the beginning of a run by x (n_x,), for what is active in the program.

    place: the time t0 and the steps of the groups, [t0, h_1, ...] [s].
    """

    def __init__(self, program: ObservedProgram) -> None:
        scheme, model, active = program.scheme, program.scheme.model, program.active
        n = len(model.q_i)
        sizes = (len(model.parameters), n, n, len(model.loop_unknowns))
        self.ends = np.cumsum(sizes)
        x = ca.SX.sym("x", sum(sizes))
        p, q_i, q_i_dot, loop = ca.vertsplit(x, [0, *map(int, self.ends)])
        place = ca.SX.sym("place", 1 + len(scheme.grid.h))
        constants = ca.vertcat(model.kernel("constants")(p), place[1:])
        z = scheme.starter(place[0], q_i, q_i_dot, loop, constants)
        rows = [k for k in active.z if k < scheme.layout.size]
        self._rows = [n for n, k in enumerate(active.z) if k < scheme.layout.size]
        self._rows += [len(active.z) + n for n in range(len(active.c))]
        self._size = active.size
        found = ca.densify(ca.vertcat(z[rows], program.prepared.constants(constants)[list(active.c)]))
        along, back = ca.SX.sym("along", x.numel()), ca.SX.sym("back", found.numel())
        pushed = ca.densify(ca.jtimes(found, x, along))
        pulled = ca.densify(ca.jtimes(found, x, back, True))
        self._tangent = ca.Function("beginning_tangent", [x, place, along], shared([pushed]))
        self._adjoint = ca.Function("beginning_adjoint", [x, place, back], shared([pulled]))

    def tangents(self, place: Sequence[float], x: np.ndarray, slopes: np.ndarray) -> np.ndarray:
        """(active entries of z and constants, k) along dx = slopes (n_x, k)."""
        found = np.zeros((self._size, slopes.shape[1]))
        for k in range(slopes.shape[1]):
            found[self._rows, k] = np.asarray(self._tangent(x, place, slopes[:, k])).ravel()
        return found

    def pulled_back(self, place: Sequence[float], x: np.ndarray, adjoint: np.ndarray) -> np.ndarray:
        """(n_x,) from the adjoint of the active entries of z and constants."""
        return np.asarray(self._adjoint(x, place, adjoint[self._rows])).ravel()
