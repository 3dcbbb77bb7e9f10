"""What a simulation leaves, with the files that it can be kept in."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.arguments import MODEL, arguments
from runtime.contract.cards import badge, card, line, sparkline, table
from runtime.contract.coordinates import followed
from runtime.contract.lazy_method import LazyMethod
from runtime.contract.model import EmittedModel
from runtime.results.samples import Samples

if TYPE_CHECKING:
    from runtime.results.body_motion import body_motion as _body_motion
    from runtime.results.dataset import to_xarray as _to_xarray
    from runtime.results.deflections import deflections as _deflections
    from runtime.results.export import columns as _columns
    from runtime.results.export import export as _export
    from runtime.results.export import write_npz as _write_npz
    from runtime.results.friction import joint_friction as _joint_friction
    from runtime.results.friction import joint_stop as _joint_stop
    from runtime.results.impacts import impacts as _impacts
    from runtime.results.section_forces import section_forces as _section_forces
    from runtime.results.stresses import beam_stresses as _beam_stresses
    from runtime.results.stresses import stresses as _stresses
    from runtime.views.animation import animate as _animate
    from runtime.views.plots import coordinates as _coordinates
    from runtime.views.report import run_report as _run_report
    from runtime.views.run_page import page as _page
    from runtime.views.viewer.page import show as _show

MOST_SHOWN_COORDINATES = 10  # coordinates that a notebook shows


def solution_card(solution: Samples) -> str:
    """HTML of a solution: how it ended, what it cost, how exact it is, and its coordinates as small curves."""
    model, stats, status = solution.model, solution.stats, solution.status
    m = ",".join(map(str, solution.m)) or "-"
    wall = stats.get("wall_seconds")
    cost = f", {float(wall):.3g} s" if isinstance(wall, int | float) else ""
    steps = f", {stats['steps']} steps" if "steps" in stats else ""
    balance = f", energy balance {solution.balance}" if len(solution.t) > 2 else ""
    about = f"{solution.scheme}, {solution.pace}, m = {m}"
    rates = {f"{name}_dot" for name in model.measures}
    names = [*followed(model)[0], *(name for name in model.measures if name not in rates)][:MOST_SHOWN_COORDINATES]
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
        line(status._repr_html_()) if not status.ok else line(badge(status.name, True), f" at t = {status.time:.6g} s"),
        line(
            f"{len(solution.t)} samples{steps}{cost}; largest constraint error "
            f"{float(solution.constraint_error.max(initial=0.0)):.2g}{balance}"
        ),
        table(rows, ("", "", "range", "at the end")),
    )


@dataclass(repr=False)
class Solution(Samples):
    """The result of a run: samples of the motion, how it ended, how far it is off, and what can be made of them.

    status, error, events, balance, stats: how it went. t (N,) [s]; q, q_dot, q_ddot (N, n) [m, rad; per s, s^2];
    `run["name"]` (N,): any column. joint_force, load_force, motor, friction, stop, impacts, section_forces,
    stresses, beam_stresses; view, plot, page, ...
    """

    # Each of these is the function that it names, with the solution as its first argument.
    if TYPE_CHECKING:
        view = _show
        plot = _coordinates
        animate = _animate
        report = _run_report
        page = _page
        section_forces = _section_forces
        deflections = _deflections
        stresses = _stresses
        beam_stresses = _beam_stresses
        friction = _joint_friction
        stop = _joint_stop
        impacts = _impacts
        body_motion = _body_motion
        save = _write_npz
        export = _export
        columns = _columns
        to_xarray = _to_xarray
    else:

        @LazyMethod
        def view():
            from runtime.views.viewer.page import show

            return show

        @LazyMethod
        def plot():
            from runtime.views.plots import coordinates

            return coordinates

        @LazyMethod
        def animate():
            from runtime.views.animation import animate

            return animate

        @LazyMethod
        def report():
            from runtime.views.report import run_report

            return run_report

        @LazyMethod
        def page():
            from runtime.views.run_page import page

            return page

        @LazyMethod
        def section_forces():
            from runtime.results.section_forces import section_forces

            return section_forces

        @LazyMethod
        def deflections():
            from runtime.results.deflections import deflections

            return deflections

        @LazyMethod
        def stresses():
            from runtime.results.stresses import stresses

            return stresses

        @LazyMethod
        def beam_stresses():
            from runtime.results.stresses import beam_stresses

            return beam_stresses

        @LazyMethod
        def friction():
            from runtime.results.friction import joint_friction

            return joint_friction

        @LazyMethod
        def stop():
            from runtime.results.friction import joint_stop

            return joint_stop

        @LazyMethod
        def impacts():
            from runtime.results.impacts import impacts

            return impacts

        @LazyMethod
        def body_motion():
            from runtime.results.body_motion import body_motion

            return body_motion

        @LazyMethod
        def save():
            from runtime.results.export import write_npz

            return write_npz

        @LazyMethod
        def export():
            from runtime.results.export import export

            return export

        @LazyMethod
        def columns():
            from runtime.results.export import columns

            return columns

        @LazyMethod
        def to_xarray():
            from runtime.results.dataset import to_xarray

            return to_xarray

    @arguments()
    def __getitem__(self, name: str) -> np.ndarray:
        """Column (N,) by name: a coordinate, its rate or acceleration (`_dot`, `_ddot`), a measure, or one of the CSV.

        Columns of the CSV: `t`, `J1.force_x`, `load.motor.moment`, `lam.J1.x`, `energy.kinetic`, `measure.tip`, with
        their unit in brackets or without. Raises ModelError for an unknown name.
        """
        name = name.partition(" [")[0]
        if not self.is_sampled(name):
            from runtime.results.export import columns

            table = columns(self)
            if name in table:
                return table[name]
        return super().__getitem__(name)

    def _repr_html_(self) -> str:
        return solution_card(self)

    @classmethod
    @arguments(model=MODEL)
    def load(cls, path: str | Path, model: EmittedModel | None = None) -> Solution:
        """Read a solution that `save` wrote, or the folder of a stream.

        Parameters
        ----------
        path : str or Path
            The .npz file or the folder.
        model : Model, optional
            The model that made it; without it the solution has no functions.

        Returns
        -------
        Solution
            The samples, how the run ended and its figures.

        Raises
        ------
        OutputError
            For a file that is not a saved solution, or is damaged.
        ModelError
            For a solution of another model.

        Notes
        -----
        A stream of chosen outputs is read by `runtime.results.stream.read_blocks`.
        """
        from runtime.results.export import read_npz, read_stream

        read = read_stream if Path(path).is_dir() else read_npz
        return cls(**read(path, model))
