"""Jumps of loads in time: each scheme's time to 1e-3 on cases of the hard suite, and what a jump costs a run."""

from __future__ import annotations

import sys
import time
from typing import Any

from benchmarks.cases.hard_steps import MOST, TOLERANCE, reference_of
from benchmarks.harness.fewest import Timed, fewest
from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from benchmarks.scenes.hard_suite import HARD_SUITE
from runtime import simulate
from runtime.model import Model
from runtime.running.method_choice import Method
from runtime.studies.advice.reference import Reference
from symgen.scene import Scene, SceneRecord

NAMES = ("slider_crank_torque", "f2_heavy_hub", "f2_light_hub")
METHODS = (
    Method("exponential_rk4"),
    Method("exponential_adams"),
    Method("exponential", (1,)),
    Method("exponential", (2,)),
    Method("exponential", (1,), {"order": 5}),
    Method("radau", None, {"eps": (1e-6,)}),
    Method("dop853"),
    Method("rk4"),
    Method("coupled", (4,)),
    Method("single_rate"),
)
# before steps ended at jumps, at revision 90b52f6~1 on the machine of the published table [ms]
BEFORE = {
    "slider_crank_torque": {
        "exponential_rk4": 14.0,
        "exponential m=1": 4.23,
        "exponential m=2": 0.720,
        "radau eps=1e-06": 9.20,
        "dop853": 23.3,
        "rk4": 8.99,
        "coupled m=4": 11.5,
        "single_rate": 14.2,
    },
    "f2_heavy_hub": {
        "exponential_rk4": 0.0919,
        "exponential m=1": 0.0449,
        "exponential m=2": 0.0624,
        "radau eps=1e-06": 0.0843,
        "dop853": 0.0433,
        "rk4": 0.0688,
        "coupled m=4": 0.184,
        "single_rate": 0.182,
    },
    "f2_light_hub": {
        "exponential_rk4": 0.235,
        "exponential m=1": 0.113,
        "exponential m=2": 0.142,
        "radau eps=1e-06": 0.245,
        "dop853": 0.126,
        "rk4": 0.147,
        "coupled m=4": 0.535,
        "single_rate": 0.524,
    },
}
WAVE, JUMPS = 628.3, 1000  # rad/s, and how often it changes its sign in T_END
T_END, DT, REPEATS = 5.0, 2e-3, 3
RUNS = {"rk4": None, "exponential": [1], "exponential_rk4": None, "exponential_adams": None, "single_rate": None}
SMALLEST = {
    "NAMES": ("f2_heavy_hub",),
    "METHODS": (Method("dop853"),),
    "RUNS": {"rk4": None},
    "T_END": 0.1,
    "JUMPS": 20,
    "REPEATS": 1,
}
REMARK = """\
CPU time of the loop of a run over the whole motion, at the fewest steps that bring every graded coordinate below 1e-3
of its RMS amplitude; where a jump splits it, what Python does there is in it (some 20 us a jump). The goal is half of
the best time of any scheme before steps ended at jumps, measured on one machine in one hour. A jump: one `simulate` of
the hub with a beam under a square wave of 1,000 switching times in 2,500 steps, less one under a sine; the least of
three each, with everything a run does."""


def run() -> Result:
    """The cases, then the square wave."""
    lines: list[Line] = []
    with workplace() as folder:
        for name in NAMES:
            print(f"  {name} ...", file=sys.stderr, flush=True)
            hard = HARD_SUITE[name]
            lines += _times(name, reference_of(hard, model_of(hard.make(), folder)))
        waves = [model_of(hub_under(name, load), folder) for name, load in LOADS.items()]
    for scheme, m in RUNS.items():
        with_jumps, without = (_seconds(model, scheme, m) for model in waves)
        lines.append(Line(f"square wave: a jump, {scheme}", (with_jumps - without) / JUMPS * 1e6, "us"))
    return Result("jumps", "Jumps of loads in time", lines, {}, REMARK)


def _times(name: str, reference: Reference) -> list[Line]:
    found = {}
    for method in METHODS:
        best = fewest(Timed(method, reference), TOLERANCE, most=MOST)
        if best is not None:
            found[method.label] = best
    before = BEFORE[name]
    least = min(found.values(), key=lambda one: one.seconds)
    lines = [Line(f"{name}: the best", least.seconds * 1e3, "ms", min(before.values()) / 2, least.label)]
    for label, one in found.items():
        note = f"{one.steps} steps" + (f"; before {before[label]:.3g} ms" if label in before else "")
        lines.append(Line(f"{name}: {label}", one.seconds * 1e3, "ms", note=note))
    return lines


LOADS = {"hub_square": "where(sin(w * t) > 0, torque, 0)", "hub_sine": "torque * sin(w * t)"}


def hub_under(name: str, load: str) -> SceneRecord:
    """The hub with a beam of the hard suite under another torque."""
    section: dict[str, Any] = {"area": 7.2968e-5, "second_moment": 8.2189e-9, "youngs_modulus": 6.8952e10}
    shapes = {"ends": "clamped-free", "modes": 3}
    builder = Scene(name).parameter("torque", 10.0, "N m").parameter("w", WAVE, "rad/s")
    builder.rigid("hub", mass=1.0, inertia=10.0)
    builder.beam("beam", length=8.0, density=2766.7, lateral=shapes, stiffening=True, **section)
    builder.revolute("pivot", "ground.origin", "hub.origin").weld("clamp", "hub.origin", "beam.start")
    return builder.torque("motor", "hub.origin", load).simulation(t_end=T_END, dt=DT, scheme="rk4").build()


def _seconds(model: Model, scheme: str, m: list[int] | None) -> float:
    """Of one run, whatever was compiled before [s]."""
    least = float("inf")
    for _ in range(REPEATS + 1):
        began = time.process_time()
        simulate(model, scheme=scheme, m=m, seen_every=10 * model.simulation["dt"])
        least = min(least, time.process_time() - began)
    return least
