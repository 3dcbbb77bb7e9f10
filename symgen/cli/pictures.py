"""`symgen view`, `plot`, `compare`, `animate`: results that are there, or of a scene simulated for it, to look at."""

from __future__ import annotations

import argparse
from pathlib import Path

from symgen.cli.outcome import Outcome, left
from symgen.cli.runs import exit_code, loaded_or_run, results_of


def view(arguments: argparse.Namespace) -> Outcome:
    """Write a page that shows the moving mechanism in three dimensions.

    One HTML file that works from a double click, without network: turn, zoom, play, exaggerate, curves. RESULTS is
    a folder left by `simulate --out` or `demo`; a SCENE is simulated first.
    """
    from runtime.views.viewer.page import show

    solution, folder = loaded_or_run(arguments)
    default = folder / "view.html" if folder else Path(f"{solution.model.name}.html")
    path = Path(arguments.out) if arguments.out else default
    second = results_of(arguments.beside) if arguments.beside else None
    page = show(solution, path, second)
    if arguments.open:
        page.open()
    size = len(page.text.encode()) / 1e6
    lines = [f"{path}: {size:.2f} MB; open it in a browser"]
    data = {"file": str(path), "megabytes": size, "status": str(solution.status)}
    return Outcome(data, lines if solution.status.ok else [*lines, str(solution.status)], exit_code(solution))


def plot(arguments: argparse.Namespace) -> Outcome:
    """Draw motion, deformation, forces and energy, or the quantities that are named.

    RESULTS is a folder left by `simulate --out` or `demo`; a SCENE is simulated first.
    """
    from runtime.views import plots

    solution, folder = loaded_or_run(arguments)
    target = Path(arguments.out) if arguments.out else folder or Path("out") / solution.model.name
    if arguments.frequencies:
        paths = [target / "frequencies.png"]
        plots.frequencies(solution, paths[0])
    elif arguments.sections:
        paths = [target / f"sections_{arguments.sections}.png"]
        plots.section_forces(solution, arguments.sections, paths[0])
    elif arguments.stresses:
        paths = [target / f"stresses_{arguments.stresses}.png"]
        plots.stresses(solution, arguments.stresses, paths[0])
    elif arguments.names:
        paths = [target / "curves.png"]
        plots.coordinates(solution, paths[0], arguments.names)
    else:
        paths = plots.usual(solution, target)
    data = {"files": {path.name: str(path) for path in paths}, "status": str(solution.status)}
    return Outcome(data, left(map(str, paths)), exit_code(solution))


def compare(arguments: argparse.Namespace) -> Outcome:
    """Compare two runs: largest and mean square difference, and a picture of both.

    FIRST and SECOND are folders left by `simulate --out`. Compared at the first run's times, SI units.
    """
    import numpy as np

    from runtime.contract.coordinates import followed
    from runtime.views import plots

    first, second = results_of(arguments.first), results_of(arguments.second)
    path = Path(arguments.out) if arguments.out else Path(arguments.first) / "difference.png"
    plots.difference(first, second, path, arguments.names)
    chosen = arguments.names or [name for name in followed(first.model)[0] if name in second.model.coordinates]
    t = first.t[(first.t >= second.t[0]) & (first.t <= second.t[-1])]
    rows = {}
    for name in chosen:
        gap = np.asarray(second.interpolate(t, name)) - np.asarray(first.interpolate(t, name))
        rows[name] = {"largest": float(np.abs(gap).max()), "rms": float(np.sqrt(np.mean(gap**2)))}
    wide = max(len(name) for name in rows)
    lines = [f"{'':{wide}}  {'largest':>10}  {'rms':>10}   of {len(t)} times to {t[-1]:g} s"]
    lines += [f"{name:{wide}}  {row['largest']:10.3e}  {row['rms']:10.3e}" for name, row in rows.items()]
    return Outcome({"difference": rows, "times": len(t), "file": str(path)}, [*lines, *left([str(path)])])


def animate(arguments: argparse.Namespace) -> Outcome:
    """Write a film of the moving mechanism: a GIF that repeats, or an MP4.

    RESULTS is a folder left by `simulate --out` or `demo`; a SCENE is simulated first.
    """
    from runtime.views.animation import animate

    solution, folder = loaded_or_run(arguments)
    default = folder / "motion.gif" if folder else Path(f"{solution.model.name}.gif")
    path = Path(arguments.out) if arguments.out else default
    shown = animate(solution, path, arguments.frames, arguments.fps, arguments.exaggeration)
    data = {
        "file": str(path),
        "frames": len(shown.t),
        "exaggeration": shown.exaggeration,
        "status": str(solution.status),
    }
    line = f"{path}: {len(shown.t)} frames, deformation x {shown.exaggeration:.3g}"
    return Outcome(data, [line] if solution.status.ok else [line, str(solution.status)], exit_code(solution))
