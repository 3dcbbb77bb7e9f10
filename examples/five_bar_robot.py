"""A five-bar robot: two driven cranks carry a tool along a closed path; what torque do the motors need?"""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from scipy.interpolate import CubicSpline

from runtime import plots
from symgen import Scene

BASE, CRANK, ARM = 0.10, 0.20, 0.32  # m: half the distance of the motors, lengths of the links


def build():
    """Two cranks and two arms that meet in the tool; the plane is level, so gravity does no work."""
    builder = Scene("five_bar", title="Five-bar robot")
    builder.ground(markers={"left": {"position": (-BASE, 0)}, "right": {"position": (BASE, 0)}})
    for name, length, mass in (("crank1", CRANK, 0.4), ("arm1", ARM, 0.3), ("arm2", ARM, 0.3), ("crank2", CRANK, 0.4)):
        builder.rigid(name, mass=mass, inertia=mass * length**2 / 12, center_of_mass=(length / 2, 0),
                      markers={"tip": {"position": (length, 0)}})
    builder.rigid("tool", mass=0.5, inertia=1e-4)
    for k, side in ((1, "left"), (2, "right")):
        builder.revolute(f"shoulder{k}", f"ground.{side}", f"crank{k}.origin")
        builder.revolute(f"elbow{k}", f"crank{k}.tip", f"arm{k}.origin")
    builder.weld("grip", "arm1.tip", "tool.origin").revolute("tip", "arm2.tip", "tool.origin")
    builder.prescribed_angle("motor1", "ground.left", "crank1.origin", motion="2.2 + 0.4 * sin(2 * pi * t)")
    builder.prescribed_angle("motor2", "ground.right", "crank2.origin", motion="0.9 + 0.4 * cos(2 * pi * t)")
    builder.initial({"arm1.theta": 0.8, "arm2.theta": 2.2})
    return builder.simulation(t_end=1.0, dt=0.005).build()


def main(picture: Path | None = None) -> None:
    """The tool is where two circles intersect, and the motors' power is the rate of the energy."""
    run = build().model().simulate()
    elbows = [np.array([x + CRANK * np.cos(run[f"crank{k}.theta"]), CRANK * np.sin(run[f"crank{k}.theta"])])
              for k, x in ((1, -BASE), (2, BASE))]
    half = (elbows[1] - elbows[0]) / 2
    distance = np.linalg.norm(half, axis=0)
    tool = elbows[0] + half + np.sqrt(ARM**2 / distance**2 - 1) * np.array([-half[1], half[0]])
    power = sum(run.motor(f"motor{k}") * run.rate(f"crank{k}.theta") for k in (1, 2))
    change = CubicSpline(run.t, run.total_energy).derivative()(run.t)
    print(run.status)
    print(f"tool off the closed form by {np.abs(tool - [run['tool.x'], run['tool.y']]).max():.1e} m")
    print(f"power off the change of energy by {np.abs(power - change).max() / np.abs(power).max():.1e} of the largest")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(run, ax=left, instants=6, traces=["tool.origin"])
        right.plot(run.t, np.transpose([run.motor("motor1"), run.motor("motor2")]))
        right.set(xlabel="time [s]", ylabel="torque of the motors [N m]")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
