"""Initial values as a run takes them: by name, or from what has a state, an equilibrium or a solution."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Protocol

import numpy as np

if TYPE_CHECKING:
    from runtime.contract.model import Model


class HasState(Protocol):
    """An equilibrium, or a solution, of which it is the last sample."""

    def initial_values(self) -> dict[str, float]:
        """All coordinates and rates by name."""


Initial = Mapping[str, float] | HasState | None


def values_by_name(initial: Initial) -> Mapping[str, float] | None:
    """Initial values by name."""
    return initial if initial is None or isinstance(initial, Mapping) else initial.initial_values()


def named_values(model: Model, q: np.ndarray, q_dot: np.ndarray) -> dict[str, float]:
    """Coordinates (n,) and rates (n,) by name; of the state of a controller its value alone, which is a rate."""
    values: dict[str, float] = {}
    for entry, place, rate in zip(model.description.coordinates, q.tolist(), q_dot.tolist(), strict=True):
        values |= {entry.owner: rate} if entry.kind == "state" else {entry.name: place, f"{entry.name}_dot": rate}
    return values
