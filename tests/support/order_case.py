"""What a test of the order of a scheme runs."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class OrderCase:
    """t_end and the coarsest of three steps [s], a cap on the error at the finest, about 1.5 times the measured one."""

    t_end: float
    dt: float
    cap: float
    start: str | None = None
