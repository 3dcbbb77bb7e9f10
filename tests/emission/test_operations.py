"""Operation counts of M_hat and Q_hat: regression budgets, and small models against code written by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest

from benchmarks.cases.rhs_pinocchio import skew_chain, skew_tree
from runtime import load_model
from runtime.contract.tape import arithmetic, as_function
from symgen.generate import generate
from symgen.pipeline import derive
from symgen.scene import Scene, SceneRecord
from symgen.scenes import SCENES, generated_folder
from symgen.scenes.pendulums import chain
from symgen.scenes.spatial import spatial_chain
from tests.hand_derived.spatial.spatial_scenes import flexible
from tests.hand_derived.spatial.twin_flexible_nodes import scattered
from tests.support.scenes import on_hinge

pytestmark = pytest.mark.long

CONDENSED = frozenset({"condensed"})


def slider_crank(rod: Scene, end: str, start: str, modes: int) -> SceneRecord:
    rod.rigid("crank", mass=0.36, inertia=0.002, center_of_mass=(0.075, 0), markers={"tip": {"position": (0.15, 0)}})
    rod.rigid("slider", mass=0.07, inertia=1e-4)
    rod.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", start)
    rod.prismatic("slide", "ground.origin", "slider.origin").revolute("C", end, "slider.origin")
    rod.independent("crank.theta", *[f"rod.q{k + 1}" for k in range(modes)]).initial({"crank.theta": 0.3})
    return rod.build()


def two_pinned_modes() -> SceneRecord:
    rod = Scene("pinned").beam(
        "rod",
        length=0.3,
        density=7870.0,
        area=6.4e-5,
        second_moment=3.4e-10,
        youngs_modulus=2e11,
        lateral={"ends": "pinned-pinned", "modes": 2},
    )
    return slider_crank(rod, "rod.end", "rod.start", 2)


def four_general_modes() -> SceneRecord:
    """Every integral and every tip shape non-zero, mass and stiffness matrices full."""
    rng = np.random.default_rng(0)
    half = rng.normal(size=(4, 4))
    M_ff = half @ half.T + 4 * np.eye(4)
    turn = 0.1 * (half - half.T)
    rod = Scene("general").modal(
        "rod",
        mass=10.0,
        first_moment=(0.2, 0.0),
        inertia=10.0,
        M_ff=M_ff,
        K_ff=3 * M_ff,
        phi_integral=0.1 * rng.normal(size=(2, 4)),
        rho_dot_phi=0.1 * rng.normal(size=4),
        rho_cross_phi=0.1 * rng.normal(size=4),
        phi_cross_phi=turn,
        markers={"end": {"position": (0.3, 0), "shape_x": rng.normal(size=4), "shape_y": rng.normal(size=4)}},
    )
    return slider_crank(rod, "rod.end", "rod.origin", 4)


@pytest.mark.parametrize(
    ("scene", "budget"),
    [
        (two_pinned_modes(), 112),
        (four_general_modes(), 498),
        (chain(10), 428),
        (chain(10, 2), 2426),
    ],
    ids=["two pinned modes", "four general modes", "rigid chain of 10", "flexible chain of 10"],
)
def test_condensed_equations_stay_within_their_budget(scene: SceneRecord, budget: int) -> None:
    assert derive(scene, CONDENSED).tapes["condensed"].operations <= budget


def off_its_centre() -> SceneRecord:
    """A free body whose centre of mass is not its origin; Newton and Euler about the origin take 138 operations."""
    builder = Scene("off", space="spatial").gravity(0, 0, -9.81)
    inertia: dict[str, Any] = {"inertia": [0.31, 0.24, 0.19], "products": [0.02, -0.03, 0.04]}
    return builder.rigid("body", mass=2.0, center_of_mass=[0.2, -0.1, 0.17], free=True, **inertia).build()


def dense_spatial_chain() -> SceneRecord:
    """Ten links of two modes each with every shape integral and every tip shape non-zero, on spherical joints."""
    builder, rng = Scene("dense", space="spatial").gravity(0, 0, -9.81), np.random.default_rng(1)
    for k in range(10):
        end = {"position": rng.normal(size=3), "shape": rng.normal(size=(3, 2))}
        builder.flexible(f"link{k + 1}", **flexible(scattered(7, 2, seed=k)), orientation="zyx", markers={"end": end})
        builder.joint("spherical", f"joint{k + 1}", f"link{k}.end" if k else "ground.origin", f"link{k + 1}.origin")
    return builder.build()


@pytest.mark.parametrize(
    ("scene", "budget"),
    [
        (spatial_chain(10), 1877),
        (spatial_chain(10, 2), 11_680),
        (dense_spatial_chain(), 16_718),
    ],
    ids=["rigid chain of 10", "flexible chain of 10", "general flexible chain of 10"],
)
def test_spatial_equations_stay_within_their_budget(scene: SceneRecord, budget: int) -> None:
    """Balls pass forces in world axes; modes turn a body only where its joint holds it."""
    assert derive(scene, CONDENSED).tapes["condensed"].operations <= budget


@pytest.mark.parametrize(
    ("scene", "function", "budget"),
    [
        (off_its_centre(), "condensed", 138),
        (skew_tree().scene, "condensed", 1758),
        (skew_tree().scene, "forward_dynamics", 1879),
        (skew_chain(20).scene, "forward_dynamics", 6905),
        (SCENES["flyball_governor"](), "condensed", 124),
        (SCENES["bricard"](), "condensed", 636),
        (SCENES["spatial_slider_crank"](), "condensed", 2269),
        (skew_tree().scene, "residual_jacobian", 4320),
        (SCENES["bricard"](), "residual_jacobian", 1788),
        (SCENES["bricard"](), "dQ_hat_dq_i", 1606),
        (SCENES["n_four_bar"](), "dQ_hat_dq_i_dot", 148),
        (SCENES["spatial_slider_crank"](), "residual_jacobian", 8139),
        (chain(10), "residual_jacobian", 799),
        (chain(10), "dQ_hat_dq_i", 391),
    ],
    ids=[
        "free body off its centre, as by hand",
        "tree of 8",
        "accelerations of the tree of 8",
        "accelerations of a chain of 20",
        "governor",
        "bricard",
        "slider-crank",
        "Jacobian of the tree of 8",
        "Jacobian of bricard",
        "dQ_hat/dq of bricard",
        "dQ_hat/dq' of the four-bar",
        "Jacobian of the slider-crank",
        "Jacobian of the planar chain of 10",
        "dQ_hat/dq of the planar chain of 10",
    ],
)
def test_arithmetic_stays_within_its_budget(scene: SceneRecord, function: str, budget: int) -> None:
    """Pinocchio's CasADi code of the tree has 3,864 for its accelerations."""
    assert derive(scene, frozenset({function})).tapes[function].operations <= budget


def test_tree_accelerations_grow_linearly() -> None:
    """Topology-ordered elimination: 241 operations a body with two modes, 265 for each further one."""
    counts = {
        links: derive(chain(links, 2), frozenset({"forward_dynamics"})).tapes["forward_dynamics"].operations
        for links in (5, 10, 15)
    }
    assert counts[10] <= 241 * 10
    assert counts[15] - counts[10] == counts[10] - counts[5] <= 5 * 265


def tree_of_eight(space: str, rubs: set[int]) -> SceneRecord:
    """Two links on the end of each, hinged; friction in the hinges `rubs`."""
    builder, spatial = Scene("tree", space=space).gravity(0.0, -9.81), space == "spatial"
    inertia = {"inertia": [0.02, 0.08, 0.09]} if spatial else {"inertia": 0.08}
    tip = {"position": [1.0, 0.1, 0.2], "axis": [0.3, 0.4, 0.5]} if spatial else {"position": [1.0, 0.1]}
    for k in range(8):
        builder.rigid(f"link{k}", mass=1.0, center_of_mass=[0.5, 0.0], markers={"tip": tip}, **inertia)
        friction = {"friction": {"coulomb": 1.0}} if k in rubs else {}
        before = f"link{(k - 1) // 2}.tip" if k else "ground.origin"
        builder.revolute(f"hinge{k}", before, f"link{k}.origin", **friction)
    return builder.build()


@pytest.mark.parametrize(("space", "share"), [("planar", 0.046), ("spatial", 0.003)])
def test_the_price_of_a_joint_that_sticks(space: str, share: float) -> None:
    """Of accelerations, at the root, in the middle, at a tip. In a plane angles are absolute: 16 operations and the
    law's 4, of 443; in space one product, the square of the mode, and the law's 2, of 1,573."""

    def operations(rubs: set[int]) -> int:
        found = derive(tree_of_eight(space, rubs), frozenset({"forward_dynamics"}))
        return found.tapes["forward_dynamics"].operations

    free = operations(set())
    assert all(operations({k}) - free <= share * free for k in (0, 3, 7))


def test_chains_in_space_that_stick_grow_linearly() -> None:
    """The recursion of articulated bodies, 432 operations a link with friction in each hinge."""
    counts = []
    for n in (26, 28):
        builder, before = Scene("long", space="spatial").gravity(0.0, -9.81), "ground.origin"
        for k in range(n):
            tip = {"position": [1.0, 0.1, 0.2], "axis": [0.3, 0.4, 0.5]}
            builder.rigid(f"link{k}", mass=1.0, inertia=[0.02, 0.08, 0.09], markers={"tip": tip})
            builder.revolute(f"hinge{k}", before, f"link{k}.origin", friction={"coulomb": 1.0})
            before = f"link{k}.tip"
        found = derive(builder.build(), frozenset({"forward_dynamics"}))
        counts.append(found.tapes["forward_dynamics"].operations)
    assert counts[0] <= 432 * 26
    assert counts[1] - counts[0] <= 2 * 432


def hand_pendulum() -> ca.Function:
    """J a = g m a cos(theta), with J and g m a given."""
    q_i, J, weight = ca.SX.sym("q_i"), ca.SX.sym("J"), ca.SX.sym("weight")
    return ca.Function("hand", [q_i, J, weight], [J, weight * ca.cos(q_i)])


def hand_double_pendulum() -> ca.Function:
    """The twin's formulas with their constants given: J_1 + m_2 l^2, h = m_2 l a_2, J_2, and the two weights."""
    q_i, v = ca.SX.sym("q_i", 2), ca.SX.sym("v", 2)
    J_1, h, J_2, weight_1, weight_2 = (ca.SX.sym(name) for name in ("J_1", "h", "J_2", "w_1", "w_2"))
    angle = q_i[1] - q_i[0]
    off, turn = h * ca.cos(angle), h * ca.sin(angle)
    M_hat = ca.vertcat(ca.horzcat(J_1, off), ca.horzcat(off, J_2))
    Q_hat = ca.vertcat(turn * v[1] ** 2 + weight_1 * ca.cos(q_i[0]), weight_2 * ca.cos(q_i[1]) - turn * v[0] ** 2)
    return ca.Function("hand", [q_i, v, J_1, h, J_2, weight_1, weight_2], [M_hat, Q_hat])


@pytest.mark.parametrize(
    ("name", "hand"),
    [("pendulum", hand_pendulum()), ("double_pendulum", hand_double_pendulum())],
    ids=["pendulum", "double pendulum"],
)
def test_small_models_cost_no_more_than_code_written_by_hand(name: str, hand: ca.Function) -> None:
    assert load_model(generated_folder(name)).kernel("condensed").n_instructions() <= hand.n_instructions()


@pytest.mark.parametrize("name", SCENES)
def test_stamped_counts_are_the_counts_of_the_loaded_functions(name: str) -> None:
    model = load_model(generated_folder(name))
    assert model.operations == {key: arithmetic(build()) for key, build in model.builders.items()}


def test_planar_scenes_pay_only_for_what_they_have(tmp_path: Path) -> None:
    """Without gravity, damping or motion the kernels do not take what they do not need."""
    plain = on_hinge("plain", "rod", "hinge", mass=1.0, inertia=0.1)
    model = load_model(generate(plain.build(), tmp_path / "plain"))
    assert model.kernel("condensed").name_in() == ["c"]
    assert model.operations["condensed"] == 0


def test_products_grow_with_the_length() -> None:
    """Accelerations with their derivative along one direction in O(N): the same again for each five links."""
    counts = []
    for links in (5, 10, 15):
        found = as_function(
            "dynamics", derive(chain(links, 2), frozenset({"forward_dynamics"})).tapes["forward_dynamics"]
        )
        symbols = {name: ca.SX.sym(name, found.size1_in(name)) for name in found.name_in()}
        along = [ca.SX.sym(name, symbols[name].numel()) for name in ("q_i", "q_i_dot")]
        a = ca.vertcat(*found.call(list(symbols.values())))
        product = sum(ca.jtimes(a, symbols[name], to) for name, to in zip(("q_i", "q_i_dot"), along, strict=True))
        together = ca.Function("product", [*symbols.values(), *along], ca.cse([ca.densify(a), ca.densify(product)]))
        counts.append(arithmetic(together))
    assert counts[2] - counts[1] == counts[1] - counts[0] <= 4300
