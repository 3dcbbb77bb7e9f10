"""A satellite that wobbles as it spins: damping of its panels takes the wobble away, the angular momentum stays."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import plots
from symgen import Scene

SPIN, WOBBLE, HUB = 2.0, 0.6, np.array([4.0, 6.0, 9.0])  # rad/s, rad/s, kg m^2
REACH, ROOT, LINE = 2.0, 0.3, 1.0  # m, m, kg/m: length of a panel, where it is held, its mass per length


def build():
    """A hub on an air bearing, as satellites are tested: three massless hinges, and two panels that bend in z."""
    y, x = {"axis": (0, 1, 0)}, {"axis": (1, 0, 0)}
    builder = Scene("satellite", space="spatial", title="Spinning satellite with flexible panels")
    builder.rigid("ring", mass=1, inertia=[0, 0, 0], markers={"y": y})
    builder.rigid("fork", mass=1, inertia=[0, 0, 0], markers={"y": y, "x": x})
    builder.rigid("hub", mass=60.0, inertia=list(HUB), shape={"type": "box", "size": (0.6, 0.6, 0.8)}, markers={
        "x": x, "nose": {"position": (0, 0, 0.8)}, "left": {"position": (0, ROOT, 0), "x_axis": (0, 1, 0)},
        "right": {"position": (0, -ROOT, 0), "x_axis": (0, -1, 0)}})
    builder.revolute("yaw", "ground.origin", "ring.origin").revolute("pitch", "ring.y", "fork.y")
    builder.revolute("roll", "fork.x", "hub.x").rates({"yaw.angle": SPIN, "roll.angle": WOBBLE})
    for side in ("left", "right"):
        builder.beam(side, length=REACH, density=1e2, area=LINE / 1e2, second_moment=1.2e-5, second_moment_z=1e-10,
                     youngs_modulus=2e10, lateral_z={"ends": "clamped-free", "modes": 1}, damping_ratio=0.7,
                     stiffening=True)
        builder.weld(f"hold_{side}", f"hub.{side}", f"{side}.start")
    return builder.simulation(t_end=400.0, dt=0.05, scheme="rk4", seen_every=0.2).build()


def main(picture: Path | None = None) -> None:
    """Spin and direction at the end follow from the conservation of angular momentum."""
    run = build().model().simulate()
    panels = 2 * LINE * ((ROOT + REACH) ** 3 - ROOT**3) / 3  # kg m^2 about an axis across them
    along_x, along_z = (HUB[0] + panels) * WOBBLE, (HUB[2] + panels) * SPIN  # the angular momentum, in world axes
    one, two, three = (run[f"{hinge}.angle"] for hinge in ("yaw", "pitch", "roll"))
    nose_x = np.cos(one) * np.sin(two) * np.cos(three) + np.sin(one) * np.sin(three)  # the z-axis of the hub
    cosine = (along_x * nose_x + along_z * np.cos(two) * np.cos(three)) / np.hypot(along_x, along_z)
    tilt, least = np.degrees(np.arccos(cosine)), (along_x**2 + along_z**2) / 2 / (HUB[2] + panels)
    print(run.status)
    print(f"angle to the angular momentum {tilt[:20].max():.2f} deg at first, {tilt[-300:].max():.2f} deg at the end")
    print(f"energy {run.total_energy[0]:.3f} J at first, {run.total_energy[-1]:.3f} J at the end, least {least:.3f} J")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(run, ax=left, instants=[0.0, 0.5, 1.0], traces=["hub.nose"])
        right.plot(run.t, tilt, lw=0.4)
        right.set(xlabel="time [s]", ylabel="angle of the axis to the angular momentum [deg]")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
