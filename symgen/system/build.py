"""The end of the scene's journey: equations, parameters, topology and requests, which is all that later stages read.

What a scene asks of the later stages: which coordinates, which groups, which start.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from runtime.contract.consistent_state import GivenValues
from symgen.algebra.parameters import ParameterTable
from symgen.scene import BeamBody, InitialValue, SpatialModalBody, with_ends
from symgen.system.equations import Equations, blank_equations
from symgen.system.mechanism import Mechanism
from symgen.system.orientations import Orientations, orientations_of
from symgen.system.signals import input_units
from symgen.system.structure import structure_equations
from symgen.system.topology import Topology, topology_of

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


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


def requested_by(scene: SceneRecord) -> Requested:
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


def _independent(scene: SceneRecord) -> tuple[str, ...]:
    """Those that the scene names, and with them the coordinates of states."""
    named = scene.partition.independent or ()
    states = [f"{name}.integral" for name in scene.states]
    return (*named, *(name for name in states if name not in named)) if named else ()


def _states(scene: SceneRecord) -> dict[str, InitialValue]:
    """States at the start: rates of their coordinates."""
    return {f"{name}.integral": InitialValue(value=state.initial, fixed=True) for name, state in scene.states.items()}


def _given(entries: Mapping[str, InitialValue]) -> GivenValues:
    return GivenValues(
        {name: float(entry.value) for name, entry in entries.items()},
        frozenset(name for name, entry in entries.items() if entry.fixed),
    )


@dataclass(frozen=True)
class System:
    """A scene as the later stages see it.

    equations: in all coordinates. reduced: in those of the tree of bodies, with the same columns; in the plane, where
    all coordinates are the bodies' own, the same. orientations: those with velocities of their own; their columns
    follow the others in `reduced`.
    """

    equations: Equations
    reduced: Equations
    parameters: ParameterTable
    topology: Topology
    requested: Requested
    orientations: Orientations = field(default_factory=Orientations)


def build_system(scene: SceneRecord) -> System:
    """The system of a scene. Raises SceneError for quantities that cannot be read."""
    scene = with_ends(scene)
    table, topology, orientations = ParameterTable(scene), topology_of(scene), Orientations()
    if scene.structure is not None:
        equations = reduced = _with_inputs(structure_equations(scene, table), scene)
    elif scene.space == "planar":
        from symgen.system.planar import PlanarSpace

        blank = _blank(scene)
        plane = PlanarSpace(scene, table, blank, topology)
        equations = reduced = _with_inputs(Mechanism(scene, table, plane, blank, topology).equations, scene)
    else:
        from symgen.system.reduced import reduced_equations
        from symgen.system.spatial import SpatialSpace

        blank = _blank(scene)
        space = SpatialSpace(scene, table, blank, topology)
        built = Mechanism(scene, table, space, blank, topology)
        equations = _with_inputs(built.equations, scene)
        orientations = orientations_of(scene, topology)
        reduced = reduced_equations(built, space, orientations)
    return System(equations, reduced, table, topology, requested_by(scene), orientations)


def _with_inputs(equations: Equations, scene: SceneRecord) -> Equations:
    """The equations, their inputs now among the measures."""
    units = {**equations.measure_units, **input_units(scene)}
    return replace(equations, measures={**equations.measures, **equations.u}, measure_units=units)


def _blank(scene: SceneRecord) -> Equations:
    """With what is known of the bodies' shapes."""
    equations = replace(
        blank_equations(scene), flexible=[body.name for body in scene.bodies if isinstance(body, SpatialModalBody)]
    )
    beams = [body for body in scene.bodies if isinstance(body, BeamBody)]
    if beams:
        from symgen.bodies.beam_sets import set_records, static_residuals

        of_beams = {body.name: set_records(body) for body in beams}
        return replace(equations, static_residuals=static_residuals(scene), beams=of_beams)
    return equations
