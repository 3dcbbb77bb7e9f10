"""Are the Euler angles of a body near the orientation where they fail? What a stopped run says about it."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping

NEAR = 0.2  # of cos or sin of the middle angle; a run stops some steps before the orientation itself


def singular_angles(scene_toml: str, coordinates: Mapping[str, float]) -> str | None:
    """Advice if a body of the scene is near the singular orientation of its Euler angles, else None.

    coordinates: name -> value of all coordinates. Three different axes fail where the middle angle is 90 degrees, the
    others where it is 0.
    """
    for body in tomllib.loads(scene_toml).get("bodies", []):
        axes, middle = str(body.get("orientation", "")), coordinates.get(f"{body.get('name')}.theta2")
        if len(axes) != 3 or middle is None:
            continue
        if abs(math.cos(middle) if len(set(axes)) == 3 else math.sin(middle)) < NEAR:
            return (
                f"The Euler angles {axes} of {body['name']} are near their singular orientation (theta2 = "
                f'{middle:.3g} rad): use orientation = "euler_parameters", or a sequence that keeps away from it.'
            )
    return None
