"""A run of a structure: its plan, its levels of refinement, what it leaves."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import ceil
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from runtime.contract.arguments import NAMES, NUMBERS, PLACE, WHOLE, arguments
from runtime.contract.errors import is_finite_number, shown_value
from runtime.contract.files import replacing
from runtime.contract.lazy_method import LazyMethod
from runtime.contract.status import Status
from runtime.structures.central_difference import CentralDifference
from runtime.structures.generalised_alpha import Coefficients, GeneralisedAlpha
from runtime.structures.pictures import field_picture, motion_picture, regions_picture, write_vtk
from runtime.structures.regions import Regions, checked_step, one_group
from runtime.structures.structure import Array, StructureError

if TYPE_CHECKING:
    from runtime.structures.model import StructureModel
    from runtime.structures.run_page import page as _page

ErrorWish = Literal["measured", "off"]
SCHEMES = ("printed", "single_rate", "generalized_alpha")
KEPT_BYTES = 20e6  # all coordinates are outputs below this
DEFAULT_OUTPUTS = 20  # outputs that nobody named
ENERGY_TIMES = 200  # about so many times at which the energy is taken
MOST_LEVELS = 12
MOST_FIELDS = 10_000
MOST_STRUCTURE_STEPS = 10**9  # major steps: hours for the smallest structure
ORDER = 2  # of all three methods
INACCURATE = 0.1
TINY = 1e-300
GOLDEN = 0.6180339887498949  # fields are kept at times that no period divides


class Stepper(Protocol):
    """What a scheme offers."""

    t: float

    @property
    def major_step(self) -> float:
        """The step of the slowest group [s]."""

    @property
    def x(self) -> Array:
        """Displacements (n,) [m] at t."""

    @property
    def rates(self) -> Array:
        """x' (n,) [m/s] at t."""

    def start(self, x: Array, rates: Array, t: float = 0.0) -> None:
        """Begin there."""

    def advance(self, steps: int) -> None:
        """So many major steps."""

    def near(self, t: float) -> Array:
        """x (n,) [m] at a time within half a step."""

    def energy(self) -> tuple[float, float]:
        """Kinetic and elastic energy [J] at t."""


class StructureRunError(NamedTuple):
    """How far a run is off, by half its steps: RMS over time, of the amplitude; each output, and the whole field in
    M's norm.

    order: that three levels showed, None where only two were run.
    """

    outputs: dict[str, float]
    field: float
    order: float | None

    @property
    def largest(self) -> float:
        """The largest of them, NaN where nothing was measured."""
        return max([self.field, *self.outputs.values()], default=float("nan"))

    def __str__(self) -> str:
        shown = "" if self.order is None else f", order {self.order:.1f} shown"
        return f"{self.largest:.2g} of the amplitude{shown}"


NOT_MEASURED = StructureRunError({}, float("nan"), None)


@dataclass(eq=False)
class StructureRun:
    """What a run of a structure leaves.

    Attributes
    ----------
    t : (N,) [s]
        Times of the samples.
    values : (N, outputs) [m]
        ``run["name"]`` gives a column.
    field_times : (F,) [s]; fields : (F, n) [m]
        All coordinates at some times.
    status, error, stats
        How the run ended, how far it is off, what it took.
    x, rates : (n,) [m, m/s]
        The last good state.
    energy : (N, 2) [J]
        Kinetic and elastic, at `energy_times`.
    """

    model: StructureModel
    scheme: str
    t: Array
    names: list[str]
    values: Array
    field_times: Array
    fields: Array
    energy_times: Array
    energy: Array
    x: Array
    rates: Array
    regions: Regions | None
    status: Status
    error: StructureRunError = NOT_MEASURED
    stats: dict[str, Any] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Array:
        if name not in self.names:
            self.model.structure.place(name)  # raises for a name that is not there
            raise StructureError(f"output '{name}'", "was not kept", f"run again with outputs=[..., {name!r}]")
        return self.values[:, self.names.index(name)]

    @property
    def about(self) -> str:
        """Scheme, step and ratios in a line."""
        ratios = ", ".join(map(str, self.stats.get("m", [])))
        return f"{self.scheme}, {self.stats['dt']:.3g} s{f', m = {ratios}' if ratios else ''}"

    if TYPE_CHECKING:
        page = _page
    else:

        @LazyMethod
        def page():
            from runtime.structures.run_page import page

            return page

    @arguments(path=PLACE, names=NAMES)
    def plot(self, path: str | Path | None = None, names: Sequence[str] | None = None) -> Figure:
        """Displacements of `names` over time, and the energy; by default those that move most."""
        return motion_picture(self, names, path)

    @arguments(path=PLACE, times=NUMBERS)
    def plot_fields(self, path: str | Path | None = None, times: Sequence[float] | None = None) -> Figure:
        """The deformed mesh at some times [s]; four by default."""
        return field_picture(self, times, path)

    @arguments(path=PLACE)
    def plot_regions(self, path: str | Path | None = None) -> Figure:
        """The mesh coloured by how often its nodes step."""
        if self.regions is None:
            raise StructureError("plot_regions", f"{self.scheme} has one step for all", 'take scheme="printed"')
        return regions_picture(self.model.structure, self.regions, path)

    @arguments()
    def to_vtk(self, path: str | Path) -> Path:
        """The kept fields as a time series for ParaView (XDMF), by meshio (extra `files`)."""
        return write_vtk(self, path)

    @arguments()
    def save(self, path: str | Path) -> Path:
        """Times, outputs, fields and energies as an .npz file, which `numpy.load` reads."""
        with replacing(path) as temporary:
            np.savez_compressed(
                temporary, t=self.t, names=np.array(self.names), values=self.values, field_times=self.field_times,
                fields=self.fields, energy_times=self.energy_times, energy=self.energy, x=self.x, rates=self.rates,
                status=np.array(str(self.status)),
            )  # fmt: skip
        return Path(path)

    def __repr__(self) -> str:
        return f"StructureRun({self.model.name!r}, {self.scheme}, {self.status}, error {self.error})"


class _Level(NamedTuple):
    """What a run with steps of one refinement left; index of samples is common to all levels."""

    values: Array
    fields: Array
    energy: Array
    x: Array
    rates: Array
    reached: int  # samples
    failed: str


@dataclass(frozen=True)
class _Plan:
    """steps: major steps of the first level; sampled: after how many of them samples are taken; kept: times of
    fields [s].
    """

    t_end: float
    steps: int
    sampled: NDArray[np.int64]
    weighed: NDArray[np.int64]
    kept: Array
    outputs: NDArray[np.int64]


def simulate(
    model: StructureModel,
    t_end: float,
    *,
    scheme: str,
    dt: float | None,
    m: Sequence[int] | int | None,
    groups: Mapping[str, Sequence[str] | NDArray[np.int64]] | None,
    tolerance: float | None,
    initial: Mapping[str, float] | Array | None,
    rates: Mapping[str, float] | Array | None,
    outputs: Sequence[str] | None,
    samples: int,
    fields: int,
    error: ErrorWish,
    rho_inf: float,
    progress: Callable[[float], None] | None,
) -> StructureRun:
    """See `StructureModel.simulate`."""
    began = time.perf_counter()
    _check_options(t_end, scheme, tolerance, samples, fields, error, m, groups)
    x, v = model.vector("initial", initial), model.vector("rates", rates)
    regions = (
        None
        if scheme == "generalized_alpha"
        else model.regions(groups, m)
        if scheme == "printed"
        else one_group(model._lumped("single_rate"))
    )
    longest = t_end / 1000 if regions is None else regions.steps[-1]
    if dt is not None and regions is not None:
        limits = [group.limit / times for group, times in zip(regions.groups, regions.fastest, strict=True)]
        checked_step(dt, min(*limits, model.step_limit) * regions.fastest[-1], "dt")
    else:
        checked_step(dt, np.inf, "dt")
    if t_end / (dt or longest) > MOST_STRUCTURE_STEPS:
        raise StructureError(
            "t_end", f"{t_end:g} s are more than {MOST_STRUCTURE_STEPS:.0e} steps of {dt or longest:.3g} s", "lower it"
        )
    first = ceil(t_end / (dt or longest) * (1 - 1e-12))
    samples = min(samples, first)  # they are taken at steps
    plan = _planned(t_end, first, samples, fields, _chosen_outputs(model, outputs, samples))

    def level(refined: int, share: tuple[float, float]) -> _Level:
        major = t_end / (plan.steps * refined)
        stepper: Stepper = (
            GeneralisedAlpha(model.structure, major, Coefficients.of(rho_inf))
            if regions is None
            else CentralDifference(model.structure, regions.with_step(major / regions.fastest[-1]))
        )
        stepper.start(x, v)
        return _stepped(stepper, plan, refined, progress, share)

    levels, refined = [level(1, (0.0, 1.0 if error == "off" else 1 / 3))], 1
    found = NOT_MEASURED
    while error == "measured" and not levels[-1].failed and len(levels) < MOST_LEVELS:
        levels.append(level(2 * refined, (1 / 3, 1.0)))
        if levels[-1].failed:
            break
        found = _measured(levels, plan, [model.names[k] for k in plan.outputs], model.structure.mass)
        wanted = float("inf") if tolerance is None else tolerance
        finer = _scaled(found, 1 / (2**ORDER - 1))
        coarser = _scaled(found, 2**ORDER / (2**ORDER - 1))
        if coarser.largest <= wanted:
            levels, found = levels[:-1], coarser
            break
        if finer.largest <= wanted:
            found, refined = finer, 2 * refined
            break
        refined, found = 2 * refined, finer
    major = t_end / (plan.steps * refined)
    return _left(model, scheme, plan, regions, levels[-1], t_end, major, found, tolerance, time.perf_counter() - began)


def _check_options(
    t_end: float, scheme: str, tolerance: float | None, samples: int, fields: int, error: str, m: Any, groups: Any
) -> None:
    if scheme not in SCHEMES:
        raise StructureError("scheme", f"{scheme!r} does not step a structure", f"give one of {', '.join(SCHEMES)}")
    if not is_finite_number(t_end) or t_end <= 0:
        raise StructureError("t_end", f"{shown_value(t_end)} s", "give a positive time")
    if tolerance is not None and not (np.isfinite(tolerance) and tolerance > 0):
        raise StructureError("tolerance", f"{tolerance!r}", "give a positive number, such as 1e-3")
    if error not in ("measured", "off"):
        raise StructureError("error", f"{error!r}", 'give "measured" or "off"')
    if error == "off" and tolerance is not None:
        raise StructureError("error", "a tolerance needs a measured error", 'leave error out, or give a step "dt"')
    for item, count, least in (("samples", samples, 1), ("fields", fields, 2)):
        if not WHOLE.holds(count) or count < least:
            raise StructureError(item, shown_value(count), f"give a whole number from {least}")
    if fields > MOST_FIELDS:
        raise StructureError("fields", f"{fields} would take all memory", f"give at most {MOST_FIELDS}")
    if scheme != "printed" and (m is not None or groups is not None):
        raise StructureError("m and groups", f"{scheme} has one step for all", 'take scheme="printed"')


def _chosen_outputs(model: StructureModel, outputs: Sequence[str] | None, samples: int) -> NDArray[np.int64]:
    structure = model.structure
    if outputs is not None:
        if isinstance(outputs, str):
            raise StructureError("outputs", f"{outputs!r} is one text", "give a list of names")
        return np.array([structure.place(name) for name in outputs], dtype=np.int64)
    if structure.size * (samples + 1) * 8 <= KEPT_BYTES:
        return np.arange(structure.size)
    loaded = [np.flatnonzero(load.pattern)[:DEFAULT_OUTPUTS] for load in structure.loads]
    spread = np.linspace(0, structure.size - 1, DEFAULT_OUTPUTS).astype(np.int64)
    return np.unique(np.concatenate([*loaded, spread])).astype(np.int64)


def _planned(t_end: float, steps: int, samples: int, fields: int, outputs: NDArray[np.int64]) -> _Plan:
    sampled = np.unique(np.round(np.linspace(0, steps, samples + 1)).astype(np.int64))
    marks = (
        np.arange(fields) + (np.arange(fields) * GOLDEN) % 1.0
    ) / fields  # one in each slice, at no regular distance
    weighed = sampled[:: max(1, len(sampled) // ENERGY_TIMES)]
    return _Plan(t_end, steps, sampled, weighed, np.append(t_end * marks, t_end), outputs)


def _stepped(
    stepper: Stepper, plan: _Plan, refined: int, progress: Callable[[float], None] | None, share: tuple[float, float]
) -> _Level:
    """Step to the end; samples are taken at steps, fields at their times by the motion about the nearest step."""
    values, fields, energy, failed, at = [], [], [], "", 0
    x, rates, steps = stepper.x.copy(), stepper.rates.copy(), plan.steps * refined
    sampled, weighed = set((plan.sampled * refined).tolist()), set((plan.weighed * refined).tolist())
    kept: dict[int, list[float]] = {}
    for t in plan.kept.tolist():
        kept.setdefault(round(t / plan.t_end * steps), []).append(t)
    try:
        for stop in sorted(sampled | weighed | kept.keys()):
            stepper.advance(stop - at)
            at, now = stop, stepper.x
            if not np.all(np.isfinite(now)):
                failed = "not_finite"
                break
            if stop in sampled:
                values.append(now[plan.outputs])
            if stop in weighed:
                energy.append(stepper.energy())
            for t in kept.get(stop, ()):
                fields.append(stepper.near(t))
            x = now
            if progress is not None:
                progress(share[0] + (share[1] - share[0]) * stop / steps)
        rates = stepper.rates if not failed else rates
    except KeyboardInterrupt:
        failed = "interrupted"
    return _Level(
        np.array(values), np.array(fields), np.array(energy), np.array(x), np.array(rates), len(values), failed
    )


def _differences(one: _Level, other: _Level, names: list[str], mass: Any) -> StructureRunError:
    """Root mean squares of the difference over those of the finer level; fields in the norm of M.

    An output is judged by its own amplitude, one that moves less than the structure as a whole by the structure's.
    """
    weights = mass if isinstance(mass, np.ndarray) else mass.diagonal()
    apart = np.sqrt((np.square(other.fields - one.fields) * weights).sum(axis=1))
    size = np.sqrt((np.square(other.fields) * weights).sum(axis=1))
    field_error = float(np.sqrt(np.mean(apart**2)) / max(np.sqrt(np.mean(size**2)), TINY))
    whole = float(np.sqrt(np.mean(size**2) / weights.sum()))
    gap = np.sqrt(np.mean(np.square(other.values - one.values), axis=0))
    spread = np.sqrt(np.mean(np.square(other.values - other.values.mean(axis=0)), axis=0))
    found = {name: float(g / max(s, whole, TINY)) for name, g, s in zip(names, gap, spread, strict=True)}
    return StructureRunError(found, field_error, None)


def _measured(levels: list[_Level], plan: _Plan, names: list[str], mass: Any) -> StructureRunError:
    found = _differences(levels[-2], levels[-1], names, mass)
    if len(levels) < 3:
        return found
    before = _differences(levels[-3], levels[-2], names, mass)
    return found._replace(
        order=float(np.log2(before.field / found.field)) if found.field > 0 and before.field > 0 else None
    )


def _scaled(error: StructureRunError, factor: float) -> StructureRunError:
    return StructureRunError(
        {name: factor * value for name, value in error.outputs.items()}, factor * error.field, error.order
    )


def _left(
    model: StructureModel, scheme: str, plan: _Plan, regions: Regions | None, level: _Level, t_end: float, major:
    float, error: StructureRunError, tolerance: float | None, seconds: float,
) -> StructureRun:  # fmt: skip
    t = t_end * plan.sampled[: level.reached] / plan.steps
    kept, weighed = plan.kept[: len(level.fields)], t_end * plan.weighed[: len(level.energy)] / plan.steps
    last = float(t[-1]) if len(t) else 0.0
    fine = None if regions is None else regions.with_step(major / regions.fastest[-1])
    stats: dict[str, Any] = {"steps": round(t_end / major), "dt": major, "wall_seconds": seconds}
    if fine is not None:
        stats |= {
            "small_steps": round(t_end / fine.step),
            "groups": [len(group.nodes) for group in fine.groups],
            "m": [group.sub_steps for group in fine.groups[:0:-1]],
            "share_of_operations": fine.share,
        }
    return StructureRun(
        model, scheme, t, [model.names[k] for k in plan.outputs], level.values, kept, level.fields, weighed,
        level.energy, level.x, level.rates, fine, _status(level, last, error, tolerance), error, stats,
    )  # fmt: skip


def _status(level: _Level, last: float, error: StructureRunError, tolerance: float | None) -> Status:
    if level.failed == "interrupted":
        return Status("interrupted", last, None, "stopped by the user", "results up to here are kept")
    if level.failed:
        return Status(
            "not_finite",
            last,
            None,
            "the motion is no longer a number: the step grows",
            "see model.stability(); take a shorter dt",
        )
    if tolerance is not None and not error.largest <= tolerance:
        cause = f"the measured error is {error.largest:.2g} where {tolerance:g} was asked for"
        return Status("inaccurate", last, None, cause, "ask for less, or for a shorter motion")
    if error.largest > INACCURATE:
        cause = f"steps of this length are off by {error.largest:.2g} of the amplitude"
        return Status("inaccurate", last, None, cause, "give a tolerance, or a shorter dt")
    return Status("completed", last)
