"""The steady response of a rotor to an unbalance: a force that turns with it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, NUMBER, NUMBERS, arguments
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.operating.campbell import Sweep


@dataclass(frozen=True)
class UnbalanceResponse:
    """Complex amplitudes (N, n_y) of the outputs at N speeds [rad/s]: y(t) = Re(amplitude exp(i speed t))."""

    speeds: np.ndarray
    outputs: list[str]
    amplitudes: np.ndarray


@arguments(speeds=NUMBERS, at=NAMES, unbalance=NUMBER, outputs=NAMES, held=BY_NAME, parameters=BY_NAME, locked=NAMES)
def unbalance_response(
    model: EmittedModel,
    over: str,
    speeds: Sequence[float] | np.ndarray,
    *,
    at: tuple[str, str],
    unbalance: float,
    outputs: Sequence[str] | None = None,
    held: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    locked: Sequence[str] | None = None,
) -> UnbalanceResponse:
    """Find the steady whirl of a rotor with an unbalance at each speed, to first order.

    Parameters
    ----------
    model : Model
        The mechanism.
    over : str
        The rate that is the speed, such as `disk.omega`.
    speeds : array_like (k,)
        Speeds [rad/s].
    at : (str, str)
        The two coordinates [m] across the axle at which the force acts, for a rotor that turns from the first to the
        second.
    unbalance : float
        Mass times eccentricity U [kg m].
    outputs : sequence of str, optional
        What is told; these two coordinates by default.
    held, parameters : mapping of str to float, optional
        As of `equilibrium`.
    locked : sequence of str, optional
        As of `linearise`.

    Returns
    -------
    UnbalanceResponse
        Complex amplitudes of the outputs at each speed.

    Raises
    ------
    ModelError, NoEquilibrium
        For what cannot be used, and where no equilibrium is reached.
    NoResult
        At a speed where the whirl grows without bound.

    Notes
    -----
    The force is U speed^2 (cos, sin)(speed t) on the linear system of each speed, gyroscopic terms included.
    """
    names = list(outputs if outputs is not None else at)
    for name in at:
        if name not in model.coordinates:
            raise ModelError(f"model {model.name} has no coordinate {name!r} for the unbalance to act on")
    rows = [model.coordinates.index(name) for name in at]
    sweep = Sweep(model, over, held or {}, {}, parameters or {}, locked, outputs=names)
    wanted = np.asarray(speeds, dtype=float)
    result = np.zeros((len(wanted), len(names)), dtype=complex)
    for k, speed in enumerate(wanted):
        system = sweep.system(float(speed))
        force = unbalance * speed**2 * (system.S[rows[0]] - 1j * system.S[rows[1]])
        result[k] = system.response(float(speed), force)
    return UnbalanceResponse(wanted, names, result)
