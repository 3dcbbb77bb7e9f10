"""Section forces along a beam: what every section has to bear, and the instant at which the beam bears most."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from runtime.results.section_forces import Which
from runtime.results.section_forces import section_forces as forces_along
from runtime.views.figure import finish, grid, legend, prefixed, title
from runtime.views.style import COLOURS

if TYPE_CHECKING:
    from runtime.results.solution import Solution

PARTS: dict[Which, tuple[str, str]] = {
    "normal": ("normal force", "N"),
    "shear": ("shear force along y", "N"),
    "shear_z": ("shear force along z", "N"),
    "torsion": ("torsion", "N m"),
    "moment_y": ("bending moment about y", "N m"),
    "moment": ("bending moment about z", "N m"),
}
NOTHING = 1e-9  # of the largest force or moment of the beam: what stays below is not drawn


def section_forces(solution: Solution, body: str, path: str | Path | None = None) -> Figure:
    """Normal and shear forces, torsion and bending moments along the beam `body`, those that there are.

    Grey: between the least and the largest value of each section over the run; the line is the instant at which the
    largest magnitude is met. Raises ModelError for a body whose section forces are not known, OutputError.
    """
    found = forces_along(solution, body)
    values = {name: np.nan_to_num(np.asarray(getattr(found, name))) for name in PARTS}
    sizes = {
        unit: max(float(np.abs(values[k]).max()) for k, part in PARTS.items() if part[1] == unit)
        for unit in ("N", "N m")
    }
    drawn = [k for k, (_, unit) in PARTS.items() if np.abs(values[k]).max() > NOTHING * max(sizes[unit], 1e-300)]
    figure, axes = grid(max(len(drawn), 1), title(solution, f"section forces of {body}"), shared=False)
    for k, (ax, name) in enumerate(zip(axes, drawn, strict=False)):
        what, own = PARTS[name]
        factor, unit = prefixed(values[name], own)
        largest = found.largest(name)
        sample = int(np.argmin(np.abs(found.t - largest.t)))
        low, high = factor * values[name].min(axis=0), factor * values[name].max(axis=0)
        ax.fill_between(found.at, low, high, color="0.85", lw=0, label="over the run")
        ax.plot(found.at, factor * values[name][sample], color=COLOURS[0], lw=1.4, label=f"t = {largest.t:.4g} s")
        ax.axhline(0.0, color="0.6", lw=0.7)
        ax.set_xlim(0.0, 1.0)
        about = f"{what}, at most {factor * abs(largest.value):.3g} {unit}"
        ax.set_title(about, fontsize=9.5, loc="left", fontweight="bold")
        ax.set_ylabel(f"[{unit}]", fontsize=9)
        ax.set_xlabel("" if k < len(drawn) - 2 else "part of the length", fontsize=9)
        legend(ax)
    return finish(figure, path)
