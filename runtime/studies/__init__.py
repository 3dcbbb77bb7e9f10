"""Studies made of many runs: ensembles, stability, work-precision, advice."""
