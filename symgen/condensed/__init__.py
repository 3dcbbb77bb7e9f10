"""The condensed equations (32)-(38), closed loops, and O(N) accelerations."""
