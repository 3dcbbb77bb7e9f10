"""Derivatives of inertia forces by composites against automatic differentiation of inverse dynamics."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from benchmarks.cases.rhs_pinocchio import skew_tree
from symgen.algebra.rows import Row
from symgen.scene import Scene, SceneBuilder
from symgen.scenes import SCENES
from symgen.system.build import build_system
from tests.hand_derived.spatial.spatial_scenes import flexible
from tests.hand_derived.spatial.twin_flexible_nodes import scattered


def bent_chain() -> Scene:
    """Three bodies of two modes each, every integral non-zero, on joints of all kinds between bent and turned ends."""
    builder, rng = SceneBuilder("bent", space="spatial").gravity(0.3, 0.5, -9.81), np.random.default_rng(1)
    for k, kind in enumerate(("revolute", "universal", "planar")):
        start, end = (
            {
                "position": rng.normal(size=3),
                "shape": rng.normal(size=(3, 2)),
                "rotation": rng.normal(size=(3, 2)),
                "axis": rng.normal(size=3),
            }
            for _ in range(2)
        )
        builder.flexible(f"link{k}", **flexible(scattered(7, 2, seed=k)), markers={"start": start, "end": end})
        near, far = f"link{k - 1}.end" if k else "ground.origin", f"link{k}.start"
        builder.joint(kind, f"joint{k}", *((far, near) if k == 1 else (near, far)))
    return builder.build()


@pytest.mark.parametrize(
    "scene",
    [skew_tree().scene, SCENES["bricard"](), SCENES["spatial_slider_crank"](), bent_chain()],
    ids=["tree of 8", "bricard", "slider-crank", "bent chain"],
)
def test_derivatives_of_inertia_forces(scene: Scene) -> None:
    """By q and by q', at random positions, rates and accelerations."""
    system = build_system(scene)
    eq, p = system.reduced, system.parameters.vector()
    columns = [column for column in range(len(eq.q)) if column not in eq.placed_columns]
    a = {column: ca.SX.sym(f"a_{column}") for column in columns}
    assert eq.inertia_forces is not None and eq.force_changes is not None
    force = eq.inertia_forces(a)
    values = ca.vertcat(*(force.get(column, ca.SX(0)) for column in columns))
    q, q_dot = (ca.vertcat(*(source[column] for column in columns)) for source in (eq.q, eq.q_dot))

    def dense(rows: list[Row]) -> ca.SX:
        return ca.vertcat(*(ca.horzcat(*(rows[i].get(j, ca.SX(0)) for j in columns)) for i in columns))

    K, D = (dense(rows) for rows in eq.force_changes(a))
    pairs = [(K, ca.jacobian(values, q)), (D, ca.jacobian(values, q_dot))]
    inputs = [ca.vertcat(*eq.q), ca.vertcat(*eq.q_dot), ca.vertcat(*a.values()), p]
    function = ca.Function("both", inputs, [value for pair in pairs for value in pair])
    rng, defaults = np.random.default_rng(0), np.array([entry.default for entry in system.parameters.entries])
    sizes = [0.3 * rng.normal(size=len(eq.q)), rng.normal(size=len(eq.q)), rng.normal(size=len(columns)), defaults]
    found = [np.asarray(value) for value in function(*sizes)]
    for composite, differentiated in (found[:2], found[2:]):
        assert np.max(np.abs(composite - differentiated)) <= 1e-13 * np.max(np.abs(differentiated)) > 0
