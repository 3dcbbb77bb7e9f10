"""What is kept of every lane at each major step: is it alive, why not, and what its outputs come to.

causes: 0 while nothing is wrong with a lane, then what was at the first step at which something was, as a sum of powers
of two in the order of CAUSES; reached: steps that were good.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import get_args

import casadi as ca
import numpy as np

from runtime.contract.coordinates import joined, length_rows
from runtime.contract.model import EmittedModel
from runtime.contract.status import StatusName
from runtime.engine.program import Fields
from runtime.running.monitor import (
    CLOSURE_LIMIT,
    CONSTRAINT_LIMIT,
    GROWTH_LIMIT,
    MOST_DEFLECTION,
    MOST_TURN_OF_BODY,
    observed,
)
from runtime.running.singular.singularity_monitor import NEAR_SINGULAR_DETERMINANT
from runtime.running.stepped_model import NO_HIGHEST, NO_LOWEST
from runtime.schemes.scheme import LARGEST_NUMBER, Scheme
from runtime.schemes.switching.watched import NEVER, watches

NAME = f"U{max(map(len, get_args(StatusName)))}"  # of a status, as NumPy keeps it
ALONE = "alone"  # no end: a case that comes to a singular position or to an event is run by itself
# in the order in which they are looked for
CAUSES: tuple[StatusName | str, ...] = (
    ALONE,
    "iteration_failed",
    "not_finite",
    "constraints_lost",
)

Step = Callable[[ca.SX, ca.SX], ca.SX]
# name: (at the start, with one more value)
REDUCTIONS: dict[str, tuple[Callable[[ca.SX], ca.SX], Step]] = {
    "max": (lambda y: y, ca.fmax),
    "min": (lambda y: y, ca.fmin),
    "peak": (ca.fabs, lambda kept, y: ca.fmax(kept, ca.fabs(y))),
    "mean": (lambda y: y, lambda kept, y: kept + y),
    "rms": (lambda y: y * y, lambda kept, y: kept + y * y),
    "end": (lambda y: y, lambda kept, y: y),
}


class LaneAccount:
    """Fields of z and the stage that keeps them; reduced: (position in `outputs`, reduction) of each value kept.

    length [m]: size of the mechanism, which closure errors are compared with.
    """

    def __init__(self, scheme: Scheme, reduced: list[tuple[int, str]], length: float) -> None:
        self.scheme, self.reduced, self.length = scheme, reduced, length
        self.blocks = scheme.layout.sizes["det_low"]

    @property
    def fields(self) -> dict[str, int]:
        """What is kept in z."""
        return {"causes": 1, "reached": 1, "largest": self.blocks, "before": self.blocks, "reduced": len(self.reduced)}

    def begin(self, z: Fields) -> Mapping[str, ca.SX]:
        """At the start, step 0."""
        zeros = ca.SX.zeros(self.blocks)
        values = [REDUCTIONS[name][0](z["outputs"][k]) for k, name in self.reduced]
        lost = ca.logic_not(self.scheme.alive(self.scheme.layout.unpack(z["scheme"])))
        start = {"causes": lost * 2 ** CAUSES.index("not_finite"), "reached": ca.SX(0), "largest": zeros}
        return {**start, "before": zeros, "reduced": ca.vertcat(*values) if values else ca.SX(0, 1)}

    def step(self, z: Fields, c: ca.SX) -> Mapping[str, ca.SX]:
        """After one more major step."""
        s = self.scheme.layout.unpack(z["scheme"])
        near_singular, account = self._monitored(z, s)
        none, scheme = ca.SX(0), self.scheme
        found = {
            ALONE: ca.logic_or(near_singular, self._at_event(s)),
            "iteration_failed": none if scheme.iteration_limit is None else s["failures"] > 0,
            "not_finite": ca.logic_not(scheme.alive(s)),
            "constraints_lost": s["closure_error"] > CLOSURE_LIMIT * self.length if self.blocks else none,
        }
        now = ca.SX(0)
        for k, name in enumerate(CAUSES):
            now = now + found[name] * 2**k
        causes = z["causes"] + (z["causes"] <= 0) * now
        values = [REDUCTIONS[name][1](z["reduced"][n], z["outputs"][k]) for n, (k, name) in enumerate(self.reduced)]
        return {
            **account,
            "causes": causes,
            "reached": z["reached"] + (causes <= 0),
            "reduced": ca.vertcat(*values) if values else ca.SX(0, 1),
        }

    def _at_event(self, s: Fields) -> ca.SX:
        """May an event have happened, or has its condition no finite value?"""
        if not watches(self.scheme):
            return ca.SX(0)
        return ca.logic_or(s["event_step"] < NEVER, ca.logic_not(ca.sum1(ca.fabs(s["event_values"])) < LARGEST_NUMBER))

    def _monitored(self, z: Fields, s: Fields) -> tuple[ca.SX, dict[str, ca.SX]]:
        """(is the determinant of a loop block small, or has it changed its sign?, what is kept of them).

        See runtime/running/singular/singularity_monitor.
        """
        near_singular, largest = ca.SX(0), ca.SX(z["largest"])
        for k in range(self.blocks):
            low, high = s["det_low"][k], s["det_high"][k]
            least, most = ca.fmin(ca.fabs(low), ca.fabs(high)), ca.fmax(ca.fabs(low), ca.fabs(high))
            largest[k] = ca.fmax(most, largest[k])
            changed = ca.logic_or(low * high <= 0, z["before"][k] * low < 0)
            near_singular = ca.logic_or(
                near_singular, ca.logic_or(least < NEAR_SINGULAR_DETERMINANT * largest[k], changed)
            )
        fresh = {"det_low": NO_LOWEST * ca.SX.ones(self.blocks), "det_high": NO_HIGHEST * ca.SX.ones(self.blocks)}
        state = self.scheme.layout.pack({**s, **fresh})
        return near_singular, {"scheme": state, "largest": largest, "before": s["det_high"]}


def cause_of(causes: np.ndarray) -> np.ndarray:
    """Names of the first of CAUSES in sums of their powers of two, "completed" for zero."""
    found = np.full(causes.shape, "completed", dtype=NAME)
    for k in reversed(range(len(CAUSES))):
        found[(causes.astype(int) >> k) & 1 > 0] = CAUSES[k]
    return found


# Looks at the state of all lanes a few times a run: what steps do not notice, by the limits of a run's monitor.
#
# constraint    largest C of the observed state, of its limit                        above 1: constraints_lost
# pivot         least pivot of M_hat = L D L^T                                       not above 0: mass_not_positive
# bent          largest deflection of a flexible body, of its limit                  above 1: deflection_too_large
# growth        largest increment of a step, of its limit                            above 1: diverged

FIELDS = ("constraint", "pivot", "bent", "growth")
LARGE = 20  # coordinates of q_i: above, M_hat is not factorised
FOUND: tuple[StatusName, ...] = ("mass_not_positive", "constraints_lost", "deflection_too_large", "diverged")


def looked(model: EmittedModel, scheme: Scheme, length: float, p: ca.SX, z: ca.SX, c: ca.SX) -> Mapping[str, ca.SX]:
    """The values of FIELDS at the scheme's part of z; c as the scheme's stages read it, p: parameters."""
    observation = scheme.observer(z=z, c=c)
    found = {"constraint": ca.SX(0), "pivot": ca.SX(1), "bent": ca.SX(0)}
    if model.constraints and model.has("constraints"):
        C, _ = observed(model, scheme, "constraints", ("C", "C_q"))(z, c)
        found["constraint"] = _largest(C / (CONSTRAINT_LIMIT * np.where(length_rows(model), length, 1.0)))
    if len(model.q_i) <= LARGE:
        M_hat = model.evaluate("condensed", **{**observation, "c": c[: model.c_size]})["M_hat"]
        found["pivot"] = _least_pivot(ca.SX(M_hat))
    found["bent"] = _largest_deflection(model, p, observation["q_i"], observation["q_d"])
    found["growth"] = _largest(observation["q_i_dot"] * ca.DM(scheme.step_sizes)) / GROWTH_LIMIT
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


def _largest_deflection(model: EmittedModel, p: ca.SX, q_i: ca.SX, q_d: ca.SX) -> ca.SX:
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
            turned = ca.norm_2(ca.mtimes(drawn["turns"][:, start:stop], q[modes])) / MOST_TURN_OF_BODY
            worst = ca.fmax(worst, ca.fmax(ca.if_else(length > 0, moved, 0), turned))
    return worst
