"""`symgen compare`: two runs over each other, and how far they are apart."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symgen.cli.arguments import add_command, names
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "compare",
        run,
        "Compare two runs: largest and mean square difference, and a picture of both.",
        "FIRST and SECOND are folders left by `simulate --out`. Compared at the first run's times, SI units.",
    )
    command.add_argument("first", metavar="FIRST", help="results folder")
    command.add_argument("second", metavar="SECOND", help="results folder")
    command.add_argument("--names", type=names, metavar="NAMES", help="default: the independent coordinates of both")
    command.add_argument("--out", metavar="FILE", help="the picture (default: FIRST/difference.png)")


def run(arguments: argparse.Namespace) -> Outcome:
    """Differences as a table, and the picture."""
    import numpy as np

    from runtime.contract.coordinates import followed
    from runtime.views import plots
    from symgen.cli.running import results_of

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
    return Outcome({"difference": rows, "times": len(t), "file": str(path)}, [*lines, f"left {path}"])
