"""The scene's constraints as numbers at default parameters, and the consistent initial state."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import (
    Assembly,
    ConsistentState,
    GivenValues,
    InitialStateError,
    angle_bodies,
    consistent_state,
    with_words,
)
from runtime.contract.orientations import angle_names, parameter_rates
from symgen.algebra.parameters import ParameterTable
from symgen.system.build import System
from symgen.system.constraint import DerivationError
from symgen.system.equations import Equations

MOST_PLACING_STEPS = 30  # of Newton's method for the place of a body
PLACED_ROWS = 1e-12  # error of the rows of a joint, relative to the place
OMEGA = ("omega_x", "omega_y", "omega_z")


class ConstraintNumbers:
    """C, C_q and C_t of all rows at a position and a time, with default parameters and inputs."""

    def __init__(self, equations: Equations, table: ParameterTable) -> None:
        rows, self._equations = equations.constraints, equations
        outputs = [
            ca.densify(ca.vertcat(*(row.C for row in rows))),
            ca.sparsify(equations.C_q),
            ca.densify(ca.vertcat(*(row.C_t for row in rows))),
        ]
        known = self._known = ca.vertcat(table.vector(), *equations.u.values())
        # every chart where the Euler parameters are, every rotation vector from there zero
        charts = ca.vertcat(*(entry for rotation in equations.rotation_vectors for entry in rotation.chart))
        turns = ca.vertcat(*(equations.q[column] for column in sorted(equations.turn_columns)))
        e = ca.vertcat(*(entry for rotation in equations.rotation_vectors for entry in rotation.e))
        if charts.numel():
            outputs = ca.substitute(outputs, [ca.vertcat(charts, turns)], [ca.vertcat(e, ca.SX.zeros(turns.numel()))])
        own = ca.vertcat(*(x for column, x in enumerate(equations.q) if column not in equations.turn_columns))
        self._function = ca.Function("constraints", [own, equations.t, known], outputs)
        defaults = [entry.default for entry in table.entries]
        self._defaults = np.array([*defaults, *equations.input_defaults])
        self._shape = (len(rows), len(equations.names))
        self._places = [np.array(found, dtype=int) for found in self._function.sparsity_out(1).get_triplet()]

    def _jacobian(self, C_q: ca.DM) -> np.ndarray:
        found = np.zeros(self._shape)
        found[self._places[0], self._places[1]] = C_q.nonzeros()
        return found

    def position(self, q: np.ndarray, t: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
        """(C, C_q)."""
        C, C_q, _ = self._function(q, t, self._defaults)
        return np.asarray(C).ravel(), self._jacobian(C_q)

    def velocity(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(C_q, nu) at t = 0."""
        _, C_q, C_t = self._function(q, 0.0, self._defaults)
        return self._jacobian(C_q), -np.asarray(C_t).ravel()

    def of_body(self, rows: list[int], own: list[int]) -> tuple[list[int], ca.Function]:
        """(other columns that some rows depend on, (their q, other q) -> C, dC/d(their q) at t = 0)."""
        eq = self._equations
        others = sorted({column for row in rows for column in eq.constraints[row].C_q} - set(own))
        C = ca.vertcat(*(eq.constraints[row].C for row in rows))
        x, y = (ca.vertcat(*(eq.q[column] for column in columns)) for columns in (own, others))
        known = ca.vertcat(eq.t, self._known)
        C = ca.substitute(C, known, ca.vertcat(0.0, ca.DM(self._defaults)))
        return others, ca.Function("body", [x, y], [C, ca.jacobian(C, x)])


def assembled(system: System, numbers: ConstraintNumbers) -> ConsistentState:
    """The requested initial state made consistent. Raises DerivationError if there is none within reach."""
    equations, topology, requested = system.equations, system.topology, system.requested
    following = frozenset(
        k
        for k, coordinate in enumerate(equations.coordinates)
        if coordinate.owner in topology.placed and not coordinate.elastic
    )
    spins = {name for name in requested.rates.values if name.partition(".")[2] in OMEGA}
    rates = GivenValues(
        {name: value for name, value in requested.rates.values.items() if name not in spins},
        requested.rates.fixed - spins,
    )
    at_rest = np.array([coordinate.at_rest for coordinate in equations.coordinates])
    by_angles = angle_bodies({**requested.coordinates.values, **rates.values}, requested.euler_angles)

    def state_with(sequences: Mapping[str, str], coordinates: GivenValues, rates: GivenValues) -> ConsistentState:
        task = Assembly(
            equations.names,
            equations.elastic_columns,
            [row.joint or row.label for row in equations.constraints],
            numbers.position,
            numbers.velocity,
            coordinates,
            rates,
            _placed(system, numbers, coordinates.values) if not sequences else at_rest,
            equations.joint_columns,
            [k for k, row in enumerate(equations.constraints) if row.joint in topology.placements],
            following,
            frozenset(k for k, coordinate in enumerate(equations.coordinates) if coordinate.kind == "position"),
            sequences,
        )
        return consistent_state(task)

    try:
        state = state_with(by_angles, requested.coordinates, rates)
        if spins:
            rotation = angle_bodies(rates.values, by_angles)
            places = _by_parameters(equations, state.q, requested.coordinates, by_angles.keys() - rotation.keys())
            moving = state_with(rotation, places, _with_spins(equations, state.q, requested.rates, rates))
            state = replace(moving, changed={**state.changed, **moving.changed})
    except InitialStateError as error:
        problem, _, remedy = str(error).rpartition("; ")
        raise DerivationError("initial", problem or remedy, remedy if problem else "check parameters") from error
    return with_words(state, equations.coordinates, requested.coordinates.values)


def _placed(system: System, numbers: ConstraintNumbers, given: Mapping[str, float]) -> np.ndarray:
    """All coordinates at rest, bodies in space where the joints that place them put them, one after the other.

    Newton's method for a long chain as a whole is held to short steps by its far end. A body of which anything is given
    stays where it is at rest, and so does one that does not get where its joint says.
    """
    eq, placements = system.equations, system.topology.placements.values()
    q = np.array([coordinate.at_rest for coordinate in eq.coordinates])
    known = np.array([given.get(name, value) for name, value in zip(eq.names, q, strict=True)])
    rows: dict[str, list[int]] = {}
    for k, row in enumerate(eq.constraints):
        rows.setdefault(row.joint or row.label, []).append(k)
    waiting = {one.child: one for one in placements}
    while waiting:
        one = next(one for one in waiting.values() if one.parent not in waiting)
        del waiting[one.child]
        own = eq.frame_columns(one.child)
        if any(eq.names[column] in given for column in own):
            continue
        turned = eq.frame_columns(one.parent) if one.parent != "ground" else []
        start = known[own]
        if len(turned) == len(own):
            start[3:] = known[turned[3:]]
        found = _pose(numbers, rows[one.joint] + rows.get(f"{one.child}.norm", []), own, start, known)
        if found is not None:
            q[own] = known[own] = found
    return q


def _pose(
    numbers: ConstraintNumbers, rows: list[int], own: list[int], x: np.ndarray, q: np.ndarray
) -> np.ndarray | None:
    """Origin and Euler parameters of a body by its rows, from x on; None where these do not give them."""
    others, function = numbers.of_body(rows, own)
    best, least = x, np.inf
    for _ in range(MOST_PLACING_STEPS):
        C, slope = (np.asarray(part) for part in function(x, q[others]))
        error = float(np.abs(C).max())
        if not error < least:
            break
        best, least = x, error
        x = x - np.linalg.lstsq(slope, C.ravel(), rcond=1e-13)[0]
    return _positive(best) if least <= PLACED_ROWS * max(1.0, float(np.abs(best).max())) else None


def _positive(x: np.ndarray) -> np.ndarray:
    """The same place by Euler parameters of which the first is not negative."""
    return np.concatenate([x[:3], -x[3:]]) if x[3] < 0 else x


def _by_parameters(equations: Equations, q: np.ndarray, given: GivenValues, bodies: Collection[str]) -> GivenValues:
    """The Euler parameters at q for the angles of these bodies; those of a body are fixed if one of its angles is."""
    values, fixed = dict(given.values), set(given.fixed)
    for body in bodies:
        angles = set(angle_names(body))
        own = [f"{body}.e{k}" for k in range(4)]
        values = {name: value for name, value in values.items() if name not in angles}
        values |= {name: float(q[equations.names.index(name)]) for name in own}
        fixed = (fixed - angles) | (set(own) if fixed & angles else set())
    return GivenValues(values, frozenset(fixed))


def _with_spins(equations: Equations, q: np.ndarray, given: GivenValues, rates: GivenValues) -> GivenValues:
    """Rates with those of Euler parameters at q for the angular velocities among the given; what is left out is zero.

    Those of a body are fixed if one of its angular velocities is.
    """
    values, fixed = dict(rates.values), set(rates.fixed)
    for body in sorted({name.partition(".")[0] for name in given.values.keys() - rates.values.keys()}):
        names = [f"{body}.omega_{axis}" for axis in "xyz"]
        columns = [equations.names.index(f"{body}.e{k}") for k in range(4)]
        rotation = parameter_rates(q[columns], np.array([given.values.get(name, 0.0) for name in names]))
        own = [equations.names[column] for column in columns]
        values |= dict(zip(own, rotation.tolist(), strict=True))
        fixed |= set(own) if given.fixed & set(names) else set()
    return GivenValues(values, frozenset(fixed))
