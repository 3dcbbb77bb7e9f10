"""Which constraint rows count and which coordinates depend (29)-(31), (39), (72)."""
