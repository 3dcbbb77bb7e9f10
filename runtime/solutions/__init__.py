"""The result of a run as users have it: its class, and how it is made of saved states or of a mode."""
