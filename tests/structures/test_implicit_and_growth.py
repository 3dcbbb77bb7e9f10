"""Generalised-alpha by its order, energy and damping; growth of steps by regions against all eigenvalues."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.sparse as sp

from runtime.structures import LinearStructure, StructureError, StructureModel
from runtime.structures.generalised_alpha import NEWMARK, Coefficients, GeneralisedAlpha, hht
from runtime.structures.regions import Group, Regions, choose_regions
from runtime.structures.stability import growth
from runtime.structures.structure import Load
from tests.structures.bars import bar, two_regions


@pytest.mark.parametrize(
    "coefficients", [Coefficients.of(0.0), Coefficients.of(0.8), Coefficients.of(1.0), NEWMARK, hht(-0.1)]
)
def test_order_two_with_consistent_mass_damping_and_load(coefficients: Coefficients) -> None:
    """Two coupled masses, driven; right values by the matrix exponential of the first-order system with its load as
    states.
    """
    from scipy.linalg import expm

    M, K, D = (
        np.array([[2.0, 0.5], [0.5, 1.0]]),
        np.array([[30.0, -8.0], [-8.0, 20.0]]),
        np.array([[0.4, 0.1], [0.1, 0.2]]),
    )
    structure = LinearStructure(
        K, sp.csr_matrix(M), damping=D, mass_damping=0.1,
        loads=(Load(np.array([1.0, -2.0]), 0),), laws=lambda t: np.sin(3 * t)[:, None], law_texts=("sin(3 * t)",),
    )  # fmt: skip
    A = np.zeros((6, 6))
    A[:2, 2:4] = np.eye(2)
    A[2:4, :2], A[2:4, 2:4] = -np.linalg.solve(M, K), -np.linalg.solve(M, D + 0.1 * M)
    A[2:4, 4] = np.linalg.solve(M, [1.0, -2.0])
    A[4, 5], A[5, 4] = 3.0, -3.0  # s' = 3 c, c' = -3 s
    right = (expm(2 * A) @ np.array([0.1, 0.0, 0.0, 1.0, 0.0, 1.0]))[:2]
    errors = []
    for count in (200, 400, 800):
        step = GeneralisedAlpha(structure, 2 / count, coefficients)
        step.start(np.array([0.1, 0.0]), np.array([0.0, 1.0]))
        step.advance(count)
        errors.append(np.abs(step.x - right).max())
    assert np.all(np.abs(np.log2(np.array(errors[:-1]) / errors[1:]) - 2) < 0.1)
    assert errors[-1] < 2e-4


def test_spectral_radius_is_rho_inf_at_high_frequency() -> None:
    for rho in (0.0, 0.5, 0.9):
        structure = LinearStructure(np.array([[1e12]]), [1.0])
        step = GeneralisedAlpha(structure, 1.0, Coefficients.of(rho))
        step.start(np.array([1.0]), np.array([0.0]))
        sizes = []
        for _ in range(60):
            step.advance(1)
            sizes.append(abs(step.rates[0]) + 1e-300)
        assert (sizes[59] / sizes[39]) ** (1 / 20) == pytest.approx(rho, abs=0.06)


def test_average_acceleration_keeps_the_energy() -> None:
    structure = two_regions()
    step = GeneralisedAlpha(structure, 0.5, NEWMARK)
    step.start(np.random.default_rng(0).standard_normal(structure.size), np.zeros(structure.size))
    before = sum(step.energy())
    step.advance(500)
    assert sum(step.energy()) == pytest.approx(before, rel=1e-9)


def test_run_of_a_slow_load_agrees_with_the_explicit_one() -> None:
    K, M = bar(np.ones(20))
    load = Load(np.eye(20)[-1], 0)
    model = StructureModel(
        LinearStructure(
            K, M, loads=(load,), laws=lambda t: (1 - np.cos(0.05 * t))[:, None], law_texts=("1 - cos(0.05 * t)",)
        )
    )
    one = model.simulate(200.0, scheme="generalized_alpha", tolerance=1e-4)
    other = model.simulate(200.0, tolerance=1e-4)
    assert one.status.name == other.status.name == "completed"
    assert np.abs(one.x - other.x).max() < 4e-4 * np.abs(other["x19"]).max()
    assert one.error.largest < 1e-4 and other.error.largest < 1e-4


def no_rings(structure: LinearStructure, step: float, m: int) -> Regions:
    nodes = np.arange(20, structure.size)
    return Regions((Group(nodes, 1, np.inf), Group(np.arange(20), m, np.inf)), step, 1.0)


def test_two_rings_do_not_grow_and_windows_without_rings_are_found() -> None:
    structure = two_regions()
    found = choose_regions(structure)
    assert growth(structure, found).stable
    worst = max(growth(structure, no_rings(structure, h, 8)).spectral_radius for h in np.linspace(0.08, 0.1245, 40))
    assert worst > 1 + 1e-3


def test_growth_beyond_the_limit_is_found_by_arnoldi() -> None:
    structure = two_regions(150, 200, 4)
    found = choose_regions(structure)
    beyond = found.with_step(1.02 * found.groups[0].limit)
    assert growth(structure, found).stable
    assert growth(structure, beyond).spectral_radius > 1.1
    assert "grows by" in str(growth(structure, beyond))


def test_rho_beyond_its_range_is_named() -> None:
    with pytest.raises(StructureError, match="rho_inf: 1.5; give a number from 0"):
        StructureModel(two_regions()).simulate(1.0, scheme="generalized_alpha", rho_inf=1.5)


def test_modes_and_static_deflection_of_a_bar() -> None:
    K, M = bar(np.full(400, 0.0025))
    model = StructureModel(LinearStructure(K, M))
    w, shapes = model.modes(3)
    assert w == pytest.approx(np.pi * np.array([0.5, 1.5, 2.5]), rel=1e-4)
    assert shapes.T @ (M[:, None] * shapes) == pytest.approx(np.eye(3), abs=1e-9)
    assert model.static({"x399": 2.0}) == pytest.approx(2.0 * np.cumsum(np.full(400, 0.0025)), rel=1e-9)


def test_a_structure_that_floats_has_no_static_deflection() -> None:
    K, M = bar(np.ones(5), held=False)
    with pytest.raises(StructureError, match="can move as a whole"):
        StructureModel(LinearStructure(K, M)).static({"x5": 1.0})
