"""Established adaptive integrators on the same emitted equations, compiled where possible: baselines of the schemes."""

from runtime.baselines.scipy_methods import scipy_solution
from runtime.baselines.sundials import sundials_solution

__all__ = ["scipy_solution", "sundials_solution"]
