"""What a simulation leaves, with the files that it can be kept in."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from runtime.contract.arguments import Door, opened
from runtime.contract.coordinates import followed
from runtime.contract.model import Model
from runtime.contract.status import badge, card, line, sparkline, table
from runtime.results.samples import Samples

MOST = 10  # coordinates that a notebook shows


def solution_card(solution: Samples) -> str:
    """HTML of a solution: how it ended, what it cost, how exact it is, and its coordinates as small curves."""
    model, stats, status = solution.model, solution.stats, solution.status
    m = ",".join(map(str, solution.m)) or "-"
    wall = stats.get("wall_seconds")
    cost = f", {float(wall):.3g} s" if isinstance(wall, int | float) else ""
    balance = f", energy balance {solution.balance}" if len(solution.t) > 2 else ""
    about = f"{solution.scheme}, {solution.pace}, m = {m}"
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


@dataclass(repr=False)
class Solution(Samples):
    """The result of a run: samples of the motion, how it ended, how far it is off, and what can be made of them.

    status, error, events, balance, stats: how it went. t (N,) [s]; q, q_dot, q_ddot (N, n) [m, rad; per s, s^2];
    `run["name"]` (N,): any column. joint_force, load_force, motor, friction, section_forces, stresses; view, plot, ...
    """

    view = Door("runtime.views.viewer.page:show")
    plot = Door("runtime.views.plots:coordinates")
    animate = Door("runtime.views.animation:animate")
    report = Door("runtime.views.report:run_report")
    section_forces = Door("runtime.results.section_forces:section_forces")
    deflections = Door("runtime.results.deflections:deflections")
    stresses = Door("runtime.results.stresses:stresses")
    friction = Door("runtime.results.friction:joint_friction")
    stop = Door("runtime.results.friction:joint_stop")
    body_motion = Door("runtime.results.body_motion:body_motion")
    save = Door("runtime.results.export:write_npz")
    export = Door("runtime.results.export:export")
    columns = Door("runtime.results.export:columns")

    def _repr_html_(self) -> str:
        return solution_card(self)

    @classmethod
    def load(cls, path: str | Path, model: Model | None = None) -> Solution:
        """Read a solution that `save` wrote, or the folder of a stream; without `model` it has no functions.

        A stream of chosen outputs is read by runtime.results.stream.read_blocks instead. Raises OutputError if the
        file is not a saved solution or is damaged, ModelError if it belongs to another model.
        """
        read = opened(f"runtime.results.export:{'read_stream' if Path(path).is_dir() else 'read_npz'}")
        return cls(**read(path, model))
