"""Which methods are compared: schemes with usual ratios and options, and established adaptive integrators.

A step with dense matrices takes about 12 n^3 operations with n independent coordinates (measured on arms of 20 and 40
links), and some 60 us of the compiler for each of them. Beyond LARGE coordinates one such method of each kind stands
for the others, beyond what can be compiled there is none. Methods whose work is in proportion to n are always tried.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from runtime.baselines.scipy_methods import scipy_solution
from runtime.baselines.sundials import sundials_solution
from runtime.contract.model import Model
from runtime.results.solution import Solution
from runtime.running.ladder import DENSE, Method, affordable
from runtime.schemes.catalogue import SCHEMES
from runtime.schemes.options import SchemeError

LARGE = 20  # independent coordinates
RADAU = Method("radau", None, {"eps": (1e-6,)})
ONE_OF_EACH = (Method("exponential", (1,)), RADAU)
ALL_DENSE = (
    *(Method("exponential", (m,)) for m in (1, 2, 4)),
    *(Method("exponential", (m,), {"order": 5}) for m in (1, 2)),
    RADAU,
)
WORTH_TRYING = (*ALL_DENSE[:2], *ALL_DENSE[3:5], RADAU)
PREDICTED = Method("single_rate", None, {"common_velocity": "predictor"})
ADAPTIVE: dict[str, Callable[..., Solution]] = {
    "DOP853 adaptive": partial(scipy_solution, method="DOP853"),
    "Radau adaptive": partial(scipy_solution, method="Radau"),
    "CVODES BDF": partial(sundials_solution, method="cvodes"),
    "CVODES Adams": partial(sundials_solution, method="cvodes", multistep="adams"),
    "IDAS": partial(sundials_solution, method="idas"),
}
FOR_LARGE = ("DOP853 adaptive", "CVODES BDF", "CVODES Adams", "IDAS")
FOR_LONGEST = ("DOP853 adaptive",)  # the others need derivatives of hundreds of thousands of operations


def multirate(method: Method) -> bool:
    """Does it take sub-steps?"""
    return SCHEMES[method.scheme].multirate


def usual_methods(model: Model) -> list[Method]:
    """Every scheme with a usual m; of dense ones fewer for large models: `left_out`."""
    found = [*stiff_methods(model), *_dense(model, ALL_DENSE)]
    if len(model.groups) > 1:
        inner = (1,) * (len(model.groups) - 2)
        found += [Method("coupled", (*inner, 4)), Method("printed", (*inner, 4), {"common_update": "direct"})]
    return [*found, Method("single_rate"), PREDICTED, Method("rk4"), Method("dop853")]


def candidates(model: Model) -> list[Method]:
    """Methods worth trying for advice, the likeliest first."""
    found = [*stiff_methods(model), *_dense(model, WORTH_TRYING), PREDICTED, Method("rk4"), Method("dop853")]
    if len(model.groups) > 1:
        inner = (1,) * (len(model.groups) - 2)
        found += [Method("coupled", (*inner, ratio)) for ratio in (2, 5, 10)]
    return found


def stiff_methods(model: Model) -> list[Method]:
    """Those for stiff deflections, the likeliest first; `exponential_adams` not where these are many along a tree."""
    if not model.has("deflections"):
        return []
    many = model.has("shifted_solution")
    return [*([] if many else [Method("exponential_adams")]), Method("exponential_rk4")]


def _dense(model: Model, all_of_them: tuple[Method, ...]) -> list[Method]:
    if not model.has("residual_jacobian"):
        return []
    if len(model.q_i) <= LARGE:
        return list(all_of_them)
    return list(ONE_OF_EACH) if affordable(model) else []


def left_out(model: Model) -> str:
    """What is not tried on a model, and how to have it tried; "" where all of them are."""
    n = len(model.q_i)
    if n <= LARGE:
        return ""
    if not model.has("residual_jacobian"):
        return f"not tried with {n} coordinates: methods with a Jacobian, which the model is too large to have"
    names = ", ".join(one.scheme for one in ONE_OF_EACH)
    ask = "symgen report SCENE --methods exponential:2"
    if affordable(model):
        return f"not tried with {n} coordinates: dense methods beside {names}; {ask} tries some"
    price = f"{DENSE * n**3 / 1e6:.1f} million operations a step"
    return f"not tried with {n} coordinates: {names} and other dense methods, {price}; {ask}"


def usual_adaptive(model: Model) -> list[str]:
    """Names of the established integrators that a model is compared with."""
    if len(model.q_i) <= LARGE:
        return list(ADAPTIVE)
    return list(FOR_LARGE if affordable(model) and model.has("residual_jacobian") else FOR_LONGEST)


def methods_named(model: Model, names: list[str]) -> list[Method | str]:
    """Methods by name: `exponential`, `coupled:4` (m after a colon, ratios with +), or an adaptive one's name.

    `compiled` alone stands for all usual schemes. Raises SchemeError.
    """
    if names == ["compiled"]:
        return list(usual_methods(model))
    found: list[Method | str] = []
    for name in names:
        adaptive = next((one for one in ADAPTIVE if one.lower().replace(" ", "_") == name.lower()), None)
        if adaptive is not None:
            found.append(adaptive)
            continue
        scheme, _, ratios = name.partition(":")
        if scheme not in SCHEMES:
            known = ", ".join([*SCHEMES, *(one.lower().replace(" ", "_") for one in ADAPTIVE)])
            raise SchemeError(f"there is no method {name!r}; methods are {known}")
        try:
            m = tuple(int(part) for part in ratios.split("+")) if ratios else None
        except ValueError:
            raise SchemeError(f"{name!r}: what follows the colon must be whole numbers, such as {scheme}:4") from None
        found.append(Method(scheme, m))
    return found
