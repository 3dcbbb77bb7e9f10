"""`symgen view`: one page that shows a run, or a scene simulated for it, moving in three dimensions."""

from __future__ import annotations

import argparse
import zipfile
from pathlib import Path
from typing import Any

from symgen.cli.arguments import UsageError, add_command, add_run_options, add_scene
from symgen.cli.outcome import Outcome

# what numpy.load says of files that are cut, of another kind (an array alone), or not there
BROKEN = (OSError, ValueError, TypeError, AttributeError, EOFError, zipfile.BadZipFile)


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "view",
        run,
        "Write a page that shows the moving mechanism in three dimensions.",
        "One HTML file that works from a double click, without network: turn, zoom, play, exaggerate, curves. "
        "RESULTS is a folder left by `simulate --out` or `demo`; a SCENE is simulated first.",
    )
    add_scene(command, metavar="RESULTS|SCENE", help="results folder, built-in name, .toml file, or generated folder")
    command.add_argument("--out", metavar="FILE", help="the .html to write (default: RESULTS/view.html or SCENE.html)")
    command.add_argument(
        "--surface",
        action="append",
        default=[],
        metavar="BODY=FILE.npz",
        help="surface of a flexible body (FlexibleBody.surface written with numpy.savez); may be repeated",
    )
    command.add_argument("--beside", metavar="RESULTS", help="a second run, shown pale in the same page")
    command.add_argument("--open", action="store_true", help="open it in the browser")
    add_run_options(command)


def run(arguments: argparse.Namespace) -> Outcome:
    """Load or simulate, then write the page."""
    from runtime.views.viewer import write_view
    from symgen.cli.running import exit_code, loaded_or_run, results_of

    solution, folder = loaded_or_run(arguments)
    default = folder / "view.html" if folder else Path(f"{solution.model.name}.html")
    path = Path(arguments.out) if arguments.out else default
    second = results_of(arguments.beside) if arguments.beside else None
    page = write_view(solution, path, _surfaces(arguments.surface), second)
    if arguments.open:
        page.open()
    size = len(page.text.encode()) / 1e6
    lines = [f"{path}: {size:.2f} MB; open it in a browser"]
    data = {"file": str(path), "megabytes": size, "status": str(solution.status)}
    return Outcome(data, lines if solution.status.ok else [*lines, str(solution.status)], exit_code(solution))


def _surfaces(given: list[str]) -> dict[str, dict[str, Any]]:
    """The surfaces given, by body. Raises UsageError."""
    import numpy as np

    found: dict[str, dict[str, Any]] = {}
    for body, file in map(_named, given):
        try:
            with open(file, "rb") as stream, np.load(stream, allow_pickle=False) as arrays:
                found[body] = {name: arrays[name] for name in arrays.files}
        except BROKEN as error:
            raise UsageError(
                f"--surface {body}={file} is not a whole .npz file of plain arrays; write it with numpy.savez"
            ) from error
    return found


def _named(word: str) -> tuple[str, Path]:
    body, equals, file = word.partition("=")
    if not (body and equals and file):
        raise UsageError(f"--surface {word!r} is not BODY=FILE.npz")
    return body, Path(file)
