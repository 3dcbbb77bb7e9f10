"""Frequencies of the condensed, linearised equations."""
