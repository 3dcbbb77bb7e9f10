"""`symgen simulate`: step a scene or a generated model, and leave the results in a folder."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symgen.cli.arguments import add_checkpoint_options, add_command, add_run_options, add_scene, names
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "simulate",
        run,
        "Simulate a scene or a generated model.",
        "With --out it leaves model/, solution.npz, solution.csv, report.json, report.md and pictures.",
    )
    add_scene(command)
    command.add_argument("--out", metavar="DIR", help="folder for the results (default: none are kept)")
    command.add_argument(
        "--plots",
        action=argparse.BooleanOptionalAction,
        default=None,
        help="motion.png, deformation.png, forces.png and energy.png in --out (left unless --no-plots is given)",
    )
    add_run_options(command)
    command.add_argument("--inputs", metavar="FILE.csv", help="samples of inputs: columns t,name,..., held in between")
    command.add_argument("--checkpoint", metavar="FILE", help="file that `symgen resume` goes on from")
    add_checkpoint_options(command)
    command.add_argument(
        "--outputs",
        type=names,
        metavar="NAMES",
        help="keep only these coordinates, rates, measures or energies, separated by commas",
    )


def run(arguments: argparse.Namespace) -> Outcome:
    """Simulate; exit code 1 if the run did not reach its end, with what was computed until then."""
    from runtime.views.report import run_report
    from symgen.cli.arguments import UsageError
    from symgen.cli.input_files import input_samples
    from symgen.cli.running import MODEL_FOLDER, exit_code, leave_all, run_model, summary
    from symgen.cli.sources import opened_model, try_leaving_model

    if arguments.plots and not arguments.out:
        raise UsageError("--plots needs --out DIR")
    folder = Path(arguments.out) if arguments.out else None
    model = opened_model(arguments.scene, arguments.made_with)
    if folder:
        try_leaving_model(folder / MODEL_FOLDER)
    solution = run_model(
        model,
        arguments,
        inputs=input_samples(arguments.inputs) if arguments.inputs else None,
        outputs=arguments.outputs,
        stream=arguments.stream,
        checkpoint=arguments.checkpoint,
        checkpoint_every=arguments.checkpoint_every,
    )
    files = leave_all(solution, folder, arguments.plots is not False) if folder else {}
    lines = summary(solution) + ([f"results in {folder}"] if folder else [])
    return Outcome({"report": run_report(solution), "files": files}, lines, exit_code(solution))
