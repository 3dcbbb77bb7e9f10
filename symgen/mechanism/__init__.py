"""A mechanism as users have it: written in Python or TOML, checked as a whole, and its model, which is kept."""
