"""`symgen stability`: where a scheme is stable on a scene."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.arguments import UsageError, add_command, add_motion_options, add_scene, number, option, ratios
from symgen.cli.outcome import Outcome
from symgen.cli.progress import Progress

if TYPE_CHECKING:
    from runtime.studies.stability.chart import StabilityChart


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "stability",
        run,
        "Compute where a scheme is stable on a scene.",
        "The exact Jacobian of the step, along the motion: spectral radius over (dt_S, m), the largest stable step for "
        "each m, growth rates, resonance windows. With --out it leaves stability.csv and stability.png.",
    )
    add_scene(command)
    command.add_argument("--scheme", help="time stepping scheme (default: the scene's)")
    command.add_argument("--m", action="append", type=ratios, metavar="10,4", help="ratios to look at; may be repeated")
    command.add_argument("--dt-from", type=number, metavar="SECONDS", help="smallest step of the fastest group")
    command.add_argument("--dt-to", type=number, metavar="SECONDS", help="largest step of the fastest group")
    command.add_argument("--points", type=int, default=20, help="steps to look at for each m (default: %(default)s)")
    command.add_argument("--states", type=int, default=16, help="states along the motion (default: %(default)s)")
    command.add_argument(
        "--option",
        action="append",
        type=option,
        default=[],
        metavar="NAME=VALUE",
        help="an option of the scheme; may be repeated",
    )
    command.add_argument("--out", metavar="DIR", help="folder for stability.csv and stability.png")
    add_motion_options(command)


def run(arguments: argparse.Namespace) -> Outcome:
    """The chart as a table."""
    from runtime.studies.stability.chart import stability_chart
    from runtime.studies.stability.picture import stability_picture
    from symgen.cli.sources import opened_model

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
            m=arguments.m,
            points=arguments.points,
            states=arguments.states,
            dt_range=None if arguments.dt_from is None else (arguments.dt_from, arguments.dt_to),
            options=dict(arguments.option),
            t_end=arguments.t_end,
            parameters=dict(arguments.set),
            initial=dict(arguments.initial),
            start=arguments.start,
            progress=progress,
        )
    files = {}
    if arguments.out:
        folder = Path(arguments.out)
        chart.write_csv(folder / "stability.csv")
        stability_picture(chart, folder / "stability.png")
        files = {name: str(folder / name) for name in ("stability.csv", "stability.png")}
    data = {"scene": model.name, "scheme": chart.scheme, "t_end": chart.t_end, "limits": chart.table(), "files": files}
    return Outcome(data, _lines(chart, files))


def _lines(chart: StabilityChart, files: dict[str, str]) -> list[str]:
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
    return lines + [f"left {path}" for path in files.values()]
