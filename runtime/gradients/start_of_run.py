"""Where a differentiated run starts for values of what is differentiated by, and how that moves with them."""

from __future__ import annotations

import numpy as np

from runtime.contract.consistent_state import ConsistentState, InitialStateError
from runtime.contract.coordinates import independent, loop_part, parameter_columns
from runtime.contract.orientations import angular_velocity
from runtime.gradients.impacts import held_at_start, held_slopes
from runtime.gradients.observed_program import ObservedProgram
from runtime.gradients.run_checks import RunChecks
from runtime.gradients.settled_slopes import settled_slopes
from runtime.gradients.start_slopes import Given, start_slopes, turned_start
from runtime.gradients.started_run import StartedRun
from runtime.gradients.variables import Variables, parameters_at
from runtime.operating.given_state import given_state
from runtime.running.problem import Plan
from runtime.running.time_functions import check_time_functions
from runtime.schemes.stepper import start_vector
from runtime.start.start_state import start_state


class StartOfRun:
    """parameters and initial: values by name that hold where x says nothing else; start: as `simulate` takes it."""

    def __init__(
        self,
        program: ObservedProgram,
        plan: Plan,
        variables: Variables,
        parameters: Given,
        initial: Given,
        start: str | None,
    ) -> None:
        self._program, self._plan, self._variables = program, plan, variables
        self._model = plan.scheme.model
        self._parameters, self._initial = dict(parameters), dict(initial)
        self._start, self._kind = start, self._kind_of(start)

    def on(self, program: ObservedProgram, plan: Plan, parameters: Given | None = None) -> StartOfRun:
        """The same start of a program and plan with other steps, another time and further parameters."""
        own = {**self._parameters, **(parameters or {})}
        return StartOfRun(program, plan, self._variables, own, self._initial, self._start)

    def values(self) -> np.ndarray:
        """(n,) x of the start: what was given, else what the model says. Raises ModelError for a motion that jumps."""
        p = parameters_at(self._model, self._parameters, self._plan.t0)
        c = self._model.constants(p)
        state = start_state(self._model, p, c, self._plan.t0, self._initial, self._kind)
        check_time_functions(self._model, c, self._plan, state)
        x = np.zeros(len(self._variables.names))
        for k, entry, _ in self._variables.parameters:
            x[k] = p[entry]
        for k, column, is_rate in self._variables.initial:
            x[k] = (state.q_dot if is_rate else state.q)[column]
        for k, value in self._variables.samples:
            x[k] = value
        for k, body, axis, is_rate in self._variables.turns:
            e = parameter_columns(self._model)[body]
            x[k] = angular_velocity(state.q[e], state.q_dot[e])[axis] if is_rate else 0.0
        return x

    def started(self, x: np.ndarray, slopes: bool) -> StartedRun:
        """The beginning for values x (n,), with its derivatives if they are asked for. Raises NoResult."""
        parameters, initial = self._variables.named(x)
        given = turned_start(self._model, {**self._initial, **initial}, self._variables, x)
        model, scheme, plan = self._model, self._plan.scheme, self._plan
        p = parameters_at(model, {**self._parameters, **parameters}, plan.t0)
        c = model.constants(p)
        state = start_state(model, p, c, plan.t0, given, self._kind)
        z = self._program.prepared.widened(start_vector(scheme, plan.t0, state.q, state.q_dot, c))
        if (held := held_at_start(scheme, z, c, p)) is not None:
            c = model.constants(p)
            z = self._program.prepared.widened(start_vector(scheme, plan.t0, state.q, state.q_dot, c))
        moved = self._slopes(p, c, given, state, x) if slopes else np.zeros((0, 0))
        checks = RunChecks(plan, c, p)
        checks.begin(z)
        where = np.concatenate([p, *independent(model, state.q, state.q_dot), loop_part(model, state.q)])
        if slopes and held is not None:
            moved = held_slopes(model, plan.t0, where, moved, self._variables.names, held)
        return StartedRun(
            z, self._program.prepared.ready(scheme.constants(c)), where, moved, x, checks, (state.q, state.q_dot)
        )

    def _slopes(self, p: np.ndarray, c: np.ndarray, given: Given, state: ConsistentState, x: np.ndarray) -> np.ndarray:
        """d(p, q_i, q_i_dot, loop unknowns)/dx at the start's state."""
        model, t0 = self._model, self._plan.t0
        assembled = state if self._kind == "given" else given_state(model, p, c, t0, given)
        slopes = start_slopes(model, p, t0, assembled, given, self._variables, x)
        if self._kind == "given" or not set(model.elastic) & set(model.q_i):
            return slopes
        return settled_slopes(model, p, c, t0, assembled, slopes, self._kind == "quasi_static_unstable")

    def _kind_of(self, start: str | None) -> str:
        """As a simulation takes it. Raises InitialStateError for one that does not go with `by`."""
        chosen = start or str(self._model.simulation.get("start", "given"))
        if chosen == "equilibrium":
            raise InitialStateError(
                "start = equilibrium is not differentiated: give its values as initial, or take quasi_static"
            )
        names = {name + end for name in self._model.elastic for end in ("", "_dot")}
        if start is None and names & {*self._initial, *self._variables.names}:
            return "given"
        following = ", ".join(sorted(names & set(self._variables.names)))
        if chosen != "given" and following:
            raise InitialStateError(
                f"start = {chosen}: {following} follow from the equilibrium; do not name them, or take start = given"
            )
        return chosen
