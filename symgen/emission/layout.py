"""How an output is written: sparse ones by entry, matrices by rows, lists of points by points, vectors by entry."""

from __future__ import annotations

from collections.abc import Sequence

WIDTH = 116
ZEROS = ("0.0", "-0.0")
SPARSE = 1 / 3  # share of zeros from which entries are written one by one
SMALL = 3  # entries: a vector this short is written in one go
TALL = 12  # rows: a matrix no taller is written by columns where it has more of them


def output_lines(name: str, size: Sequence[int], entries: Sequence[str], names: Sequence[Sequence[str]]) -> list[str]:
    """Statements that make the output: entries column by column, names along rows and columns ([] for none)."""
    rows, columns = size
    zeros = sum(entry in ZEROS for entry in entries)
    if zeros == len(entries):
        return [f"{name} = ca.SX({rows}, {columns})"]
    if len(entries) > SMALL and zeros > SPARSE * len(entries):
        return _by_entry(name, rows, columns, entries, names)
    if columns == 1:
        return _vector(name, entries, names[0])
    if rows == 1:
        return [f"{name} = ca.horzcat(", *(f"    {line}" for line in _filled(entries)), ")"]
    along = (
        (columns, [entries[k * rows : (k + 1) * rows] for k in range(columns)], names[1], "horzcat", "vertcat")
        if rows <= TALL < columns or (names[1] and not names[0])
        else (rows, [entries[k::rows] for k in range(rows)], names[0], "vertcat", "horzcat")
    )
    count, parts, labels, outer, inner = along
    lines = [f"{name} = ca.{outer}("]
    for k in range(count):
        lines += _part(inner, parts[k], labels[k] if labels else "")
    return [*lines, ")"]


def _by_entry(name: str, rows: int, columns: int, entries: Sequence[str], names: Sequence[Sequence[str]]) -> list[str]:
    """Only what is not zero, row by row under the row's name."""
    lines = [f"{name} = ca.SX({rows}, {columns})"]
    for row in range(rows):
        found = [(column, entries[column * rows + row]) for column in range(columns)]
        found = [(column, entry) for column, entry in found if entry not in ZEROS]
        label = names[0][row] if names[0] else ""
        if columns == 1:
            lines += [_noted(f"{name}[{row}] = {entry}", label) for _, entry in found]
            continue
        lines += [f"# {label}"] if label and found else []
        lines += [f"{name}[{row}, {column}] = {entry}" for column, entry in found]
    return lines


def _vector(name: str, entries: Sequence[str], labels: Sequence[str]) -> list[str]:
    whole = f"{name} = ca.vertcat({', '.join(entries)})"
    if len(entries) <= SMALL and len(whole) <= WIDTH:
        return [whole]
    if labels:
        noted = (_noted(f"    {entry},", label) for entry, label in zip(entries, labels, strict=True))
        return [f"{name} = ca.vertcat(", *noted, ")"]
    return [f"{name} = ca.vertcat(", *(f"    {line}" for line in _filled(entries)), ")"]


def _part(function: str, entries: Sequence[str], label: str) -> list[str]:
    """A row or column of a matrix, on one line if it fits."""
    whole = _noted(f"    ca.{function}({', '.join(entries)}),", label)
    if len(whole) <= WIDTH:
        return [whole]
    return [_noted(f"    ca.{function}(", label), *(f"        {line}" for line in _filled(entries)), "    ),"]


def _filled(entries: Sequence[str]) -> list[str]:
    """Entries with commas, as many on a line as fit."""
    lines: list[str] = []
    for entry in entries:
        if lines and len(lines[-1]) + len(entry) + 2 <= WIDTH - 12:
            lines[-1] += f" {entry},"
        else:
            lines.append(f"{entry},")
    return lines


def _noted(text: str, label: str) -> str:
    return f"{text}  # {label}" if label else text
