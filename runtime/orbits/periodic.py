"""The search for a motion that repeats, a limit cycle or a forced response: the function `periodic`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import gcd, lcm
from typing import Any

import numpy as np

from runtime.contract.arguments import BY_NAME, NUMBER, START, Kind, arguments
from runtime.contract.coordinates import followed
from runtime.contract.errors import LARGEST_NUMBER, ArgumentError, SymgenError, shown_value
from runtime.contract.model import EmittedModel, refuse_events
from runtime.gradients.variables import parameters_at
from runtime.operating.given_state import given_state
from runtime.orbits.controllers import controllers_in, period_map, refuse_controllers, samples_in, states_of
from runtime.orbits.floquet import UNIT_CIRCLE_MARGIN, Floquet, floquet
from runtime.orbits.motion import PeriodicMotion
from runtime.orbits.shooting import Closed, Conditions, NoPeriodicMotion, PeriodMap, Setting, closed, closed_beside
from runtime.orbits.states import States
from runtime.results.motion_error import MotionError, amplitudes, motion_error
from runtime.running.comparison_times import common_steps, coprime
from runtime.running.inputs import InputValue, bound
from runtime.running.simulate import simulate
from runtime.schemes.catalogue import scheme_kind
from runtime.solutions.solution import Solution

FREE = "free"
SCHEME = "exponential_rk4"
COMPARED_PLACES = 20  # places of a period at which two solutions are compared, at least
FIRST_STEPS_OF_PERIOD, MOST_STEPS_OF_PERIOD = 200, 50_000  # a period: the first try, and the last
TRANSIENT_PERIODS = 20  # periods of a transient, where Newton's method does not find the motion from the start
REPEAT_TOLERANCE = 1e-5  # of a coordinate's size: what is driven, and loads, repeat up to this
DOUBT = 20  # times the difference between two numbers of steps: how well the largest multiplier is known

BEGINNING = Kind(
    lambda value: isinstance(value, PeriodicMotion) or START.holds(value),
    "give initial values by name, a run, or another periodic motion",
)


@arguments(parameters=BY_NAME, inputs=BY_NAME, start=BEGINNING, options=BY_NAME, t0=NUMBER)
def periodic(
    model: EmittedModel,
    *,
    period: float | str | None = None,
    speed: str | None = None,
    turns: float = 1.0,
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, InputValue] | None = None,
    start: PeriodicMotion | Solution | Mapping[str, float] | None = None,
    settle: int | None = None,
    guess: float | None = None,
    scheme: str | None = None,
    options: Mapping[str, Any] | None = None,
    tolerance: float = 1e-6,
    steps: int | None = None,
    parts: int = 1,
    t0: float = 0.0,
) -> PeriodicMotion:
    """Find a motion that repeats after a period, its stability and its error, by shooting.

    Parameters
    ----------
    model : Model
        The mechanism.
    period : float or "free", optional
        The period [s]; "free" where nothing depends on time.
    speed : str, optional
        In place of `period`: the parameter that is the speed [rad/s]; the period is that of so many `turns`.
    turns : float, optional
        Turns of a period at `speed`, or of a free period in which an angle turns on and on.
    parameters, inputs : mapping, optional
        As of `simulate`.
    start : PeriodicMotion, Solution or mapping of str to float, optional
        Where the search begins: another periodic motion, a run (its end), or initial values by name.
    settle : int, optional
        Periods that are simulated first; None: 20, only if the search fails, and for a free period.
    guess : float, optional
        Of a free period [s]; if left out, what a transient shows: what swings, or turns on and on.
    scheme, options : optional
        A scheme with steps of one length, and its options.
    tolerance : float, optional
        Error relative to amplitudes [1].
    steps : int, optional
        Steps in a period, in place of `tolerance`.
    parts : int, optional
        Parts that the period is divided into (multiple shooting), for motions too unstable to last one.
    t0 : float, optional
        Start of the period [s].

    Returns
    -------
    PeriodicMotion
        The state at t0, the period [s], Floquet multipliers, stability, error.

    Raises
    ------
    NoPeriodicMotion, NoResult, ArgumentError, ModelError, SchemeError
        Where none is found, and for what cannot be used.

    Notes
    -----
    Newton's method on x(t0 + T) = x(t0), with the monodromy matrix by exact derivatives of the steps.

    References
    ----------
    R. Seydel, Practical Bifurcation and Stability Analysis, 3rd ed., Springer, 2010.
    """
    asked = _Asked(model, period, speed, turns, dict(parameters or {}), dict(inputs or {}), scheme or SCHEME)
    refuse_events_that_end(model)
    if not isinstance(parts, int) or parts < 1:
        raise ArgumentError("parts", f"is {parts!r}", "give a whole number of at least 1")
    if steps is not None and (not isinstance(steps, int) or steps < 1):
        raise ArgumentError("steps", f"is {steps!r}", "give a whole number of at least 1")
    if not 0 < tolerance < 1:
        raise ArgumentError("tolerance", f"is {tolerance!r}", "give a number between 0 and 1")
    refuse_controllers(model, asked.inputs, asked.free)
    x, first = _beginning(asked, start, settle, guess, t0)
    count = steps if steps is not None else FIRST_STEPS_OF_PERIOD
    samples = samples_in(first, asked.inputs)
    if steps is not None and steps % samples:
        raise ArgumentError("steps", f"are {steps}, with {samples} samples a period", "give a multiple of that")
    unit = lcm(COMPARED_PLACES * parts, samples)
    search = _Search(asked, dict(options or {}), parts, t0)
    while True:
        count = max(1, round(count / unit)) * unit if steps is None else count
        motion = search.solved(count, x, first, settle)
        if steps is not None or motion.error.largest <= tolerance or count >= MOST_STEPS_OF_PERIOD:
            return motion
        order = scheme_kind(asked.scheme).make.order
        wanted = (motion.error.largest / (0.8 * tolerance)) ** (1.0 / order)
        count = min(MOST_STEPS_OF_PERIOD, int(np.ceil(count * min(max(wanted, 1.2), 5.0))))
        x, first = motion.x, motion.period


def refuse_events_that_end(model: EmittedModel) -> None:
    """Raises ModelError for events that are terminal."""
    if any(event.terminal for event in model.description.events):
        refuse_events(model, "a periodic motion")


@dataclass(frozen=True)
class _Asked:
    """What `periodic` was asked for."""

    model: EmittedModel
    period: float | str | None
    speed: str | None
    turns: float
    parameters: dict[str, float]
    inputs: dict[str, InputValue]
    scheme: str

    def __post_init__(self) -> None:
        if (self.period is None) == (self.speed is None):
            raise ArgumentError("period", "give either period or speed", "for example period=0.1")
        if self.speed is not None:
            known = [one.name for one in self.model.parameters]
            if self.speed not in known:
                raise ArgumentError(
                    "speed", f"{self.speed!r} is not a parameter of the model", "name a parameter in rad/s"
                )
            if self.turns <= 0:
                raise ArgumentError("turns", f"is {self.turns!r}", "give a positive number")
        elif self.period != FREE and not (
            isinstance(self.period, int | float)
            and not isinstance(self.period, bool)
            and 0 < self.period < LARGEST_NUMBER
        ):
            raise ArgumentError(
                "period", f"is {shown_value(self.period)}", 'give a positive number of seconds, or "free"'
            )
        if not self.model.q_i:
            raise ArgumentError(
                f"model {self.model.name}", "is driven in every coordinate", "its motion repeats as its drives do"
            )

    @property
    def free(self) -> bool:
        """Is the period unknown?"""
        return self.period == FREE

    def length(self, parameters: Mapping[str, float]) -> float:
        """The period [s] at these parameters. Raises ArgumentError for a speed of zero."""
        if self.speed is None:
            assert isinstance(self.period, int | float)
            return float(self.period)
        entry = next(one for one in self.model.parameters if one.name == self.speed)
        value = float({**{entry.name: entry.default}, **parameters}[self.speed])
        if value == 0:
            raise ArgumentError(f"speed {self.speed}", "is zero: nothing turns", "give it another value")
        return speed_period(self.turns, value)


def speed_period(turns: float, speed: float) -> float:
    """Of so many turns at a speed [rad/s]: 2 pi turns / |speed| [s]."""
    return float(2 * np.pi * turns / abs(speed))


def _beginning(
    asked: _Asked, start: Any, settle: int | None, guess: float | None, t0: float
) -> tuple[np.ndarray, float]:
    """(state (n,), period) that the search begins with."""
    states = states_of(asked.model, asked.inputs)
    if isinstance(start, PeriodicMotion) and start.states.names == states.names:
        return start.x, start.period if asked.free else asked.length(asked.parameters)
    start = start.state if isinstance(start, PeriodicMotion) else start
    x = states.of(start.q[-1], start.q_dot[-1]) if isinstance(start, Solution) else _given(asked, states, start, t0)
    if not asked.free:
        return x, asked.length(asked.parameters)
    if guess is not None and settle is None:
        return x, float(guess)
    return _settled_freely(asked, states, x, guess, settle or TRANSIENT_PERIODS, t0)


def _given(asked: _Asked, states: States, start: Mapping[str, float] | None, t0: float) -> np.ndarray:
    """(n,) of the model's own start with values by name. Raises InitialStateError."""
    model = bound(asked.model, asked.inputs)
    p = parameters_at(model, asked.parameters, t0)
    state = given_state(model, p, model.constants(p), t0, start or {})
    return states.of(state.q, state.q_dot)


def _settled_freely(
    asked: _Asked, states: States, x: np.ndarray, guess: float | None, settle: int, t0: float
) -> tuple[np.ndarray, float]:
    """End of a transient, and its last period: of the turns of the slowest angle that turns, where one does, else the
    time between the last two passages of the coordinate that moves most.
    """
    model = asked.model
    span = guess * settle if guess else max(float(model.simulation["t_end"]), 1e-3)
    given: dict[str, Any] = {"parameters": asked.parameters, "inputs": asked.inputs or None, "t0": t0, "error": "off"}
    dt = span / (FIRST_STEPS_OF_PERIOD * settle)
    for _ in range(6):
        run = simulate(
            model, scheme=asked.scheme, initial=states.by_name(x), t_end=t0 + span, dt=dt, seen_every=0.0, **given
        )
        q = run.q[:, followed(model)[1]]
        late = slice(len(run.t) // 2, None)
        turned = [_time_of_turns(run.t[late], run.q[late, k], asked.turns) for k in _angles(model)]
        if any(turned):
            return states.of(run.q[-1], run.q_dot[-1]), max(turned)
        column = int(np.ptp(q[late], axis=0).argmax())
        wave = q[late, column] - (q[late, column].max() + q[late, column].min()) / 2
        up = np.flatnonzero((wave[:-1] < 0) & (wave[1:] >= 0))
        if len(up) >= 3:
            times = run.t[late][up] - wave[up] * np.diff(run.t[late])[up] / (wave[up + 1] - wave[up])
            return states.of(run.q[-1], run.q_dot[-1]), float(times[-1] - times[-2])
        span, dt = 4 * span, 4 * dt if guess is None else dt
    raise NoPeriodicMotion(
        f"model {model.name}",
        "neither swings to and fro nor turns on and on in a simulation of it, so no free period shows",
        "give guess=, an estimate of the period in seconds, and a start near the motion",
    )


def _angles(model: EmittedModel) -> list[int]:
    """Columns of q of angles that tell the motion."""
    return [int(k) for k in followed(model)[1] if model.description.coordinates[k].kind == "angle"]


def _time_of_turns(t: np.ndarray, angle: np.ndarray, turns: float) -> float:
    """The time [s] of the last so many turns of an angle (N,) over t (N,); 0 where it has not made twice as many, or
    turns back.
    """
    left = np.abs(angle[-1] - angle)
    if left[0] < 4 * np.pi * turns or np.any(np.diff(left) > 0):
        return 0.0
    return float(t[-1] - np.interp(-2 * np.pi * turns, -left, t))


class _Search:
    """Maps of one question with several numbers of steps: what is compiled is shared."""

    def __init__(self, asked: _Asked, options: dict[str, Any], parts: int, t0: float) -> None:
        self._asked, self._options, self._parts, self._t0 = asked, options, parts, t0
        self._map: PeriodMap | None = None

    def map_(self, steps: int, period: float) -> PeriodMap:
        """With so many steps a period."""
        a = self._asked
        setting = Setting(
            a.model, a.scheme, max(1, steps // self._parts), self._parts, self._t0, self._options, a.inputs
        )
        if self._map is None:
            self._map = period_map(setting, period, a.parameters, ())
        return self._map.with_steps(setting)

    def solved(self, steps: int, x: np.ndarray, period: float, settle: int | None) -> PeriodicMotion:
        """The motion with so many steps a period, compared with itself with other steps."""
        map_ = self.map_(steps, period)
        found, conditions = self._found(map_, x, period, settle)
        motion = self._motion(map_, found, steps)
        self._check_repeats(map_, motion)
        samples = samples_in(found.period, self._asked.inputs)
        other = companion_steps(self._asked.scheme, steps, self._parts, samples)
        twin = closed_beside(self.map_(other, found.period), conditions, found)
        beside = self._motion(map_, twin, other)
        return replace(motion, floquet=doubted(motion.floquet, beside.floquet), error=_difference(motion, beside))

    def _found(self, map_: PeriodMap, x: np.ndarray, period: float, settle: int | None) -> tuple[Closed, Conditions]:
        """From the state x (n,), or where that fails (or settle asks for it) from the end of a transient."""
        settled = settle or 0
        for _ in range(settled):
            x = self._wrapped(map_, x, map_.with_parts(1).ends(x[None], period, ())[0])
        try:
            return self._newton(map_, x, period)
        except NoPeriodicMotion:
            if settle is not None or self._asked.free:
                raise
        for _ in range(TRANSIENT_PERIODS):
            x = self._wrapped(map_, x, map_.ends(map_.along(x, period, ()), period, ())[-1])
        return self._newton(map_, x, period)

    def _wrapped(self, map_: PeriodMap, before: np.ndarray, after: np.ndarray) -> np.ndarray:
        """The end of a period with its whole turns taken off."""
        return np.asarray(after - map_.states.whole_turns(after - before))

    def _newton(self, map_: PeriodMap, x: np.ndarray, period: float) -> tuple[Closed, Conditions]:
        states = map_.along(x, period, ())
        shot = map_.shot(states, period, ())
        turn = map_.states.whole_turns(shot.ends[-1] - x)
        scale = map_.states.sizes(np.abs(np.vstack([states, shot.ends])).max(axis=0), period)
        conditions = Conditions(scale, turn, self._asked.free, x, shot.rates[-1])
        return closed(map_, conditions, shot, period, ()), conditions

    def _motion(self, map_: PeriodMap, found: Closed, steps: int) -> PeriodicMotion:
        a = self._asked
        turns = np.rint(found.turn[: len(map_.states.places)] / (2 * np.pi)).astype(int)
        speed = None if a.speed is None else (a.speed, a.turns)
        return PeriodicMotion(
            a.model, found.period, found.shot.x[0],
            {name: int(k) for name, k in zip(map_.states.places, turns, strict=True) if k},
            floquet(found.shot.monodromy, found.period, a.free), MotionError(reason="not yet compared"),
            a.scheme, steps, self._parts, found.iterations, self._t0, a.parameters, a.free, speed,
            found, self._options, a.inputs,
        )  # fmt: skip

    def _check_repeats(self, map_: PeriodMap, motion: PeriodicMotion) -> None:
        """Raises NoPeriodicMotion where drives, loads, inputs or what events did do not repeat with the period."""
        found, end = motion.found, motion.found.shot.ends[0]
        if any(event.sets for event in motion.model.description.events) or controllers_in(motion.inputs):
            run = motion.simulate(2, samples=2)  # what they set, and decide, goes on in the next period
            end, states = found.shot.x[0], map_.states
            again = states.near(states.of(run.q[-1], run.q_dot[-1]) - 2 * found.turn, end)
            again[states.own :] = end[states.own :]
        else:
            again = map_.next_period(found.shot.x[0], found.period)
        size = map_.states.sizes(np.abs(np.vstack([found.shot.x, found.shot.ends])).max(axis=0), found.period)
        off = np.abs(again - end) / size
        if off.max() > REPEAT_TOLERANCE:
            name = map_.states.names[int(off.argmax())]
            raise NoPeriodicMotion(
                f"model {self._asked.model.name}",
                f"drives, loads, inputs or events do not repeat after {found.period:.6g} s: in the next period {name} "
                f"comes out differently by {off.max():.2g} of its size",
                "give the period with which they do",
            )


def doubted(one: Floquet, beside: Floquet) -> Floquet:
    """With the margin that follows from the same with other steps."""
    return replace(one, margin=max(UNIT_CIRCLE_MARGIN, DOUBT * abs(one.largest - beside.largest)))


def companion_steps(scheme: str, steps: int, parts: int, samples: int) -> int:
    """Steps of the motion that one is compared with: fewer, of half the error, with as many common times as there are.

    Between two of these the numbers of steps have no common divisor, so that forces are seen at other phases.
    """
    ratio, least = 2.0 ** (1.0 / scheme_kind(scheme).make.order), lcm(parts, samples)
    if steps % least:
        other = max(1, round(steps / ratio / least)) * least
        return other if other != steps else 2 * steps
    a = common_steps(steps, ratio, steps // least)
    return 2 * steps if steps // a < COMPARED_PLACES else steps // a * coprime(a, ratio)


def _difference(motion: PeriodicMotion, other: PeriodicMotion) -> MotionError:
    """Over the period, at the ends of steps that both have."""
    samples, places = [], gcd(motion.steps, other.steps)
    for one in (motion, other):
        every = one.steps // places
        run = one.simulate(1, seen_every=every * one.period / one.steps)
        if not run.status.ok:
            raise SymgenError(f"model {motion.model.name}: the periodic motion cannot be simulated: {run.status}")
        columns = followed(motion.model)[1]
        samples.append((run.t, run.q[:, columns]))
    (t, q), (_, beside) = samples
    if len(q) != len(beside):
        q, beside, t = q[[0, -1]], beside[[0, -1]], t[[0, -1]]
    return motion_error(motion.model, t, q, beside, amplitudes(motion.model, samples[0][1]))
