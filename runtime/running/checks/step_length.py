"""The stability limit of the step: checked at the start, and named in the advice of other checks."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Status
from runtime.operating.mode_solver import ModeSolver, State
from runtime.running.checks.check import Check, Subject
from runtime.schemes.step_limit import StepLimit


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
    model, scheme = subject.model, subject.scheme
    if subject.good is None or not scheme.limited(scheme.options) or not ModeSolver.possible(model):
        return None
    seen = scheme.observer(z=subject.good, c=subject.c)
    loop = [model.q_d.index(name) for name in model.loop_unknowns]
    q_i, rates, q_d = (np.asarray(seen[name]).ravel() for name in ("q_i", "q_i_dot", "q_d"))
    try:
        solver = ModeSolver(model, subject.c[: model.c_size])
        return scheme.step_limit(*solver.slopes(State(float(seen["t"]), q_i, rates, q_d[loop])))
    except np.linalg.LinAlgError:  # not finite, or M_hat is singular
        return None


def step_advice(subject: Subject, below: str = "") -> str:
    """The limit at the last good state against the step; below: what to say where the step is below it."""
    if subject.scheme.adaptive:
        return "Give a smaller tolerance."
    limit, h = step_limit(subject), subject.scheme.grid.h[-1]
    if limit is None:
        return "Reduce the step."
    text = (
        f"The {limit} at the last good state: the scheme needs a step below {limit.h:.3g} s there, and the "
        f"fastest group's step is {h:.3g} s."
    )
    if h > limit.h:
        return text
    if below:
        return f"{text} {below}"
    if len(subject.scheme.grid.groups) > 1:
        return text + (
            " So the sub-cycling itself is unstable (a frozen q_L_ddot acts as negative damping): "
            "reduce m or dt, add damping, or use single_rate."
        )
    return text + " So the growth may be physical: a spinning beam without geometric stiffening diverges, for instance."
