"""What a state z says by itself about how its steps went: one answer for runs, studies and references."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import StatusName
from runtime.schemes.scheme import Scheme


def verdict(scheme: Scheme, z: np.ndarray) -> StatusName | None:
    """Why steps that led to z (at least the scheme's part, flat) are worth nothing; None if z does not say so.

    `iteration_failed` where an update did not converge, whatever it left behind; `not_finite` for NaN or infinity.
    """
    if z[scheme.layout.slice("failures")][0] > 0:
        return "iteration_failed"
    return None if np.isfinite(z).all() else "not_finite"
