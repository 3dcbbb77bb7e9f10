"""The gradient of a number that a run leads to, and the Jacobian of its outputs: the doors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from runtime.contract.model import Model
from runtime.gradients.derivatives_of_run import Gradient, OutputJacobian
from runtime.gradients.differentiable_run import DifferentiableRun
from runtime.gradients.objectives import Objective


def gradient(model: Model, of: Objective, by: Sequence[str], *, mode: str = "auto", **run: Any) -> Gradient:
    """d(of)/d(by) of a run: `of` an objective of outputs at saved times, `by` parameters and initial values by name.

    mode: `forward` (one direction a lane), `reverse` (one way back for all), or by what costs less. run: the arguments
    of DifferentiableRun, those of `simulate`. Who asks again and again keeps a DifferentiableRun. Raises ModelError,
    SchemeError, InitialStateError, ArgumentError for what cannot be used, NoResult for a run without a derivative.
    """
    return DifferentiableRun(model, of.outputs, by, **run).gradient(of, mode=mode)


def output_jacobian(model: Model, outputs: Sequence[str], by: Sequence[str], **run: Any) -> OutputJacobian:
    """d(outputs at every saved time)/d(by) of a run; the arguments and errors of `gradient`."""
    return DifferentiableRun(model, outputs, by, **run).jacobian()
