"""A scheme on a model with parameters, compiled: what a run and a stepper in Python are both built on."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.results.observe import observe_samples
from runtime.results.solution import Solution
from runtime.running.plan import Plan
from runtime.schemes.stepper import Stepper


@dataclass(eq=False)
class SteppedModel:
    """model, plan and compiled stepper; p (n_p,), c (c_size,) and `ready`, what the compiled program reads.

    The arrays stay where they are and change in place: compiled code that was bound to them sees it. States z (flat)
    belong to whoever steps.
    """

    model: Model
    plan: Plan
    stepper: Stepper
    p: np.ndarray
    c: np.ndarray
    ready: np.ndarray

    @classmethod
    def prepared(cls, model: Model, plan: Plan, p: np.ndarray, engine: str, wait: bool = False) -> Self:
        """Prepare and compile, for parameters p (n_p,); wait: for the best code. Raises ModelError or CompilerError."""
        c = model.constants(p).copy()
        stepper = Stepper(plan.scheme, engine, wait)
        return cls(model, plan, stepper, p.copy(), c, stepper.ready(c, plan.grid.dt_L).copy())

    def take(self, p: np.ndarray) -> None:
        """From now on these parameters (n_p,)."""
        self.p[:], self.c[:] = p, self.model.constants(p)
        self.ready[:] = self.stepper.ready(self.c, self.plan.grid.dt_L)

    def begin(self, t: float, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
        """The whole z at a consistent state of all coordinates (n,) at time t [s] (Eqs. 68-71)."""
        return self.stepper.start(t, q, q_dot, self.c, self.plan.grid.dt_L)

    def advance(self, z: np.ndarray, steps: int) -> None:
        """Make so many major steps in one native call, in place."""
        self.stepper.run(z, self.ready, steps)

    def bound(self, z: np.ndarray) -> Callable[[int], None]:
        """`advance` of a z that stays where it is: a call costs nothing but its steps."""
        return self.stepper.engine.bound(z, self.ready)

    def state(self, z: np.ndarray) -> np.ndarray:
        """The scheme's part of z, as a view."""
        return self.stepper.state(z)

    def observed(self, samples: Sequence[np.ndarray], status: Status | None = None) -> Solution:
        """Samples of the scheme's part of z as a Solution."""
        plan, status = self.plan, status or Status("completed", self.plan.t_end)
        return observe_samples(self.model, plan.scheme, np.array(samples), self.p, self.c, plan.name, {}, status)
