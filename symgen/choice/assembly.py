"""The scene's constraints as numbers at default parameters, and the consistent initial state."""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from runtime.contract.angular import parameter_rates
from runtime.contract.consistent_state import ConsistentState, GivenValues, InitialStateError, consistent_state
from symgen.algebra.parameters import ParameterTable
from symgen.choice.elimination import constraint_jacobian
from symgen.system.build import System
from symgen.system.equations import Equations
from symgen.system.errors import DerivationError

SINGULAR = 1e-6  # sine of the angle between the first and the last axis of Euler angles


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
    spins = {name for name in requested.rates.values if name not in equations.names}
    rates = GivenValues(
        {name: value for name, value in requested.rates.values.items() if name not in spins},
        requested.rates.fixed - spins,
    )

    def state_with(rates: GivenValues) -> ConsistentState:
        return consistent_state(
            equations.names,
            equations.elastic_columns,
            [row.joint or row.label for row in equations.constraints],
            numbers.position,
            numbers.velocity,
            requested.coordinates,
            rates,
            np.array([coordinate.at_rest for coordinate in equations.coordinates]),
            equations.joint_columns,
            [k for k, row in enumerate(equations.constraints) if row.joint in topology.placements],
            following,
        )

    try:
        state = state_with(rates)
        if spins:
            state = state_with(_with_spins(equations, state.q, requested.rates, rates))
    except InitialStateError as error:
        problem, _, remedy = str(error).rpartition("; ")
        raise DerivationError("initial", problem or remedy, remedy if problem else "check parameters") from error
    _require_regular_angles(requested.euler_angles, equations, state.q)
    return state


def _with_spins(equations: Equations, q: np.ndarray, given: GivenValues, rates: GivenValues) -> GivenValues:
    """Rates with those of Euler parameters at q for the angular velocities among the given; what is left out is zero.

    Those of a body are fixed if one of its angular velocities is.
    """
    values, fixed = dict(rates.values), set(rates.fixed)
    for body in {name.partition(".")[0] for name in given.values.keys() - rates.values.keys()}:
        names = [f"{body}.omega_{axis}" for axis in "xyz"]
        columns = [equations.names.index(f"{body}.e{k}") for k in range(4)]
        turning = parameter_rates(q[columns], np.array([given.values.get(name, 0.0) for name in names]))
        own = [equations.names[column] for column in columns]
        values |= dict(zip(own, turning.tolist(), strict=True))
        fixed |= set(own) if given.fixed & set(names) else set()
    return GivenValues(values, frozenset(fixed))


def _require_regular_angles(sequences: Mapping[str, str], equations: Equations, q: np.ndarray) -> None:
    """Refuse Euler angles (sequences by body) that start where their first and last axis coincide."""
    for body, sequence in sequences.items():
        turning = [k for k, c in enumerate(equations.coordinates) if c.owner == body and c.kind == "angle"]
        if len(turning) != 3:  # a planar scene takes no notice of the sequence
            continue
        name, middle = equations.names[turning[1]], q[turning[1]]
        if abs(np.sin(middle) if sequence[0] == sequence[2] else np.cos(middle)) < SINGULAR:
            raise DerivationError(
                name,
                f"Euler angles {sequence} are singular at their start value {middle:.6g}: the "
                "first and the last turn about the same axis",
                'start at another angle, choose another sequence, or use orientation = "euler_parameters"',
            )
