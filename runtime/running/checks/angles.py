"""Euler angles are followed by the steps: near their singular orientation two of them turn fast."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Status
from runtime.running.checks.check import Check
from runtime.schemes.turns import turn_of

MOST_TURN = 0.3  # rad in a step near the singular orientation


class Angles(Check):
    """`angles_too_fast`."""

    costly = False

    def after(self, z: np.ndarray) -> Status | None:
        """What did the angles of a body turn by in a step near their singular orientation, at most?"""
        turn = turn_of(self.subject.scheme, z)
        if not turn > MOST_TURN:
            return None
        return self.subject.stop(
            "angles_too_fast",
            f"Euler angles turned by {turn:.2g} rad in one step near their singular orientation",
            'Use orientation = "euler_parameters", a sequence that keeps away from it, or a smaller step.',
            z=z,
        )
