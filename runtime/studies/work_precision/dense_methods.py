"""Methods that factorise dense matrices, by size: all of them, one of each kind, or none; who leaves some out says so.

A step of them takes about PER_CUBE n^3 operations with n independent coordinates (measured on arms of 20 and 40 links),
and some 60 us of the compiler for each of them. Methods whose work is in proportion to n are always tried.
"""

from __future__ import annotations

from runtime.contract.model import Model
from runtime.studies.work_precision.prepared_method import Spec

LARGE = 20  # independent coordinates beyond which one method of each kind stands for the others
PER_CUBE = 12
MOST_OPERATIONS = 400_000  # of a step: some 30 s of the compiler
ONE_OF_EACH = (Spec("exponential", (1,)), Spec("radau", None, {"eps": (1e-6,)}))


def dense_methods(model: Model, all_of_them: list[Spec]) -> list[Spec]:
    """Those to be tried on a model."""
    if not model.has("residual_jacobian"):
        return []
    if len(model.q_i) <= LARGE:
        return all_of_them
    return list(ONE_OF_EACH) if affordable(model) else []


def affordable(model: Model) -> bool:
    """Is a step of them short enough to be compiled?"""
    return PER_CUBE * len(model.q_i) ** 3 <= MOST_OPERATIONS


def left_out(model: Model) -> str:
    """What is not tried on a model, and how to have it tried; "" where all of them are."""
    n = len(model.q_i)
    if n <= LARGE:
        return ""
    if not model.has("residual_jacobian"):
        return f"not tried with {n} coordinates: methods with a Jacobian, which the model is too large to have"
    names = ", ".join(one.scheme for one in ONE_OF_EACH)
    ask = "symgen report SCENE --methods exponential:2,linearised:2"
    if affordable(model):
        return f"not tried with {n} coordinates: dense methods beside {names}; {ask} tries some"
    price = f"{PER_CUBE * n**3 / 1e6:.1f} million operations a step"
    return f"not tried with {n} coordinates: {names} and other dense methods, {price}; {ask}"
