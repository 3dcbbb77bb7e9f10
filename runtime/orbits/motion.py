"""A motion that repeats: what it is, its simulation, and derivatives of what it shows, by parameters.

x0(p) is where F(x0, T, p) = x0 + turn, with the monodromy M = F_x and, where T is free, the phase as one more row. With
the objective J(x0, T, p) and one linear solve more,

    (I - M)^T w = J_x^T,        dJ/dp = J_p + w^T F_p + (J_T + w^T F_T) dT/dp

J_x and, with w, the two terms by p are ways back of one run each. T moves with p where it is that of turns at a speed;
there F_T are the rates at the end, and J_T is a central difference of the run with longer and shorter steps.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.lazy_method import LazyMethod
from runtime.contract.model import EmittedModel
from runtime.contract.status import Status
from runtime.gradients.differentiable_run import DifferentiableRun, Gradient
from runtime.gradients.objectives import Objective, Weighed
from runtime.gradients.variables import parameters_at
from runtime.orbits.controllers import remembering, states_of
from runtime.orbits.floquet import MEANINGS, Floquet
from runtime.orbits.shooting import Closed, NoPeriodicMotion
from runtime.orbits.states import States
from runtime.results.motion_error import MotionError
from runtime.running.inputs import InputValue
from runtime.running.simulate import simulate
from runtime.solutions.mode_motion import visible
from runtime.solutions.observe import assemble_solution
from runtime.solutions.solution import Solution

if TYPE_CHECKING:
    from runtime.orbits.response import harmonic_response as _harmonic_response

PERIOD_DIFFERENCE = 1e-5  # of the period: of a central difference by it
SINGULAR_SENSITIVITY = 1e-10  # of the largest singular value of I - M


@dataclass(frozen=True, repr=False)
class PeriodicMotion:
    """A motion x(t + T) = x(t), angles that turn modulo whole turns.

    period T [s]; x (n,): the state at t0 [s], see `state`; turns: whole turns a period, by coordinate that makes any;
    floquet: multipliers and what they mean; error: measured against the same motion with other steps, by coordinate;
    scheme, steps a period, parts that the period was cut into; iterations of Newton's method; parameters: those given;
    doublings: flips that its branch has passed.
    """

    model: EmittedModel
    period: float
    x: np.ndarray
    turns: dict[str, int]
    floquet: Floquet
    error: MotionError
    scheme: str
    steps: int
    parts: int
    iterations: int
    t0: float
    parameters: dict[str, float]
    free: bool
    speed: tuple[str, float] | None
    found: Closed = field(repr=False)
    options: Mapping[str, Any] = field(repr=False)
    inputs: Mapping[str, InputValue] = field(repr=False)
    doublings: int = 0

    @cached_property
    def states(self) -> States:
        """What the numbers of x are."""
        return states_of(self.model, self.inputs)

    @property
    def state(self) -> dict[str, float]:
        """Initial values by name at t0 [s]."""
        return self.states.by_name(self.x)

    @property
    def stability(self) -> str:
        """`stable`, `unstable` or `neutral`."""
        return self.floquet.stability

    @cached_property
    def solution(self) -> Solution:
        """One period of it, with reactions, stresses, views as of any run."""
        return self.simulate(1)

    def simulate(self, periods: float = 1, **changes: Any) -> Solution:
        """So many periods of it; changes: further arguments of `simulate`."""
        steps = max(1, round(self.steps * periods))
        given: dict[str, Any] = {
            **self.setting,
            "initial": self.state,
            "t_end": self.t0 + steps * (self.period / self.steps),
            "seen_every": max(1, self.steps // 200) * (self.period / self.steps),
            "error": "off",
        }
        if "samples" in changes:
            del given["seen_every"]
        return simulate(self.model, **{**given, **changes})

    @property
    def setting(self) -> dict[str, Any]:
        """One period of it as arguments of `simulate` and `DifferentiableRun`, without where it starts."""
        return {
            "parameters": self.parameters,
            "inputs": remembering(self.inputs, self.x) or None,
            "scheme": self.scheme,
            "options": dict(self.options) or None,
            "start": "given",
            "t0": self.t0,
            "t_end": self.t0 + self.period,
            "dt": self.period / self.steps,
        }

    def mode(self, k: int = 0, periods: int = 4, amplitude: float | None = None) -> Solution:
        """The motion with a Floquet mode upon it, without its growth, for views, films and plots.

        k: counted from 0 by falling size of multipliers; amplitude: of the vector `floquet.vectors[:, k]`; by default
        angles move by 0.2 rad and points by a tenth of the mechanism's length. To first order: loops are not closed
        anew. Raises ArgumentError for a mode that is not there, or that dies out within a period.
        """
        return _floquet_mode(self, k, periods, amplitude)

    def gradient(self, of: Objective, by: Sequence[str]) -> Gradient:
        """d(of)/d(by) of the motion that stays periodic: by the implicit-function theorem, one way back for all `by`.

        of: an objective of outputs over the period (runtime.gradients.objectives); by: parameters. Raises
        ArgumentError, ModelError, NoResult, and NoPeriodicMotion at a fold, where there is no derivative.
        """
        return _gradient(self, of, by)

    if TYPE_CHECKING:
        response = _harmonic_response
    else:

        @LazyMethod
        def response():
            from runtime.orbits.response import harmonic_response

            return harmonic_response

    def remarks(self) -> list[str]:
        """What to know about it."""
        kind = self.floquet.kind
        return [f"unstable by a {kind}: {MEANINGS[kind]}"] if kind else []

    def __repr__(self) -> str:
        kind = f" ({self.floquet.kind})" if self.floquet.kind else ""
        summary = f"period {self.period:.10g} s, {self.stability}{kind}, largest multiplier {self.floquet.largest:.6g}"
        return (
            f"<PeriodicMotion of {self.model.name}: {summary}, "
            f"error {self.error.largest:.2g} of the amplitude of {self.error.of}>"
        )


@dataclass(frozen=True)
class _AtEnd:
    """An objective plus w . y(end), y the outputs `shown`."""

    own: Objective
    shown: tuple[str, ...]
    w: np.ndarray

    @property
    def outputs(self) -> tuple[str, ...]:
        """Of both, each once, the objective's first."""
        return tuple(dict.fromkeys((*self.own.outputs, *self.shown)))

    def weighed(self, t: np.ndarray, y: np.ndarray) -> Weighed:
        """J + w . y_N."""
        count, columns = len(self.own.outputs), [self.outputs.index(name) for name in self.shown]
        value, slope = self.own.weighed(t, y[:, :count])
        found = np.zeros_like(y)
        found[:, :count] = slope
        found[-1, columns] += self.w
        return value + float(self.w @ y[-1, columns]), found


def _gradient(motion: PeriodicMotion, of: Objective, by: Sequence[str]) -> Gradient:
    """See PeriodicMotion.gradient."""
    model = motion.model
    own = {entry.name for entry in model.parameters}
    unknown = [name for name in by if name not in own]
    if unknown:
        raise ArgumentError(f"by {unknown[0]!r}", f"is not a parameter of model {model.name}", "see model.parameters")
    states, n = motion.states, len(motion.x)
    shown = tuple(states.outputs)
    run = gradient_run(motion, tuple(dict.fromkeys((*of.outputs, *shown))), [*states.names, *by])
    x = run.x0.copy()
    x[:n] = motion.x
    first = run.gradient(of, x)
    w = _adjoint(motion, run, of, x, first.derivatives[:n])
    last = np.array([first.outputs[name][-1] for name in shown])
    slopes = states.slopes(last, np.eye(len(shown)), motion.found.shot.ends[-1])
    whole = run.gradient(_AtEnd(of, shown, w @ slopes), x, mode="reverse")
    found = whole.derivatives[n:].copy()
    if motion.speed is not None and motion.speed[0] in by:
        rate = -motion.period / x[n + list(by).index(motion.speed[0])]
        by_period = _by_period(run, motion, of, x) + w @ motion.found.shot.rates[-1]
        found[list(by).index(motion.speed[0])] += rate * by_period
    return replace(first, by=tuple(by), derivatives=found, mode="reverse")


def gradient_run(motion: PeriodicMotion, outputs: Sequence[str], by: Sequence[str]) -> DifferentiableRun:
    """One period of a motion, seen at every step; what is prepared is kept by the model, unless inputs drive it."""
    model = motion.model

    def first() -> DifferentiableRun:
        without = {name: value for name, value in motion.setting.items() if name != "parameters"}
        return DifferentiableRun(model, outputs, by, **without, initial=motion.states.upright, seen_every=0.0)

    key = f"gradient of an orbit by {motion.scheme} {dict(motion.options)} {tuple(outputs)} {tuple(by)}"
    run = first() if motion.inputs else model.derived(key, first)
    return run.over(motion.t0, motion.period, motion.steps, 1, motion.parameters)


def _adjoint(
    motion: PeriodicMotion, run: DifferentiableRun, of: Objective, x: np.ndarray, J_x: np.ndarray
) -> np.ndarray:
    """(n,) w; where the period is free with the phase, which holds x0 across the motion. NoPeriodicMotion at a fold."""
    n = len(motion.x)
    matrix = np.eye(n) - motion.found.shot.monodromy
    right = J_x
    if motion.free:  # rows: (x, phase), columns: (x, T)
        rates = motion.found.shot.rates[-1]
        J_T = _by_period(run, motion, of, x)
        matrix = np.block([[matrix, -rates[:, None]], [rates[None, :] / np.linalg.norm(rates), np.zeros((1, 1))]])
        right = np.append(J_x, J_T)
    singular = np.linalg.svd(matrix, compute_uv=False)
    if singular[-1] <= SINGULAR_SENSITIVITY * singular[0]:
        raise NoPeriodicMotion(
            f"model {motion.model.name}",
            "the motion has no derivative: a Floquet multiplier is 1 (a fold, or a coordinate that nothing holds)",
            "move away from the fold, or give the model damping",
        )
    return np.asarray(np.linalg.solve(matrix.T, right)[:n])


def _by_period(run: DifferentiableRun, motion: PeriodicMotion, of: Objective, x: np.ndarray) -> float:
    """dJ/dT at held initial values and parameters."""
    values = []
    columns = [run.outputs.index(name) for name in of.outputs]
    for sign in (1.0, -1.0):
        longer = run.over(motion.t0, motion.period * (1.0 + sign * PERIOD_DIFFERENCE))
        values.append(of.weighed(longer.t, longer.values(x)[:, columns])[0])
    return float((values[0] - values[1]) / (2 * PERIOD_DIFFERENCE * motion.period))


# A Floquet mode as a motion, which everything that shows a solution can show.
#
# A disturbance v of the start grows as Phi(t) v, with Phi the tangent of the run, and Phi(T) v = mu v. Its shape
#
#     p(t) = Phi(t) v exp(-lambda t),    lambda = log(mu) / T
#
# repeats with the period up to its frequency; what is drawn is q(t) + a Re(p(t) exp(i Im(lambda) t)), without the
# growth.

FRAMES_OF_PERIOD = 60  # a period


def _floquet_mode(motion: PeriodicMotion, k: int, periods: int, amplitude: float | None) -> Solution:
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
        seen_every=max(1, motion.steps // FRAMES_OF_PERIOD) * (motion.period / motion.steps),
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
