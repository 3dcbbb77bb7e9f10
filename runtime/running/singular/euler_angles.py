"""Are the Euler angles of a body near the orientation where they fail? What a stopped run says about it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from runtime.contract.records import BodyRecord

NEAR = 0.2  # of cos or sin of the middle angle; a run stops some steps before the orientation itself


def singular_angles(bodies: Sequence[BodyRecord], coordinates: Mapping[str, float]) -> str | None:
    """Advice if one of the bodies is near the singular orientation of its Euler angles, else None.

    coordinates: name -> value of all coordinates. Three different axes fail where the middle angle is 90 degrees, the
    others where it is 0.
    """
    for body in bodies:
        if len(body.angles) != 3:
            continue
        middle, axes = coordinates[body.angles[1]], body.orientation
        if abs(math.cos(middle) if len(set(axes)) == 3 else math.sin(middle)) < NEAR:
            return (
                f"The Euler angles {axes} of {body.name} are near their singular orientation (theta2 = "
                f'{middle:.3g} rad): use orientation = "euler_parameters", or a sequence that keeps away from it.'
            )
    return None
