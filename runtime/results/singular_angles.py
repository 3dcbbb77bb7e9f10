"""Events of Euler angles that are read off near their singular orientation; the motion knows nothing of it."""

from __future__ import annotations

from runtime.contract.coordinates import euler_angles, parameter_columns
from runtime.contract.orientations import NEAR_GIMBAL_LOCK, angles, regularity
from runtime.contract.status import Event
from runtime.results.samples import Samples


def singular_angles(solution: Samples) -> list[Event]:
    """An event for each body that came so near in a saved sample, at the nearest one."""
    events, columns = [], parameter_columns(solution.model)
    for body, kind in euler_angles(solution.model).items():
        theta = angles(kind, solution.q[:, columns[body]])
        off = regularity(kind, theta)
        k = int(off.argmin())
        if off[k] < NEAR_GIMBAL_LOCK:
            text = (
                f"the Euler angles {kind} of {body} are near their singular orientation (theta2 = {theta[k, 1]:.4g} "
                "rad), where theta1, theta3 and the rates are not determined; the motion is not touched: read "
                f"{body}.e0 ... e3 and {body}.omega_x, _y, _z, or give the body another sequence"
            )
            events.append(Event(float(solution.t[k]), "angles_singular", text))
    return events
