"""`symgen plot`: pictures of a run, or of a scene simulated for it."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symgen.cli.arguments import add_command, add_run_options, add_scene, names
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "plot",
        run,
        "Draw motion, deformation, forces and energy, or the quantities that are named.",
        "RESULTS is a folder left by `simulate --out` or `demo`; a SCENE is simulated first.",
    )
    add_scene(command, metavar="RESULTS|SCENE", help="results folder, built-in name, .toml file, or generated folder")
    command.add_argument("--names", type=names, metavar="NAMES", help="coordinates, rates or measures, by commas")
    command.add_argument("--frequencies", action="store_true", help="the frequencies along the motion instead")
    command.add_argument("--sections", metavar="BEAM", help="section forces along this beam instead")
    command.add_argument("--stresses", metavar="BODY", help="stresses at the gauges of this body instead")
    command.add_argument("--out", metavar="DIR", help="folder for the pictures (default: RESULTS, or out/SCENE)")
    add_run_options(command)


def run(arguments: argparse.Namespace) -> Outcome:
    """Load or simulate, then draw."""
    from runtime.views import plots
    from symgen.cli.running import exit_code, loaded_or_run

    solution, folder = loaded_or_run(arguments)
    target = Path(arguments.out) if arguments.out else folder or Path("out") / solution.model.name
    if arguments.frequencies:
        paths = [target / "frequencies.png"]
        plots.frequencies(solution, paths[0])
    elif arguments.sections:
        paths = [target / f"sections_{arguments.sections}.png"]
        plots.section_forces(solution, arguments.sections, paths[0])
    elif arguments.stresses:
        paths = [target / f"stresses_{arguments.stresses}.png"]
        plots.stresses(solution, arguments.stresses, paths[0])
    elif arguments.names:
        paths = [target / "curves.png"]
        plots.coordinates(solution, paths[0], arguments.names)
    else:
        paths = plots.usual(solution, target)
    data = {"files": {path.name: str(path) for path in paths}, "status": str(solution.status)}
    return Outcome(data, [f"left {path}" for path in paths], exit_code(solution))
