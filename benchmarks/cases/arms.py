"""Arms of rigid links with one stiff flexible link: what schemes cost as the mechanism grows, to 1e-3 in the angles."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from runtime.contract.model import Model
from runtime.studies.work_precision.prepared_method import PreparedMethod, Spec
from runtime.studies.work_precision.problem import Problem, make_setting
from runtime.studies.work_precision.search import search_steps
from symgen.scenes.arm import arm

LINKS = (10, 20, 40)
DENSE = 20  # links up to which schemes that factorise M_hat are compiled
STIFFENING, T_END, TOLERANCE = 100.0, 0.5, 1e-3
REFERENCE_STEPS = 10_000  # of order 8, h w = 1.2 for the fastest mode


def run() -> Result:
    """Every scheme with the fewest steps that are enough; reference: DOP853 with steps that resolve all modes."""
    lines: list[Line] = []
    details: dict = {}
    with workplace() as folder:
        for links in LINKS:
            problem = _problem(model_of(arm(links, stiffening=STIFFENING), folder))
            for spec in _contenders(links):
                method = PreparedMethod(spec, problem)
                best = search_steps(method, TOLERANCE, most=20_000).best
                if best is None:
                    continue
                note = f"{best.steps} steps, {method.operations} operations a step, error {best.error:.1e}"
                lines.append(Line(f"{links} links, {spec.label}", best.seconds * 1e3, "ms", note=note))
                details[f"{links} {spec.label}"] = {"steps": best.steps, "operations": method.operations}
    return Result("arms", f"Arms of N links, the last one flexible, {T_END} s to {TOLERANCE:g}", lines, details)


def _contenders(links: int) -> list[Spec]:
    dense = [Spec("exponential", (1,)), Spec("radau", None, {"eps": (1e-6,)})] if links <= DENSE else []
    decoupled = [Spec("decoupled", (m,)) for m in (16, 22, 32)]
    return [Spec("exponential_rk4"), *dense, *decoupled, Spec("single_rate", None, {"common_velocity": "predictor"})]


def _problem(model: Model) -> Problem:
    angles = [name for name in model.q_i if name.endswith("theta")]
    setting = make_setting(model, t_end=T_END, graded=angles)
    unknown = Problem(setting, T_END, lambda times: np.zeros((len(times), len(model.q_i))), 0.0)
    seen, _ = PreparedMethod(Spec("dop853"), unknown).observed(REFERENCE_STEPS)
    path = CubicHermiteSpline(seen["t"][:, 0], seen["q_i"], seen["q_i_dot"])
    return Problem(setting, T_END, path, 1e-7)
