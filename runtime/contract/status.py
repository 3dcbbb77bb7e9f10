"""How a simulation ended: a named status with time, coordinate, likely cause and advice."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import Literal

from runtime.contract.cards import badge

StatusName = Literal[
    "completed",
    "inaccurate",
    "interrupted",
    "step_too_long",
    "step_too_short",
    "not_finite",
    "diverged",
    "constraints_lost",
    "mass_not_positive",
    "iteration_failed",
    "partition_lost",
    "branch_lost",
    "deflection_too_large",
    "integrator_refused",
    "output_failed",
    "not_assembled",
    "event",
    "chattering",
]
EventKind = Literal[
    "assembled",
    "not_settled",
    "repartition",
    "singular_position",
    "no_variant",
    "checkpoint_failed",
    "load_missed",
    "load_not_finite",
    "shapes_missing",
    "stresses_missing",
    "sections_missing",
    "velocity_jump",
    "beyond_buckling",
    "angles_singular",
    "event",
]


@dataclass(frozen=True)
class Event:
    """Something that happened during a run, at a time [s], told in plain words; of events of the scene with their name
    and direction (rising or falling).
    """

    time: float
    kind: EventKind
    text: str
    name: str = ""
    direction: str = ""

    def __str__(self) -> str:
        return f"t = {self.time:.9g} s: {self.text}"


@dataclass(frozen=True)
class Status:
    """name; time of the last good state [s]; coordinate that failed (if any); cause and advice in plain words."""

    name: StatusName
    time: float
    coordinate: str | None = None
    cause: str = ""
    advice: str = ""

    @property
    def ok(self) -> bool:
        """Did the run reach its end, or a terminal event, and is its error small as far as it was estimated?"""
        return self.name in ("completed", "event")

    @property
    def whole(self) -> bool:
        """Was all of the motion computed, accurately or not?"""
        return self.ok or self.name == "inaccurate"

    @property
    def ending(self) -> str:
        """For titles: nothing where all is well, else what happened and when."""
        if self.ok:
            return ""
        return "INACCURATE" if self.whole else f"STOPPED: {self.name} at {self.time:.4g} s"

    def _repr_html_(self) -> str:
        where = f", coordinate {escape(self.coordinate)}" if self.coordinate else ""
        cause = f"<br>{escape(self.cause)}" if self.cause else ""
        advice = f"<br>Try: {escape(self.advice)}" if self.advice else ""
        return f"{badge(self.name, self.ok)} at t = {self.time:.9g} s{where}{cause}{advice}"

    def __str__(self) -> str:
        where = f", coordinate {self.coordinate}" if self.coordinate else ""
        tail = f": {self.cause}. {self.advice}" if self.cause else ""
        return f"{self.name} at t = {self.time:.9g} s{where}{tail}"
