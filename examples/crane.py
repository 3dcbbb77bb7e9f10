"""A crane moves a hanging load: accelerate for one whole period of the swing, and the load arrives at rest."""

import sys
from math import pi, sqrt
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import plots
from symgen import Scene

ROPE, GRAVITY, PUSH = 6.0, 9.81, 0.5  # m, m/s^2, m/s^2
PERIOD = 2 * pi * sqrt(ROPE / GRAVITY)
COAST = "T * t - T**2 / 2"  # after T seconds of unit acceleration
RAMP = f"where(t < T, t**2 / 2, where(t < B, {COAST}, where(t < B + T, {COAST} - (t - B)**2 / 2, T * B)))"


def build():
    """A trolley that accelerates for T seconds, brakes for T seconds from B on, and a load on a rope."""
    return (
        Scene("crane", title="Crane").gravity(0, -GRAVITY)
        .parameter("a", PUSH, "m/s^2", "acceleration").parameter("T", PERIOD, "s").parameter("B", 1.5 * PERIOD, "s")
        .rigid("trolley", mass=800.0, inertia=50.0)
        .rigid("load", mass=2000.0, inertia=0.0, center_of_mass=(0, -ROPE), markers={"hook": {"position": (0, -ROPE)}})
        .prismatic("bridge", "ground.origin", "trolley.origin").revolute("rope", "trolley.origin", "load.origin")
        .prescribed_displacement("drive", "ground.origin", "trolley.origin", motion=f"a * ({RAMP})")
        .simulation(t_end=5 * PERIOD, dt=5e-3, scheme="rk4")
        .build()
    )


def residual(run) -> float:
    """Amplitude of the swing [rad] after the trolley has stopped, from the energy of the load."""
    angle, rate = run["load.theta"], run.rate("load.theta")
    swing = np.arccos(np.cos(angle) - rate**2 * ROPE / GRAVITY / 2)
    return float(swing[run.t > 3 * PERIOD].max())


def main(picture: Path | None = None) -> None:
    """The same way twice: pushed for half a period, then for a whole one."""
    model = build().model()
    abrupt = model.simulate(parameters={"T": PERIOD / 2, "a": PUSH})
    shaped = model.simulate(parameters={"T": PERIOD, "a": PUSH / 2})
    print(shaped.status)
    print(f"swing left {np.degrees(residual(abrupt)):.3f} deg (small swings: {np.degrees(4 * PUSH / GRAVITY):.3f} deg)")
    print(f"swing left {np.degrees(residual(shaped)):.3f} deg when pushed for one period")
    if picture:
        figure = Figure(figsize=(10, 3.6), layout="constrained", dpi=120)
        for ax, run, name in zip(figure.subplots(1, 2), (abrupt, shaped), ("half a period", "one period"), strict=True):
            plots.snapshots(run, ax=ax, instants=np.linspace(0, 3.5 * PERIOD, 22))
            ax.set_title(f"pushed for {name}: {np.degrees(residual(run)):.2f} deg of swing left", loc="left")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
