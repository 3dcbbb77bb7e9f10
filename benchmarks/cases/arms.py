"""Arms of rigid links with one flexible link: what schemes cost over links and over the stiffness of that link."""

from __future__ import annotations

import sys
from dataclasses import replace
from math import ceil

from scipy.interpolate import CubicHermiteSpline

from benchmarks.harness.fewest import Timed, fewest
from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from benchmarks.scenes.arm import arm
from runtime.contract.coordinates import followed
from runtime.model import Model
from runtime.running.method_choice import Method
from runtime.running.problem import Problem
from runtime.running.step_refinement import StepRefinement
from runtime.studies.advice.reference import Reference

CASES = ((10, 1.0), (10, 10.0), (10, 100.0), (10, 1000.0), (20, 100.0), (40, 100.0))  # links, factor on E
DENSE = 20  # links up to which more than one scheme that factorises M_hat is compiled
T_END, TOLERANCE = 0.5, 1e-3
KEPT = 2000  # samples of a reference
FASTEST = 2_360.0  # rad/s, the fastest mode with the factor 1
REFERENCE_REACH, EXPLICIT_REACH = 1.2, 1.9  # h w of the reference, of order 8, and of central differences
SMALLEST = {"CASES": ((2, 1.0),), "T_END": 0.02}


def run() -> Result:
    """Every scheme with the fewest steps that are enough; reference: DOP853 with steps that resolve all modes."""
    lines: list[Line] = []
    details: dict = {}
    with workplace() as folder:
        for links, stiffening in CASES:
            print(f"  {links} links, E x {stiffening:g} ...", file=sys.stderr, flush=True)
            fastest = FASTEST * stiffening**0.5
            reference = arm_reference(model_of(arm(links, stiffening=stiffening), folder), fastest)
            for method in _contenders(links, fastest):
                timed = Timed(method, reference)
                best = fewest(timed, TOLERANCE, most=40_000)
                if best is None:
                    continue
                note = f"{best.steps} steps, {timed.operations} operations a step, error {best.error:.1e}"
                name = f"{links} links, E x {stiffening:g}, {method.label}"
                lines.append(Line(name, best.seconds * 1e3, "ms", note=note))
                details[name] = {"steps": best.steps, "operations": timed.operations, "seconds": best.seconds}
    return Result("arms", f"Arms of N links, the last one flexible, {T_END} s to {TOLERANCE:g}", lines, details)


def _contenders(links: int, fastest: float) -> list[Method]:
    """Sub-steps at the limit of the fastest mode in some hundred major steps."""
    limit = T_END * fastest / EXPLICIT_REACH
    dense = [
        Method("exponential", (1,)),
        Method("exponential", (1,), {"order": 5}),
        Method("radau", None, {"eps": (1e-6,)}),
    ]
    dense = dense if links <= DENSE else dense[:1]
    ratios = sorted({max(2, ceil(limit / steps)) for steps in (125, 250, 500, 1000)})
    coupled = [Method("coupled", (m,)) for m in ratios]
    stiff = [Method("exponential_adams"), Method("exponential_rk4")]
    return [*stiff, *dense, *coupled, Method("single_rate", None, {"common_velocity": "predictor"})]


def arm_reference(model: Model, fastest: float) -> Reference:
    """Link angles of an arm against steps of order 8 that resolve its fastest mode [rad/s]."""
    problem = Problem.of(model, T_END)
    refinement, steps = StepRefinement(problem, 1e-12), ceil(T_END * fastest / REFERENCE_REACH)
    level = refinement.level(replace(refinement.plan(Method("dop853"), steps), seen_steps=max(1, steps // KEPT)))
    seen = level.run.sampled_solution()
    columns = followed(model)[1]
    path = CubicHermiteSpline(seen.t, seen.q[:, columns], seen.q_dot[:, columns])
    return Reference(problem, path, [name for name in model.q_i if name.endswith("theta")], 1e-7)
