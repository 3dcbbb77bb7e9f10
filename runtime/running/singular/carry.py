"""A scheme's state from one q_i to another: positions and rates exactly, and what the scheme remembers of the past.

Central difference remembers q(t - h) by its increments d = q(t) - q(t - h). A coordinate that takes another's place
gets the increment that the closure gives for the old increments: exactly the same two positions of the mechanism.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from runtime.contract.coordinates import charts_in, dependent_part, independent, independent_rates, rate_parts
from runtime.contract.model import Model
from runtime.contract.orientations import product, rotation_vector
from runtime.results.solution import Solution
from runtime.running.segment import Segment

COUNTERS = ("closure_error", "iterations", "failures")
STEPS_MADE = ("accepted", "counted", "rejected", "h_least", "h_largest")  # those that follow from a tolerance
OF_TOLERANCE = (*STEPS_MADE, "h_next", "per_step", "steady", "lands", "ranging")
RANGES = ("q_low", "q_high")  # what errors are measured by
CLOSURES = 6
CONJUGATE = np.array([1.0, -1.0, -1.0, -1.0])


def carried(old: Segment, z: np.ndarray, new: Segment, seen: Solution) -> np.ndarray:
    """z of the new segment at the state of the old one; seen: that state observed, one sample."""
    result = new.start(seen.q[0], seen.q_dot[0], old.step_of(z))
    before, after = old.plan.scheme.layout, new.plan.scheme.layout
    for name in (*COUNTERS, *(name for name in OF_TOLERANCE if name in after.sizes)):
        result[after.slice(name)] = z[before.slice(name)]
    stays = np.array([a == b for a, b in zip(old.model.q_i, new.model.q_i, strict=True)])
    for name in new.plan.scheme.history:
        values = result[after.slice(name)]
        result[after.slice(name)] = np.where(stays, z[before.slice(name)], values)
    for name in RANGES:
        if name in after.sizes:
            result[after.slice(name)] = np.where(stays, z[before.slice(name)], result[after.slice(name)])
    if {"d", "a"} <= set(new.plan.scheme.history):  # it remembers the last step by increments
        for k in np.flatnonzero(~stays):
            d, a = _increment(old, z, seen, new.model.q_i[k], float(new.plan.scheme.step_sizes[k]))
            result[after.slice("d")][k], result[after.slice("a")][k] = d, a
    return result


def _increment(old: Segment, z: np.ndarray, seen: Solution, name: str, h: float) -> tuple[float, float]:
    """(q(t) - q(t - h), q_ddot(t - h)) of a dependent coordinate of the old segment.

    Coordinates with another step than h are not remembered at t - h; they are taken along their acceleration.
    """
    model, layout, scheme = old.model, old.plan.scheme.layout, old.plan.scheme
    d, a = z[layout.slice("d")], z[layout.slice("a")]
    same = np.isclose(scheme.step_sizes, h, rtol=1e-12)
    now = seen.q_ddot[0]
    q_i, v_i = independent(model, seen.q[0], seen.q_dot[0])
    a_i = independent_rates(model, seen.q[0], now)
    x, c = z[layout.slice("x")], old.c
    guess = dependent_part(model, seen.q[0] - h * seen.q_dot[0] + h**2 / 2 * now)
    turns, omega = model.places.turns, np.concatenate(rate_parts(model, seen.q[0], seen.q_dot[0]))
    if len(turns):  # all from the charts of z
        c = c.copy()
        c[charts_in(model)] = z[layout.slice("chart")]
        for own, theta in zip(turns, _thetas(model, seen.q[0], c), strict=True):
            turned = np.concatenate([q_i, guess])
            turned[own] = theta
            turned[own[own >= len(q_i)]] -= h * omega[own[own >= len(q_i)]]
            q_i, guess = turned[: len(q_i)], turned[len(q_i) :]
    earlier = np.where(same, x - d, q_i - h * v_i + h**2 / 2 * a_i)
    earlier_v = np.where(same, d / h - h / 2 * a, v_i - h * a_i)
    t = float(seen.t[0]) - h
    q_d = closed(model, c, t, earlier, guess)
    values: dict[str, Any] = {"q_i": earlier, "q_d": q_d, "q_i_dot": earlier_v, "t": t, "c": c, "q_i_ddot": a}
    values["q_d_dot"] = model.evaluate("velocities", **values)["q_d_dot"]
    q_d_ddot = np.asarray(model.evaluate("accelerations", **values)["q_d_ddot"]).ravel()
    position = model.q_d.index(name)
    return _turned(model, seen.q[0], q_d, name), float(q_d_ddot[position])


def _thetas(model: Model, q: np.ndarray, c: np.ndarray) -> list[np.ndarray]:
    """Rotation vectors from the charts in c to where the bodies are."""
    charts = c[charts_in(model)].reshape(-1, 4)
    return [
        rotation_vector(product(chart * CONJUGATE, q[e]))
        for chart, e in zip(charts, model.places.parameters, strict=True)
    ]


def _turned(model: Model, q: np.ndarray, before: np.ndarray, name: str) -> float:
    """By how much a dependent coordinate changed to q (n,) from q_d before; of a turn, in the axes of its body."""
    if name in model.coordinates:
        return float(q[model.coordinates.index(name)] - before[model.q_d.index(name)])
    record, e = next(
        (record, e)
        for record, e in zip(model.description.orientations, model.places.parameters, strict=True)
        if name in record.turns
    )
    earlier = before[[model.q_d.index(one) for one in record.parameters]]
    return float(rotation_vector(product(earlier * CONJUGATE, q[e]))[record.turns.index(name)])


def closed(model: Model, c: np.ndarray, t: float, q_i: np.ndarray, q_d: np.ndarray) -> np.ndarray:
    """q_d at q_i from a near guess, by Newton until it no longer moves."""
    for _ in range(CLOSURES):
        q_d = np.asarray(model.evaluate("closure", q_i=q_i, q_d=q_d, t=t, c=c)["q_d_next"]).ravel()
    return q_d
