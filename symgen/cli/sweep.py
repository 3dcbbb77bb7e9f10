"""`symgen sweep`: one scene for many values of its parameters and starts, at once."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symgen.cli.arguments import (
    UsageError,
    add_command,
    add_motion_options,
    add_scene,
    names,
    number,
    option,
    ratios,
)
from symgen.cli.outcome import FAILED, INTERRUPTED, OK, Outcome

SPACINGS = ("lin", "log")
MOST_CASES = 10_000_000
LISTED = 12  # values in the summary


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "sweep",
        run,
        "Run a scene for many values of parameters and starts at once.",
        "Every combination of the values of --over is a case. With --out FILE.nc or FILE.csv it leaves the answer, and "
        "a picture of the same name.",
    )
    add_scene(command)
    command.add_argument(
        "--over",
        action="append",
        type=over,
        required=True,
        metavar="NAME=lin:FROM:TO:COUNT",
        help="a parameter, coordinate or rate (NAME_dot) and values: lin:, log:, or a list such as 1,2,5; repeatable",
    )
    command.add_argument("--outputs", type=names, required=True, metavar="NAMES", help="what is kept of each case")
    command.add_argument(
        "--reduce", type=names, metavar="HOW", help="max, min, peak, mean, rms, end of each output (default: peak,end)"
    )
    command.add_argument("--every", type=int, metavar="STEPS", help="keep one of so many major steps instead")
    command.add_argument("--out", metavar="FILE", help="study.nc or study.csv; the picture is study.png")
    command.add_argument("--folder", metavar="DIR", help="where finished parts are kept: the same words go on there")
    command.add_argument("--workers", type=int, metavar="COUNT", help="threads (default: one a processor)")
    add_motion_options(command)
    group = command.add_argument_group("run", "What is not given comes from the scene's [simulation].")
    group.add_argument("--dt", type=number, metavar="SECONDS", help="major step dt_L")
    group.add_argument("--m", type=ratios, metavar="10,4", help="ratio of each next group's step, slow to fast")
    group.add_argument("--scheme", help="time stepping scheme, for instance exponential or single_rate")
    group.add_argument(
        "--option", action="append", type=option, default=[], metavar="NAME=VALUE", help="as for simulate; repeatable"
    )


def over(text: str) -> tuple[str, list[float]]:
    """NAME=lin:FROM:TO:COUNT, NAME=log:FROM:TO:COUNT or NAME=VALUE,VALUE,..."""
    name, equals, values = text.partition("=")
    spacing, *parts = values.split(":")
    try:
        if not name.strip() or not equals:
            raise ValueError
        if spacing not in SPACINGS:
            return name.strip(), [number(part) for part in values.split(",")]
        first, last, count = number(parts[0]), number(parts[1]), int(parts[2])
        if len(parts) == 3 and count >= 2 and (spacing == "lin" or first * last > 0):
            return name.strip(), _spaced(spacing, first, last, count)
    except (ValueError, IndexError, argparse.ArgumentTypeError):
        pass
    raise argparse.ArgumentTypeError(
        f"{text!r} is not NAME=lin:FROM:TO:COUNT, NAME=log:FROM:TO:COUNT (one sign) or NAME=1,2,5"
    )


def _spaced(spacing: str, first: float, last: float, count: int) -> list[float]:
    import numpy as np

    values = np.linspace(first, last, count) if spacing == "lin" else np.geomspace(first, last, count)
    return [float(value) for value in values]


def run(arguments: argparse.Namespace) -> Outcome:
    """Sweep; exit code 1 if a case did not reach its end, with all that others left."""
    import numpy as np

    from runtime import ensemble
    from runtime.contract.files import try_writing
    from runtime.engine.compiled import CompilerError
    from runtime.studies.ensemble.answer_files import check_suffix, variables, write_answer
    from runtime.views.ensemble_picture import ensemble_picture
    from symgen.cli.progress import Progress
    from symgen.cli.sources import opened_model

    if arguments.out:
        check_suffix(arguments.out)
        try_writing(arguments.out)
    if arguments.reduce and arguments.every is not None:
        raise UsageError("--reduce and --every are two answers: give one")
    model = opened_model(arguments.scene, arguments.made_with)
    columns = _combined(arguments.over)
    known = {parameter.name for parameter in model.parameters}
    parameters = {name: values for name, values in columns.items() if name in known}
    starts = {name: values for name, values in columns.items() if name not in known}
    _refuse_unknown(model, starts)
    hows = [] if arguments.every is not None else arguments.reduce or ["peak", "end"]
    try:
        with Progress(f"symgen {model.name}", counted="cases") as progress:
            answer = ensemble(
                model,
                {**dict(arguments.set), **parameters},
                {**dict(arguments.initial), **starts},
                scheme=arguments.scheme,
                dt=arguments.dt,
                m=arguments.m,
                options=dict(arguments.option),
                t_end=arguments.t_end,
                start=arguments.start,
                outputs=arguments.outputs,
                reduce=dict.fromkeys(arguments.outputs, hows) if hows else None,
                every=arguments.every,
                workers=arguments.workers,
                progress=progress,
                folder=arguments.folder,
            )
    except CompilerError as error:
        raise UsageError(f"{error}; an ensemble needs llvmlite") from error
    written = variables(answer)
    found = {name: values for name, (_, values, _) in written.items()}
    kept = [f"{name}_{how}" for name in arguments.outputs for how in hows] or arguments.outputs
    values = {name: found[name] for name in dict.fromkeys(kept)}
    files = []
    if arguments.out:
        write_answer(answer, arguments.out)
        picture = Path(arguments.out).with_suffix(".png")
        units = {name: f"{name} [{unit}]" if unit else name for name, (_, _, unit) in written.items()}
        varied = {name: one for name, one in columns.items() if np.ptp(one) > 0} or columns
        ensemble_picture(
            model.title or model.name,
            {units.get(name, units.get(f"initial.{name}", name)): one for name, one in varied.items()},
            {units[name]: one for name, one in values.items()},
            found.get("time"),
            picture,
        )
        files = [str(arguments.out), str(picture)]
    ends, counts = np.unique(found["status"], return_counts=True)
    statuses = dict(zip(ends.tolist(), counts.tolist(), strict=True))
    lines = [f"{model.name}: {len(found['case'])} cases, " + ", ".join(f"{n} {name}" for name, n in statuses.items())]
    ranges = _ranges(values)
    lines += [f"  {name:<28} {low:>14.6g} ... {high:.6g}" for name, (low, high) in list(ranges.items())[:LISTED]]
    code = OK if set(statuses) == {"completed"} else INTERRUPTED if "interrupted" in statuses else FAILED
    data = {"scene": model.name, "cases": len(found["case"]), "status": statuses, "ranges": ranges, "files": files}
    return Outcome(data, [*lines, *(f"left {path}" for path in files)], code)


def _combined(given: list[tuple[str, list[float]]]) -> dict[str, Any]:
    """Columns of all combinations, the last name running fastest. Raises UsageError."""
    import numpy as np

    seen = [name for name, _ in given]
    twice = next((name for name in seen if seen.count(name) > 1), None)
    if twice is not None:
        raise UsageError(f"--over {twice} is given twice; list its values in one")
    if np.prod([float(len(values)) for _, values in given]) > MOST_CASES:
        raise UsageError(f"--over makes more than {MOST_CASES} cases; take fewer values")
    meshes = np.meshgrid(*(values for _, values in given), indexing="ij")
    return {name: mesh.ravel() for name, mesh in zip(seen, meshes, strict=True)}


def _refuse_unknown(model: Any, starts: dict[str, Any]) -> None:
    """Raises ModelError for a name that is neither a parameter nor a coordinate or rate."""
    from runtime.contract.model import ModelError

    for name in starts:
        if name.removesuffix("_dot") not in model.coordinates and name not in model.coordinates:
            offered = [parameter.name for parameter in model.parameters if parameter.kind != "data"]
            raise ModelError(
                f"--over {name}",
                f"model {model.name} has no parameter, coordinate or rate of this name",
                f"it has {', '.join([*offered, *model.coordinates])}",
            )


def _ranges(values: dict[str, Any]) -> dict[str, tuple[float, float]]:
    """Least and largest of each output."""
    import numpy as np

    known = {name: one[np.isfinite(one)] for name, one in values.items()}
    return {name: (float(one.min()), float(one.max())) for name, one in known.items() if one.size}
