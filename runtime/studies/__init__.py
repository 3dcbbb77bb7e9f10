"""Studies made of many runs: stability, work-precision, advice."""
