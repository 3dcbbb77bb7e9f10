"""The scene's constraints as numbers at default parameters, and the consistent initial state."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import casadi as ca
import numpy as np

from runtime.contract.angle_start import angle_bodies, consistent_state_by_angles
from runtime.contract.angular import parameter_rates
from runtime.contract.assembled import with_words
from runtime.contract.consistent_state import ConsistentState, GivenValues, InitialStateError
from runtime.contract.euler_angles import angle_names
from symgen.algebra.parameters import ParameterTable
from symgen.choice.elimination import constraint_jacobian
from symgen.system.build import System
from symgen.system.equations import Equations
from symgen.system.errors import DerivationError

OMEGA = ("omega_x", "omega_y", "omega_z")


class ConstraintNumbers:
    """C, C_q and C_t of all rows at a position and a time, with default parameters and inputs."""

    def __init__(self, equations: Equations, table: ParameterTable) -> None:
        rows = equations.constraints
        outputs = [
            ca.densify(ca.vertcat(*(row.C for row in rows))),
            ca.densify(constraint_jacobian(equations)),
            ca.densify(ca.vertcat(*(row.C_t for row in rows))),
        ]
        known = ca.vertcat(table.vector(), *equations.u.values())
        # every chart where the Euler parameters are, every rotation vector from there zero
        charts = ca.vertcat(*(entry for turning in equations.turnings for entry in turning.chart))
        turns = ca.vertcat(*(equations.q[column] for column in sorted(equations.turn_columns)))
        e = ca.vertcat(*(entry for turning in equations.turnings for entry in turning.e))
        if charts.numel():
            outputs = ca.substitute(outputs, [ca.vertcat(charts, turns)], [ca.vertcat(e, ca.SX.zeros(turns.numel()))])
        own = ca.vertcat(*(x for column, x in enumerate(equations.q) if column not in equations.turn_columns))
        self._function = ca.Function("constraints", [own, equations.t, known], outputs)
        defaults = [entry.default for entry in table.entries]
        self._defaults = np.array([*defaults, *equations.input_defaults])
        self._shape = (len(rows), len(equations.names))

    def position(self, q: np.ndarray, t: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
        """(C, C_q)."""
        C, C_q, _ = self._function(q, t, self._defaults)
        return np.asarray(C).ravel(), np.asarray(C_q).reshape(self._shape)

    def velocity(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(C_q, nu) at t = 0."""
        _, C_q, C_t = self._function(q, 0.0, self._defaults)
        return np.asarray(C_q).reshape(self._shape), -np.asarray(C_t).ravel()


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
    by_angles = angle_bodies({**requested.coordinates.values, **rates.values}, requested.euler_angles)

    def state_with(sequences: Mapping[str, str], coordinates: GivenValues, rates: GivenValues) -> ConsistentState:
        return consistent_state_by_angles(
            sequences,
            equations.names,
            equations.elastic_columns,
            [row.joint or row.label for row in equations.constraints],
            numbers.position,
            numbers.velocity,
            coordinates,
            rates,
            np.array([coordinate.at_rest for coordinate in equations.coordinates]),
            equations.joint_columns,
            [k for k, row in enumerate(equations.constraints) if row.joint in topology.placements],
            following,
            frozenset(k for k, coordinate in enumerate(equations.coordinates) if coordinate.kind == "position"),
        )

    try:
        state = state_with(by_angles, requested.coordinates, rates)
        if spins:
            turning = angle_bodies(rates.values, by_angles)
            places = _by_parameters(equations, state.q, requested.coordinates, by_angles.keys() - turning.keys())
            moving = state_with(turning, places, _with_spins(equations, state.q, requested.rates, rates))
            state = replace(moving, changed={**state.changed, **moving.changed})
    except InitialStateError as error:
        problem, _, remedy = str(error).rpartition("; ")
        raise DerivationError("initial", problem or remedy, remedy if problem else "check parameters") from error
    return with_words(state, equations.coordinates, requested.coordinates.values)


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
        turning = parameter_rates(q[columns], np.array([given.values.get(name, 0.0) for name in names]))
        own = [equations.names[column] for column in columns]
        values |= dict(zip(own, turning.tolist(), strict=True))
        fixed |= set(own) if given.fixed & set(names) else set()
    return GivenValues(values, frozenset(fixed))
