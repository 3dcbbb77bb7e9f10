"""`symgen demo plate`: a plate with a finely meshed spot, stepped by regions (Section 2 of the paper, Fig. 1)."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from runtime.contract.files import write_text
from symgen.cli.outcome import FAILED, OK, Outcome, Progress

T_END = 4e-4  # [s]: the pulse crosses the plate twice
MOST_ERROR = 0.02  # at which methods are compared


def plate_demo(out: str | None, t_end: float | None) -> Outcome:
    """Simulate the plate, draw its regions and its motion, and report every method's error against its time.

    Leaves page.html, regions.png, motion.png, fields.png, error_time.png, methods.md, methods.csv, report.json and
    run.npz.
    """
    from symgen.scenes.plate import plate_scene

    folder, end = Path(out) if out else Path("out") / "plate", t_end or T_END
    with Progress("symgen") as progress:
        progress.note("assembling the plate ...")
        model = plate_scene().model()
        progress.note("stepping ...")
        run = model.simulate(end)
        progress.note("drawing ...")
        files: dict[str, Callable[[Path], object]] = {
            "regions.png": run.plot_regions, "motion.png": run.plot, "fields.png": run.plot_fields, "run.npz": run.save,
            "page.html": run.page,
        }  # fmt: skip
        for name, write in files.items():
            write(folder / name)
        report = model.report(end, folder, note=progress.note)
    quickest = report.best(MOST_ERROR)
    data: dict[str, Any] = {
        "status": run.status.name,
        "error": run.error.largest,
        **run.stats,
        "rows": [row._asdict() for row in report.rows],
        "reference": report.reference,
    }
    write_text(folder / "report.json", json.dumps(data, indent=2))
    left = [*files, "error_time.png", "methods.md", "methods.csv", "report.json"]
    counts = " and ".join(map(str, run.stats["groups"]))
    lines = [
        f"{model.title}: {len(model.names)} coordinates, {counts} nodes that step {run.stats['m']} to 1",
        f"{run.status}; measured error {run.error}",
        f"operations {run.stats['share_of_operations']:.2f} of those of one step for all",
        str(report),
        *(
            [f"quickest with an error below {MOST_ERROR:g}: {quickest.method}, {quickest.seconds:.3g} s"]
            if quickest
            else []
        ),
        f"in {folder}: {', '.join(left)}",
    ]
    paths = {name: str(folder / name) for name in left}
    return Outcome({"report": data, "folder": str(folder), "files": paths}, lines, OK if run.status.ok else FAILED)
