"""Expressions: scalars that keep zeros and ones, vectors, rows, small systems, SymPy templates."""
