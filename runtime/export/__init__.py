"""Handing a model on: C code, and functional mock-up units."""
