"""Straight-line code of the kernels."""
