"""What stops and what holds do to the rates of a mechanism, as an expression that can be differentiated.

Of rows G of q_i that are struck or held, with rates G q_i' + b,

    q_i'+ = q_i'- - M_hat^-1 G^T A^-1 (1 + e) (G q_i'- + b),    A = G M_hat^-1 G^T,

e = 0 of what is held. Which rows these are is data, found in a run. Whatever disturbs a row that is held at a start has
come to rest before anything else moves: it loses its part G dq_i' by that formula, and dq_i where a stop holds it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.errors import NoResult
from runtime.contract.model import EmittedModel
from runtime.running.events import state_of
from runtime.schemes.scheme import Scheme
from runtime.schemes.sparse_lu import Number, factor, solve, solve_symmetric
from runtime.schemes.stage_equations import StageEquations
from runtime.schemes.switching.settle import NoMode, Settled, elements, settled
from runtime.schemes.switching.stops import TOUCH

FOLLOWS = 1e-9  # of a row of G: what is left of one that follows from others
MOVES = 1e-6  # of the largest rate, or slope: less is rounding


def sizes(model: EmittedModel) -> tuple[int, int]:
    """How many elements there are, and how many rigid stops."""
    found = model.kernel("elements")
    return int(found.size1_out("G")), sum(bool(event.side) for event in model.mode_events)


def _elements(equations: StageEquations, place: tuple[ca.SX, ca.SX, ca.SX], v: ca.SX) -> dict[str, ca.SX]:
    """The function `elements`; place: q_i, a guess of the loop unknowns, t."""
    motion = equations.close_well(*place)
    at = {"q_i": motion.q_i, "q_d": motion.q_d, "q_i_dot": v, "q_d_dot": equations.rates(motion, v), "t": motion.t}
    return equations.call("elements", **at)


def _pushed(own: Mapping[str, ca.SX], rows: ca.SX, speed: ca.SX) -> ca.SX:
    """(n_i,) what takes these speeds (n_e,) from rows, none of which follows from others: -M_hat^-1 G^T A^-1 speed."""
    G = ca.diag(rows) @ own["G"]
    factors = factor(Number(ca.sparsify(own["M_hat"])), symmetric=True)
    by = ca.horzcat(*(solve(factors, Number(ca.densify(one))).re for one in ca.horzsplit(ca.densify(G.T))))
    return -by @ solve_symmetric(G @ by + ca.diag(1 - rows), rows * speed)


def thrown(equations: StageEquations, place: tuple[ca.SX, ca.SX, ca.SX], v: ca.SX, rows: ca.SX, struck: ca.SX) -> ca.SX:
    """(n_i,) what is added to q_i' = v; place: q_i, a guess of the loop unknowns, t.

    rows (n_e,): one of those that are struck or held, of which none follows from others, else zero; struck
    (n_stop,): one of stops that are struck.
    """
    own = _elements(equations, place, v)
    speed = ca.SX(own["v_rel"])
    for k, row in enumerate(_stop_rows(equations.model)):
        speed[row] = speed[row] + struck[k] * own["restitution"][k] * own["v_rel"][row]
    return _pushed(own, rows, speed)


def _stop_rows(model: EmittedModel) -> list[int]:
    return [event.row for event in model.mode_events if event.side]


def rows_of(
    model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray, settled: Settled
) -> tuple[np.ndarray, np.ndarray]:
    """(rows (n_e,), hit (n_stop,)), see `thrown`, of what elements did at a state with constants c."""
    events, G = model.mode_events, elements(model, at, c)["G"]
    hits = {one.k: one.rests is None for one in settled.impacts}  # bounces that are summed end at once
    struck = np.array([hits.get(k, False) for k, event in enumerate(events) if event.side], dtype=float)
    return _independent(G, {event.row for k, event in enumerate(events) if k in hits or settled.modes[k] == 0}), struck


def _independent(G: np.ndarray, wanted: set[int]) -> np.ndarray:
    """(n_e,) one of the rows of G (n_e, n_i) that are wanted and do not follow from those before, else zero."""
    rows, basis = np.zeros(len(G)), np.zeros((0, G.shape[1]))
    for k in sorted(wanted):
        left = G[k] - basis.T @ (basis @ G[k])
        left = left - basis.T @ (basis @ left)
        if (size := np.linalg.norm(left)) > FOLLOWS * np.linalg.norm(G[k]):
            rows[k], basis = 1.0, np.vstack([basis, left / size])
    return rows


# What is held where a run starts.


@dataclass(frozen=True)
class Held:
    """closed, rows (n_e,): independent rows that stops hold, and all that are held; loose: events of those at rest that
    are not held (positions among `mode_events`).
    """

    closed: np.ndarray
    rows: np.ndarray
    loose: list[int]


def held_at_start(scheme: Scheme, z: np.ndarray, c: np.ndarray, p: np.ndarray) -> Held | None:
    """At a state z; the modes of elements go into p. None where there are no elements. Raises NoResult."""
    model, events = scheme.model, scheme.model.mode_events
    if not events:
        return None
    at, none = state_of(scheme, z, scheme.constants(c)), np.zeros(len(events))
    found = settled(model, at, c, none, none)
    slow = MOVES * (1 + np.abs(at["q_i_dot"]).max())
    if isinstance(found, NoMode) or np.abs(found.push).max() > slow:
        raise NoResult(
            f"the start of model {model.name}",
            "has no derivative: a stop is struck there, or no modes are consistent",
            "start slightly away from it",
        )
    p[len(p) - model.signals.size + model.element_modes] = found.modes
    own, modes = elements(model, at, c), list(enumerate(zip(events, found.modes, strict=True)))
    closed = {one.row for _, (one, mode) in modes if mode == 0 and one.side}
    rows = {one.row for _, (one, mode) in modes if mode == 0}
    loose = [
        k for k, (one, mode) in modes
        if one.row not in rows and (mode == -1 if one.side else abs(own["v_rel"][one.row]) <= slow)
    ]  # fmt: skip
    return Held(_independent(own["G"], closed), _independent(own["G"], rows), loose)


def held_slopes(
    model: EmittedModel, t: float, x: np.ndarray, slopes: np.ndarray, by: Sequence[str], held: Held
) -> np.ndarray:
    """Slopes (n_x, n) of x = (p, q_i, q_i_dot, loop unknowns) by names, with what is held at rest. Raises NoResult."""
    n_p, n_i = len(model.parameters), len(model.q_i)
    function = model.derived("held_slopes", lambda: _held_slopes(model))
    shift, push, rates, gaps = (np.asarray(one) for one in function(t, x, held.closed, held.rows))
    found = slopes.copy()
    found[n_p : n_p + n_i] += shift @ slopes
    found[n_p + n_i : n_p + 2 * n_i] += push @ found
    stops = [k for k, event in enumerate(model.mode_events) if event.side]
    for k in held.loose:
        event = model.mode_events[k]
        moved = np.abs(rates[event.row] @ found)
        if k in stops:
            moved = np.maximum(moved, np.abs(gaps[stops.index(k)] @ found))
        if moved.max() > MOVES * max(1.0, np.abs(slopes).max()):
            raise NoResult(
                f"derivative by {by[int(moved.argmax())]}",
                f"differs on the two sides: {event.name} is at rest at the start and not held",
                "start slightly away from it, or leave it out of `by`",
            )
    return found


def _held_slopes(model: EmittedModel) -> ca.Function:
    """(t, x, closed, rows) -> by x (n_x,) what leaves positions on stops, what leaves rates at rest, rates, gaps."""
    n_i, n_e, p = len(model.q_i), sizes(model)[0], ca.SX.sym("p", len(model.parameters))
    t, closed, rows = ca.SX.sym("t"), ca.SX.sym("closed", n_e), ca.SX.sym("rows", n_e)
    q_i, v, loop = ca.SX.sym("q_i", n_i), ca.SX.sym("v", n_i), ca.SX.sym("loop", len(model.loop_unknowns))
    own = _elements(StageEquations(model, model.kernel("constants")(p)), (q_i, loop, t), v)
    beyond, gaps = ca.SX.zeros(n_e), own.get("gap", ca.SX(0, 1))
    for k, one in enumerate(event for event in model.mode_events if event.side):
        beyond[one.row] = beyond[one.row] + one.side * ca.if_else(ca.fabs(gaps[k]) <= TOUCH, gaps[k], 0)
    x = ca.vertcat(p, q_i, v, loop)
    found = [_pushed(own, closed, beyond), _pushed(own, rows, own["v_rel"]), own["v_rel"], gaps]
    return ca.Function("held_slopes", [t, x, closed, rows], [ca.densify(ca.jacobian(one, x)) for one in found])
