"""Coupled frequencies and damping over a motion, whose coordinates they belong to, and groups by the widest gap."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.model import Model
from runtime.operating.mode_solver import Modes, ModeSolver, State

TAKES_PART = 0.2  # share of a mode's kinetic energy from which a coordinate counts as moving in it
WIDE_GAP = 4.0  # ratio of neighbouring frequencies from which two step sizes are worth a thought


@dataclass(frozen=True)
class ModeRange:
    """One mode over the motion: frequencies [rad/s] and damping ratios, lowest and highest; leading coordinates."""

    lowest: float
    highest: float
    least_damping: float
    most_damping: float
    coordinates: list[str]


@dataclass(frozen=True)
class Groups:
    """Proposed groups, slow and fast, and the gap between their frequencies."""

    slow: list[str]
    fast: list[str]
    gap: float


def mode_ranges(model: Model, solver: ModeSolver, states: list[State]) -> list[ModeRange]:
    """The modes, slow to fast."""
    found = [solver(state) for state in states]
    frequency = np.array([modes.frequencies for modes in found])
    damping = np.array([modes.damping for modes in found])
    share = np.mean([modes.participation for modes in found], axis=0)
    return [
        ModeRange(
            float(frequency[:, k].min()),
            float(frequency[:, k].max()),
            float(damping[:, k].min()),
            float(damping[:, k].max()),
            [model.q_i[j] for place, j in enumerate(np.argsort(-share[k])) if share[k, j] >= TAKES_PART or place == 0],
        )
        for k in range(len(model.q_i))
    ]


def propose_groups(model: Model, solver: ModeSolver, states: list[State]) -> Groups | None:
    """Slow and fast coordinates on both sides of the widest gap, None if there is no wide one."""
    own = np.mean([_own_frequencies(solver(state)) for state in states], axis=0)
    order = np.argsort(own, kind="stable")
    if len(order) < 2:
        return None
    ordered = np.maximum(own[order], 1e-9 * own.max(initial=1.0))
    floor = max(float(own.max()) * 1e-6, 1e-12)
    ratios = np.maximum(ordered[1:], floor) / np.maximum(ordered[:-1], floor)
    # a rigid coordinate has no frequency of its own: its gap is judged against the slowest mode that has one
    place = int(np.argmax(np.where(ordered[:-1] > floor, ratios, WIDE_GAP)))
    if ratios[place] < WIDE_GAP:
        return None
    names = [model.q_i[k] for k in order]
    return Groups(names[: place + 1], names[place + 1 :], float(ratios[place]))


def _own_frequencies(modes: Modes) -> np.ndarray:
    """Of each coordinate: the frequency of the mode in which it takes part most."""
    return np.asarray(modes.frequencies[np.argmax(modes.participation, axis=0)])
