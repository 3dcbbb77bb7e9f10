"""What a fit found: values, how sure they are, and what is left over."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from scipy import stats

from runtime.contract.errors import ArgumentError

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Fit:
    """x (n,) of the names with their covariance (n, n), in SI units; freedom: of the estimated deviation (inf: given).

    t (N,) [s], data and fitted {output: (N,)}; evaluations: runs of the search; converged, message: how it ended. The
    covariance is that of the linear theory: right where the residuals are independent and the model is nearly linear
    over it.
    """

    names: tuple[str, ...]
    x: np.ndarray
    covariance: np.ndarray
    freedom: float
    t: np.ndarray
    data: Mapping[str, np.ndarray]
    fitted: Mapping[str, np.ndarray]
    evaluations: int
    converged: bool
    message: str

    def __getitem__(self, name: str) -> float:
        """The value of one. Raises ArgumentError for another name."""
        return float(self.x[self._index(name)])

    @property
    def residuals(self) -> dict[str, np.ndarray]:
        """fitted - data of every output, (N,)."""
        return {name: self.fitted[name] - values for name, values in self.data.items()}

    @property
    def standard_errors(self) -> np.ndarray:
        """(n,) square roots of the variances."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def correlation(self) -> np.ndarray:
        """(n, n): near 1 or -1 where the data hardly tell two apart."""
        return np.asarray(self.covariance / np.outer(self.standard_errors, self.standard_errors))

    def interval(self, name: str, confidence: float = 0.95) -> tuple[float, float]:
        """In which the truth lies with this confidence, whatever the others are. Raises ArgumentError."""
        k = self._index(name)
        half = float(stats.t.ppf(0.5 + _share(confidence) / 2, self.freedom)) * self.standard_errors[k]
        return float(self.x[k] - half), float(self.x[k] + half)

    def contains(self, values: Mapping[str, float], confidence: float = 0.95) -> bool:
        """Do values of all names lie in the ellipsoid that holds the truth with this confidence?"""
        missing = [name for name in self.names if name not in values]
        if missing:
            raise ArgumentError(f"value of {missing[0]}", "is missing", f"give {', '.join(self.names)}")
        away = np.array([values[name] for name in self.names]) - self.x
        scale = self.standard_errors
        distance = float((away / scale) @ np.linalg.solve(self.correlation, away / scale))
        n = len(self.names)
        if np.isinf(self.freedom):
            return bool(distance <= stats.chi2.ppf(_share(confidence), n))
        return bool(distance <= n * stats.f.ppf(_share(confidence), n, self.freedom))

    def picture(self, path: str | Path | None = None) -> Figure:
        """Data, fitted outputs and residuals over time; with a path it also writes the file."""
        from runtime.gradients.fit_picture import fit_picture

        title = "\n".join(f"{name} = {value:.4g} ± {error:.1g}" for name, value, error in self._rows())
        return fit_picture(self.t, self.data, self.fitted, title, path)

    def __str__(self) -> str:
        rows = [f"{name} = {value:.6g} +- {error:.2g}" for name, value, error in self._rows()]
        return "\n".join([*rows, f"{self.evaluations} runs; {self.message}"])

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{escape(name)}</td><td>{value:.6g}</td><td>{error:.2g}</td></tr>"
            for name, value, error in self._rows()
        )
        return f"<table><tr><th>name</th><th>value</th><th>standard error</th></tr>{rows}</table>{escape(self.message)}"

    def _rows(self) -> list[tuple[str, float, float]]:
        return list(zip(self.names, map(float, self.x), map(float, self.standard_errors), strict=True))

    def _index(self, name: str) -> int:
        if name not in self.names:
            raise ArgumentError(f"{name!r}", "was not fitted", f"take one of {', '.join(self.names)}")
        return self.names.index(name)


def _share(confidence: float) -> float:
    if not 0 < confidence < 1:
        raise ArgumentError("confidence", f"is {confidence}", "give a share between 0 and 1, such as 0.95")
    return confidence
