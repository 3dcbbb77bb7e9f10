"""The README's picture from what `symgen demo slider-crank --out DIR` left: a still of the animation, two coordinates.

python docs/images/make_picture.py DIR
"""

import sys
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from runtime import Solution, load_model
from runtime.views.film import film

TARGET = Path(__file__).with_name("slider_crank.png")
BODIES = {"crank": "#0b6fa4", "rod": "#d1495b", "slider": "#2e8b57"}


def still(ax, solution: Solution, time: float) -> None:
    """The mechanism at one time, and faintly a few instants before it."""
    shown = film(solution, frames=1001)
    last = int(np.argmin(np.abs(shown.t - time)))
    for k, alpha in ((last - 24, 0.2), (last - 12, 0.4), (last, 1.0)):
        for body, colour in BODIES.items():
            marker = "s" if body == "slider" else None
            line = next(line for line in shown.lines if line.name == body and line.kind in ("beam", "body"))
            ax.plot(*line.xy[k], color=colour, lw=3, marker=marker, ms=10, alpha=alpha)
    ax.plot(*shown.line("rod", "ghost").xy[last], color="0.6", lw=1.2, ls="--")
    ax.plot(0, 0, ls="", marker="^", ms=11, mfc="0.8", mec="0.35")
    ax.set_aspect("equal")
    ax.set(xlabel="x [m]", ylabel="y [m]", title=f"deformation x {shown.exaggeration:.0f}")


def main(folder: Path) -> None:
    """Draw and write slider_crank.png beside this script."""
    solution = Solution.load(folder / "solution.npz", load_model(folder / "model"))
    figure = Figure(figsize=(9.6, 3.6), dpi=100, layout="constrained")
    FigureCanvasAgg(figure)
    left, right = figure.subplots(1, 2, width_ratios=(3, 4))
    still(left, solution, 0.031)
    for name, colour in (("rod.q1", "#d1495b"), ("rod.q2", "#6a4c93")):
        right.plot(solution.t, 1e3 * solution[name], color=colour, lw=1.2, label=f"{name} (bending)")
    right.set(xlabel="time [s]", ylabel="deflection [mm]", title="flexible slider-crank at 150 rad/s")
    right.set_ylim(top=2.2)
    right.legend(frameon=False, ncols=2, loc="upper right")
    for ax in (left, right):
        ax.grid(True, color="0.92", lw=0.7)
        ax.spines[["top", "right"]].set_visible(False)
    figure.savefig(TARGET)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
