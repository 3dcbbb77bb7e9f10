"""`symgen sweep`, `stability`, `periodic`, `converge`, `advise`: many runs of a scene."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.outcome import FAILED, INTERRUPTED, OK, Outcome, Progress, left
from symgen.cli.sources import opened_model
from symgen.cli.words import MOTION, UsageError, motion_words, settings

if TYPE_CHECKING:
    from runtime.model import Model
    from runtime.orbits.branch import PeriodicBranch
    from runtime.studies.advice.advise import Advice
    from runtime.studies.ensemble.parts import Executor
    from runtime.studies.stability.chart import StabilityChart

MOST_CASES = 10_000_000
LISTED = 12  # values in the summary of a sweep


def sweep(arguments: argparse.Namespace) -> Outcome:
    """Run a scene for many values of parameters and starts at once.

    Every combination of the values of --over is a case. With --out FILE.csv it leaves the answer, and a picture
    of the same name.
    """
    import numpy as np

    from runtime.contract.files import try_writing
    from runtime.studies.ensemble.ensemble_result import variables, write_csv
    from runtime.views.plots import ensemble_picture

    if arguments.out:
        if Path(arguments.out).suffix != ".csv":
            raise UsageError(f"--out {arguments.out}: the answer is a table, name it study.csv")
        try_writing(arguments.out)
    sampled = arguments.seen_every is not None or arguments.samples is not None
    if arguments.reduce and sampled:
        raise UsageError("--reduce and samples exclude each other: give one")
    model = opened_model(arguments.scene, arguments.made_with)
    columns = _combined(arguments.over)
    hows = [] if sampled else arguments.reduce or ["peak", "end"]
    answer = _swept(model, columns, hows, arguments)
    written = variables(answer)
    found = {name: values for name, (_, values, _) in written.items()}
    kept = [f"{name}_{how}" for name in arguments.outputs for how in hows] or arguments.outputs
    values = {name: found[name] for name in dict.fromkeys(kept)}
    files = []
    if arguments.out:
        files = [str(arguments.out), str(Path(arguments.out).with_suffix(".png"))]
        write_csv(answer, arguments.out)
        units = {name: f"{name} [{unit}]" if unit else name for name, (_, _, unit) in written.items()}
        varied = {name: one for name, one in columns.items() if np.ptp(one) > 0} or columns
        axes = {units.get(name, units.get(f"initial.{name}", name)): one for name, one in varied.items()}
        shown = {units[name]: one for name, one in values.items()}
        ensemble_picture(model.title or model.name, axes, shown, found.get("time"), Path(files[1]))
    ends, counts = np.unique(found["status"], return_counts=True)
    statuses = dict(zip(ends.tolist(), counts.tolist(), strict=True))
    finite = {name: one[np.isfinite(one)] for name, one in values.items()}
    ranges = {name: (float(one.min()), float(one.max())) for name, one in finite.items() if one.size}
    lines = [f"{model.name}: {len(found['case'])} cases, " + ", ".join(f"{n} {name}" for name, n in statuses.items())]
    lines += [f"  {name:<28} {low:>14.6g} ... {high:.6g}" for name, (low, high) in list(ranges.items())[:LISTED]]
    code = OK if set(statuses) == {"completed"} else INTERRUPTED if "interrupted" in statuses else FAILED
    data = {"scene": model.name, "cases": len(found["case"]), "status": statuses, "ranges": ranges, "files": files}
    return Outcome(data, [*lines, *left(files)], code)


def _swept(model: Model, columns: dict[str, Any], hows: list[str], arguments: argparse.Namespace) -> Any:
    """The answer of the ensemble of these columns. Raises UsageError, and what `ensemble` raises."""
    from runtime import ensemble
    from runtime.contract.errors import CompilerError

    known = {parameter.name for parameter in model.parameters}
    starts = {name: values for name, values in columns.items() if name not in known}
    _refuse_unknown(model, starts)
    how = ("scheme", "dt", "m", "options", "t_end", "start", "outputs", "seen_every", "samples", "workers", "folder")
    executor = None if arguments.processes is None else _processes(arguments.processes)
    try:
        with Progress(f"symgen {model.name}", counted="cases") as progress:
            return ensemble(
                model,
                {**arguments.parameters, **{name: columns[name] for name in columns if name in known}},
                {**arguments.initial, **starts},
                reduce=dict.fromkeys(arguments.outputs, hows) if hows else None,
                progress=progress,
                executor=executor,
                **settings(arguments, how),
            )
    except CompilerError as error:
        raise UsageError(f"{error}; an ensemble needs llvmlite") from error


def _processes(count: int) -> Callable[[], Executor]:
    """What makes a pool of so many processes. Raises UsageError."""
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    if count < 1:
        raise UsageError(f"--processes {count}: give a number of at least 1")
    return lambda: ProcessPoolExecutor(count, mp_context=get_context("spawn"))


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
    from runtime.contract.errors import ModelError

    for name in starts:
        if name.removesuffix("_dot") not in model.coordinates and name not in model.coordinates:
            offered = [parameter.name for parameter in model.parameters if parameter.kind != "data"]
            raise ModelError(
                f"--over {name}",
                f"model {model.name} has no parameter, coordinate or rate of this name",
                f"it has {', '.join([*offered, *model.coordinates])}",
            )


def stability(arguments: argparse.Namespace) -> Outcome:
    """Compute where a scheme is stable on a scene.

    The exact Jacobian of the step, along the motion: spectral radius over (dt_S, m), the largest stable step for
    each m, growth rates, resonance windows. With --out it leaves stability.csv and stability.png.
    """
    from runtime.studies.stability.chart import stability_chart

    if (arguments.dt_from is None) != (arguments.dt_to is None):
        raise UsageError("--dt-from and --dt-to belong together")
    if arguments.dt_from is not None and not 0 < arguments.dt_from < arguments.dt_to:
        raise UsageError("--dt-from must be positive and below --dt-to")
    if arguments.points < 2 or arguments.states < 1:
        raise UsageError("--points must be at least 2 and --states at least 1")
    model = opened_model(arguments.scene, arguments.made_with)
    with Progress(f"symgen {model.name}") as progress:
        chart = stability_chart(
            model,
            arguments.scheme,
            dt_range=None if arguments.dt_from is None else (arguments.dt_from, arguments.dt_to),
            progress=progress,
            **settings(arguments, ("m", "points", "states", "options", *MOTION)),
        )
    files = {}
    if arguments.out:
        folder = Path(arguments.out)
        chart.write_csv(folder / "stability.csv")
        chart.picture(folder / "stability.png")
        files = {name: str(folder / name) for name in ("stability.csv", "stability.png")}
    data = {"scene": model.name, "scheme": chart.scheme, "t_end": chart.t_end, "limits": chart.table(), "files": files}
    return Outcome(data, [*_limits(chart), *left(files)])


def periodic(arguments: argparse.Namespace) -> Outcome:
    """Find the motion that repeats, whether it is stable, and how it changes over a parameter.

    With --out it leaves motion.csv, one period of it; with --over branch.csv, branch.png and branch.html instead.
    """
    from runtime.orbits.continuation import periodic_over
    from runtime.orbits.periodic import periodic

    model = opened_model(arguments.scene, arguments.made_with)
    how = settings(arguments, ("period", "speed", "turns", "settle", "tolerance", "parts", "scheme", "parameters"))
    how["start"] = arguments.initial or None
    if arguments.flips and not arguments.over:
        raise UsageError("--flips needs --over")
    if arguments.resume and not arguments.over:
        raise UsageError("--resume needs --over")
    if arguments.over:
        name, first, last = arguments.over
        further = {"flips": arguments.flips, "resume": arguments.resume}
        with Progress(f"symgen {model.name}") as progress:
            branch = periodic_over(model, name, (first, last), progress=progress, **further, **how)
        return _branch(branch, arguments.output or [model.q_i[0]], arguments.out)
    found = periodic(model, **how)
    files = []
    if arguments.out:
        files = [str(Path(arguments.out) / "motion.csv")]
        found.solution.export(Path(files[0]))
    multipliers = [[float(one.real), float(one.imag)] for one in found.floquet.multipliers.astype(complex)]
    data = {
        "scene": model.name,
        "period": found.period,
        "state": found.state,
        "turns": found.turns,
        "stability": found.stability,
        "kind": found.floquet.kind,
        "multipliers": multipliers,
        "error": found.error.largest,
        "steps": found.steps,
        "files": files,
    }
    sizes = ", ".join(f"{abs(complex(*one)):.6g}" for one in multipliers[:6])
    lines = [
        f"{model.name}: period {found.period:.12g} s, {found.stability}",
        f"Floquet multipliers, by size: {sizes}{', ...' if len(multipliers) > 6 else ''}",
        f"measured error: {found.error.largest:.2g} of the amplitude of {found.error.of}; {found.steps} steps",
    ]
    return Outcome(data, [*lines, *found.remarks(), *left(files)])


def _branch(branch: PeriodicBranch, outputs: list[str], out: str | None) -> Outcome:
    files = []
    if out:
        files = [str(Path(out) / f"branch.{kind}") for kind in ("csv", "png", "html")]
        branch.write_csv(files[0], outputs)
        branch.picture(outputs[0], files[1])
        branch.view(files[2], outputs)
    kinds = [special for one in branch.all for special in one.specials]
    specials = [{"kind": one.kind, "value": one.value, "period": one.period} for one in kinds]
    data = {
        "scene": branch.model.name,
        "over": branch.over,
        "values": branch.values.tolist(),
        "periods": branch.periods.tolist(),
        "stability": branch.stability,
        "errors": branch.errors.tolist(),
        "specials": specials,
        "stopped": branch.stopped,
        "files": files,
    }
    errors = f"errors up to {branch.errors.max():.2g} of sizes"
    lines = [f"{branch.model.name}: {len(branch.points)} motions over {branch.over}, {errors}"]
    lines += [f"{one.kind} at {branch.over} = {one.value:.9g}" for one in kinds]
    lines += [f"stopped: {branch.stopped}"] if branch.stopped else []
    code = INTERRUPTED if branch.stopped == "interrupted" else FAILED if branch.stopped else OK
    return Outcome(data, [*lines, *left(files)], code)


def _limits(chart: StabilityChart) -> list[str]:
    lines = [
        f"{chart.model.name}, {chart.scheme}, {len(chart.states)} states over {chart.t_end:g} s",
        f"{'m':>8}  {'dt limit':>12}  {'dt_S limit':>12}  {'growth below':>13}  windows",
    ]
    for row in chart.table():
        m = ",".join(map(str, row["m"])) or "-"
        if row["dt_limit"] is None:
            limit = fine = "unstable"
        else:
            above = ">" if row["no_limit_found"] else ""
            limit, fine = f"{above}{row['dt_limit']:.5g} s", f"{above}{row['dt_S_limit']:.5g} s"
        growth = row["largest_growth_below_limit"]
        below = f"{'-':>13}" if growth is None else f"{growth:>9.3g} 1/s"
        windows = ", ".join(f"{low:.4g}-{high:.4g} s" for low, high in row["windows"]) or "-"
        lines.append(f"{m:>8}  {limit:>12}  {fine:>12}  {below}  {windows}")
        if row["dt_limit"] is None:
            smallest, fastest = row["smallest_dt"], row["growth_at_smallest_dt"]
            lines.append(
                f"{'':>8}  already dt = {smallest:.3g} s grows by {fastest:.3g} 1/s more than the motion itself"
            )
    return lines


def converge(arguments: argparse.Namespace) -> Outcome:
    """Estimate the error of the model itself, beside that of its steps.

    The scene with more shapes, other pieces, another mesh, stiffening: one of them at a time, by output. With --out it
    leaves a table.
    """
    from runtime.contract.files import try_writing
    from runtime.studies.convergence import EQUILIBRIUM, convergence

    if arguments.out:
        try_writing(arguments.out)
    outputs, hows = arguments.outputs, arguments.reduce
    if hows and not outputs:
        raise UsageError("--reduce needs --outputs NAMES")
    if hows and arguments.equilibrium:
        raise UsageError("--reduce applies to motions: remove it or --equilibrium")
    model = opened_model(arguments.scene, arguments.made_with)
    others: dict[str, Any] = {
        side: {knob: opened_model(word) for knob, word in getattr(arguments, side).items()}
        for side in ("coarser", "finer")
    }
    how = settings(arguments, ("knobs", "levels", "tolerance", "samples", *MOTION))
    with Progress(f"symgen {model.name}", counted="runs") as progress:
        found = convergence(
            model,
            dict.fromkeys(outputs, hows) if hows else outputs,
            of=EQUILIBRIUM if arguments.equilibrium else "motion",
            progress=progress,
            **others,
            **how,
        )
    files = [str(arguments.out)] if arguments.out else []
    if files:
        found.write_csv(files[0])
    return Outcome({"convergence": found.to_dict(), "files": files}, [*found.lines(), *left(files)])


def advise(arguments: argparse.Namespace) -> Outcome:
    """Find the method and step that suit a scene.

    Every method makes the whole motion with ever more steps until its error meets the tolerance; the one with the
    fewest operations is advised. With --out it leaves a picture of error against operations of every method.
    """
    from runtime.studies.advice.advice_text import advice_data, advice_lines
    from runtime.studies.advice.advise import advise

    model = opened_model(arguments.scene, arguments.made_with)
    with Progress(f"symgen {model.name}") as progress:
        how = settings(arguments, ("tolerance", "graded", *MOTION))
        advice: Advice = advise(model, note=progress.note, **how)
    files = [str(arguments.out)] if arguments.out else []
    if files:
        advice.picture(files[0])
    lines = advice_lines(advice, motion_words(arguments))
    return Outcome({"advice": advice_data(advice), "files": files}, [*left(files), *lines])


def report(arguments: argparse.Namespace) -> Outcome:
    """Compare methods on a scene: true error against time.

    Every method makes the motion with ever more steps, each of which is compared with an independent reference and
    timed. With --out it leaves methods.md, methods.csv and error_time.png.
    """
    from runtime.studies.advice.advice_text import advice_data, advice_lines
    from runtime.studies.advice.report import leave
    from runtime.studies.advice.report import report as made

    model = opened_model(arguments.scene, arguments.made_with)
    with Progress(f"symgen {model.name}") as progress:
        found: Advice = made(model, note=progress.note, **settings(arguments, ("tolerance", "graded", *MOTION)))
    files = leave(found, Path(arguments.out)) if arguments.out else {}
    lines = advice_lines(found, motion_words(arguments))
    return Outcome({"advice": advice_data(found), "files": files}, [*left(files), *lines])
