"""Singular positions: seen coming by the determinants of the closure, and passed by another q_i or in one step."""
