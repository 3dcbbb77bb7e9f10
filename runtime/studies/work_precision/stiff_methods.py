"""Methods that follow stiff deflections without a Jacobian of the mechanism, as far as a model can take them."""

from __future__ import annotations

from runtime.contract.model import Model
from runtime.studies.work_precision.prepared_method import Spec


def stiff_methods(model: Model) -> list[Spec]:
    """The likeliest first; `exponential_adams` not where deflections are many along a tree."""
    if not model.has("deflections"):
        return []
    found = [Spec("exponential_rk4")]
    if model.has("shifted_solution"):
        return found
    return [Spec("exponential_adams"), *found]
