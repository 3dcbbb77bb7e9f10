"""Bodies of solid meshes: a box in closed form, integrals against the deformed body, order of nodes, truncation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import skfem
from numpy.testing import assert_allclose

from symgen.fe import FEStructure, FlexibleBody, Material
from symgen.fe.inertia import inertia_integrals, nodal_inertia, scalar_mass
from symgen.fe.report import RigidCheck, body_report
from symgen.fe.stresses import solid_structure
from symgen.fe.structure import structure

pytestmark = pytest.mark.long

SIZE = np.array([0.3, 0.024, 0.012])
MATERIAL = Material(E=2.1e11, nu=0.3, rho=7850.0)
MASS = MATERIAL.rho * float(np.prod(SIZE))
FACES = {"left": lambda places: places[:, 0] < 1e-9, "right": lambda places: places[:, 0] > SIZE[0] - 1e-9}


def hexahedra(cells: int = 10) -> skfem.MeshHex:
    return skfem.MeshHex.init_tensor(
        np.linspace(0, SIZE[0], cells + 1), np.linspace(0, SIZE[1], 3), np.linspace(0, SIZE[2], 2)
    )


def tetrahedra(cells: int = 10) -> skfem.MeshTet:
    return skfem.MeshTet.init_tensor(
        np.linspace(0, SIZE[0], cells + 1), np.linspace(0, SIZE[1], 3), np.linspace(0, SIZE[2], 2)
    )


def body(**choices: object) -> FlexibleBody:
    return FlexibleBody.from_mesh(hexahedra(), MATERIAL, interface=FACES, **{"modes": 6, **choices})


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("mesh", [hexahedra(), tetrahedra()], ids=["hexahedra", "tetrahedra"])
def test_integrals_of_a_box(mesh: object, order: int) -> None:
    made = solid_structure(mesh, MATERIAL, order)
    integrals = inertia_integrals(made, np.zeros((made.n_dof, 0)), np.zeros(3))
    assert_allclose(integrals.mass, MASS, rtol=1e-12)
    assert_allclose(integrals.first_moment, MASS * SIZE / 2, rtol=1e-12)
    assert_allclose(integrals.moments, MASS * (np.outer(SIZE, SIZE) / 4 + np.diag(SIZE**2) / 12), rtol=1e-11)


def test_integrals_about_another_origin() -> None:
    middle = body(origin=SIZE / 2).integrals
    assert np.all(middle.first_moment == 0.0)  # exact zeros, not round-off
    assert np.count_nonzero(middle.moments) == 3
    assert_allclose(np.diag(middle.moments), MASS * SIZE**2 / 12, rtol=1e-11)
    assert_allclose(body(origin="right").markers["left"].position, [-SIZE[0], 0.0, 0.0], atol=1e-15)


@pytest.mark.parametrize(
    "choices", [{}, {"mode_set": "mixed", "fixed": ["left"]}, {"mode_set": "fixed_interface", "modes": 1}]
)
def test_integrals_give_the_moments_of_the_deformed_body(choices: dict[str, object]) -> None:
    """int (rho0 + u)_i (rho0 + u)_j dm and int (rho0 + u)_i v_j dm for random q_f, q_f' from the mass of the mesh."""
    made = body(origin=(0.01, -0.02, 0.03), **choices)
    rng = np.random.default_rng(1)
    q, q_dot = 1e-3 * rng.standard_normal((2, made.nf))
    mesh_mass = scalar_mass(made.structure)
    assert mesh_mass is not None
    place = made.structure.positions - made.origin + (made.modes.shapes @ q).reshape(-1, 3)
    velocity = (made.modes.shapes @ q_dot).reshape(-1, 3)
    these = made.integrals
    linear = np.einsum("aij,a->ij", these.rho_phi, q)
    moments = these.moments + linear + linear.T + np.einsum("abij,a,b->ij", these.phi_phi, q, q)
    mixed = np.einsum("aij,a->ij", these.rho_phi, q_dot) + np.einsum("abij,a,b->ij", these.phi_phi, q, q_dot)
    assert_allclose(moments, place.T @ mesh_mass @ place, atol=1e-9 * np.abs(moments).max())
    assert_allclose(mixed, place.T @ mesh_mass @ velocity, atol=1e-8 * np.abs(mixed).max())
    first_moment = these.first_moment + these.phi_integral @ q
    assert_allclose(first_moment, np.sum(mesh_mass @ place, axis=0), rtol=1e-9, atol=1e-12)
    assert_allclose(np.einsum("abii->ab", these.phi_phi), these.M_ff, atol=1e-9)


def test_free_modes_have_no_momentum() -> None:
    these = body().integrals
    assert np.all(these.phi_integral == 0.0)
    assert np.all(np.abs(these.rho_phi - np.swapaxes(these.rho_phi, 1, 2)) < 1e-14)


def test_bending_frequencies_of_a_slender_bar() -> None:
    """Free-free Euler-Bernoulli frequencies, lower by shear and rotary inertia: 0.5 % and 2.2 % at these sizes."""
    found = body(modes=2).frequencies
    thin = 22.373285 / SIZE[0] ** 2 * np.sqrt(MATERIAL.E / MATERIAL.rho / 12.0) / (2.0 * np.pi) * SIZE[[2, 1]]
    assert np.all(found < thin * [0.998, 0.98]) and np.all(found > thin * [0.994, 0.977])
    tets = FlexibleBody.from_mesh(tetrahedra(), MATERIAL, interface=FACES, modes=2).frequencies
    assert_allclose(tets, found, rtol=5e-3)


def test_linear_hexahedra_are_too_stiff_in_bending() -> None:
    assert body(order=1, modes=1).frequencies[0] > 1.5 * body(modes=1).frequencies[0]


@pytest.mark.parametrize("mesh", [hexahedra(20), tetrahedra(20)], ids=["hexahedra", "tetrahedra"])
@pytest.mark.parametrize("order", [1, 2])
def test_lumped_mass_is_positive_and_keeps_mass_and_centre(mesh: object, order: int) -> None:
    made = FlexibleBody.from_mesh(mesh, MATERIAL, order=order, mass="lumped", interface=FACES, modes=1)
    assert nodal_inertia(made.structure)[0].min() > 0.0
    assert made.structure.M.nnz == made.structure.n_dof
    assert_allclose(made.integrals.mass, MASS, rtol=1e-12)
    assert_allclose(made.integrals.first_moment, MASS * SIZE / 2, rtol=1e-9)
    exact = FlexibleBody.from_mesh(mesh, MATERIAL, order=order, interface=FACES, modes=1)
    assert_allclose(made.frequencies, exact.frequencies, rtol=0.02)


def permuted(made: FEStructure, seed: int) -> FEStructure:
    """The same model with its nodes and its rows in another order; ids stay with their nodes."""
    rng = np.random.default_rng(seed)
    nodes, rows = rng.permutation(len(made.ids)), rng.permutation(made.n_dof)
    place = np.argsort(nodes)
    return structure(
        made.K[rows][:, rows],
        made.M[rows][:, rows],
        made.ids[nodes],
        made.positions[nodes],
        place[made.node[rows]],
        made.component[rows],
    )


@pytest.mark.parametrize("choices", [{}, {"mode_set": "fixed_interface", "modes": 2}])
def test_the_order_of_nodes_does_not_matter(choices: dict[str, object]) -> None:
    first = body(**choices)
    other = FlexibleBody.from_structure(permuted(first.structure, 3), interface=FACES, **{"modes": 6, **choices})
    assert_allclose(other.modes.eigenvalues, first.modes.eigenvalues, rtol=1e-9)
    for name in ("phi_integral", "rho_phi", "phi_phi"):
        one, two = (getattr(each.integrals, name) for each in (first, other))
        assert np.array_equal(one == 0.0, two == 0.0)
        assert_allclose(two, one, atol=1e-9 * np.abs(one).max(initial=1e-30), err_msg=name)
    assert_allclose(other.markers["right"].shape, first.markers["right"].shape, atol=1e-8)


def test_the_same_input_gives_the_same_numbers() -> None:
    assert body().fields(0.01) == body().fields(0.01)


def test_truncation_loses_less_with_more_modes() -> None:
    losses = []
    for modes in (2, 4, 8, 16):
        made = body(mode_set="mixed", fixed=["left"], modes=modes)
        (loss,) = [one for one in made.losses() if one.name == "right"]
        losses.append(loss.loss)
    assert np.all(np.diff(losses, axis=0) < 1e-12)
    assert np.all(np.array(losses) > -1e-9)
    assert losses[-1][1] < 0.01 < losses[0][1] < 0.05  # Fy; the first bending mode has 97 % of the flexibility


def test_effective_masses_of_a_clamped_bar_add_up() -> None:
    made = body(mode_set="mixed", fixed=["left"], modes=30)
    shares = np.sum(made.integrals.phi_integral**2, axis=1) / MASS
    assert np.all(shares < 1.0) and np.all(shares > [0.8, 0.9, 0.9])
    report = made.report()
    assert f"{100 * shares[2]:.3g} %" in report and "6 zero modes" in report


def test_the_report_says_where_places_are_measured_from() -> None:
    """The mean of the left end's nodes is the middle of the section: a gauge at the mesh's z = 0 is not at z = 0."""
    report = body(origin="left").report()
    middle = f"{SIZE[1] / 2:.6g}, {SIZE[2] / 2:.6g}"
    assert f"measured from (0, {middle}) m of the mesh: left at (0, 0, 0)" in report
    assert f"right at ({SIZE[0]:.6g}, 0, 0)" in report
    assert "measured from (0, 0, 0) m" in body().report()


def test_a_marker_may_be_away_from_its_nodes() -> None:
    pin = (SIZE[0] + 0.02, 0.0, 0.0)
    plain, moved = body(), body(marker_positions={"right": pin})
    offset = np.array(pin) - plain.markers["right"].position
    one, two = plain.markers["right"], moved.markers["right"]
    assert_allclose(two.position, pin)
    assert_allclose(two.rotation, one.rotation, atol=1e-12)
    assert_allclose(two.shape, one.shape + np.cross(one.rotation, offset, axis=0), atol=1e-9)


def test_markers_follow_a_rigid_motion() -> None:
    made = body(marker_positions={"left": (0.1, 0.2, 0.3)})
    for part in made.interfaces.values():
        assert_allclose(part.average @ made.structure.rigid(part.position), np.eye(6), atol=1e-11)


def test_fields_are_plain_numbers() -> None:
    fields = body(modes=3).fields([0.01, 0.02, 0.0])
    assert list(fields) == [
        "mass",
        "first_moment",
        "inertia_moments",
        "M_ff",
        "K_ff",
        "D_ff",
        "phi_integral",
        "rho_phi",
        "phi_phi",
        "markers",
        "struts",
    ]
    assert np.shape(fields["phi_phi"]) == (3, 3, 3, 3) and np.shape(fields["rho_phi"]) == (3, 3, 3)
    omega = np.sqrt(np.diag(fields["K_ff"]))
    assert_allclose(np.diag(fields["D_ff"]), 2.0 * np.array([0.01, 0.02, 0.0]) * omega)
    marker = fields["markers"]["left"]
    assert np.shape(marker["shape"]) == np.shape(marker["rotation"]) == (3, 3)
    assert type(fields["mass"]) is float and type(marker["shape"][0][0]) is float


def test_a_structure_with_other_mass_is_not_a_scalar_one() -> None:
    made = solid_structure(hexahedra(2), MATERIAL, 1)
    M = made.M.tolil()
    M[0, 0] *= 1.001
    assert scalar_mass(made) is not None
    assert scalar_mass(replace(made, M=M.tocsr())) is None


def test_effective_masses_that_are_not_represented() -> None:
    """Shares 60 % and 30 % along x add up to 90 %; 10 % are left."""
    shares = np.array([[0.6, 0.0, 0.0], [0.3, 0.2, 0.0]])
    text = body_report("rod", np.array([1.0, 2.0]), shares, None, [], RigidCheck(6, 0.1, 1.0, 1e-9))
    assert "| sum |  | 90 % | 20 % | 0 % |" in text and "| not represented |  | 10 % | 80 % | 100 % |" in text
