"""A scheme on a model with parameters, compiled: what a run and a stepper in Python are both built on."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Self

import numpy as np

from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.results.observe import observe_samples
from runtime.results.solution import Solution
from runtime.running.plan import Plan
from runtime.schemes.kept_steppers import kept_stepper
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.restart import remembers
from runtime.schemes.switching.steps_with_stops import StepsWithStops, restart_of
from runtime.schemes.switching.times import SwitchTime, switching_times
from runtime.schemes.switching.watched import NEVER, all_awake, begin_events, watches


@dataclass(eq=False)
class SteppedModel:
    """model, plan and compiled stepper; p (n_p,), c (c_size,) and `ready`, what the compiled program reads.

    The arrays stay where they are and change in place: compiled code that was bound to them sees it. States z (flat)
    belong to whoever steps. switches: times at which loads or motions jump or kink, where they were looked for;
    broken: who steps across them.
    """

    model: Model
    plan: Plan
    stepper: Stepper
    p: np.ndarray
    c: np.ndarray
    ready: np.ndarray
    switches: list[SwitchTime] = field(default_factory=list, init=False)
    broken: StepsWithStops | None = field(default=None, init=False)

    @classmethod
    def prepared(cls, model: Model, plan: Plan, p: np.ndarray, engine: str, wait: bool = False) -> Self:
        """Prepare and compile, for parameters p (n_p,); wait: for the best code. Raises ModelError or CompilerError."""
        c = model.constants(p).copy()
        stepper = kept_stepper(plan.scheme, engine, wait)
        plan = replace(plan, scheme=stepper.scheme)
        return cls(model, plan, stepper, p.copy(), c, stepper.ready(c, plan.grid.dt_L).copy())

    def take(self, p: np.ndarray) -> None:
        """From now on these parameters (n_p,)."""
        self.p[:], self.c[:] = p, self.model.constants(p)
        self.ready[:] = self.stepper.ready(self.c, self.plan.grid.dt_L)

    def begin(self, t: float, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
        """The whole z at a consistent state of all coordinates (n,) at time t [s] (Eqs. 68-71)."""
        return self.stepper.start(t, q, q_dot, self.c, self.plan.grid.dt_L)

    def advance(self, z: np.ndarray, steps: int) -> None:
        """Make so many major steps in place, in one native call where nothing jumps."""
        if self.broken is None:
            self.stepper.run(z, self.ready, steps)
        else:
            self.broken.run(z, self.ready, self.c, steps)

    def hold(self, z: np.ndarray, w: np.ndarray) -> None:
        """From now on z (n_z,) has these numbers (n_w,) of the inputs; where they change, forces jump."""
        now = z[self._inputs]
        if not self.remembers or (now == w).all():
            now[:] = w
            return
        clock, dt, size = z[:2].copy(), self.plan.grid.dt_L, self.plan.scheme.layout.size
        t = float(clock[0] + clock[1] * dt)
        z[:size] = restart_of(self.stepper)(z[:size], self.plan.scheme.constants(self.c), dt, dt, t, inputs=w)
        z[:2] = clock

    @cached_property
    def _inputs(self) -> slice:
        return self.plan.scheme.layout.slice("inputs")

    @cached_property
    def remembers(self) -> bool:
        """Is the scheme started anew where forces jump?"""
        return not self.plan.scheme.adaptive and remembers(self.plan.scheme)

    def with_inputs(self, z: np.ndarray) -> np.ndarray:
        """(c_size,) the constants with the inputs that z holds."""
        layout = self.plan.scheme.layout
        if "inputs" not in layout.sizes:
            return self.c
        held = z[layout.slice("inputs")]
        return np.concatenate([self.c[: len(self.c) - len(held)], held])

    def find_switches(self, t0: float, t_end: float) -> None:
        """Look where something jumps on the grid of steps from t0 on, for the inputs as they are. Raises ModelError."""
        self.switches = self.stops(t0, t_end)
        scheme, length = self.plan.scheme, self.plan.grid.dt_L
        breaks = (
            bool(self.switches) or self.watches_events
        ) and not scheme.adaptive  # who chooses the ends of steps puts them there
        known = round((t_end - t0) / length)
        self.broken = StepsWithStops(self.stepper, t0, length, self.switches, self.c, known) if breaks else None

    def stops(self, t0: float, t_end: float) -> list[SwitchTime]:
        """Times at which steps end. Raises ModelError."""
        return switching_times(self.model, self.c, t0, t_end)

    def begin_events(self, z: np.ndarray) -> None:
        """Look for events from a state z (n_z,) on as if none had happened yet."""
        all_awake(self.plan.scheme, z)
        self.look_anew(z)

    def look_anew(self, z: np.ndarray) -> None:
        """From a state z (n_z,) on whose inputs have changed: an event that they move does not happen."""
        begin_events(self.plan.scheme, z, self.plan.scheme.constants(self.c))

    @property
    def watches_events(self) -> bool:
        """Has z their fields?"""
        return watches(self.plan.scheme)

    def first_event(self, z: np.ndarray) -> int | None:
        """The step in which an event was flagged first since z (n_z,) was last looked at, if one was."""
        if not self.watches_events:
            return None
        found = float(z[self.plan.scheme.layout.slice("event_step")][0])
        return int(found) if found < NEVER else None

    def bound(self, z: np.ndarray) -> Callable[[int], None]:
        """`advance` of a z that stays where it is: a call costs nothing but its steps."""
        return self.stepper.engine.bound(z, self.ready)

    def state(self, z: np.ndarray) -> np.ndarray:
        """The scheme's part of z, as a view."""
        return self.stepper.state(z)

    def observed(self, samples: Sequence[np.ndarray] | np.ndarray, status: Status | None = None) -> Solution:
        """Samples of the scheme's part of z as a Solution."""
        plan, status = self.plan, status or Status("completed", self.plan.t_end)
        return observe_samples(self.model, plan.scheme, np.array(samples), self.p, self.c, plan.name, {}, status)
