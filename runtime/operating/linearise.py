"""The condensed equations to first order about a state, with inputs and outputs by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, NUMBER, Kind, arguments
from runtime.contract.coordinates import independent, independent_rates, loop_part
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.operating.balance import clamped_directions
from runtime.operating.equilibrium import (
    Equilibrium,
    equilibrium,
    force_unit,
    is_steady,
    named,
    names_rates,
    turning_name,
)
from runtime.operating.functions import (
    ALREADY_CLOSED,
    PointFunctions,
    all_coordinates,
    dependent_rates,
    independent_turns,
    row_names,
)
from runtime.operating.given_state import given_state
from runtime.operating.linearisation import Linearisation
from runtime.operating.mode_solver import State, parameters_at, state_at
from runtime.operating.trim import force_by_parameters
from runtime.results.samples import Samples
from runtime.schemes.stage_equations import StageEquations, along_rotations, turning

Place = Equilibrium | State | Mapping[str, float] | tuple[Samples, int] | None


def _is_place(value: Any) -> bool:
    if isinstance(value, tuple):
        count = len(value[0].t) if len(value) == 2 and isinstance(value[0], Samples) else 0
        return count > 0 and value[1] in range(-count, count)
    return isinstance(value, State | Mapping) or hasattr(value, "initial_values")


AT = Kind(_is_place, "give an equilibrium, coordinates by name, a solution, or (solution, number of a sample)")


@arguments(at=AT, inputs=NAMES, outputs=NAMES, parameters=BY_NAME, locked=NAMES, t=NUMBER)
def linearise(
    model: EmittedModel,
    at: Place = None,
    *,
    inputs: Sequence[str] | None = None,
    outputs: Sequence[str] | None = None,
    parameters: Mapping[str, float] | None = None,
    locked: Sequence[str] | None = None,
    t: float = 0.0,
) -> Linearisation:
    """Linearise about a state: M x'' + D x' + K x = B u, y = C (x, x') + D_state u.

    Parameters
    ----------
    model : Model
        The mechanism.
    at : Equilibrium, mapping of str to float or (Solution, int), optional
        An equilibrium; coordinates and rates (`_dot`) by name [m, rad, m/s, rad/s]; a sample of a solution; or None:
        the equilibrium reached from the initial state at the rigid rates that it has, prescribed motions moving.
    inputs : sequence of str, optional
        u (n_u,): coordinates (a generalised force [N, N m]), inputs or parameters of the scene; all independent
        coordinates by default.
    outputs : sequence of str, optional
        y (n_y,): measures, coordinates or rates (`_dot`); the scene's measures by default, else the independent
        coordinates.
    parameters : mapping of str to float, optional
        Changes by name; not with an equilibrium or a solution, which have their own.
    locked : sequence of str, optional
        Coordinates that stay as they are; by default those that the equilibrium holds, and in any case what friction or
        a stop holds there.
    t : float, optional
        The time, if `at` does not say it [s].

    Returns
    -------
    Linearisation
        M, D, K (n, n), B (n, n_u), C (n_y, 2 n), eigenvalues and shapes.

    Raises
    ------
    ModelError, InitialStateError, NoEquilibrium
        For what cannot be used, and where no equilibrium is reached.

    Notes
    -----
    Exact derivatives of M_hat q_i'' = Q_hat (Eq. 38), gyroscopic and geometric terms included.
    """
    point = _point(model, at, parameters, t)
    locked = tuple(turning_name(model, name) for name in (point.held if locked is None else locked))
    input_names = [_input(model, name) for name in inputs] if inputs is not None else list(model.q_i)
    output_names = list(outputs if outputs is not None else model.state_measures or model.q_i)
    functions = PointFunctions(model, model.constants(point.p), point.drives_move)
    here = functions(point.state)
    resting = point.at_rest
    a = np.zeros(len(model.q_i)) if resting else np.linalg.solve(here.M, here.Q)
    values = here if resting else functions(point.state, a)
    values = functions.in_moving_axes(values, point.state, a)
    rows = [row_names(model).index(name) for name in locked]
    Z = clamped_directions(np.vstack([values.directions[rows], *point.locked]), model.states)
    K = -(values.J_q + _held_slope(model, functions, point, values.S, here.Q) if resting else values.J_q)
    B = _inputs(model, point, a, input_names, values.S)
    C, through = _outputs(model, point, input_names, output_names)
    _require_slopes(model, output_names, np.hstack([C, through]))
    n = len(model.q_i)
    return Linearisation(
        model=model,
        parameters=point.p,
        state=point.state,
        M=Z.T @ values.M @ Z,
        D=-Z.T @ values.J_v @ Z,
        K=Z.T @ K @ Z,
        B=Z.T @ B,
        C=np.hstack([C[:, :n] @ Z, C[:, n:] @ Z]),
        D_state=through,
        names=_names(model, Z),
        input_names=input_names,
        output_names=output_names,
        units=_units(model, [*model.q_i, *input_names, *output_names], input_names),
        S=values.S @ Z,
        q=values.q,
        q_dot=values.q_dot,
        residual=np.zeros(Z.shape[1]) if resting else Z.T @ here.Q,
        steady=is_steady(here, point.state.q_i_dot),
        locked=locked,
        controllers=len(model.states),
    )


def _require_slopes(model: EmittedModel, outputs: Sequence[str], slopes: np.ndarray) -> None:
    """Raises ModelError for an output that has no derivative here, such as a distance of zero; slopes (n_y, n)."""
    bad = [name for name, row in zip(outputs, slopes, strict=True) if not np.isfinite(row).all()]
    if bad:
        raise ModelError(
            f"output {', '.join(bad)} of model {model.name}",
            "has no derivative at this state (the distance of points that meet, a root at zero)",
            "give outputs without it, or a state beside",
        )


@dataclass(frozen=True)
class _Point:
    """State and parameters; held coordinates; holding forces on all coordinates; is it an equilibrium?

    locked (n_i,) each: directions in which friction or a stop holds.
    """

    state: State
    p: np.ndarray
    held: tuple[str, ...] = ()
    holding: np.ndarray | None = None
    at_rest: bool = False
    drives_move: bool = True
    locked: tuple[np.ndarray, ...] = ()


def _point(model: EmittedModel, at: Place, parameters: Mapping[str, float] | None, t: float) -> _Point:
    if at is None:
        at = equilibrium(model, rates=starting_rates(model), parameters=parameters, at_time=t)
    elif parameters and not isinstance(at, Mapping | State):
        raise ModelError("parameters belong to the equilibrium or solution that is linearised about: give them there")
    if isinstance(at, Equilibrium):
        force = np.zeros(len(model.coordinates))
        for name, value in at.holding.items():
            if name in model.coordinates:  # what holds an independent turn adds no stiffness
                force[model.coordinates.index(name)] = value
        return _Point(at.state, at.parameters, at.held, force, True, at.drives != "held", tuple(at.locked))
    p = model.parameter_vector(parameters)
    if isinstance(at, State):
        return _Point(at, p)
    if isinstance(at, tuple):
        return _Point(state_at(*at), parameters_at(*at))
    found = given_state(model, p, model.constants(p), t, at)
    return _Point(State(t, *independent(model, found.q, found.q_dot), loop_part(model, found.q)), p)


def starting_rates(model: EmittedModel) -> dict[str, float]:
    """The rates of rigid independent coordinates at the scene's start that are not zero, `body.omega_x` of turns."""
    return rigid_rates(model, model.initial_q, model.initial_q_dot)


def rigid_rates(model: EmittedModel, q: np.ndarray, q_dot: np.ndarray) -> dict[str, float]:
    """Those of a state (n,) and (n,)."""
    left_out = {*model.elastic, *(model.q_i[k] for k in model.states)}
    turns = set(independent_turns(model).tolist())
    rates = independent_rates(model, q, q_dot).tolist()
    moving = [(k, name, rate) for k, (name, rate) in enumerate(zip(model.q_i, rates, strict=True)) if rate != 0]
    return {
        name.replace(".turn_", ".omega_") if k in turns else name: rate
        for k, name, rate in moving
        if name not in left_out
    }


def _held_slope(
    model: EmittedModel, functions: PointFunctions, point: _Point, S: np.ndarray, Q: np.ndarray
) -> np.ndarray:
    """What constant holding forces on dependent coordinates add to dQ_hat/dq_i."""
    force = point.holding
    dependent = [] if force is None else [k for k in np.flatnonzero(force) if model.coordinates[k] in model.q_d]
    if force is None or not dependent:
        return np.zeros((len(model.q_i),) * 2)
    return functions.pull_slope(point.state, force)


def _names(model: EmittedModel, Z: np.ndarray) -> list[str]:
    """Names of x: coordinates where each direction is one of them."""
    single = all(np.count_nonzero(column) == 1 for column in Z.T)
    return [model.q_i[int(np.abs(column).argmax())] if single else f"free{k + 1}" for k, column in enumerate(Z.T)]


def _input(model: EmittedModel, name: str) -> str:
    if name in [parameter.name for parameter in model.parameters]:
        return name
    try:
        return named(model, name)
    except ModelError:
        known = [*model.q_i, *(parameter.name for parameter in model.parameters if parameter.kind != "data")]
        listed = ", ".join(known[:30])
        raise ModelError(
            f"model {model.name} has no input {name!r}: an input is a coordinate or a parameter, of {listed}"
        ) from None


def _inputs(model: EmittedModel, point: _Point, a: np.ndarray, names: Sequence[str], S: np.ndarray) -> np.ndarray:
    """(n_i, n_u) generalised forces on q_i of unit inputs."""
    B = np.zeros((len(model.q_i), len(names)))
    of_loads = [name for name in names if name not in model.coordinates and name not in model.q_i]
    if of_loads:
        state = point.state
        move = point.drives_move or names_rates(model, of_loads)
        key = f"forces by {', '.join(of_loads)}{'' if move else ', drives held'}"
        slope = model.derived(key, lambda: force_by_parameters(model, of_loads, move))
        found = slope(state.t, state.q_i, state.q_i_dot, a, state.loop, point.p)
        B[:, [names.index(name) for name in of_loads]] = np.asarray(found)
    for k, name in enumerate(names):
        if name in model.coordinates:
            B[:, k] = S[model.coordinates.index(name)]
        elif name in model.q_i:  # a moment in the axes of the body
            B[model.q_i.index(name), k] = 1.0
    return B


def _outputs(
    model: EmittedModel, point: _Point, inputs: Sequence[str], names: Sequence[str]
) -> tuple[np.ndarray, np.ndarray]:
    """(n_y, 2 n_i) and (n_y, n_u): derivatives of the outputs by (q_i, q_i_dot) and by the inputs."""
    n, state = len(model.q_i), point.state
    through = np.zeros((len(names), len(inputs)))
    if not names:
        return np.zeros((0, 2 * n)), through
    loads = [k for k, name in enumerate(inputs) if name not in model.coordinates and name not in model.q_i]
    move = point.drives_move
    key = f"outputs {', '.join(names)} by {', '.join(inputs[k] for k in loads)}{'' if move else ', drives held'}"
    function = model.derived(key, lambda: output_slopes(model, names, [inputs[k] for k in loads], move))
    by_state, by_parameters = function(state.t, state.q_i, state.q_i_dot, state.loop, point.p)
    through[:, loads] = np.asarray(by_parameters).reshape(len(names), len(loads))
    return np.asarray(by_state).reshape(len(names), 2 * n), through


def _units(model: EmittedModel, names: Sequence[str], inputs: Sequence[str]) -> dict[str, str]:
    """SI units of coordinates, rates, measures and parameters; of an input coordinate that of its force."""
    known = {measure.name: measure.unit for measure in model.description.measures}
    known |= {parameter.name: parameter.unit for parameter in model.parameters}
    for entry in model.description.coordinates:
        known |= {entry.name: entry.unit, f"{entry.name}_dot": entry.unit_of(1)}
    turns = {name for record in model.description.orientations for name in record.turns}
    known |= {name: "rad" for name in turns} | {f"{name}_dot": "rad/s" for name in turns}
    found = {name: known[name] for name in names if name in known}
    forces = {f"force on {name}": force_unit(model, name) for name in inputs if name in model.coordinates}
    return found | forces | {f"force on {name}": "N m" for name in inputs if name in turns}


# ---- Measures, coordinates and rates as outputs of a linear system: their derivatives along the constraints.

SHOWN_NAMES = 30  # names that an error lists


def output_slopes(
    model: EmittedModel, names: Sequence[str], inputs: Sequence[str], drives_move: bool = True
) -> ca.Function:
    """(t, q_i, q_i_dot, loop unknowns, p) -> dy/d(q_i, q_i_dot) (n_y x 2 n_i), dy/d(p of these inputs) (n_y x k).

    q_d = f(q_i, t, p) is differentiated through. Raises ModelError for a name that is neither a measure, nor a
    coordinate, nor its rate.
    """
    n = len(model.q_i)
    t, q, v = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n)
    loop, p = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("p", len(model.parameters))
    equations = StageEquations(model, model.kernel("constants")(p))
    motion = equations.close(q, loop, t, ALREADY_CLOSED)
    places = all_coordinates(model, q, motion.q_d)
    rates = all_coordinates(model, v, dependent_rates(equations, motion, v, drives_move))
    known = {name: places[k] for k, name in enumerate(model.coordinates)}
    known |= {f"{name}_dot": rates[k] for k, name in enumerate(model.coordinates)}
    known |= {name: q[k] for k, name in enumerate(model.q_i) if name not in known}
    if model.state_measures:
        found = equations.call("measures", q=places, q_dot=rates, t=t)["measures"]
        known |= {name: found[k] for k, name in enumerate(model.state_measures)}
    for name in names:
        if name in model.acceleration_measures:
            raise ModelError(
                f"output {name!r}",
                "follows from accelerations, on which forces act at once, and a linear system has outputs of states",
                f"give the beam axial modes, take its bending_moment, or read {name} of a run",
            )
        if name not in known:
            listed = ", ".join([*model.state_measures, *model.coordinates][:SHOWN_NAMES])
            raise ModelError(f"model {model.name} has no output {name!r}; it has {listed} (rates end in _dot)")
    y = ca.vertcat(*(known[name] for name in names))
    index = [parameter.name for parameter in model.parameters]
    by_q, by_v = along_rotations(equations, motion, ca.jacobian(y, q)), ca.jacobian(y, v)
    by_q = ca.densify(by_q + ca.mtimes(by_v, turning(equations, motion, v)))  # in axes that move with the state
    turns = {model.q_i[int(k)]: int(k) for k in model.places.turns.ravel() if k < n}
    for row, name in enumerate(names):
        if name in turns:  # the turn itself
            by_q[row, :] = ca.SX.eye(n)[turns[name], :]
    slopes = [ca.horzcat(by_q, by_v), ca.jacobian(y, p)[:, [index.index(name) for name in inputs]]]
    return ca.Function("outputs", [t, q, v, loop, p], [ca.densify(slope) for slope in slopes])
