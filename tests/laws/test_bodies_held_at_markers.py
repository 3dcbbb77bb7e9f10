"""Bodies with many modes that a joint holds at a marker which the modes move and turn."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace

import casadi as ca
import numpy as np
import pytest

from runtime.model import Model
from symgen.bodies.spatial_moments import SpatialIntegrals, SpatialPoint
from symgen.scene import Scene, SceneRecord
from symgen.scenes.spatial import ROD
from tests.hand_derived.spatial.spatial_scenes import flexible
from tests.hand_derived.spatial.twin_flexible_nodes import Nodes, scattered
from tests.support.model_values import (
    Array,
    augmented_solution,
    condensed_accelerations,
    random_states,
    relative_error,
)

CONDENSED = frozenset({"condensed", "closure", "velocities", "accelerations", "augmented", "constraints"})


def entries(values: Array) -> list:
    """As nested lists of numbers of the derivation."""
    return ca.SX(float(values)) if values.ndim == 0 else [entries(row) for row in values]


def integrals(nodes: Nodes) -> SpatialIntegrals:
    found = {key: np.asarray(value) for key, value in flexible(nodes).items()}
    names = ("mass", "first_moment", "inertia_moments", "phi_integral", "rho_phi", "phi_phi", "M_ff", "K_ff", "D_ff")
    mass, S1, J0, Sb, N, P, *matrices = (
        entries(found[key].T if key == "phi_integral" else found[key]) for key in names
    )
    return SpatialIntegrals(mass, S1, J0, Sb, N, P, *matrices, [], [])


def numbers(found: SpatialIntegrals) -> Array:
    flat = ca.vertcat(
        *(value for value in _flat([getattr(found, key) for key in ("S1", "J0", "Sb", "N", "P", "M_ff")]))
    )
    return np.array(ca.Function("numbers", [], [flat])()["o0"]).ravel()


def _flat(values: object) -> list:
    return [one for value in values for one in _flat(value)] if isinstance(values, list) else [values]


def test_integrals_about_a_node_that_the_modes_move() -> None:
    """Every node seen from one of them: its place and its shapes less those of that one."""
    nodes = scattered(7, 3)
    x, phi = nodes.positions[4], nodes.shapes[4]
    point = SpatialPoint(entries(x), entries(phi.T), entries(0 * phi.T), [], entries(np.eye(3)), entries(np.eye(4)[0]))
    seen = replace(nodes, positions=nodes.positions - x, shapes=nodes.shapes - phi)
    assert np.abs(numbers(integrals(nodes).about(point)) - numbers(integrals(seen))).max() < 1e-14


@pytest.mark.every_push("balls")
@pytest.mark.parametrize("kinds", [("cylindrical", "revolute"), ("spherical", "spherical")], ids=["hinges", "balls"])
def test_rod_held_at_its_end(
    build: Callable[[SceneRecord, frozenset[str] | None], Model], kinds: tuple[str, str]
) -> None:
    """A rod of six modes hangs by its small end, a weight from its big end, all three turned against each other:

    (38) by the recursions, with twists that come to the rod and shares in the turns of its ends, is (28) by the
    templates in all coordinates.
    """
    data = json.loads(ROD.read_text(encoding="utf-8"))
    data["markers"]["small_end"] |= {"axis": [0.1, 0.2, 1], "x_axis": [0, -1, 0]}
    builder = Scene("rod", space="spatial").gravity(0.2, -0.4, -9.81)
    builder.flexible("rod", **data)
    hook = {"position": [0.1, 0.05, 0], "axis": [0, 1, 1], "x_axis": [1, 0, 0]}
    builder.rigid("weight", mass=0.3, inertia=[1e-3, 2e-3, 2.5e-3], markers={"hook": hook})
    builder.joint(kinds[0], "top", "ground.origin", "rod.small_end")
    builder.joint(kinds[1], "elbow", "rod.big_end", "weight.hook")
    model = build(builder.build(), CONDENSED)
    for state in random_states(model, 2):
        q_ddot, _ = augmented_solution(model, state)
        assert relative_error(condensed_accelerations(model, state), q_ddot) < 1e-9
