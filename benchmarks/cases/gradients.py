"""Derivatives of a run in multiples of the run: one direction forward, all of them backward."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from benchmarks.harness.result import Line, Result
from benchmarks.harness.timing import Timing, interleave
from runtime import DifferentiableRun, load_model
from runtime.engine.derivatives import LaneArrays, Recorder, TangentCode, most_lanes
from runtime.engine.native import NativeProgram
from runtime.gradients import End
from runtime.gradients.started_run import Beginning
from runtime.model import Model
from symgen.scenes import generated_folder

STEPS, ROUNDS = 250, 40
MODEL = "flexible_slider_crank_free"
# scheme: (settings, most scalar runs a direction forward, most scalar runs backward)
SCHEMES: dict[str, tuple[dict, float, float]] = {
    "single_rate": ({"dt": 2e-5}, 0.7, 4.0),
    "exponential": ({"dt": 2e-4, "m": [4]}, 0.7, 6.0),
    "printed": ({"dt": 2e-5, "m": [4]}, 0.7, 6.0),
}
AGREEMENT = 1e-12
SMALLEST = {"SCHEMES": {"single_rate": SCHEMES["single_rate"]}, "STEPS": 20, "ROUNDS": 2}


def run() -> Result:
    """The freely running slider-crank by all its parameters and initial values."""
    model, lines, details = load_model(generated_folder(MODEL)), [], {}
    for scheme, (settings, forward, backward) in SCHEMES.items():
        found, details[scheme] = _scheme(model, scheme, settings, forward, backward)
        lines += found
    remark = (
        f"Model `{MODEL}`, {STEPS} steps, CPU time of one thread. A scalar run is the same steps without derivatives, "
        "compiled by the same engine. Forward, a register of directions at once; backward, by all parameters and "
        "initial values, once with the whole run on the tape, once with the run made again from states that were kept."
    )
    return Result("gradients", "Derivatives of a run, in multiples of the run", lines, details, remark)


def _by(model: Model) -> list[str]:
    """All that acts: entries of p that c depends on, q_i and their rates."""
    columns = set(model.kernel("constants").jac_sparsity(0, 0).get_triplet()[1])
    acting = [parameter.name for k, parameter in enumerate(model.parameters) if k in columns]
    return [*acting, *model.q_i, *(f"{name}_dot" for name in model.q_i)]


def _scheme(
    model: Model, scheme: str, settings: dict, forward: float, backward: float
) -> tuple[list[Line], dict[str, float]]:
    by = _by(model)
    t_end = STEPS * settings["dt"]
    prepared = DifferentiableRun(
        model, ["rod.q1", "slider.x"], by, scheme=scheme, t_end=t_end, samples=1, wait=True, **settings
    )
    objective = End("rod.q1")
    one, other = (prepared.gradient(objective, prepared.x0, mode=mode).derivatives for mode in ("forward", "reverse"))
    difference = float(np.abs(one - other).max() / np.abs(one).max())
    timings = interleave(_contenders(prepared), ROUNDS)
    scalar, width = timings["scalar"], most_lanes()

    def times(name: str) -> float:
        return timings[name].best / scalar.best

    record, reverse = times("record"), times("reverse")
    lines = [
        _plain(f"{scheme}, a scalar run", scalar),
        Line(f"{scheme}, a direction forward", times("tangents") / width, "runs", forward, f"{width} at once"),
        Line(f"{scheme}, backward, run on the tape", record + reverse, "runs", backward, f"{len(by)} derivatives"),
        Line(
            f"{scheme}, backward, run again from kept states",
            1 + record + reverse,
            "runs",
            backward,
            "memory of sqrt(n) steps",
        ),
        Line(f"{scheme}, forward less backward, of the largest", difference, "", AGREEMENT),
    ]
    return lines, {
        "record": record,
        "reverse": reverse,
        "numbers on the tape a step": prepared._backward.stepping.records,
    }


def _contenders(prepared: DifferentiableRun) -> dict[str, Callable[[int], None]]:
    """The parts of a differentiated run on prepared arrays, each n times."""
    started, program = prepared._started(prepared.x0), prepared.program
    active = program.active
    plain = NativeProgram(program.step, wait=True)
    tangents = TangentCode(program.step, active, most_lanes(), wait=True)
    recorder = Recorder(program.step, active, wait=True)
    z, tape = started.z.copy(), np.zeros(STEPS * recorder.records + 1)
    adjoint, seed = np.zeros(active.size), np.random.default_rng(0).normal(size=active.size)
    arrays = LaneArrays(len(z) + len(active.z), len(started.ready) + len(active.c), most_lanes())
    arrays.c[: len(started.ready)] = started.ready[:, None]
    directions = Beginning(program).tangents(prepared._place, started.x, started.slopes)[:, -most_lanes() :]

    def scalar(n: int) -> None:
        for _ in range(n):
            z[:] = started.z
            plain.run(z, started.ready, STEPS)

    def record(n: int) -> None:
        for _ in range(n):
            z[:] = started.z
            recorder.record(z, started.ready, tape, STEPS)

    def reverse(n: int) -> None:
        for _ in range(n):
            adjoint[:] = seed
            recorder.reverse(adjoint, started.ready, tape, STEPS)

    def along(n: int) -> None:
        for _ in range(n):
            arrays.z[: len(z)] = started.z[:, None]
            arrays.z[len(z) :] = directions[: len(active.z)]
            tangents.run(arrays, STEPS)

    record(1)
    return {"scalar": scalar, "record": record, "reverse": reverse, "tangents": along}


def _plain(name: str, timing: Timing) -> Line:
    return Line(name, timing.best / STEPS * 1e9, "ns a step", None, f"median +{timing.spread:.0%}")
