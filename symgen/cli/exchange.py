"""`symgen import`, `symgen export`: files of other programs."""

from __future__ import annotations

import argparse
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

from symgen.cli.outcome import Outcome
from symgen.cli.sources import opened_model
from symgen.cli.words import UsageError, settings

if TYPE_CHECKING:
    from symgen.urdf import Dropped

STEPS = ("scheme", "dt", "m", "options", "parameters", "name")
SHOWN = 6  # names of a kind that a line of the list has


def import_robot(arguments: argparse.Namespace) -> Outcome:
    """Write the scene of a robot that a URDF file describes; list what the scene has not, and what was assumed."""
    from runtime.contract.files import write_text
    from symgen.scene import SceneError
    from symgen.urdf import RobotWarning, read

    path = Path(arguments.out) if arguments.out else Path(f"{Path(arguments.file).stem}.toml")
    if path.exists() and not arguments.force:
        raise SceneError(f"file '{path}'", "already exists", "choose another --out, or replace it with --force")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RobotWarning)  # the list below has them
        robot = read(
            arguments.file,
            arguments.base,
            arguments.flexible,
            meshes=not arguments.no_meshes,
            packages=arguments.package or (),
            inertia=arguments.inertia,
            kinematics=arguments.kinematics,
            default_inertia=None if arguments.density is None else "meshes",
            density=arguments.density,
            **{law: not getattr(arguments, f"no_{law}") for law in ("damping", "friction", "limits", "effort")},
        )
    scene = robot.build()
    write_text(path, scene.to_toml())
    lines = [f"Wrote {path}: {len(scene.moving_bodies)} bodies, {len(scene.joints)} joints.", *_lost(robot.dropped)]
    assumed = [str(one) for one in robot.assumed]
    lines += ["Assumed:", *(f"  {one}" for one in assumed)] if assumed else []
    lines += [f"Renamed: {', '.join(f'{a} -> {b}' for a, b in robot.renamed.items())}"] if robot.renamed else []
    dropped = [str(one) for one in robot.dropped]
    return Outcome(
        {"scene": scene.name, "file": str(path), "dropped": dropped, "assumed": assumed, "renamed": robot.renamed},
        [*lines, f"Next: symgen show {path}, then symgen view {path}"],
    )


def export(arguments: argparse.Namespace) -> Outcome:
    """Hand something on: a model as C or as an FMU, functions of a model as C, the results of a run as a table.

    `c` and `fmu` hold the time stepping scheme, whose bits are those of a run here; both need no Python.
    """
    known = {"results": _results, "c": _c, "fmu": _fmu}
    return known[arguments.what](arguments)


def _results(arguments: argparse.Namespace) -> Outcome:
    """What a results folder holds as a table with units: CSV, MATLAB, Parquet or NetCDF by the name's end."""
    from symgen.cli.runs import results_of

    solution = results_of(arguments.source)
    try:
        solution.export(arguments.out)
    except ImportError as error:  # the message names the extra
        raise UsageError(str(error)) from error
    return Outcome({"file": str(arguments.out)}, [f"Wrote {arguments.out}: {len(solution.t)} samples."])


def _c(arguments: argparse.Namespace) -> Outcome:
    model = opened_model(arguments.source, arguments.made_with)
    return _written(model.export_c(arguments.out, **settings(arguments, STEPS)))


def _fmu(arguments: argparse.Namespace) -> Outcome:
    model, steps = opened_model(arguments.source, arguments.made_with), settings(arguments, STEPS)
    done = model.export_fmu(arguments.out, int(arguments.fmi), arguments.platforms, **steps)
    runs_on = f"for {', '.join(done.platforms)}" if done.platforms else "sources only"
    lines = [f"Wrote {done.path}, {runs_on}.", *(f"Nothing for {name}: {why}." for name, why in done.missing.items())]
    return Outcome({"file": str(done.path), "platforms": done.platforms, "missing": done.missing}, lines)


def _written(files: list[Path]) -> Outcome:
    return Outcome({"files": [str(path) for path in files]}, [f"Wrote {', '.join(map(str, files))}."])


def _lost(dropped: list[Dropped]) -> list[str]:
    """A line for each kind; all of them are in the outcome's data."""
    kinds: dict[str, list[str]] = {}
    for one in dropped:
        kinds.setdefault(one.what, []).append(one.name)
    more = {kind: f", and {len(names) - SHOWN} more (--json)" for kind, names in kinds.items() if len(names) > SHOWN}
    lines = [f"  {kind}: {', '.join(names[:SHOWN])}{more.get(kind, '')}" for kind, names in kinds.items()]
    return ["Not in the scene:", *lines] if lines else []
