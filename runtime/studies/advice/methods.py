"""Which methods are worth trying on a model, and by which coordinates they are graded.

A step with dense matrices takes about 12 n^3 operations with n independent coordinates (measured on arms of 20 and 40
links), and some 60 us of the compiler for each of them. Beyond LARGE coordinates one such method of each kind stands
for the others, beyond what can be compiled there is none. Methods whose work is in proportion to n are always tried.
"""

from __future__ import annotations

from collections.abc import Sequence

from runtime.contract.coordinates import followed
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.running.method_choice import DENSE_STEP_OPERATIONS, Method, affordable
from runtime.schemes.catalogue import SCHEMES
from runtime.studies.advice.spectrum import StepRatios

LARGE = 20  # independent coordinates
RADAU = Method("radau", None, {"eps": (1e-6,)})
ONE_OF_EACH = (Method("exponential", (1,)), RADAU)
CHEAP = (1, 2)  # sub-steps of `exponential` that make a step of one stage
PREDICTED = Method("single_rate", None, {"common_velocity": "predictor"})


def multirate(method: Method) -> bool:
    """Does it take sub-steps?"""
    return SCHEMES[method.scheme].multirate


def candidates(model: EmittedModel, ratios: StepRatios) -> list[Method]:
    """Methods worth trying for advice, the likeliest first, with ratios of steps as the motion needs them."""
    found = [*stiff_methods(model), *_dense(model, ratios), PREDICTED, Method("rk4"), Method("dop853")]
    if len(model.groups) > 1:
        twice = (*(1,) * (len(model.groups) - 2), 2)
        wanted = dict.fromkeys((twice, ratios.halved, ratios.groups))
        found += [Method("coupled", one) for one in wanted if max(one) > 1]
    return found


def always_reported(model: EmittedModel, ratios: StepRatios) -> list[Method]:
    """What every report shows: the paper's sub-cycling, and central difference with one step for all coordinates.

    `printed` has the ratios that the motion needs, and those of a scene that is stepped by it.
    """
    own = model.simulation.get("m") if model.simulation["scheme"] == "printed" else None
    wanted = dict.fromkeys((ratios.groups, *([tuple(own)] if own else [])))
    return [*(Method("printed", one or None) for one in wanted), Method("single_rate")]


def stiff_methods(model: EmittedModel) -> list[Method]:
    """Those for stiff deflections, the likeliest first; `exponential_adams` not where these are many along a tree."""
    if not model.has("deflections"):
        return []
    many = model.has("shifted_solution")
    return [*([] if many else [Method("exponential_adams")]), Method("exponential_rk4")]


def _dense(model: EmittedModel, ratios: StepRatios) -> list[Method]:
    if not model.has("residual_jacobian"):
        return []
    if len(model.q_i) <= LARGE:
        sub_steps = sorted({*CHEAP, ratios.overall})
        fifth = [Method("exponential", (m,), {"order": 5}) for m in CHEAP]
        return [*(Method("exponential", (m,)) for m in sub_steps), *fifth, RADAU]
    return list(ONE_OF_EACH) if affordable(model) else []


def left_out(model: EmittedModel) -> str:
    """What is not tried on a model; "" where all of them are."""
    n = len(model.q_i)
    if n <= LARGE:
        return ""
    if not model.has("residual_jacobian"):
        return f"not tried with {n} coordinates: methods with a Jacobian, which the model is too large to have"
    names = ", ".join(one.scheme for one in ONE_OF_EACH)
    if affordable(model):
        return f"not tried with {n} coordinates: dense methods beside {names}"
    price = f"{DENSE_STEP_OPERATIONS * n**3 / 1e6:.1f} million operations a step"
    return f"not tried with {n} coordinates: {names} and other dense methods, {price}"


def checked_grades(model: EmittedModel, graded: Sequence[str] | None) -> list[str]:
    """Names of what tells the motion, all by default. Raises ModelError."""
    known = followed(model)[0]
    for name in graded or ():
        if name not in known:
            raise ModelError(
                f"{name!r} cannot be graded: it is not an independent coordinate of {model.name}; those "
                f"are {', '.join(known)}"
            )
    return list(graded or known)
