"""Residual Jacobians of spherical loops along directions, against the ones with each dependent coordinate taken out."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np
import pytest

from symgen.condensed.condensation import Condensed
from symgen.kernels import held_multipliers, jacobians
from symgen.pipeline import derive
from symgen.scene import Scene, SceneBuilder
from symgen.system.build import build_system
from tests.derivation.test_force_changes import bent_chain


def twice_tied() -> Scene:
    """Three rigid bodies on universal joints, the last one tied to the ground and to a body that slides there."""
    builder, rng = SceneBuilder("tied", space="spatial").gravity(0.3, 0.5, -9.81), np.random.default_rng(2)
    builder.ground(markers={"near": {"position": [1.5, 0.2, 0.1]}})
    for k in range(4):
        ends = {name: {"position": rng.normal(size=3), "axis": rng.normal(size=3)} for name in ("start", "end", "side")}
        data = {"mass": 1.0 + k, "inertia": [0.2, 0.3, 0.4], "center_of_mass": rng.normal(size=3)}
        builder.rigid(f"link{k}", **data, markers=ends)
        near = f"link{k - 1}.end" if 0 < k < 3 else "ground.origin"
        builder.joint("universal" if k < 3 else "planar", f"joint{k}", near, f"link{k}.start")
    builder.spherical("first", "ground.near", "link2.end").spherical("second", "link2.side", "link3.end")
    return builder.build()


@pytest.mark.parametrize(
    "scene",
    [bent_chain(("universal", "revolute"), "spherical"), twice_tied()],
    ids=["bent chain", "two ties"],
)
def test_directions_give_the_jacobians_of_elimination(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    """At random positions and rates: the forms are equal whether or not these close the loops."""
    forms: list[tuple[ca.SX, ca.SX]] = []
    whole = held_multipliers.held_jacobians

    def kept(system: Condensed, q_i_ddot: Sequence[ca.SX]) -> list[tuple[ca.SX, ca.SX]]:
        assert system.reduced.tied_changes is not None and system.reduced.loop_rates
        forms.extend(whole(system, q_i_ddot))
        return forms

    monkeypatch.setattr(jacobians, "held_jacobians", kept)
    derive(scene, frozenset({"residual_jacobian"}))
    eliminated, directed = (ca.vertcat(*form) for form in forms)
    symbols = ca.symvar(ca.horzcat(eliminated, directed))
    function = ca.Function("both", [ca.vertcat(*symbols)], [eliminated, directed])
    table, rng = build_system(scene).parameters, np.random.default_rng(0)
    given = {str(own): entry.default for own, entry in zip(ca.vertsplit(table.vector()), table.entries, strict=True)}
    values = function([given.get(str(symbol), 0.4 * rng.normal()) for symbol in symbols])
    expected, found = (np.asarray(value) for value in values)
    size = found.shape[1]
    for part in (slice(size), slice(size, None)):
        assert np.max(np.abs(found[part] - expected[part])) <= 1e-13 * np.max(np.abs(expected[part])) > 0
