"""`symgen campbell`: frequencies along a speed or a parameter."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from math import isnan
from pathlib import Path
from typing import Any

from symgen.cli.arguments import UsageError, add_command, add_scene, number
from symgen.cli.operating_options import add_locked, add_operating_options
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "campbell",
        run,
        "Follow the modes along a speed or a parameter.",
        "Each mode is followed by the likeness of its shape, through crossings. With --out it leaves campbell.csv and "
        "campbell.png.",
    )
    add_scene(command)
    command.add_argument(
        "--over",
        type=span,
        required=True,
        metavar="NAME=FROM:TO",
        help="what changes: a parameter, or the rate of a coordinate such as hub.omega=0:12",
    )
    command.add_argument("--points", type=int, default=25, help="values to look at (default: %(default)s)")
    add_operating_options(command)
    add_locked(command)
    command.add_argument("--out", metavar="DIR", help="folder for campbell.csv and campbell.png")


def span(text: str) -> tuple[str, float, float]:
    """NAME=FROM:TO with finite numbers."""
    name, equals, values = text.partition("=")
    first, colon, last = values.partition(":")
    try:
        if name.strip() and equals and colon:
            return name.strip(), number(first), number(last)
    except (ValueError, argparse.ArgumentTypeError):
        pass
    raise argparse.ArgumentTypeError(f"{text!r} is not NAME=FROM:TO with finite numbers")


def run(arguments: argparse.Namespace) -> Outcome:
    """Frequencies at the first and the last value, critical speeds, remarks."""
    import numpy as np

    from runtime.operating.campbell import campbell
    from runtime.views.campbell_picture import campbell_picture
    from symgen.cli.sources import opened_model

    if arguments.points < 2:
        raise UsageError("--points must be at least 2")
    if arguments.initial:
        raise UsageError("--initial has no place here: every equilibrium starts from the one before")
    name, first, last = arguments.over
    model = opened_model(arguments.scene, arguments.made_with)
    found = campbell(
        model,
        name,
        np.linspace(first, last, arguments.points),
        held=dict(arguments.held),
        rates=dict(arguments.rate),
        parameters=dict(arguments.set),
        locked=arguments.locked,
        t=arguments.time,
    )
    files = []
    if arguments.out:
        folder = Path(arguments.out)
        found.write_csv(folder / "campbell.csv")
        campbell_picture(found, folder / "campbell.png")
        files = [str(folder / "campbell.csv"), str(folder / "campbell.png")]
    data = {
        "scene": model.name,
        "over": name,
        "values": found.values.tolist(),
        "modes": [
            {
                "name": mode,
                "frequencies": _where_there(found.frequencies[:, k]),
                "damping": _where_there(found.damping_ratios[:, k]),
            }
            for k, mode in enumerate(found.names)
        ],
        "critical_speeds": [{"mode": mode + 1, "value": value} for mode, value in found.crossings()],
        "remarks": found.remarks,
        "files": files,
    }
    lines = [f"{model.name} along {name}", f"{'mode':>4}  {f'at {first:g}':>12}  {f'at {last:g}':>12}  [rad/s]"]
    lines += [
        f"{k + 1:>4}  {_shown(found.frequencies[0, k])}  {_shown(found.frequencies[-1, k])}  {mode}"
        for k, mode in enumerate(found.names)
    ]
    if found.is_speed:
        lines += [f"critical speed {value:.6g} rad/s of mode {mode + 1}" for mode, value in found.crossings()]
    return Outcome(data, [*lines, *found.remarks[-3:], *(f"left {path}" for path in files)])


def _shown(frequency: float) -> str:
    return f"{'-':>12}" if isnan(frequency) else f"{frequency:>12.6g}"


def _where_there(values: Iterable[float]) -> list[float | None]:
    """Of a mode that comes or goes, None where it is not."""
    return [None if isnan(value) else float(value) for value in values]
