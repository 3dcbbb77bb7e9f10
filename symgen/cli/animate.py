"""`symgen animate`: a GIF of results that are there, or of a scene simulated for it."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.arguments import UsageError, add_command, add_run_options, add_scene, number
from symgen.cli.outcome import Outcome

if TYPE_CHECKING:
    from runtime.results.solution import Solution


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "animate",
        run,
        "Write a GIF of the moving mechanism.",
        "RESULTS is a folder left by `simulate --out` or `demo`; a SCENE is simulated first.",
    )
    add_scene(command, metavar="RESULTS|SCENE", help="results folder, built-in name, .toml file, or generated folder")
    command.add_argument("--out", metavar="FILE", help="the .gif to write (default: RESULTS/motion.gif or SCENE.gif)")
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
    from symgen.cli.running import exit_code

    solution, default = _solution(arguments)
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


def _solution(arguments: argparse.Namespace) -> tuple[Solution, Path]:
    """The solution and where its GIF goes unless told otherwise."""
    from runtime.contract.loading import load_model
    from runtime.results.solution import Solution
    from symgen.cli.running import MODEL_FOLDER, SOLUTION_FILE, run_model
    from symgen.cli.sources import builtin_name, opened_model

    folder = Path(arguments.scene)
    if (folder / SOLUTION_FILE).is_file() and builtin_name(arguments.scene) is None:
        given = [
            name
            for name in ("t_end", "dt", "m", "scheme", "set", "initial", "option", "save_every")
            if getattr(arguments, name)
        ]
        if given:
            raise UsageError(
                f"{arguments.scene} holds results that are there already; --{given[0].replace('_', '-')} "
                "needs a SCENE to simulate"
            )
        model = load_model(folder / MODEL_FOLDER)
        return Solution.load(folder / SOLUTION_FILE, model), folder / "motion.gif"
    model = opened_model(arguments.scene, arguments.made_with)
    return run_model(model, arguments), Path(f"{model.name}.gif")
