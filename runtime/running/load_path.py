"""Loads that act in a short part of the way, which no step may see: forces along the path that a motion took.

Between the ends of its steps the path is a cubic by positions and rates, each coordinate for itself: loops need not
close, loads do not ask. So forces become functions of time, of which parts that act for a short time are looked for
as in those of time alone.
"""

from __future__ import annotations

from typing import NamedTuple

import casadi as ca
import numpy as np

from runtime.contract.coordinates import whole
from runtime.contract.model import EmittedModel
from runtime.contract.status import Event
from runtime.engine.rows import ManyPoints, evaluate
from runtime.running.run import Run
from runtime.running.time_functions import LARGEST_LOAD, short_spans
from runtime.schemes.stage_equations import is_long_tree

PATH_PLACES = 4096  # of the path
MOST_PATH_STEPS = 4 * PATH_PLACES  # of a motion: more see what two places see
RESTS = 1e-6  # m or rad: who moves no farther goes no way, and rates by differences are rounding
CHANGES = 1e-6  # of its largest value: a force that changes by less is constant
FEWEST = 1000  # samples, of more steps
MOST_NODES = 10_000  # of the forces: more take longer than a first motion


class ShortLoad(NamedTuple):
    """The load on a coordinate of q_i acts from one time to another [s]."""

    coordinate: str
    start: float
    end: float

    @property
    def event(self) -> Event:
        """In words."""
        text = (
            f"the load on {self.coordinate} acts on a short part of the way, from t = {self.start:.6g} to "
            f"{self.end:.6g} s, which steps may pass by; take a tolerance, or a smaller step"
        )
        return Event(self.start, "load_missed", text)


def short_loads(run: Run, steps: float) -> list[ShortLoad]:
    """What acts in less than so many steps of a run along the way of its samples in memory, where no step ends for it.

    None of a model without measures, whose loads are smooth in the motion, nor of long trees and orientations in
    charts.
    """
    model, c = run.segment.model, run.segment.c[: run.segment.model.c_size]
    described = model.description
    if not described.measures or is_long_tree(model) or described.orientations or not model.has("condensed"):
        return []
    plan = run.segment.plan
    if plan.scheme.adaptive or plan.steps > MOST_PATH_STEPS or plan.outputs:
        return []
    t, moved = _motion(run)
    if 2 * len(t) < min(plan.steps, FEWEST):  # samples too far apart tell no way
        return []
    q = moved[:, : len(model.coordinates)]
    if (np.ptp(q, axis=0) <= RESTS * (1 + np.abs(q).max(axis=0))).all():
        return []
    function = _force_of_motion(model, c)
    if function.n_nodes() > MOST_NODES:
        return []
    times = np.linspace(t[0], t[-1], PATH_PLACES + 1)
    forces = ManyPoints(function)(np.column_stack([_path(t, moved, times), times])).T
    if not (np.abs(forces) < LARGEST_LOAD).all():
        return []
    kinks = (event.time for event in run.events if event.kind == "kink")
    ends = np.array([*(one.time for one in run.segment.switches), *kinks])
    found = [
        ShortLoad(model.q_i[k], float(times[first]), float(times[last]))
        for k, row in enumerate(forces)
        if np.ptp(row) > CHANGES * np.abs(row).max()
        for first, last in short_spans(row)
    ]
    return [
        one
        for one in found
        if one.end - one.start < steps * plan.grid.dt_L and not ((one.start <= ends) & (ends <= one.end)).any()
    ]


def _motion(run: Run) -> tuple[np.ndarray, np.ndarray]:
    """t (N,) and [q, q_dot] (N, 2 n) of the samples."""
    times, moved = [np.zeros(0)], [np.zeros((0, 2 * len(run.segment.model.coordinates)))]
    for own, rows in run.record.samples:
        segment = run.record.segments[own]
        scheme = segment.plan.scheme
        states = rows[:, : scheme.layout.size]
        observed = evaluate(scheme.observer, {"z": states}, scheme.constants(segment.c))
        parts = [whole(segment.model, observed[f"q_i{rate}"], observed[f"q_d{rate}"]) for rate in ("", "_dot")]
        times.append(observed["t"].ravel())
        moved.append(np.hstack(parts))
    t, values = np.concatenate(times), np.concatenate(moved)
    once = np.append(True, np.diff(t) > 0)[: len(t)]
    return t[once], values[once]


def _force_of_motion(model: EmittedModel, c: np.ndarray) -> ca.Function:
    """[q, q_dot, t] -> Q_hat (n_i,)."""
    n = len(model.coordinates)
    moved, t = ca.SX.sym("moved", 2 * n), ca.SX.sym("t")
    q, q_dot = moved[:n], moved[n:]
    columns = model.independent_columns.tolist(), model.dependent_columns.tolist()
    values = {"q": q, "q_dot": q_dot, "c": ca.SX(ca.DM(c)), "t": t}
    for own, name in zip(columns, ("i", "d"), strict=True):
        values |= {f"q_{name}": q[own], f"q_{name}_dot": q_dot[own]}
    return ca.Function("forces", [ca.vertcat(moved, t)], [ca.densify(model.evaluate("condensed", **values)["Q_hat"])])


def _path(t: np.ndarray, moved: np.ndarray, times: np.ndarray) -> np.ndarray:
    """(times, 2 n): the cubics through positions and rates, and their rates."""
    k = np.clip(np.searchsorted(t, times, side="right") - 1, 0, len(t) - 2)
    h = (t[k + 1] - t[k])[:, None]
    s = (times - t[k])[:, None] / h
    q, rate = np.split(moved, 2, axis=1)
    a, b, va, vb = q[k], q[k + 1], h * rate[k], h * rate[k + 1]
    place = (1 + 2 * s) * (1 - s) ** 2 * a + s**2 * (3 - 2 * s) * b + s * (1 - s) ** 2 * va - s**2 * (1 - s) * vb
    speed = 6 * s * (1 - s) * (b - a) + (1 - s) * (1 - 3 * s) * va + s * (3 * s - 2) * vb
    return np.column_stack([place, speed / h])
