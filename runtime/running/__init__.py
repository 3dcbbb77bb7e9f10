"""The parts of a run: its plan, its legs, what is kept of it, checkpoints, and the loop itself."""
