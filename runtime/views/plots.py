"""Pictures of a run: motion, deformation, forces, energy, snapshots, coordinates, constraints, phase plane, two runs.

Every function takes (solution, path or None) and returns the figure; with a path it also writes the file, whose ending
chooses the format (png, svg, pdf). Units get a prefix and angles degrees in pictures only: data stay in SI. No pyplot,
no global state: safe in threads and without a display. `ax`: draw into these axes, in their own colours.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from runtime.contract.coordinates import followed
from runtime.contract.errors import ArgumentError
from runtime.results.samples import Samples
from runtime.views import curves
from runtime.views.curves import Curves
from runtime.views.figure import finish, grid, legend, owner, panel, prefixed, title
from runtime.views.frequencies_picture import frequencies as frequencies
from runtime.views.section_picture import section_forces as section_forces
from runtime.views.snapshots import snapshots as snapshots
from runtime.views.stress_picture import stresses as stresses
from runtime.views.style import COLOURS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from runtime.results.solution import Solution

MAX_PANELS = 12
MOST_FORCES = 6  # joints in a panel, the largest first


def motion(solution: Solution, path: str | Path | None = None) -> Figure:
    """Angles [deg], travels and measures; Euler parameters and dependent copies only by name (`coordinates`)."""
    groups = curves.motion(solution) or curves.every_coordinate(solution)
    return _panels(solution, groups, path)


def deformation(solution: Solution, path: str | Path | None = None) -> Figure:
    """Modal coordinates of each flexible body (those above 1/1000 of the largest) and the largest deflections.

    Raises ArgumentError where nothing is flexible.
    """
    groups = curves.deformation(solution)
    if not groups:
        raise ArgumentError(f"nothing of {solution.model.name} is flexible, or nothing of it moves")
    return _panels(solution, groups, path)


def forces(solution: Solution, path: str | Path | None = None) -> Figure:
    """Forces |F| and moments of joints and loads, the six largest each, and of motors. Raises ArgumentError without."""
    groups = [group.largest(MOST_FORCES) for group in curves.forces(solution)]
    if not groups:
        raise ArgumentError(f"{solution.model.name} has no joints and no loads")
    return _panels(solution, groups, path)


def coordinates(
    solution: Solution,
    path: str | Path | None = None,
    names: Sequence[str] | None = None,
    ax: Axes | None = None,
) -> Figure:
    """Coordinates against time: all that move, or those named (measures and rates too), a panel for each unit and body.

    Raises ModelError for an unknown name, ArgumentError where `ax` is given for more than one unit.
    """
    groups = curves.every_coordinate(solution) if names is None else _named(solution, names)
    if ax is None:
        return _panels(solution, groups, path)
    if len({group.unit for group in groups}) > 1:
        raise ArgumentError("ax takes curves of one unit; give names of one unit")
    every = Curves("", groups[0].unit, [n for g in groups for n in g.names], np.concatenate([g.values for g in groups]))
    panel(ax, solution.t, every, own=False)
    return finish(owner(ax), path)


def energy_balance(solution: Solution, path: str | Path | None = None) -> Figure:
    """Energies against time, the total on top, and below what the balance total - initial - work leaves."""
    figure, (top, bottom) = grid(2, title(solution), columns=1, ratios=(2, 1))
    shown = curves.energy(solution)
    panel(top, solution.t, shown)
    factor, _ = prefixed(shown.values, "J")
    found = solution.balance
    if np.any(found.work):
        top.plot(
            solution.t,
            factor * (solution.total_energy[:1] + found.work),
            "0.5",
            lw=1.0,
            label="initial + work",
            zorder=1,
        )
    legend(top)
    top.set_xlabel("")
    part = found.largest / max(float(np.abs(shown.values).max()), 1e-300)
    told = "" if found.resolved else ", not resolved by the samples"
    name = f"balance error, at most {part:.1e} of the energy{told}"
    panel(bottom, solution.t, Curves(name, "J", [""], found.error[None]))
    bottom.axhline(0.0, color="0.6", lw=0.7)
    return finish(figure, path)


def constraint_error(solution: Solution, path: str | Path | None = None, ax: Axes | None = None) -> Figure:
    """Largest constraint violation max |C| [m, rad] against time, logarithmic."""
    figure: Figure
    if ax is None:
        figure, (ax,) = grid(1, title(solution))
    else:
        figure = owner(ax)
    positive = solution.constraint_error[solution.constraint_error > np.finfo(float).tiny]
    if positive.size:
        lowest = max(float(positive.min()), 1e-18)
        ax.semilogy(solution.t, np.maximum(solution.constraint_error, lowest), color=COLOURS[0], lw=1.2)
    else:
        ax.plot(solution.t, np.zeros_like(solution.t), color=COLOURS[0], lw=1.2)
    ax.set_title("constraint error", fontsize=9.5, loc="left", fontweight="bold")
    ax.set_ylabel("max |C| [m, rad]", fontsize=9)
    ax.set_xlabel("time [s]", fontsize=9)
    return finish(figure, path)


def phase(
    solution: Solution,
    path: str | Path | None = None,
    names: Sequence[str] | None = None,
    ax: Axes | None = None,
) -> Figure:
    """Rate against coordinate, one panel each (the independent ones by default, at most twelve).

    Raises ModelError for an unknown name, ArgumentError where `ax` is given for more than one name.
    """
    chosen = list(names) if names is not None else followed(solution.model)[0]
    if ax is not None and len(chosen) != 1:
        raise ArgumentError("ax takes one phase plane; give one name")
    figure: Figure
    if ax is None:
        figure, axes = grid(min(len(chosen), MAX_PANELS), title(solution, "phase planes"), shared=False)
    else:
        figure, axes = owner(ax), [ax]
    for own, name in zip(axes, chosen, strict=False):
        x, v, coordinate = solution[name], solution.rate(name), solution.model.coordinate(name)
        (factor, unit), (fast, _) = prefixed(x, coordinate.unit), prefixed(v, coordinate.unit)
        rate_unit = prefixed(v, coordinate.unit)[1] + "/s"
        own.plot(factor * x, fast * v, color=COLOURS[0], lw=0.9)
        own.plot(factor * x[:1], fast * v[:1], "o", color=COLOURS[2], ms=5, label="start")
        own.plot(factor * x[-1:], fast * v[-1:], "s", color=COLOURS[1], ms=5, label="end")
        own.set_title(name, fontsize=9.5, loc="left", fontweight="bold")
        own.set_xlabel(f"{name} [{unit}]", fontsize=9)
        own.set_ylabel(f"rate [{rate_unit}]", fontsize=9)
    if axes:
        legend(axes[0])
    return finish(figure, path)


def difference(
    first: Solution,
    second: Solution | Sequence[Solution],
    path: str | Path | None = None,
    names: Sequence[str] | None = None,
) -> Figure:
    """Runs over each other, and beside them the difference of each other run to the first, at the first run's times.

    second: one other run, or several. names: coordinates or measures that all have; by default the independent
    coordinates that they share, at most six. Raises ModelError for an unknown name, ArgumentError where the runs share
    no name or no time.
    """
    others = [second] if isinstance(second, Samples) else list(second)
    shared = [name for name in followed(first.model)[0] if all(name in run.model.coordinates for run in others)]
    chosen = list(names) if names is not None else shared
    t = first.t[[all(run.t[0] <= at <= run.t[-1] for run in others) for at in first.t]]
    if not others or not chosen or not len(t):
        raise ArgumentError("the runs share no " + ("time" if chosen else "independent coordinate; give names"))
    chosen = chosen[:MOST_FORCES]
    about = "   and   ".join([title(first), *(f"{run.scheme}, dt {run.dt:g} s" for run in others)])
    figure, axes = grid(2 * len(chosen), about)
    for k, name in enumerate(chosen):
        values = np.array([run.interpolate(t, name) for run in (first, *others)])
        unit, apart = _unit(first, name), values[1:] - values[0]
        labels = [f"{run.scheme} {run.dt:g}" for run in (first, *others)]
        panel(axes[2 * k], t, Curves(name, unit, labels, values))
        for line in axes[2 * k].lines[1:]:
            line.set_linestyle((0, (4, 2)))
        about = f"difference, at most {_written(np.abs(apart).max(), unit)}"
        panel(axes[2 * k + 1], t, Curves(about, unit, labels[1:] if len(others) > 1 else [""], apart))
    for ax in axes[:-2]:
        ax.set_xlabel("")
    return finish(figure, path)


def usual(solution: Solution, folder: Path) -> list[Path]:
    """Write what is looked at first as PNG: motion, deformation, forces, energy, those there are (OutputError)."""
    drawn: list[tuple[str, Callable[[Solution, Path], Figure]]] = [("motion", motion)]
    drawn += [("deformation", deformation)] if curves.deformation(solution) else []
    drawn += [("forces", forces)] if curves.forces(solution) else []
    drawn.append(("energy", energy_balance))
    paths = [folder / f"{name}.png" for name, _ in drawn]
    for path, (_, draw) in zip(paths, drawn, strict=True):
        draw(solution, path)
    return paths


def _panels(solution: Solution, groups: list[Curves], path: str | Path | None) -> Figure:
    shown, left_out = groups[:MAX_PANELS], len(groups) - MAX_PANELS
    figure, axes = grid(len(shown), title(solution))
    for k, (ax, group) in enumerate(zip(axes, shown, strict=True)):
        panel(ax, solution.t, group.merged())
        if k < len(shown) - 2:
            ax.set_xlabel("")
    if left_out > 0:
        figure.text(0.99, 0.005, f"{left_out} more groups not shown", ha="right", fontsize=8, color="0.4")
    return finish(figure, path)


def _named(solution: Solution, names: Sequence[str]) -> list[Curves]:
    """A panel for each unit, and for each body's modes."""
    found: dict[tuple[str, str], list[str]] = {}
    elastic = {entry.name: entry.owner for entry in solution.model.description.coordinates if entry.elastic}
    for name in names:
        solution[name]  # raises for a name that is not there
        found.setdefault((elastic.get(name, ""), _unit(solution, name)), []).append(name)
    return [
        Curves(body and f"{body}: modal coordinates", unit, own, np.array([solution[name] for name in own]))
        for (body, unit), own in found.items()
    ]


def _unit(solution: Solution, name: str) -> str:
    described = solution.model.description
    units = {entry.name: entry.unit for entry in described.measures}
    for derivative, suffix in enumerate(("", "_dot", "_ddot")):
        units |= {entry.name + suffix: entry.unit_of(derivative) for entry in described.coordinates}
    return units.get(name, "")


def _written(value: float, unit: str) -> str:
    factor, shown = prefixed(np.array([value]), unit)
    return f"{factor * value:.3g} {shown}"
