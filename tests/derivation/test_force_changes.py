"""Derivatives of inertia forces by composites, and of the rows of loops, against automatic differentiation."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from benchmarks.cases.rhs_pinocchio import skew_tree
from symgen.algebra.rows import Row
from symgen.scene import Scene, SceneRecord
from symgen.scenes import SCENES
from symgen.system.build import build_system
from tests.hand_derived.spatial.spatial_scenes import flexible
from tests.hand_derived.spatial.twin_flexible_nodes import scattered

ALL = ("revolute", "universal", "planar")


def bent_chain(kinds: tuple[str, ...], closing: str = "") -> SceneRecord:
    """Bodies of two modes each, every integral non-zero, on joints of some kinds between bent and turned ends.

    closing: type of a joint that ties the last one to the ground.
    """
    builder, rng = Scene("bent", space="spatial").gravity(0.3, 0.5, -9.81), np.random.default_rng(1)
    for k, kind in enumerate(kinds):
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
    if closing:
        builder.joint(closing, "closing", "ground.origin", f"link{len(kinds) - 1}.end")
    return builder.build()


@pytest.mark.every_push("tree of 8", "bricard")
@pytest.mark.parametrize(
    "scene",
    [skew_tree().scene, SCENES["bricard"](), SCENES["spatial_slider_crank"](), bent_chain(ALL)],
    ids=["tree of 8", "bricard", "slider-crank", "bent chain"],
)
def test_derivatives_of_inertia_forces(scene: SceneRecord) -> None:
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


def test_rates_of_loop_rows() -> None:
    """First and second derivative in time of C_q by the fields at both bent ends, against automatic differentiation."""
    system = build_system(bent_chain(ALL, "spherical"))
    eq, p = system.reduced, system.parameters.vector()
    columns = [column for column in range(len(eq.q)) if column not in eq.placed_columns]
    ((joint, known),) = eq.loop_rates.items()
    rows = [row.C_q for row in eq.constraints if row.joint == joint]
    q, rates = (ca.vertcat(*(source[column] for column in columns)) for source in (eq.q, eq.q_dot))
    a = ca.SX.sym("a", len(columns))
    entries = ca.vertcat(*(row.get(column, ca.SX(0)) for row in rows for column in columns))
    once = ca.jtimes(entries, q, rates)
    twice = ca.jtimes(once, ca.vertcat(q, rates), ca.vertcat(rates, a))
    found = known(dict(enumerate(eq.q_dot)), dict(zip(columns, ca.vertsplit(a), strict=True)))
    by_fields = [ca.vertcat(*(row.get(column, ca.SX(0)) for row in one for column in columns)) for one in found]
    function = ca.Function("both", [ca.vertcat(*eq.q), ca.vertcat(*eq.q_dot), a, p], [*by_fields, once, twice])
    rng, defaults = np.random.default_rng(0), np.array([entry.default for entry in system.parameters.entries])
    sizes = 0.3 * rng.normal(size=len(eq.q)), rng.normal(size=len(eq.q)), rng.normal(size=len(columns)), defaults
    values = [np.asarray(value) for value in function(*sizes)]
    for geometric, differentiated in zip(values[:2], values[2:], strict=True):
        assert np.max(np.abs(geometric - differentiated)) <= 1e-13 * np.max(np.abs(differentiated)) > 0
