"""Impulses of prescribed motions whose velocity jumps, where steps follow from a tolerance."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from runtime.contract.coordinates import independent_rates, whole
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.adaptive.event_ends import settled
from runtime.schemes.switching.breaks import ON_THE_GRID
from runtime.schemes.switching.impulse import Impulse, impulse_at
from runtime.schemes.switching.times import SwitchTime
from runtime.schemes.work import accounted


def give_impulse(
    scheme: AdaptiveSteps, z: np.ndarray, c: np.ndarray, jumps: Sequence[SwitchTime]
) -> dict[float, Impulse]:
    """Of the jump at the end of the last step of z (n_z,), in place: rates just after it; {} where none jumps.

    c (c_size,): the model's constants.
    """
    own, model, reached = scheme.layout.slice, scheme.model, scheme.reached(z)
    there = next((one for one in jumps if one.time == reached), None)
    if there is None:
        return {}
    constants = scheme.constants(c)
    shown = scheme.observer(z=scheme.at_end(z)[: scheme.layout.size], c=constants)
    parts = {name: np.asarray(value).ravel() for name, value in shown.items()}
    q = whole(model, parts["q_i"], parts["q_d"])
    q_dot = whole(model, parts["q_i_dot"], _rates_before(scheme, parts, c, there.before))
    found = impulse_at(model, c, q, q_dot, there.before, there.after)
    if found is None:
        return {}
    settled(scheme, z, constants)
    z[own("v_to")] = independent_rates(model, q, found.q_dot)
    if accounted(scheme):
        z[own("work_from")] += found.energy
    seen_at = float(z[own("t0")][0] + z[own("n")][0] * scheme.grid.dt_L)
    if abs(seen_at - reached) <= ON_THE_GRID * scheme.grid.dt_L:  # what is seen there is after the jump
        z[own("t0")] += max(0.0, there.after - seen_at)
        z[own("v")] = z[own("v_to")]
        if accounted(scheme):
            z[own("work")] = z[own("work_from")]
    return {there.time: found}


def _rates_before(scheme: AdaptiveSteps, parts: dict[str, np.ndarray], c: np.ndarray, before: float) -> np.ndarray:
    """(n_d,) rates of the dependent coordinates on the clock before a jump."""
    arguments = {name: parts[name] for name in ("q_i", "q_d", "q_i_dot")}
    return np.asarray(scheme.model.evaluate("velocities", **arguments, t=before, c=c)["q_d_dot"]).ravel()
