"""`symgen modes`: frequencies, damping and shapes about an operating point."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symgen.cli.arguments import add_command, add_scene
from symgen.cli.operating_options import add_locked, add_operating_options, equilibrium_data, found_equilibrium
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "modes",
        run,
        "Compute the modes about an equilibrium or a steady rotation.",
        "Damping, gyroscopic and geometric terms included; rigid-body modes are named. With --out each mode leaves a "
        "period of its motion as a solution, mode1.npz and so on.",
    )
    add_scene(command)
    add_operating_options(command)
    add_locked(command)
    command.add_argument("--out", metavar="DIR", help="folder for the motion of each mode")


def run(arguments: argparse.Namespace) -> Outcome:
    """The modes as a table."""
    from runtime.operating.mode_motion import mode_motion
    from runtime.operating.modes import modes
    from symgen.cli.sources import opened_model

    model = opened_model(arguments.scene, arguments.made_with)
    point = found_equilibrium(model, arguments)
    found = modes(model, point, locked=arguments.locked)
    files = []
    for k in range(len(found)) if arguments.out else ():
        path = Path(arguments.out) / f"mode{k + 1}.npz"
        mode_motion(found.system, k).save(path)
        files.append(str(path))
    remarks = found.system.remarks()
    data = {"scene": model.name, "equilibrium": equilibrium_data(point), "modes": found.table(), "remarks": remarks}
    head = f"{'mode':>4}  {'rad/s':>12}  {'Hz':>12}  {'damping':>10}  coordinate"
    rows = [
        f"{row['mode']:>4}  {row['frequency']:>12.6g}  {row['frequency_Hz']:>12.6g}  {row['damping_ratio']:>10.4g}"
        f"  {row['name']}"
        for row in found.table()
    ]
    lines = [f"{model.name}: {len(found)} modes about {point!r}", head, *rows, *remarks]
    return Outcome({**data, "files": files}, lines + [f"left {path}" for path in files])
