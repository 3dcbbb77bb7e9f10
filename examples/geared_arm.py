"""A robot arm with gears and friction: its joints break away, slide to their goals, and stick where they arrive."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import plots
from symgen import Scene
from symgen.scene import s_curve

RATIO, ROTOR, G = {"shoulder": 100.0, "elbow": 80.0}, 2e-4, 9.81  # motor over joint; kg m^2; m/s^2
HOLDS = {"shoulder": 9.0, "elbow": 8.0}  # N m of friction at rest
UPPER, FORE, LENGTH, CENTRES = 6.0, 3.0, 0.5, (0.25, 0.2)  # kg, kg, m of the upper arm, m to the centres


def build(shoulder: str, elbow: str):
    """Two links; each joint has friction and a motor behind a gear, which gives the torque at the joint."""
    scene = Scene("geared_arm", title="Robot arm with gears and friction").gravity(0, -G)
    scene.rigid("upper", mass=UPPER, inertia=0.12, center_of_mass=(CENTRES[0], 0),
                markers={"elbow": {"position": (LENGTH, 0)}})
    scene.rigid("fore", mass=FORE, inertia=0.05, center_of_mass=(CENTRES[1], 0),
                markers={"tool": {"position": (0.45, 0)}})
    ends = {"shoulder": ("ground.origin", "upper.origin"), "elbow": ("upper.elbow", "fore.origin")}
    for joint, torque in (("shoulder", shoulder), ("elbow", elbow)):
        carrier, link = ends[joint]
        scene.rigid(f"{joint}_rotor", mass=0.1, inertia=ROTOR)
        scene.revolute(f"{joint}_shaft", carrier, f"{joint}_rotor.origin")
        scene.revolute(joint, carrier, link, friction={
            "coulomb": 0.6 * HOLDS[joint], "breakaway": HOLDS[joint], "stribeck_velocity": 0.05, "viscous": 2.0})
        scene.gear(f"{joint}_gear", f"{joint}_shaft.angle", f"{joint}.angle", RATIO[joint])
        scene.effort(f"{joint}_motor", f"{joint}_shaft.angle", f"({torque}) / {RATIO[joint]}")
    scene.measure("q1", "angle", "upper.origin").measure("q2", "angle", "fore.origin", relative_to="upper.origin")
    return scene.table("move", **s_curve(1.0, speed=1.0, acceleration=4.0, jerk=40.0))


def gravity(q1: float, q2: float) -> np.ndarray:
    """Torques of the weights about both joints, by hand, the elbow's rotor with them [N m]."""
    fore = FORE * CENTRES[1] * np.cos(q1 + q2)
    upper = (UPPER * CENTRES[0] + (FORE + 0.1) * LENGTH) * np.cos(q1)
    return G * np.array([upper + fore, fore])


def main(picture: Path | None = None) -> None:
    """A ramp breaks the shoulder away at its breakaway torque; a controller leaves errors that friction can hold."""
    weights = gravity(0.0, 0.0)
    ramp = build(f"{weights[0]} + 5 * t", f"{weights[1]}").model().simulate(t_end=2.0, samples=200)
    first = next(event for event in ramp.events if event.kind == "mode")
    print(f"breaks away at {5 * first.time:.6f} N m beyond the weights, given {HOLDS['shoulder']} N m")
    laws = "400 * (0.8 * table('move', t) - q1) - 40 * q1_dot", "200 * (-1.2 * table('move', t) - q2) - 20 * q2_dot"
    run = build(*laws).model().simulate(t_end=3.0, samples=600)
    q, wanted = np.array([run["q1"][-1], run["q2"][-1]]), np.array([0.8, -1.2])
    left = np.array([400.0, 200.0]) * (wanted - q) - gravity(*q)
    print(f"{run.status}; errors at rest {np.round(wanted - q, 4)} rad, rates {run['q1_dot'][-1]} {run['q2_dot'][-1]}")
    print(f"torques beyond the weights {np.round(left, 3)} N m; friction holds {list(HOLDS.values())} N m")
    if picture:
        left_ax, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(run, ax=left_ax, instants=run.t[:361:60], traces=["fore.tool"])
        for k, (joint, angle) in enumerate((("shoulder", "q1"), ("elbow", "q2"))):
            right.plot(run.t, run[angle], color=f"C{k}", label=f"{joint} [rad]")
            right.fill_between(run.t, -1.4, 1.0, where=run[f"{joint}.friction_mode"] == 0, color=f"C{k}", alpha=0.12)
        right.set(xlabel="time [s]", title="shaded: the joint sticks", ylim=(-1.4, 1.0))
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
