"""Where a model rests or turns steadily: Q_hat(q_i, q_i_dot) = 0 with constant rates (Eq. 38 with q_i_ddot = 0)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import casadi as ca
import numpy as np

from runtime.contract.arguments import BY_NAME, NUMBER, START, arguments
from runtime.contract.consistent_state import InitialStateError
from runtime.contract.coordinates import (
    Initial,
    euler_angles,
    followed,
    independent_part,
    independent_rates,
    loop_part,
    named_values,
    parameter_columns,
)
from runtime.contract.errors import ModelError, NoResult
from runtime.contract.model import EmittedModel, refuse_reactions
from runtime.contract.orientations import angle_names, angles
from runtime.contract.signals import SUFFIXES
from runtime.operating.balance import Clamped, clamped_directions, steady_rates
from runtime.operating.functions import PointFunctions, PointValues, has_drives, independent_turns, row_names
from runtime.operating.given_state import given_position, given_state
from runtime.operating.linearisation import modal_analysis
from runtime.operating.mode_solver import State
from runtime.operating.newton import Balance, Found, balanced
from runtime.operating.trim import trimmed

STIFFNESS_ROUNDING = 1e-13  # of the largest stiffness
UNSTEADY = 1e-9  # change of the forces along the motion, relative to what the stiffness makes of it


class NoEquilibrium(NoResult):
    """No equilibrium in reach: the message tells the largest force that is left, and where; residual: all of them."""

    def __init__(self, message: str, residual: Mapping[str, float]) -> None:
        super().__init__(message)
        self.residual = dict(residual)


@dataclass(frozen=True, repr=False)
class Equilibrium:
    """A state at which nothing but the coordinates with given rates moves.

    Attributes
    ----------
    model : Model
        The mechanism.
    q, q_dot : (n,) array
        All coordinates [m, rad] and rates, in the order of `model.coordinates`.
    parameters : (n_p,) array
        The vector p.
    state : State
        t [s], q_i, q_i_dot and loop unknowns.
    held, turning : tuple of str
        Coordinates that are clamped; those with a given rate.
    holding : dict of str to float
        The generalised force [N, N m] that each of them needs to stay so.
    trimmed : dict of str to float
        Inputs that were solved for.
    eigenvalues : array
        Of small motions with the held coordinates clamped [1/s]; `stable` tells by them.
    steady : bool
        Whether the forces stay the same as the motion goes on; if not, this is an instant of a motion that is not
        steady.
    drives : str
        Whether prescribed motions are `held` where they are at t, or `moving` with the rates and accelerations that
        they have then; "" without any.
    friction : dict of str to float
        Force [N, N m] of each joint that friction or a rigid stop holds at rest, by `joint.friction`,
        `joint.limits.lower`, ...; they stay locked in `eigenvalues`.
    locked : (k, n_i) array
        The directions of q_i in which they do.
    """

    model: EmittedModel
    q: np.ndarray
    q_dot: np.ndarray
    parameters: np.ndarray
    state: State
    held: tuple[str, ...]
    turning: tuple[str, ...]
    holding: dict[str, float]
    trimmed: dict[str, float]
    eigenvalues: np.ndarray
    stable: bool
    steady: bool
    iterations: int
    drives: str = ""
    friction: dict[str, float] = field(default_factory=dict)
    locked: np.ndarray = field(default_factory=lambda: np.zeros((0, 0)))

    def __getitem__(self, name: str) -> float:
        """A coordinate, rate (`_dot`) or state by name. Raises ModelError for an unknown name."""
        for entry in self.model.description.coordinates:
            if entry.kind == "state" and entry.owner == name:
                name = f"{entry.name}_dot"
        for k, known in enumerate(self.model.coordinates):
            if name in (known, f"{known}_dot"):
                return float((self.q if name == known else self.q_dot)[k])
        for body, kind in euler_angles(self.model).items():
            theta = angles(kind, self.q[parameter_columns(self.model)[body]])
            if name in angle_names(body):
                return float(theta[angle_names(body).index(name)])
        raise ModelError(f"model {self.model.name} has no coordinate {name!r}; it has {_listed(self.model)}")

    def initial_values(self) -> dict[str, float]:
        """All coordinates and rates by name: what a run that begins here has as `initial`."""
        return named_values(self.model, self.q, self.q_dot)

    @property
    def kind(self) -> str:
        """`equilibrium`, or `steady motion` if something has a rate."""
        return "steady motion" if self.turning else "equilibrium"

    def __repr__(self) -> str:
        words = [self.kind, "stable" if self.stable else "unstable"] + ([] if self.steady else ["not steady"])
        words += [f"drives {self.drives} as at t = {self.state.t:g} s"] if self.drives else []
        words += [f"held by {', '.join(self.friction)}"] if self.friction else []
        values = ", ".join(f"{name} = {self[name]:.6g}" for name in followed(self.model)[0][:6])
        return f"<{', '.join(words)} of {self.model.name}: {values}{', ...' if len(self.model.q_i) > 6 else ''}>"


@arguments(held=BY_NAME, rates=BY_NAME, inputs=BY_NAME, parameters=BY_NAME, initial=START, t=NUMBER, at_time=NUMBER)
def equilibrium(
    model: EmittedModel,
    held: Mapping[str, float] | None = None,
    rates: Mapping[str, float] | None = None,
    inputs: Mapping[str, float | None] | None = None,
    *,
    parameters: Mapping[str, float] | None = None,
    initial: Initial = None,
    t: float = 0.0,
    at_time: float | None = None,
) -> Equilibrium:
    """Find the equilibrium, Q_hat = 0 at constant rates, that is reached from the model's initial state.

    Parameters
    ----------
    model : Model
        The mechanism.
    held : mapping of str to float, optional
        Coordinates that are clamped at a value [m, rad].
    rates : mapping of str to float, optional
        Coordinates that go on at a constant rate [m/s, rad/s].
    inputs : mapping of str to float or None, optional
        Inputs or parameters set to a value; None: solved for, as many as are held or turning, so that these need no
        force.
    parameters, initial : mapping of str to float, optional
        Changes by name, as of `simulate`.
    t : float, optional
        Time of loads and prescribed motions, which stand still there [s].
    at_time : float, optional
        Time [s] in place of t, at which prescribed motions have their rates and accelerations (also where `inputs` or
        `parameters` name a rate of an input).

    Returns
    -------
    Equilibrium
        Coordinates, forces that hold it, its stability.

    Raises
    ------
    NoEquilibrium, InitialStateError, ModelError
        Where none is reached, and for what cannot be used.

    Notes
    -----
    Newton's method on Q_hat of Eq. (38) with exact derivatives, led away from unstable equilibria unless it starts in
    one. Joints with friction hold where they start, and slide where they turn. What leans on a rigid stop rests on it.
    """
    inputs, initial = inputs or {}, _places(model, initial)
    held = {named(model, name): float(value) for name, value in (held or {}).items()}
    rates = {turning_name(model, name): float(value) for name, value in (rates or {}).items()}
    trim = [name for name, value in inputs.items() if value is None]
    given = {name: value for name, value in inputs.items() if value is not None}
    p = model.parameter_vector({**(parameters or {}), **given})
    fixed = [*held, *(name for name in rates if name not in held)]
    _check_trim(model, trim, fixed)
    moving = at_time is not None or names_rates(model, {**(parameters or {}), **inputs})
    functions = PointFunctions(model, model.constants(p), moving)
    clamped, q_i = _clamped(functions, p, t if at_time is None else at_time, held, rates, fixed, initial)
    if model.element_modes.size:
        p, clamped = _sliding(clamped, q_i, p)
    # a controller that wants something else than what is held has no balance before its inputs are solved for
    found = Found(q_i, True, np.zeros(0), 0) if trim and model.states else clamped.solve(q_i)
    if not found.converged:
        around = _led_around(clamped, p, initial, held)
        found, clamped = (found, clamped) if around is None else around
    if not found.converged:
        raise _failure(model, clamped, found)
    stops = any(event.side for event in model.mode_events)
    if stops:
        from runtime.operating.resting import on_stops

        found, p, clamped = on_stops(clamped, found, p)
        if not found.converged:
            raise _failure(model, clamped, found)
    q_i, iterations = found.x, found.iterations
    if trim:
        trim_found = trimmed(model, clamped, q_i, p, trim)
        if not trim_found.converged:
            raise _no_trim(trim_found.clamped, trim, fixed)
        q_i, p, iterations = trim_found.q_i, trim_found.p, iterations + trim_found.iterations
        clamped = trim_found.clamped
    values = dict(zip([parameter.name for parameter in model.parameters], p, strict=True))
    balanced = _equilibrium(
        clamped, q_i, p, tuple(held), tuple(rates), {name: float(values[name]) for name in trim}, iterations
    )
    if stops:
        from runtime.operating.resting import refuse_beyond

        refuse_beyond(model, model.constants(p), clamped.t, balanced.q, balanced.q_dot)
    return balanced


def _places(model: EmittedModel, initial: Initial) -> Mapping[str, float]:
    """Changes by name; of what has a state its coordinates, since `rates` says what moves."""
    if initial is None or isinstance(initial, Mapping):
        return initial or {}
    return {name: value for name, value in initial.initial_values().items() if name in model.coordinates}


def named(model: EmittedModel, name: str) -> str:
    """The coordinate that a name means: itself, or `hub.omega` for the one angle that hub has. Raises ModelError."""
    if name in model.coordinates:
        return name
    angles = [entry for entry in model.description.coordinates if entry.kind == "angle"]
    found = [entry.name for entry in angles if name == f"{entry.owner}.omega"]
    if len(found) == 1:
        return found[0]
    if any(name in body.angles for body in model.description.bodies):
        raise ModelError(
            f"{name} is an Euler angle, which is input and output only: it can be `initial` and be read, and what is "
            "held or turns by it needs hinges, a universal and a revolute joint with a light body between them"
        )
    raise ModelError(f"model {model.name} has no coordinate {name!r}; it has {_listed(model)}")


def turning_name(model: EmittedModel, name: str) -> str:
    """The coordinate or turn whose rate is given: `body.turn_x` for `body.omega_x`. Raises ModelError."""
    turns = {model.q_i[k] for k in independent_turns(model)}
    turn = name.replace(".omega_", ".turn_")
    return turn if turn in turns else named(model, name)


def force_unit(model: EmittedModel, name: str) -> str:
    """SI unit of the generalised force on a coordinate."""
    return "N m" if name not in model.coordinates or model.coordinate(name).turns else "N"


def _listed(model: EmittedModel) -> str:
    return ", ".join(model.coordinates[:20]) + (", ..." if len(model.coordinates) > 20 else "")


def _check_trim(model: EmittedModel, trim: list[str], fixed: list[str]) -> None:
    model.parameter_vector({name: 1.0 for name in trim})
    if trim and len(trim) != len(fixed):
        raise ModelError(
            f"inputs to be solved for: {', '.join(trim)}; coordinates held or turning: {', '.join(fixed) or 'none'}. "
            "There must be as many of both"
        )


def names_rates(model: EmittedModel, names: Iterable[str]) -> bool:
    """Does a name stand for a rate or acceleration of an input?"""
    rates = {f"{entry.name}{suffix}" for entry in model.description.inputs for suffix in SUFFIXES[1:]}
    return not rates.isdisjoint(names)


def _clamped(
    functions: PointFunctions,
    p: np.ndarray,
    t: float,
    held: Mapping[str, float],
    rates: dict[str, float],
    fixed: list[str],
    initial: Mapping[str, float],
) -> tuple[Clamped, np.ndarray]:
    """The task with its clamped coordinates, and q_i where it starts."""
    model = functions.model
    own = {name: value for name, value in held.items() if name in model.q_i}
    rows = [row_names(model).index(name) for name in fixed]
    q_i, loop = given_position(model, p, functions.c, t, {**initial, **own})
    q_i[model.states] = independent_rates(model, model.initial_q, model.initial_q_dot)[model.states]
    task = Clamped(model, functions, t, np.zeros(len(q_i)), rows, np.zeros(0), loop)
    at = task.values(q_i)
    if at is not None:
        goal = [held.get(name, float(at.places[row])) for name, row in zip(fixed, rows, strict=True)]
        task = replace(task, goal=np.array(goal))
    placed = task.placed(q_i) if at is not None else None
    if placed is None:
        wanted = ", ".join(f"{name} = {held[name]:g}" for name in held) or "closed loops"
        raise InitialStateError(
            f"model {model.name} has no state with {wanted} near its initial one: start closer with "
            "`initial`, or hold other coordinates"
        )
    return replace(task, v=steady_rates(functions, t, placed, task.loop, rates)), placed


def _led_around(
    clamped: Clamped, p: np.ndarray, initial: Mapping[str, float], held: Mapping[str, float]
) -> tuple[Found, Clamped] | None:
    """The equilibrium at rest found on all coordinates, where the way in the independent ones was barred.

    With the task whose loops are closed there.
    """
    model = clamped.model
    if not model.loop_unknowns or model.states or clamped.v.any() or not model.has("augmented"):
        return None
    start = given_state(model, p, clamped.functions.c, clamped.t, {**initial, **held})
    q = AllCoordinates(model, clamped.functions.c, clamped.t, clamped.rows, clamped.goal).solve(start.q)
    if q is None:
        return None
    there = replace(clamped, loop=loop_part(model, q))
    return there.solve(independent_part(model, q)), there


def _equilibrium(
    clamped: Clamped,
    q_i: np.ndarray,
    p: np.ndarray,
    held: tuple[str, ...],
    turning: tuple[str, ...],
    trim: dict[str, float],
    iterations: int,
) -> Equilibrium:
    model, at = clamped.model, clamped.values(q_i)
    assert at is not None
    states, v = model.states, clamped.rates(q_i)
    friction, locked = _held_by(clamped, at, q_i) if model.element_modes.size else ({}, np.zeros((0, len(v))))
    fixed = [model.coordinates.index(name) for name in held]
    Z = clamped_directions(np.vstack([at.S[fixed], locked]), states)
    K = -clamped.slope(q_i, at)
    K[:, states] = 0.0
    moving = clamped.functions.in_moving_axes(at, clamped.state(q_i), np.zeros(len(v)))
    K -= moving.J_q - at.J_q
    modal = modal_analysis(Z.T @ at.M @ Z, -Z.T @ moving.J_v @ Z, Z.T @ K @ Z, len(states))
    forces = clamped.holding(at)
    names = [row_names(model)[row] for row in clamped.rows]
    return Equilibrium(
        model=model,
        q=at.q,
        q_dot=at.q_dot,
        parameters=p,
        state=clamped.state(q_i),
        held=held,
        turning=turning,
        holding={name: float(force) for name, force in zip(names, forces, strict=True)},
        trimmed=trim,
        eigenvalues=modal.every_eigenvalue,
        stable=modal.stable,
        steady=is_steady(at, v),
        iterations=iterations,
        drives="" if not has_drives(model) else "moving" if clamped.functions.drives_move else "held",
        friction=friction,
        locked=locked,
    )


def _sliding(clamped: Clamped, q_i: np.ndarray, p: np.ndarray) -> tuple[np.ndarray, Clamped]:
    """p with the modes of friction by the rates where the search starts, and `clamped` with its constants."""
    model, at = clamped.model, clamped.values(q_i)
    if at is None:
        return p, clamped
    from runtime.operating.resting import signs, state_of, with_modes

    refuse_reactions(model, "is not determined in an equilibrium", "give coulomb, or step it")
    state, c = state_of(clamped, at, q_i)
    found = with_modes(model, p, signs(model, state, c))
    return found, clamped.with_constants(model.constants(found))


def _held_by(clamped: Clamped, at: PointValues, q_i: np.ndarray) -> tuple[dict[str, float], np.ndarray]:
    """Forces of friction and stops that hold, and their rows G (k, n_i). Raises NoEquilibrium."""
    from runtime.operating.resting import held, signs, state_of

    model, (state, c) = clamped.model, state_of(clamped, at, q_i)
    modes = c[len(c) - model.signals.size + model.element_modes]
    forces, beyond = held(model, state, c)
    rubs = np.array([not event.side for event in model.mode_events])
    if beyond or (signs(model, state, c) != modes)[rubs].any():
        name, force = next(iter(beyond.items()), ("", 0.0))
        text = f"{name} would have to hold {force:.6g}, more than it can" if beyond else "one turns back on the way"
        raise NoEquilibrium(
            f"model {model.name} has no equilibrium where its joints with friction start: {text}. Begin elsewhere with "
            f"`initial`, or take a scene with more or without friction{_of_when(clamped)}",
            beyond,
        )
    rows = [event.row for event, mode in zip(model.mode_events, modes, strict=True) if mode == 0]
    return forces, np.asarray(model.evaluate("elements", **state, c=c)["G"])[rows]


def is_steady(at: PointValues, v: np.ndarray) -> bool:
    """Does d(Q_hat)/dt along the motion with rates v (n_i) vanish against what the stiffness makes of it?"""
    change = np.abs(at.J_q @ v + at.Q_t)
    rows = np.abs(at.J_q).max(axis=1, initial=0.0)
    allowed = (UNSTEADY * rows + STIFFNESS_ROUNDING * rows.max(initial=0.0)) * float(np.abs(v).max(initial=0.0))
    return bool(np.all(change <= allowed))


def _of_when(clamped: Clamped) -> str:
    """Where forces depend on time, also by a condition whose derivative is zero: of which time they are."""
    if not clamped.functions.depend_on_time:
        return ""
    return (
        f". Loads and prescribed motions are those of t = {clamped.t:g} s: give `t`, or `at_time` with what is "
        "prescribed in motion, for another time"
    )


def _failure(model: EmittedModel, clamped: Clamped, found: Found) -> NoEquilibrium:
    at = clamped.values(found.x)
    if at is None:
        return NoEquilibrium(
            f"model {model.name}: the loops do not close, or a force is not finite, where it starts", {}
        )
    left = at.Q + at.directions[clamped.rows].T @ clamped.holding(at)
    residual = {name: float(value) for name, value in zip(model.q_i, left, strict=True)}
    worst = max(residual, key=lambda name: abs(residual[name]))
    remedy = "Hold that coordinate, give it a rate, or begin elsewhere with `initial`"
    if worst not in model.coordinates:
        remedy = (
            f"That is a turn of a body: give the spin as rates ({worst.replace('.turn_', '.omega_')}); what spins and "
            "precesses is steady in hinge angles: take a universal and a revolute joint with a light body between them"
        )
    return NoEquilibrium(
        f"model {model.name} has no equilibrium near its initial state: a force of {residual[worst]:.6g} "
        f"{force_unit(model, worst)} is left at {worst} after {found.iterations} iterations. {remedy}"
        f"{_of_when(clamped)}",
        residual,
    )


def _no_trim(clamped: Clamped, trim: list[str], fixed: list[str]) -> NoEquilibrium:
    return NoEquilibrium(
        f"model {clamped.model.name}: no value of {', '.join(trim)} near the default keeps {', '.join(fixed)} "
        f"without a holding force. Do these inputs act on them?{_of_when(clamped)}",
        {},
    )


# ---- Equilibria on all coordinates, for where the independent ones lead nowhere.
#
# Near a position at which two links are in line the q_d are no function of the q_i, and the condensed equations end
# there. The equilibrium itself need not: with Z an orthonormal basis of the motions that C_q lets (C_q Z = 0),
#
#     Z^T Q* = 0,  slope Z^T d(Q* - C_q^T lambda)/dq Z,  C_q^T lambda = Q* in the least-squares sense,
#
# has no such places. Steps are made along Z and put back on C(q, t) = 0. What is found is a start for the condensed
# equations, which have the last word.

DEPENDENT = 1e-10  # singular value of C_q, relative to the largest, of rows that others imply
ON_THE_ROWS = 1e-12  # m or rad
MOST_RETURNS = 30


class AllCoordinates:
    """A model at rest at time t [s] with constants c (c_size,), coordinates `rows` of q clamped at `goal`."""

    def __init__(self, model: EmittedModel, c: np.ndarray, t: float, rows: Sequence[int], goal: np.ndarray) -> None:
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


def _built(model: EmittedModel) -> ca.Function:
    """(t, q, lam, c) -> M, Q*, C, C_q, d(Q* - C_q^T lam)/dq, all at rest."""
    n, n_c = len(model.coordinates), len(model.constraints)
    t, q, lam, c = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("lam", n_c), ca.SX.sym("c", model.c_size)
    rest = ca.SX.zeros(n)
    found = model.evaluate("augmented", q=q, q_dot=rest, t=t, c=c)
    rows = model.evaluate("constraints", q=q, q_dot=rest, t=t, c=c)
    left = found["Q_star"] - ca.mtimes(rows["C_q"].T, lam)
    outputs = [found["M"], found["Q_star"], rows["C"], rows["C_q"], ca.jacobian(left, q)]
    return ca.Function("all_coordinates", [t, q, lam, c], [ca.densify(part) for part in outputs])
