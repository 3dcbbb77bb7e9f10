"""One model run many times: samples in, reductions or histories out, many runs side by side."""
