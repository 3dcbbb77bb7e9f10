"""What an impact, and a change between sticking and sliding, costs a run, and in an ensemble."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from benchmarks.harness.result import Line, Result
from runtime.model import Model
from symgen.scene import Scene

SHORT, LONG, CASES, REPEATS = 20.0, 220.0, 200, 3  # s, s, cases of the ensemble, of which the best counts
SMALLEST = {"SHORT": 1.0, "LONG": 2.0, "CASES": 4, "REPEATS": 1}
DT = 1e-3


def ball() -> Model:
    """A ball that a shaken rail throws up again and again, onto a stop that gives back 0.9 of its speed."""
    scene = Scene("ball").rigid("ball", mass=1.0, inertia=0.1)
    limits = {"lower": 0.0, "restitution": 0.9}
    scene.prismatic("rail", "ground.origin", "ball.origin", limits=limits).initial({"ball.x": 0.05})
    scene.measure("height", "x", "ball.origin").force("weight", "ball.origin", "-9.81 + 9 * sin(7 * t)", 0.0)
    return scene.build().model()


def block() -> Model:
    """A block on a dry rail, pushed to and fro."""
    scene = Scene("block").rigid("block", mass=1.0, inertia=0.1)
    friction = {"coulomb": 2.0, "breakaway": 2.5, "stribeck_velocity": 0.01}
    scene.prismatic("rail", "ground.origin", "block.origin", friction=friction)
    return scene.force("push", "block.origin", "4 * sin(31.4159 * t)", 0.0).build().model()


def run() -> Result:
    """CPU time in one process: differences of two runs, divided by what happened in them; an ensemble over its runs."""
    lines = []
    for name, model, goal in (("an impact", ball(), 5.0), ("a change of mode", block(), 30.0)):
        short, long = (_best(partial(model.simulate, **_asked(t), error="off")) for t in (SHORT, LONG))
        count = len(long[1].events) - len(short[1].events)
        cost = 1e6 * (long[0] - short[0]) / max(1, count)
        lines.append(Line(name, cost, "us", goal, f"{count} more events in {LONG - SHORT:g} s more"))
    lines.append(Line("stick-slip cases of an ensemble over single runs", _ensemble(), "", 0.25, f"{CASES} cases"))
    remark = (
        "`rk4`, steps of 1 ms, CPU time in one process. The steps between events are in the figures, and what a run "
        "says of each event (time, speeds, impulse, energy)."
    )
    return Result("events", "Impacts and changes of mode", lines, {}, remark)


def _asked(t_end: float) -> dict[str, Any]:
    return {"scheme": "rk4", "dt": DT, "t_end": t_end, "seen_every": t_end / 200}


def _ensemble() -> float:
    """Time of an ensemble over that of as many runs."""
    model, masses = block(), np.linspace(0.9, 1.1, CASES)
    asked = _asked(SHORT / 5)

    def alone() -> None:
        for mass in masses:
            model.simulate(parameters={"block.mass": float(mass)}, error="off", **asked)

    def together() -> None:
        model.ensemble({"block.mass": masses}, outputs=["block.x"], **asked)

    return float(_best(together)[0] / _best(alone)[0])


def _best(call: Callable[[], Any]) -> tuple[float, Any]:
    """(CPU seconds, result) of the best of some calls, behind one that compiles."""
    found = call()
    best = np.inf
    for _ in range(REPEATS):
        began = time.process_time()
        found = call()
        best = min(best, time.process_time() - began)
    return best, found
