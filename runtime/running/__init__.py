"""The parts of a run: its plan, its segments, what is kept of it, checkpoints, and the loop itself."""
