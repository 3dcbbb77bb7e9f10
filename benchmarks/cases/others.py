"""Other programs on the arms and the hard suite, each at an error of 1e-3: SUNDIALS, Exudyn, Pinocchio."""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable
from functools import partial
from math import sin

import casadi as ca
import numpy as np

from benchmarks.cases.hard_steps import STIFF, TOLERANCE, best_of, problem_of
from benchmarks.cases.rhs_pinocchio import planar_chain
from benchmarks.contenders.explicit_stepper import ExplicitStepper
from benchmarks.contenders.exudyn_arm import ExudynArm
from benchmarks.contenders.exudyn_models import is_installed, version
from benchmarks.contenders.pinocchio_tree import PinocchioTree, library
from benchmarks.contenders.pinocchio_tree import version as pinocchio_version
from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result, Skipped
from benchmarks.harness.timing import interleave
from runtime.contract.coordinates import followed
from runtime.contract.model import Model
from runtime.schemes.stage_equations import StageEquations
from runtime.studies.work_precision.methods import ADAPTIVE
from runtime.studies.work_precision.prepared_method import Spec
from runtime.studies.work_precision.problem import Problem
from symgen.scenes.hard_suite import HARD_SUITE

FIVE = {"order": 5}
OURS = [Spec(STIFF), *(Spec("exponential", (m,), options) for options in ({}, FIVE) for m in (1, 2)), Spec("dop853")]
SUNDIALS = ("CVODES BDF", "IDAS")
MOST_STEPS = 50_000  # of theirs between two samples
LADDER = tuple(10.0 ** (-k / 2) for k in range(6, 15))  # rtol, half a decade apart
CASES = (
    "f1_smooth",
    "slider_crank_free",
    "f2_heavy_hub",
    "f3_spin_up",
    "four_bar",
    "overdamped",
    "oscillators_1000",
    "near_singular",
    "stiff_200",
    "joint_arm",
    "governor",
    "spatial_chain",
    "arm_10",
)
LONG_ARM, SAMPLES, EXUDYN_SAMPLES = "arm_20", 100, 50
EXUDYN = (
    (2, 0.9, False, 1e-5),
    (2, 0.9, True, 1e-5),
    (2, 0.9, True, 1e-4),
    (4, 0.9, True, 1e-5),
    (2, None, True, 1e-5),
)
EXUDYN_FINEST = 6_400
RIGID, RIGID_TOLERANCE, RIGID_END = 10, 1e-6, 1.0
REMARK = """\
Every contender at its least time that meets 1e-3 (RMS over the motion of the worst graded coordinate, over its own RMS
amplitude), CPU time. CVODES and IDAS run through CasADi with compiled right-hand side and exact Jacobian, at the first
of tolerances half a decade apart that is enough; ours are compiled steps of one length. A ratio is their time over that
of the fastest of ours. Exudyn {exudyn} ({arm} links, ANCF cable elements for the last one, generalized-alpha or the
trapezoidal rule, one thread) and ours are each graded by their own converged motion, in the angles of the rigid links;
of floating-frame bodies Exudyn has spatial ones from solid meshes only. Rigid arm: Dormand and Prince's steps of order
8 to {rigid:g} in every angle at {end:g} s, the same loop around our equations and around those of Pinocchio
{pinocchio} (`aba` as CasADi code); `aba calls alone` is its compiled C++ for as many evaluations, without the sums of
the method."""


def run() -> Result:
    """All three. Raises Skipped where Exudyn or Pinocchio is missing."""
    if not is_installed():
        raise Skipped("exudyn is not installed; install the extra `benchmark`")
    theirs = library()
    lines: list[Line] = []
    with workplace() as folder:
        for name in CASES:
            print(f"  {name} ...", file=sys.stderr, flush=True)
            lines += against_sundials(name, model_of(HARD_SUITE[name].make(), folder))
        lines += against_exudyn(model_of(HARD_SUITE[LONG_ARM].make(), folder))
        lines += against_pinocchio(model_of(planar_chain().scene, folder), theirs)
    remark = REMARK.format(
        exudyn=version(),
        arm=20,
        rigid=RIGID_TOLERANCE,
        end=RIGID_END,
        pinocchio=pinocchio_version(),
    )
    return Result("others", "Against other programs, in one run", lines, {}, remark)


def against_sundials(name: str, model: Model) -> list[Line]:
    """One case of the hard suite."""
    problem = problem_of(HARD_SUITE[name], model)
    found = best_of([spec for spec in OURS if spec.scheme != STIFF or model.has("deflections")], problem)
    best = min(found.values(), key=lambda trial: trial.seconds)
    told = f"{best.label}, {best.steps} steps, error {best.error:.1e}"
    lines = [Line(f"{name}: this project", best.seconds * 1e3, "ms", note=told)]
    for label in SUNDIALS:
        seconds, note = _to_tolerance(label, problem)
        lines.append(Line(f"{name}: {label} / this project", seconds / best.seconds, "", note=note))
    return lines


def _to_tolerance(label: str, problem: Problem) -> tuple[float, str]:
    """(CPU seconds, what is to be said) at the loosest tolerance of the ladder that is enough; NaN where none is."""
    times, columns = np.linspace(0.0, problem.t_end, SAMPLES + 1), followed(problem.model)[1]
    why = ""
    for rtol in LADDER:
        done = problem.solved(partial(ADAPTIVE[label], most_steps=MOST_STEPS), times, rtol)
        if not done.status.ok or len(done.t) != len(times):
            why = done.status.cause or "failed"
            continue
        error = float(problem.errors(times, done.q[:, columns])[0].max())
        if error <= TOLERANCE:
            seconds, steps = float(done.stats["cpu_seconds"]), done.stats["steps"]
            return seconds, f"{seconds * 1e3:.3g} ms, rtol {rtol:.0e}, {steps} steps, error {error:.1e}"
    return np.nan, why or "not met"


def against_exudyn(model: Model) -> list[Line]:
    """The arm of 20 links."""
    case = HARD_SUITE[LONG_ARM]
    best = best_of([Spec(STIFF)], problem_of(case, model))[STIFF]
    lines = [Line(f"{LONG_ARM}: this project", best.seconds * 1e3, "ms", note=f"{STIFF}, {best.steps} steps")]
    angles = tuple(-1.2 + 0.5 * sin(k) for k in range(1, 21))
    for elements, rho_inf, sparse, newton in EXUDYN:
        arm = ExudynArm(angles, 100.0, elements, rho_inf, sparse, newton)
        exact = ExudynArm(angles, 100.0, elements, 0.9).run(case.t_end, EXUDYN_FINEST, EXUDYN_SAMPLES)[1]
        steps, seconds, error = _fewest(partial(arm.run, case.t_end), exact)
        note = f"{seconds * 1e3:.3g} ms, {steps} steps, error {error:.1e}"
        lines.append(Line(f"{LONG_ARM}: {arm.label} / this project", seconds / best.seconds, "", note=note))
    return lines


def _fewest(run: Callable[[int, int], tuple[float, np.ndarray]], exact: np.ndarray) -> tuple[int, float, float]:
    """(steps, CPU seconds, error) of the fewest steps, by factors of 2, that are near the finest run."""
    amplitudes = np.sqrt(np.mean((exact - exact.mean(axis=0)) ** 2, axis=0))
    steps = EXUDYN_SAMPLES
    while steps < EXUDYN_FINEST:
        try:
            off = run(steps, EXUDYN_SAMPLES)[1] - exact
        except RuntimeError:
            steps *= 2
            continue
        error = float((np.sqrt(np.mean(off**2, axis=0)) / amplitudes).max())
        if error <= TOLERANCE:
            return steps, min(run(steps, 0)[0] for _ in range(5)), error
        steps *= 2
    return steps, np.nan, np.nan


def against_pinocchio(model: Model, theirs: ctypes.CDLL) -> list[Line]:
    """The rigid chain of ten links, thrown from a bend, by the same explicit steps."""
    case, c = planar_chain(), model.constants(model.parameter_vector())
    n = len(case.hinges)
    tree = PinocchioTree(theirs, case.hinges, case.gravity)
    with workplace() as folder:
        aba = tree.expression(folder)

    def ours(q: ca.SX, v: ca.SX, given: ca.SX) -> ca.SX:
        equations = StageEquations(model, given)
        return equations.tree_accelerations(equations.close(q, ca.SX(0, 1), ca.SX(0), 1), v)

    angles, rest = np.array([-1.2 + 0.5 * sin(k) for k in range(1, n + 1)]), np.zeros(n)
    steppers = {
        "this project": (ExplicitStepper(n, c, ours), angles, np.eye(n)),
        "Pinocchio, CasADi code": (
            ExplicitStepper(n, np.zeros(0), lambda q, v, given: aba(q, v)),
            case.relative @ angles,
            np.linalg.inv(case.relative),
        ),
    }
    exact = steppers["this project"][0].runner(angles, rest, RIGID_END, 20_000)().copy()
    steps, workers = {}, {}
    for name, (stepper, start, back) in steppers.items():
        steps[name] = next(
            count
            for count in (round(20 * 2 ** (k / 4)) for k in range(60))
            if np.abs(back @ stepper.runner(start, rest, RIGID_END, count)() - exact).max() <= RIGID_TOLERANCE
        )
        runner = stepper.runner(start, rest, RIGID_END, steps[name])
        workers[name] = partial(_repeated, runner)
    state = np.concatenate([case.relative @ angles, rest, rest])
    calls = 12 * steps["Pinocchio, CasADi code"]
    aba_calls = tree.worker(state)
    workers["Pinocchio, aba calls alone"] = lambda repeats: aba_calls(calls * repeats)
    timings = interleave(workers, 20)
    own = timings["this project"].best
    lines = [Line("rigid arm: this project", own * 1e3, "ms", note=f"{steps['this project']} steps of dop853")]
    for name in list(timings)[1:]:
        note = f"{timings[name].best * 1e3:.3g} ms, {steps.get(name, calls)} {'steps' if name in steps else 'calls'}"
        lines.append(Line(f"rigid arm: {name} / this project", timings[name].best / own, "", note=note))
    return lines


def _repeated(run: Callable[[], np.ndarray], times: int) -> None:
    for _ in range(times):
        run()
