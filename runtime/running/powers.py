"""What acts just before and behind a change of inputs or modes: powers that samples do not show.

A sampled controller, an event or a change of friction's mode lets the power jump, often between two samples. The state
there is kept as it goes by, and its power and the rate of that are computed when the run is over, all at once: just
before it and just behind it along the motion, for the state itself is on one side of a load that jumps there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from runtime.contract.coordinates import joined
from runtime.contract.model import EmittedModel
from runtime.contract.tape import shared
from runtime.engine.rows import evaluate
from runtime.schemes.scheme import Scheme
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.switching.impulse import moves_in_time

if TYPE_CHECKING:
    from runtime.running.stepped_model import SteppedModel

MAX_CHANGES = 20_000  # changes of a run whose powers are kept
BESIDE, LEAST_BESIDE = 1e-7, 1e-11  # of a step; of a time, and s: how far from a change; events are located closer
ONE_TIME = 1e-14  # of a time, and s: an impact stands just before its changes of modes


@dataclass(frozen=True)
class Change:
    """Of inputs and rates at t [s]: z (n_z,) as it is seen with constants c before it; w (n_w,), push (n_i,) behind."""

    t: float
    z: np.ndarray
    c: np.ndarray
    w: np.ndarray
    push: np.ndarray


def tell_powers(scheme: Scheme) -> bool:
    """Are they computed? Not where turns have charts, nor where drives take or give what their reactions tell."""
    return scheme.model.has("energy") and not scheme.charts.size and not moves_in_time(scheme.model)


def powers_at(times: np.ndarray, segments: list[SteppedModel]) -> np.ndarray:
    """(S, 4) power [W] and its rate [W/s] before and behind each of times (S,), rising [s]; NaN: not known."""
    found = np.full((len(times), 4), np.nan)
    for segment in segments:
        if not segment.changes:
            continue
        at = np.array([one.t for one in segment.changes])
        both, margin = _powers(segment), ONE_TIME * (1 + np.abs(times))  # changes are in the order of their times
        first, last = np.searchsorted(at, times - margin), np.searchsorted(at, times + margin, side="right") - 1
        follows = np.diff(times, prepend=-np.inf) <= margin
        for k in np.flatnonzero(first <= last):
            found[k] = *(both[last[k], 2:] if follows[k] else both[first[k], :2]), *both[last[k], 2:]
    return found


def _powers(segment: SteppedModel) -> np.ndarray:
    """(N, 4) of the changes of a segment."""
    scheme, model, changes = segment.plan.scheme, segment.model, segment.changes
    z, c = np.array([one.z for one in changes]), np.array([one.c for one in changes])
    observed = evaluate(scheme.observer, {"z": z}, c)
    n = model.signals.size
    constants = np.tile(segment.c[: model.c_size], (len(z), 1))
    if n:
        constants[:, -n:] = z[:, scheme.layout.slice("inputs")]
    function = model.derived("power and its rate", lambda: _power(model))
    beside = np.maximum(BESIDE * segment.plan.grid.dt_L, LEAST_BESIDE * (1 + np.abs(observed["t"])))
    sides = []
    for push, w, shift in (
        (0.0, None, -beside),
        (np.array([one.push for one in changes]), np.array([one.w for one in changes]), beside),
    ):
        if w is not None and n:
            constants = np.hstack([constants[:, :-n], w])
        at = {"q_i": observed["q_i"], "q_d": observed["q_d"], "q_i_dot": observed["q_i_dot"] + push, "t": observed["t"]}
        slopes = evaluate(function, at, constants)
        rates = {
            "q_i": at["q_i_dot"],
            "q_d": slopes["q_d_dot"],
            "q_i_dot": slopes["q_i_ddot"],
            "t": np.ones((len(z), 1)),
        }
        near = {name: value + shift.reshape(-1, 1) * rates[name].reshape(len(z), -1) for name, value in at.items()}
        P, rate = evaluate(function, near, constants)["power"].T
        sides.append(np.column_stack([P - shift.ravel() * rate, rate]))
    return np.hstack(sides)


def _power(model: EmittedModel) -> ca.Function:
    """(q_i, q_d, q_i_dot, t, c) -> power applied less dissipated, and its rate along the motion; q_d_dot, q_i_ddot."""
    n_i, n_d = len(model.q_i), len(model.q_d)
    q_i, q_d, v = ca.SX.sym("q_i", n_i), ca.SX.sym("q_d", n_d), ca.SX.sym("v", n_i)
    v_d, t, c = ca.SX.sym("v_d", n_d), ca.SX.sym("t"), ca.SX.sym("c", model.c_size)
    equations = StageEquations(model, c)
    motion = ClosedConfiguration(q_i, q_d, t, ca.SX(0), ca.SX(0, 1))
    a = equations.accelerations(motion, v)
    a_d = equations.dependent_accelerations(motion, v, a)
    found = model.evaluate("energy", q=joined(model, q_i, q_d), q_dot=joined(model, v, v_d), t=t, c=c)
    P = found["power_applied"] - found["power_dissipated"]
    rate = ca.jtimes(P, ca.vertcat(q_i, q_d, v, v_d, t), ca.vertcat(v, v_d, a, a_d, 1))
    rates = ca.SX(0, 1)
    if n_d:
        rates = model.evaluate("velocities", q_i=q_i, q_d=q_d, q_i_dot=v, t=t, c=c)["q_d_dot"]
    evaluated = [ca.vertcat(P, rate), rates, a]
    evaluated = [ca.densify(ca.substitute(one, v_d, rates) if n_d else one) for one in evaluated]
    return ca.Function(
        "power",
        [q_i, q_d, v, t, c],
        shared(evaluated),
        ["q_i", "q_d", "q_i_dot", "t", "c"],
        ["power", "q_d_dot", "q_i_ddot"],
    )
