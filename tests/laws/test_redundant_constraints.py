"""Redundant constraints: found and named, the motion that of the mechanism without them, multipliers of least norm."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import null_space

from runtime import load_model, simulate
from runtime.model import Model
from symgen.generate import generate
from symgen.scene import Scene
from tests.support.augmented import augmented_accelerations, augmented_run
from tests.support.model_values import (
    augmented_solution,
    condensed_accelerations,
    evaluate,
    make_state,
    random_states,
    reactions,
    relative_error,
)

BARS = ("left", "middle", "right")


def parallelogram(third: bool = True) -> Scene:
    """A bar of 2 m on two or three parallel bars of 1 m; without the third joint its bar hangs on the top bar."""
    builder = Scene("bars").gravity(0, -9.81)
    builder.ground(markers={"m": {"position": (1, 0)}, "r": {"position": (2, 0)}})
    for name in BARS:
        builder.rigid(name, mass=1.0, inertia=0.1, center_of_mass=(0.5, 0), markers={"tip": {"position": (1, 0)}})
    builder.rigid(
        "top",
        mass=1.0,
        inertia=0.1,
        center_of_mass=(0.8, 0.1),
        markers={"a": {"position": (0, 0)}, "b": {"position": (1, 0)}, "c": {"position": (2, 0)}},
    )
    for name, foot, mark in zip(BARS, ("origin", "m", "r"), "abc", strict=True):
        if third or name != "middle":
            builder.revolute(f"{name}_low", f"ground.{foot}", f"{name}.origin")
        builder.revolute(f"{name}_up", f"{name}.tip", f"top.{mark}")
    if not third:
        builder.prescribed_angle("parallel", "left.origin", "middle.origin", motion="0.0")
    builder.initial({f"{name}.theta": 0.9 for name in BARS}).rates({"left.theta": 1.0})
    return builder.independent("left.theta")


def doubled_hinge() -> Scene:
    """Two bearings on one axis; the same markers twice would be refused."""
    builder = Scene("twice").gravity(0, -9.81)
    builder.rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0), markers={"pin": {"position": (0.0, 0.0)}})
    return builder.revolute("hinge", "ground.origin", "rod.origin").revolute("again", "ground.origin", "rod.pin")


def ring_of_welds() -> Scene:
    """Three bodies welded to each other, swinging on a hinge."""
    corners = {"next": {"position": (0.5, 0.1), "angle": 0.2}}
    builder = Scene("ring").gravity(0, -9.81).rigid("one", mass=1.0, inertia=0.1, markers=corners)
    builder.rigid("two", mass=2.0, inertia=0.1, markers={"next": {"position": (0.3, 0.4), "angle": -0.2}})
    cos, sin = np.cos(0.2), np.sin(0.2)
    back = (-0.5 - 0.3 * cos + 0.4 * sin, -0.1 - 0.3 * sin - 0.4 * cos)
    builder.rigid("three", mass=1.0, inertia=0.2, markers={"back": {"position": back}})
    builder.revolute("hinge", "ground.origin", "one.origin").weld("first", "one.next", "two.origin")
    return builder.weld("second", "two.next", "three.origin").weld("third", "three.back", "one.origin")


def driven_twice() -> Scene:
    """Two motors with the same motion of one angle, and an arm that swings on it."""
    builder = (
        Scene("twins")
        .gravity(0, -9.81)
        .rigid("rod", mass=1.0, inertia=0.1, markers={"tip": {"position": (0.4, 0)}})
        .rigid("arm", mass=1.0, inertia=0.1, center_of_mass=(0.2, 0))
    )
    builder.revolute("hinge", "ground.origin", "rod.origin").revolute("elbow", "rod.tip", "arm.origin")
    for name in ("motor", "twin"):
        builder.prescribed_angle(name, "ground.origin", "rod.origin", motion="sin(3 * t)")
    return builder.rates({"rod.theta": 3.0})


CASES: dict[str, tuple[Callable[[], Scene], int]] = {
    "parallelogram": (parallelogram, 1),
    "doubled hinge": (doubled_hinge, 2),
    "ring of welds": (ring_of_welds, 3),
    "driven twice": (driven_twice, 1),
}


@pytest.fixture(scope="module", params=list(CASES))
def case(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Model, int]:
    make, count = CASES[request.param]
    return load_model(generate(make().build(), tmp_path_factory.mktemp("redundant"))), count


def test_redundant_rows_are_found(case: tuple[Model, int]) -> None:
    model, count = case
    assert len(model.redundant) == count
    C_q = evaluate(model, "constraints", q=model.initial_q, q_dot=model.initial_q_dot, t=0.0)["C_q"]
    C_q = C_q.reshape(len(model.constraints), -1)
    assert np.linalg.matrix_rank(C_q[model.kept_rows]) == np.linalg.matrix_rank(C_q) == len(model.kept_rows)


def test_the_page_names_them(tmp_path: Path) -> None:
    folder = generate(doubled_hinge().build(), tmp_path / "page")
    page = (folder / "model.md").read_text(encoding="utf-8")
    assert "`again.x` (joint again)" in page and "least norm" in page


def test_condensed_equals_augmented_with_the_least_multipliers(case: tuple[Model, int]) -> None:
    """M q_ddot + C_q^T lam = Q*, and lam has no part that C_q^T maps to zero."""
    model, count = case
    solve = augmented_accelerations(model)
    c = model.constants(model.parameter_vector())
    for state in random_states(model, 3):
        q_ddot = condensed_accelerations(model, state)
        expected, least = augmented_solution(model, state)
        assert relative_error(q_ddot, expected) < 1e-10
        lam = reactions(model, state, q_ddot)
        assert relative_error(lam, least) < 1e-9
        found = evaluate(model, "augmented", **state.values())
        C_q = found["C_q"].reshape(len(model.constraints), -1)
        balance = found["M"].reshape(len(q_ddot), -1) @ q_ddot + C_q.T @ lam - found["Q_star"]
        assert np.max(np.abs(balance)) < 1e-11 * max(1.0, np.max(np.abs(lam)))
        open_part = null_space(C_q.T, rcond=1e-9)
        assert open_part.shape[1] == count
        assert np.max(np.abs(open_part.T @ lam)) < 1e-11 * max(1.0, np.max(np.abs(lam)))
        numbers = solve(state.t, state.q, state.q_dot, c)
        assert relative_error(np.asarray(numbers[0]).ravel(), expected) < 1e-8
        assert relative_error(np.asarray(numbers[1]).ravel(), least) < 1e-8


@pytest.mark.every_push("parallelogram", "ring of welds")
def test_all_rows_hold_and_energy_is_kept(case: tuple[Model, int]) -> None:
    model, _ = case
    solution = simulate(model, t_end=1.0, dt=5e-4, scheme="single_rate", seen_every=0.0025, engine="interpreted")
    assert solution.status.ok, solution.status
    assert np.max(solution.constraint_error) < 1e-12
    error = solution.total_energy - solution.total_energy[0] - solution.work()
    assert np.max(np.abs(error)) < 1e-4 * np.max(solution.energy["kinetic"])


def test_the_third_bar_carries_load_but_does_not_change_the_motion(tmp_path: Path) -> None:
    """Against the two-bar parallelogram whose third bar is kept parallel without its foot."""
    three, two = (load_model(generate(parallelogram(third).build(), tmp_path / str(third))) for third in (True, False))
    for angle in (0.4, 0.9, 2.0):
        both = [condensed_accelerations(model, make_state(model, [angle], [1.3])) for model in (three, two)]
        assert relative_error(*both) < 1e-12
    solution = simulate(three, t_end=0.1, dt=1e-3, scheme="single_rate", engine="interpreted")
    feet = [solution.joint_forces[0, three.joints.index(f"{name}_low"), 1] for name in BARS]
    assert min(np.abs(feet)) > 1.0  # the least-norm choice spreads the weight over all three


def test_other_paths_agree(tmp_path: Path) -> None:
    model = load_model(generate(parallelogram().build(), tmp_path / "bars"))
    times = np.array([0.0, 0.25, 0.5])
    reference = augmented_run(model, t_end=0.5, times=times)
    solution = simulate(model, t_end=0.5, dt=1e-3, scheme="rk4", seen_every=0.25, engine="interpreted")
    assert np.max(np.abs(solution.q - reference.q)) < 1e-5
    assert np.max(np.abs(solution.lam - reference.lam)) < 1e-2 * np.max(np.abs(reference.lam))
