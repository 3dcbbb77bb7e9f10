"""What is checked between native calls, one check a file; each says what to do where it stops a run."""
