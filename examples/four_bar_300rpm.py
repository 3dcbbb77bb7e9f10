"""A four-bar driven at 300 rpm: the torque of its motor and the shaking force on its frame."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime.views import plots
from symgen import Scene

SPEED = 300 * 2 * np.pi / 60  # rad/s
BARS = {"crank": (0.1, 0.5), "coupler": (0.3, 1.2), "rocker": (0.25, 1.0)}  # m, kg: uniform rods
SPAN = 0.35  # m between the pivots


def build():
    """Three rods in a loop with the ground, the crank at constant speed."""
    scene = Scene("four_bar_300rpm", title="Four-bar at 300 rpm").ground(markers={"right": {"position": (SPAN, 0)}})
    for name, (length, mass) in BARS.items():
        scene.rigid(name, mass=mass, inertia=mass * length**2 / 12, center_of_mass=(length / 2, 0),
                    markers={"tip": {"position": (length, 0)}})
    scene.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "coupler.origin")
    scene.revolute("C", "coupler.tip", "rocker.tip").revolute("D", "ground.right", "rocker.origin")
    scene.prescribed_angle("motor", "ground.origin", "crank.origin", motion=f"{SPEED} * t")
    return scene.initial({"coupler.theta": 0.8, "rocker.theta": 1.6})


def slope(values):
    """By the angle, of values at even steps of one whole turn: by their Fourier series."""
    n = len(values)
    return np.fft.irfft(1j * np.arange(n // 2 + 1) * np.fft.rfft(values), n)


def by_hand(angle):
    """Angles of coupler and rocker from the triangle over the diagonal (Freudenstein), kinetic energy at SPEED."""
    (a, m), (b, n), (c, k) = BARS.values()
    x, y = SPAN - a * np.cos(angle), -a * np.sin(angle)
    d, phi = np.hypot(x, y), np.arctan2(y, x)
    coupler = phi + np.arccos((b**2 + d**2 - c**2) / (2 * b * d))
    rocker = phi + np.pi - np.arccos((c**2 + d**2 - b**2) / (2 * c * d))
    v, w = (SPEED * slope(np.unwrap(one)) for one in (coupler, rocker))
    middle = a**2 * SPEED**2 + a * b * SPEED * v * np.cos(angle - coupler) + (b * v / 2) ** 2
    return (m * a**2 * SPEED**2 / 3 + n * middle + n * b**2 * v**2 / 12 + k * c**2 * w**2 / 3) / 2


def main(picture: Path | None = None) -> None:
    """The motor's torque is dT/dphi of the loop by hand: at constant speed it does nothing else."""
    run = build().model().simulate(t_end=2 * np.pi / SPEED, samples=720)
    torque, angle = run.motor("motor"), SPEED * run.t
    hand = slope(by_hand(angle[:-1]))
    shake = -(run.joint_force("A") + run.joint_force("D"))[:, :2]
    print(f"{run.status}: torque from {torque.min():.3f} to {torque.max():.3f} N m")
    print(f"off by hand by {np.abs(torque[:-1] - hand).max():.1e} N m; mean {torque[:-1].mean():.1e} N m")
    print(f"shaking force at most {np.hypot(*shake.T).max():.1f} N")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(run, ax=left, instants=run.t[:-1:90])
        right.plot(np.degrees(angle), torque, label="motor [N m]")
        right.plot(np.degrees(angle), np.hypot(*shake.T) / 100, label="shaking force [100 N]")
        right.set(xlabel="crank [deg]", title="one turn at 300 rpm")
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
