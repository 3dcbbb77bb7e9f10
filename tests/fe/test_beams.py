"""Bodies of frame beams: analytic frequencies, static exactness of Craig-Bampton modes, lumping, integrals."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import scipy.sparse as sp
from numpy.testing import assert_allclose

from symgen.fe import FEStructure, FlexibleBody, LineMesh, Material, Section
from symgen.fe.frame import frame_structure

LENGTH, WIDE, FLAT = 0.8, 0.016, 0.008
MATERIAL = Material(E=2.0e11, nu=0.25, rho=8000.0)
SECTION = Section.rectangle(WIDE, FLAT)
FREE_FREE = np.array([4.730040744862704, 7.853204624095838, 10.995607838001671])
CLAMPED_FREE = np.array([1.875104068711961, 4.694091132974175, 7.854757438237613])


def beam(elements: int = 40, direction: tuple[float, float, float] = (1.0, 0.0, 0.0)) -> LineMesh:
    along = np.linspace(0.0, LENGTH, elements + 1)[:, None] * np.array(direction)
    return LineMesh(along, [(k, k + 1) for k in range(elements)], SECTION)


def body(elements: int = 40, modes: int = 6, **choices: object) -> FlexibleBody:
    ends = {"left": [0], "right": [elements]}
    return FlexibleBody.from_mesh(beam(elements), MATERIAL, interface=ends, modes=modes, **choices)


def bending(roots: np.ndarray, second_moment: float) -> np.ndarray:
    return (roots / LENGTH) ** 2 * np.sqrt(MATERIAL.E * second_moment / (MATERIAL.rho * SECTION.area)) / (2.0 * np.pi)


@pytest.mark.parametrize(
    ("roots", "choices"), [(FREE_FREE, {"mode_set": "free"}), (CLAMPED_FREE, {"mode_set": "mixed", "fixed": ["left"]})]
)
def test_bending_frequencies_are_analytic(roots: np.ndarray, choices: dict[str, object]) -> None:
    found = body(**choices).frequencies
    expected = np.sort(np.concatenate([bending(roots, SECTION.I_y), bending(roots, SECTION.I_z)]))[:5]
    assert_allclose(found[:5], expected, rtol=1e-5)


def test_the_error_of_a_frequency_falls_with_the_fourth_power_of_the_element() -> None:
    exact = bending(FREE_FREE, SECTION.I_y)[0]
    coarse, fine = (body(elements, 1).frequencies[0] / exact - 1.0 for elements in (5, 10))
    assert 14.0 < coarse / fine < 18.0


def test_torsion_and_stretching_frequencies_are_analytic() -> None:
    found = body(modes=22).frequencies
    stretching = np.sqrt(MATERIAL.E / MATERIAL.rho) / (2.0 * LENGTH)
    polar = SECTION.I_y + SECTION.I_z
    torsion = np.sqrt(MATERIAL.G * SECTION.torsion / (MATERIAL.rho * polar)) / (2.0 * LENGTH)
    for expected in (stretching, torsion):
        assert np.min(np.abs(found / expected - 1.0)) < 1e-3  # linear elements: (pi h / L)^2 / 24


def test_torsion_constant_of_a_square() -> None:
    assert_allclose(Section.rectangle(2.0, 2.0).torsion, 0.140577 * 16.0, rtol=2e-3)


def deflections(structure: FEStructure, force: np.ndarray) -> np.ndarray:
    """The full model clamped at node 0."""
    K = structure.K.toarray()[6:, 6:]
    return np.concatenate([np.zeros(6), np.linalg.solve(K, force[6:])])


@pytest.mark.parametrize("component", range(6))
def test_craig_bampton_modes_are_statically_exact(component: int) -> None:
    """Held at one interface and loaded at the other, the reduced body moves there as the full model does."""
    reduced = body(elements=15, modes=0, mode_set="fixed_interface")
    force = np.zeros(reduced.structure.n_dof)
    force[6 * 15 + component] = 1000.0
    full = deflections(reduced.structure, force)[-6:]
    basis = np.hstack([reduced.modes.shapes, reduced.structure.rigid(np.zeros(3))])
    K = basis.T @ reduced.structure.K @ basis
    left, right = basis[:6], basis[-6:]
    held = np.block([[K, left.T], [left, np.zeros((6, 6))]])
    moved = np.linalg.solve(held, np.concatenate([1000.0 * right[component], np.zeros(6)]))[: basis.shape[1]]
    assert_allclose(right @ moved, full, rtol=0.0, atol=1e-9 * np.abs(full).max())
    (loss,) = [one for one in reduced.losses() if one.name == "right, left held"]
    assert_allclose(loss.full[component] * 1000.0, full[component], rtol=1e-9)
    assert abs(loss.loss[component]) < 1e-9


def test_craig_bampton_removes_six_rigid_modes() -> None:
    reduced = body(elements=15, modes=3, mode_set="fixed_interface")
    assert reduced.nf == 12 + 3 - 6
    rigid = reduced.structure.rigid(np.zeros(3))
    assert np.abs(rigid.T @ reduced.structure.M @ reduced.modes.shapes).max() < 1e-12
    assert_allclose(reduced.frequencies[:2], body(elements=15).frequencies[:2], rtol=5e-3)


@pytest.mark.parametrize("mass", ["consistent", "lumped"])
@pytest.mark.parametrize("choices", [{}, {"mode_set": "fixed_interface"}, {"mode_set": "mixed", "fixed": ["right"]}])
def test_modes_are_orthonormal_in_the_mass(choices: dict[str, object], mass: str) -> None:
    made = body(elements=20, modes=5, mass=mass, **choices)
    phi = made.modes.shapes
    assert_allclose(phi.T @ made.structure.M @ phi, np.eye(made.nf), atol=1e-10)
    K_ff = phi.T @ made.structure.K @ phi
    assert_allclose(K_ff, np.diag(made.modes.eigenvalues), atol=1e-9 * K_ff.max())
    assert_allclose(np.einsum("abii->ab", made.integrals.phi_phi), made.integrals.M_ff, atol=1e-9)


def test_lumped_mass_nears_the_consistent_one_with_the_square_of_the_element() -> None:
    gaps = [
        body(elements, 1, mass="lumped").frequencies[0] / body(elements, 1).frequencies[0] - 1.0
        for elements in (10, 20)
    ]
    assert gaps[0] < 0.0 and 3.5 < gaps[0] / gaps[1] < 4.5
    heavy, light = body(20, 1), body(20, 1, mass="lumped")
    assert_allclose(light.integrals.mass, heavy.integrals.mass, rtol=1e-13)
    assert_allclose(light.integrals.first_moment, heavy.integrals.first_moment, atol=1e-14)


def test_integrals_of_a_straight_beam() -> None:
    made = body(modes=5, mode_set="mixed", fixed=["left"])
    integrals = made.integrals
    mass = MATERIAL.rho * SECTION.area * LENGTH
    assert_allclose(integrals.mass, mass, rtol=1e-13)
    assert_allclose(integrals.first_moment, [0.5 * mass * LENGTH, 0.0, 0.0], rtol=1e-13)
    tensor = np.trace(integrals.moments) * np.eye(3) - integrals.moments
    polar = MATERIAL.rho * (SECTION.I_y + SECTION.I_z) * LENGTH
    assert_allclose(np.diag(tensor), [polar, mass * LENGTH**2 / 3, mass * LENGTH**2 / 3], rtol=1e-9)
    # mode 1 bends in z, mode 2 in y: int phi dm and int x phi dm of the clamped beam are known
    root, share = CLAMPED_FREE[0], 0.782991756
    for a, axis in ((0, 2), (1, 1)):
        assert_allclose(abs(integrals.phi_integral[axis, a]), np.sqrt(mass) * share, rtol=1e-5)
        assert_allclose(abs(integrals.rho_phi[a, 0, axis]), np.sqrt(mass) * LENGTH * 2.0 / root**2, rtol=1e-3)
        assert_allclose(integrals.phi_phi[a, a, axis, axis], 1.0, rtol=1e-3)
    assert np.count_nonzero(integrals.phi_integral[:, 0]) == 1  # structural zeros are exact


@pytest.mark.parametrize("modes", [2, 4])
def test_products_of_shapes_near_those_of_a_fine_mesh(modes: int) -> None:
    """An arch bends in all directions; the nodal masses with their first moments do well on few elements."""

    def arch(elements: int) -> FlexibleBody:
        angle = np.linspace(0.0, 2.0, elements + 1)
        nodes = np.column_stack([np.sin(angle), np.cos(angle), 0.1 * angle])
        return FlexibleBody.from_mesh(
            LineMesh(nodes, [(k, k + 1) for k in range(elements)], SECTION),
            MATERIAL,
            interface={"end": [0]},
            modes=modes,
        )

    fine, errors = arch(160).integrals, []
    for elements in (10, 20):
        coarse = arch(elements).integrals
        errors.append(
            [
                np.abs(getattr(coarse, name) - getattr(fine, name)).max() / np.abs(getattr(fine, name)).max()
                for name in ("rho_phi", "phi_phi")
            ]
        )
    assert np.all(np.array(errors[0]) < 0.04) and np.all(np.array(errors[1]) < 0.3 * np.array(errors[0]))


def test_an_offset_mass_is_where_it_is() -> None:
    """A point mass fixed to the last node at an offset, as programs write it into M: products exact."""
    mass, offset = 3.0, np.array([0.02, -0.05, 0.03])
    base = frame_structure(beam(10), MATERIAL)
    arm = np.array([[0.0, offset[2], -offset[1]], [-offset[2], 0.0, offset[0]], [offset[1], -offset[0], 0.0]])
    moved = np.zeros((3, base.n_dof))
    moved[:, -6:] = np.hstack([np.eye(3), arm])  # u + theta x offset
    choices = {"interface": {"left": [0], "right": [10]}, "modes": 3, "mode_set": "mixed", "fixed": ["left"]}
    light = replace(base, M=sp.csr_matrix(1e-9 * base.M))
    made = FlexibleBody.from_structure(replace(light, M=sp.csr_matrix(light.M + mass * moved.T @ moved)), **choices)
    phi = moved @ made.modes.shapes
    place = np.array([LENGTH, 0.0, 0.0]) + offset
    assert_allclose(made.integrals.first_moment, mass * place, rtol=1e-7)
    assert_allclose(made.integrals.rho_phi, mass * np.einsum("i,ja->aij", place, phi), atol=1e-7)
    assert_allclose(made.integrals.phi_phi, mass * np.einsum("ia,jb->abij", phi, phi), atol=1e-7)


def test_the_direction_of_a_beam_does_not_matter() -> None:
    third = tuple(np.array([2.0, 3.0, 6.0]) / 7.0)
    turned = FlexibleBody.from_mesh(beam(20, third), MATERIAL, interface={"left": [0], "right": [20]}, modes=6)
    assert_allclose(turned.frequencies, body(20).frequencies, rtol=1e-8)
    assert_allclose(
        np.linalg.eigvalsh(turned.integrals.moments),
        np.linalg.eigvalsh(body(20).integrals.moments),
        rtol=1e-9,
        atol=1e-12,
    )


def test_torsion_counts_in_the_products_of_shapes() -> None:
    """A twisting straight beam moves no node, yet its mass moves; M knows the polar inertia, y and z share it."""
    made = body(modes=14)
    (twist,) = [a for a in range(14) if np.abs(made.markers["right"].rotation[0, a]) > 1.0]
    products = made.integrals.phi_phi[twist, twist]
    assert_allclose(products, np.diag([0.0, 0.5, 0.5]), atol=1e-9)


def test_a_frame_with_a_corner_is_stiff_at_the_corner() -> None:
    nodes = [(0.0, 0.0, 0.0), (0.2, 0.0, 0.0), (0.4, 0.0, 0.0), (0.4, 0.0, 0.2)]
    mesh = LineMesh(nodes, [(0, 1), (1, 2), (2, 3)], SECTION)
    structure = frame_structure(mesh, MATERIAL)
    force = np.zeros(24)
    force[18 + 1] = 1.0  # along y at the end of the short leg: bends both legs and twists the long one
    a, b = 0.4, 0.2
    expected = (a**3 + b**3) / (3.0 * MATERIAL.E * SECTION.I_z) + b**2 * a / (MATERIAL.G * SECTION.torsion)
    assert_allclose(deflections(structure, force)[19], expected, rtol=1e-9)
