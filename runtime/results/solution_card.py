"""A solution in a notebook: how it ended, what it cost, how exact it is, and its coordinates as small curves."""

from __future__ import annotations

from runtime.contract.coordinates import followed
from runtime.contract.status import badge, card, line, sparkline, table
from runtime.results.samples import Samples

MOST = 10


def solution_card(solution: Samples) -> str:
    """HTML of a solution."""
    model, stats, status = solution.model, solution.stats, solution.status
    m = ",".join(map(str, solution.m)) or "-"
    wall = stats.get("wall_seconds")
    cost = f", {float(wall):.3g} s" if isinstance(wall, int | float) else ""
    balance = f", energy balance {solution.balance}" if len(solution.t) > 2 else ""
    about = f"{solution.scheme}, dt = {solution.dt:g} s, m = {m}"
    rates = {f"{name}_dot" for name in model.measures}
    names = [*followed(model)[0], *(name for name in model.measures if name not in rates)][:MOST]
    rows = [
        (
            name,
            sparkline(solution[name]),
            f"{solution[name].min():.4g} to {solution[name].max():.4g}",
            f"{solution[name][-1]:.6g}",
        )
        for name in names
    ]
    return card(
        model.title or model.name,
        about,
        line(status._repr_html_())
        if not status.ok
        else line(badge(status.name, True) + f" at t = {status.time:.6g} s"),
        line(
            f"{len(solution.t)} samples, {stats.get('steps', '?')} steps{cost}; largest constraint error "
            f"{float(solution.constraint_error.max(initial=0.0)):.2g}{balance}"
        ),
        table(rows, ("", "", "range", "at the end")),
    )
