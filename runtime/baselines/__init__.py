"""Established adaptive integrators on the same emitted equations, compiled where possible: baselines of the schemes."""
