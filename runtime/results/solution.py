"""What a simulation leaves, with the files that it can be kept in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from runtime.contract.coordinates import followed
from runtime.contract.doors import Door
from runtime.contract.flexible import BodyMotion
from runtime.contract.model import Model
from runtime.contract.status import badge, card, line, sparkline, table
from runtime.results import export
from runtime.results.body_motion import body_motion
from runtime.results.samples import Samples
from runtime.results.section_forces import SectionForces, Way, section_forces
from runtime.results.stresses import Stresses, StressWay, stresses

if TYPE_CHECKING:
    import xarray


# ---- A solution in a notebook: how it ended, what it cost, how exact it is, and its coordinates as small
# curves.

MOST = 10


def solution_card(solution: Samples) -> str:
    """HTML of a solution."""
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
    """Samples that can be saved, loaded, exported and looked at."""

    # What is made of a solution: each is the function that it names, with the solution as its first argument.
    view = Door("runtime.views.viewer.page:show")
    plot = Door("runtime.views.plots:coordinates")
    animate = Door("runtime.views.animation:animate")
    report = Door("runtime.views.report:run_report")

    def _repr_html_(self) -> str:
        return solution_card(self)

    def save(self, path: str | Path) -> None:
        """Everything in one .npz file of plain arrays (no pickle). Raises OutputError if it cannot be written."""
        export.write_npz(self, path)

    @classmethod
    def load(cls, path: str | Path, model: Model | None = None) -> Solution:
        """Read what `save` wrote, or the folder of a stream. Without `model` there are names, but no functions.

        A stream of chosen outputs is read by runtime.results.stream.read_blocks instead. Raises OutputError if the
        file is not a saved solution or is damaged, ModelError if it belongs to another model.
        """

        return cls(**(export.read_stream(path, model) if Path(path).is_dir() else export.read_npz(path, model)))

    def section_forces(
        self, body: str, at: float | Sequence[float] | None = None, way: Way = "equilibrium"
    ) -> SectionForces:
        """Normal and shear forces, torque and bending moments of a beam at fractions `at` of its length.

        way: "equilibrium" of the part beyond each section (mode acceleration with inertia relief), or "modes", the sum
        of modal forces. at: 33 sections if left out. Errors as of runtime.results.section_forces.section_forces.
        """
        return section_forces(self, body, at, way)

    def stresses(self, body: str, way: StressWay = "equilibrium") -> Stresses:
        """Stress components and von Mises stress of a finite-element body at the gauges of the scene.

        way: "equilibrium" of all forces on it (mode acceleration with inertia relief), or "modes", the sum of modal
        stresses. Errors as of runtime.results.stresses.stresses.
        """
        return stresses(self, body, way)

    def body_motion(self, body: str) -> BodyMotion:
        """Motion of a flexible body in space and the forces at its markers, for `FlexibleBody.equilibrium_stresses()`.

        Raises ModelError as runtime.results.body_motion.body_motion.
        """
        return body_motion(self, body)

    def export(self, path: str | Path) -> None:
        """One row a sample with names and units, as .csv, .mat (MATLAB), .parquet or .nc (NetCDF) by the name's end.

        Of the outputs if only those were kept. Raises ModelError for another ending, ImportError naming the extra that
        is missing (`parquet`, `netcdf`), or OutputError.
        """
        export.export(self, path)

    def to_xarray(self) -> xarray.Dataset:
        """A labelled Dataset with units. Raises ImportError naming the extra `netcdf` if xarray is missing."""

        return export.to_xarray(self)
