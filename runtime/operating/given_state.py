"""A consistent state with values changed by name: the model's own, or assembled anew."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import (
    ASSEMBLED,
    LARGEST_STEP,
    MAX_ASSEMBLY_ITERATIONS,
    POSITION_TOLERANCE,
    VELOCITY_TOLERANCE,
    AngleForm,
    Assembly,
    ConsistentState,
    GivenValues,
    InitialStateError,
    angle_bodies,
    consistent_state,
    with_words,
)
from runtime.contract.coordinates import (
    OMEGA,
    Initial,
    angular_velocities,
    dependent_part,
    euler_angles,
    followed,
    independent,
    independent_part,
    joined,
    loop_part,
    parameter_columns,
    values_by_name,
)
from runtime.contract.errors import is_finite_number, shown_value
from runtime.contract.model import EmittedModel
from runtime.contract.orientations import angle_names, parameter_rates

# ---- Dependent coordinates from independent ones by the closure alone: a pure function, so runs in lanes share
# its bits.
#
#     q_d <- closure(q_i, q_d, t)      Newton on the loop unknowns (32), at most LARGEST_STEP a time, to rounding
#     fits: |C(q, t)| and |C_q q_dot + C_t| of all rows are rounding, with q_d_dot of (36)
#
# Where it does not fit (redundant rows that disagree, no branch in reach), runtime/contract/consistent_state.py
# decides.

FINITE = 1e300  # less than this are all numbers that are no NaN


def closing(model: EmittedModel) -> ca.Function:
    """(q_i, q_d, t, c) -> (q_d after one more Newton step, was it open before?), built once for a model."""

    def build() -> ca.Function:
        q_i, q_d, t, c = _symbols(model, "q_i", "q_d", "t", "c")
        found = model.evaluate("closure", q_i=q_i, q_d=q_d, t=t, c=c)
        closed, open_ = ca.SX(found["q_d_next"]), ca.SX(0)
        loops = [model.q_d.index(name) for name in model.loop_unknowns]
        if loops:
            step = closed[loops] - q_d[loops]
            share = ca.fmin(1, LARGEST_STEP / ca.fmax(ca.norm_inf(step), LARGEST_STEP))
            closed[loops] = q_d[loops] + share * step
            open_ = ca.norm_inf(found["C_loop"]) > POSITION_TOLERANCE * _scale(q_d)
        names = ["q_i", "q_d", "t", "c"]
        return ca.Function("closing", [q_i, q_d, t, c], [closed, open_], names, ["q_d_next", "open"])

    return model.derived("closing", build)


def fitting(model: EmittedModel) -> ca.Function:
    """(q_i, q_i_dot, q_d, t, c) -> (q, q_dot, does it fit?), built once for a model."""

    def build() -> ca.Function:
        q_i, q_i_dot, q_d, t, c = _symbols(model, "q_i", "q_i_dot", "q_d", "t", "c")
        q_d_dot = model.evaluate("velocities", q_i=q_i, q_d=q_d, q_i_dot=q_i_dot, t=t, c=c)["q_d_dot"]
        q, q_dot = joined(model, q_i, q_d), joined(model, q_i_dot, q_d_dot)
        found = model.evaluate("constraints", q=q, q_dot=q_dot, t=t, c=c)
        C, C_dot = found["C"], ca.mtimes(found["C_q"], q_dot) + found["C_t"]
        fits = ca.logic_and(
            ca.norm_inf(C) <= POSITION_TOLERANCE * _scale(q), ca.norm_inf(C_dot) <= VELOCITY_TOLERANCE * _scale(q_dot)
        )
        # the largest of some numbers hides a NaN among them, their sum does not
        fits = ca.logic_and(fits, ca.sum1(ca.fabs(C)) + ca.sum1(ca.fabs(C_dot)) < FINITE)
        names = ["q_i", "q_i_dot", "q_d", "t", "c"]
        values = [ca.densify(value) for value in (q, q_dot, fits)]
        return ca.Function("fitting", [q_i, q_i_dot, q_d, t, c], values, names, ["q", "q_dot", "fits"])

    return model.derived("fitting", build)


def closable(model: EmittedModel) -> bool:
    """Does the model have what this needs?"""
    return bool(model.constraints) and all(model.has(name) for name in ("closure", "velocities", "constraints"))


def closed(model: EmittedModel, c: np.ndarray, t: float, q_i: np.ndarray, q_d: np.ndarray) -> tuple[np.ndarray, bool]:
    """(q_d (n_d,) at q_i (n_i,) from a guess of it, do the loops close?)."""
    step, open_ = closing(model), True
    for _ in range(MAX_ASSEMBLY_ITERATIONS):
        found = step(q_i, q_d, t, c)
        q_d, open_ = np.asarray(found[0]).ravel(), bool(float(found[1]) > 0)
        if not open_:
            break
    return q_d, not open_ and bool(np.isfinite(q_d).all())


def closed_state(
    model: EmittedModel, c: np.ndarray, t: float, q_i: np.ndarray, q_i_dot: np.ndarray, q_d: np.ndarray
) -> ConsistentState | None:
    """The state with these q_i and q_i_dot (n_i,) exactly, from a guess q_d (n_d,); None if it does not fit."""
    q_d, closes = closed(model, c, t, q_i, q_d)
    q, q_dot, fits = fitting(model)(q_i, q_i_dot, q_d, t, c)
    if not closes or not float(fits) > 0:
        return None
    return ConsistentState(np.asarray(q).ravel(), np.asarray(q_dot).ravel(), {})


def _symbols(model: EmittedModel, *names: str) -> list[ca.SX]:
    n_i, n_d = len(model.q_i), len(model.q_d)
    sizes = {"q_i": n_i, "q_i_dot": n_i, "q_d": n_d, "t": 1, "c": model.c_size}
    return [ca.SX.sym(name, sizes[name]) for name in names]


def _scale(values: ca.SX) -> ca.SX:
    return ca.fmax(1, ca.norm_inf(values))


def given_position(
    model: EmittedModel, p: np.ndarray, c: np.ndarray, t: float, changes: Mapping[str, float]
) -> tuple[np.ndarray, np.ndarray]:
    """(q_i, guess of the loop unknowns) with some coordinates changed; assembled only where it has to be.

    Turns count from charts that are 1.

    changes: coordinate names. Where q_d is a closed form of the q_i, and only those are changed, nothing has to be
    assembled. Raises InitialStateError.
    """
    if not model.loop_unknowns and set(changes) <= set(model.q_i):
        _split(model, changes)
        q_i = independent_part(model, model.initial_q)
        return np.array([changes.get(name, q_i[k]) for k, name in enumerate(model.q_i)]), np.zeros(0)
    state = given_state(model, p, c, t, changes)
    return independent_part(model, state.q), loop_part(model, state.q)


def given_state(model: EmittedModel, p: np.ndarray, c: np.ndarray, t0: float, initial: Initial) -> ConsistentState:
    """Consistent q and q_dot for parameters p at t0 [s], keeping the model's q_i except for the changes.

    initial: what has a state (see runtime.contract.coordinates), or changes by name: coordinates,
    `<coordinate>_dot` rates, angular velocities `<body>.omega_x`, and Euler angles of bodies described by them with
    their rates; they are kept exactly.
    Raises InitialStateError.
    """
    changes = values_by_name(initial)
    spins = {name: value for name, value in (changes or {}).items() if name in spin_names(model)}
    if spins:
        others = {name: value for name, value in (changes or {}).items() if name not in spins}
        still = given_state(model, p, c, t0, others)
        return _assembled(model, c, t0, *_with_spins(model, still, others, _split(model, spins, spin_names(model))[0]))
    coordinates, rates = _split(model, changes or {})
    defaults = np.array([parameter.default for parameter in model.parameters])
    if not changes and t0 == 0 and np.array_equal(p, defaults) and not model.sources:
        reported = tuple((ASSEMBLED, text) for text in model.assembly)
        return ConsistentState(model.initial_q, model.initial_q_dot, dict(model.initial_changes), reported=reported)
    if not model.constraints:
        q, q_dot = model.initial_q.copy(), model.initial_q_dot.copy()
        for k, name in enumerate(model.coordinates):
            q[k], q_dot[k] = coordinates.get(name, q[k]), rates.get(name, q_dot[k])
        return ConsistentState(q, q_dot, {})
    if closable(model) and keeps_independent(model, coordinates, rates):
        q, q_dot = model.initial_q.copy(), model.initial_q_dot.copy()
        for k, name in enumerate(model.coordinates):
            q[k], q_dot[k] = coordinates.get(name, q[k]), rates.get(name, q_dot[k])
        found = closed_state(model, c, t0, *independent(model, q, q_dot), dependent_part(model, q))
        if found is not None:
            return with_words(replace(found, placed=q), model.description.coordinates, coordinates)
    return _assembled(model, c, t0, coordinates, rates)


def keeps_independent(model: EmittedModel, coordinates: Iterable[str], rates: Iterable[str]) -> bool:
    """Are the coordinates, and those of the rates, all independent ones? Then q_d follows from the closure."""
    return {*coordinates, *rates} <= set(model.q_i)


def spin_names(model: EmittedModel) -> list[str]:
    """Names of the angular velocities in body axes."""
    return [f"{body}.{axis}" for body in parameter_columns(model) for axis in OMEGA]


def angle_starts(model: EmittedModel) -> list[str]:
    """Names of the Euler angles that can be given, and of their rates."""
    return [f"{name}{end}" for body in model.description.bodies for name in body.angles for end in ("", "_dot")]


def _with_spins(
    model: EmittedModel, state: ConsistentState, others: Mapping[str, float], spins: Mapping[str, float]
) -> tuple[dict[str, float], dict[str, float]]:
    """Coordinates and rates given by name, with rates of Euler parameters for angular velocities at a state.

    The Euler parameters of the state stand for angles of the same body.
    """
    coordinates, rates = _split(model, others)
    omega = {name: float(value) for name, value in angular_velocities(model, state.q, state.q_dot).items()}
    omega |= dict(spins)
    for body, columns in parameter_columns(model).items():
        names = [f"{body}.{axis}" for axis in OMEGA]
        if not spins.keys().isdisjoint(names):
            e = state.q[columns]
            twice = [name for name in angle_names(body) if name in rates]
            if twice:
                raise InitialStateError(
                    f"{twice[0]}_dot and angular velocities of {body} are given; give one or the other"
                )
            coordinates = {name: value for name, value in coordinates.items() if name not in angle_names(body)}
            coordinates |= {model.coordinates[k]: float(state.q[k]) for k in columns}
            turning = parameter_rates(e, np.array([omega[name] for name in names]))
            rates |= {model.coordinates[k]: float(rate) for k, rate in zip(columns, turning, strict=True)}
    return coordinates, rates


def _split(
    model: EmittedModel, changes: Mapping[str, float], known: Iterable[str] = ()
) -> tuple[dict[str, float], dict[str, float]]:
    coordinates: dict[str, float] = {}
    rates: dict[str, float] = {}
    angles = [name for body in model.description.bodies for name in body.angles]
    coordinate_of = {f"{name}_dot": name for name in (*model.coordinates, *angles)}
    coordinate_of |= {entry.owner: entry.name for entry in model.description.coordinates if entry.kind == "state"}
    for name, value in changes.items():
        if not is_finite_number(value):
            raise InitialStateError(f"initial value of {name} must be a finite number, not {shown_value(value)}")
        if name in model.coordinates or name in known or name in angles:
            coordinates[name] = float(value)
        elif name in coordinate_of:
            rates[coordinate_of[name]] = float(value)
        else:
            raise InitialStateError(
                f"model {model.name} has no coordinate {name!r}; it has "
                f"{', '.join([*model.coordinates, *angles])} (rates end in _dot)"
            )
    return coordinates, rates


def _assembled(
    model: EmittedModel, c: np.ndarray, t0: float, coordinates: dict[str, float], rates: dict[str, float]
) -> ConsistentState:
    shape = (len(model.constraints), len(model.coordinates))

    def evaluate(q: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        result = model.evaluate("constraints", q=q, q_dot=np.zeros(shape[1]), t=t0, c=c)
        C, C_q, C_t = (np.asarray(result[name]) for name in ("C", "C_q", "C_t"))
        return C.ravel(), C_q.reshape(shape), C_t.ravel()

    def velocity(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        _, C_q, C_t = evaluate(q)
        return C_q, -C_t

    form = AngleForm(model.coordinates, angle_bodies({**coordinates, **rates}, euler_angles(model)))
    own = [name for name in followed(model)[0] if name in form.own] + form.own[len(form.plain) :]
    at = [form.own.index(name) for name in own]
    independent = dict(zip(own, form.of_coordinates(model.initial_q)[at], strict=True))
    independent_rates = dict(zip(own, form.of_rates(model.initial_q, model.initial_q_dot)[at], strict=True))
    elastic = frozenset(model.coordinates.index(name) for name in model.elastic)
    keep = {
        name: value
        for name, value in independent.items()
        if not coordinates or set(coordinates) <= set(own) or name in model.elastic
    }
    keep_rates = {
        name: value
        for name, value in independent_rates.items()
        if not rates or set(rates) <= set(own) or name in model.elastic
    }
    task = Assembly(
        model.coordinates,
        elastic,
        [row.joint or row.label for row in model.description.constraints],
        lambda q: evaluate(q)[:2],
        velocity,
        GivenValues({**keep, **coordinates}, frozenset(coordinates)),
        GivenValues({**keep_rates, **rates}, frozenset(rates)),
        model.initial_q,
        sequences=form.sequences,
    )
    found = consistent_state(task)
    return with_words(found, model.description.coordinates, coordinates)
