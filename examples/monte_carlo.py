"""Tolerances by Monte Carlo: how much does the deflection of a slider-crank's rod scatter, and what makes it scatter?

Two thousand cases at once: mass of the slider, speed and starting angle of the crank vary.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from scipy.stats import norm, qmc

from runtime.views.plots import ensemble_picture
from symgen.scenes import SCENES

NAMES = ("crank speed [rad/s]", "crank angle [rad]", "slider mass [kg]")
CENTRE, SPREAD = np.array([150.0, 0.0, 0.075552]), np.array([1.5, 0.01, 0.002])


def main(picture: Path | None = None, cases: int = 2000) -> None:
    """The scatter of the deflection, and the share of its variance that a linear fit gives to each cause."""
    model = SCENES["flexible_slider_crank_free"]().model()
    scatter = norm.ppf(qmc.LatinHypercube(3, rng=1).random(cases))
    points = CENTRE + SPREAD * scatter
    found = model.ensemble(
        parameters={"slider.mass": points[:, 2]},
        initial={"crank.theta_dot": points[:, 0], "crank.theta": points[:, 1]},
        scheme="exponential",
        dt=4e-5,
        t_end=0.01,
        reduce={"rod.q1": "peak"},
    )
    good = np.asarray(found["status"]) == "completed"
    peak = np.asarray(found["rod.q1_peak"])[good] * 1e3
    low, middle, high = np.percentile(peak, [2.5, 50, 97.5])
    print(f"{good.sum()} of {cases} cases reached the end")
    print(f"peak deflection {middle:.4f} mm, 95 % of the cases from {low:.4f} to {high:.4f} mm")
    slopes, *_ = np.linalg.lstsq(scatter[good] - scatter[good].mean(0), peak - peak.mean(), rcond=None)
    for name, share in zip(NAMES, slopes**2 / peak.var(), strict=True):
        print(f"{name}: {100 * share:.1f} of the variance in percent")
    if picture:
        varied = {name: points[good, k] for k, name in enumerate(NAMES)}
        ensemble_picture(model.title, varied, {"peak deflection [mm]": peak}, path=picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
