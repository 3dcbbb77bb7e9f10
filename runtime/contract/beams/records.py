"""A beam as the manifest names it; its shapes follow from the names."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class ModeSetRecord:
    """Shapes of a beam by name (runtime.contract.beams): their ends and number.

    axis: direction of the displacements, 0 = x (stretching), 1 = y, 2 = z; 3 = torsion about x.
    """

    axis: int
    ends: str
    modes: int


@dataclass(frozen=True)
class BeamRecord:
    """A beam with exact shapes: its mode sets in the order of its coordinates, and the loads that act on it.

    loads: names of loads and of joints with friction, in the order of their columns in `load_forces`. missing: share of
    the static bending energy of what its ends carry that the shapes miss, 0 if they carry it.
    """

    body: str
    sets: list[ModeSetRecord]
    loads: list[str] = field(default_factory=list)
    missing: float = 0.0


def beam_records(plain: Iterable[Mapping[str, Any]]) -> list[BeamRecord]:
    """The records from plain values. Raises KeyError or TypeError for anything else."""
    return [BeamRecord(**{**entry, "sets": [ModeSetRecord(**one) for one in entry["sets"]]}) for entry in plain]
