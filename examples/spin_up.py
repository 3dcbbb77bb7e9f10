"""A beam brought to speed: with geometric stiffening it settles, without it bends away (Kane et al. 1987)."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import plots
from symgen.scenes import SCENES
from symgen.scenes.beams import spin_up_beam


def lag(run) -> np.ndarray:
    """Deflection of the tip across the undeformed beam [m]."""
    angle = run["beam.theta"]
    return np.cos(angle) * run["tip_y"] - np.sin(angle) * run["tip_x"]


def main(picture: Path | None = None) -> None:
    """The lag of the tip while the beam is brought to 6 rad/s in 15 s, and the vibration that is left."""
    stiffened = SCENES["spin_up_beam"]().model().simulate(dt=2e-3, seen_every=0.01)
    model = spin_up_beam(stiffening=False, modes=2).model()
    linear = model.simulate(dt=2e-3, seen_every=0.01)
    print(stiffened.status)
    left_over = np.abs(lag(stiffened)[stiffened.t > 15.0]).max()
    print(f"largest lag {lag(stiffened).min():.5f} m, afterwards {left_over:.3e} m")
    print(f"without stiffening: {linear.status.name} at {linear.status.time:.2f} s")
    if picture:
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        left, right = figure.subplots(1, 2, width_ratios=(3, 4))
        plots.snapshots(stiffened, ax=left, instants=np.linspace(0, 6.5, 8), exaggeration=1.0)
        right.plot(stiffened.t, lag(stiffened), label="with stiffening")
        right.plot(linear.t, lag(linear), "--", label="without: bends away")
        right.set(xlabel="time [s]", ylabel="lag of the tip [m]", ylim=(-4, 0.5))
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
