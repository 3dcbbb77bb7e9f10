"""A gyroscope: let go it nods as it goes round; with the right push it goes round evenly, at a rate in closed form."""

import sys
from math import cos, pi, sqrt
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import plots
from symgen import Scene

MASS, ARM, RADIUS, SPIN, TILT, GRAVITY = 0.5, 0.15, 0.08, 100.0, pi / 3, 9.81  # kg, m, m, rad/s, rad, m/s^2
AXIAL, ACROSS = MASS * RADIUS**2 / 2, MASS * (RADIUS**2 / 4 + ARM**2)  # kg m^2 about the axis, about the foot


def build():
    """A disk on a massless arm, free to turn about the foot; Euler angles: precession, nutation, spin."""
    builder = Scene("gyroscope", space="spatial", title="Gyroscope").gravity(0, 0, -GRAVITY)
    builder.rigid("disk", mass=MASS, inertia=[MASS * RADIUS**2 / 4, MASS * RADIUS**2 / 4, AXIAL],
                  center_of_mass=(0, 0, ARM), orientation="zxz", markers={"hub": {"position": (0, 0, ARM)}}, shape=[
                      {"type": "cylinder", "radius": RADIUS, "length": 0.01, "position": (0, 0, ARM)},
                      {"type": "cylinder", "radius": 0.003, "length": ARM, "position": (0, 0, ARM / 2)}])
    builder.spherical("foot", "ground.origin", "disk.origin")
    builder.initial({"disk.theta2": TILT}).rates({"disk.theta3": SPIN})
    return builder.simulation(t_end=1.5, dt=2.5e-4, scheme="rk4", seen_every=0.001).build()


def main(picture: Path | None = None) -> None:
    """Even precession W solves A' W^2 cos(tilt) - C s W + m g l = 0, where s is the spin about the axis."""
    model = build().model()
    square = (AXIAL * SPIN) ** 2 - 4 * ACROSS * cos(TILT) * MASS * GRAVITY * ARM
    even = (AXIAL * SPIN - sqrt(square)) / (2 * ACROSS * cos(TILT))
    free = model.simulate()
    pushed = model.simulate(initial={"disk.theta1_dot": even, "disk.theta3_dot": SPIN - even * cos(TILT)})
    print(pushed.status)
    round_ = np.unwrap(pushed["disk.theta1"])  # angles are read off between -pi and pi
    print(f"goes round at {round_[-1] / pushed.t[-1]:.6f} rad/s, closed form {even:.6f} rad/s")
    print(f"nods by {np.degrees(np.ptp(pushed['disk.theta2'])):.1e} deg, let go by "
          f"{np.degrees(np.ptp(free['disk.theta2'])):.3f} deg")
    top = AXIAL * SPIN / MASS / GRAVITY / ARM * AXIAL * SPIN / ACROSS / 4  # lowest point of a top let go, closed form
    print(f"lowest tilt {np.degrees(free['disk.theta2'].max()):.4f} deg, closed form "
          f"{np.degrees(np.arccos(top - sqrt(top**2 - 2 * top * cos(TILT) + 1))):.4f} deg")
    if picture:
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        for ax, run, what in zip(figure.subplots(1, 2), (free, pushed), ("let go", "pushed"), strict=True):
            plots.snapshots(run, ax=ax, instants=[0.0, 0.3, 0.6], traces=["disk.hub"])
            ax.set_title(f"{what}: three instants and the path of the hub", loc="left")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
