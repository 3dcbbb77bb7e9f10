"""Looks at the state of all lanes a few times a run: what steps do not notice, by the limits of a run's monitor.

constraint    largest C of the observed state, of its limit                        above 1: constraints_lost
pivot         least pivot of M_hat = L D L^T                                       not above 0: mass_not_positive
bent          largest deflection of a flexible body, of its limit                  above 1: deflection_too_large
growth        largest increment of a step, of its limit                            above 1: diverged
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from runtime.contract.coordinates import joined, length_rows
from runtime.contract.model import Model
from runtime.contract.status import StatusName
from runtime.running.monitor import CONSTRAINT_LIMIT, GROWTH_LIMIT, MOST_DEFLECTION, MOST_TURN, observed
from runtime.schemes.scheme import Scheme

FIELDS = ("constraint", "pivot", "bent", "growth")
LARGE = 20  # coordinates of q_i: above, M_hat is not factorised
FOUND: tuple[StatusName, ...] = ("mass_not_positive", "constraints_lost", "deflection_too_large", "diverged")


def looked(model: Model, scheme: Scheme, length: float, p: ca.SX, z: ca.SX, c: ca.SX) -> Mapping[str, ca.SX]:
    """The values of FIELDS at the scheme's part of z; c as the scheme's stages read it, p: parameters."""
    seen = scheme.observer(z=z, c=c)
    found = {"constraint": ca.SX(0), "pivot": ca.SX(1), "bent": ca.SX(0)}
    if model.constraints and model.has("constraints"):
        C, _ = observed(model, scheme, "constraints", ("C", "C_q"))(z, c)
        found["constraint"] = _largest(C / (CONSTRAINT_LIMIT * np.where(length_rows(model), length, 1.0)))
    if len(model.q_i) <= LARGE:
        M_hat = model.evaluate("condensed", **{**seen, "c": c[: model.c_size]})["M_hat"]
        found["pivot"] = _least_pivot(ca.SX(M_hat))
    found["bent"] = _bent(model, p, seen["q_i"], seen["q_d"])
    found["growth"] = _largest(seen["q_i_dot"] * ca.DM(scheme.step_sizes)) / GROWTH_LIMIT
    return found


def judged(now: np.ndarray) -> np.ndarray:
    """Position in FOUND, -1 where nothing is wrong, of lanes whose FIELDS are now (4, n)."""
    constraint, pivot, bent, growth = now
    wrong = np.full(now.shape[1], -1)
    for name, found in (
        ("diverged", growth > 1),
        ("deflection_too_large", bent > 1),
        ("constraints_lost", ~(constraint <= 1)),
        ("mass_not_positive", ~(pivot > 0)),
    ):
        wrong[found] = FOUND.index(name)
    return wrong


def _largest(values: ca.SX) -> ca.SX:
    """Of the magnitudes; NaN where one of them is none."""
    return ca.norm_inf(values) + 0 * ca.sum1(values)


def _least_pivot(M: ca.SX) -> ca.SX:
    """Of the elimination of a symmetric matrix (n x n) without exchanges."""
    n, least = M.size1(), None
    for k in range(n):
        pivot = M[k, k]
        least = pivot if least is None else ca.fmin(least, pivot)
        for i in range(k + 1, n):
            factor = M[i, k] / pivot
            for j in range(k + 1, i + 1):
                M[i, j] = M[j, i] = M[i, j] - factor * M[j, k]
    assert least is not None
    return least


def _bent(model: Model, p: ca.SX, q_i: ca.SX, q_d: ca.SX) -> ca.SX:
    """The largest deflection or turn of a drawn point of a flexible body, of its limit."""
    if not model.elastic or not model.has("geometry"):
        return ca.SX(0)
    q = joined(model, q_i, q_d)
    drawn = model.kernel("geometry")(p=p)
    points: dict[str, list[tuple[int, int, int]]] = {}
    first = 0
    for k, point in enumerate(model.description.drawing.points):
        if point.modes:
            points.setdefault(point.body, []).append((k, first, first + point.modes))
            first += point.modes
    worst = ca.SX(0)
    for body, own in points.items():
        modes = [k for k, one in enumerate(model.description.coordinates) if one.elastic and one.owner == body]
        places = ca.horzcat(*(drawn["positions"][:, k] for k, _, _ in own))
        extent = ca.vertcat(*(ca.mmax(places[axis, :]) - ca.mmin(places[axis, :]) for axis in range(3)))
        length = ca.norm_2(extent)
        for _, start, stop in own:
            moved = ca.norm_2(ca.mtimes(drawn["shapes"][:, start:stop], q[modes])) / (MOST_DEFLECTION * length)
            turned = ca.norm_2(ca.mtimes(drawn["turns"][:, start:stop], q[modes])) / MOST_TURN
            worst = ca.fmax(worst, ca.fmax(ca.if_else(length > 0, moved, 0), turned))
    return worst
