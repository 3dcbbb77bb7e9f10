"""Named fields of a state."""

from __future__ import annotations

import casadi as ca
import pytest

from runtime.engine.program import Layout, make_stage


def test_a_stage_that_gives_a_field_of_another_size_is_refused() -> None:
    """Compiled code would write what stands behind it to other places."""
    layout = Layout({"x": 2, "n": 1})
    with pytest.raises(ValueError, match=r"fields of z have other sizes than the layout: x \(3\)"):
        make_stage("wrong", layout, 1, lambda z, c: {"x": ca.vertcat(z["x"], c)})
    stage = make_stage("right", layout, 1, lambda z, c: {"x": 2 * z["x"], "n": z["n"] + 1})
    assert stage.stage(ca.DM([1, 2, 3]), ca.DM(0)).full().ravel().tolist() == [2, 4, 4]
