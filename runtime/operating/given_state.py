"""A consistent state with values changed by name: the model's own, or assembled anew."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from runtime.contract.consistent_state import ConsistentState, GivenValues, InitialStateError, consistent_state
from runtime.contract.model import Model
from runtime.operating.assembly import closable, closed_state


def given_position(
    model: Model, p: np.ndarray, c: np.ndarray, t: float, changes: Mapping[str, float]
) -> tuple[np.ndarray, np.ndarray]:
    """(q_i, guess of the loop unknowns) with some coordinates changed; assembled only where it has to be.

    changes: coordinate names. Where q_d is a closed form of the q_i, and only those are changed, nothing has to be
    assembled. Raises InitialStateError.
    """
    if not model.loop_unknowns and set(changes) <= set(model.q_i):
        _split(model, changes)
        q = model.initial_q
        return np.array([changes.get(name, q[model.coordinates.index(name)]) for name in model.q_i]), np.zeros(0)
    state = given_state(model, p, c, t, changes)
    return state.q[model.independent_columns], state.q[model.loop_columns]


def given_state(
    model: Model, p: np.ndarray, c: np.ndarray, t0: float, changes: Mapping[str, float] | None
) -> ConsistentState:
    """Consistent q and q_dot for parameters p at t0 [s], keeping the model's q_i except for the changes.

    changes: coordinate names and `<coordinate>_dot` rates; they are kept exactly. Raises InitialStateError.
    """
    coordinates, rates = _split(model, changes or {})
    defaults = np.array([parameter.default for parameter in model.parameters])
    if not changes and t0 == 0 and np.array_equal(p, defaults) and not model.sources:
        return ConsistentState(model.initial_q, model.initial_q_dot, dict(model.initial_changes))
    if not model.constraints:
        q, q_dot = model.initial_q.copy(), model.initial_q_dot.copy()
        for k, name in enumerate(model.coordinates):
            q[k], q_dot[k] = coordinates.get(name, q[k]), rates.get(name, q_dot[k])
        return ConsistentState(q, q_dot, {})
    if closable(model) and keeps_independent(model, coordinates, rates):
        q, q_dot = model.initial_q.copy(), model.initial_q_dot.copy()
        for k, name in enumerate(model.coordinates):
            q[k], q_dot[k] = coordinates.get(name, q[k]), rates.get(name, q_dot[k])
        i, d = model.independent_columns, model.dependent_columns
        found = closed_state(model, c, t0, q[i], q_dot[i], q[d])
        if found is not None:
            return found
    return _assembled(model, c, t0, coordinates, rates)


def keeps_independent(model: Model, coordinates: Iterable[str], rates: Iterable[str]) -> bool:
    """Are the coordinates, and those of the rates, all independent ones? Then q_d follows from the closure."""
    return {*coordinates, *rates} <= set(model.q_i)


def _split(model: Model, changes: Mapping[str, float]) -> tuple[dict[str, float], dict[str, float]]:
    coordinates: dict[str, float] = {}
    rates: dict[str, float] = {}
    coordinate_of = {f"{name}_dot": name for name in model.coordinates}
    coordinate_of |= {entry.owner: entry.name for entry in model.description.coordinates if entry.kind == "state"}
    for name, value in changes.items():
        if isinstance(value, bool) or not isinstance(value, int | float | np.number) or not np.isfinite(value):
            raise InitialStateError(f"initial value of {name} must be a finite number, not {value!r}")
        if name in model.coordinates:
            coordinates[name] = float(value)
        elif name in coordinate_of:
            rates[coordinate_of[name]] = float(value)
        else:
            raise InitialStateError(
                f"model {model.name} has no coordinate {name!r}; it has "
                f"{', '.join(model.coordinates)} (rates end in _dot)"
            )
    return coordinates, rates


def _assembled(
    model: Model, c: np.ndarray, t0: float, coordinates: dict[str, float], rates: dict[str, float]
) -> ConsistentState:
    shape = (len(model.constraints), len(model.coordinates))

    def evaluate(q: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        result = model.evaluate("constraints", q=q, q_dot=np.zeros(shape[1]), t=t0, c=c)
        C, C_q, C_t = (np.asarray(result[name]) for name in ("C", "C_q", "C_t"))
        return C.ravel(), C_q.reshape(shape), C_t.ravel()

    def velocity(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        _, C_q, C_t = evaluate(q)
        return C_q, -C_t

    independent = {name: model.initial_q[model.coordinates.index(name)] for name in model.q_i}
    independent_rates = {name: model.initial_q_dot[model.coordinates.index(name)] for name in model.q_i}
    elastic = frozenset(model.coordinates.index(name) for name in model.elastic)
    keep = {
        name: value
        for name, value in independent.items()
        if not coordinates or set(coordinates) <= set(model.q_i) or name in model.elastic
    }
    keep_rates = {
        name: value
        for name, value in independent_rates.items()
        if not rates or set(rates) <= set(model.q_i) or name in model.elastic
    }
    return consistent_state(
        model.coordinates,
        elastic,
        [row.joint or row.label for row in model.description.constraints],
        lambda q: evaluate(q)[:2],
        velocity,
        GivenValues({**keep, **coordinates}, frozenset(coordinates)),
        GivenValues({**keep_rates, **rates}, frozenset(rates)),
        guess=model.initial_q,
    )
