"""Dimensionless modal data of a uniform beam: numbers for unit length, mass and stiffness (Eqs. 15-20)."""
