"""Central differences by regions: against the equations of the paper step by step, exact motions, order, waves."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.linalg as la
import scipy.sparse as sp

from runtime.structures import LinearStructure, StructureModel
from runtime.structures.central_difference import CentralDifference
from runtime.structures.regions import Group, Regions, choose_regions, coordinates_of, one_group
from runtime.structures.structure import Load
from symgen import Scene
from tests.structures.bars import bar, matrices, two_regions


def by_hand(structure: LinearStructure, regions: Regions, x: np.ndarray, v: np.ndarray, majors: int) -> np.ndarray:
    """Steps (10)-(14), (72) in plain words, with dense matrices; every slow value is interpolated anew from its
    chord.

    Shares nothing with the code under test: the time of each group is a fraction, chords are kept as pairs of ends.
    """
    K, M, D = matrices(structure)
    mass, a, dense_D = np.diag(M), structure.mass_damping, D - structure.mass_damping * M
    times = regions.fastest
    rows = [coordinates_of(group.nodes, structure.width) for group in regions.groups]
    h = regions.steps
    own = np.empty(len(x))
    for g, r in enumerate(rows):
        own[r] = h[g]
    acceleration = (structure.force(np.array([0.0]))[0] - K @ x - D @ v) / mass
    d = own * v - own**2 / 2 * acceleration
    before = d - own**2 * acceleration
    x = x.copy()
    begin, end = x.copy(), x.copy()  # the chord of each coordinate's step
    for tick in range(majors * times[-1]):
        t = tick * h[0]
        for g in reversed(range(len(rows))):
            if tick % times[g]:
                continue
            r = rows[g]
            seen = x.copy()
            rate = 1.5 * d / own - 0.5 * before / own
            for slower in range(g + 1, len(rows)):
                s, share = rows[slower], (tick % times[slower]) / times[slower]
                seen[s] = begin[s] + share * (end[s] - begin[s])
                rate[s] = (before[s] + (share + 0.5) * (d[s] - before[s])) / own[s]
            force = structure.force(np.array([t]))[0][r] - K[r] @ seen - dense_D[r] @ rate
            implicit = 1 + a * h[g] / 2
            new = (2 - implicit) / implicit * d[r] + h[g] ** 2 / (mass[r] * implicit) * force
            before[r], d[r] = d[r], new
            begin[r], end[r] = x[r], x[r] + new
        for g, r in enumerate(rows):
            if (tick + 1) % times[g] == 0:
                x[r] = end[r]
    return x


def three_groups(width: int, damped: bool) -> tuple[LinearStructure, Regions]:
    """A random structure of blocks with three groups, no two of them without neighbours in common."""
    rng = np.random.default_rng(width)
    nodes = 12
    n = nodes * width
    A = rng.standard_normal((n, n)) * np.kron(
        abs(np.subtract.outer(range(nodes), range(nodes))) <= 2, np.ones((width, width))
    )
    K = sp.csr_matrix(A @ A.T)
    pattern = rng.standard_normal(n)
    structure = LinearStructure(
        K, rng.uniform(1, 2, n), width=width, damping=1e-3 * K if damped else None, mass_damping=0.2 if damped else 0.0,
        loads=(Load(pattern, 0), Load(np.eye(n)[n // 2], 1)),
        laws=lambda t: np.column_stack([np.sin(3 * t), np.cos(t)]), law_texts=("sin(3 * t)", "cos(t)"),
    )  # fmt: skip
    groups = tuple(
        Group(np.array(own), m, 1.0) for own, m in (([4, 5, 6], 1), ([2, 3, 7, 8], 2), ([0, 1, 9, 10, 11], 3))
    )
    return structure, Regions(groups, 0.02, 1.0)


@pytest.mark.parametrize("width", [1, 2, 3])
@pytest.mark.parametrize("damped", [False, True])
def test_steps_are_those_of_the_paper(width: int, damped: bool) -> None:
    structure, regions = three_groups(width, damped)
    rng = np.random.default_rng(7)
    x, v = rng.standard_normal(structure.size), rng.standard_normal(structure.size)
    step = CentralDifference(structure, regions)
    step.start(x, v)
    step.advance(20)
    right = by_hand(structure, regions, x, v, 20)
    assert np.abs(step.x - right).max() < 1e-11 * np.abs(right).max()
    assert step.t == pytest.approx(20 * 6 * 0.02, rel=1e-14)


def test_one_sub_step_is_one_step_for_all() -> None:
    structure, regions = three_groups(2, False)
    same = Regions(tuple(group._replace(sub_steps=1) for group in regions.groups), regions.step, 1.0)
    whole = Regions((Group(np.arange(12), 1, 1.0),), regions.step, 1.0)
    found = []
    for groups in (same, whole):
        step = CentralDifference(structure, groups)
        step.start(np.ones(structure.size), np.zeros(structure.size))
        step.advance(100)
        found.append(step.x)
    assert np.abs(found[0] - found[1]).max() < 1e-12 * np.abs(found[1]).max()


def exact(structure: LinearStructure, x: np.ndarray, t: float) -> np.ndarray:
    """Free undamped motion from rest, by its modes."""
    K, M, _ = matrices(structure)
    values, shapes = la.eigh(K, M)
    return shapes @ ((shapes.T @ (M @ x)) * np.cos(np.sqrt(values) * t))


@pytest.mark.parametrize("by_regions", [False, True])
def test_order_two_against_exact_motion(by_regions: bool) -> None:
    structure = two_regions()
    K, M, _ = matrices(structure)
    shapes = la.eigh(K, M)[1]
    x = shapes[:, 0] + 0.3 * shapes[:, 2]
    regions = choose_regions(structure) if by_regions else one_group(structure)
    t_end, errors = 20.0, []
    for refined in (1, 2, 4, 8):
        count = int(np.ceil(t_end / regions.steps[-1])) * refined
        step = CentralDifference(structure, regions.with_step(t_end / count / regions.fastest[-1]))
        step.start(x, np.zeros(len(x)))
        step.advance(count)
        errors.append(np.abs(step.x - exact(structure, x, t_end)).max() / np.abs(x).max())
    slopes = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(np.abs(slopes - 2) < 0.1), slopes
    w, h = np.sqrt(la.eigh(K, M, eigvals_only=True)[2]), regions.steps[-1] / 8
    assert (
        errors[-1] < 1.2 * 0.3 * w * t_end * (w * h) ** 2 / 24
    )  # the phase of the third mode, as one step for all has


def test_damped_oscillator_of_second_order() -> None:
    w, zeta, a = 3.0, 0.05, 0.2
    structure = LinearStructure(np.array([[w * w]]), [1.0], damping=np.array([[2 * zeta * w]]), mass_damping=a)
    c = zeta * w + a / 2
    wd = np.sqrt(w * w - c * c)
    errors = []
    for count in (100, 200, 400):
        step = CentralDifference(structure, one_group(structure, 2.0 / count))
        step.start(np.array([1.0]), np.array([0.5]))
        step.advance(count)
        right = np.exp(-2 * c) * (np.cos(2 * wd) + (0.5 + c) / wd * np.sin(2 * wd))
        errors.append(abs(step.x[0] - right))
    assert np.all(np.abs(np.log2(np.array(errors[:-1]) / errors[1:]) - 2) < 0.15)
    assert errors[-1] < 1e-4


def test_wave_crosses_the_regions_as_d_alembert_says() -> None:
    """A smooth pulse runs into the fine part and is reflected at its free end: u = f(x - t) + f(2 L - x - t)."""
    lengths = np.array([0.02] * 100 + [0.0025] * 400)
    K, M = bar(lengths)
    where, end = np.cumsum(lengths), lengths.sum()
    f = lambda s: np.where(abs(s - 1) < 0.6, np.cos(np.pi * (s - 1) / 1.2) ** 4, 0.0)  # noqa: E731
    slope = (f(where + 1e-6) - f(where - 1e-6)) / 2e-6
    model = StructureModel(LinearStructure(K, M))
    run = model.simulate(2.6, initial=f(where), rates=-slope, fields=10)
    assert run.status.name == "completed"
    assert len(run.stats["groups"]) == 2 and run.stats["share_of_operations"] < 0.95
    right = f(where - 2.6) + f(2 * end - where - 2.6)
    assert np.abs(run.x - right).max() < 4e-3
    assert abs(run.energy.sum(axis=1)[-1] / run.energy.sum(axis=1)[0] - 1) < 1e-3


@pytest.mark.long
def test_undamped_motion_does_not_grow_in_1e5_steps() -> None:
    structure = two_regions(40, 64, 8)
    regions = choose_regions(structure)
    step = CentralDifference(structure, regions)
    rng = np.random.default_rng(0)
    step.start(0.01 * rng.standard_normal(structure.size), np.zeros(structure.size))
    sizes = []
    for _ in range(100):
        step.advance(1000 // regions.fastest[-1])
        sizes.append(np.abs(step.x).max())
    assert max(sizes[-20:]) < 1.3 * max(sizes[:20])


@pytest.mark.long
def test_a_small_structure_written_as_equations_does_not_grow_by_default() -> None:
    """A bar of two regions at 0.7 of its limit, m = 4, two rings fast: the printed reading grows to 191, the chord
    does not.
    """
    structure = two_regions(6, 10, 4)
    K, M, _ = matrices(structure)
    names = [f"x{k}" for k in range(16)]
    h = 0.7 * 2 / np.sqrt(la.eigh(K, M, eigvals_only=True)[-1])
    start = dict(zip(names, (0.01 * np.random.default_rng(0).standard_normal(16)).tolist(), strict=True))
    scene = Scene("bar").structure(coordinates=names, mass=M.tolist(), stiffness=K.tolist())
    model = scene.groups(L=names[:3], S=names[3:]).initial(start).model()
    sizes = {}
    for reading in ("auto", "end_point_sum"):
        run = model.simulate(
            scheme="printed", t_end=8000 * 4 * h, dt=4 * h, m=[4], samples=200, error="off",
            options={"slow_interpolation": reading}
        )  # fmt: skip
        sizes[reading] = np.abs(run.q[-20:]).max()
    assert sizes["auto"] < 0.05 < 0.2 < sizes["end_point_sum"]
