"""The freely running flexible slider-crank against Exudyn (extra `benchmark`): CPU time at a given error."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline

from benchmarks.contenders.exudyn_models import SPEED, Cable, is_installed, version
from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.native_run import native_run
from benchmarks.harness.result import Line, Result, Skipped
from benchmarks.harness.timing import Timing, interleave
from runtime import simulate
from runtime.model import Model
from runtime.start.start_state import start_state
from symgen.scene import Scene, SceneRecord
from symgen.scenes.flexible_slider_crank import J1, L1, L2, M1, M3, RHO, WIDTH, E

T_END, PERIOD = 0.05, 1e-5  # s; a run is compared every PERIOD, or every step if that is longer
LATERAL, AXIAL = 3, 1
TOLERANCES = (1e-5, 1e-6)  # m, largest distance of the rod's middle from the reference at any time
REFERENCE, REFERENCE_STEPS, OWN_STEPS = Cable(32), 20_000, 40_000
CHECKS = ((Cable(16), 20_000), (Cable(32), 10_000), (Cable(4), 20_000))  # elements or steps halved, few elements
GOAL = 0.01
FEWEST, MOST, FINENESS, ROUNDS = 40, 16_000, 4, 7
CABLES = (
    Cable(4),
    Cable(4, sparse=True),
    Cable(4, newton_tolerance=1e-6),
    Cable(4, newton_tolerance=1e-5),
    Cable(6),
    Cable(6, sparse=True),
    Cable(6, rho_inf=0.9),
    Cable(6, modified_newton=False),
    Cable(8),
    Cable(8, sparse=True),
    Cable(8, sparse=True, newton_tolerance=1e-6),
    Cable(16, sparse=True),
)
SMALLEST = {
    "T_END": 0.002,
    "TOLERANCES": (1e-4,),
    "REFERENCE": Cable(8),
    "REFERENCE_STEPS": 400,
    "OWN_STEPS": 2_000,
    "CHECKS": ((Cable(4), 400), (Cable(8), 200), (Cable(4), 400)),
    "CABLES": (Cable(4),),
    "MOST": 800,
    "ROUNDS": 2,
}
REMARK = """\
Crank {l1} m, rod {l2} m, {width} m square, {speed:g} rad/s at crank angle 0, running freely for {t_end} s without
gravity or damping. The rod starts straight, stretched as the rotation stretches it: started unstretched, Exudyn's
results differed by up to 1.6e-05 m between steps and did not converge regularly. Graded is the position of the rod's
middle in the world, its largest distance from a reference of cable elements.

Exudyn {version}: geometrically exact cable elements, one thread, build without range checks, no output; only
`SolveDynamic` is timed. Its explicit solvers RK44 and VelocityVerlet refuse
the joints. This project: a chord frame with {lateral} pinned
lateral modes and {axial} axial mode, stiffening on; only the compiled steps are timed.

Steps are the fewest of a row of ratio 1.19 that meet the tolerance and meet it at the next two as well. Where four
elements meet 1e-05 m, the errors of mesh and step cancel. The lines `own motion` grade this project against its own
converged motion, and show the fastest on each side only."""

Path2D = Callable[[np.ndarray], np.ndarray]


@dataclass
class Entry:
    """A method: error in m of a run in so many steps, and what repeats such a run n times."""

    label: str
    middle: Callable[[int], tuple[np.ndarray, np.ndarray] | None]
    worker: Callable[[int], Callable[[int], None]]
    runs: dict[int, tuple[np.ndarray, np.ndarray] | None] = field(default_factory=dict)

    def error(self, steps: int, path: Path2D) -> float:
        """Largest distance from a path; infinite where the run failed."""
        if steps not in self.runs:
            self.runs[steps] = self.middle(steps)
        run = self.runs[steps]
        return np.inf if run is None else float(np.linalg.norm(run[1] - path(run[0]), axis=1).max())

    def fewest(self, tolerance: float, path: Path2D) -> int | None:
        """Steps that meet the tolerance, as the next two finer ones do."""
        steps = [round(FEWEST * 2 ** (k / FINENESS)) for k in range(20 * FINENESS)]
        for tried in zip(steps, steps[1:], steps[2:], strict=False):
            if tried[-1] > MOST:
                return None
            if all(self.error(n, path) <= tolerance for n in tried):
                return tried[0]
        return None


def run() -> Result:
    """Reference, search of the steps, timing. Raises Skipped without Exudyn."""
    if not is_installed():
        raise Skipped("exudyn is not installed; install the extra `benchmark`")
    exact = _spline(REFERENCE.middle(T_END, REFERENCE_STEPS, PERIOD))
    changes = [_off(cable.middle(T_END, steps, PERIOD), exact) for cable, steps in CHECKS]
    with workplace() as folder:
        model, set_up = _set_up(folder)
        initial = stretched(model)
        own, unstiffened = (
            _spline(_ours(one, initial, "rk4", None, OWN_STEPS))
            for one in (model, model_of(slider_crank(stiffening=False), folder))
        )
        times = np.arange(0.0, T_END, PERIOD)
        exudyn, ours = _cables(), _schemes(model, initial)
        lines = [
            Line("reference, change with half the elements", changes[0], "m"),
            Line("reference, change with half the steps", changes[1], "m"),
            Line("four elements less reference", changes[2], "m", note="both with small steps"),
            Line(
                "converged modal model less reference",
                _off((times, own(times)), exact),
                "m",
                note="both with small steps",
            ),
            Line(
                "the same without stiffening", _off((times, unstiffened(times)), exact), "m", note="linear modes alone"
            ),
        ]
        details: dict[str, Any] = {"version": version(), "runs": []}
        lines += _contest("", TOLERANCES[0], [(e, exact) for e in exudyn + ours], details, GOAL)
        for tolerance in TOLERANCES:
            lines += _contest(
                "own motion: ", tolerance, [(e, exact) for e in exudyn] + [(e, own) for e in ours], details
            )
    lines += set_up
    remark = REMARK.format(
        l1=L1, l2=L2, width=WIDTH, speed=SPEED, t_end=T_END, version=version(), lateral=LATERAL, axial=AXIAL
    )
    return Result("exudyn_slider_crank", "Flexible slider-crank, against Exudyn", lines, details, remark)


def _set_up(folder: Path) -> tuple[Model, list[Line]]:
    """The model, and what is not in the times of the contest."""
    started = time.perf_counter()
    model = model_of(slider_crank(), folder)
    native_run(model, "exponential", [1], T_END, 100, stretched(model), "given")
    here = time.perf_counter() - started
    cable, started = Cable(8), time.perf_counter()
    _ = cable.system
    there = time.perf_counter() - started
    settings = cable.settings(PERIOD, 1)
    one = min(cable.solve(settings) for _ in range(5))
    return model, [
        Line("set-up here: derive, emit, load, compile exponential m=1", here, "s", note="wall time, empty cache"),
        Line("set-up of Exudyn: 8 elements, assembled", there * 1e3, "ms", note="wall time"),
        Line("`SolveDynamic` of one step, 8 elements", one * 1e3, "ms"),
    ]


def slider_crank(stiffening: bool = True) -> SceneRecord:
    """The mechanism with a flexible rod, its middle measured."""
    builder = Scene("slider_crank_exudyn")
    builder.rigid(
        "crank",
        mass=M1,
        inertia=J1 - M1 * (L1 / 2) ** 2,
        center_of_mass=(L1 / 2, 0),
        markers={"tip": {"position": (L1, 0)}},
    )
    builder.beam(
        "rod",
        length=L2,
        density=RHO,
        area=WIDTH**2,
        second_moment=WIDTH**4 / 12,
        youngs_modulus=E,
        lateral={"ends": "pinned-pinned", "modes": LATERAL},
        axial={"ends": "fixed-free", "modes": AXIAL},
        stiffening=stiffening,
        markers={"middle": {"at": 0.5}},
    )
    builder.rigid("slider", mass=M3, inertia=1e-5)
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.start")
    builder.prismatic("slide", "ground.origin", "slider.origin").revolute("C", "rod.end", "slider.origin")
    builder.measure("x", "x", "rod.middle").measure("y", "y", "rod.middle")
    builder.independent("crank.theta", *(f"rod.q{k + 1}" for k in range(LATERAL + AXIAL)))
    builder.initial({"crank.theta": 0.0, "rod.theta": 0.0}).rates({"crank.theta": SPEED})
    return builder.simulation(t_end=T_END, dt=1e-5, m=[1], scheme="single_rate").build()


def stretched(model: Model) -> dict[str, float]:
    """Axial coordinates in elastic equilibrium; lateral ones and all elastic rates stay zero."""
    p = model.parameter_vector()
    state = start_state(model, p, model.constants(p), 0.0, None, "quasi_static")
    names = [f"rod.q{k + 1}" for k in range(LATERAL, LATERAL + AXIAL)]
    return {name: float(state.q[model.coordinates.index(name)]) for name in names}


def _spline(run: tuple[np.ndarray, np.ndarray] | None) -> Path2D:
    if run is None:
        raise RuntimeError("a reference run failed")
    return CubicSpline(*run)


def _off(run: tuple[np.ndarray, np.ndarray], path: Path2D) -> float:
    return float(np.linalg.norm(run[1] - path(run[0]), axis=1).max())


def _cables() -> list[Entry]:
    def worker(cable: Cable, steps: int) -> Callable[[int], None]:
        settings = cable.settings(T_END, steps)

        def work(n: int) -> None:
            for _ in range(n):
                cable.solve(settings)

        return work

    return [Entry(cable.label, partial(cable.middle, T_END, period=PERIOD), partial(worker, cable)) for cable in CABLES]


def _native(
    model: Model, name: str, m: list[int] | None, initial: dict[str, float], steps: int
) -> Callable[[int], None]:
    return native_run(model, name, m, T_END, steps, initial, "given")


def _schemes(model: Model, initial: dict[str, float]) -> list[Entry]:
    return [
        Entry(
            f"this project, {name}" + (f" m={m[0]}" if m else ""),
            partial(_ours, model, initial, name, m),
            partial(_native, model, name, m, initial),
        )
        for name, m in (
            ("single_rate", None),
            ("rk4", None),
            ("exponential", [1]),
            ("exponential", [2]),
            ("exponential", [4]),
        )
    ]


def _ours(
    model: Model, initial: dict[str, float], scheme: str, m: list[int] | None, steps: int
) -> tuple[np.ndarray, np.ndarray] | None:
    every = max(1, round(PERIOD * steps / T_END))
    solution = simulate(
        model,
        t_end=T_END,
        dt=T_END / steps,
        m=m,
        scheme=scheme,
        initial=initial,
        seen_every=every * T_END / steps,
        start="given",
        engine="compiled",
    )
    if solution.status.name != "completed":
        return None
    return solution.t, np.column_stack([solution["x"], solution["y"]])


def _contest(
    title: str,
    tolerance: float,
    entries: list[tuple[Entry, Path2D]],
    details: dict[str, Any],
    goal: float | None = None,
) -> list[Line]:
    """The fastest on each side and their ratio; with a goal, a line for every method."""
    title += f"{tolerance:g} m"
    steps = {
        entry.label: (n, entry.error(n, path))
        for entry, path in entries
        if (n := entry.fewest(tolerance, path)) is not None
    }
    timings = interleave({e.label: e.worker(steps[e.label][0]) for e, _ in entries if e.label in steps}, ROUNDS)
    theirs, mine = (_fastest(timings, side) for side in ("Exudyn", "this project"))
    lines = []
    for entry, _ in entries:
        label = entry.label
        n, error = steps.get(label, (0, np.inf))
        seconds = timings[label].best if n else np.nan
        details["runs"].append({"contest": title, "label": label, "steps": n, "error": error, "seconds": seconds})
        if goal is not None or label in (theirs, mine):
            note = f"dt {T_END / n * 1e6:.3g} us, {n} steps, error {error:.1e} m" if n else "not met"
            lines.append(Line(f"{title}: {label}", seconds * 1e3, "ms", note=note))
    if theirs and mine:
        share = timings[mine].best / timings[theirs].best
        lines.append(Line(f"{title}: this project / Exudyn", share, "", goal, f"{1 / share:.0f} times faster"))
    return lines


def _fastest(timings: dict[str, Timing], side: str) -> str | None:
    return min((label for label in timings if label.startswith(side)), key=lambda one: timings[one].best, default=None)
