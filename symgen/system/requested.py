"""What a scene asks of the later stages: which coordinates, which groups, which start."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from runtime.contract.consistent_state import GivenValues
from symgen.scene import InitialValue, Scene


@dataclass(frozen=True)
class RequestedGroup:
    """A group by name: coordinates, or patterns with * and ?, that share a step."""

    name: str
    patterns: tuple[str, ...]


@dataclass(frozen=True)
class Requested:
    """What the scene says about q_i (Eq. 29), its groups from slow to fast (Eqs. 39, 72) and the initial state.

    independent: q_i by name, empty if the choice is left open; groups likewise. stiff: patterns of the deflections that
    count as stiff, None for all. ratios: step ratio m of each group after the first. coordinates [m, rad] and rates
    [m/s, rad/s] at the start. euler_angles: sequence by body.
    """

    independent: tuple[str, ...] = ()
    groups: tuple[RequestedGroup, ...] = ()
    stiff: tuple[str, ...] | None = None
    ratios: tuple[int, ...] = ()
    coordinates: GivenValues = field(default_factory=GivenValues)
    rates: GivenValues = field(default_factory=GivenValues)
    euler_angles: Mapping[str, str] = field(default_factory=dict)


def requested_by(scene: Scene) -> Requested:
    """The requests of a scene."""
    return Requested(
        independent=_independent(scene),
        groups=tuple(RequestedGroup(group.name, group.coordinates) for group in scene.partition.groups or ()),
        stiff=scene.partition.stiff,
        ratios=scene.simulation.m,
        coordinates=_given(scene.initial.coordinates),
        rates=_given(scene.initial.rates | _states(scene)),
        euler_angles=scene.euler_angles(),
    )


def _independent(scene: Scene) -> tuple[str, ...]:
    """Those that the scene names, and with them the coordinates of states."""
    named = scene.partition.independent or ()
    states = [f"{name}.integral" for name in scene.states]
    return (*named, *(name for name in states if name not in named)) if named else ()


def _states(scene: Scene) -> dict[str, InitialValue]:
    """States at the start: rates of their coordinates."""
    return {f"{name}.integral": InitialValue(value=state.initial, fixed=True) for name, state in scene.states.items()}


def _given(entries: Mapping[str, InitialValue]) -> GivenValues:
    return GivenValues(
        {name: float(entry.value) for name, entry in entries.items()},
        frozenset(name for name, entry in entries.items() if entry.fixed),
    )
