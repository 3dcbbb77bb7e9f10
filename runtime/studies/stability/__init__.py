"""Stability of a scheme on a model, computed from the exact Jacobian of its step."""
