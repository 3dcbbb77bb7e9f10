"""Derivatives of a run by its parameters and initial values, and what they are good for: fits and designs."""
