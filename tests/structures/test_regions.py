"""Which nodes step how often, and how long steps may be."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.linalg as la

from runtime.structures import LinearStructure, StructureError, StructureModel
from runtime.structures.central_difference import CentralDifference
from runtime.structures.limits import damped_limit, largest_frequency, row_limits
from runtime.structures.regions import Group, Regions
from tests.structures.bars import bar, matrices, two_regions


def test_limits_against_all_eigenvalues() -> None:
    structure = two_regions()
    K, M, _ = matrices(structure)
    right = 2 / np.sqrt(la.eigh(K, M, eigvals_only=True)[-1])
    assert 2 / largest_frequency(structure.stiffness, structure.mass) == pytest.approx(right, rel=1e-3)
    assert 0.7 * right < row_limits(structure.stiffness, structure.mass).min() <= right
    assert StructureModel(structure).step_limit == pytest.approx(right, rel=1e-3)


@pytest.mark.parametrize("b", [0.0, 1e-3, 0.05])
def test_limit_with_dampers_is_where_motion_begins_to_grow(b: float) -> None:
    w = 40.0
    limit = damped_limit(w, b)
    for factor, grows in ((0.98, False), (1.02, True)):
        structure = LinearStructure(np.array([[w * w]]), [1.0], damping=None if b == 0 else np.array([[b * w * w]]))
        step = CentralDifference(structure, Regions((Group(np.array([0]), 1, limit),), factor * limit, 1.0))
        step.start(np.array([1.0]), np.array([0.3]))
        step.advance(2000)
        assert bool(abs(step.x[0]) < 1e3) is not grows


def test_regions_of_a_bar_have_two_rings_and_steps_within_their_limits() -> None:
    model = StructureModel(two_regions(40, 64, 8))
    found = model.regions()
    fast, slow = found.groups
    assert slow.sub_steps == 8
    shortest = 40  # node of the first short element's end; two rings make it begin two nodes before
    assert fast.nodes.min() in (shortest - 3, shortest - 2) and len(fast.nodes) + len(slow.nodes) == 104
    for group, step in zip(found.groups, found.steps, strict=True):
        assert step <= 0.91 * group.limit


def test_graded_mesh_gets_three_groups() -> None:
    K, M = bar(np.concatenate([np.full(2000, 1.0), np.full(700, 0.25), np.full(200, 1 / 16)]))
    found = StructureModel(LinearStructure(K, M)).regions()
    assert [group.sub_steps for group in found.groups] == [1, 4, 4]
    assert found.share < 0.3


def test_uniform_mesh_stays_one_group() -> None:
    K, M = bar(np.ones(50))
    assert len(StructureModel(LinearStructure(K, M)).regions().groups) == 1


def test_groups_by_name() -> None:
    model = StructureModel(two_regions())
    found = model.regions(groups={"slow": [], "fast": [f"x{k}" for k in range(20, 44)]}, m=4)
    assert [len(group.nodes) for group in found.groups] == [26, 18] and found.groups[1].sub_steps == 4


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda m: m.regions(groups={"slow": [], "fast": ["x99"]}), "coordinate 'x99': is not in the structure"),
        (lambda m: m.regions(groups={"slow": [], "fast": []}, m=2), "group 0 (fastest is 0) has no node"),
        (lambda m: m.regions(m=1), "m: 1; give whole numbers from 2"),
        (
            lambda m: m.simulate(1.0, dt=5.0, scheme="single_rate"),
            "beyond the limit of 0.1251 s; give at most 0.1126 s",
        ),
        (lambda m: m.simulate(1.0, scheme="rk4"), "'rk4' does not step a structure"),
        (lambda m: m.simulate(-1.0), "t_end: -1.0 s; give a positive time"),
        (lambda m: m.simulate(1.0, outputs=["y"]), "coordinate 'y'"),
        (lambda m: m.simulate(1.0, initial={"x1": np.nan}), "initial: holds a number that is not finite"),
        (lambda m: m.simulate(1.0, scheme="single_rate", m=3), "single_rate has one step for all"),
    ],
)
def test_options_that_cannot_be_used_are_named(call, says: str) -> None:
    with pytest.raises(StructureError) as error:
        call(StructureModel(two_regions()))
    assert says in str(error.value)


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        (
            {"stiffness": [[1.0, 0.5], [0.0, 1.0]], "mass": [1, 1]},
            "stiffness: is not symmetric: entries (x0, x1) and its mirror differ by 0.5",
        ),
        ({"stiffness": [[1.0, np.nan], [np.nan, 1.0]], "mass": [1, 1]}, "stiffness: entry (x0, x1) is nan"),
        ({"stiffness": [[-1.0]], "mass": [1]}, "stiffness: the diagonal of x0 is -1"),
        ({"stiffness": [[1.0]], "mass": [0.0]}, "mass: the mass of x0 is 0 kg"),
        ({"stiffness": [[1.0]], "mass": [1.0, 2.0]}, "mass: has shape (2,), K needs (1,)"),
        (
            {"stiffness": [[1.0, 0], [0, 1]], "mass": [1, 1], "coordinates": ["a", "a"]},
            "coordinates: 'a' appears twice",
        ),
        ({"stiffness": [[1.0]], "mass": [1], "width": 2}, "width: 2 coordinates a node do not divide 1 rows"),
        ({"stiffness": [1.0], "mass": [1]}, "stiffness: has shape (1,)"),
    ],
)
def test_matrices_that_cannot_be_are_named(fields: dict, says: str) -> None:
    with pytest.raises(StructureError) as error:
        LinearStructure(**fields)
    assert says in str(error.value)
