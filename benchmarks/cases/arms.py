"""Arms of rigid links with one flexible link: what schemes cost over links and over the stiffness of that link."""

from __future__ import annotations

import sys
from math import ceil

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from runtime.contract.model import Model
from runtime.studies.work_precision.prepared_method import PreparedMethod, Spec
from runtime.studies.work_precision.problem import Problem, make_setting
from runtime.studies.work_precision.search import search_steps
from symgen.scenes.arm import arm

CASES = ((10, 1.0), (10, 10.0), (10, 100.0), (10, 1000.0), (20, 100.0), (40, 100.0))  # links, factor on E
DENSE = 20  # links up to which more than one scheme that factorises M_hat is compiled
T_END, TOLERANCE = 0.5, 1e-3
FASTEST = 2_360.0  # rad/s, the fastest mode with the factor 1
REFERENCE_REACH, EXPLICIT_REACH = 1.2, 1.9  # h w of the reference, of order 8, and of central differences


def run() -> Result:
    """Every scheme with the fewest steps that are enough; reference: DOP853 with steps that resolve all modes."""
    lines: list[Line] = []
    details: dict = {}
    with workplace() as folder:
        for links, stiffening in CASES:
            print(f"  {links} links, E x {stiffening:g} ...", file=sys.stderr, flush=True)
            fastest = FASTEST * stiffening**0.5
            problem = arm_problem(model_of(arm(links, stiffening=stiffening), folder), fastest)
            for spec in _contenders(links, fastest):
                method = PreparedMethod(spec, problem)
                best = search_steps(method, TOLERANCE, most=40_000).best
                if best is None:
                    continue
                note = f"{best.steps} steps, {method.operations} operations a step, error {best.error:.1e}"
                name = f"{links} links, E x {stiffening:g}, {spec.label}"
                lines.append(Line(name, best.seconds * 1e3, "ms", note=note))
                details[name] = {"steps": best.steps, "operations": method.operations, "seconds": best.seconds}
    return Result("arms", f"Arms of N links, the last one flexible, {T_END} s to {TOLERANCE:g}", lines, details)


def _contenders(links: int, fastest: float) -> list[Spec]:
    """Sub-steps at the limit of the fastest mode in some hundred major steps."""
    limit = T_END * fastest / EXPLICIT_REACH
    dense = [Spec("exponential", (1,)), Spec("exponential", (1,), {"order": 5}), Spec("radau", None, {"eps": (1e-6,)})]
    dense = dense if links <= DENSE else dense[:1]
    ratios = sorted({max(2, ceil(limit / steps)) for steps in (125, 250, 500, 1000)})
    decoupled = [Spec("decoupled", (m,)) for m in ratios]
    stiff = [Spec("exponential_adams"), Spec("exponential_rk4")]
    return [*stiff, *dense, *decoupled, Spec("single_rate", None, {"common_velocity": "predictor"})]


def arm_problem(model: Model, fastest: float) -> Problem:
    """Link angles of an arm against a reference that resolves its fastest mode [rad/s]."""
    angles = [name for name in model.q_i if name.endswith("theta")]
    setting = make_setting(model, t_end=T_END, graded=angles)
    unknown = Problem(setting, T_END, lambda times: np.zeros((len(times), len(model.q_i))), 0.0)
    seen, _ = PreparedMethod(Spec("dop853"), unknown).observed(ceil(T_END * fastest / REFERENCE_REACH))
    path = CubicHermiteSpline(seen["t"][:, 0], seen["q_i"], seen["q_i_dot"])
    return Problem(setting, T_END, path, 1e-7)
