"""Measures, coordinates and rates as outputs of a linear system: their derivatives along the constraints."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.operating.functions import ALREADY_CLOSED, all_coordinates, dependent_rates
from runtime.schemes.stage_equations import StageEquations
from runtime.schemes.turned_axes import along_rotations, turning

SHOWN = 30  # names that an error lists


def output_slopes(model: Model, names: Sequence[str], inputs: Sequence[str], drives_move: bool = True) -> ca.Function:
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
    if model.measures:
        found = equations.call("measures", q=places, q_dot=rates, t=t)["measures"]
        known |= {name: found[k] for k, name in enumerate(model.measures)}
    for name in names:
        if name not in known:
            listed = ", ".join([*model.measures, *model.coordinates][:SHOWN])
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
