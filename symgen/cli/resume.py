"""`symgen resume`: go on with a run from its checkpoint."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symgen.cli.arguments import add_checkpoint_options, add_command, add_engine
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "resume",
        run,
        "Go on with a run from its checkpoint.",
        "The results are those of an uninterrupted run, bit for bit.",
    )
    command.add_argument("file", metavar="FILE", help="what simulate --checkpoint wrote")
    command.add_argument(
        "scene",
        metavar="SCENE",
        nargs="?",
        help="built-in name, .toml file or generated folder of the run (default: the scene that the checkpoint holds)",
    )
    command.add_argument("--out", metavar="DIR", help="folder for the results (default: none are kept)")
    add_engine(command)
    add_checkpoint_options(command)


def run(arguments: argparse.Namespace) -> Outcome:
    """Resume; exit codes as of `simulate`."""
    from runtime import resume
    from runtime.running.checkpoint import read_checkpoint
    from runtime.views.report import run_report
    from symgen.cli.progress import Progress
    from symgen.cli.running import MODEL_FOLDER, exit_code, leave_all, summary
    from symgen.cli.sources import opened_model, opened_text, try_leaving_model

    folder = Path(arguments.out) if arguments.out else None
    keep = folder / MODEL_FOLDER if folder else None
    if keep:
        try_leaving_model(keep)
    header = read_checkpoint(arguments.file).header
    model = (
        opened_model(arguments.scene, keep=keep, digest=header.digest)
        if arguments.scene
        else opened_text(header.model, header.scene_toml, header.digest, keep)
    )
    with Progress(f"symgen {model.name}") as progress:
        solution = resume(
            model,
            arguments.file,
            stream=arguments.stream,
            engine=arguments.engine,
            progress=progress,
            checkpoint_every=arguments.checkpoint_every,
        )
    files = leave_all(solution, folder, pictures=False) if folder else {}
    lines = summary(solution) + ([f"results in {folder}"] if folder else [])
    return Outcome({"report": run_report(solution), "files": files}, lines, exit_code(solution))
