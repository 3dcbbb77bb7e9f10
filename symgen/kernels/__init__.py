"""The functions that a model provides."""
