"""The mechanism as pictures need it: bodies with their points, poses over time, exaggeration without gaps."""
