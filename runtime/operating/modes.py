"""The modes of a model about a state: a table of frequencies, damping and shapes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, NUMBER, arguments
from runtime.contract.coordinates import mechanism_length, turning_columns
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.status import Status
from runtime.operating.linearisation import Linearisation
from runtime.operating.linearise import AT, Place, linearise
from runtime.solutions.observe import assemble_solution
from runtime.solutions.solution import Solution


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
    """Find the modes about a state, sorted by frequency [rad/s]; the arguments are those of `linearise`.

    Damping, gyroscopic and geometric terms are included. Raises ModelError, InitialStateError and NoEquilibrium.
    """
    return ModeTable(linearise(model, at, inputs=(), outputs=(), parameters=parameters, locked=locked, t=t))


# ---- A mode as a motion of the model, which everything that shows a solution can show.

TURNED, MOVED = 0.2, 0.1  # largest amplitudes shown: rad, and parts of the mechanism's length


def mode_motion(system: Linearisation, mode: int, frames: int = 24, amplitude: float | None = None) -> Solution:
    """One period of a mode about its state: q(t) = q_0 + amplitude Re(shape exp(i w t)), w = |Im lambda|.

    mode: counted from 0; a mode that does not vibrate is shown over 1 s; amplitude: of the shape with modal mass 1; by
    default angles swing by at most 0.2 rad and points by about a tenth of the mechanism's length. To first order: loops
    are not closed anew. Raises ModelError for a mode that is not there and ArgumentError for no frames.
    """
    if not 0 <= mode < len(system.names):
        raise ModelError(f"model {system.model.name} has {len(system.names)} modes here; there is no mode {mode + 1}")
    if frames < 1:
        raise ArgumentError(f"frames must be at least 1, not {frames}")
    model, shape = system.model, system.shape_of_all(mode)
    c = model.constants(system.parameters)
    state = system.q, system.q_dot, system.state.t
    size = visible(model, state, c, shape) if amplitude is None else amplitude
    w = abs(float(system.eigenvalues[mode].imag)) or 2 * np.pi
    t = np.arange(frames + 1) * (2 * np.pi / w / frames)
    turning = size * shape[None, :] * np.exp(1j * w * t)[:, None]
    q, q_dot, q_ddot = system.q + turning.real, (1j * w * turning).real, (-(w**2) * turning).real
    ended = Status("completed", float(t[-1]))
    name = f"mode {mode + 1} ({system.mode_names[mode]})"
    return assemble_solution(model, t, q, q_dot, q_ddot, system.parameters, c, name, float(t[1]), [], {}, ended)


def visible(
    model: EmittedModel, state: tuple[np.ndarray, np.ndarray, float], c: np.ndarray, shape: np.ndarray
) -> float:
    """The factor by which a shape (n,) about a state (q, q_dot, t) is seen: by TURNED and MOVED."""
    length = 1.0
    if model.constraints:
        q, q_dot, t = state
        found = model.evaluate("constraints", q=q, q_dot=q_dot, t=t, c=c)
        length = mechanism_length(model, np.asarray(found["C_q"]))
    turns = turning_columns(model)
    share = max(
        float(np.abs(shape[turns]).max(initial=0.0)) / TURNED,
        float(np.abs(shape[~turns]).max(initial=0.0)) / (MOVED * length),
    )
    return 1.0 / share if share > 0 else 1.0
