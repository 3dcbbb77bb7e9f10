"""Advice: which method, step and groups suit a model, with the reasons."""
