"""Cases of the IFToMM benchmark library: the least CPU time that reaches a coarse and a fine error."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from benchmarks.harness.timing import interleave
from runtime import Solution, Status
from runtime.model import Model
from runtime.running.method_choice import Method
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import Stepper
from runtime.solutions.observe import observe_samples
from runtime.start.start_state import start_state
from symgen.scene import SceneRecord
from symgen.scenes.linkages import n_four_bar
from symgen.scenes.spatial import bricard, flyball_governor, heavy_top

FINE, COARSE = 1e-6, 1e-3  # m
SAME_MOTION = 0.1  # m, where the coarse threshold is one of energy
GOALS = ("coarse", "fine")
IN_A_ROW = 3  # neighbouring numbers of steps that must be accurate enough
RATIO, MOST = 1.19, 100_000  # of neighbouring numbers of steps tried; most steps
HOPELESS = 5.0  # times the CPU time of the fastest method so far: a method that is slower still is given up
SAMPLES, REPEATS, ROUNDS = 1000, 3, 30
METHODS = (
    Method("rk4"),
    Method("dop853"),
    Method("single_rate"),
    Method("radau", None, {"eps": (1e-6,)}),
    Method("radau"),
    Method("exponential", (1,)),
    Method("exponential", (2,)),
)
REMARK = """\
Each row is the fastest of
{methods}, compiled,
with the fewest steps of a row of ratio {ratio} that reach the error and reach it at the next two as well. CPU time is
that of the steps of the whole run, without derivation and compilation. Evaluations are those of M_hat and Q_hat.

- A02, two windows, 10 s, ten singular positions: the coarse error is the library's, the total energy's within 0.1 J;
  so that it is the same motion, the first upright's tip is within 0.1 m at 1, 2 and 10 s too. The fine error is that
  of this tip [m].
- A04, 1 s: position of P3 at 0.5 and 1 s [m].
- A05, 10 s: position of the slider at 0.1, 0.5, 1 and 10 s [m].
- Heavy top, Euler angles xzy, 1 s: position of its centre of mass at 0.2 and 1 s [m].

Where the library's own threshold is not energy, coarse means 1e-3. All mechanisms are about 1 m large, so these errors
are relative too."""


@dataclass(frozen=True)
class Case:
    """A scene with reference positions at times; steps come in multiples of `steps`, so that they meet these times."""

    name: str
    make: Callable[[], SceneRecord]
    t_end: float
    steps: int
    positions: Callable[[Solution], np.ndarray]
    exact: dict[float, tuple[float, ...]]
    energy: float | None = None  # J, the coarse threshold, where it is not a position's

    def position_error(self, run: Solution) -> float:
        """Largest distance from the reference [m]."""
        found = self.positions(run)
        rows = [int(np.argmin(np.abs(run.t - t))) for t in self.exact]
        return float(np.linalg.norm(found[rows] - np.array(list(self.exact.values())), axis=1).max())

    def errors(self, run: Solution) -> tuple[float, float]:
        """(coarse, fine) error over its threshold; infinite where the run failed."""
        if not np.isfinite(run.q).all() or abs(run.t[-1] - self.t_end) > 1e-6:
            return np.inf, np.inf
        off = self.position_error(run)
        drift = float(np.abs(run.total_energy - run.total_energy[0]).max())
        coarse = off / COARSE if self.energy is None else max(drift / self.energy, off / SAME_MOTION)
        return coarse, off / FINE

    def threshold(self, goal: str) -> tuple[float, str]:
        """The error allowed, with its unit."""
        if goal == "fine":
            return FINE, "m"
        return (COARSE, "m") if self.energy is None else (self.energy, "J")


def _columns(*names: str) -> Callable[[Solution], np.ndarray]:
    return lambda run: np.column_stack([run[name] for name in names])


def _upright(run: Solution) -> np.ndarray:
    angle = run["upright0.theta"]
    return np.column_stack([np.cos(angle), np.sin(angle)])


CASES = (
    Case(
        "A02 N-four-bar",
        n_four_bar,
        10.0,
        10,
        _upright,
        {
            1.0: (-0.19502030194944, -0.98079920566217),
            2.0: (0.057815795768011, 0.99832726786346),
            10.0: (0.32845811154082, 0.9445185381786),
        },
        0.1,
    ),
    Case(
        "A04 Bricard",
        bricard,
        1.0,
        2,
        _columns("P3_x", "P3_y", "P3_z"),
        {
            0.5: (0.9682836791067775, -1.2246251594363333, 0.7501466094377676),
            1.0: (0.5105014611872206, -1.649167599394806, 0.1401231145532866),
        },
    ),
    Case(
        "A05 flyball governor",
        flyball_governor,
        10.0,
        100,
        _columns("height.travel"),
        {0.1: (0.52383647556958,), 0.5: (0.74324942478637,), 1.0: (0.50142092237955,), 10.0: (0.61962291706135,)},
    ),
    Case(
        "heavy top",
        lambda: heavy_top("xzy"),
        1.0,
        5,
        _columns("top.x", "top.y", "top.z"),
        {0.2: (0.60555056138, 0.59895768179, -0.52398302743), 1.0: (0.17334396410, 0.64008859207, -0.74849079113)},
    ),
)


SMALLEST = {"CASES": CASES[1:2], "METHODS": METHODS[:1], "REPEATS": 1, "ROUNDS": 2}


@dataclass(frozen=True)
class Found:
    """A run that is accurate enough: its steps, evaluations and error over the threshold."""

    runs: Runs
    steps: int
    evaluations: int
    error: float


class Runs:
    """A method on a case, compiled once for all steps."""

    def __init__(self, case: Case, model: Model, spec: Method) -> None:
        self.case, self.model, self.spec = case, model, spec
        self._stepper = Stepper(self._scheme(1.0), "compiled", wait=True)
        self._p = model.parameter_vector()
        self._c = model.constants(self._p)
        self._state = start_state(model, self._p, self._c, 0.0, None, None)

    def worker(self, steps: int) -> Callable[[int], None]:
        """What repeats the run n times."""
        first, ready = self._started(steps)
        z = first.copy()

        def work(n: int) -> None:
            for _ in range(n):
                z[:] = first
                self._stepper.run(z, ready, steps)

        return work

    def solution(self, steps: int) -> tuple[Solution, int]:
        """(the run at samples that hold the reference times, evaluations)."""
        z, ready = self._started(steps)
        part = steps // self.case.steps
        every = next(k for k in range(max(1, steps // SAMPLES), 0, -1) if part % k == 0)
        samples = [self._stepper.state(z).copy()]
        for _ in range(steps // every):
            self._stepper.run(z, ready, every)
            if not np.isfinite(z).all():
                break
            samples.append(self._stepper.state(z).copy())
        scheme = self._scheme(self.case.t_end / steps)
        iterations = int(samples[-1][scheme.layout.slice("iterations")][0])
        full, partial = scheme.evaluations()
        found = observe_samples(
            self.model,
            scheme,
            np.array(samples),
            self._p,
            self._c,
            self.spec.scheme,
            {},
            Status("completed", self.case.t_end),
        )
        return found, (iterations or steps * full) + steps * partial

    def _scheme(self, dt: float) -> Scheme:
        ratios = list(self.spec.m) if self.spec.m else None
        return scheme_kind(self.spec.scheme).build(self.spec.scheme, self.model, dt, ratios, self.spec.options)

    def _started(self, steps: int) -> tuple[np.ndarray, np.ndarray]:
        dt = self.case.t_end / steps
        return (
            self._stepper.start(0.0, self._state.q, self._state.q_dot, self._c, dt),
            self._stepper.ready(self._c, dt),
        )


def fewest(runs: Runs, bounds: list[float]) -> tuple[list[Found | None], list[float]]:
    """(the fewest steps for the coarse and the fine error, their seconds); given up beyond `bounds` [s]."""
    case = runs.case
    steps = sorted({case.steps * round(RATIO**k) for k in range(60)})
    found: list[Found | None] = [None, None]
    seconds = [np.inf, np.inf]
    passed: list[list[Found]] = [[], []]
    for n in (n for n in steps if n <= MOST):
        solution, evaluations = runs.solution(n)
        spent = _seconds(runs.worker(n))
        for k, error in enumerate(case.errors(solution)):
            passed[k] = [*passed[k], Found(runs, n, evaluations, error)] if error <= 1 else []
            if len(passed[k]) == IN_A_ROW and found[k] is None:
                found[k] = passed[k][0]
                seconds[k] = spent * passed[k][0].steps / n
        if all(one or spent > HOPELESS * bound for one, bound in zip(found, bounds, strict=True)):
            break
    return found, seconds


def _seconds(work: Callable[[int], None]) -> float:
    spent = []
    for _ in range(REPEATS):
        started = time.thread_time()
        work(1)
        spent.append(time.thread_time() - started)
    return min(spent)


def run() -> Result:
    """Search the steps of every method on every case, then time the fastest ones against each other."""
    lines: list[Line] = []
    details: dict = {}
    with workplace() as folder:
        for case in CASES:
            case_lines, details[case.name] = _case(case, model_of(case.make(), folder))
            lines += case_lines
    remark = REMARK.format(methods=", ".join(spec.label for spec in METHODS), ratio=RATIO)
    return Result("iftomm", "Cases of the IFToMM benchmark library", lines, details, remark)


def _case(case: Case, model: Model) -> tuple[list[Line], list]:
    best: list[Found | None] = [None, None]
    bounds, details = [np.inf, np.inf], []
    for spec in METHODS:
        found, seconds = fewest(Runs(case, model, spec), bounds)
        for k, one in enumerate(found):
            details.append(
                {"method": spec.label, "goal": GOALS[k], "steps": one.steps if one else None, "seconds": seconds[k]}
            )
            if one and seconds[k] < bounds[k]:
                best[k], bounds[k] = one, seconds[k]
    lines: list[Line] = []
    for goal, one in zip(GOALS, best, strict=True):
        if one is None:
            lines.append(Line(f"{case.name}, {goal}", np.nan, "ms", note="no method got there"))
            continue
        timing = interleave({"run": one.runs.worker(one.steps)}, ROUNDS)["run"]
        allowed, unit = case.threshold(goal)
        lines.append(
            Line(
                f"{case.name}, {goal}",
                timing.best * 1e3,
                "ms",
                note=(
                    f"{one.runs.spec.label}, {one.steps} steps of {case.t_end / one.steps:.3g} s, {one.evaluations} "
                    f"evaluations, error {one.error * allowed:.1e} {unit}"
                ),
            )
        )
    return lines, details
