"""A CSV of samples of inputs: a header `t,name,...` and a row for each time from which they hold."""

from __future__ import annotations

from symgen.cli.arguments import UsageError


def input_samples(path: str) -> dict[str, tuple[list[float], list[float]]]:
    """{input: (times [s], values)}. Raises UsageError for a file that is none."""
    try:
        with open(path, encoding="utf-8-sig") as stream:
            lines = [line.strip() for line in stream if line.strip()]
    except (OSError, ValueError) as error:
        raise UsageError(f"--inputs {path} cannot be read ({getattr(error, 'strerror', None) or error})") from None
    header = [name.strip() for name in lines[0].split(",")] if lines else []
    if len(header) < 2 or header[0] != "t" or len(lines) < 2:
        raise UsageError(f"--inputs {path}: the first line must name the columns, t,input,... and rows must follow")
    columns: list[list[float]] = [[] for _ in header]
    for number, line in enumerate(lines[1:], 2):
        try:
            values = [float(word) for word in line.split(",")]
        except ValueError:
            values = []
        if len(values) != len(header):
            raise UsageError(f"--inputs {path}: row {number} does not hold {len(header)} numbers")
        for column, value in zip(columns, values, strict=True):
            column.append(value)
    return {name: (columns[0], values) for name, values in zip(header[1:], columns[1:], strict=True)}
