"""Faults put into the code at random, to see whether the tests see them: python -m benchmarks.mutations --help."""
