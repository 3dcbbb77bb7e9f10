"""Other programs on the arms and the hard suite, each at an error of 1e-3: SUNDIALS, Exudyn, Pinocchio."""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from math import inf, isfinite, nan, sin
from typing import Any

import casadi as ca
import numpy as np

from benchmarks.cases.hard_steps import DENSE, TOLERANCE, best_of, reference_of
from benchmarks.cases.rhs_pinocchio import planar_chain
from benchmarks.contenders.explicit_stepper import ExplicitStepper
from benchmarks.contenders.exudyn_arm import ExudynArm
from benchmarks.contenders.exudyn_floating_arm import FloatingArm
from benchmarks.contenders.exudyn_models import is_installed, version
from benchmarks.contenders.pinocchio_tree import PinocchioTree, library
from benchmarks.contenders.pinocchio_tree import version as pinocchio_version
from benchmarks.contenders.sundials_runs import SundialsRuns
from benchmarks.harness.matched import Attempt, Matched, match
from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result, Skipped
from benchmarks.harness.timing import interleave
from benchmarks.scenes.hard_suite import CASES, HARD_SUITE, HardCase
from runtime import SymgenError
from runtime.contract.coordinates import followed
from runtime.model import Model
from runtime.running.method_choice import Method
from runtime.schemes.stage_equations import StageEquations
from runtime.studies.advice.methods import stiff_methods
from runtime.studies.advice.reference import Reference
from runtime.studies.advice.trial import Trial

SHORTER = {"oscillators_10000": 1.0, "arm_40": 0.25}  # s of motion, where all of it takes SUNDIALS many seconds
LONG_ARM, EXUDYN_SAMPLES = "arm_20", 50
PATIENCE = 2.0  # s: a run that is longer than this and not exact enough is the last of its kind
ANCF = ((2, 0.9, True, 1e-5), (2, 0.9, False, 1e-5), (4, 0.9, True, 1e-5), (2, None, True, 1e-5))
FLOATING = ((3, 0.9, True, 1e-5), (3, 0.9, False, 1e-5), (3, None, True, 1e-5))
CABLE, FRAME = "Exudyn, cable elements", "Exudyn, floating frame"
STEPS = tuple(EXUDYN_SAMPLES * 2.0**k for k in range(7))
EXUDYN_FINEST, EXUDYN_REPEATED, EXUDYN_REPEATS = 6_400, 0.2, 3
RIGID, RIGID_TOLERANCE, RIGID_END = (10, 20), 1e-6, 1.0
SMALLEST = {"CASES": (replace(HARD_SUITE["overdamped"], t_end=0.1),), "RIGID": (2,), "RIGID_END": 0.1}
REMARK = """\
CPU time for each second of motion at an error of 1e-3 (RMS over the motion of the worst graded coordinate, over its own
RMS amplitude; the reference of a case is made once and judges both sides). A ratio is their time over that of the
fastest of ours, whose steps have one length and are the fewest that are enough. Theirs lies between two runs, by
powers of the error; both are told. A dash: the error was not met, or the program refused, with what it said.

CVODES and IDAS run through CasADi and call native code of our right-hand side (CVODES: accelerations; IDAS: a and
M_hat a - Q_hat) and of its exact Jacobian; nothing is interpreted. They have the best of BDF, BDF of order 2 at most
and (CVODES) Adams, each with an absolute tolerance of the relative one times the smallest or ("coarse atol") the
largest graded amplitude. `equations`: the share of evaluating right-hand side and Jacobian in their time; the rest is
the work of SUNDIALS and what CasADi puts around it. `alone`: the ratio if there were nothing else.

Exudyn {exudyn}, arm of 20 links, one thread: the last link of ANCF cable elements, graded by its own converged motion,
or in a floating frame (`ObjectFFRFreducedOrder`) with the three beam modes of ours, graded by our reference: these are
the same equations. Rigid arms: Dormand and Prince's steps of order 8 to {rigid:g} in every angle at {end:g} s, the same
loop around our equations and around those of Pinocchio {pinocchio} (`aba` as CasADi code, compiled alike); `aba calls
alone` is its compiled C++ for as many evaluations, without the sums of the method."""


def run() -> Result:
    """All of them. Raises Skipped where Exudyn or Pinocchio is missing."""
    if not is_installed():
        raise Skipped("exudyn is not installed; install the extra `benchmark`")
    given = {"exudyn": version(), "rigid": RIGID_TOLERANCE, "end": RIGID_END, "pinocchio": pinocchio_version()}
    lines: list[Line] = []
    details: dict[str, Any] = {"suite": {}, "rigid": {}}
    with workplace() as folder:
        for hard in CASES:
            print(f"  {hard.name} ...", file=sys.stderr, flush=True)
            case = replace(hard, t_end=SHORTER.get(hard.name, hard.t_end))
            reference = reference_of(case, model_of(case.make(), folder))
            best = ours(case, reference)
            details["suite"][case.name], found = against_sundials(case.name, reference, best)
            lines += found
            if case.name == LONG_ARM:
                details["exudyn"], found = against_exudyn(reference, best)
                lines += found
    theirs = library()
    with workplace() as folder:
        for links in RIGID:
            chain = model_of(planar_chain(links).scene, folder)
            details["rigid"][str(links)], found = against_pinocchio(links, chain, theirs)
            lines += found
    return Result("others", "Against other programs, in one run", lines, details, REMARK.format(**given))


def ours(case: HardCase, reference: Reference) -> Trial:
    """The fastest of the likeliest schemes."""
    model = reference.problem.model
    methods = stiff_methods(model)
    if len(model.q_i) <= DENSE and model.has("residual_jacobian"):
        orders = ({},) if case.large else ({}, {"order": 5})
        methods += [
            Method("exponential", (m,), options) for options in orders for m in ((1,) if case.large else (1, 2))
        ]
    found = best_of([*methods, Method("dop853"), Method("rk4")], reference)
    return min(found.values(), key=lambda trial: trial.seconds)


def against_sundials(name: str, reference: Reference, best: Trial) -> tuple[dict[str, Any], list[Line]]:
    """Figures of one case of the hard suite: ours, and of each integrator its ratio, and that if it were alone."""
    t_end = reference.problem.t_end
    told = f"{best.label}, {best.error:.1e} in {best.steps} steps, {t_end:g} s of motion"
    lines = [Line(f"{name}: this project", best.seconds / t_end * 1e3, "ms/s", note=told)]
    figures: dict[str, Any] = {"label": best.label, "steps": best.steps, "ms_a_second": best.seconds / t_end * 1e3}
    for method in ("cvodes", "idas"):
        figures[method] = nan, nan
        try:
            way, found = SundialsRuns(method, reference).best(TOLERANCE, PATIENCE)
        except SymgenError as refused:
            lines.append(Line(f"{name}: {method.upper()} / this project", nan, "", note=str(refused)))
            continue
        ratio = found.seconds / best.seconds if found.met else nan
        share = _share(found)
        figures[method] = ratio, share * ratio
        words = f"{way}: {found.told(t_end)}"
        if isfinite(share):
            words += f"; equations {share:.0%}, alone {share * found.seconds / best.seconds:.3g}"
        lines.append(Line(f"{name}: {method.upper()} / this project", ratio, "", note=words))
    return figures, lines


def _share(found: Matched) -> float:
    """Of the equations in the time of a run; nan where it is not known."""
    return found.fine.own / found.fine.seconds if found.fine is not None and isfinite(found.fine.own) else nan


def against_exudyn(reference: Reference, best: Trial) -> tuple[dict[str, Any], list[Line]]:
    """The arm of 20 links: ours, and (label, ratio, what is told) of each model by its kind."""
    angles = tuple(-1.2 + 0.5 * sin(k) for k in range(1, 21))
    places = [followed(reference.problem.model)[0].index(f"link{k}.theta") for k in range(1, 20)]
    problem = reference.problem
    motion = reference.path(np.linspace(0.0, problem.t_end, EXUDYN_SAMPLES + 1))[:, places]
    finest = {
        elements: ExudynArm(angles, 100.0, elements, 0.9).run(problem.t_end, EXUDYN_FINEST, EXUDYN_SAMPLES)[1]
        for elements in {way[0] for way in ANCF}
    }
    arms = [(CABLE, ExudynArm(angles, 100.0, *way), finest[way[0]]) for way in ANCF]
    arms += [(FRAME, FloatingArm(angles, 100.0, *way), motion - motion[0]) for way in FLOATING]
    lines: list[Line] = []
    kinds: dict[str, list[tuple[str, float, str]]] = {CABLE: [], FRAME: []}
    for kind, arm, exact in arms:
        found = match(partial(_exudyn, arm, exact, problem.t_end), STEPS, 0, TOLERANCE, inf)
        ratio = found.seconds / best.seconds if found.met else nan
        kinds[kind].append((arm.label, ratio, found.told(problem.t_end)))
        lines.append(Line(f"{LONG_ARM}: {arm.label} / this project", ratio, "", note=found.told(problem.t_end)))
    return {"case": LONG_ARM, "label": best.label, "steps": best.steps, "seconds": best.seconds, "kinds": kinds}, lines


def _exudyn(arm: ExudynArm, exact: np.ndarray, t_end: float, steps: float) -> Attempt:
    """A run in about so many steps, a multiple of the samples."""
    count = EXUDYN_SAMPLES * max(1, round(steps / EXUDYN_SAMPLES))
    try:
        off = arm.run(t_end, count, EXUDYN_SAMPLES)[1] - exact
        seconds = arm.run(t_end, count)[0]
        if seconds < EXUDYN_REPEATED:
            seconds = min(seconds, *(arm.run(t_end, count)[0] for _ in range(EXUDYN_REPEATS - 1)))
    except RuntimeError as failed:
        return Attempt(steps, inf, 0.0, count, str(failed))
    amplitudes = np.sqrt(np.mean((exact - exact.mean(axis=0)) ** 2, axis=0))
    error = float((np.sqrt(np.mean(off**2, axis=0)) / amplitudes).max())
    return Attempt(steps, error if isfinite(error) else inf, seconds, count)


def against_pinocchio(links: int, model: Model, theirs: ctypes.CDLL) -> tuple[dict[str, Any], list[Line]]:
    """A rigid chain, thrown from a bend, by the same explicit steps: ours, and ratios of theirs."""
    case, c = planar_chain(links), model.constants(model.parameter_vector())
    tree = PinocchioTree(theirs, case.hinges, case.gravity)
    with workplace() as folder:
        aba = tree.expression(folder)

    def accelerations(q: ca.SX, v: ca.SX, given: ca.SX) -> ca.SX:
        equations = StageEquations(model, given)
        return equations.tree_accelerations(equations.close(q, ca.SX(0, 1), ca.SX(0), 1), v)

    angles, rest = np.array([-1.2 + 0.5 * sin(k) for k in range(1, links + 1)]), np.zeros(links)
    steppers = {
        "this project": (ExplicitStepper(links, c, accelerations), angles, np.eye(links)),
        "Pinocchio, CasADi code": (
            ExplicitStepper(links, np.zeros(0), lambda q, v, given: aba(q, v)),
            case.relative @ angles,
            np.linalg.inv(case.relative),
        ),
    }
    exact = steppers["this project"][0].runner(angles, rest, RIGID_END, 20_000)().copy()
    steps, errors, workers = {}, {}, {}
    for name, (stepper, start, back) in steppers.items():
        for count in (round(20 * 2 ** (k / 4)) for k in range(60)):
            errors[name] = np.abs(back @ stepper.runner(start, rest, RIGID_END, count)() - exact).max()
            if errors[name] <= RIGID_TOLERANCE:
                break
        steps[name] = count
        workers[name] = partial(_repeated, stepper.runner(start, rest, RIGID_END, count))
    calls = 12 * steps["Pinocchio, CasADi code"]
    aba_calls = tree.worker(np.concatenate([case.relative @ angles, rest, rest]))
    workers["Pinocchio, aba calls alone"] = partial(_many, aba_calls, calls)
    timings = interleave(workers, 20)
    own, title = timings["this project"].best, f"rigid arm of {links}"
    note = f"dop853, {errors['this project']:.1e} in {steps['this project']} steps"
    lines = [Line(f"{title}: this project", own / RIGID_END * 1e3, "ms/s", note=note)]
    figures: dict[str, Any] = {"steps": steps["this project"], "seconds": own, "theirs": {}}
    for name in list(timings)[1:]:
        told = f"{errors[name]:.1e} in {steps[name]} steps" if name in steps else f"{calls} calls"
        note = f"{told}, {timings[name].best / RIGID_END * 1e3:.3g} ms/s"
        figures["theirs"][name] = timings[name].best / own, told
        lines.append(Line(f"{title}: {name} / this project", timings[name].best / own, "", note=note))
    return figures, lines


def _many(calls: Callable[[int], None], each: int, times: int) -> None:
    calls(each * times)


def _repeated(run: Callable[[], np.ndarray], times: int) -> None:
    for _ in range(times):
        run()
