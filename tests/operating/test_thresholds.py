"""Thresholds of the room `operating` from both sides: a figure that a threshold a thousand times looser gets wrong."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from runtime import Model, NoEquilibrium, equilibrium, linearise
from runtime.operating.balance import Clamped
from runtime.operating.equilibrium import is_steady
from runtime.operating.functions import PointFunctions, PointValues
from runtime.operating.linearisation import modal_analysis
from runtime.operating.mode_tracking import ModeState, tracked
from runtime.operating.newton import Balance, balanced
from runtime.operating.trim import trimmed
from symgen.scene import Scene, SceneRecord

UNIT = np.eye(2)
NONE = np.zeros(2)
PLACE = PointValues(UNIT, NONE, UNIT, UNIT, NONE, NONE, UNIT, NONE, 0.0, NONE)


def linear(H: np.ndarray, exact: np.ndarray, claimed: np.ndarray | None = None, left: float = 0.0) -> Balance:
    """A spring's force -H (x - exact), and `left` in the last direction; its stiffness is said to be `claimed`."""

    def balance(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        r = -H @ (x - exact)
        r[-1] += left
        return r, -H if claimed is None else -claimed, np.eye(len(x))

    return balance  # type: ignore[return-value]


def test_a_weak_spring_is_a_spring() -> None:
    """k = 1e-11 beside 1: sqrt(1e-11) rad/s, no rigid-body mode."""
    modal = modal_analysis(UNIT, np.zeros((2, 2)), np.diag([1.0, 1e-11]))
    assert not modal.rigid.any() and modal.frequencies[0] == pytest.approx(np.sqrt(1e-11))


def test_a_slow_decay_of_a_free_body_is_no_rounding() -> None:
    """x'' + 1e-3 x' = 0 beside a frequency of 1: eigenvalues 0 and -1e-3."""
    modal = modal_analysis(UNIT, np.diag([1e-3, 0.1]), np.diag([0.0, 1.0]))
    decays = np.sort(modal.every_eigenvalue[np.abs(modal.every_eigenvalue) < 0.5].real)
    assert decays == pytest.approx([-1e-3, 0.0], abs=1e-12)


def test_a_weak_circulatory_force_drives_and_damps() -> None:
    """K = [[1, e], [-e, 1]], e = 1e-9: lambda^2 = -(1 +- i e), real parts +- e / 2."""
    found = modal_analysis(UNIT, np.zeros((2, 2)), np.array([[1.0, 1e-9], [-1e-9, 1.0]])).every_eigenvalue
    assert found.real.max() == pytest.approx(5e-10, rel=1e-3) and found.real.min() == pytest.approx(-5e-10, rel=1e-3)


def test_weak_damping_is_damping() -> None:
    """x'' + 1e-11 x' + x = 0 decays at 5e-12 1/s."""
    modal = modal_analysis(UNIT, 1e-11 * UNIT, UNIT)
    assert modal.damping_ratios == pytest.approx([5e-12, 5e-12], rel=1e-3)


def test_slow_growth_is_unstable() -> None:
    """Real part +1e-8 of |lambda| = 1: unstable; +1e-10 is rounding."""
    assert not modal_analysis(UNIT, -2e-8 * UNIT, UNIT).stable
    assert modal_analysis(UNIT, -2e-10 * UNIT, UNIT).stable


def test_nothing_to_move_has_no_modes() -> None:
    none = np.zeros((0, 0))
    modal = modal_analysis(none, none, none)
    shapes = (modal.frequencies, modal.damping_ratios, modal.shapes, modal.rigid, modal.every_eigenvalue)
    assert [part.shape for part in shapes] == [(0,), (0,), (0, 0), (0,), (0,)] and modal.stable


def test_iterations_go_on_until_the_correction_is_small() -> None:
    """Stiffness 1 that is said to be 2: each step halves the error, and the last one is 1e-12."""
    one = np.ones(1)
    found = balanced(linear(np.eye(1), one, 1.999 * np.eye(1)), np.zeros(1))
    assert found.converged and abs(found.x[0] - 1.0) < 1e-11


def test_iterations_that_shrink_slowly_stop_at_rounding_only() -> None:
    """Stiffness 1 that is said to be 4: steps shrink by a quarter, which is rounding below 1e-9 (error 3e-9)."""
    found = balanced(linear(np.eye(1), np.ones(1), 4.0 * np.eye(1)), np.zeros(1))
    assert found.converged and abs(found.x[0] - 1.0) < 1e-8


def test_a_force_that_nothing_balances_is_told() -> None:
    """1e-7 N in a direction without stiffness beside 1 N that is balanced: no equilibrium; the force is returned."""
    found = balanced(linear(np.diag([1.0, 0.0]), UNIT[0], left=1e-7), np.zeros(2))
    assert not found.converged
    assert found.residual.shape == (2,) and found.residual[1] == pytest.approx(1e-7)


def test_a_weak_spring_is_balanced_too() -> None:
    """Stiffness 1e-10 beside 1: both coordinates reach their place."""
    found = balanced(linear(np.diag([1.0, 1e-10]), np.ones(2)), np.zeros(2))
    assert found.converged and found.x == pytest.approx([1.0, 1.0])


def modes(frequencies: list[float], shapes: np.ndarray) -> ModeState:
    values = np.array(frequencies)
    return ModeState(1j * values, values, np.zeros(2), shapes.astype(complex), UNIT, ["first", "second"])


def test_shapes_that_are_alike_need_nothing_in_between() -> None:
    """cos^2 of 20 degrees is 0.88: the same mode, without a look at the middle."""
    turn = np.radians(20)
    shapes = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])

    def at(value: float) -> ModeState:
        raise AssertionError("asked for what is in between")

    assert tracked(modes([1.0, 2.0], UNIT), modes([1.1, 2.1], shapes), 0.0, 1.0, at).names == ["first", "second"]


def test_modes_that_cross_keep_their_shapes() -> None:
    """Frequencies 1 + v and 2 - v/2 of fixed shapes: at v = 1 the first mode is the faster one."""

    def at(value: float) -> ModeState:
        frequencies = np.array([1.0 + value, 2.0 - 0.5 * value])
        order = np.argsort(frequencies)
        found = modes(frequencies[order].tolist(), UNIT[:, order])
        return ModeState(found.eigenvalues, found.frequencies, found.damping_ratios, found.shapes, found.M, found.names)

    for halvings in (6, 0):
        found = tracked(at(0.0), at(1.0), 0.0, 1.0, at, halvings)
        assert found.frequencies == pytest.approx([2.0, 1.5])


@pytest.mark.parametrize("row", [0, 1])
def test_forces_that_change_a_little_as_the_motion_goes_on_are_not_steady(row: int) -> None:
    """1e-8 of a row's stiffness is a change, 1e-10 is none; in a row that is next to nothing beside the others, 1e-12
    and 1e-14 of those."""
    for part, steady in (((1e-8, 1e-12)[row], False), ((1e-10, 1e-14)[row], True)):
        J_q = np.array([[1.0, 0.0], [1.0 - row, 0.0]])
        J_q[row, 1] = part
        at = replace(PLACE, J_q=J_q)
        assert is_steady(at, np.array([0.0, 1.0])) == steady


def test_loops_that_are_open_are_of_no_use() -> None:
    assert replace(PLACE, open_by=1e-10).usable and not replace(PLACE, open_by=1e-7).usable


def test_a_mode_that_changes_a_little_without_an_assumed_mode_is_coupled_to_it(
    built_in: Callable[[str], Model],
) -> None:
    """K = diag(1, 4, 9, 16), and e between first and last, e^2 = 3e-4: 1 falls by e^2 / (2 (16 - 1)) = 1e-5."""
    system = linearise(built_in("hub_beam"))
    elastic = [name in system.model.elastic for name in system.names]
    assert elastic == [False, True, True, True]
    K = np.diag([1.0, 4.0, 9.0, 16.0])
    K[0, 3] = K[3, 0] = math.sqrt(3e-4)
    change = replace(system, M=np.eye(4), K=K).basis_change
    assert change[0] == pytest.approx(1e-5, rel=1e-2) and change[2] == 0


def test_what_inputs_cannot_balance_is_told(model_of: Callable[[SceneRecord], Model]) -> None:
    """Two inputs for two held coordinates, one of which has 1e-7 N that neither moves; 1 N at the start."""
    builder = Scene("held").parameter("u", 0.0, "N").parameter("w", 1.0, "N")
    builder.structure(coordinates=["x", "y"], mass=np.eye(2), stiffness=np.eye(2), force=["u - 1", "1e-7 + 0 * w"])
    model = model_of(builder.simulation(t_end=0.1, dt=0.01, scheme="printed").build())
    with pytest.raises(NoEquilibrium):
        equilibrium(model, {"x": 0.0, "y": 0.0}, inputs={"u": None, "w": None})


def test_dependent_coordinates_are_held_where_they_are_asked_for(built_in: Callable[[str], Model]) -> None:
    """Ten places of a slider, each to 1e-12 m."""
    model = built_in("slider_crank")
    name = next(name for name in model.q_d if name.startswith("slider") and name.endswith(".x"))
    for place in np.linspace(0.33, 0.4, 10):
        assert abs(equilibrium(model, {name: place}, initial={"crank.theta": 1.0})[name] - place) < 1e-12


def test_a_trim_goes_on_until_the_correction_is_small(built_in: Callable[[str], Model]) -> None:
    """Newton on sin d from d = 1e-3: tan d - d = 3.3e-10 is left after one step, 1e-29 after two."""
    model = built_in("pendulum")
    p, none = model.parameter_vector(), np.zeros(0)
    task = Clamped(model, PointFunctions(model, model.constants(p)), 0.0, np.zeros(1), [], none, none)
    found = trimmed(model, task, np.array([-np.pi / 2 + 1e-3]), p, [])
    assert found.converged and found.q_i[0] == pytest.approx(-np.pi / 2, abs=1e-14)
