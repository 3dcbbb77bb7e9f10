"""The page of a run of a structure: what came of it, how exact it is, with which method."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.arguments import PLACE, require
from runtime.contract.cards import Html, html
from runtime.results.key_figures import Peak, peak
from runtime.structures.structure import StructureError
from runtime.views.document import badge, code, document, made_with, paragraph, peak_table, picture, table
from runtime.views.viewer.page import View, shown

if TYPE_CHECKING:
    from runtime.structures.run import StructureRun

MOST_PEAKS = 8  # outputs, those that move most


def page(run: StructureRun, path: str | Path | None = None) -> View:
    """Write a report of a run of a structure as one page to read, send and print.

    Parameters
    ----------
    run : StructureRun
        N samples.
    path : str or Path, optional
        An .html file; if left out the page is shown in the notebook, or opened.

    Returns
    -------
    View
        The page: status and error, regions and deformed mesh, key figures with their times, curves, the call that makes
        the run again. It needs no network.

    Raises
    ------
    OutputError
        For a place that cannot be written.
    """
    require(PLACE, or_none=True, path=path)
    structure = run.model.structure
    sections = [
        ("Result", _result(run)),
        ("Structure", _pictures(run)),
        ("Key figures", peak_table(_peaks(run), "Peaks are the largest magnitudes among the saved samples.")),
        ("Curves", picture(run.plot(), "Displacements that are largest, and energies.") if len(run.t) > 1 else Html()),
        ("Loads", table(("number", "F(t)"), [(str(k + 1), text) for k, text in enumerate(structure.law_texts)])),
        ("How to reproduce it", html(made_with(), code(_lines(run)))),
    ]
    return shown(document(run.model.title, f"{structure.size} coordinates", sections), path)


def _result(run: StructureRun) -> Html:
    status = run.status
    ended = html(badge(status.name, status.ok), "" if status.ok else f" {status}")
    total = run.energy.sum(axis=1)
    rows = [
        ("status", ended),
        ("motion", f"t = {run.t[0]:.6g} to {run.t[-1]:.6g} s, {len(run.t)} samples saved" if len(run.t) else "-"),
        ("method", f"{run.about}, {run.stats['steps']} steps"),
        ("error of the steps", str(run.error) if np.isfinite(run.error.largest) else "not estimated"),
        ("error of the mesh", "not estimated: run a finer mesh"),
        ("energy", f"{total[-1]:.4g} J at the end" if len(total) else "-"),
    ]
    return html(Html('<div class="facts">'), table((), rows), Html("</div>"))


def _peaks(run: StructureRun) -> list[Peak]:
    """Of the outputs that move most, of all nodes where fields were kept, and of the energy."""
    largest = np.argsort(-np.abs(run.values).max(axis=0, initial=0.0), kind="stable")[:MOST_PEAKS]
    found = [peak(run.names[k], "m", run.t, run.values[:, k]) for k in largest] if len(run.t) else []
    structure = run.model.structure
    if len(run.fields):
        moved = np.linalg.norm(run.fields.reshape(len(run.fields), -1, structure.width), axis=2)
        sample, node = np.unravel_index(int(moved.argmax()), moved.shape)
        at = () if structure.points is None else structure.points[node]
        where = ", ".join(f"{axis} = {x:.4g} m" for axis, x in zip("xyz", at, strict=False)) or f"node {node + 1}"
        value, t = float(moved[sample, node]), float(run.field_times[sample])
        found.insert(0, Peak("displacement of the mesh, where fields were kept", "m", value, t, where))
    return [*found, peak("total energy", "J", run.energy_times, run.energy.sum(axis=1))] if len(run.energy) else found


def _pictures(run: StructureRun) -> Html:
    """Regions of steps, and the deformed mesh; of what is drawn in a plane."""
    parts = []
    try:
        if run.regions is not None and len(run.regions.groups) > 1:
            parts.append(picture(run.plot_regions(), "How often each node steps in one of the slowest steps."))
        parts.append(picture(run.plot_fields(), "The deformed mesh."))
    except StructureError:
        return Html() if run.model.structure.points is None else paragraph("run.to_vtk writes the motion for ParaView.")
    return html(*parts)


def _lines(run: StructureRun) -> str:
    stats = run.stats
    steps = f", m={stats['m']}" if stats.get("m") else ""
    return (
        "# the structure as its scene or its matrices give it\n"
        f"run = model.simulate(t_end={float(run.t[-1]) if len(run.t) else 0.0!r}, scheme={run.scheme!r}, "
        f"dt={float(stats['dt'])!r}{steps})\n"
        'run.page("page.html")'
    )
