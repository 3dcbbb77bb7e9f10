"""Error against time: one step for all, steps by regions and implicit steps of a structure, on the same motion."""

from __future__ import annotations

import csv
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from runtime.contract.escapes import markdown
from runtime.contract.files import replacing
from runtime.structures.pictures import error_time_picture

if TYPE_CHECKING:
    from runtime.structures.model import StructureModel
    from runtime.structures.run import StructureRun

REFINED = (1, 2, 4)
IMPLICIT = (100, 300, 1000)  # steps
REFERENCE = 8  # times as many steps as one step for all takes at its limit


class Row(NamedTuple):
    """A run: method, step of the slowest group [s], steps of the fastest, time of the run [s], error of the
    amplitude.
    """

    method: str
    dt: float
    steps: int
    seconds: float
    error: float
    status: str


@dataclass(frozen=True)
class StructureReport:
    """The runs of a report, and the error of what they were compared with."""

    title: str
    rows: tuple[Row, ...]
    reference: str

    def best(self, error: float) -> Row | None:
        """The quickest run with at most this error."""
        return min((row for row in self.rows if row.error <= error), key=lambda row: row.seconds, default=None)

    def __str__(self) -> str:
        lines = ["| method | dt [s] | small steps | time [s] | error |", "|---|---:|---:|---:|---:|"]
        lines += [f"| {r.method} | {r.dt:.3g} | {r.steps} | {r.seconds:.3g} | {r.error:.2g} |" for r in self.rows]
        return "\n".join([*lines, "", f"Compared with {self.reference}."])


def report(
    model: StructureModel,
    t_end: float,
    folder: str | Path | None = None,
    note: Callable[[str], None] = lambda text: None,
    **motion: Any,
) -> StructureReport:
    """Run every method with steps of several lengths; writes methods.md, methods.csv and error_time.png into a
    folder.

    motion: initial, rates as for `StructureModel.simulate`. The error is that of the whole field in the norm of the
    mass matrix, RMS over time, against one step for all with REFERENCE times as many steps; its own error is said.
    """
    kept: dict[str, Any] = {**motion, "error": "off", "samples": 1, "fields": 40, "outputs": [model.names[0]]}
    explicit = model.structure.is_lumped
    limit = model.step_limit if explicit else t_end / 1000
    note("reference ...")
    fine: dict[str, Any] = {"scheme": "single_rate" if explicit else "generalized_alpha"}
    references = [
        model.simulate(t_end, dt=0.9 * limit / times, **fine, **kept) for times in (REFERENCE // 2, REFERENCE)
    ]
    right = references[1]
    own = _error(references[0], right) / 3
    rows = []
    for method, options in _runs(model, t_end, explicit):
        note(f"{method} ...")
        began = time.perf_counter()
        run = model.simulate(t_end, **options, **kept)
        seconds = time.perf_counter() - began
        small = run.stats.get("small_steps", run.stats["steps"])
        error = _error(run, right) if run.status.whole else float("inf")
        rows.append(Row(method, run.stats["dt"], small, seconds, error, run.status.name))
    said = f"{fine['scheme']} with steps of {right.stats['dt']:.3g} s, itself off by some {own:.1g}"
    found = StructureReport(model.title, tuple(rows), said)
    if folder is not None:
        _write(found, Path(folder))
    return found


def _runs(model: StructureModel, t_end: float, explicit: bool) -> list[tuple[str, dict[str, Any]]]:
    found: list[tuple[str, dict[str, Any]]] = []
    if explicit:
        found += [("single_rate", {"scheme": "single_rate", "dt": 0.9 * model.step_limit / times}) for times in REFINED]
        regions = model.regions()
        if len(regions.groups) > 1:
            m = ", ".join(str(group.sub_steps) for group in regions.groups[:0:-1])
            found += [(f"printed, chord, m = {m}", {"dt": regions.steps[-1] / times}) for times in REFINED]
    return found + [("generalized_alpha", {"scheme": "generalized_alpha", "dt": t_end / steps}) for steps in IMPLICIT]


def _error(run: StructureRun, right: StructureRun) -> float:
    """RMS of the difference of the fields in M's norm over that of the right ones, at the same times."""
    mass = run.model.structure.mass
    weights = mass if isinstance(mass, np.ndarray) else mass.diagonal()
    apart = (np.square(run.fields - right.fields) * weights).sum(axis=1).mean()
    size = (np.square(right.fields) * weights).sum(axis=1).mean()
    return float(np.sqrt(apart / max(size, 1e-300)))


def _write(found: StructureReport, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    with replacing(folder / "methods.md") as temporary:
        temporary.write_text(f"# {markdown(found.title)}: methods\n\n{found}\n", encoding="utf-8")
    with replacing(folder / "methods.csv") as temporary, temporary.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(Row._fields)
        writer.writerows(found.rows)
    error_time_picture(found.title, found.rows, folder / "error_time.png")
