"""The steady response of a rotor to an unbalance: a force that turns with it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.operating.campbell import Sweep


@dataclass(frozen=True)
class UnbalanceResponse:
    """Complex amplitudes (N, n_y) of the outputs at N speeds [rad/s]: y(t) = Re(amplitude exp(i speed t))."""

    speeds: np.ndarray
    outputs: list[str]
    amplitudes: np.ndarray


def unbalance_response(
    model: Model,
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
    """Amplitudes under an unbalance U [kg m] of a rotor that turns at each speed, to first order.

    over: the rate that is the speed, such as `disk.omega`; at: the two coordinates [m] across the axle at which the
    force U speed^2 (cos, sin)(speed t) acts, for a rotor that turns from the first to the second; outputs: these two by
    default. The linear system is that of each speed, gyroscopic terms included. Raises ModelError and NoEquilibrium.
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
