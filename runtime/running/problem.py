"""What a run is asked to do: a model with parameters, inputs and a start, checked once, over a span of time; and the
plan of its steps: a scheme on the model, how many of its steps are made and which are saved.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import accumulate
from math import ceil
from operator import index, truediv
from typing import Any

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import Initial
from runtime.contract.model import EmittedModel
from runtime.running.going_on import goes_on
from runtime.running.inputs import InputValue, Sampled, Schedule, scheduled, started
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import LARGEST_TOLERANCE, Grid, SchemeError
from runtime.schemes.scheme import Scheme
from runtime.start.start_state import start_state

LEAST_SAMPLES = 100  # samples of a motion whose spacing is the scene's
ONE_TIME = 1e-9  # of a time: two that differ by less are one
SPAN_ROUNDING = 1e-6  # of an interval: a span is a whole number of them up to this


@dataclass(frozen=True, eq=False)
class Problem:
    """A model from a consistent state at t0 until t_end [s], with parameters p (n_p,) and inputs.

    quiet: events that are not looked for at first, and until when [s].
    Everybody who makes this motion takes it: a run, its companion, the levels of a refinement. Nobody changes it.
    """

    model: EmittedModel
    p: np.ndarray
    state: ConsistentState
    t0: float
    t_end: float
    inputs: Mapping[str, InputValue]
    engine: str = "auto"
    quiet: Mapping[str, float] = field(default_factory=dict)

    @staticmethod
    def of(
        model: EmittedModel,
        t_end: float | None = None,
        parameters: Mapping[str, float] | None = None,
        initial: Initial = None,
        start: str | None = None,
        t0: float = 0.0,
        inputs: Mapping[str, InputValue] | None = None,
        engine: str = "auto",
        dt: float | None = None,
    ) -> Problem:
        """Checked, of a model that its inputs are bound to; dt: of the steps, where they are known [s].

        Raises SchemeError for times, ModelError and InitialStateError for parameters, inputs and the start.
        """
        begin, end = span_of(model, t0, t_end)
        grid = dt if dt is not None else spacing_of(inputs or {}, begin) or (end - begin)
        p = model.parameter_vector(parameters)
        going = goes_on(model, initial, begin, p, parameters or {}, inputs or {})
        if going is not None:
            inputs, p = going.inputs, np.concatenate([p[: len(p) - len(going.w)], going.w])
        p = started(model, p, scheduled(model, inputs, begin, grid), begin)
        state = start_state(model, p, model.constants(p), begin, initial, start)
        quiet = {} if going is None else going.quiet
        return Problem(model, p, state, begin, end, dict(inputs or {}), engine, quiet)

    def schedule(self, dt: float) -> Schedule:
        """What becomes of the inputs on a grid of steps dt [s], from the start; controllers remember nothing yet."""
        return scheduled(self.model, self.inputs, self.t0, dt)

    @cached_property
    def numbers(self) -> tuple[float | bytes, ...]:
        """What the motion of a model, with its inputs, depends on."""
        state = self.state
        return self.t0, self.t_end, self.p.tobytes(), state.q.tobytes(), state.q_dot.tobytes()

    @cached_property
    def spacing(self) -> float | None:
        """The longest step at whose multiples all inputs are sampled [s]; None: nothing is sampled."""
        return spacing_of(self.inputs, self.t0)

    @property
    def forgets(self) -> bool:
        """Can the motion be made again? A controller that keeps memory of its own may give other numbers then."""
        return all(one.memory is not None for one in self.inputs.values() if isinstance(one, Sampled))


def span_of(model: EmittedModel, t0: Any, t_end: Any) -> tuple[float, float]:
    """(t0, t_end) [s], the scene's own end where none is given. Raises SchemeError."""
    if isinstance(t0, bool) or not isinstance(t0, int | float | np.number) or not np.isfinite(t0):
        raise SchemeError(f"t0 must be a time in seconds, not {t0!r}")
    end = model.simulation["t_end"] if t_end is None else t_end
    if isinstance(end, bool) or not isinstance(end, int | float | np.number) or not np.isfinite(end) or end <= t0:
        raise SchemeError(f"t_end must be a time after t0 = {t0:g} s, not {end!r}")
    return float(t0), float(end)


def seen_every_of(seen_every: Any, samples: Any, t0: float, t_end: float) -> float | None:
    """The time from sample to sample that is asked for [s], 0 for every step; None: nothing is. Raises SchemeError."""
    if seen_every is not None and samples is not None:
        raise SchemeError("seen_every, samples", "exclude each other", "give the time between samples or their number")
    if samples is not None:
        if isinstance(samples, bool) or not isinstance(samples, int | np.integer) or samples < 1:
            raise SchemeError(f"samples must be a whole number of at least 1, not {samples!r}")
        return (t_end - t0) / int(samples)
    number = isinstance(seen_every, int | float | np.number) and not isinstance(seen_every, bool)
    if seen_every is not None and not (number and 0 <= seen_every < np.inf):
        raise SchemeError(f"seen_every must be a time between samples in seconds, not {seen_every!r}")
    return None if seen_every is None else float(seen_every)


def own_spacing(model: EmittedModel, t0: float, t_end: float) -> float:
    """The scene's time from sample to sample [s], 0 for every step; of a shorter motion such that it is still seen."""
    return min(float(model.simulation.get("seen_every", 0.0)), (t_end - t0) / LEAST_SAMPLES)


def spacing_of(inputs: Mapping[str, InputValue], t0: float) -> float | None:
    """The longest time of which all periods of controllers and all times of samples are multiples [s], if there
    are.
    """
    times = [value.every for value in inputs.values() if isinstance(value, Sampled)]
    for value in inputs.values():
        if isinstance(value, tuple | list) and len(value):
            try:
                times += [float(t) - t0 for t in value[0] if float(t) > t0]
            except (TypeError, ValueError):  # not two lists of numbers: who reads them says so
                continue
    times = [t for t in times if isinstance(t, int | float) and np.isfinite(t) and t > 0]
    found: float | None = None
    for t in times:
        found = t if found is None else common_time(found, t)
    return found


def common_time(a: float, b: float) -> float:
    """The largest time of which both are multiples [s], up to rounding."""
    least = ONE_TIME * max(a, b)
    while b > least:
        a, b = b, a % b
        if a - b < least:  # a remainder that is the divisor but for rounding
            b = 0.0
    return a


# ---- The plan of steps -----------------------------------------------------------------------------------------

AUTO = "auto"
DEFAULT = 1e-3  # of `auto`
LEAST_TOLERANCE = 1e-13
MAX_SAMPLES = 10_000_000
MOST_KEPT = 20_000  # samples of a run for which no time between them is asked
MAX_STEPS = 1e15
DISTINCT_TIMES = 2.0**-49  # dt over a time, at least
STEP_COUNT_ROUNDING = 1e-6  # of a step: t_end / dt is a whole number up to this
SAME_END = 1e-11  # of times: an end that near is the end that a clock shows


@dataclass(frozen=True)
class Plan:
    """A scheme on a model, by name and built, and how many of its steps are made and saved.

    options: the user's changes to the scheme's Options; a variant of the model is stepped with the same ones.
    seen_steps: steps from sample to sample. force: run although the step is above its limit. outputs: the quantities
    that are kept, () for all. end [s]: where the last step ends, if it is shorter than the others; None: all are
    alike.
    """

    name: str
    scheme: Scheme
    options: Mapping[str, Any]
    steps: int
    seen_steps: int
    t0: float
    force: bool = False
    outputs: tuple[str, ...] = ()
    refined: bool = False
    end: float | None = None

    @property
    def numbers(self) -> dict[str, Any]:
        """In plain numbers and words, for `of_numbers`."""
        found = {name: getattr(self, name) for name in ("steps", "seen_steps", "t0", "force", "outputs", "end")}
        return found | {"scheme": self.name, "dt": self.grid.dt_L, "m": self.grid.m, "options": dict(self.options)}

    @staticmethod
    def of_numbers(model: EmittedModel, numbers: Mapping[str, Any]) -> Plan:
        """On a model, from `numbers` as JSON gives them back. Raises SchemeError."""
        rest = dict(numbers)
        name, dt, m, options = (rest.pop(key) for key in ("scheme", "dt", "m", "options"))
        options = {key: tuple(value) if isinstance(value, list) else value for key, value in options.items()}
        built = scheme_kind(name).build(name, model, dt, m or None, options)
        return Plan(name, built, options, **rest | {"outputs": tuple(rest["outputs"])})

    @property
    def grid(self) -> Grid:
        """Groups and steps."""
        return self.scheme.grid

    def time(self, step: int) -> float:
        """Time after so many major steps [s]."""
        if self.end is not None and step == self.steps:
            return self.end
        return self.on_grid(step)

    def times(self, steps: Sequence[int] | np.ndarray) -> np.ndarray:
        """(N,) the same of many [s]."""
        found = self.t0 + np.asarray(steps) * self.grid.dt_L
        return found if self.end is None else np.where(np.asarray(steps) == self.steps, self.end, found)

    def on_grid(self, step: int) -> float:
        """Time after so many steps that are all alike [s]."""
        return self.t0 + step * self.scheme.grid.h[0]

    @property
    def t_end(self) -> float:
        """Time after the last step [s]."""
        return self.time(self.steps)

    @property
    def whole_steps(self) -> int:
        """Major steps that are not shortened."""
        return self.steps if self.end is None else self.steps - 1

    @property
    def last_step(self) -> float:
        """How long the last step is [s]."""
        return self.grid.dt_L if self.end is None else self.end - self.on_grid(self.whole_steps)

    def until(self, end: float) -> Plan:
        """The same plan with as many steps as lead to an end [s], of which the last may be shorter."""
        return replace(self, **steps_until(self.t0, end, self.grid.dt_L))

    def with_steps(self, model: EmittedModel, dt: float, steps: int, options: Mapping[str, Any] | None = None) -> Plan:
        """The same plan with so many steps of dt [s], all alike, and perhaps other options. Raises SchemeError."""
        if options is None:
            h = list(accumulate([dt, *self.grid.m], truediv))
            return replace(self, scheme=self.scheme.on(replace(self.grid, h=h)), steps=steps, end=None)
        built = scheme_kind(self.name).build(self.name, model, dt, list(self.grid.m) or None, options)
        return replace(self, scheme=built, options=options, steps=steps, end=None)

    def on(self, model: EmittedModel) -> Plan:
        """The same plan for a variant of the model with as many groups, on the way: its step is not judged again.

        Raises SchemeError.
        """
        built = scheme_kind(self.name).build(self.name, model, self.grid.dt_L, list(self.grid.m) or None, self.options)
        return replace(self, scheme=built, force=True)


def checked_plan(
    model: EmittedModel,
    t_end: float | None,
    dt: float,
    m: list[int] | None,
    scheme: str,
    seen_every: float | None,
    options: Mapping[str, Any] | None,
    t0: float,
    bounded: bool = False,
) -> Plan:
    """Check every number of a run. seen_every [s]: time from sample to sample, 0: every step; None: what the scene
    says, else every step, of long runs every so many.

    bounded: samples do not stay in memory. Raises SchemeError.
    """
    ratios = None if m is None else _whole_numbers(m)
    built = scheme_kind(scheme).build(scheme, model, dt, ratios, options or {})
    t0, end = span_of(model, t0, t_end)
    dividing = dividing_step(t0, end, built.grid.dt_L)
    if dividing != built.grid.dt_L:
        built = scheme_kind(scheme).build(scheme, model, dividing, ratios, options or {})
    grid = built.grid
    spacing = own_spacing(model, t0, end) if seen_every is None else seen_every
    every = max(1, round(spacing / grid.dt_L))
    if grid.dt_L > (end - t0) * (1 + STEP_COUNT_ROUNDING):
        raise SchemeError(f"dt = {grid.dt_L:g} s is longer than the simulation ({end - t0:g} s); give a smaller step")
    if (end - t0) / grid.dt_L > MAX_STEPS:
        raise SchemeError(f"dt = {grid.dt_L:g} s needs more than {MAX_STEPS:.0e} steps; raise dt or lower t_end")
    refuse_alike(t0, end, grid.dt_L)
    if seen_every is None and not spacing and not bounded:
        every = max(1, ceil((end - t0) / grid.dt_L / MOST_KEPT - STEP_COUNT_ROUNDING))
    found = Plan(scheme, built, dict(options or {}), 1, every, float(t0)).until(end)
    if found.steps / every > MAX_SAMPLES and not bounded:
        raise SchemeError(
            f"{found.steps // every:.3g} saved states are too many; raise seen_every or dt, or stream them"
        )
    return found


def steps_until(t0: float, end: float, dt: float) -> dict[str, Any]:
    """`steps` of dt from t0 to an end, and `end` where the last one is shorter; None: all are alike [s]."""
    count = (end - t0) / dt
    steps = max(1, ceil(count - STEP_COUNT_ROUNDING))
    return {"steps": steps, "end": end if steps - count > STEP_COUNT_ROUNDING else None}


def dividing_step(t0: float, end: float, dt: float) -> float:
    """dt, or the step that divides the span where dt does up to `STEP_COUNT_ROUNDING` [s].

    A third of a second written with seven digits is meant as a third, and a run ends at its end.
    """
    if (end - t0) / dt > MAX_STEPS:  # which is refused
        return dt
    steps = steps_until(t0, end, dt)
    exact = (end - t0) / steps["steps"]
    told_apart = abs(exact - dt) * steps["steps"] > SAME_END * max(abs(t0), abs(end))
    return exact if steps["end"] is None and told_apart else dt


def refuse_alike(t0: float, end: float, dt: float) -> None:
    """Raises SchemeError for times dt apart that are one number [s]."""
    latest = max(abs(t0), abs(end))
    if dt < DISTINCT_TIMES * latest:
        near = f"times near {latest:g} s that are {dt:g} s apart"
        raise SchemeError(f"{near} cannot be distinguished; start at t0 = 0")


def tolerance_of(
    model: EmittedModel, scheme: str | None, tolerance: float | None, dt: float | None = None
) -> float | None:
    """The tolerance of a run: what was given, that of the scene where its own scheme runs without a step dt, or
    that of `auto`; None for a run with steps of its own. Raises SchemeError for one out of range, and for an
    unknown scheme.
    """
    name = scheme or (AUTO if tolerance is not None else str(model.simulation["scheme"]))
    if name != AUTO:
        scheme_kind(name)
    if tolerance is None and scheme in (None, AUTO):
        tolerance = model.simulation.get("tolerance") or (DEFAULT if name == AUTO else None)
    if tolerance is None:
        return None
    if isinstance(tolerance, bool) or not isinstance(tolerance, int | float) or not 0 < tolerance <= LARGEST_TOLERANCE:
        raise SchemeError(f"tolerance must be between 0 and {LARGEST_TOLERANCE:g}, not {tolerance!r}")
    if tolerance < LEAST_TOLERANCE:
        raise SchemeError(f"tolerance = {tolerance:g} is below what rounding leaves; give at least {LEAST_TOLERANCE:g}")
    return float(tolerance)


def whole_number(value: Any) -> int | None:
    """An int, also from a NumPy integer; None for anything else (a bool, 2.0)."""
    try:
        return None if isinstance(value, bool) else index(value)
    except TypeError:
        return None


def _whole_numbers(values: Any) -> list[Any]:
    """m as a list, NumPy integers as int; what is not whole stays for the grid to refuse. Raises SchemeError."""
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise SchemeError(f"m must be a list with one ratio between each two groups, not {values!r}")
    return [value if (whole := whole_number(value)) is None else whole for value in values]
