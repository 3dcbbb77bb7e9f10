"""A quarter car on a bump: a damper by a table, soft in compression and hard in rebound, and a tyre."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from scipy.integrate import solve_ivp

from symgen import Scene

BODY, WHEEL, SPRING, TYRE, REST = 320.0, 40.0, 20e3, 200e3, 0.5  # kg, kg, N/m, N/m, m
SUNK = (BODY + WHEEL) * 9.81 / TYRE  # m
SPEED, FORCE = [-1.0, -0.3, 0.0, 0.3, 1.0], [-900.0, -450.0, 0.0, 900.0, 2400.0]  # m/s apart, N
BUMP = "where(1 <= t < 1.2, 0.04 * (1 - cos(10 * pi * (t - 1))), 0)"  # m: 80 mm high, 0.2 s long


def build():
    """Body and wheel on a rail, the strut as a line of force by its length and rate, the tyre as a force."""
    rail = {"rail": {"angle": "pi / 2"}}
    scene = Scene("quarter_car", title="Quarter car").gravity(0, -9.81).ground(markers=rail)
    scene.rigid("body", mass=BODY, inertia=1.0, markers=rail).rigid("wheel", mass=WHEEL, inertia=1.0, markers=rail)
    scene.prismatic("guide", "ground.rail", "body.rail").prismatic("hub", "ground.rail", "wheel.rail")
    scene.table("damper", x=SPEED, y=FORCE, outside="hold")
    strut = f"{SPRING} * (length - {REST}) + table('damper', rate)"
    scene.line("strut", "wheel.origin", "body.origin", strut)
    scene.measure("height", "y", of="wheel.origin")
    scene.force("tyre", "wheel.origin", 0, f"{TYRE} * max(0, {BUMP} - height)")
    return scene.initial({"body.y": REST - BODY * 9.81 / SPRING - SUNK, "wheel.y": -SUNK})


def by_hand(t_end, times):
    """The same two equations by SciPy, with the table by NumPy's interp."""
    def slope(t, x):
        y, w, v, u = x
        road = 0.04 * (1 - np.cos(10 * np.pi * (t - 1))) if 1 <= t < 1.2 else 0.0
        pull = SPRING * (y - w - REST) + np.interp(v - u, SPEED, FORCE)
        return [v, u, -pull / BODY - 9.81, (pull + TYRE * max(0.0, road - w)) / WHEEL - 9.81]

    start = [REST - BODY * 9.81 / SPRING - SUNK, -SUNK, 0.0, 0.0]
    return solve_ivp(slope, (0, t_end), start, t_eval=times, rtol=1e-10, atol=1e-12, max_step=1e-3).y


def main(picture: Path | None = None) -> None:
    """The motion is that of two equations by hand; it prints how far the body rises and whether the tyre lifts."""
    run = build().model().simulate(t_end=3.0, tolerance=1e-5, samples=600)
    body, wheel = by_hand(3.0, run.t)[:2]
    off = max(np.abs(run["body.y"] - body).max(), np.abs(run["wheel.y"] - wheel).max())
    print(f"{run.status}, off the equations by hand by {off:.1e} m")
    press = run.load_force("tyre")[:, 1]
    print(f"body rises {1e3 * (body.max() - body[0]):.1f} mm; tyre between {press.min():.0f} and {press.max():.0f} N")
    if picture:
        left, right = (figure := Figure(figsize=(10, 3.8), layout="constrained", dpi=120)).subplots(1, 2)
        left.plot(run.t, 1e3 * (run["body.y"] - body[0]), label="body")
        left.plot(run.t, 1e3 * (run["wheel.y"] - wheel[0]), label="wheel")
        left.set(xlabel="time [s]", ylabel="[mm]", title="a bump of 80 mm, 0.2 s long", xlim=(0.8, 3))
        left.legend(frameon=False)
        right.plot(SPEED, FORCE, "o-")
        right.set(xlabel="rate of the strut [m/s]", ylabel="damper [N]", title="damper, by a table")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
