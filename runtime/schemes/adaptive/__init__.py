"""Steps whose length follows from a tolerance: one loop, and the methods that it drives."""
