"""The methods whose steps may follow their estimates of the error: what a Method says, driven by AdaptiveSteps."""

from __future__ import annotations

from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.baselines.runge_kutta import DormandPrince5
from runtime.schemes.exponential import Exponential
from runtime.schemes.exponential_rk4 import ExponentialRungeKutta


class AdaptiveDormandPrince(AdaptiveSteps, DormandPrince5):
    """Six evaluations an attempt."""


class AdaptiveExponential(AdaptiveSteps, Exponential):
    """One evaluation with its Jacobian at the start of a step, one more an attempt."""


class AdaptiveExponentialRungeKutta(AdaptiveSteps, ExponentialRungeKutta):
    """One evaluation at the start of a step, three more an attempt."""
