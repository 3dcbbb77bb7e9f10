"""Four-bar windows that lie flat on their way: ten singular positions passed, and the motion of a pendulum kept."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from scipy.integrate import quad

from runtime import load_model, plots, simulate
from symgen.scenes import generated_folder


def main(picture: Path | None = None) -> None:
    """All uprights turn alike, so 3 theta'' = -3.5 g cos(theta) in kg m^2; one turn takes an integral of its energy."""
    run = simulate(load_model(generated_folder("n_four_bar")), dt=2e-3, scheme="rk4", seen_every=0.0)
    energy = run.total_energy[0]
    period = quad(lambda angle: (2 / 3 * (energy - 3.5 * 9.81 * np.sin(angle))) ** -0.5, 0, 2 * np.pi)[0]
    angle = run["upright0.theta"]
    turn = np.interp(2 * np.pi, np.pi / 2 - angle, run.t)
    passed = [event for event in run.events if event.kind == "singular_position"]
    print(run.status)
    print(f"{len(passed)} singular positions passed")
    print(f"one turn takes {turn:.5f} s, the integral {period:.5f} s")
    print(f"largest energy error {np.abs(run.energy_balance()).max():.1e} J")
    if picture:
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        left, right = figure.subplots(1, 2, width_ratios=(4, 5))
        plots.snapshots(run, ax=left, instants=[0.0, 0.5, 0.8, 0.95, 1.05, 1.2], traces=["upright2.tip"])
        right.plot(run.t, np.degrees(angle))
        right.plot([event.time for event in passed], np.degrees(np.interp([e.time for e in passed], run.t, angle)), "o",
                   label="singular position passed")
        right.set(xlabel="time [s]", ylabel="angle of the uprights [deg]")
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
