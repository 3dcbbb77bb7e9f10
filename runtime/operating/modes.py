"""The modes of a model about a state: a table of frequencies, damping and shapes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, NUMBER, arguments
from runtime.contract.model import EmittedModel
from runtime.operating.linearisation import Linearisation
from runtime.operating.linearise import AT, Place, linearise


@dataclass(frozen=True, repr=False)
class ModeTable:
    """n modes sorted by frequency; as an array or a sequence: their eigenvalues [1/s], one of each pair.

    system: the linear system they are of. Angles in rad, times in s.
    """

    system: Linearisation

    @property
    def eigenvalues(self) -> np.ndarray:
        """(n,) one eigenvalue of each mode [1/s]: of a conjugate pair the one with positive imaginary part."""
        return self.system.eigenvalues

    @property
    def frequencies(self) -> np.ndarray:
        """(n,) natural frequencies [rad/s], ascending; rigid-body modes 0."""
        return self.system.frequencies

    @property
    def damping_ratios(self) -> np.ndarray:
        """(n,) damping ratios."""
        return self.system.damping_ratios

    @property
    def shapes(self) -> np.ndarray:
        """(n, n) complex shapes, columns, in the coordinates `system.names`."""
        return self.system.shapes

    @property
    def names(self) -> list[str]:
        """One name a mode: its main coordinate, `rigid` before it for a rigid-body mode."""
        return self.system.mode_names

    @property
    def rigid(self) -> np.ndarray:
        """(n,) which modes are motions without stiffness."""
        return self.system.modal.rigid

    def table(self) -> list[dict[str, Any]]:
        """One row a mode: mode, name, frequency [rad/s], frequency_Hz, damping_ratio, real and imaginary part [1/s]."""
        return [
            {
                "mode": k + 1,
                "name": name,
                "frequency": float(self.frequencies[k]),
                "frequency_Hz": float(self.frequencies[k] / (2 * np.pi)),
                "damping_ratio": float(self.damping_ratios[k]),
                "real": float(self.eigenvalues[k].real),
                "imaginary": float(self.eigenvalues[k].imag),
            }
            for k, name in enumerate(self.names)
        ]

    def remarks(self) -> list[str]:
        """What to know about these modes; see `Linearisation.remarks`."""
        return self.system.remarks()

    def __len__(self) -> int:
        return len(self.eigenvalues)

    def __getitem__(self, k: Any) -> Any:
        return self.eigenvalues[k]

    def __iter__(self) -> Iterator[complex]:
        return iter(self.eigenvalues)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        return np.array(self.eigenvalues, dtype=dtype)

    def __repr__(self) -> str:
        listed = ", ".join(
            f"{name} {w:.6g} rad/s ({w / (2 * np.pi):.4g} Hz)"
            for name, w in zip(self.names[:8], self.frequencies, strict=False)
        )
        of = f"{len(self)} mode{'' if len(self) == 1 else 's'} of {self.system.model.name}"
        return f"<{of}{': ' if listed else ''}{listed}{', ...' if len(self) > 8 else ''}>"


@arguments(at=AT, parameters=BY_NAME, locked=NAMES, t=NUMBER)
def modes(
    model: EmittedModel,
    at: Place = None,
    *,
    parameters: Mapping[str, float] | None = None,
    locked: Sequence[str] | None = None,
    t: float = 0.0,
) -> ModeTable:
    """Find the modes about a state, sorted by frequency.

    Parameters
    ----------
    model : Model
        The mechanism.
    at, parameters, locked, t : optional
        As of `linearise`.

    Returns
    -------
    ModeTable
        n modes: eigenvalues (n,) [1/s], frequencies (n,) [rad/s], damping ratios (n,), shapes (n, n).

    Raises
    ------
    ModelError, InitialStateError, NoEquilibrium
        As of `linearise`.

    Notes
    -----
    Eigenvalues of lambda^2 M + lambda D + K of `linearise`: damping, gyroscopic and geometric terms are included.
    """
    return ModeTable(linearise(model, at, inputs=(), outputs=(), parameters=parameters, locked=locked, t=t))
