"""A ball thrown with backspin bounces over a floor: it slides and grips, comes back, and rolls in the end."""

import sys
from math import log
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import plots
from symgen import Scene

RADIUS, DAMPING, GRAVITY = 0.1, 0.15, 9.81  # m, s/m, m/s^2
SPEED, SPIN, HEIGHT = 3.0, 60.0, 1.0  # m/s, rad/s, m


def build():
    """The floor pushes back by Hunt and Crossley's law, and rubs with a coefficient of 0.2."""
    floor = {"marker": "ball.origin", "radius": RADIUS, "plane": "ground.origin"}
    rim = {f"rim{k}": {"position": (RADIUS * np.cos(a), RADIUS * np.sin(a))} for k, a in enumerate((0.0, 2.1, 4.2))}
    return (
        Scene("bouncing_ball", title="Ball that bounces with backspin")
        .gravity(0, -GRAVITY)
        .rigid("ball", mass=1.0, inertia=0.4 * RADIUS**2, free=True, markers=rim)
        .load("contact", "floor", **floor, stiffness=5e6, damping=DAMPING, exponent=1.5, friction=0.2)
        .initial({"ball.y": HEIGHT})
        .rates({"ball.x": SPEED, "ball.theta": SPIN})
        .simulation(t_end=6.0, dt=5e-5, seen_every=2e-3, scheme="rk4")
        .build()
    )


def returned(v: float) -> float:
    """The speed behind a stop: v - ln(1 + D v) / D = -u - ln(1 - D u) / D."""
    low, high = 0.0, v
    for _ in range(60):
        u = (low + high) / 2
        rises = DAMPING * (v + u) > log(1 + DAMPING * v) - log(1 - DAMPING * u)
        low, high = (u, high) if rises else (low, u)
    return low


def main(picture: Path | None = None) -> None:
    """The first bounce is as high as Hunt and Crossley's law says, and the ball ends at the speed of rolling."""
    run = build().model().simulate()
    height = run["ball.y"] - RADIUS
    summit = np.flatnonzero(np.diff(np.sign(run["ball.y_dot"])) < 0)[1]
    fall = (2 * GRAVITY * (HEIGHT - RADIUS)) ** 0.5
    print(run.status)
    print(f"first bounce {height[summit]:.4f} m, closed form {returned(fall) ** 2 / (2 * GRAVITY):.4f} m")
    rolling = (SPEED - 0.4 * RADIUS * SPIN) / 1.4
    print(f"rolls in the end with {run['ball.x_dot'][-1]:.5f} m/s, by momentum {rolling:.5f} m/s")
    if picture:
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        ax = figure.subplots()
        plots.snapshots(run, ax=ax, instants=[0.0, 0.2, 0.4, 0.8, 1.2], traces=["ball.origin", "ball.rim0"])
        ax.set(title="path of the centre and of a point of the rim")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
