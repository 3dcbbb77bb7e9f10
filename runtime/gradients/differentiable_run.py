"""A run as a differentiable function of parameters and initial values: outputs at saved times and their slopes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, Kind, arguments
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import EmittedModel
from runtime.engine.derivatives import Recorder, TangentCode, most_lanes
from runtime.engine.native import NativeProgram
from runtime.gradients.course import Course, MovingJumps, Stop, Turn, course
from runtime.gradients.event_crossings import EventCrossings
from runtime.gradients.objectives import Objective
from runtime.gradients.observed_program import ObservedProgram, check_outputs, observed_program
from runtime.gradients.passes import Backward, forward
from runtime.gradients.recorded_run import RecordedRun, require_finite
from runtime.gradients.start_of_run import StartOfRun
from runtime.gradients.started_run import Beginning, StartedRun
from runtime.gradients.switches import Switches
from runtime.gradients.turns import TurnProgram
from runtime.gradients.variables import Inputs, driven_by, held_samples, holds_of, variables_of
from runtime.running.planning import make_plan
from runtime.running.problem import seen_every_of, span_of
from runtime.schemes.switching.times import switches_by_inputs

Values = Sequence[float] | np.ndarray | Mapping[str, float]
MODES = ("auto", "forward", "reverse")
OBJECTIVE = Kind(
    lambda value: NAMES.holds(getattr(value, "outputs", None)) and hasattr(value, "weighed"),
    'give an objective, such as End("tip_y")',
)


class RunCode:
    """A step and its outputs, compiled when they are asked for: plain, along `count` directions, and recorded."""

    def __init__(self, program: ObservedProgram, count: int, wait: bool) -> None:
        self._program, self._count, self._wait = program, count, wait
        self._turns: dict[str, TurnProgram] = {}

    @property
    def width(self) -> int:
        """Directions side by side."""
        return min(most_lanes(), 1 << (self._count - 1).bit_length())

    def turns(self, turn: Turn) -> TurnProgram:
        """The program of a turn."""
        if turn.kind not in self._turns:
            self._turns[turn.kind] = TurnProgram(self._program, turn.kind, self.width, self._wait)
        return self._turns[turn.kind]

    def turned(self, stop: Stop, z: np.ndarray, started: StartedRun) -> np.ndarray:
        """What is done at a stop before its steps, to z (n_z,) in place; what the steps read."""
        if stop.turn is not None:
            return self.turns(stop.turn).take(stop.turn, z, started)
        z[0] = stop.t0
        return started.ready

    @cached_property
    def plain(self) -> tuple[NativeProgram, NativeProgram]:
        """Values."""
        step, observe = self._program.step, self._program.observe
        return NativeProgram(step, wait=self._wait), NativeProgram(observe, wait=self._wait)

    @cached_property
    def tangents(self) -> tuple[TangentCode, TangentCode]:
        """Values and slopes, a direction a lane."""
        own, active, how = self._program, self._program.active, (self.width, self._wait)
        return TangentCode(own.step, active, *how), TangentCode(own.observe, active, *how)

    @cached_property
    def beginning(self) -> Beginning:
        """How the start moves."""
        return Beginning(self._program)

    @cached_property
    def recorders(self) -> tuple[Recorder, Recorder]:
        """Values, and the way back."""
        active, wait = self._program.active, self._wait
        return Recorder(self._program.step, active, wait), Recorder(self._program.observe, active, wait)


class DifferentiableRun:
    """Prepare a run of a model once, as a function of the values x of `by`; `x0` holds those of the start.

    Parameters
    ----------
    model : Model
        The mechanism.
    outputs : sequence of str
        Names at the saved times: coordinates, rates, accelerations, measures, energies, multipliers, joint
        forces.
    by : sequence of str
        Names of parameters, coordinates and rates (`_dot`, at the start) that it is differentiated by.
    parameters, initial, t_end, dt, m, scheme, options, start, t0, inputs, seen_every, samples : optional
        As of `simulate`.
    wait : bool
        Whether to wait until code is compiled; until then it is interpreted.

    Raises
    ------
    ModelError, SchemeError, InitialStateError, ArgumentError
        For what cannot be used, by name.

    Notes
    -----
    Each method takes x, in the order of `by` or by name, and keeps nothing of it: `jacobian(x)` is the
    derivative of `values(x)` whatever was asked before.

    References
    ----------
    A. Griewank, A. Walther, Evaluating Derivatives: Principles and Techniques of Algorithmic Differentiation,
    2nd ed., SIAM, 2008.
    """

    @arguments(parameters=BY_NAME, initial=BY_NAME, options=BY_NAME, inputs=BY_NAME)
    def __init__(
        self,
        model: EmittedModel,
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
        inputs: Inputs | None = None,
        seen_every: float | None = None,
        samples: int | None = None,
        wait: bool = False,
    ) -> None:
        model = driven_by(model, inputs)
        if not model.q_i:
            raise ModelError(f"every coordinate of model {model.name} is driven: there is nothing to step")
        self.model, self.outputs = model, check_outputs(model, outputs)
        spacing = seen_every_of(seen_every, samples, *span_of(model, t0, t_end))
        self.plan, plan = (make_plan(model, t_end, dt, m, scheme, spacing, options, t0) for _ in range(2))
        self._crossings = EventCrossings(model, plan)
        held = held_samples(model, inputs, self.plan)
        self._crossings.refuse(samples=any(one.step > 0 for one in held))
        self.variables = variables_of(model, by, held)
        entries = [entry for _, entry, _ in self.variables.parameters]
        self.program = observed_program(self.plan.scheme, self.outputs, entries)
        self._codes = RunCode(self.program, len(self.by), wait)
        self._refuse_idle()
        self._holds = holds_of(self.plan, held, self.by)
        self.course = course(self.plan, self._holds)
        self.t = self.plan.times(self.course.times)
        sampled = [k for k, entry in enumerate(model.parameters) if entry.name in {one.input for one in held}]
        self._switches = Switches(self.plan, self.program, [*entries, *sampled])
        self._jumps = MovingJumps(model, entries)
        self._refuse_jumps_by_samples([one.input for one in held if one.step > 0])
        given = {one.input: one.value for one in held if one.step == 0}
        self._start = StartOfRun(
            self.program, self.plan, self.variables, {**(parameters or {}), **given}, initial or {}, start
        )
        self.x0 = self._start.values()

    @property
    def by(self) -> tuple[str, ...]:
        """Names of what is differentiated by."""
        return self.variables.names

    @arguments()
    def over(
        self,
        t0: float,
        length: float,
        steps: int | None = None,
        every: int | None = None,
        parameters: Mapping[str, float] | None = None,
    ) -> DifferentiableRun:
        """Prepare the same run over another time; what is compiled is shared.

        Parameters
        ----------
        t0 : float
            Where it begins [s].
        length : float
            How long it is [s].
        steps : int, optional
            How many steps it has; as many as before if left out.
        every : int, optional
            With `steps`, how many of them lie between outputs; if left out all, for outputs at its start and
            its end.
        parameters : dict of str to float, optional
            By name, besides those of the run [SI units].

        Returns
        -------
        DifferentiableRun
            The other run.
        """
        other, count = copy(self), self.plan.steps if steps is None else steps
        other.__dict__.pop("_backward", None)
        dt = length / count
        scheme = self.plan.scheme.with_step(dt)
        saved = self.plan.seen_steps if steps is None else every or count
        other.plan = replace(self.plan, scheme=scheme, t0=t0, steps=count, seen_steps=saved, end=None)
        other.program = replace(self.program, scheme=scheme)
        other._holds = self._holds if steps is None else []
        other.course = course(other.plan, other._holds)
        other.t = t0 + np.array(other.course.times) * dt
        other._crossings = self._crossings.over(t0, dt, count)
        other._start = self._start.on(other.program, other.plan, parameters)
        if parameters:
            other.x0 = other._start.values()
        return other

    # ---- what is asked for ----------------------------------------------------------------------------------

    def values(self, x: Values) -> np.ndarray:
        """Run with the values x.

        Parameters
        ----------
        x : (n,) array, or dict by name
            Values of `by` [SI units]; `x0` holds those of the start.

        Returns
        -------
        (N, n_y) array
            The outputs at the saved times `t`.

        Raises
        ------
        ArgumentError
            For an x of another shape, an unknown name, or a value that is not finite.
        NoResult
            For a run that does not come to its end.
        """
        started = self._started(x, slopes=False)
        z, y = started.z.copy(), np.zeros((len(self.t), len(self.outputs)))
        stepping, observing = self._codes.plain
        for stop in self._across(started).stops:
            ready = self._codes.turned(stop, z, started)
            stepping.run(z, ready, stop.steps)
            if stop.sample >= 0:
                observing.run(z, ready, 1)
                y[stop.sample] = z[self.program.outputs]
        started.checks.end(z)
        return y

    def jacobian(self, x: Values) -> OutputJacobian:
        """Run with the values x, and differentiate the outputs by them, one direction a lane.

        Parameters
        ----------
        x : (n,) array, or dict by name
            Where the derivative is taken [SI units]; `x0` holds the values of the start.

        Returns
        -------
        OutputJacobian
            Outputs (N, n_y), and their derivatives (N, n_y, n).

        Raises
        ------
        ArgumentError, NoResult
            As of `values`; NoResult also where a derivative is not finite.
        """
        started = self._started(x)
        directions = self._codes.beginning.tangents(self._place, started.x, started.slopes)
        course, codes = self._across(started), self._codes
        y, slopes, last = forward(self.program, codes.tangents, codes.turns, course, started, directions)
        started.checks.end(last)
        self._switches.check(started, course, codes.turned)
        require_finite(slopes, self.by)
        return OutputJacobian(self.t, self.outputs, self.by, y, slopes)

    @arguments(objective=OBJECTIVE)
    def gradient(self, objective: Objective, x: Values, mode: str = "auto") -> Gradient:
        """Run with the values x, and differentiate an objective made of these outputs.

        Parameters
        ----------
        objective : Objective
            Such as ``End("tip_y")``; its outputs are among those of the run.
        x : (n,) array, or dict by name
            Where the gradient is taken [SI units]; `x0` holds the values of the start.
        mode : str
            ``forward``, ``reverse``, or ``auto``: what costs less.

        Returns
        -------
        Gradient
            The objective's value, and its derivatives (n,).

        Raises
        ------
        ArgumentError, NoResult
            As of `jacobian`.
        """
        chosen = self.mode_of(mode)
        missing = [name for name in objective.outputs if name not in self.outputs]
        if missing:
            raise ArgumentError("objective", f"needs the output {missing[0]!r}", "name it when the run is prepared")
        columns = [self.outputs.index(name) for name in objective.outputs]
        run = self.record(x, chosen)
        value, slope = objective.weighed(self.t, run.values[:, columns])
        bars = np.zeros_like(run.values)
        bars[:, columns] = slope
        derivatives = run.back(bars)
        require_finite(derivatives, self.by)
        outputs = {name: run.values[:, k] for k, name in enumerate(self.outputs)}
        return Gradient(value, self.by, derivatives, chosen, self.t, outputs)

    def record(self, x: Values, mode: str = "auto") -> RecordedRun:
        """Run with the values x, and keep what vector-Jacobian products need.

        Parameters
        ----------
        x : (n,) array, or dict by name
            Where the products are taken [SI units]; `x0` holds the values of the start.
        mode : str
            ``forward``, ``reverse``, or ``auto``: what costs less.

        Returns
        -------
        RecordedRun
            Outputs (N, n_y), and `pull_back`. It holds the Jacobian, or the tapes of some steps.

        Raises
        ------
        ArgumentError, NoResult
            As of `jacobian`.
        """
        chosen = self.mode_of(mode)
        if chosen == "forward":
            slopes = self.jacobian(x)
            y, derivatives = slopes.values, slopes.derivatives
            return self._recorded(y, chosen, lambda bars: np.einsum("ny,nyk->k", bars, derivatives))
        started = self._started(x)
        course = self._across(started)
        backward = self._backward if course is self.course else self._way_back(course)
        recording = backward.record(started)
        started.checks.end(recording.last)
        self._switches.check(started, course, self._codes.turned)

        def back(bars: np.ndarray) -> np.ndarray:
            adjoint, held, of_parameters = recording.back(bars)
            of_x = self._codes.beginning.pulled_back(self._place, started.x, adjoint)
            of_x[: len(of_parameters)] += of_parameters
            return np.asarray(started.slopes.T @ of_x + held)

        return self._recorded(recording.y, chosen, back)

    def pull_back(self, x: Values, cotangents: np.ndarray, mode: str = "auto") -> np.ndarray:
        """Run with the values x, and multiply the Jacobian of its outputs by cotangents from the left.

        Parameters
        ----------
        x : (n,) array, or dict by name
            Where the product is taken [SI units]; `x0` holds the values of the start.
        cotangents : (N, n_y) array
            The derivative of a number by each of the outputs.
        mode : str
            ``forward``, ``reverse``, or ``auto``: what costs less.

        Returns
        -------
        (n,) array
            The derivative of that number by the values of `by`.

        Raises
        ------
        ArgumentError, NoResult
            As of `jacobian`; ArgumentError also for cotangents of another shape or that are not finite.

        Notes
        -----
        The vector-Jacobian product that reverse-mode frameworks ask for; `as_jax` and `as_torch` are made of it. For
        several products at one x keep a `record`.
        """
        return self.record(x, mode).pull_back(cotangents)

    def mode_of(self, mode: str) -> str:
        """Say what ``auto`` means here: ``forward`` where all directions fit side by side.

        Parameters
        ----------
        mode : str
            ``forward``, ``reverse`` or ``auto``.

        Returns
        -------
        str
            ``forward`` or ``reverse``.

        Raises
        ------
        ArgumentError
            For another word.
        """
        if mode not in MODES:
            raise ArgumentError("mode", f"is {mode!r}", f"give one of {', '.join(MODES)}")
        return mode if mode != "auto" else "forward" if len(self.by) <= most_lanes() else "reverse"

    # ---- inside ---------------------------------------------------------------------------------------------

    def _recorded(self, y: np.ndarray, mode: str, back: Callable[[np.ndarray], np.ndarray]) -> RecordedRun:
        return RecordedRun(self.t, self.outputs, self.by, y, mode, back)

    def _across(self, started: StartedRun) -> Course:
        """The course with its steps in parts where something jumps or happens."""
        crossings, modes = self._crossings.found(started, self._holds)
        path = course(self.plan, (*self._holds, *modes)) if modes else self.course
        return self._jumps.broken(path, self.plan, started.x[: len(self.model.parameters)], crossings)

    def _started(self, x: Values, slopes: bool = True) -> StartedRun:
        return self._start.started(self.variables.checked(x), slopes)

    @cached_property
    def _backward(self) -> Backward:
        return self._way_back(self.course)

    def _way_back(self, course: Course) -> Backward:
        return Backward(self.program, self._codes.recorders, self._codes.turns, course)

    @property
    def _place(self) -> list[float]:
        return [self.plan.t0, *self.plan.grid.h]

    def _refuse_idle(self) -> None:
        """Raises ArgumentError for a parameter that no function of the model reads."""
        acting = self.model.kernel("constants").jac_sparsity(0, 0)
        columns = set(acting.get_triplet()[1])
        for k, entry, _ in self.variables.parameters:
            if entry not in columns:
                raise ArgumentError(
                    f"parameter {self.by[k]}",
                    "enters the equations only as structure or as drawing: nothing that is computed depends on it",
                    "leave it out of `by`",
                )

    def _refuse_jumps_by_samples(self, names: Sequence[str]) -> None:
        """Raises ArgumentError where held samples change when something jumps."""
        if names and switches_by_inputs(self.model):
            raise ArgumentError(
                f"samples of {', '.join(dict.fromkeys(names))}",
                f"change during the run, and when something in model {self.model.name} jumps depends on inputs",
                "give a constant or a function of time",
            )


# What a differentiated run gives: derivatives by name.


@dataclass(frozen=True)
class OutputJacobian:
    """Outputs (N, n_y) at times t (N,) [s], and their derivatives (N, n_y, n) by the names `by`, in SI units."""

    t: np.ndarray
    outputs: tuple[str, ...]
    by: tuple[str, ...]
    values: np.ndarray
    derivatives: np.ndarray

    def __getitem__(self, names: tuple[str, str]) -> np.ndarray:
        """(N,) the derivative of an output by a parameter or initial value. Raises ArgumentError for other names."""
        if len(names) != 2 or names[0] not in self.outputs or names[1] not in self.by:
            known = f"{', '.join(self.outputs)} and {', '.join(self.by)}"
            raise ArgumentError(f"derivative {names!r}", "is not here", f"give a pair of {known}")
        return self.derivatives[:, self.outputs.index(names[0]), self.by.index(names[1])]


@dataclass(frozen=True)
class Gradient:
    """value of an objective and its derivatives (n,) by the names `by`.

    mode: how they were found; t (N,) [s] and outputs (N,) by name: of the run.
    """

    value: float
    by: tuple[str, ...]
    derivatives: np.ndarray
    mode: str
    t: np.ndarray = field(repr=False)
    outputs: Mapping[str, np.ndarray] = field(repr=False)

    def __getitem__(self, name: str) -> float:
        """The derivative by one of them. Raises ArgumentError for another name."""
        if name not in self.by:
            raise ArgumentError(f"derivative by {name!r}", "is not here", f"give one of {', '.join(self.by)}")
        return float(self.derivatives[self.by.index(name)])


# The gradient of a number that a run leads to, and the Jacobian of its outputs: the doors.


DIFFERENTIABLE = Kind(
    lambda value: isinstance(value, DifferentiableRun),
    "give a DifferentiableRun, such as DifferentiableRun(model, ...)",
)


@arguments(of=OBJECTIVE)
def gradient(model: EmittedModel, of: Objective, by: Sequence[str], *, mode: str = "auto", **run: Any) -> Gradient:
    """Differentiate an objective of a run by parameters, initial values and inputs.

    Parameters
    ----------
    model : Model
        The mechanism.
    of : Objective
        A number that follows from outputs of the run, see `runtime.gradients.objectives`.
    by : sequence of str (n,)
        Parameters, coordinates and rates (`_dot`) at the start, inputs.
    mode : {"auto", "forward", "reverse"}, optional
        "forward": one direction a lane; "reverse": one way back for all; "auto": what costs less.
    **run
        Arguments of `DifferentiableRun`, those of `simulate`.

    Returns
    -------
    Gradient
        The value and its derivatives (n,).

    Raises
    ------
    ModelError, SchemeError, InitialStateError, ArgumentError
        For what cannot be used.
    NoResult
        For a run without a derivative.

    Notes
    -----
    Derivatives of the discrete steps, not of the differential equation: exact to rounding for the run that is made,
    across events by the jump of the sensitivities (saltation). For repeated gradients keep a `DifferentiableRun`.

    References
    ----------
    A. Griewank and A. Walther, Evaluating Derivatives, 2nd ed., SIAM, 2008.
    """
    prepared = DifferentiableRun(model, of.outputs, by, **run)
    return prepared.gradient(of, prepared.x0, mode)


@arguments()
def output_jacobian(model: EmittedModel, outputs: Sequence[str], by: Sequence[str], **run: Any) -> OutputJacobian:
    """Differentiate outputs at stored times by parameters, initial values and inputs.

    Parameters
    ----------
    model : Model
        The mechanism.
    outputs : sequence of str (k,)
        Coordinates, rates, measures, energies, forces by name.
    by : sequence of str (n,)
        As of `gradient`.
    **run
        Arguments of `DifferentiableRun`, those of `simulate`.

    Returns
    -------
    OutputJacobian
        Times (N,) [s], outputs (N, k) and derivatives (N, k, n), in SI units.

    Raises
    ------
    ModelError, SchemeError, InitialStateError, ArgumentError, NoResult
        As of `gradient`.
    """
    prepared = DifferentiableRun(model, outputs, by, **run)
    return prepared.jacobian(prepared.x0)
