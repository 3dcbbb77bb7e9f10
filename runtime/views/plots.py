"""Pictures of a run: motion, deformation, forces, energy, snapshots, coordinates, two runs.

Every function takes (solution, path or None) and returns the figure; with a path it also writes the file, whose
ending chooses the format (png, svg, pdf). Units get a prefix and angles degrees in pictures only: data stay in SI.
No pyplot, no global state: safe in threads and without a display. `ax`: draw into these axes, in their own colours.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import BoundaryNorm, ListedColormap, to_rgba
from matplotlib.figure import Figure

from runtime.contract.arguments import NAMES, PLACE, Kind, require
from runtime.contract.coordinates import followed
from runtime.contract.errors import ArgumentError, ModelError
from runtime.operating.campbell import Campbell
from runtime.operating.frequencies_along import frequencies_along
from runtime.results.samples import Samples
from runtime.results.section_forces import Which
from runtime.results.section_forces import section_forces as forces_along
from runtime.results.stresses import stresses as stresses_at
from runtime.schemes.catalogue import SCHEMES
from runtime.views import curves
from runtime.views.animation import snapshots as snapshots
from runtime.views.curves import COLOURS, SPECIALS, Curves
from runtime.views.figure import WIDTH, NotebookFigure, finish, grid, legend, literal, owner, panel, prefixed, title
from runtime.views.method_styles import Method, MethodOfRun, method_styles

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from runtime.solutions.solution import Solution


MAX_PANELS = 12
MOST_FORCES = 6  # joints in a panel, the largest first


def motion(solution: Solution, path: str | Path | None = None) -> Figure:
    """Angles [deg], travels and measures; Euler parameters and dependent copies only by name (`coordinates`)."""
    groups = curves.motion(solution) or curves.every_motion(solution)
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
    """Forces |F| and moments of joints and loads, the six largest each, and of motors. Raises ArgumentError
    without.
    """
    groups = [group.largest(MOST_FORCES) for group in curves.forces(solution)]
    if not groups:
        raise ArgumentError(f"{solution.model.name} has no joints and no loads")
    return _panels(solution, groups, path)


SHOWN = Kind(lambda value: isinstance(value, str) or NAMES.holds(value), 'give a list of names, such as ["rod.theta"]')


def coordinates(
    solution: Solution,
    path: str | Path | None = None,
    names: str | Sequence[str] | None = None,
    ax: Axes | None = None,
) -> Figure:
    """Plot coordinates and measures against time, a panel for each unit and body.

    Parameters
    ----------
    solution : Solution
        N samples.
    path : str or Path, optional
        Where the picture is written.
    names : str or sequence of str, optional
        Coordinates, rates and measures; all that move if left out.
    ax : Axes, optional
        Where it is drawn, for names of one unit.

    Returns
    -------
    Figure
        Of Matplotlib.

    Raises
    ------
    ModelError
        For an unknown name.
    ArgumentError
        Where `ax` is given for more than one unit.
    """
    require(SHOWN, or_none=True, names=names)
    require(PLACE, or_none=True, path=path)
    chosen = [names] if isinstance(names, str) else names
    groups = curves.every_motion(solution) if chosen is None else _named(solution, chosen)
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
    remark = "" if found.resolved else ", too few samples to check"
    name = f"balance error, at most {part:.1e} of the energy{remark}"
    panel(bottom, solution.t, Curves(name, "J", [""], found.error[None]))
    bottom.axhline(0.0, color="0.6", lw=0.7)
    return finish(figure, path)


def difference(
    first: Solution,
    second: Solution | Sequence[Solution],
    path: str | Path | None = None,
    names: Sequence[str] | None = None,
) -> Figure:
    """Runs over each other, and beside them the difference of each other run to the first, at the first run's times.

    second: one other run, or several. names: coordinates or measures that all have; by default the independent
    coordinates that they share, at most six. Raises ModelError for an unknown name, ArgumentError where the runs
    share no name or no time.
    """
    others = [second] if isinstance(second, Samples) else list(second)
    shared = [name for name in followed(first.model)[0] if all(name in run.model.coordinates for run in others)]
    chosen = list(names) if names is not None else shared
    t = first.t[[all(run.t[0] <= at <= run.t[-1] for run in others) for at in first.t]]
    if not others or not chosen or not len(t):
        raise ArgumentError("the runs share no " + ("time" if chosen else "independent coordinate; give names"))
    chosen = chosen[:MOST_FORCES]
    colours = _run_colours([first, *others])
    about = "   and   ".join([title(first), *(f"{run.scheme}, {run.step}" for run in others)])
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
        for line, colour in zip([*axes[2 * k].lines, *axes[2 * k + 1].lines], [*colours, *colours[1:]], strict=False):
            line.set_color(colour)
        if len(others) > 1:
            legend(axes[2 * k + 1])
        legend(axes[2 * k])
    for ax in axes[:-2]:
        ax.set_xlabel("")
    return finish(figure, path)


def _run_colours(runs: Sequence[Solution]) -> list[str]:
    """Those of their methods, where each run has another one."""
    methods = [MethodOfRun(run.scheme, tuple(run.m) or None) for run in runs if run.scheme in SCHEMES]
    styles = method_styles(methods)
    if len(styles) == len(runs):
        return [str(styles[method.label]["color"]) for method in methods]
    return [COLOURS[k % len(COLOURS)] for k in range(len(runs))]


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


# ---- The picture of the frequencies along a motion.

LOWEST = 1e-6  # of the largest frequency: what is slower does not show on the logarithmic axis
FAINTEST = 0.25  # of a mode that is damped critically or more


def frequencies(
    solution: Solution, path: str | Path | None = None, samples: int = 60, ax: Axes | None = None
) -> Figure:
    """Frequencies |lambda| of the linearised equations over time, fainter the more a mode is damped.

    The right axis is the step at which central differences become unstable for an undamped mode, h = 2 / w. Raises
    ModelError where the model lacks its Jacobians, OutputError.
    """
    found = frequencies_along(solution, samples)
    figure: Figure
    if ax is None:
        figure, (own,) = grid(1, title(solution, "frequencies along the motion"))
    else:
        figure, own = owner(ax), ax
    lowest = LOWEST * max(float(found.frequencies.max(initial=0.0)), 1e-300)
    shown = np.maximum(found.frequencies, lowest)
    for k, name in enumerate(found.names):
        points = np.column_stack([found.t, shown[:, k]])
        colour = np.tile(to_rgba(COLOURS[k % len(COLOURS)]), (len(points) - 1, 1))
        colour[:, 3] = 1.0 - (1.0 - FAINTEST) * np.clip(np.abs(found.damping_ratios[:-1, k]), 0.0, 1.0)
        strokes = list(np.stack([points[:-1], points[1:]], axis=1))
        own.add_collection(LineCollection(strokes, colors=list(map(tuple, colour)), linewidths=1.6))
        own.plot([], [], color=COLOURS[k % len(COLOURS)], lw=1.6, label=name)
    own.set_yscale("log")
    own.set_ylim(0.5 * float(np.min(shown[shown > lowest], initial=shown.max())), 2.0 * float(shown.max()))
    own.set_xlim(found.t[0], found.t[-1])
    own.set_xlabel("time [s]", fontsize=9)
    own.set_ylabel("frequency [rad/s]", fontsize=9)
    limit = own.secondary_yaxis("right", functions=(_step_limit, _step_limit))
    limit.set_ylabel("largest step of central differences [s]", fontsize=8)
    limit.tick_params(labelsize=8)
    legend(own)
    if own.get_legend() is not None:
        own.get_legend().set_bbox_to_anchor((1.2, 0.5))  # beyond the right axis and its words
    return finish(figure, path)


def _step_limit(w: np.ndarray) -> np.ndarray:
    """h = 2 / w, which is its own inverse."""
    return np.asarray(2.0 / np.maximum(np.asarray(w, dtype=float), 1e-300))


# ---- Section forces along a beam: what every section has to bear, and the instant at which the beam bears most.

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
        ax.set_ylabel(literal(f"[{unit}]"), fontsize=9)
        ax.set_xlabel("" if k < len(drawn) - 2 else "part of the length", fontsize=9)
        legend(ax)
    return finish(figure, path)


# ---- Von Mises stress at the gauges of a finite-element body over time, by equilibrium and as the sum of modes.

MOST_GAUGES = 8


def stresses(solution: Solution, body: str, path: str | Path | None = None) -> Figure:
    """The gauges of `body` that bear most, the most loaded first; dashed: what the modes say.

    Raises ModelError for a body without gauges, OutputError.
    """
    modal = stresses_at(solution, body, way="modes")
    try:
        found, ways = stresses_at(solution, body), [("-", "equilibrium"), ("--", "modes")]
    except ModelError:  # gauges that know modal stresses only
        found, ways = modal, [("--", "modes")]
    shown = np.argsort(-found.von_mises.max(axis=0))[:MOST_GAUGES]
    figure, (ax,) = grid(1, title(solution, f"von Mises stress of {body}"))
    factor, unit = prefixed(found.von_mises[:, shown], "Pa")
    for k, gauge in enumerate(shown):
        for style, way in ways:
            values = (found if way == "equilibrium" else modal).von_mises[:, gauge]
            name = f"{found.gauges[gauge]}, {way}"
            ax.plot(found.t, factor * values, style, color=COLOURS[k % len(COLOURS)], lw=1.2, label=name)
    largest = found.largest()
    about = f"at most {factor * largest.value:.3g} {unit}, {largest.gauge} at {largest.t:.4g} s"
    if np.isfinite(largest.mesh_error):
        about += f"; mesh: +-{factor * largest.mesh_error:.2g} {unit}"
    ax.set_title(about, fontsize=9.5, loc="left", fontweight="bold")
    ax.set_ylabel(literal(f"[{unit}]"), fontsize=9)
    ax.set_xlabel("t [s]", fontsize=9)
    legend(ax)
    return finish(figure, path)


# ---- The picture of a Campbell diagram.

MOST_NAMED = 12  # modes in the legend


HIGHEST = 5.0  # times the largest speed: slower modes are drawn


def campbell_picture(found: Campbell, path: str | Path | None = None) -> Figure:
    """Frequencies of the followed modes over the speed or parameter; with a path it also writes the file.

    Along a speed, frequency = speed is drawn too. Raises OutputError if the file cannot be written.
    """
    figure, (ax,) = grid(1, found.model.title or found.model.name)
    for k, name in enumerate(found.names):
        label = f"{k + 1} {name}" if k < MOST_NAMED else None
        ax.plot(found.values, found.frequencies[:, k], color=COLOURS[k % len(COLOURS)], label=label)
    if found.is_speed:
        ax.plot(found.values, abs(found.values), color="0.4", lw=0.9, ls="--", label="frequency = speed")
        _keep_to_speeds(ax, found)
    ax.set_xlabel(f"{found.over} [rad/s]" if found.is_speed else found.over)
    ax.set_ylabel("frequency [rad/s]")
    ax.set_ylim(bottom=0.0)
    legend(ax)
    return finish(figure, path)


def _keep_to_speeds(ax: Axes, found: Campbell) -> None:
    """Leave modes out of the picture that are far above all speeds: they would press the line of the speed flat."""
    shown = np.nan_to_num(found.frequencies)  # a mode that is not there has none
    fastest, lowest = float(np.abs(found.values).max()), shown.min(axis=0)
    near = lowest <= max(HIGHEST * fastest, float(lowest.min(initial=np.inf)))
    if near.all():
        return
    ax.set_ylim(top=1.05 * max(fastest, float(shown[:, near].max(initial=0.0))))
    above = np.count_nonzero(~near)
    words = f"{above} mode{'s' if above > 1 else ''} above, up to {shown.max():.3g} rad/s"
    ax.text(0.99, 0.985, words, transform=ax.transAxes, ha="right", va="top", fontsize=8, color="0.4")


# ---- The picture of an ensemble: values of whole runs over what was varied, or the bundle of all histories.

MOST_PANELS, MOST_CURVES = 8, 100
BAND = (5, 50, 95)  # percent


def ensemble_picture(
    title: str,
    varied: Mapping[str, np.ndarray],
    values: Mapping[str, np.ndarray],
    time: np.ndarray | None = None,
    path: str | Path | None = None,
) -> Figure:
    """Panels of the first values (cases,), or (cases, times) over `time`; with a path it also writes the file.

    varied: parameters and initial values by name (cases,). The second of them is the colour. Raises OutputError.
    """
    shown = dict(list(values.items())[:MOST_PANELS])
    figure, axes = grid(len(shown), title, shared=time is not None)
    for ax, (name, found) in zip(axes, shown.items(), strict=True):
        if time is not None:
            _bundle(ax, time, found)
        else:
            _over(figure, ax, varied, found)
        ax.set_ylabel(name)
    for ax in axes[-2:]:
        ax.set_xlabel("time [s]" if time is not None else next(iter(varied)))
    return finish(figure, path)


def _bundle(ax: Axes, time: np.ndarray, found: np.ndarray) -> None:
    """Some histories, and between which values most of them are."""
    chosen = np.unique(np.linspace(0, len(found) - 1, MOST_CURVES).astype(int))
    ax.plot(time, found[chosen].T, color="0.75", lw=0.4)
    good = found[np.isfinite(found).all(axis=1)]
    if len(good):
        low, middle, high = np.percentile(good, BAND, axis=0)
        ax.fill_between(time, low, high, color=COLOURS[0], alpha=0.25, lw=0)
        ax.plot(time, middle, color=COLOURS[0], lw=1.2)


def _over(figure: NotebookFigure, ax: Axes, varied: Mapping[str, np.ndarray], found: np.ndarray) -> None:
    """Points over the first of what was varied, a line where nothing else was."""
    names: Sequence[str] = list(varied)
    if len(names) == 1:
        order = np.argsort(varied[names[0]])
        ax.plot(varied[names[0]][order], found[order], color=COLOURS[0], marker=".", ms=3, lw=0.8)
        return
    points = ax.scatter(varied[names[0]], found, c=varied[names[1]], s=8, cmap="viridis", linewidths=0, zorder=3)
    figure.colorbar(points, ax=ax, label=names[1], pad=0.01)


# ---- The picture of advice and reports: error against operations or time, a curve a method.


def work_precision(
    title: str,
    refinements: Sequence[tuple[Method, np.ndarray]],
    tolerance: float,
    unit: str,
    path: str | Path | None = None,
) -> Figure:
    """Error over the price of every level: of each method (N, 2), price in a unit, and error. Raises OutputError.

    A method none of whose levels came to its end stands in the legend only, as lost.
    """
    figure, (ax,) = grid(1, title)
    figure.set_size_inches(WIDTH, 0.5 * WIDTH)
    styles = method_styles([method for method, _ in refinements])
    for method, levels in refinements:
        shown = levels[np.isfinite(levels).all(axis=1)]
        name = method.label if len(shown) or not len(levels) else f"{method.label} (lost)"
        if len(levels):
            ax.loglog(*shown.T, label=name, ms=5, lw=1.3, **styles[method.label])
    ax.axhline(tolerance, color="0.4", lw=0.8, ls="--", label="tolerance")
    ax.set_xlabel(unit, fontsize=9)
    ax.set_ylabel("error of the motion, of its amplitudes", fontsize=9)
    ax.tick_params(which="both", labelsize=7)
    legend(ax)
    return finish(figure, path)


# ---- The picture of a fit: data and fitted outputs over time, and what is left over.

DATA, LINE = "#8fb9c9", "#8a1c3b"


def fit_picture(
    title: str,
    t: np.ndarray,
    data: Mapping[str, np.ndarray],
    fitted: Mapping[str, np.ndarray],
    path: str | Path | None = None,
) -> Figure:
    """Of each output (N,) over t (N,) [s] data (points), fit (line), and below them residuals. Raises OutputError."""
    count = len(data)
    figure, axes = grid(2 * count, title, columns=count, ratios=(3, 1))
    for (name, values), above, below in zip(data.items(), axes[:count], axes[count:], strict=True):
        above.plot(t, values, ".", markersize=3, color=DATA, label="data")
        above.plot(t, fitted[name], color=LINE, linewidth=1.2, label="fit")
        above.set_ylabel(name)
        above.legend(frameon=False)
        below.plot(t, fitted[name] - values, ".", markersize=2, color=LINE)
        below.axhline(0.0, color="#111827", linewidth=0.6)
        below.set_ylabel("residual")
        below.set_xlabel("t [s]")
    return finish(figure, path)


# ---- The picture of motions that repeat over a parameter.

Branch = tuple[np.ndarray, np.ndarray, np.ndarray, int]  # values, heights, is it unstable?, doublings


def branch_picture(
    title: str,
    over: str,
    output: str,
    branches: Sequence[Branch],
    specials: Sequence[tuple[str, float, float]],
    path: str | Path | None = None,
) -> Figure:
    """Heights (N,) over the parameter: stable solid, unstable dashed, thinner with each doubling; specials marked.

    specials: kind, value, height. Raises OutputError.
    """
    figure, (ax,) = grid(1, f"{title}: motions that repeat (dashed: unstable)")
    for values, heights, unstable, doublings in branches:
        for piece in np.split(np.arange(len(values)), np.flatnonzero(np.diff(unstable)) + 1):
            own = slice(piece[0], piece[-1] + 2)
            style = {"ls": "--", "color": "#9aa5b1"} if unstable[piece[0]] else {"ls": "-", "color": "#1f4e79"}
            ax.plot(values[own], heights[own], lw=1.8 / (1 + 0.4 * doublings), **style)
    for kind, value, height in specials:
        ax.plot(value, height, "o", color=SPECIALS.get(kind, "#111827"), markersize=6)
        ax.annotate(kind, (value, height), textcoords="offset points", xytext=(6, 6), fontsize=8)
    ax.set_xlabel(literal(over))
    ax.set_ylabel(f"largest |{output}| of a period")
    return finish(figure, path)


# ---- The picture of a stability chart.

LEVELS = (0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2, 1e-1, 1.0, np.inf)  # of growth in a major step
SHADES = ("#e8f1f2", "#d3e6ea", "#b3d4db", "#8fb9c9", "#f4d58d", "#f0a35e", "#d1495b", "#8a1c3b")
Row = tuple[str, np.ndarray, np.ndarray, float | None, Sequence[tuple[float, float]]]


def stability_picture(title: str, rows: Sequence[Row], path: str | Path | None = None) -> Figure:
    """Spurious growth in a major step over dt_S, a row for each m, limits as bars, windows as lines.

    rows: m, dt_S (N,) [s], growth (N,), the limit and the windows [s] in it. Raises OutputError.
    """
    figure, (ax,) = grid(1, title)
    figure.set_size_inches(9, 1.8 + 0.42 * max(3, len(rows)))
    ax.grid(False)
    norm = BoundaryNorm(np.arange(len(LEVELS)), len(SHADES))
    for k, (_, fine, growth, limit, windows) in enumerate(rows):
        edges = np.sqrt(fine[1:] * fine[:-1])
        edges = np.concatenate([[fine[0] ** 2 / edges[0]], edges, [fine[-1] ** 2 / edges[-1]]])
        values = np.digitize(np.where(np.isfinite(growth), growth, 1e9), LEVELS[1:-1])[None] + 0.5
        mesh = ax.pcolormesh(edges, [k - 0.45, k + 0.45], values, cmap=ListedColormap(SHADES), norm=norm)
        if limit is not None:
            ax.plot([limit] * 2, [k - 0.45, k + 0.45], color="#111827", linewidth=2.0)
        for window in windows:
            ax.plot(window, [k, k], color="#111827", linewidth=1.0)
    ax.set_xscale("log")
    ax.set_yticks(range(len(rows)), [row[0] for row in rows])
    ax.set_ylabel("m")
    ax.set_xlabel("step of the fastest group dt_S [s]")
    bar = figure.colorbar(mesh, ax=ax, ticks=np.arange(1, len(SHADES)))
    bar.ax.set_yticklabels([f"{level:g}" for level in LEVELS[1:-1]])
    bar.set_label("spurious growth in a major step")
    return finish(figure, path)
