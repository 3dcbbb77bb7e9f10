"""The stability limit of the step: checked at the start, and named in the advice of other checks."""

from __future__ import annotations

import numpy as np

from runtime.contract.coordinates import independent_part, loop_part, whole
from runtime.contract.status import Status
from runtime.operating.mode_solver import ModeSolver, State
from runtime.running.checks.check import Check, Subject
from runtime.schemes.step_limit import StepLimit, eigenvalues

STRONG = 5.0  # times that a motion decays by e in a step, from which advice names the damper


class StepLength(Check):
    """`step_too_long`: the fastest group's step is above the limit that the modes at the start set.

    limit [s]: None if nothing limits the step or the modes are not known. force: run all the same.
    """

    def __init__(self, subject: Subject, force: bool) -> None:
        super().__init__(subject)
        self.force = force
        self.limit: float | None = None

    def start(self, z: np.ndarray) -> Status | None:
        """Compare the step with its limit."""
        limit = step_limit(self.subject)
        self.limit = limit.h if limit else None
        h = self.subject.scheme.grid.h[-1]
        if self.limit is None or h <= self.limit or self.force:
            return None
        return self.subject.stop(
            "step_too_long", f"the step {h:.3g} s of the fastest group is above its limit", step_advice(self.subject)
        )


def step_limit(subject: Subject) -> StepLimit | None:
    """What limits the step at the last good state. None if nothing does, or if its modes are not known."""
    slopes = _slopes(subject) if subject.scheme.limited(subject.scheme.options) else None
    return None if slopes is None else subject.scheme.step_limit(*slopes)


def _slopes(subject: Subject) -> tuple[np.ndarray, np.ndarray] | None:
    """A_q, A_v (n_i x n_i) of w'' = A_q w + A_v w' at the last good state; None where they are not known."""
    model = subject.model
    if subject.good is None or not ModeSolver.possible(model):
        return None
    seen = subject.scheme.observer(z=subject.good, c=subject.c)
    q_i, rates, q_d = (np.asarray(seen[name]).ravel() for name in ("q_i", "q_i_dot", "q_d"))
    q = whole(model, q_i, q_d)
    q_i, loop = independent_part(model, q), loop_part(model, q)
    try:
        found = ModeSolver(model, subject.c[: model.c_size]).slopes(State(float(seen["t"]), q_i, rates, loop))
    except np.linalg.LinAlgError:  # M_hat is singular
        return None
    return found if all(np.isfinite(slope).all() for slope in found) else None


def step_advice(subject: Subject, below: str = "") -> str:
    """The limit at the last good state against the step, and what to do about a strong damper; below: what to say where
    the step is below the limit.
    """
    if subject.scheme.adaptive:
        return "Give a smaller tolerance."
    slopes, h = _slopes(subject), subject.scheme.grid.h[-1]
    damper = "" if slopes is None else _damper(*slopes, h)
    limit = subject.scheme.step_limit(*slopes) if slopes and subject.scheme.limited(subject.scheme.options) else None
    if limit is None:
        return damper or "Reduce the step."
    text = (
        f"The {limit} at the last good state: the scheme needs a step below {limit.h:.3g} s there, and the "
        f"fastest group's step is {h:.3g} s."
    )
    if h > limit.h:
        return f"{text} {damper}".rstrip()
    if below:
        return f"{text} {below}"
    if len(subject.scheme.grid.groups) > 1:
        return text + (
            " So the sub-cycling itself is unstable (a frozen q_L_ddot acts as negative damping): "
            "reduce m or dt, add damping, or use single_rate."
        )
    return text + " So the growth may be physical: a spinning beam without geometric stiffening diverges, for instance."


def _damper(A_q: np.ndarray, A_v: np.ndarray, h: float) -> str:
    """Advice where a motion decays much faster than a step; else nothing."""
    decay = float((-eigenvalues(A_q, A_v).real).max(initial=0.0))
    if not decay * h > STRONG:
        return ""
    return (
        f"A damper lets a motion decay at {decay:.3g} 1/s, {decay * h:.3g} times in a step of {h:.3g} s: take radau or "
        "exponential with propagation = decaying, whose steps let such a decay die out."
    )
