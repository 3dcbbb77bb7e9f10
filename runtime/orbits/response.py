"""What a motion that repeats does under a small disturbance e^{i w t} of an input: harmonic transfer functions.

To first order dx(t0 + T) = Phi dx(t0) + G(w), and what repeats under it satisfies dx(t0 + T) = e^{i w T} dx(t0):

    (e^{i w T} - Phi) dx(t0) = G(w),    dy(t) = sum over m of H_m(w) e^{i (w + m 2 pi / T) t}

Phi is the monodromy. G follows from tangents by an input that is held over each step, S_k = integral of g over step k:
the integral of g e^{i w t} is that of the means in each step, and of g' i w e^{i w t} h^3 / 12, up to h^4.
Source: Wereley, Analysis and Control of Linear Periodically Time Varying Systems (1991), ch. 3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.gradients.differentiable_run import DifferentiableRun
from runtime.orbits.shooting import NoPeriodicMotion

if TYPE_CHECKING:
    from runtime.orbits.motion import PeriodicMotion

SINGULAR_RESPONSE = 1e-10  # of the largest singular value of e^{i w T} - Phi


@dataclass(frozen=True)
class HarmonicResponse:
    """H (W, n_y, 2 M + 1) of outputs by name at w (W,) [rad/s], by harmonics m = -M .. M: see the module's text."""

    w: np.ndarray
    outputs: tuple[str, ...]
    harmonics: np.ndarray
    values: np.ndarray

    def of(self, output: str, m: int = 0) -> np.ndarray:
        """(W,) H_m of an output. Raises ArgumentError."""
        if output not in self.outputs or m not in self.harmonics:
            known = f"{', '.join(self.outputs)} and m up to {self.harmonics[-1]}"
            raise ArgumentError(f"response of {output!r}, m = {m}", "is not here", f"ask for {known}")
        return self.values[:, self.outputs.index(output), m - int(self.harmonics[0])]


def harmonic_response(
    motion: PeriodicMotion, by: str, w: Sequence[float] | np.ndarray, outputs: Sequence[str] = (), harmonics: int = 3
) -> HarmonicResponse:
    """Of outputs (all q_i) by an input that is disturbed by e^{i w t}, w [rad/s], with harmonics up to so many.

    Raises ArgumentError and ModelError for what cannot be used, NoPeriodicMotion where w resonates without damping.
    """
    model, states, n, steps = motion.model, motion.states, len(motion.x), motion.steps
    given = {one.name: one.default for one in model.description.inputs} | dict(model.input_values)
    value = (given | dict(model.sources) | dict(motion.inputs)).get(by)
    if not isinstance(value, int | float):
        raise ArgumentError(f"by {by!r}", "is not an input that is constant over the period", "name one")
    shown, h = tuple(outputs) or tuple(model.q_i), motion.period / steps
    held = (motion.t0 + h * np.arange(steps), np.full(steps, float(value)))
    run = DifferentiableRun(
        model, [*shown, *states.outputs], [*states.names, by], initial=states.upright, seen_every=0.0,
        **{**motion.setting, "inputs": {**motion.inputs, by: held}},
    )  # fmt: skip
    x = run.x0.copy()
    x[:n] = motion.x
    found = run.jacobian(x)
    own = len(shown)
    end = states.slopes(found.values[-1, own:], found.derivatives[-1, own:], motion.found.shot.ends[-1])
    frequencies, orders = np.atleast_1d(np.asarray(w, dtype=float)), np.arange(-harmonics, harmonics + 1)
    values = np.zeros((len(frequencies), own, len(orders)), dtype=complex)
    for k, one in enumerate(frequencies):
        start = _started(end[:, :n], _driven(end[:, n:], one, h, motion.t0), one * motion.period)
        y = np.array([row[:, :n] @ start for row in found.derivatives[:-1, :own]])
        for j in range(1, steps):
            y[j] += _driven(found.derivatives[j, :own, n : n + j], one, h, motion.t0)
        waves = np.exp(-1j * np.outer(one + orders * 2 * np.pi / motion.period, run.t[:-1]))
        values[k] = (waves @ y).T / steps
    return HarmonicResponse(frequencies, shown, orders, values)


def _driven(S: np.ndarray, w: float, h: float, t0: float) -> np.ndarray:
    """The integral of g e^{i w t}, of the integrals S (n, k) of g over the first k steps of h from t0 on."""
    wave = np.exp(1j * w * (t0 + h * (np.arange(S.shape[1]) + 0.5)))
    slopes = np.gradient(S, axis=1, edge_order=2) if S.shape[1] > 2 else np.zeros_like(S)
    return np.asarray(S @ wave * np.sinc(w * h / (2 * np.pi)) + slopes @ wave * (1j * w * h / 12))


def _started(monodromy: np.ndarray, G: np.ndarray, angle: float) -> np.ndarray:
    """dx(t0). Raises NoPeriodicMotion."""
    matrix = np.exp(1j * angle) * np.eye(len(G)) - monodromy
    sizes = np.linalg.svd(matrix, compute_uv=False)
    if sizes[-1] <= SINGULAR_RESPONSE * sizes[0]:
        raise NoPeriodicMotion("the response", "grows without bound: this w resonates", "take another w, or damping")
    return np.asarray(np.linalg.solve(matrix, G))
