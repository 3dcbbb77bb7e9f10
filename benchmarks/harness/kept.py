"""Results on disk: of each benchmark by itself as soon as it is measured, so that what follows may be interrupted."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path

from benchmarks.harness.page import as_json, as_markdown
from benchmarks.harness.result import Line, Result


def keep(folder: Path, machine: dict[str, str], result: Result, so_far: list[Result]) -> None:
    """NAME.json of a result; results.json and results.md of all that the run has so far."""
    folder.mkdir(parents=True, exist_ok=True)
    texts = {
        f"{result.name}.json": json.dumps({"machine": machine, "result": asdict(result)}, indent=1) + "\n",
        "results.json": json.dumps(as_json(machine, so_far), indent=1) + "\n",
        "results.md": as_markdown(machine, so_far),
    }
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")


def kept(folder: Path, name: str) -> tuple[dict[str, str], Result] | None:
    """(machine, result) of a benchmark that was kept; None if there is none."""
    path = folder / f"{name}.json"
    if not path.is_file():
        return None
    found = json.loads(path.read_text(encoding="utf-8"))
    fields = found["result"]
    return found["machine"], Result(**{**fields, "lines": [Line(**line) for line in fields["lines"]]})
