"""What a beam's shapes leave out of the static answer to the loads that its ends carry.

Moments M_0, M_L at the two ends, held in balance by transverse forces there, bend a beam of length L by
M(x) = -M_0 (1 - x/L) + M_L x/L. Their work is the same in every frame of the body, so shapes of any frame can be
judged: they give the bending energy f^T (B^T K^-1 B) f / 2 where f^T F f / 2 is exact,
F = (L / 6 EI) [[2, -1], [-1, 2]].
"""

from __future__ import annotations

import numpy as np
from scipy.linalg import eigh

from symgen.bodies.beam_sets import mode_sets
from symgen.modes import BeamModes
from symgen.scene import BeamBody, SceneRecord, lateral_ends
from symgen.scene.attachments import StaticResidual

EXACT = np.array([[2.0, -1.0], [-1.0, 2.0]]) / 6.0  # for L = EI = 1
LOADED = {"welded-welded": [0, 1], "welded-pinned": [0], "pinned-welded": [1]}  # which of M_0, M_L the ends carry
WORTH_A_WORD = 1e-3


def static_residuals(scene: SceneRecord) -> list[StaticResidual]:
    """Of all beams of a scene whose `ends` are filled in: those that miss more than 0.1 %."""
    found = []
    for body in scene.moving_bodies:
        if not isinstance(body, BeamBody):
            continue
        for plane, axis in (("lateral", 1), ("lateral_z", 2)):
            modes = next((one for own, one in mode_sets(body) if own == axis), None)
            asked = lateral_ends(scene, body, plane)
            if isinstance(modes, BeamModes) and asked in LOADED:
                share = missing_share(modes, LOADED[asked])
                if share > WORTH_A_WORD:
                    found.append(StaticResidual(body.name, plane, modes.ends, modes.modes, asked, share))
    return found


def missing_share(modes: BeamModes, moments: list[int]) -> float:
    """Part of the exact bending energy that the shapes miss, for the worst end moments of those in `moments`."""
    start, end = modes.interpolate(0.0), modes.interpolate(1.0)
    balance = start.phi - end.phi
    B = np.stack([start.slope + balance, end.slope + balance], axis=1)[:, moments]
    modal = B.T @ (B / np.diag(modes.kappa)[:, None])
    kept = eigh(modal, EXACT[np.ix_(moments, moments)], eigvals_only=True)
    return float(1.0 - kept[0])
