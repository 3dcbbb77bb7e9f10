"""The norm of an estimated local error: root mean square of (dq, h dv) relative to the amplitudes of the coordinates.

As that of Hairer, Norsett & Wanner, II.4, (4.11), but for what an error is measured by: they take the size of a
component at the ends of the step, which passes through zero; here it is the amplitude of the motion so far.

Velocities are weighted by h: without them what is delivered is many times what was asked. The amplitude of a
coordinate is half the range that it has been seen in, the end of the step in question included, so that the first
steps of a motion from rest are measured by how far they go; at least SMALL_MOTION_SHARE of the largest of its kind
and unit, and LEAST_SIZE; of an angle of a body at most MOST_TURN_RANGE.

References
----------
E. Hairer, S. P. Norsett, G. Wanner: Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, section II.4.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.model import EmittedModel

SMALL_MOTION_SHARE = 1e-3  # so that small vibrations, far below what moves, need not be resolved
MOST_TURN_RANGE = np.pi  # rad: what turns on and on is not measured by how far it has come
LEAST_SIZE = 1e-10  # m or rad: a motion that begins as a power of time is as large as its error for ever


def error_weights(model: EmittedModel, low: ca.SX, high: ca.SX) -> ca.SX:
    """(n_i) what squares of errors are multiplied by, of coordinates seen between low and high."""
    scale = amplitudes(model, (high - low) / 2)
    return 1 / (2 * len(model.q_i) * scale * scale)


def squared_error_norm(weight: ca.SX, dq: ca.SX, h_dv: ca.SX) -> ca.SX:
    """The square of the norm of errors dq and h dv (n_i each)."""
    return ca.dot(weight, dq * dq + h_dv * h_dv)


def amplitudes(model: EmittedModel, half_ranges: ca.SX) -> ca.SX:
    """(n_i) what errors are measured by."""
    entries = {entry.name: entry for entry in model.description.coordinates}
    of_bodies = {name: ("angle", "rad") for record in model.description.orientations for name in record.turns}
    kinds = [of_bodies.get(name) or (entries[name].kind, entries[name].unit) for name in model.q_i]
    turns = [kind[1] == "rad" and kind[0] != "modal" for kind in kinds]
    sizes = [ca.fmin(half_ranges[k], MOST_TURN_RANGE) if turns[k] else half_ranges[k] for k in range(len(kinds))]
    for own in model.places.turns:  # an orientation as a whole
        widest = ca.SX(0)
        for k in own:
            widest = ca.fmax(widest, sizes[k]) if k < len(sizes) else widest
        sizes = [widest if k in own else one for k, one in enumerate(sizes)]
    largest = {kind: ca.SX(LEAST_SIZE) for kind in kinds}
    for kind, one in zip(kinds, sizes, strict=True):
        largest[kind] = ca.fmax(largest[kind], one)
    return ca.vertcat(
        *(
            ca.fmax(ca.fmax(one, LEAST_SIZE), SMALL_MOTION_SHARE * largest[kind])
            for kind, one in zip(kinds, sizes, strict=True)
        )
    )
