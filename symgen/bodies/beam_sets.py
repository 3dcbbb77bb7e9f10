"""The mode sets of a beam of the scene: exact shapes, or those of the paper's lumped mesh (Eqs. 15-20)."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

from runtime.contract.records import ModeSetRecord
from symgen.modes import (
    BarModes,
    BeamModes,
    axial_modes,
    exact_bending,
    exact_stretching,
    lateral_modes,
    panels_for,
)
from symgen.scene import BeamBody

BENDING_AXES = (1, 2)


class SetChoice(NamedTuple):
    """axis: direction of the displacements, 0 = x (stretching), 1 = y, 2 = z; 3 = torsion about x."""

    axis: int
    ends: str
    modes: int


ModeSets = tuple[tuple[int, BeamModes | BarModes], ...]


def set_choices(body: BeamBody) -> tuple[SetChoice, ...]:
    """The sets that a beam asks for, in the order of its coordinates. Its `ends` are filled in."""
    found = []
    for axis, modes in ((1, body.lateral), (2, body.lateral_z), (0, body.axial), (3, body.torsion)):
        if modes is not None:
            assert modes.ends is not None, "ends are filled in where the scene is left behind"
            found.append(SetChoice(axis, modes.ends, modes.modes))
    return tuple(found)


def mode_sets(body: BeamBody) -> ModeSets:
    """(axis, shapes) of each set; equal requests are computed once."""
    return _sets(body.lumped_elements, set_choices(body))


@lru_cache(maxsize=64)
def _sets(elements: int | None, choices: tuple[SetChoice, ...]) -> ModeSets:
    if elements is not None:
        return tuple(
            (one.axis, (lateral_modes if one.axis in BENDING_AXES else axial_modes)(elements, one.ends, one.modes))
            for one in choices
        )
    panels = panels_for(max((one.modes for one in choices), default=0))
    return tuple(
        (one.axis, (exact_bending if one.axis in BENDING_AXES else exact_stretching)(one.ends, one.modes, panels))
        for one in choices
    )


def set_records(body: BeamBody) -> list[ModeSetRecord]:
    """The sets as the runtime knows them: names from which it has the same shapes."""
    return [ModeSetRecord(*one) for one in set_choices(body)]


def mesh_name(body: BeamBody) -> str:
    """First part of the name of a beam's data in p: of the exact ones, or of its mesh."""
    return "beam" if body.lumped_elements is None else f"beam{body.lumped_elements}"
