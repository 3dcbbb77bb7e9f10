"""A quick-return mechanism, driven at constant speed: the torque of its motor, and how much faster it comes back."""

import sys
from math import asin, pi
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import plots
from symgen import Scene

CRANK, PIVOT, INERTIA, SPEED = 0.10, 0.25, 0.2, 10.0  # m, m below the crank's axle, kg m^2, rad/s


def build():
    """The pin of a crank slides in the slot of a rocker that swings about a pivot below."""
    return (
        Scene("quick_return", title="Quick-return mechanism")
        .ground(markers={"pivot": {"position": (0, -PIVOT)}})
        .rigid("crank", mass=1.0, inertia=0.01, markers={"pin": {"position": (CRANK, 0)}})
        .rigid("rocker", mass=4.0, inertia=INERTIA, markers={"end": {"position": (0.5, 0)}})
        .revolute("axle", "ground.origin", "crank.origin").revolute("hinge", "ground.pivot", "rocker.origin")
        .point_on_line("slot", "rocker.origin", "crank.pin")
        .prescribed_angle("motor", "ground.origin", "crank.origin", motion=f"{SPEED} * t")
        .initial({"rocker.theta": 1.2})
        .simulation(t_end=2 * pi / SPEED, dt=2 * pi / SPEED / 400)
        .build()
    )


def main(picture: Path | None = None) -> None:
    """The torque is J w^2 g g', where g is the rate of the rocker per rate of the crank."""
    run = build().model().simulate()
    phi, square = run["crank.theta"], CRANK**2 + PIVOT**2 + 2 * CRANK * PIVOT * np.sin(run["crank.theta"])
    g = (CRANK**2 + CRANK * PIVOT * np.sin(phi)) / square
    slope = CRANK * PIVOT * np.cos(phi) * (PIVOT**2 - CRANK**2) / square**2
    torque = INERTIA * SPEED**2 * g * slope
    forward = np.mean(run.rate("rocker.theta") > 0)
    print(run.status)
    print(f"torque off the closed form by {np.abs(run.motor('motor') - torque).max():.1e} of {torque.max():.3f} N m")
    print(f"time ratio {forward / (1 - forward):.3f}, closed form "
          f"{(pi + 2 * asin(CRANK / PIVOT)) / (pi - 2 * asin(CRANK / PIVOT)):.3f}")
    if picture:
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        left, right = figure.subplots(1, 2, width_ratios=(3, 5))
        plots.snapshots(run, ax=left, instants=[0.02, 0.1, 0.2, 0.33, 0.45], traces=["rocker.end", "crank.pin"])
        right.plot(run.t, run.motor("motor"), label="motor torque [N m]")
        right.plot(run.t, run.rate("rocker.theta"), label="rate of the rocker [rad/s]")
        right.set(xlabel="time [s]", title="one turn of the crank")
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
