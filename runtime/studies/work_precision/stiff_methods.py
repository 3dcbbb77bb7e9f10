"""Methods for stiff deflections that do without the Jacobian of the mechanism, or with little else."""

from __future__ import annotations

from runtime.contract.model import Model
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.rosenbrock_adams import RosenbrockAdams
from runtime.studies.work_precision.prepared_method import Spec


def stiff_methods(model: Model) -> list[Spec]:
    """The likeliest first; `exponential_adams` not where deflections are many along a tree."""
    if not model.has("deflections"):
        return []
    found = [Spec("exponential_rk4")]
    if model.has("shifted_solution"):
        return found
    return [*_adams(model), *found]


def _adams(model: Model) -> list[Spec]:
    """As it chooses itself by the price of a step; with the Jacobian, too, where that is dearer and may take fewer."""
    name = "exponential_adams"
    chosen = scheme_kind(name).build(name, model, 1.0, None, {})
    if chosen.takes_jacobian or not RosenbrockAdams.possible(model):
        return [Spec(name)]
    return [Spec(name), Spec(name, None, {"linearisation": "jacobian"})]
