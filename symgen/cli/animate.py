"""`symgen animate`: a film of results that are there, or of a scene simulated for it."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symgen.cli.arguments import add_command, add_run_options, add_scene, number
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "animate",
        run,
        "Write a film of the moving mechanism: GIF, or MP4 where ffmpeg is installed.",
        "RESULTS is a folder left by `simulate --out` or `demo`; a SCENE is simulated first.",
    )
    add_scene(command, metavar="RESULTS|SCENE", help="results folder, built-in name, .toml file, or generated folder")
    command.add_argument(
        "--out", metavar="FILE", help="the .gif or .mp4 to write (default: RESULTS/motion.gif or SCENE.gif)"
    )
    command.add_argument("--frames", type=int, default=60, help="number of frames (default: 60)")
    command.add_argument("--fps", type=number, default=20.0, help="frames a second (default: 20)")
    command.add_argument(
        "--exaggeration",
        type=number,
        metavar="FACTOR",
        help="scale of the deformation (default: the largest becomes 5 %% of the mechanism's size)",
    )
    add_run_options(command)


def run(arguments: argparse.Namespace) -> Outcome:
    """Load or simulate, then draw."""
    from runtime.views.animation import animate
    from symgen.cli.running import exit_code, loaded_or_run

    solution, folder = loaded_or_run(arguments)
    default = folder / "motion.gif" if folder else Path(f"{solution.model.name}.gif")
    path = Path(arguments.out) if arguments.out else default
    shown = animate(solution, path, arguments.frames, arguments.fps, arguments.exaggeration)
    data = {
        "file": str(path),
        "frames": len(shown.t),
        "exaggeration": shown.exaggeration,
        "status": str(solution.status),
    }
    line = f"{path}: {len(shown.t)} frames, deformation x {shown.exaggeration:.3g}"
    return Outcome(data, [line] if solution.status.ok else [line, str(solution.status)], exit_code(solution))
