"""Modulus, damping and hub inertia of a turning beam from one noisy record of its tip, with confidence."""

import sys
from pathlib import Path

import numpy as np

from runtime import DifferentiableRun
from symgen import Scene

TRUTH = {"beam.youngs_modulus": 6.8952e10, "beam.damping_ratio": 0.02, "hub.inertia": 10.0}
GUESS = {"beam.youngs_modulus": 5.5e10, "beam.damping_ratio": 0.05, "hub.inertia": 14.0}
NOISE = 0.005  # m


def build():
    """The hub of case F2 with its 8 m beam: a torque turns it for two seconds, then it swings freely."""
    builder = Scene("hub_beam").rigid("hub", mass=1.0, inertia=10.0).beam(
        "beam", length=8.0, density=2766.7, area=7.2968e-5, second_moment=8.2189e-9, youngs_modulus=6.8952e10,
        damping_ratio=0.02, lateral={"ends": "clamped-free", "modes": 2}, stiffening=True)
    builder.revolute("pivot", "ground.origin", "hub.origin").weld("clamp", "hub.origin", "beam.start")
    builder.torque("motor", "hub.origin", "where(t < 2, 10 * sin(pi * t), 0)")
    builder.measure("tip_y", "y", of="beam.end")
    return builder.simulation(t_end=8.0, dt=0.01, scheme="rk4", seen_every=0.04).build()


def main(picture: Path | None = None, repetitions: int = 1, seed: int = 7) -> None:
    """How often the 95 % region holds the truth is counted over repeated measurements."""
    model = build().model()
    true = DifferentiableRun(model, ["tip_y"], list(TRUTH))
    path, noise, inside = true.values(TRUTH)[:, 0], np.random.default_rng(seed), 0
    for k in range(repetitions):
        data = {"t": true.t, "tip_y": path + noise.normal(0.0, NOISE, len(true.t))}
        found = model.fit(data, list(TRUTH), guess=GUESS, bounds={"beam.damping_ratio": (0.0, 0.3)})
        inside += found.contains(TRUTH)
        if k == 0:
            print(found)
            for name, value in TRUTH.items():
                low, high = found.interval(name)
                print(f"{name}: 95 % from {low:.5g} to {high:.5g}, truth {value:.5g}")
            print(f"noise {found.residuals['tip_y'].std():.4f} m of {NOISE} m")
            if picture:
                found.picture(picture)
    print(f"the truth lies in the 95 % region of {inside} of {repetitions} measurements")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
