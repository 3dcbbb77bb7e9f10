"""An overhung rotor: its Campbell diagram in fixed axes, and a run-up through the first critical speed."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from symgen import Scene

LENGTH, RADIUS, E = 0.5, 0.01, 2.1e11  # m, m, Pa
SECOND = np.pi * RADIUS**4 / 4  # m^4
MASS, POLAR, ACROSS = 12.0, 0.12, 0.06  # kg, kg m^2
TORQUE, OFF = 1.2, 1e-4  # N m, m of the centre of mass from the axis


def build(off=0.0):
    """A round shaft that stands still and bends both ways, a disk that spins on a hinge at its end."""
    scene = Scene("overhung_rotor", space="spatial", title="Overhung rotor")
    scene.beam("shaft", length=LENGTH, density=1.0, area=np.pi * RADIUS**2, youngs_modulus=E,
               second_moment=SECOND, second_moment_z=SECOND, damping_ratio=0.01,
               lateral={"modes": 2}, lateral_z={"modes": 2}, markers={"bearing": {"at": 1.0, "axis": [1.0, 0, 0]}})
    scene.rigid("disk", mass=MASS, inertia=[POLAR, ACROSS, ACROSS], center_of_mass=(0, off, 0),
                markers={"hub": {"axis": [1.0, 0, 0]}})
    scene.weld("wall", "ground.origin", "shaft.start").revolute("spin", "shaft.bearing", "disk.hub")
    scene.effort("motor", "spin.angle", TORQUE)
    return scene.measure("y", "y", of="shaft.bearing").measure("z", "z", of="shaft.bearing")


def by_hand(speed):
    """Forward and backward whirl: (k11 - m w^2)(k22 + Ip W w - Id w^2) = k12^2, of a light shaft."""
    k11, k12, k22 = 12 * E * SECOND / LENGTH**3, 6 * E * SECOND / LENGTH**2, 4 * E * SECOND / LENGTH
    return np.roots(np.polysub(np.polymul([-MASS, 0, k11], [-ACROSS, POLAR * speed, k22]), [k12**2])).real


def main(picture: Path | None = None) -> None:
    """Whirl frequencies are the roots of a quartic, and whirl is largest near the critical speed."""
    model, speeds = build().model(), np.linspace(0, 200, 21)
    diagram = model.campbell("spin.omega", speeds)
    lowest = np.sort(np.abs([by_hand(speed) for speed in speeds]), axis=1)
    whirl = np.sort(diagram.frequencies, axis=1)[:, 1:]
    print(f"whirl off the quartic by {np.abs(whirl[:, :2] / lowest[:, :2] - 1).max():.1e} of it")
    critical = max(speed for mode, speed in diagram.crossings())
    run = build(OFF).model().simulate(t_end=16.0, tolerance=1e-2, samples=8000)
    bent, speed = np.hypot(run["y"], run["z"]), run.rate("spin.angle")
    print(f"{run.status}, largest whirl at {speed[bent.argmax()]:.1f} rad/s, critical speed {critical:.1f} rad/s")
    print(f"largest whirl {1e3 * bent.max():.2f} mm, {bent.max() / OFF:.0f} times the eccentricity")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        left.plot(speeds, whirl[:, :2], "o-", ms=3)
        left.plot(speeds, speeds, "k--", lw=0.8, label="once a turn")
        left.set(xlabel="speed [rad/s]", ylabel="whirl [rad/s]", title="Campbell diagram", ylim=(0, 100))
        left.legend(frameon=False)
        right.plot(speed, 1e3 * bent, lw=0.6)
        right.axvline(critical, color="k", ls="--", lw=0.8)
        right.set(xlabel="speed [rad/s]", ylabel="whirl [mm]", title="run-up by a torque")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
