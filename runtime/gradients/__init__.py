"""Derivatives of a run by its parameters and initial values, and what they are good for: fits and designs."""

from runtime.gradients.objectives import End, Formula, Integral, Largest, Objective, SquaredError

__all__ = ["End", "Formula", "Integral", "Largest", "Objective", "SquaredError"]
