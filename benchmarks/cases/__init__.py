"""What is measured, one case a file, and the mechanisms that are timed."""
