"""A linear structure without bodies, M x'' + D x' + K x = F(t), on the same steppers (Eqs. 3-14).

Four masses in a row; the last link is stiff, so its mass oscillates fast. The partition is data.
"""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import reference_solution
from symgen import Scene

STIFFNESS = np.array([40.0, 40.0, 40.0, 4000.0])  # N/m, from the wall outwards


def build():
    """Masses of 1 kg, the last 0.2 kg; a harmonic force on the second."""
    k = np.append(STIFFNESS, 0.0)
    K = np.diag(k[:-1] + k[1:]) - np.diag(k[1:-1], 1) - np.diag(k[1:-1], -1)
    return (
        Scene("masses_in_a_row", title="Four masses in a row")
        .parameter("force", 2.0, "N", "amplitude of the force")
        .structure(coordinates=["x1", "x2", "x3", "x4"], mass=np.diag([1.0, 1.0, 1.0, 0.2]), stiffness=K,
                   damping=0.002 * K, force=[0.0, "force * sin(3 * t)", 0.0, 0.0])
        .groups(slow=["x1", "x2"], fast=["x3", "x4"])
        .initial({"x4": 0.01})
        .simulation(t_end=5.0, dt=0.004, m=[4], scheme="printed")
        .build()
    )


def main(picture: Path | None = None) -> None:
    """Printed sub-cycling with linear (13) and constant-acceleration interpolation against DOP853."""
    model = build().model()
    exact = reference_solution(model, t_end=5.0).q[-1]
    print("interpolation          dt_L      error at t = 5 s [m]")
    for reading in ("chord_ahead", "chord", "constant_acceleration"):
        for dt in (0.004, 0.002):
            run = model.simulate(dt=dt, options={"slow_interpolation": reading})
            print(f"{reading:22} {dt:<9g} {np.abs(run.q[-1] - exact).max():.3e}   {run.status.name}")
    if picture:
        ax = (figure := Figure(figsize=(8, 3.5), layout="constrained", dpi=120)).subplots()
        ax.plot(run.t, 200 * (run["x4"] - run["x3"]), lw=0.8, label="200 (x4 - x3), the stiff link")
        ax.plot(run.t, run["x2"], label="x2, pushed")
        ax.set(xlabel="time [s]", ylabel="[m]", title="four masses in a row: steps of 2 ms and 0.5 ms")
        ax.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
