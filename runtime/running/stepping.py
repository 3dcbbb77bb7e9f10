"""A model stepped from Python: one call, one or more major steps, nothing set up anew."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from runtime.contract.arguments import BY_NAME, START, arguments
from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import Initial
from runtime.contract.errors import LARGEST_NUMBER, ArgumentError, ModelError, shown_value
from runtime.contract.model import EmittedModel
from runtime.contract.signals import SINCE
from runtime.contract.status import Event, Status
from runtime.operating.equilibrium import Equilibrium
from runtime.running.events import EventHandler
from runtime.running.inputs import reading
from runtime.running.monitor import Monitor
from runtime.running.planning import make_plan, steps_asked
from runtime.running.step_driver import StepDriver
from runtime.running.stepped_model import Divisions, SteppedModel
from runtime.running.time_functions import refuse_position_jumps
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.impulse import moves_in_time
from runtime.schemes.switching.steps_with_stops import StepsWithStops
from runtime.schemes.switching.times import may_jump, switches_by_inputs, switching_times
from runtime.schemes.switching.watched import may_break
from runtime.solutions.solution import Solution
from runtime.start.start_state import start_state

KNOWN = (float, int, np.number)  # kinds of numbers that need no closer look
HORIZON = 1e9  # major steps: no end is meant


@dataclass(frozen=True, eq=False)
class SteppedState:
    """All that the next step depends on: the scheme's z (flat), the parameters p (n_p,), where its grid begins [s].

    events: what has happened since then; ended: the status, where one of them was terminal; memory: latest times of
    each [s]; divisions: of steps since then.
    """

    z: np.ndarray
    p: np.ndarray
    t0: float = 0.0
    events: tuple[Event, ...] = ()
    ended: Status | None = None
    memory: Mapping[str, Sequence[float]] = field(default_factory=dict)
    divisions: Divisions = Divisions()


class ModelStepper:
    """Step a model from outside: a scheme, compiled once, whose state can be read, set, saved and restored.

    Parameters
    ----------
    model : Model
        The mechanism.
    scheme, dt, m, options, parameters, engine : optional
        As of `simulate`: a scheme with steps of one length dt [s].

    Raises
    ------
    SchemeError
        For a scheme or step that cannot be used.
    ModelError
        For unknown parameters, and where every coordinate is driven.

    Notes
    -----
    `step` makes steps without checks; `check` tells what a run would have found. Singular positions are not
    passed. Events happen as in a run: see `events`, and `ended`, after which there is no further step. Where the
    iteration of a step does not converge, it is made in shorter parts as in a run, see `divided_steps`; where these
    do not either, `check` tells.
    """

    @arguments(options=BY_NAME, parameters=BY_NAME)
    def __init__(
        self,
        model: EmittedModel,
        *,
        scheme: str | None = None,
        dt: float | None = None,
        m: list[int] | None = None,
        options: Mapping[str, Any] | None = None,
        parameters: Mapping[str, float] | None = None,
        engine: str = "auto",
    ) -> None:
        if not model.q_i:
            raise ModelError(
                f"every coordinate of model {model.name} is driven: use simulate, there is nothing to step"
            )
        name, length = steps_asked(model, scheme, dt, m, options)
        end = HORIZON * length if isinstance(length, int | float) and length > 0 else None
        plan = make_plan(model, end, length, m, name, None, options, 0.0, bounded=True)
        self.model, self.name = model, plan.name
        self._settings = {"scheme": scheme, "dt": dt, "m": m, "options": options, "engine": engine}
        plan.scheme.of_one_length("a stepper")
        self.dt = plan.grid.dt_L
        self._own = SteppedModel.prepared(model, plan, model.parameter_vector(parameters), engine, wait=True)
        self.scheme = plan.scheme
        self._constants = self.scheme.constants(self._own.c, self.dt).copy()
        self._sample: Solution | None = None
        state = start_state(model, self.parameters, self._own.c, 0.0, None)
        # this array stays where it is: compiled code and readers know its address
        self._z = self._own.stepper.start(0.0, state.q, state.q_dot, self._own.c, self.dt)
        self._across = UnendingSteps(self._own, self._z) if may_part(plan.scheme) else None
        self._advance = self._own.bound(self._z) if self._across is None else self._across.run
        self._set_out(0.0)
        w = model.signals
        self._own_inputs = self._z[self.scheme.layout.slice("inputs")] if w.size else self._z[:0]
        plain = SINCE not in w.names and not w.sources
        self._plain_inputs = {name: w.names.index(name) for name in model.inputs} if plain else {}

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickled by its model, settings and state; compiled anew."""
        return _restored, (self.model, self._settings, self.save())

    # ---- stepping -------------------------------------------------------------------------------------------

    @arguments(state=START)
    def reset(
        self,
        state: Initial = None,
        *,
        t: float = 0.0,
        start: str | None = None,
    ) -> None:
        """Go to a state.

        Parameters
        ----------
        state : dict, Equilibrium, Solution or None
            Coordinates [m, rad] and rates (`_dot`) [m/s, rad/s] by name; an equilibrium, which brings its time
            and parameters; a solution, from its end; or None for the start of the scene.
        t : float
            Time [s].
        start : str, optional
            As of `simulate`.

        Raises
        ------
        InitialStateError
            For a state that does not close the loops.
        ModelError
            For an unknown name.

        Notes
        -----
        Inputs are again what the parameters say.
        """
        if isinstance(state, Equilibrium):
            self._take(state.parameters)
            q, q_dot, t = state.q, state.q_dot, state.state.t
        else:
            if SINCE in self.model.signals.names:
                self._take(np.append(self.parameters[:-1], t))  # rates count from here
            found = start_state(self.model, self.parameters, self._own.c, t, state, start)
            q, q_dot = found.q, found.q_dot
        self._z[:] = self._own.stepper.start(t, q, q_dot, self._own.c, self.dt)
        self._set_out(t)
        self._sample = None

    def _set_out(self, t: float) -> None:
        """The grid of steps begins at t [s]; a jump that is there is over."""
        if self._across is not None:
            self._across.begin(t)

    def step(self, u: int | Mapping[str, float] | Sequence[float] | None = None, n: int = 1) -> None:
        """Make n major steps.

        Parameters
        ----------
        u : dict, sequence of float, int or None
            Inputs by name or a number for each of `model.inputs`, held from here on; those with rates go on
            with the rate and acceleration given. None: as they are. A whole number is n.
        n : int
            How many steps.

        Raises
        ------
        ArgumentError
            For wrong inputs or numbers, and where an event has `ended` the motion.

        Notes
        -----
        Bit for bit the same in one call or in many. The steps are those of Eqs. 40-45 for central differences.
        """
        if u is not None:
            if isinstance(u, int | np.integer):
                n = int(u)
            else:
                self._hold(u)
                if self._across is not None:
                    self._across.look_anew()
        if not (isinstance(n, int | np.integer) and n >= 0):
            raise ArgumentError("n", f"is {shown_value(n)}", "give a whole number of steps")
        self._advance(n)
        self._sample = None

    def _hold(self, u: Mapping[str, float] | Sequence[float]) -> None:
        """From now on these inputs."""
        if self._across is not None:
            self._across.take_inputs()
        names, own = self.model.inputs, self._own_inputs.copy() if self.scheme.multistep else self._own_inputs
        if not isinstance(u, Mapping):
            if not isinstance(u, Sequence) and getattr(u, "ndim", 0) != 1:
                raise ArgumentError(
                    "u", f"is {shown_value(u)}", "give inputs by name, a list of numbers, or a number of steps"
                )
            if len(u) != len(names):
                raise ArgumentError(f"{len(u)} numbers for {len(names)} inputs: {', '.join(names) or 'none'}")
            u = dict(zip(names, u, strict=True))
        if not self._plain_inputs:
            own[:] = self.model.signals.changed(own, self.time, u)
        for name, value in u.items() if self._plain_inputs else ():
            k = self._plain_inputs.get(name)
            if k is None or not isinstance(value, KNOWN) or not abs(value) <= LARGEST_NUMBER:
                own[:] = self.model.signals.changed(own, 0.0, u)  # says what is wrong
                break
            own[k] = value
        if self.scheme.multistep:
            self._own.hold(self._z, own)

    @arguments()
    def change(self, parameters: Mapping[str, float]) -> None:
        """Change parameters from the next step on; the others stay as they are.

        Parameters
        ----------
        parameters : dict of str to float
            New values by name [SI units].

        Raises
        ------
        ModelError
            For an unknown name, or a value that is not finite.

        Notes
        -----
        Inputs are given to `step`, which costs less.
        """
        p, index = self.parameters.copy(), self._index
        checked = self.model.parameter_vector(parameters)
        for name in parameters:
            p[index[name]] = checked[index[name]]
        own = {name: value for name, value in parameters.items() if name in self.model.signals.names}
        if own:
            self._hold(own)
        if len(own) < len(parameters):
            self._take(p)
        if self._across is not None:
            self._across.look_anew()
        self._sample = None

    def save(self) -> SteppedState:
        """Save the state.

        Returns
        -------
        SteppedState
            What `restore` goes back to.
        """
        t0 = float(self._z[0]) if self._across is None else self._across.t0
        memory = {} if self._across is None else self._across.event_handler.memory()
        z, divisions = self._z.copy(), self._own.divisions
        return SteppedState(z, self.parameters.copy(), t0, tuple(self.events), self.ended, memory, divisions)

    def restore(self, kept: SteppedState) -> None:
        """Go back to what was saved.

        Parameters
        ----------
        kept : SteppedState
            What `save` gave.

        Raises
        ------
        ArgumentError
            For a state of another stepper.
        """
        if not isinstance(kept, SteppedState):
            raise ArgumentError("the saved state", f"is {shown_value(kept)}", "give what `save` gave")
        if len(kept.z) != len(self._z) or len(kept.p) != len(self.parameters):
            raise ArgumentError(
                "the saved state", "is of a stepper of another model or scheme", "save it from this one"
            )
        self._take(kept.p)
        self._z[:] = kept.z
        if self._across is not None:
            self._across.go_back(kept)
        self._sample = None

    # ---- reading --------------------------------------------------------------------------------------------

    @property
    def parameters(self) -> np.ndarray:
        """The parameters p (n_p,) in use."""
        return self._own.p

    @property
    def events(self) -> list[Event]:
        """Events of the model since `reset`, in order."""
        reported = [] if self._across is None else self._across.event_handler.reported
        return sorted((event for event in reported if event.kind != "kink"), key=lambda event: event.time)

    @property
    def ended(self) -> Status | None:
        """Why there is no further step: a terminal event, or one that chatters; `time` is then its own."""
        return None if self._across is None else self._across.event_handler.status

    @property
    def divided_steps(self) -> int:
        """How many steps since `reset` were made in shorter parts, as their iteration did not converge."""
        return self._own.divisions.steps

    @property
    def time(self) -> float:
        """Time after the last step [s]."""
        return float(self._z[0]) + float(self._z[1]) * self.dt

    @property
    def sample(self) -> Solution:
        """The present state as a solution of one sample: coordinates, rates, accelerations, forces, energies."""
        if self._sample is None:
            self._sample = self._own.observed([self._own.state(self._z)], Status("completed", self.time))
        return self._sample

    @property
    def state(self) -> dict[str, float]:
        """Coordinates and rates (`_dot`) by name; `reset` takes those of q_i."""
        sample, names = self.sample, self.model.coordinates
        rates = {f"{name}_dot": float(sample.q_dot[0, k]) for k, name in enumerate(names)}
        return {name: float(sample.q[0, k]) for k, name in enumerate(names)} | rates

    @property
    def measures(self) -> dict[str, float]:
        """Measures and their rates by name."""
        return {name: float(self.sample.measures[0, k]) for k, name in enumerate(self.model.measures)}

    @property
    def reactions(self) -> dict[str, np.ndarray]:
        """(3,) or in space (6,) world force [N] and moment [N m] of each joint on its body b, by name."""
        return {name: self.sample.joint_forces[0, k] for k, name in enumerate(self.model.joints)}

    @arguments()
    def reader(self, names: Sequence[str]) -> Callable[[], np.ndarray]:
        """Prepare a fast function that reads coordinates, rates and measures at once, for controllers.

        Parameters
        ----------
        names : sequence of str
            k names.

        Returns
        -------
        callable
            Without arguments; it gives an array (k,), the same at each call.

        Raises
        ------
        ModelError
            For an unknown name.
        """
        function = reading(self.scheme, len(self._z), names)
        evaluation: tuple[Any, Any] = function.buffer()
        buffer, evaluate = evaluation
        values = np.zeros(len(names))
        buffer.set_arg(0, self._z.data)
        buffer.set_arg(1, self._constants.data)
        buffer.set_res(0, values.data)

        def read() -> np.ndarray:
            evaluate()
            return values

        read.kept = (function, buffer)  # type: ignore[attr-defined]
        return read

    def check(self) -> Status | None:
        """Check this state as a run would, costly checks included.

        Returns
        -------
        Status or None
            What is wrong; None if nothing is.
        """
        state = self._own.state(self._z).copy()
        return Monitor(self.model, self.scheme, self._own.c, force=True).first(state)

    # ---- inside ---------------------------------------------------------------------------------------------

    @property
    def _index(self) -> dict[str, int]:
        return {parameter.name: k for k, parameter in enumerate(self.model.parameters)}

    def _take(self, p: np.ndarray) -> None:
        """Other parameters: what the program reads is written in place."""
        self._own.take(p)
        if self._across is not None:
            self._across.forget()
        self._constants[:] = self.scheme.constants(self._own.c, self.dt)
        self._sample = None


@arguments(options=BY_NAME, parameters=BY_NAME)
def stepper(
    model: EmittedModel,
    *,
    scheme: str | None = None,
    dt: float | None = None,
    m: list[int] | None = None,
    options: Mapping[str, Any] | None = None,
    parameters: Mapping[str, float] | None = None,
    engine: str = "auto",
) -> ModelStepper:
    """Step the model from outside, for a controller or another program.

    Parameters
    ----------
    model : Model
        The mechanism.
    scheme, dt, m, options, parameters, engine : optional
        As of `simulate`: a scheme with steps of one length dt [s].

    Returns
    -------
    ModelStepper
        A state that can be stepped, read, set, saved and restored.

    Raises
    ------
    SchemeError, ModelError
        For what cannot be used.
    """
    return ModelStepper(model, scheme=scheme, dt=dt, m=m, options=options, parameters=parameters, engine=engine)


def _restored(model: EmittedModel, settings: Mapping[str, Any], kept: SteppedState) -> ModelStepper:
    made = ModelStepper(model, **settings)
    made.restore(kept)
    return made


# Steps without an end across jumps in time and events: looked for as time goes on, always over the same steps.

JUMP_SEARCH_STEPS = 4096  # steps over which jumps are looked for at a time: the same in one call or in many


def may_part(scheme: Scheme) -> bool:
    """May a step be made in parts: at what breaks it, or where its iteration does not converge?"""
    return may_break(scheme) or scheme.iteration_limit is not None


class UnendingSteps:
    """Advances a z (whole, flat) that stays where it is; t0 [s] is where its grid of steps begins.

    event_handler: the events since the grid began, and the status where one has ended it.
    """

    def __init__(self, own: SteppedModel, z: np.ndarray) -> None:
        self._own, self._z, self.t0 = own, z, float(z[0])
        self._first, own.broken = -1, StepsWithStops(own.stepper, self.t0, own.plan.grid.dt_L, [], own.c)
        self._jumps, self._driver = may_jump(own.model), StepDriver(own)
        self._by_inputs = self._jumps and (switches_by_inputs(own.model) or moves_in_time(own.model))

    @property
    def event_handler(self) -> EventHandler:
        """What has happened."""
        return self._driver.event_handler

    def begin(self, t0: float) -> None:
        """The grid of steps begins there [s]."""
        self.t0, self._driver = t0, StepDriver(self._own)
        self._own.divisions = Divisions()
        self.forget()
        self._look(self._own.with_inputs(self._z))
        assert self._own.broken is not None
        grid, step = self._own.broken.grid, int(self._z[1])
        self._z[0] = t0 + (grid.clock(step) - grid.time(step))
        self._own.begin_events(self._z)
        self.event_handler.settle(self._z)
        self.event_handler.reported.clear()

    def go_back(self, kept: SteppedState) -> None:
        """To the grid of a state, and what had happened on it."""
        self.t0, self._driver = kept.t0, StepDriver(self._own)
        self.event_handler.reported, self.event_handler.status = list(kept.events), kept.ended
        self.event_handler.resume(kept.memory)
        self._own.divisions = kept.divisions
        self.forget()

    def look_anew(self) -> None:
        """At events: inputs or parameters have changed."""
        if self._own.watches_events:
            self._own.look_anew(self._z)
            self.event_handler.settle(self._z)

    def forget(self) -> None:
        """Parameters have changed: look again."""
        self._first = -1

    def take_inputs(self) -> None:
        """Inputs have changed: look again where times of jumps, or how far positions jump, hang on them."""
        if self._by_inputs:
            self.forget()

    def run(self, steps: int) -> None:
        """Make so many major steps, fewer where an event ends them.

        Raises ModelError for a prescribed motion whose position jumps in them, ArgumentError where an event has ended
        all steps before.
        """
        if (ended := self.event_handler.status) is not None:
            raise ArgumentError(
                f"{ended.cause} has ended the motion", "there is no further step", "reset or restore it"
            )
        end = int(self._z[1]) + steps
        while (step := int(self._z[1])) < end and self.event_handler.status is None:
            if self._first != step // JUMP_SEARCH_STEPS * JUMP_SEARCH_STEPS:
                self._look(self._own.with_inputs(self._z))
            if self._driver.advance(self._z, min(end, self._first + JUMP_SEARCH_STEPS) - step) is not None:
                self.take_inputs()

    def _look(self, c: np.ndarray) -> None:
        own, h = self._own, self._own.plan.grid.dt_L
        self._first = int(self._z[1]) // JUMP_SEARCH_STEPS * JUMP_SEARCH_STEPS
        ends = self.t0 + self._first * h, self.t0 + (self._first + JUMP_SEARCH_STEPS) * h
        found = switching_times(own.model, c, *ends) if self._jumps else []
        if found and moves_in_time(own.model):
            observed = own.observed([own.state(self._z)])
            refuse_position_jumps(own.model, c, ConsistentState(observed.q[0], observed.q_dot[0], {}), found, *ends)
        own.switches, own.broken = found, StepsWithStops(own.stepper, self.t0, h, found, c)
