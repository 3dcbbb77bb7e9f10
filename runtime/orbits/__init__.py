"""Motions that repeat: found by shooting, their stability, their branches over a parameter, their sensitivity."""
