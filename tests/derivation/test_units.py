"""Units by name: every row label of a joint type is either a distance or not, none is forgotten."""

from __future__ import annotations

from runtime.contract.units import LENGTH_ROWS, UNIT_ROWS, unit
from symgen.joints.planar_rows import TYPES as PLANAR
from symgen.joints.spatial_rows import TYPES as SPATIAL


def test_every_row_has_a_unit() -> None:
    labels = {label for types in (PLANAR, SPATIAL) for joint in types.values() for label in joint().labels}
    assert labels <= LENGTH_ROWS | UNIT_ROWS
    assert not LENGTH_ROWS & UNIT_ROWS


def test_units_of_coordinates() -> None:
    names = ("crank.x", "rod.q2", "crank.theta", "top.theta3", "hinge.angle1", "top.e0", "slide.travel")
    assert [unit(name) for name in names] == ["m", "m", "rad", "rad", "rad", "1", "m"]
    assert unit("crank.theta", 2) == "rad/s^2"
