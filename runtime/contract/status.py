"""How a simulation ended: a named status with time, coordinate, likely cause and advice."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from runtime.contract.cards import Html, badge, html

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
    "off_the_beam",
    "integrator_refused",
    "output_failed",
    "not_assembled",
    "event",
    "chattering",
    "no_mode",
]
EventKind = Literal[
    "assembled",
    "start_changed",
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
    "measure_undefined",
    "velocity_jump",
    "beyond_buckling",
    "angles_singular",
    "kink_crossed",
    "chattering",
    "kink",
    "event",
    "mode",
    "impact",
    "rest",
]


@dataclass(frozen=True)
class Event:
    """Something that happened during a run, at a time [s], told in plain words; of events of the scene with their name
    and direction (rising or falling). Kinks of loads, at which steps end without a word, are in no solution.
    Of an impact impulse: what a stop gave, away from it [N s or N m s]; before, after: the rates of its gap [m/s or
    rad/s]; energy_lost [J].
    """

    time: float
    kind: EventKind
    text: str
    name: str = ""
    direction: str = ""
    impulse: float = 0.0
    before: float = 0.0
    after: float = 0.0
    energy_lost: float = 0.0

    def __str__(self) -> str:
        return f"t = {self.time:.9g} s: {self.text}"


@dataclass(frozen=True)
class Status:
    """How a run ended.

    Attributes
    ----------
    name : str
        Such as completed, event, diverged; `ok` says whether it is a good one.
    time : float
        Time of the last good state [s].
    coordinate : str, optional
        The coordinate that failed, if one did.
    cause, advice : str
        Why, and what to do, in plain words.
    """

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

    def _repr_html_(self) -> Html:
        where = f", coordinate {self.coordinate}" if self.coordinate else ""
        cause = html(Html("<br>"), self.cause) if self.cause else Html()
        advice = html(Html("<br>"), f"Try: {self.advice}") if self.advice else Html()
        return html(badge(self.name, self.ok), f" at t = {self.time:.9g} s{where}", cause, advice)

    def __str__(self) -> str:
        where = f", coordinate {self.coordinate}" if self.coordinate else ""
        tail = f": {self.cause}. {self.advice}" if self.cause else ""
        return f"{self.name} at t = {self.time:.9g} s{where}{tail}"
