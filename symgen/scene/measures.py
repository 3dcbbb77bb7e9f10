"""Measures: scalars of the motion that load expressions may use, with their rates ``<measure>_dot``."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from symgen.schema.fields import Coordinate, GaugeRef, MarkerRef, Name, StrictModel, refuse

ALL_GAUGES = "all"
OLDER = {"marker_b": "of", "marker": "of", "coordinate": "of", "gauge": "of", "marker_a": "relative_to"}


class _Measure(StrictModel):
    name: Name

    @model_validator(mode="before")
    @classmethod
    def _spelling(cls, data: Any) -> Any:
        older = [key for key in OLDER if isinstance(data, dict) and key in data]
        if older:
            raise refuse(f"is written '{OLDER[older[0]]}' in a measure", f"write {OLDER[older[0]]} = ...", older[0])
        return data

    @property
    def markers(self) -> dict[str, str]:
        """The markers that it names, by key."""
        return {}


class MarkerMeasure(_Measure):
    """From marker `relative_to` to marker `of`: the world components x, y, z [m] or the length [m] of r_b - r_a, or the
    angle phi_b - phi_a [rad].

    In space the angle is that about the z-axis of `relative_to`, between -pi and pi; between the markers of a joint
    with an angle of its own it is that angle, over any number of turns.
    """

    type: Literal["angle", "distance", "x", "y", "z"]
    of: MarkerRef
    relative_to: MarkerRef = "ground.origin"

    @property
    def markers(self) -> dict[str, str]:
        """From and to."""
        return {"relative_to": self.relative_to, "of": self.of}


class CoordinateMeasure(_Measure):
    """A coordinate itself [m, rad], for instance a mode or the second angle of a universal joint."""

    type: Literal["coordinate"] = "coordinate"
    of: Coordinate


class SectionForceMeasure(_Measure):
    """Normal force E A u', shear force -E I w''' [N] or bending moment E I w'' [N m] of a beam at a marker.

    In space also `shear_force_z`, `bending_moment_y`, which is -E I w_z'', and `torsion_moment` G J tau'. From its
    shapes: what the part beyond the marker does to the part before it. `Solution.section_forces` has what equilibrium
    says.
    """

    type: Literal[
        "normal_force", "shear_force", "bending_moment", "shear_force_z", "bending_moment_y", "torsion_moment"
    ]
    of: MarkerRef

    @property
    def markers(self) -> dict[str, str]:
        """On the beam."""
        return {"of": self.of}


class StressMeasure(_Measure):
    """Stress [Pa] of a finite-element body at a gauge `body.gauge` by its modes, in the body's axes.

    component: von_mises, or xx, yy, zz, yz, xz, xy. `body.all`: the largest von Mises stress of all its gauges.
    `Solution.stresses` has what equilibrium says.
    """

    type: Literal["stress"] = "stress"
    of: GaugeRef
    component: Literal["von_mises", "xx", "yy", "zz", "yz", "xz", "xy"] = "von_mises"


Measure = Annotated[
    MarkerMeasure | CoordinateMeasure | SectionForceMeasure | StressMeasure, Field(discriminator="type")
]
