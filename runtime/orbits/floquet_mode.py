"""A Floquet mode as a motion, which everything that shows a solution can show.

A disturbance v of the start grows as Phi(t) v, with Phi the tangent of the run, and Phi(T) v = mu v. Its shape

    p(t) = Phi(t) v exp(-lambda t),    lambda = log(mu) / T

repeats with the period up to its frequency; what is drawn is q(t) + a Re(p(t) exp(i Im(lambda) t)), without the growth.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.status import Status
from runtime.gradients.differentiable_run import DifferentiableRun
from runtime.gradients.variables import parameters_at
from runtime.operating.modes import visible
from runtime.results.observe import assemble_solution
from runtime.results.solution import Solution

if TYPE_CHECKING:
    from runtime.orbits.motion import PeriodicMotion

FRAMES = 60  # a period


def floquet_mode(motion: PeriodicMotion, k: int, periods: int, amplitude: float | None) -> Solution:
    """See PeriodicMotion.mode."""
    model, count = motion.model, len(motion.x)
    if not 0 <= k < count:
        raise ArgumentError(f"mode {k}", f"is not there: {model.name} has {count} Floquet modes", "they count from 0")
    if periods < 1:
        raise ArgumentError("periods", f"is {periods!r}", "give a whole number of at least 1")
    exponent, multiplier = complex(motion.floquet.exponents[k]), motion.floquet.multipliers[k]
    if not np.isfinite(exponent):
        raise ArgumentError(f"mode {k}", "dies out within a period: its multiplier is 0", "take one that lasts")
    names = model.coordinates
    run = DifferentiableRun(
        model,
        [f"{name}{end}" for end in ("", "_dot", "_ddot") for name in names],
        motion.states.names,
        **motion.setting,
        initial=motion.states.upright,
        seen_every=max(1, motion.steps // FRAMES) * (motion.period / motion.steps),
    )
    found = run.jacobian(motion.x)
    values = found.values.reshape(-1, 3, len(names))
    moved = (found.derivatives @ motion.floquet.vectors[:, k]).reshape(-1, 3, len(names))
    shape = moved * np.exp(-exponent.real * (run.t - motion.t0))[:, None, None]
    p = parameters_at(run.model, motion.parameters, motion.t0)
    c = run.model.constants(p)
    at = values[0, 0], values[0, 1], motion.t0
    size = visible(run.model, at, c, np.abs(shape[:, 0]).max(axis=0)) if amplitude is None else amplitude
    on = np.zeros((3, len(names)))
    on[0] = values[-1, 0] - values[0, 0]  # whole turns
    turned = [np.exp(1j * exponent.imag * motion.period * j) for j in range(periods)]
    pieces = [values + j * on + size * (shape * turned[j]).real for j in range(periods)]
    whole = np.concatenate([*(one[:-1] for one in pieces), pieces[-1][-1:]])
    clocks = [run.t[:-1] + j * motion.period for j in range(periods)]
    t = np.append(np.concatenate(clocks), run.t[-1] + (periods - 1) * motion.period)
    q, q_dot, q_ddot = whole[:, 0], whole[:, 1], whole[:, 2]
    name, ended = f"Floquet mode {k + 1}, multiplier {multiplier:.4g}", Status("completed", float(t[-1]))
    dt = motion.period / motion.steps
    return assemble_solution(run.model, t, q, q_dot, q_ddot, p, c, name, dt, [], {}, ended)
