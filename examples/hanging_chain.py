"""Where a chain between two hooks comes to rest: its equilibrium, against the catenary."""

import sys
from math import sinh
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from scipy.optimize import brentq

from symgen import Scene

LINKS, LENGTH, SPAN = 12, 1.5, 1.0  # m: of the whole chain, between the hooks


def build():
    """Rigid links on hinges, started as a round sag."""
    builder = Scene("hanging_chain", title="Chain between two hooks").gravity(0, -9.81)
    builder.ground(markers={"hook": {"position": (SPAN, 0)}})
    link, last = LENGTH / LINKS, "ground.origin"
    for k in range(LINKS):
        builder.rigid(f"link{k}", mass=0.1, inertia=0.1 * link**2 / 12, center_of_mass=(link / 2, 0),
                      markers={"end": {"position": (link, 0)}})
        builder.revolute(f"hinge{k}", last, f"link{k}.origin")
        last = f"link{k}.end"
    builder.initial({f"link{k}.theta": (k - (LINKS - 1) / 2) * 0.2 for k in range(LINKS)})
    return builder.revolute("hook", last, "ground.hook").build()


def main(picture: Path | None = None) -> None:
    """The catenary through the hooks is y = a cosh(x / a) with 2 a sinh(SPAN / 2 a) = LENGTH."""
    rest = build().model().equilibrium()
    x = np.array([rest[f"link{k}.x"] for k in range(LINKS)] + [SPAN])
    y = np.array([rest[f"link{k}.y"] for k in range(LINKS)] + [0.0])
    a = brentq(lambda a: 2 * a * sinh(SPAN / 2 / a) - LENGTH, 0.05, 10.0)
    catenary = a * np.cosh((x - SPAN / 2) / a) - a * np.cosh(SPAN / 2 / a)
    print(f"stable: {rest.stable}")
    print(f"sag {-y.min():.4f} m, catenary {-catenary.min():.4f} m")
    print(f"joints off the catenary by {np.abs(y - catenary).max():.4f} m at most")
    print(f"left and right alike to {np.abs(y - y[::-1]).max():.1e} m")
    if picture:
        figure = Figure(figsize=(7, 4), layout="constrained", dpi=120)
        ax = figure.subplots()
        at = np.linspace(0, SPAN, 200)
        ax.plot(at, a * np.cosh((at - SPAN / 2) / a) - a * np.cosh(SPAN / 2 / a), color="0.7", lw=5, label="catenary")
        ax.plot(x, y, "o-", label=f"{LINKS} links at rest")
        ax.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title="a chain at rest")
        ax.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
