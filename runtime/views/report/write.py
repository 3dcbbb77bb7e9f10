"""A report as JSON (strict: no NaN) and as Markdown (a heading and a table a section)."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from runtime.contract.files import write_text
from runtime.results.as_json import as_json

UNITS = {
    "time": "SI units (s)",
    "scheme": "Steps in s; m is the ratio of each next group's step.",
    "energy": "Energies and work in J.",
    "constraints": "max |C| in m and rad.",
    "operations": "Operations of the emitted functions.",
}


def write_report(report: Mapping[str, Any], folder: str | Path, title: str = "Report") -> list[Path]:
    """Write report.json and report.md into `folder`; returns their paths. Raises OutputError."""
    json_path, markdown_path = Path(folder) / "report.json", Path(folder) / "report.md"
    write_text(json_path, as_json(report))
    write_text(markdown_path, as_markdown(report, title))
    return [json_path, markdown_path]


def as_markdown(report: Mapping[str, Any], title: str) -> str:
    """Every section that has entries, in order."""
    parts = [f"# {title}"]
    for name, section in report.items():
        if section:
            parts.append(f"## {_words(name).capitalize()}")
            if name in UNITS:
                parts.append(UNITS[name])
            parts.append(_table(section) if isinstance(section, Mapping) else _cell(section))
    return "\n\n".join(parts) + "\n"


def _table(section: Mapping[str, Any]) -> str:
    """Entries that are all mappings give a column a key; anything else two columns."""
    entries = list(section.values())
    if all(isinstance(entry, Mapping) for entry in entries):
        columns = list(dict.fromkeys(key for entry in entries for key in entry))
        rows = [[f"`{name}`", *(_cell(entry.get(key)) for key in columns)] for name, entry in section.items()]
        return _rows(["name", *map(_words, columns)], rows)
    return _rows(["", "value"], [[_words(name), _cell(entry)] for name, entry in section.items()])


def _rows(header: list[str], rows: list[list[str]]) -> str:
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _cell(value: Any) -> str:
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.9g}"
    if isinstance(value, Mapping):
        return "; ".join(f"{key}: {_cell(part)}" for key, part in value.items()) or "-"
    if isinstance(value, list | tuple):
        return ", ".join(map(_cell, value)) or "-"
    return str(value).replace("|", "\\|").replace("\n", " ") or "-"


def _words(name: str) -> str:
    return name.replace("_", " ")
