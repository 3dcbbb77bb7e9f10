"""A mode as a motion of the model, which everything that shows a solution can show."""

from __future__ import annotations

import numpy as np

from runtime.contract.coordinates import mechanism_length, turning_columns
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.status import Status
from runtime.operating.linearisation import Linearisation
from runtime.solutions.observe import assemble_solution
from runtime.solutions.solution import Solution

SHOWN_AMPLITUDES, MOVED = 0.2, 0.1  # largest amplitudes shown: rad, and parts of the mechanism's length


def mode_motion(system: Linearisation, mode: int, frames: int = 24, amplitude: float | None = None) -> Solution:
    """Show one period of a mode about its state: q(t) = q_0 + amplitude Re(shape exp(i w t)), w = |Im lambda|.

    Parameters
    ----------
    system : Linearisation
        The equations about the state.
    mode : int
        Counted from 0.
    frames : int
        Samples of the period besides the first.
    amplitude : float, optional
        Of the shape with modal mass 1; by default angles swing by at most 0.2 rad and points by about a tenth of the
        mechanism's length.

    Returns
    -------
    Solution
        The period, or 1 s of a mode that does not vibrate.

    Raises
    ------
    ModelError
        For a mode that is not there.
    ArgumentError
        For no frames.

    Notes
    -----
    To first order: loops are not closed anew.
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
    """The factor by which a shape (n,) about a state (q, q_dot, t) is seen: by SHOWN_AMPLITUDES and MOVED."""
    length = 1.0
    if model.constraints:
        q, q_dot, t = state
        found = model.evaluate("constraints", q=q, q_dot=q_dot, t=t, c=c)
        length = mechanism_length(model, np.asarray(found["C_q"]))
    turns = turning_columns(model)
    share = max(
        float(np.abs(shape[turns]).max(initial=0.0)) / SHOWN_AMPLITUDES,
        float(np.abs(shape[~turns]).max(initial=0.0)) / (MOVED * length),
    )
    return 1.0 / share if share > 0 else 1.0
