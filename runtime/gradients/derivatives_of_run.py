"""What a differentiated run gives: derivatives by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from runtime.contract.errors import ArgumentError


@dataclass(frozen=True)
class OutputJacobian:
    """Outputs (N, n_y) at times t (N,) [s], and their derivatives (N, n_y, n) by the names `by`, in SI units."""

    t: np.ndarray
    outputs: tuple[str, ...]
    by: tuple[str, ...]
    values: np.ndarray
    derivatives: np.ndarray

    def __getitem__(self, names: tuple[str, str]) -> np.ndarray:
        """(N,) the derivative of an output by a parameter or initial value. Raises ArgumentError for other names."""
        if len(names) != 2 or names[0] not in self.outputs or names[1] not in self.by:
            known = f"{', '.join(self.outputs)} and {', '.join(self.by)}"
            raise ArgumentError(f"derivative {names!r}", "is not here", f"give a pair of {known}")
        return self.derivatives[:, self.outputs.index(names[0]), self.by.index(names[1])]


@dataclass(frozen=True)
class Gradient:
    """value of an objective and its derivatives (n,) by the names `by`.

    mode: how they were found; t (N,) [s] and outputs (N,) by name: of the run.
    """

    value: float
    by: tuple[str, ...]
    derivatives: np.ndarray
    mode: str
    t: np.ndarray
    outputs: Mapping[str, np.ndarray]

    def __getitem__(self, name: str) -> float:
        """The derivative by one of them. Raises ArgumentError for another name."""
        if name not in self.by:
            raise ArgumentError(f"derivative by {name!r}", "is not here", f"give one of {', '.join(self.by)}")
        return float(self.derivatives[self.by.index(name)])
