"""Mechanisms by hand with friction and stops, and their velocity-level time stepping after Moreau.

It knows no modes and no events: every step solves for impulses within their bounds. Its error falls with the step.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

Law = dict[str, float]
STRUCK = 0.05  # rad/s: a stop that is reached faster is struck


class Stop(NamedTuple):
    """An end of the way of a joint: side 1 below, -1 above."""

    joint: int
    side: int
    end: float
    e: float


@dataclass(frozen=True)
class Mechanism:
    """laws: of the friction of each joint, None where it has none."""

    laws: Sequence[Law | None]
    stops: Sequence[Stop]

    def bounds(self, v: np.ndarray) -> np.ndarray:
        """(joints,) coulomb + (breakaway - coulomb) exp(-|v| / v_s)."""
        found = np.zeros(len(v))
        for k, law in enumerate(self.laws):
            if law is not None:
                falls = law["breakaway"] - law["coulomb"]
                found[k] = law["coulomb"] + falls * np.exp(-abs(v[k]) / law["stribeck_velocity"])
        return found

    @property
    def viscous(self) -> np.ndarray:
        """(joints,)."""
        return np.array([0.0 if law is None else law["viscous"] for law in self.laws])

    @property
    def rubs_by_force(self) -> bool:
        """Are the bounds shares of what joints press with?"""
        return False

    def closure(self, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """C and C_q."""
        return np.zeros(0), np.zeros((0, len(at)))


@dataclass(frozen=True)
class Rails(Mechanism):
    """Bodies on straight rails, one on the other or on the ground: rates of the joints are G x'."""

    G: np.ndarray
    masses: np.ndarray
    loads: Callable[[float], np.ndarray]

    def mass(self, x: np.ndarray) -> np.ndarray:
        return np.diag(self.masses)

    def force(self, t: float, x: np.ndarray, rates: np.ndarray) -> np.ndarray:
        return np.asarray(self.loads(t) - self.G.T @ (self.viscous * (self.G @ rates)))


@dataclass(frozen=True)
class Links(Mechanism):
    """Links by their absolute angles, from the ground one after the other; with `span` the last one is the rocker of a
    four-bar that stands on the ground at (span, 0).

    Rates of the joints are G phi'; the drives act on joints. radii: of the bearings of a four-bar, whose laws are then
    shares of its joints' forces.
    """

    lengths: Sequence[float]
    inertia: Sequence[float]
    drives: Sequence[Callable[[float], float]]
    gravity: float = 0.0
    span: float = 0.0
    radii: Sequence[float] = ()

    @cached_property
    def G(self) -> np.ndarray:
        """(joints, links)."""
        rows = np.eye(len(self.lengths)) - np.eye(len(self.lengths), k=-1)
        return np.vstack([rows, [0.0, 0.0, 1.0]]) if self.span else rows

    @cached_property
    def _levers(self) -> np.ndarray:
        """(links, links): the centre of link i is sum_j levers[i, j] e(phi_j)."""
        found = np.tril(np.tile(np.array(self.lengths), (len(self.lengths), 1)), -1) + np.diag(self.lengths) / 2
        if self.span:
            found[2] = [0.0, 0.0, self.lengths[2] / 2]
        return found

    def mass(self, phi: np.ndarray) -> np.ndarray:
        """M of masses of 1 kg."""
        return np.asarray(self._levers.T @ self._levers * np.cos(phi[:, None] - phi) + np.diag(self.inertia))

    def force(self, t: float, phi: np.ndarray, rates: np.ndarray) -> np.ndarray:
        """All but friction that sticks."""
        rotation = -(self._levers.T @ self._levers * np.sin(phi[:, None] - phi)) @ rates**2
        weight = -self.gravity * self._levers.sum(axis=0) * np.cos(phi)
        driven = self.G[: len(self.drives)].T @ np.array([drive(t) for drive in self.drives])
        return np.asarray(rotation + weight + driven - self.G.T @ (self.viscous * (self.G @ rates)))

    @property
    def rubs_by_force(self) -> bool:
        return len(self.radii) > 0

    def arms(self, phi: np.ndarray, rates: np.ndarray, change: np.ndarray, h: float, closing: np.ndarray) -> np.ndarray:
        """(joints,) radius times force in each joint of a four-bar over a step h, by Newton's law of its links.

        change (links,): of the rates; closing (2,): the impulse on the coupler's end, by the loop's closure.
        """
        across, along = np.array([-np.sin(phi), np.cos(phi)]), np.array([np.cos(phi), np.sin(phi)])
        gained = (self._levers * change) @ across.T - h * (self._levers * rates**2) @ along.T
        crank, coupler, rocker = gained + h * np.array([0.0, self.gravity])  # by joints alone
        second = coupler - closing
        forces = [crank + second, second, closing, rocker + closing]
        return np.asarray(self.radii) * np.linalg.norm(forces, axis=1) / h

    def closure(self, phi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """C and C_q of the loop."""
        if not self.span:
            return super().closure(phi)
        signed = np.array([*self.lengths[:2], -self.lengths[2]])
        C = np.array([signed @ np.cos(phi) - self.span, signed @ np.sin(phi)])
        return C, np.array([-signed * np.sin(phi), signed * np.cos(phi)])


def moreau(own: Any, start: np.ndarray, h: float, t_end: float) -> tuple[np.ndarray, np.ndarray]:
    """(steps + 1, n) coordinates, (steps + 1, joints) rates of a Mechanism: midpoint, impulses by Gauss-Seidel.

    A stop that is reached in the middle of a step gives an impulse p >= 0 with v+ + e v- >= 0, one of them zero.
    """
    G, rates, at = own.G, np.zeros(len(start)), start.copy()
    rows = np.vstack([G, *(one.side * G[[one.joint]] for one in own.stops)])
    e = np.array([0.0] * len(G) + [one.e for one in own.stops])
    p, found, joints, arms = np.zeros(len(rows)), [at], [G @ rates], np.ones(len(G))
    for k in range(round(t_end / h)):
        middle = at + h / 2 * rates
        C, J = own.closure(middle)
        inverse = np.linalg.inv(own.mass(middle))
        S = np.linalg.inv(J @ inverse @ J.T)
        free = rates + h * inverse @ own.force((k + 0.5) * h, middle, rates)
        free = free - inverse @ J.T @ S @ (J @ free + 0.1 * C / h)
        by = (inverse - inverse @ J.T @ S @ J @ inverse) @ rows.T
        A, v = rows @ by, rows @ free + e * np.minimum(rows @ rates, 0.0)
        most = h * own.bounds(G @ rates)
        reached = [np.inf if one.side * (G[one.joint] @ middle - one.end) <= 0 else 0.0 for one in own.stops]
        hit = any(r > 0 and v[len(G) + j] < -STRUCK for j, r in enumerate(reached))
        for _ in range(200):
            before = p.copy()
            if own.rubs_by_force and not hit:  # an impact rubs nowhere: then joints press as they did before
                acts = h * own.force((k + 0.5) * h, middle, rates) + rows.T @ p
                closing = -S @ (J @ (rates + inverse @ acts) + 0.1 * C / h)
                arms = own.arms(middle, rates, free + by @ p - rates, h, closing)
            bounds = most * arms
            lower, upper = np.append(-bounds, np.zeros(len(e) - len(G))), np.append(bounds, reached)
            for i in range(len(p)):
                p[i] = min(max(p[i] - (v[i] + A[i] @ p) / A[i, i], lower[i]), upper[i])
            if np.abs(p - before).max() < 1e-10 * max(np.abs(p).max(), 1e-3 * h):
                break
        rates = free + by @ p
        at = middle + h / 2 * rates
        found.append(at)
        joints.append(G @ rates)
    return np.array(found), np.array(joints)
