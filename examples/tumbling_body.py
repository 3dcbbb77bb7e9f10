"""A body that spins about its middle axis turns over, again and again: how often, against elliptic integrals."""

import sys
from math import sqrt
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from scipy.special import ellipk

from runtime import plots
from symgen.scenes import SCENES

A, B, C = 1.0, 2.0, 3.0  # kg m^2, principal moments of the built-in scene; it starts with (0.01, 1, 0.01) rad/s


def main(picture: Path | None = None) -> None:
    """Time between two turns, from the energy and the angular momentum (Landau and Lifshitz, Mechanics, 37)."""
    run = SCENES["tumbling_body"]().model().simulate(t_end=60.0, dt=0.02, scheme="rk4", seen_every=0.0)
    e0, e1, e2, e3 = (run[f"body.e{k}"] for k in range(4))
    r0, r1, r2, r3 = (run.rate(f"body.e{k}") for k in range(4))
    spin = 2 * np.array([e0 * r1 - e1 * r0 - e2 * r3 + e3 * r2, e0 * r2 - e2 * r0 + e1 * r3 - e3 * r1,
                         e0 * r3 - e3 * r0 - e1 * r2 + e2 * r1])  # in the axes of the body
    momentum = np.linalg.norm(np.diag([A, B, C]) @ spin, axis=0)
    twice, square = 2 * run.total_energy[0], momentum[0] ** 2
    first, second = (C - B) * (square - twice * A), (B - A) * (twice * C - square)
    k2 = min(first, second) / max(first, second)
    turn = 2 * ellipk(k2) * sqrt(A * B * C / max(first, second))
    at = np.flatnonzero(np.diff(np.sign(spin[1])))
    crossings = run.t[at] + 0.02 * spin[1, at] / (spin[1, at] - spin[1, at + 1])
    print(run.status)
    print(f"turns over every {np.diff(crossings).mean():.4f} s, elliptic integral {turn:.4f} s")
    print(f"momentum changes by {np.ptp(momentum) / momentum[0]:.1e}, energy by {np.ptp(run.total_energy) / twice:.1e}")
    if picture:
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        left, right = figure.subplots(1, 2, width_ratios=(3, 5))
        plots.snapshots(run, ax=left, instants=[9.0, 10.0, 11.0, 12.0])
        right.plot(run.t, spin.T, label=["smallest inertia", "middle", "largest"])
        right.set(xlabel="time [s]", ylabel="angular velocity [rad/s]", title="in the axes of the body")
        right.legend(frameon=False, ncols=3, loc="upper center", bbox_to_anchor=(0.5, -0.15))
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
