"""A run as a differentiable function of parameters and initial values: outputs at saved times and their slopes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.errors import ArgumentError, NoResult
from runtime.contract.model import Model, ModelError
from runtime.engine.derivatives_code import Recorder, TangentCode, most_lanes
from runtime.engine.native import NativeProgram
from runtime.gradients.assembly import start_slopes
from runtime.gradients.beginning import Beginning
from runtime.gradients.derivatives_of_run import Gradient, OutputJacobian
from runtime.gradients.driving import driven_by, parameters_at
from runtime.gradients.equilibrium_slopes import settled_slopes
from runtime.gradients.objectives import Objective
from runtime.gradients.observed_program import observed_program
from runtime.gradients.outputs import check_outputs
from runtime.gradients.passes import Backward, SampleGrid, Weigh, forward
from runtime.gradients.switches import Switches
from runtime.gradients.variables import variables_of
from runtime.gradients.watch import Watch
from runtime.operating.given_state import given_state
from runtime.running.inputs import InputValue
from runtime.running.plan import make_plan
from runtime.schemes.stepper import start_vector
from runtime.start.start_state import start_state

Values = Sequence[float] | np.ndarray | Mapping[str, float] | None
MODES = ("auto", "forward", "reverse")


@dataclass(frozen=True)
class _Begun:
    z: np.ndarray
    ready: np.ndarray
    x: np.ndarray
    slopes: np.ndarray
    watch: Watch


class DifferentiableRun:
    """A run of a model prepared once; its methods take values of `by`, in order or by name (None: those of the start).

    outputs: names at the saved times (coordinates, rates, accelerations, measures, energies, multipliers, joint
    forces). by: names of parameters, coordinates and rates (`_dot`, at the start). The other arguments are those of
    `simulate`. Raises ModelError, SchemeError, InitialStateError, ArgumentError for what cannot be used.
    """

    def __init__(
        self,
        model: Model,
        outputs: Sequence[str],
        by: Sequence[str],
        *,
        parameters: Mapping[str, float] | None = None,
        initial: Mapping[str, float] | None = None,
        t_end: float | None = None,
        dt: float | None = None,
        m: list[int] | None = None,
        scheme: str | None = None,
        options: Mapping[str, Any] | None = None,
        start: str | None = None,
        t0: float = 0.0,
        inputs: Mapping[str, InputValue] | None = None,
        save_every: int | None = None,
        wait: bool = False,
    ) -> None:
        model = driven_by(model, inputs)
        if not model.q_i:
            raise ModelError(f"every coordinate of model {model.name} is driven: there is nothing to step")
        self.model, self.outputs, self.variables = model, check_outputs(model, outputs), variables_of(model, by)
        self.plan = make_plan(model, t_end, dt, m, scheme, save_every, options, t0)
        self._parameters, self._initial = dict(parameters or {}), dict(initial or {})
        self._start, self._wait = self._start_of(start), wait
        self.program = observed_program(self.plan.scheme, self.outputs, [k for _, k in self.variables.parameters])
        self._refuse_idle()
        every, steps = self.plan.save_every, self.plan.steps
        rest = [steps % every] if steps % every else []
        self.samples = SampleGrid(tuple([every] * (steps // every) + rest))
        self.t = self.plan.t0 + np.concatenate([[0], np.cumsum(self.samples.steps)]) * self.plan.grid.dt_L
        self._switches = Switches(self.plan, self.program, [k for _, k in self.variables.parameters])
        self.x0 = self._values_of_start()

    @property
    def by(self) -> tuple[str, ...]:
        """Names of what is differentiated by."""
        return self.variables.names

    # ---- what is asked for ----------------------------------------------------------------------------------

    def values(self, x: Values = None) -> np.ndarray:
        """Outputs (N, n_y). Raises NoResult for a run that does not come to its end."""
        begun = self._begun(x, slopes=False)
        z, y = begun.z.copy(), np.zeros((self.samples.count, len(self.outputs)))
        stepping, observing = self._plain
        for k in range(self.samples.count):
            if k:
                stepping.run(z, begun.ready, self.samples.steps[k - 1])
            observing.run(z, begun.ready, 1)
            y[k] = z[self.program.outputs]
        begun.watch.end(z)
        return y

    def jacobian(self, x: Values = None) -> OutputJacobian:
        """Outputs and their derivatives, one direction a lane."""
        begun = self._begun(x)
        directions = self._beginning.tangents(begun.x, begun.slopes)
        y, slopes, last = forward(self.program, self._tangents, self.samples, begun.z, begun.ready, directions)
        begun.watch.end(last)
        self._switches.check(begun.z, begun.ready, self.plan.steps)
        self._require_finite(slopes)
        return OutputJacobian(self.t, self.outputs, self.by, y, slopes)

    def gradient(self, objective: Objective, x: Values = None, mode: str = "auto") -> Gradient:
        """Of an objective made of these outputs. mode: `forward`, `reverse`, or by what costs less."""
        if mode not in MODES:
            raise ArgumentError("mode", f"is {mode!r}", f"give one of {', '.join(MODES)}")
        missing = [name for name in objective.outputs if name not in self.outputs]
        if missing:
            raise ArgumentError("objective", f"needs the output {missing[0]!r}", "name it when the run is prepared")
        columns = [self.outputs.index(name) for name in objective.outputs]
        found: list[float] = []

        def weigh(y: np.ndarray) -> np.ndarray:
            value, slope = objective.weighed(self.t, y[:, columns])
            found.append(value)
            bars = np.zeros_like(y)
            bars[:, columns] = slope
            return bars

        chosen = mode if mode != "auto" else "forward" if len(self.by) <= most_lanes() else "reverse"
        if chosen == "forward":
            jacobian = self.jacobian(x)
            y = jacobian.values
            derivatives = np.einsum("ny,nyk->k", weigh(y), jacobian.derivatives)
        else:
            y, derivatives = self._reverse(x, weigh)
        self._require_finite(derivatives[None, None, :])
        outputs = {name: y[:, k] for k, name in enumerate(self.outputs)}
        return Gradient(found[0], self.by, derivatives, chosen, self.t, outputs)

    # ---- inside ---------------------------------------------------------------------------------------------

    def _reverse(self, x: Values, weigh: Weigh) -> tuple[np.ndarray, np.ndarray]:
        begun = self._begun(x)
        y, adjoint, last = self._backward.run(begun.z, begun.ready, weigh)
        begun.watch.end(last)
        self._switches.check(begun.z, begun.ready, self.plan.steps)
        return y, begun.slopes.T @ self._beginning.pulled_back(begun.x, adjoint)

    @cached_property
    def _plain(self) -> tuple[NativeProgram, NativeProgram]:
        return NativeProgram(self.program.step, wait=self._wait), NativeProgram(self.program.observe, wait=self._wait)

    @cached_property
    def _tangents(self) -> tuple[TangentCode, TangentCode]:
        width = min(most_lanes(), 1 << (len(self.by) - 1).bit_length())
        active, wait = self.program.active, self._wait
        programs = (self.program.step, self.program.observe)
        stepping, observing = (TangentCode(one, active, width, wait) for one in programs)
        return stepping, observing

    @cached_property
    def _backward(self) -> Backward:
        active, wait = self.program.active, self._wait
        recorders = (Recorder(self.program.step, active, wait), Recorder(self.program.observe, active, wait))
        return Backward(self.program, recorders, self.samples)

    @cached_property
    def _beginning(self) -> Beginning:
        return Beginning(self.program, self.plan.t0)

    def _values_of_start(self) -> np.ndarray:
        """x of the start: what the arguments say, else what the model says."""
        p = parameters_at(self.model, self._parameters, self.plan.t0)
        given = {**self._initial}
        state = start_state(self.model, p, self.model.constants(p), self.plan.t0, given, self._start)
        x = np.zeros(len(self.by))
        for k, entry in self.variables.parameters:
            x[k] = p[entry]
        for k, column, is_rate in self.variables.initial:
            x[k] = (state.q_dot if is_rate else state.q)[column]
        return x

    def _begun(self, x: Values, slopes: bool = True) -> _Begun:
        values = self.x0 if x is None else self.variables.checked(x)
        parameters, initial = self.variables.named(values)
        given = {**self._initial, **initial}
        model, scheme, plan = self.model, self.plan.scheme, self.plan
        p = parameters_at(model, {**self._parameters, **parameters}, plan.t0)
        c = model.constants(p)
        state = start_state(model, p, c, plan.t0, given, self._start)
        z = self.program.prepared.widened(start_vector(scheme, plan.t0, state.q, state.q_dot, c))
        i, loop = model.independent_columns, model.loop_columns
        moved = self._start_slopes(p, c, given) if slopes else np.zeros((0, 0))
        watch = Watch(plan, c, p)
        watch.begin(z)
        where = np.concatenate([p, state.q[i], state.q_dot[i], state.q[loop]])
        return _Begun(z, self.program.prepared.ready(scheme.constants(c)), where, moved, watch)

    def _start_slopes(self, p: np.ndarray, c: np.ndarray, given: Mapping[str, float]) -> np.ndarray:
        """d(p, q_i, q_i_dot, loop unknowns)/dx of the start."""
        model, t0 = self.model, self.plan.t0
        assembled = given_state(model, p, c, t0, given)
        slopes = start_slopes(model, p, t0, assembled, given, self.variables)
        if self._start == "given" or not set(model.elastic) & set(model.q_i):
            return slopes
        unstable = self._start == "quasi_static_unstable"
        return settled_slopes(model, p, c, t0, assembled, slopes, unstable)

    def _start_of(self, start: str | None) -> str:
        """The kind of start, as a simulation takes it. Raises InitialStateError for one that does not go with `by`."""
        chosen = start or str(self.model.simulation.get("start", "given"))
        names = {name + end for name in self.model.elastic for end in ("", "_dot")}
        if start is None and names & {*self._initial, *self.by}:
            return "given"
        if chosen != "given" and names & set(self.by):
            raise InitialStateError(
                f"start = {chosen}: {', '.join(sorted(names & set(self.by)))} follow from the equilibrium; leave them "
                "out of `by`, or take start = given"
            )
        return chosen

    def _refuse_idle(self) -> None:
        """Raises ArgumentError for a parameter that no function of the model reads."""
        acting = self.model.kernel("constants").jac_sparsity(0, 0)
        columns = set(acting.get_triplet()[1])
        for k, entry in self.variables.parameters:
            if entry not in columns:
                raise ArgumentError(
                    f"parameter {self.by[k]}",
                    "enters the equations only as structure or as drawing: nothing that is computed depends on it",
                    "leave it out of `by`",
                )

    def _require_finite(self, slopes: np.ndarray) -> None:
        bad = ~np.isfinite(slopes).all(axis=(0, 1))
        if bad.any():
            names = ", ".join(name for name, wrong in zip(self.by, bad, strict=True) if wrong)
            raise NoResult(
                f"derivative by {names}",
                "is not finite: the run passes a point where a function has none (a root at zero, a division)",
                "start a little beside that point",
            )
