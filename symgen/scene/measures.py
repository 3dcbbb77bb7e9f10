"""Measures: scalars of the motion that load expressions may use, with their rates ``<measure>_dot``."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from symgen.schema.fields import Coordinate, GaugeRef, MarkerRef, Name, StrictModel

ALL_GAUGES = "all"


class _Measure(StrictModel):
    name: Name
    marker_a: MarkerRef = "ground.origin"
    marker_b: MarkerRef


class AngleMeasure(_Measure):
    """phi_b - phi_a [rad]; in space the angle about marker a's z-axis, between -pi and pi.

    Between the markers of a joint with an angle of its own it is that angle, over any number of turns.
    """

    type: Literal["angle"] = "angle"


class DistanceMeasure(_Measure):
    """|r_b - r_a| [m]."""

    type: Literal["distance"] = "distance"


class XMeasure(_Measure):
    """World x-component of r_b - r_a [m]."""

    type: Literal["x"] = "x"


class YMeasure(_Measure):
    """World y-component of r_b - r_a [m]."""

    type: Literal["y"] = "y"


class ZMeasure(_Measure):
    """World z-component of r_b - r_a [m] (spatial scenes)."""

    type: Literal["z"] = "z"


class CoordinateMeasure(StrictModel):
    """A coordinate itself [m, rad], for instance a mode or the second angle of a universal joint."""

    type: Literal["coordinate"] = "coordinate"
    name: Name
    coordinate: Coordinate


class SectionForceMeasure(StrictModel):
    """Normal force E A u', shear force -E I w''' [N] or bending moment E I w'' [N m] of a beam at a marker.

    In space also `shear_force_z`, `bending_moment_y`, which is -E I w_z'', and `torsion_moment` G J tau'. From its
    shapes: what the part beyond the marker does to the part before it. `Solution.section_forces` has what equilibrium
    says.
    """

    type: Literal[
        "normal_force", "shear_force", "bending_moment", "shear_force_z", "bending_moment_y", "torsion_moment"
    ]
    name: Name
    marker: MarkerRef


class StressMeasure(StrictModel):
    """Stress [Pa] of a finite-element body at a gauge `body.gauge` by its modes, in the body's axes.

    component: von_mises, or xx, yy, zz, yz, xz, xy. `body.all`: the largest von Mises stress of all its gauges.
    `Solution.stresses` has what equilibrium says.
    """

    type: Literal["stress"] = "stress"
    name: Name
    gauge: GaugeRef
    component: Literal["von_mises", "xx", "yy", "zz", "yz", "xz", "xy"] = "von_mises"


Measure = Annotated[
    AngleMeasure
    | DistanceMeasure
    | XMeasure
    | YMeasure
    | ZMeasure
    | CoordinateMeasure
    | SectionForceMeasure
    | StressMeasure,
    Field(discriminator="type"),
]
