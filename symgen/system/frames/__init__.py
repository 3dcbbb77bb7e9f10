"""Bodies of a spatial mechanism as a tree of frames, and the recursions along it."""
