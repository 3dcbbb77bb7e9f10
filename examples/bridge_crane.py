"""A trolley with a hanging load runs along a girder that bends under it: an S-curve in, deflection and swing out."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime.views import plots
from symgen import Scene
from symgen.scene import s_curve

SPAN, EI, WEIGHT = 16.0, 2.1e11 * 4e-4, 200.0  # m, N m^2, kg/m of the girder
TROLLEY, LOAD, ROPE = 800.0, 3000.0, 5.0  # kg, kg, m
FROM, WAY = 2.0, 6.0  # m: from here to the middle


def build():
    """The girder on two hinges, the trolley slides on it, the drive moves it by a table of acceleration."""
    scene = Scene("bridge_crane", title="Bridge crane").gravity(0, -9.81)
    scene.ground(markers={"far": {"position": (SPAN, 0)}})
    scene.beam("girder", length=SPAN, density=7850.0, area=WEIGHT / 7850, second_moment=4e-4, youngs_modulus=2.1e11,
               lateral={"modes": 5, "ends": "pinned-pinned"}, damping_ratio=0.02)
    scene.rigid("trolley", mass=TROLLEY, inertia=100.0)
    scene.rigid("load", mass=LOAD, inertia=0.0, center_of_mass=(0, -ROPE), markers={"hook": {"position": (0, -ROPE)}})
    scene.revolute("near", "ground.origin", "girder.start").point_on_line("roller", "ground.far", "girder.end")
    scene.slides_on("wheels", "girder.start", "trolley.origin").revolute("rope", "trolley.origin", "load.origin")
    scene.prescribed_angle("upright", "ground.origin", "trolley.origin", motion="0")
    scene.table("move", **s_curve(WAY, speed=1.0, acceleration=0.5, jerk=1.0))
    scene.prescribed_displacement("drive", "ground.origin", "trolley.origin", motion=f"{FROM} + table('move', t)")
    return scene.initial({"trolley.x": FROM}).simulation(t_end=20.0, start="quasi_static")


def main(picture: Path | None = None) -> None:
    """With the trolley in the middle the girder sags by P L^3 / 48 E I + 5 w L^4 / 384 E I."""
    run = build().model().simulate(tolerance=1e-3, samples=1000)
    last, middle = run.t > 12.0, -run.deflections("girder", at=0.5).y[:, 0]
    sag = (middle[last].max() + middle[last].min()) / 2
    load = TROLLEY + LOAD
    hand = 9.81 * (load * SPAN**3 / 48 + 5 * WEIGHT * SPAN**4 / 384) / EI
    print(f"{run.status}; sag in the middle {1e3 * sag:.2f} mm, by hand {1e3 * hand:.2f} mm")
    print(f"load swings {np.degrees(np.abs(run['load.theta'][last]).max()):.2f} deg after the trolley has stopped")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(run, ax=left, instants=run.t[:401:50])
        right.plot(run.t, 1e3 * middle, label="sag [mm]")
        right.plot(run.t, np.degrees(run["load.theta"]), label="swing [deg]")
        right.plot(run.t, run["trolley.x"], label="trolley [m]")
        right.set(xlabel="time [s]", title="2 m to 8 m on a girder of 16 m")
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
