"""The impacts of a run as a table: on rigid stops by what their events say, on compliant ones by the saved samples.

A rigid impact gives an impulse at one time. A compliant stop, teeth with play and a contact press for a while: from
samples (N,) of their force F and of the velocity v along it, by cubic splines through them,

    impulse = integral of |F| dt,    energy lost = -integral of F v dt,

since what a compliant stop stores is zero before and after. Both are as good as the samples are close.
"""

from __future__ import annotations

import csv
from collections.abc import Iterator
from dataclasses import asdict, dataclass, fields
from pathlib import Path

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.model import EmittedModel
from runtime.results.samples import Samples

LEAST_SAMPLES = 8  # of a contact: fewer say nothing of its impulse
PAIRS = {  # measures of a force and of the velocity along it
    ".stop_force": ".stop_velocity",
    ".backlash_force": ".backlash_velocity",
    ".normal_force": ".normal_velocity",
}


@dataclass(frozen=True)
class ImpactRecord:
    """time at which it begins [s]; where: `rail.limits.lower` of a rigid stop, `rail.stop` of compliant ones,
    `mesh.backlash`, `touch.contact`; side: 1 where it pushes along the coordinate, or apart, else -1.

    speed_before, with which it is met, and speed_after, with which it is left [m/s or rad/s]; impulse [N s or N m s]
    and energy_lost [J], NaN where too few samples lie in a contact; duration [s], zero of rigid stops; unit: that of
    the speeds.
    """

    time: float
    where: str
    side: int
    speed_before: float
    speed_after: float
    impulse: float
    energy_lost: float
    duration: float
    unit: str


@dataclass(frozen=True, repr=False)
class Impacts:
    """The impacts of a run in the order of time; iterate over them, or take `columns`."""

    records: tuple[ImpactRecord, ...]

    def __len__(self) -> int:
        return len(self.records)

    def __iter__(self) -> Iterator[ImpactRecord]:
        return iter(self.records)

    def __getitem__(self, k: int) -> ImpactRecord:
        return self.records[k]

    @property
    def columns(self) -> dict[str, np.ndarray]:
        """(k,) of each field by its name, as `pandas.DataFrame` takes them."""
        return {one.name: np.array([getattr(row, one.name) for row in self.records]) for one in fields(ImpactRecord)}

    def write_csv(self, path: str | Path) -> None:
        """Write the table to a CSV file.

        Parameters
        ----------
        path : str or Path
            The file, which is replaced where there is one.
        """
        with Path(path).open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, [one.name for one in fields(ImpactRecord)])
            writer.writeheader()
            writer.writerows(asdict(one) for one in self.records)

    def __repr__(self) -> str:
        lost = float(np.nansum([one.energy_lost for one in self.records])) if self.records else 0.0
        return f"<{len(self)} impact{'' if len(self) == 1 else 's'}, {lost:.6g} J lost>"


@arguments()
def impacts(solution: Samples) -> Impacts:
    """Return the impacts of a run: on rigid and compliant stops, of teeth with play, and of contacts.

    Parameters
    ----------
    solution : Solution
        N samples.

    Returns
    -------
    Impacts
        Time, place, speeds before and after with their unit, impulse and energy lost of each.

    Notes
    -----
    Those on rigid stops are located by events and exact. Those of compliant parts are read off the samples: save often
    enough (`seen_every`) that several lie in a contact. One that is under way at the first or last sample is left out.
    """
    found = _on_rigid_stops(solution)
    units = {one.name: one.unit for one in solution.model.description.measures}
    for name, velocity in compliant(solution.model).items():
        force, v = (solution.measures[:, solution.model.measures.index(one)] for one in (name, velocity))
        where = name.removesuffix("_force").replace(".normal", ".contact")
        found += _of_samples(solution.t, force, v, where, units[velocity])
    return Impacts(tuple(sorted(found, key=lambda one: one.time)))


def _on_rigid_stops(solution: Samples) -> list[ImpactRecord]:
    """From the events of the run."""
    sides = {event.name: event.side for event in solution.model.mode_events}
    slides = tuple(f"{joint.name}." for joint in solution.model.description.joints if joint.drawing == "slide")
    return [
        ImpactRecord(
            time=one.time, where=one.name, side=sides.get(one.name, 1), speed_before=-one.before, speed_after=one.after,
            impulse=one.impulse, energy_lost=one.energy_lost, duration=0.0,
            unit="m/s" if one.name.startswith(slides) else "rad/s",
        )
        for one in solution.events
        if one.kind == "impact"
    ]  # fmt: skip


def compliant(model: EmittedModel) -> dict[str, str]:
    """Measures of forces that push and never pull, with those of the velocities along them."""
    ends = {name: end for name in model.measures for end in PAIRS if name.endswith(end)}
    pairs = {name: name.removesuffix(end) + PAIRS[end] for name, end in ends.items()}
    return {name: velocity for name, velocity in pairs.items() if velocity in model.measures}


def _of_samples(
    t: np.ndarray, force: np.ndarray, velocity: np.ndarray, where: str, unit: str
) -> Iterator[ImpactRecord]:
    """Each stretch of samples with a force of one sign, between samples without."""
    sign = np.sign(force)
    starts = np.flatnonzero((sign[1:] != sign[:-1]) & (sign[1:] != 0)) + 1
    for first in starts.tolist():
        stretch = sign[first:] == sign[first]
        last = first + (int(stretch.argmin()) if not stretch.all() else len(stretch)) - 1
        if last + 1 >= len(t):
            continue
        own, side = slice(first, last + 1), float(sign[first])
        begin = _edge(t, force, first, -1)
        end = _edge(t, force, last, 1)
        before = -side * _free(t, velocity, sign, first - 1, -1, begin)
        after = side * _free(t, velocity, sign, last + 1, 1, end)
        impulse = lost = np.nan
        if last - first + 1 >= LEAST_SAMPLES:
            pressed = np.abs(force[own])
            impulse, lost = (_integral(begin, t[own], one, end) for one in (pressed, -pressed * side * velocity[own]))
        yield ImpactRecord(begin, where, int(side), before, after, impulse, lost, end - begin, unit)


def _integral(begin: float, t: np.ndarray, values: np.ndarray, end: float) -> float:
    """Of values (n,) at times between two at which they are zero."""
    from scipy.interpolate import CubicSpline

    inside = (t > begin) & (t < end)
    times = np.concatenate([[begin], t[inside], [end]])
    return float(CubicSpline(times, np.concatenate([[0.0], values[inside], [0.0]])).integrate(begin, end))


def _edge(t: np.ndarray, force: np.ndarray, k: int, way: int) -> float:
    """The time [s] at which the force is zero beside sample k, on the line through it and the next one inside."""
    outside, inside = float(t[k + way]), k - way
    if 0 <= inside < len(t) and force[inside] * force[k] > 0 and abs(force[inside]) > abs(force[k]):
        found = float(t[k] - force[k] * (t[inside] - t[k]) / (force[inside] - force[k]))
        return min(max(found, min(outside, float(t[k]))), max(outside, float(t[k])))
    return (outside + float(t[k])) / 2


def _free(t: np.ndarray, velocity: np.ndarray, sign: np.ndarray, k: int, way: int, at: float) -> float:
    """The velocity at the edge of a contact, on the line through two samples outside of it."""
    other = k + way
    if not 0 <= other < len(t) or sign[k] != 0 or sign[other] != 0:
        return float(velocity[k])
    slope = (velocity[k] - velocity[other]) / (t[k] - t[other])
    return float(velocity[k] + slope * (at - t[k]))
