"""Run a scheme on a model: the public door."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.arguments import BY_NAME, CALLED, FLAG, NAMES, PLACE, START, arguments
from runtime.contract.coordinates import Initial
from runtime.contract.errors import ArgumentError
from runtime.contract.model import EmittedModel, refuse_events
from runtime.operating.given_state import given_state
from runtime.results.motion_error import MotionError
from runtime.running.inputs import InputValue, bound, scheduled, started
from runtime.running.outcome import NOT_ASKED, comparison_times_of, finished
from runtime.running.planning import make_plan
from runtime.running.problem import (
    AUTO,
    Problem,
    common_time,
    own_spacing,
    seen_every_of,
    spacing_of,
    span_of,
    tolerance_of,
)
from runtime.running.run import start_run
from runtime.running.run_options import Progress, RunOptions
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import SchemeError
from runtime.solutions.solution import Solution

MEASURED, OFF = "measured", "off"  # what `error` may be
DEFAULT_SAMPLES = 1000  # samples of steps that follow their own error, where nothing is said
GLOBAL, LOCAL = "motion", "step"  # what a tolerance may be of

__all__ = ["simulate"]


@arguments(
    options=BY_NAME,
    parameters=BY_NAME,
    initial=START,
    inputs=BY_NAME,
    progress=CALLED,
    force=FLAG,
    outputs=NAMES,
    stream=PLACE,
    checkpoint=PLACE,
)
def simulate(
    model: EmittedModel,
    *,
    scheme: str | None = None,
    tolerance: float | None = None,
    t_end: float | None = None,
    dt: float | None = None,
    m: list[int] | None = None,
    options: Mapping[str, Any] | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Initial = None,
    start: str | None = None,
    t0: float = 0.0,
    inputs: Mapping[str, InputValue] | None = None,
    error: str = MEASURED,
    seen_every: float | None = None,
    samples: int | None = None,
    engine: str = "auto",
    progress: Progress | bool | None = None,
    force: bool = False,
    outputs: Sequence[str] | None = None,
    stream: str | Path | None = None,
    checkpoint: str | Path | None = None,
    checkpoint_every: int | None = None,
) -> Solution:
    """Compute the motion of a model from t0 to t_end. Arguments left out are those of the scene.

    Parameters
    ----------
    model : Model
        The mechanism.
    scheme : str, optional
        A name of `runtime.SCHEMES`, with its step dt and ratios m; or "auto", which chooses a method and its steps.
    tolerance : float, optional
        RMS error of the motion over its amplitudes [1]; 1e-3 with "auto". It takes the place of dt.
    t_end : float, optional
        End of the motion [s].
    dt : float, optional
        Major step [s].
    m : list of int, optional
        Ratios of steps between groups of coordinates, or the number of sub-steps.
    options : mapping, optional
        Options of the scheme, by name.
    parameters : mapping of str to float, optional
        Parameters that are not as the scene has them, in SI units.
    initial : mapping of str to float, Equilibrium or Solution, optional
        Where the motion starts: coordinates [m, rad] and rates `<coordinate>_dot` [m/s, rad/s] by name, an
        equilibrium, or a solution from whose last sample the run goes on (`run.initial_values(at=0.3)`: from
        another one).
    start : str, optional
        "given"; "quasi_static": elastic coordinates in equilibrium; "equilibrium": all but those that turn.
    t0 : float, optional
        Start of the motion [s].
    inputs : mapping, optional
        By name a number, a function of time (called once, with a symbol), (times (k,) [s], values (k,)) or a
        `Sampled`.
    error : {"measured", "off"}, optional
        "measured" computes the motion twice for `Solution.error`.
    seen_every : float, optional
        Time between stored samples [s]; 0: every step. None: what the scene says, else every step of steps of one
        length, of more than 20,000 as many as leave no more samples than that.
    samples : int, optional
        Number of stored samples besides the first, in place of `seen_every`.
    engine : {"auto", "compiled", "interpreted"}, optional
        How steps are run.
    progress : bool or callable, optional
        True shows a line; a function is called with (t, t_end).
    force : bool, optional
        Run although the step is above the stability limit.
    outputs : sequence of str, optional
        Coordinates, rates, measures and energies by name: only these are kept, in `Solution.outputs`.
    stream : path, optional
        A folder that takes the samples.
    checkpoint : path, optional
        A file for `resume`, written every `checkpoint_every` major steps (None: every minute) and on Ctrl-C.
    checkpoint_every : int, optional
        Major steps between checkpoints.

    Returns
    -------
    Solution
        Samples of the motion, how it ended (`status`) and its error. A numerical failure does not raise.

    Raises
    ------
    ArgumentError, SchemeError, ModelError, InitialStateError, OutputError, CompilerError
        For arguments that cannot be used.

    Notes
    -----
    The steps solve M_hat(q_i) q_i'' = Q_hat(q_i, q_i') (Eq. 38); dependent coordinates close the loops at every
    evaluation.

    References
    ----------
    Miao, Zhu, Shi and Chen (2008), part I; each scheme names its own, see `runtime.schemes`.
    """
    if progress is True:
        from runtime.contract.meter import Meter

        with Meter(model.name) as meter:
            return simulate(
                model, scheme=scheme, tolerance=tolerance, t_end=t_end, dt=dt, m=m, options=options,
                parameters=parameters, initial=initial, start=start, t0=t0, inputs=inputs, error=error,
                seen_every=seen_every, samples=samples, engine=engine, progress=meter, force=force, outputs=outputs,
                stream=stream, checkpoint=checkpoint, checkpoint_every=checkpoint_every,
            )  # fmt: skip
    if error not in (MEASURED, OFF):
        raise SchemeError(f"error must be {MEASURED} or {OFF}, not {error!r}")
    if checkpoint_every is not None and checkpoint_every < 1:
        raise ArgumentError("checkpoint_every", f"cannot be {checkpoint_every}", "give a number of steps from 1 on")
    run_options = RunOptions(progress, force, outputs, stream, checkpoint, checkpoint_every)
    model = bound(model, inputs)
    begin, end = span_of(model, t0, t_end)
    spacing = seen_every_of(seen_every, samples, begin, end)
    if not model.q_i:
        return _driven(model, begin, end, dt, parameters, initial, spacing, run_options, inputs)
    asked = tolerance_of(model, scheme, tolerance, dt)
    if asked is not None and dt is not None:
        raise SchemeError(
            "dt",
            "cannot be given with a tolerance, which chooses the step",
            "leave dt out (seen_every spaces the samples), or name a scheme",
        )
    if asked is not None and spacing is None and scheme is None and tolerance is None:
        spacing = own_spacing(model, begin, end)
    wanted = scheme or (AUTO if tolerance is not None else str(model.simulation["scheme"]))
    if wanted == AUTO and (m is not None or options):
        raise SchemeError("auto chooses m and options itself; leave them out, or name a scheme")
    local = (options or {}).get("error_of", GLOBAL) == LOCAL
    if asked is not None and not local:
        problem = Problem.of(model, t_end, parameters, initial, start, t0, inputs, engine)
        if not problem.forgets:
            wanted, options, local = _made_once(problem, wanted), {**(options or {}), "error_of": LOCAL}, True
    if asked is not None and not local:
        chosen = {name: value for name, value in (options or {}).items() if name != "error_of"}
        from runtime.running.step_refinement import by_step_refinement

        return by_step_refinement(problem, asked, wanted, m, chosen, spacing or None, run_options)
    if local and asked is not None:
        options = {**(options or {}), "tolerance": asked}
        spacing = spacing if spacing is not None else own_spacing(model, begin, end)
        dt = spacing = _sampling_step(begin, end, spacing, spacing_of(inputs or {}, t0))
    plan = make_plan(model, end, dt, m, wanted, spacing, options, begin, run_options.bounded)
    plan = replace(plan, force=force, outputs=tuple(outputs or ()))
    problem = Problem.of(model, end, parameters, initial, start, begin, inputs, engine, plan.grid.dt_L)
    run = start_run(problem, plan, comparison_times_of(problem, plan) if error == MEASURED else None, run_options)
    return finished(run, MotionError(reason=NOT_ASKED) if error == OFF else None)


def _made_once(problem: Problem, wanted: str) -> str:
    """The scheme for a tolerance where a controller cannot be set back, so that the motion is made but once.

    Raises SchemeError where that scheme cannot tell its own steps' lengths.
    """
    from runtime.running.method_choice import chosen_method

    name = str(chosen_method(problem)[0].scheme if wanted == AUTO else wanted)
    if "error_of" in scheme_kind(name).options.names():
        return name
    if wanted == AUTO:
        return "dopri5"
    raise SchemeError(
        "inputs",
        f"a controller may remember what cannot be set back, and {name} makes the motion several times for a tolerance",
        "give its numbers as Sampled(..., memory=[...]), memory=() if it has none",
    )


def _sampling_step(begin: float, end: float, asked: float | None, sampled: float | None) -> float:
    """Time from sample to sample [s] of steps whose length follows from their own error; a whole number of it in all.

    sampled: time from sample to sample of the inputs [s], if they have one.
    """
    spacing = asked or (end - begin) / DEFAULT_SAMPLES
    if not 0 < spacing <= end - begin:
        raise SchemeError(f"seen_every must be a time within the motion, not {asked!r}")
    if sampled is not None:
        return common_time(sampled, spacing) if asked else sampled / max(1, round(sampled / spacing))
    return (end - begin) / max(1, round(float(np.ceil((end - begin) / spacing - 1e-6))))


def _driven(
    model: EmittedModel,
    begin: float,
    end: float,
    dt: float | None,
    parameters: Mapping[str, float] | None,
    initial: Initial,
    spacing: float | None,
    run_options: RunOptions,
    inputs: Mapping[str, InputValue] | None,
) -> Solution:
    """The motion of a model in which every coordinate is driven: nothing is stepped, whatever the scheme."""
    refuse_events(model, "a motion in which every coordinate is driven")
    if run_options.bounded or run_options.checkpoint is not None:
        raise SchemeError(
            "outputs, stream, checkpoint",
            f"belong to runs that step, and every coordinate of model {model.name} is driven",
            "leave them out",
        )
    settings = model.simulation
    step = spacing or (own_spacing(model, begin, end) or settings["dt"] if dt is None else dt)
    if isinstance(step, bool) or not isinstance(step, int | float | np.number) or not 0 < step < np.inf:
        raise SchemeError(f"dt must be a positive number of seconds, not {step!r}")
    schedule = scheduled(model, inputs, begin, float(step))
    if schedule.controllers:
        raise SchemeError(
            "inputs", "a controller has nothing to act on where every coordinate is driven", "give samples"
        )
    p = started(model, model.parameter_vector(parameters), schedule, begin)
    state = given_state(model, p, model.constants(p), begin, initial)
    from runtime.running.driven import driven_solution

    return driven_solution(model, p, state, begin, end, float(step), schedule)
