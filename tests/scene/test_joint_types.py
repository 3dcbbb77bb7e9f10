"""A joint type that a scene may name is known to all who treat joints by their type."""

from __future__ import annotations

from typing import get_args

import pytest

from symgen.emission.model_page import JOINT_EQUATIONS
from symgen.joints import planar_rows, spatial_rows
from symgen.scene import Joint, SceneBuilder
from symgen.scene.checks.space import SPATIAL_JOINTS

UNION, _ = get_args(Joint)
TYPES = [get_args(record.model_fields["type"].annotation)[0] for record in get_args(UNION)]
PLACES = {*spatial_rows.TURNS, *spatial_rows.TRAVELS}  # joints that place a body by coordinates of their own


@pytest.mark.parametrize("kind", TYPES)
def test_every_joint_type_is_known_everywhere(kind: str) -> None:
    assert callable(getattr(SceneBuilder, kind))
    assert kind in {*spatial_rows.TYPES, *PLACES}
    assert (kind in SPATIAL_JOINTS) != (kind in planar_rows.TYPES)
    assert (kind in planar_rows.TYPES) == (kind in JOINT_EQUATIONS)
