"""Tables that pages have of benchmarks: FIGURES of each module, by the names of their markers."""
