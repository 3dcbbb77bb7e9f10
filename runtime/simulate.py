"""Run a scheme on a model: many major steps a native call, checks and output in between."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from math import ceil
from numbers import Real
from operator import index
from typing import Any

import numpy as np

from runtime.auto import AUTO, choose
from runtime.engine.choose import sub_step_operations
from runtime.model import Model
from runtime.observe import observe_samples
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.grid import Grid
from runtime.schemes.options import SchemeError
from runtime.schemes.scheme import Scheme, evaluation_operations
from runtime.solution import Solution
from runtime.start_state import start_state
from runtime.status import Status
from runtime.stepper import Stepper
from runtime.watch import Watch

MAX_SAMPLES = 10_000_000
MAX_STEPS = 1e15
STEP_ROUNDING = 1e-6  # of a step: t_end / dt is a whole number up to this
CALL_SECONDS = 0.25  # a native call lasts about this long, so that progress and Ctrl-C stay responsive
Progress = Callable[[float, float], None]


@dataclass(frozen=True)
class Plan:
    """Checked arguments of a run."""

    scheme: Scheme
    steps: int
    save_every: int
    t0: float

    @property
    def grid(self) -> Grid:
        """Groups and steps."""
        return self.scheme.grid


def simulate(
    model: Model, *, t_end: float | None = None, dt: float | None = None, m: list[int] | None = None,
    scheme: str | None = None, parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None, save_every: int | None = None, engine: str = "auto",
    options: Mapping[str, Any] | None = None, t0: float = 0.0, progress: Progress | None = None, force: bool = False,
    start: str | None = None, tolerance: float | None = None, graded: list[str] | None = None,
) -> Solution:
    """Simulate from t0 with major step dt and ratios m until t_end is reached (None: the scene's own settings).

    The steps are all dt long, so the run ends at t_end or less than one step after it.

    scheme: a name of runtime.schemes.catalogue.SCHEMES, or `auto`: the fastest one that keeps `tolerance` (1e-3) in the
    graded coordinates (all), with the step and m that runtime.advice finds. options: changes to its Options by name.
    parameters and initial change values by name (rates as `<coordinate>_dot`). save_every counts major steps.
    progress(t, t_end) is called between native calls. start: `given` or `quasi_static` (elastic coordinates in
    equilibrium). A run whose step is above the stability limit at the start stops there, unless `force`.
    Numerical failure does not raise: see Solution.status. Raises SchemeError, ModelError, InitialStateError or
    CompilerError for arguments that cannot be used.
    """
    if (scheme or model.simulation.get("scheme")) == AUTO:
        if dt is not None or m is not None or options:
            raise SchemeError("auto chooses dt, m and options itself; leave them out and give a tolerance")
        chosen = choose(model, t_end, parameters, initial, start, tolerance, graded, save_every, t0)
        solution = simulate(model, t_end=t_end, parameters=parameters, initial=initial, engine=engine, t0=t0,
                            progress=progress, force=force, start=start, **chosen.arguments)
        solution.stats["advice"] = chosen.reason
        return solution
    if tolerance is not None or graded is not None:
        raise SchemeError("tolerance and graded belong to scheme = auto; other schemes take the step dt")
    plan = make_plan(model, t_end, dt, m, scheme, save_every, options, t0)
    p = model.parameter_vector(parameters)
    c = model.constants(p)
    state = start_state(model, p, c, t0, initial, start)
    started = time.perf_counter()
    stepper = Stepper(plan.scheme, engine, plan.steps)
    ready = stepper.ready(c, plan.grid.dt_L)
    set_up = time.perf_counter()
    z = stepper.start(t0, state.q, state.q_dot, c, plan.grid.dt_L)
    watch = Watch(model, plan.scheme, c, force=force)
    samples, status = _run(plan, stepper, z, ready, watch, progress)
    finished = time.perf_counter()
    name = scheme or str(model.simulation["scheme"])
    stats = _statistics(plan, stepper, samples[-1], set_up - started, finished - set_up)
    stats["options"] = ", ".join(f"{key} = {getattr(plan.scheme.options, key)}" for key in scheme_kind(name).takes)
    stats["initial_changes"] = ", ".join(f"{key}: {given:.9g} -> {used:.9g}"
                                         for key, (given, used) in state.changed.items()) or "none"
    if stepper.engine.note:
        stats["engine_note"] = stepper.engine.note
    if watch.step_limit is not None:
        stats["step_limit_at_start"] = watch.step_limit
    return observe_samples(model, plan.scheme, np.array(samples), p, c, name, stats, status)


def make_plan(model: Model, t_end: float | None, dt: float | None, m: list[int] | None, scheme: str | None,
              save_every: int | None, options: Mapping[str, Any] | None, t0: float) -> Plan:
    """Resolve defaults and check every number of a run. Raises SchemeError."""
    defaults = model.simulation
    name = scheme or str(defaults["scheme"])
    ratios = None if m is None else _whole_numbers(m)
    built = scheme_kind(name).build(name, model, float(defaults["dt"]) if dt is None else dt, ratios, options or {})
    grid = built.grid
    if isinstance(t0, bool) or not isinstance(t0, int | float) or not np.isfinite(t0):
        raise SchemeError(f"t0 must be a time in seconds, not {t0!r}")
    end = float(defaults["t_end"]) if t_end is None else t_end
    if isinstance(end, bool) or not isinstance(end, Real) or not np.isfinite(float(end)) or float(end) <= t0:
        raise SchemeError(f"t_end must be a time after t0 = {t0:g} s, not {end!r}")
    end = float(end)
    every = _whole_number(int(defaults["save_every"]) if save_every is None else save_every)
    if every is None or every < 1:
        raise SchemeError(f"save_every must be a whole number of major steps of at least 1, not {save_every!r}")
    if grid.dt_L > (end - t0) * (1 + STEP_ROUNDING):
        raise SchemeError(f"dt = {grid.dt_L:g} s is longer than the simulation ({end - t0:g} s); give a smaller step")
    if (end - t0) / grid.dt_L > MAX_STEPS:
        raise SchemeError(f"dt = {grid.dt_L:g} s needs more than {MAX_STEPS:.0e} steps; raise dt or lower t_end")
    steps = max(1, ceil((end - t0) / grid.dt_L - STEP_ROUNDING))
    if steps / every > MAX_SAMPLES:
        raise SchemeError(f"{steps // every:.3g} saved states are too many; raise save_every or dt")
    return Plan(built, steps, every, t0)


def _whole_number(value: Any) -> int | None:
    """An int, also from a NumPy integer; None for anything else (a bool, 2.0)."""
    try:
        return None if isinstance(value, bool) else index(value)
    except TypeError:
        return None


def _whole_numbers(values: Any) -> list[Any]:
    """m as a list, NumPy integers as int; what is not whole stays for the grid to refuse. Raises SchemeError."""
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise SchemeError(f"m must be a list with one ratio between each two groups, not {values!r}")
    return [value if (whole := _whole_number(value)) is None else whole for value in values]


def _run(plan: Plan, stepper: Stepper, z: np.ndarray, c: np.ndarray, watch: Watch,
         progress: Progress | None) -> tuple[list[np.ndarray], Status]:
    """Samples of z, the last one good, and the status."""
    state = stepper.state(z)
    samples = [state.copy()]
    status = watch.first(state)
    done, per_call = 0, 1
    try:
        while done < plan.steps and status is None:
            until_save = plan.save_every - done % plan.save_every
            n = min(until_save, plan.steps - done, per_call)
            began = time.perf_counter()
            stepper.run(z, c, n)
            elapsed = time.perf_counter() - began
            done += n
            per_call = _next_batch(per_call, elapsed)
            status = watch.after(state, last=done == plan.steps)
            if status is None and (done % plan.save_every == 0 or done == plan.steps):
                samples.append(state.copy())
            if progress is not None:
                progress(plan.t0 + done * plan.grid.dt_L, plan.t0 + plan.steps * plan.grid.dt_L)
    except KeyboardInterrupt:
        status = Status("interrupted", plan.t0 + done * plan.grid.dt_L, None, "stopped by the user",
                        "What was computed is kept.")
    if status is not None:  # end with the last good state, which need not be one that was to be saved
        samples = [one for one in samples if watch.steps_done(one) < watch.steps_done(state)] + [state.copy()]
    return samples, status or Status("completed", plan.t0 + plan.steps * plan.grid.dt_L)


def _next_batch(per_call: int, elapsed: float) -> int:
    """Double or halve: the interpreted engine builds one Function per batch length, so there should be few."""
    if elapsed < CALL_SECONDS / 4:
        return min(per_call * 2, 1 << 20)
    return max(1, per_call // 2) if elapsed > CALL_SECONDS else per_call


def _statistics(plan: Plan, stepper: Stepper, z: np.ndarray, setup: float,
                wall: float) -> dict[str, float | int | str]:
    layout = plan.scheme.layout
    steps = int(z[layout.slice("n")][0])
    iterations = int(z[layout.slice("iterations")][0])
    full, partial = plan.scheme.evaluations()
    full_evaluations, sub_steps = iterations or steps * full, steps * partial
    repeated = sub_step_operations(stepper.program) if partial else None
    cost = {} if repeated is None else {"sub_step_cost": repeated / evaluation_operations(plan.scheme)}
    return {
        **cost,
        "steps": steps, "sub_steps": sub_steps, "full_evaluations": full_evaluations,
        "evaluations": full_evaluations + sub_steps, "iterations": iterations, "engine": stepper.engine.name,
        "operations_per_step": stepper.operations,
        "setup_seconds": setup, "wall_seconds": wall,
        "seconds_per_step": wall / max(1, steps),
    }
