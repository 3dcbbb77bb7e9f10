"""A flap between two elastic end stops: steps end where it touches and leaves them, and an event stops the run."""

import sys
from math import pi, sqrt
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import plots
from symgen import Scene

INERTIA, STIFFNESS, REACH, SPEED, ENOUGH = 0.4, 2000.0, 0.6, 3.0, 8  # kg m^2, N m/rad, rad, rad/s, touches


def build():
    """Springs act beyond 0.6 rad; each touch is counted by an input, and the flap's last touch ends the run."""
    stops = {"lower": -REACH, "upper": REACH, "stiffness": STIFFNESS}
    touch = {"action": {"touches": "touches + 1"}}
    return (
        Scene("end_stops", title="Flap between end stops")
        .input("touches", 0.0)
        .rigid("flap", mass=2.0, inertia=INERTIA, markers={"tip": {"position": (0.5, 0)}})
        .revolute("hinge", "ground.origin", "flap.origin", limits=stops)
        .measure("angle", "coordinate", "flap.theta")
        .event("upper", f"angle - {REACH}", direction="rising", **touch)
        .event("lower", f"angle + {REACH}", direction="falling", **touch)
        .event("middle", "angle * step(touches - 7.5)", direction="rising", terminal=True)
        .rates({"flap.theta": SPEED})
        .simulation(t_end=20.0, dt=0.002, seen_every=0.0, scheme="rk4")
        .build()
    )


def main(picture: Path | None = None) -> None:
    """A whole swing takes 4 a / w + 2 pi sqrt(J / k), and the energy stays that of the start."""
    run = build().model().simulate()
    upper = [event.time for event in run.events if event.name == "upper"]
    period, closed_form = np.diff(upper).mean(), 4 * REACH / SPEED + 2 * pi * sqrt(INERTIA / STIFFNESS)
    print(run.status)
    print(f"touches {run['touches'][-1]:.0f}, asked for {ENOUGH}")
    print(f"time of a swing {period:.7f} s, closed form {closed_form:.7f} s")
    print(f"energy lost {1 - run.energy['kinetic'][-1] / run.energy['kinetic'][0]:.1e}")
    if picture:
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        left, right = figure.subplots(1, 2, width_ratios=(3, 5))
        plots.snapshots(run, ax=left, instants=[0.0, 0.08, 0.15, 0.22], traces=["flap.tip"])
        right.plot(run.t, run["flap.theta"], label="angle [rad]")
        times = [event.time for event in run.events]
        right.plot(times, np.interp(times, run.t, run["flap.theta"]), "o", label="events")
        for stop in (-REACH, REACH):
            right.axhline(stop, color="grey", linewidth=0.8, linestyle="--")
        right.set(xlabel="time [s]", title="touches, leaves, and the end of the run")
        right.legend(loc="center right")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
