"""The checked arguments of a run."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import accumulate
from math import ceil
from operator import index, truediv
from typing import Any

from runtime.contract.doors import opened
from runtime.contract.model import Model
from runtime.running.problem import own_spacing, span_of
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import LARGEST_TOLERANCE, Grid, SchemeError
from runtime.schemes.scheme import Scheme

AUTO = "auto"
DEFAULT = 1e-3  # of `auto`
LEAST_TOLERANCE = 1e-13
MAX_SAMPLES = 10_000_000
MAX_STEPS = 1e15
TOLD_APART = 2.0**-49  # dt over a time, at least
STEP_ROUNDING = 1e-6  # of a step: t_end / dt is a whole number up to this


@dataclass(frozen=True)
class Plan:
    """A scheme on a model, by name and built, and how many of its steps are made and saved.

    options: the user's changes to the scheme's Options; a variant of the model is stepped with the same ones.
    seen_steps: steps from sample to sample. force: run although the step is above its limit. outputs: the quantities
    that are kept, () for all.
    """

    name: str
    scheme: Scheme
    options: Mapping[str, Any]
    steps: int
    seen_steps: int
    t0: float
    force: bool = False
    outputs: tuple[str, ...] = ()

    @property
    def numbers(self) -> dict[str, Any]:
        """In plain numbers and words, for `of_numbers`."""
        found = {name: getattr(self, name) for name in ("steps", "seen_steps", "t0", "force", "outputs")}
        return found | {"scheme": self.name, "dt": self.grid.dt_L, "m": self.grid.m, "options": dict(self.options)}

    @staticmethod
    def of_numbers(model: Model, numbers: Mapping[str, Any]) -> Plan:
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
        return self.t0 + step * self.scheme.grid.h[0]

    @property
    def t_end(self) -> float:
        """Time after the last step [s]."""
        return self.time(self.steps)

    def with_steps(self, model: Model, dt: float, steps: int, options: Mapping[str, Any] | None = None) -> Plan:
        """The same plan with so many steps of dt [s], and perhaps other options. Raises SchemeError."""
        if options is None:
            h = list(accumulate([dt, *self.grid.m], truediv))
            return replace(self, scheme=self.scheme.on(replace(self.grid, h=h)), steps=steps)
        built = scheme_kind(self.name).build(self.name, model, dt, list(self.grid.m) or None, options)
        return replace(self, scheme=built, options=options, steps=steps)

    def on(self, model: Model) -> Plan:
        """The same plan for a variant of the model with as many groups, on the way: its step is not judged again.

        Raises SchemeError.
        """
        built = scheme_kind(self.name).build(self.name, model, self.grid.dt_L, list(self.grid.m) or None, self.options)
        return replace(self, scheme=built, force=True)


def make_plan(
    model: Model,
    t_end: float | None,
    dt: float | None,
    m: list[int] | None,
    scheme: str | None,
    seen_every: float | None,
    options: Mapping[str, Any] | None,
    t0: float,
    bounded: bool = False,
) -> Plan:
    """Resolve defaults and check every number of a run. seen_every [s]: time from sample to sample, 0: every step.

    bounded: samples do not stay in memory. Raises SchemeError.
    """
    name, dt = steps_asked(model, scheme, dt, m, options, t0, t_end)
    ratios = None if m is None else _whole_numbers(m)
    built = scheme_kind(name).build(name, model, dt, ratios, options or {})
    grid = built.grid
    t0, end = span_of(model, t0, t_end)
    seen = own_spacing(model, t0, end) if seen_every is None else seen_every
    every = max(1, round(seen / grid.dt_L))
    if grid.dt_L > (end - t0) * (1 + STEP_ROUNDING):
        raise SchemeError(f"dt = {grid.dt_L:g} s is longer than the simulation ({end - t0:g} s); give a smaller step")
    if (end - t0) / grid.dt_L > MAX_STEPS:
        raise SchemeError(f"dt = {grid.dt_L:g} s needs more than {MAX_STEPS:.0e} steps; raise dt or lower t_end")
    refuse_alike(t0, end, grid.dt_L)
    steps = max(1, ceil((end - t0) / grid.dt_L - STEP_ROUNDING))
    if steps / every > MAX_SAMPLES and not bounded:
        raise SchemeError(f"{steps // every:.3g} saved states are too many; raise seen_every or dt, or stream them")
    return Plan(name, built, dict(options or {}), steps, every, float(t0))


def refuse_alike(t0: float, end: float, dt: float) -> None:
    """Raises SchemeError for times dt apart that are one number [s]."""
    latest = max(abs(t0), abs(end))
    if dt < TOLD_APART * latest:
        near = f"times near {latest:g} s that are {dt:g} s apart"
        raise SchemeError(f"{near} cannot be told from each other; begin at t0 = 0")


def steps_asked(
    model: Model,
    scheme: str | None,
    dt: float | None,
    m: list[int] | None,
    options: Mapping[str, Any] | None,
    t0: float = 0.0,
    t_end: float | None = None,
) -> tuple[str, float]:
    """(scheme, dt [s]) of steps of one length: what was given, else the scene's own; where neither names a scheme, what
    `auto` finds for the motion up to t_end as the scene has it. Raises SchemeError.
    """
    name = scheme or str(model.simulation["scheme"])
    if name != AUTO:
        return name, float(model.simulation["dt"]) if dt is None else dt
    if m is not None or options:
        raise SchemeError("auto chooses m and options itself; leave them out, or name a scheme")
    found, step = opened("runtime.running.ladder:usual_steps")(model, t0, t_end)
    return found, step if dt is None else dt


def tolerance_of(model: Model, scheme: str | None, tolerance: float | None, dt: float | None = None) -> float | None:
    """The tolerance of a run: what was given, that of the scene where its own scheme runs without a step dt, or that of
    `auto`; None for a run with steps of its own. Raises SchemeError for one out of range, and for an unknown scheme.
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
