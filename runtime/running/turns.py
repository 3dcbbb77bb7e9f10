"""How fast the angles of closed loops turn: a loop is followed from step to step, so a step must not turn it far.

The unknowns of a loop are found by Newton from those of the step before. Where a step turns the loop by a large part of
a turn, Newton may fail or find another branch, and coarse motions that err in this way tell nothing of the fine one.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import rate_parts
from runtime.contract.model import EmittedModel
from runtime.engine.rows import evaluate
from runtime.schemes.scheme import Scheme

MOST_TURN_OF_STEP = 0.3  # rad in a step


def loop_angles(model: EmittedModel) -> tuple[np.ndarray, np.ndarray]:
    """(positions in q_i, positions in q_d) of the angles that closures of loops depend on, loop unknowns included."""
    return model.derived("loop_angles", lambda: _loop_angles(model))


def _loop_angles(model: EmittedModel) -> tuple[np.ndarray, np.ndarray]:
    if not model.loop_unknowns:
        return np.zeros(0, dtype=int), np.zeros(0, dtype=int)
    q_i, q_d = ca.SX.sym("q_i", len(model.q_i)), ca.SX.sym("q_d", len(model.q_d))
    t, c = ca.SX.sym("t"), ca.SX.sym("c", model.c_size)
    C_loop = model.evaluate("closure", q_i=q_i, q_d=q_d, t=t, c=c)["C_loop"]
    angles = {entry.name for entry in model.description.coordinates if entry.turns}
    angles |= {name for record in model.description.orientations for name in record.turns}
    found = []
    for names, symbols in ((model.q_i, q_i), (model.q_d, q_d)):
        known = set(ca.jacobian(C_loop, symbols).sparsity().get_col())
        found.append(np.array([k for k, name in enumerate(names) if k in known and name in angles], dtype=int))
    return found[0], found[1]


def frequency_at_start(model: EmittedModel, state: ConsistentState) -> float:
    """Steps in a second [1/s] that do not turn a loop too far at the rates of a state; 0 where there are no loops."""
    i, d = loop_angles(model)
    v_i, v_d = rate_parts(model, state.q, state.q_dot)
    return _largest(v_i[i], v_d[d]) / MOST_TURN_OF_STEP


def frequency_at_states(
    model: EmittedModel, scheme: Scheme, c: np.ndarray, states: np.ndarray, by_change: bool = False
) -> float:
    """The same at states z (N, n_z) of a scheme; by_change: by accelerations, too, as they count in a step.

    c (c_size,): constants of the model.
    """
    i, d = loop_angles(model)
    if not len(i) + len(d) or not len(states):
        return 0.0
    observed = evaluate(scheme.observer, {"z": states}, scheme.constants(c))
    rate = _largest(observed["q_i_dot"][:, i], observed["q_d_dot"][:, d])
    if not by_change:
        return rate / MOST_TURN_OF_STEP
    change = _largest(observed["q_i_ddot"][:, i], observed["q_d_ddot"][:, d])
    # 1 / h with rate h + change h^2 / 2 = MOST_TURN_OF_STEP
    return float(rate + np.sqrt(rate**2 + 2 * change * MOST_TURN_OF_STEP)) / (2 * MOST_TURN_OF_STEP)


def _largest(*values: np.ndarray) -> float:
    """Magnitude of those that are finite."""
    found = np.abs(np.concatenate([one.ravel() for one in values]))
    return float(found[np.isfinite(found)].max(initial=0.0))
