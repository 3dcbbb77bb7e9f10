"""Angular velocities in closed loops: equations by hand, orders of schemes, resumed runs, spinning parts.

A crank on a hinge about x, a rod between two balls, a rocker on a hinge about y. The rod may spin about its line, so
that one of its turns is independent and two follow from the loop; with a stay to the ground all three follow. The
reference is written here with the rod's position, quaternion and angular velocity, and the forces of the balls.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import ensemble, linearise, resume, simulate
from runtime.contract.coordinates import independent, loop_part
from runtime.model import Model
from runtime.operating.mode_solver import ModeSolver, State
from runtime.studies.ensemble.starts import in_lanes
from symgen.scene import Scene, SceneRecord
from tests.laws.test_orientations import product, rotation
from tests.laws.test_random_spatial import turned_place
from tests.support.model_values import (
    Array,
    augmented_solution,
    condensed_accelerations,
    evaluate,
    make_state,
    relative_error,
)
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Build = Callable[..., Model]
OMEGA = ("omega_x", "omega_y", "omega_z")
CRANK, ROCKER, PIVOT, STAY = 0.25, 0.4, np.array([0.3, 1.0, 0.0]), np.array([1.478, 0.275, 0.757])
NEAR, FAR, SIDE, CENTRE = (np.array(v) for v in ([0, -0.5, 0], [0, 0.5, 0], [0.1, 0.2, 0], [0.02, 0.05, 0]))
J, MASS, G = np.array([0.05, 0.004, 0.052]), 0.7, np.array([0, 0, -9.81])


def mechanism(stay: bool = False, twice: bool = False, **rod: Any) -> SceneRecord:
    """The linkage; stay: a rigid stay from the rod to the ground. twice: its first ball twice. rod: more data of it."""
    builder = Scene("linkage", space="spatial").gravity(0, 0, -9.81)
    about = {"a": {"axis": [1, 0, 0], "x_axis": [0, 1, 0]}, "b": {"axis": [0, 1, 0], "x_axis": [1, 0, 0]}}
    builder.ground(
        markers={"a": about["a"], "b": {**about["b"], "position": PIVOT.tolist()}, "stay": {"position": STAY.tolist()}}
    )
    crank, rocker = {"position": [0, CRANK, 0]}, {"position": [ROCKER, 0, 0]}
    builder.rigid(
        "crank", mass=1.0, inertia=[0.02, 0.01, 0.015], center_of_mass=[0, 0.1, 0], markers={**about, "tip": crank}
    )
    data = {"mass": MASS, "inertia": J.tolist(), "center_of_mass": CENTRE.tolist(), **rod}
    ends = {name: {"position": place.tolist()} for name, place in (("near", NEAR), ("far", FAR), ("side", SIDE))}
    builder.rigid("rod", **data, markers=ends)
    builder.rigid(
        "rocker", mass=1.5, inertia=[0.03, 0.02, 0.04], center_of_mass=[0.2, 0, 0], markers={**about, "tip": rocker}
    )
    builder.revolute("left", "ground.a", "crank.a").revolute("right", "ground.b", "rocker.b")
    builder.spherical("first", "crank.tip", "rod.near").spherical("second", "rod.far", "rocker.tip")
    if twice:
        builder.spherical("again", "rod.near", "crank.tip")
    if stay:
        builder.distance("stay", "ground.stay", "rod.side", length=1.2)
    spin = {} if stay else {"rod.omega_y": 6.0}
    near = dict(zip("xyz", (0.315, 0.619, 0.149), strict=True)) | {"e0": 0.938, "e1": 0.068, "e2": -0.035, "e3": -0.339}
    builder.initial({"left.angle": {"value": 0.3, "fixed": True}, **{f"rod.{name}": at for name, at in near.items()}})
    builder.rates({"left.angle": {"value": 4.0, "fixed": True}, **spin})
    return builder.simulation(t_end=0.2, dt=2e-3, scheme="rk4").build()


def crank_tip(phi: float) -> tuple[Array, Array, Array]:
    """Place, and its first and second derivatives by the angle."""
    c, s = np.cos(phi), np.sin(phi)
    return tuple(CRANK * np.array(v) for v in ([0, c, s], [0, -s, c], [0, -c, -s]))  # type: ignore[return-value]


def rocker_tip(psi: float) -> tuple[Array, Array, Array]:
    """The same of the rocker."""
    c, s = np.cos(psi), np.sin(psi)
    first, second, third = (ROCKER * np.array(v) for v in ([c, 0, -s], [-s, 0, -c], [-c, 0, s]))
    return PIVOT + first, second, third


def by_hand(phi: float, psi: float, e: Array, rates: Array, stay: bool) -> Array:
    """(phi'', psi'', omega') of the rates (phi', psi', omega): forces of the balls and of the stay as unknowns.

    Unknowns: phi'', psi'', x'' of the rod's centre of mass, omega', force of each ball on the rod, tension of the stay.
    """
    A, omega = rotation(e), rates[2:]
    ends = [(NEAR - CENTRE, crank_tip(phi), 0), (FAR - CENTRE, rocker_tip(psi), 1)]
    K, side = np.zeros((14 + stay, 14 + stay)), np.zeros(14 + stay)
    K[0, 0], K[1, 1] = 0.02 + 1.0 * 0.1**2, 0.02 + 1.5 * 0.2**2
    side[0] = 1.0 * G @ (crank_tip(phi)[1] * 0.1 / CRANK)
    side[1] = 1.5 * G @ (rocker_tip(psi)[1] * 0.2 / ROCKER)
    K[2:5, 2:5], side[2:5] = MASS * np.eye(3), MASS * G
    K[5:8, 5:8], side[5:8] = np.diag(J), -np.cross(omega, J * omega)
    for k, (arm, (_, slope, bend), angle) in enumerate(ends):
        force, tilde = slice(8 + 3 * k, 11 + 3 * k), np.cross(arm, np.eye(3)).T
        K[angle, force] = slope  # the ball pushes back
        K[2:5, force] = -np.eye(3)
        K[5:8, force] = -tilde @ A.T
        K[force, 2:5], K[force, 5:8], K[force, angle] = np.eye(3), -A @ tilde, -slope
        side[force] = bend * rates[angle] ** 2 - A @ np.cross(omega, np.cross(omega, arm))
    if stay:
        arm = SIDE - CENTRE
        tilde = np.cross(arm, np.eye(3)).T
        tip, slope, _ = crank_tip(phi)
        along = tip + A @ (SIDE - NEAR) - STAY
        speed = slope * rates[0] + A @ np.cross(omega, SIDE - NEAR)
        K[2:5, 14], K[5:8, 14] = along, tilde @ A.T @ along
        K[14, 2:5], K[14, 5:8] = along, -along @ A @ tilde
        side[14] = -speed @ speed - along @ A @ np.cross(omega, np.cross(omega, arm))
    return np.linalg.solve(K, side)[[0, 1, 5, 6, 7]]


def motion_by_hand(model: Model, t_end: float, stay: bool) -> Array:
    """(phi, psi, e) at the end, from the model's own start."""
    at = [model.coordinates.index(name) for name in ("left.angle", "right.angle", *(f"rod.e{k}" for k in range(4)))]
    q, v = model.initial_q[at], model.initial_q_dot[at]
    omega = 2 * product(q[2:] * [1, -1, -1, -1], v[2:])[1:]

    def slope(t: float, y: Array) -> Array:
        e, rates = y[2:6], y[6:]
        return np.r_[rates[:2], product(e, np.r_[0, rates[2:]]) / 2, by_hand(y[0], y[1], e, rates, stay)]

    start = np.r_[q, v[:2], omega]
    return solve_ivp(slope, (0, t_end), start, method="DOP853", rtol=1e-11, atol=1e-12).y[:6, -1]


@pytest.mark.parametrize("stay", [False, True])
def test_equations_by_hand(model_of: Build, stay: bool) -> None:
    """Which turns are independent, and accelerations at random states, by hand and with Euler parameters."""
    model, rng = model_of(mechanism(stay)), np.random.default_rng(2)
    turns = [f"rod.turn_{axis}" for axis in "xyz"]
    assert model.q_i == (["left.angle"] if stay else ["left.angle", "rod.turn_y"])
    assert model.loop_unknowns == ["right.angle", *(turns if stay else [turns[0], turns[2]])]
    start = independent(model, model.initial_q, model.initial_q_dot)[0]
    for _ in range(3):
        n = len(start)
        state = make_state(model, start + 0.2 * rng.uniform(-1, 1, n), 3 * rng.uniform(-1, 1, n))
        names = ["left.angle", "right.angle", *(f"rod.e{k}" for k in range(4))]
        q, v = (source[[model.coordinates.index(name) for name in names]] for source in (state.q, state.q_dot))
        omega = 2 * product(q[2:] * [1, -1, -1, -1], v[2:])[1:]
        wanted = by_hand(q[0], q[1], q[2:], np.r_[v[:2], omega], stay)
        out = evaluate(model, "condensed", **state.values())
        a = np.linalg.solve(out["M_hat"].reshape(n, n), out["Q_hat"])
        a_d = evaluate(model, "accelerations", **state.values(), q_i_ddot=a)["q_d_ddot"]
        found = dict(zip([*model.q_i, *model.q_d], [*a, *a_d], strict=True))
        assert relative_error([found[name] for name in ("left.angle", "right.angle", *turns)], wanted) < 1e-11
        assert relative_error(condensed_accelerations(model, state), augmented_solution(model, state)[0]) < 1e-9


@pytest.mark.parametrize("stay", [False, True])
def test_residual_jacobian(model_of: Build, stay: bool) -> None:
    """J_q along rotations in the axes of the rod, the loop following, and J_v: differences of Q_hat - M_hat a."""
    model, rng, h = model_of(mechanism(stay)), np.random.default_rng(5), 1e-5
    n = len(model.q_i)
    start = independent(model, model.initial_q, model.initial_q_dot)[0]
    state = make_state(model, start + 0.1 * rng.uniform(-1, 1, n), 3 * rng.uniform(-1, 1, n))
    a = rng.uniform(-1, 1, n)

    def residual(step: Array, change: Array) -> Array:
        at = make_state(model, turned_place(model, state, step), state.q_i_dot + change, 0.0, state.q)
        out = evaluate(model, "condensed", **at.values())
        return np.asarray(out["Q_hat"] - out["M_hat"].reshape(n, n) @ a)

    found = evaluate(model, "residual_jacobian", **state.values(), q_i_ddot=a)
    none, units = np.zeros(n), h * np.eye(n)
    J_q = np.array([residual(unit, none) - residual(-unit, none) for unit in units]).T / (2 * h)
    J_v = np.array([residual(none, unit) - residual(none, -unit) for unit in units]).T / (2 * h)
    assert relative_error(found["J_q"].reshape(n, n), J_q) < 1e-7
    assert relative_error(found["J_v"].reshape(n, n), J_v) < 1e-7


def test_slopes_of_long_trees_know_turns_that_a_loop_splits(model_of: Build, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is derived along columns is what the emitted Jacobians give."""
    model, rng = model_of(mechanism()), np.random.default_rng(7)
    start = independent(model, model.initial_q, model.initial_q_dot)[0]
    n, solver = len(start), ModeSolver(model, model.constants(model.parameter_vector()))
    at = make_state(model, start + 0.1 * rng.uniform(-1, 1, n), 3 * rng.uniform(-1, 1, n))
    state = State(0.0, at.q_i, at.q_i_dot, loop_part(model, at.q))
    for moving in (False, True):
        expected = solver.slopes(state, moving)
        with monkeypatch.context() as patch:
            patch.setattr("runtime.operating.mode_solver.is_long_tree", lambda model: True)
            found = solver.slopes(state, moving)
        assert max(map(relative_error, found, expected)) < 1e-9


SCHEMES: list[tuple[str, dict[str, Any], float, float, float]] = [  # scheme, settings, step, order, error at most
    ("single_rate", {}, 2e-3, 2, 1.5e-4),
    ("rk4", {}, 2e-3, 4, 1e-7),
    ("exponential", {"m": [2]}, 4e-3, 4, 3e-6),
    ("exponential_adams", {}, 4e-3, 4, 3e-5),
    ("radau", {}, 8e-3, 5, 3e-7),
]


@pytest.mark.parametrize("stay", [False, True])
def test_orders(model_of: Build, stay: bool) -> None:
    """Size and slope of the errors against the motion by hand, with one independent turn and with none."""
    model = model_of(mechanism(stay))
    wanted = motion_by_hand(model, 0.2, stay)
    names = ["left.angle", "right.angle", *(f"rod.e{k}" for k in range(4))]

    def error(seen: Mapping[str, float]) -> float:
        return float(np.abs(np.array([seen[name] for name in names]) - wanted).max())

    for scheme, settings, dt, order, most in SCHEMES if not stay else SCHEMES[:2]:
        run = PreparedRuns(model, scheme, **settings, engine="interpreted")
        errors = [error(run.seen(0.2, h)) for h in (dt, dt / 2)]
        assert errors[0] < most, (scheme, errors)
        assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.35), (scheme, errors)
    by_tolerance = simulate(model, scheme="dopri5", dt=0.1, t_end=0.2, options={"tolerance": 1e-8})
    assert by_tolerance.status.ok and by_tolerance.constraint_error.max() < 1e-12
    assert error({name: by_tolerance[name][-1] for name in names}) < 1e-8


def test_resumed_runs_and_lanes(model_of: Build, tmp_path: Path) -> None:
    """Bit for bit the whole run, and the run by itself."""
    model = model_of(mechanism())

    def stop(t: float, t_end: float) -> None:
        if t >= 0.05:
            raise KeyboardInterrupt

    for scheme in ("exponential_adams", "single_rate"):
        settings: dict[str, Any] = {"scheme": scheme, "dt": 2e-3, "t_end": 0.1}
        end, whole, broken = simulate(model, **settings).q[-1], tmp_path / f"whole_{scheme}", tmp_path / scheme
        simulate(model, **settings, stream=whole)
        rule: dict[str, Any] = {"checkpoint": tmp_path / "run", "checkpoint_every": 3, "progress": stop}
        assert simulate(model, **settings, **rule, stream=broken).status.name == "interrupted"
        assert np.array_equal(resume(model, tmp_path / "run").q[-1], end)
        assert (broken / "samples.bin").read_bytes() == (whole / "samples.bin").read_bytes()
    name, starts = "rod.omega_x", {"left.angle_dot": np.array([3.0, 4.0]), "left.angle": np.array([0.3, 0.4])}
    many = ensemble(model, initial=starts, reduce={name: ["end"]}, outputs=[name], **settings)
    each = np.array([*starts.values()]).T.tolist()
    alone = [simulate(model, initial=dict(zip(starts, one, strict=True)), **settings)[name][-1] for one in each]
    assert in_lanes(model, list(starts), "") and np.array_equal(np.asarray(many[f"{name}_end"]), alone)


def spinning(hinges: bool) -> SceneRecord:
    """At rest but for the spin: a crank on a universal joint between two springs, a rod of revolution, the rocker."""
    builder = Scene("spinning", space="spatial")
    hinge = {"b": {"axis": [0, 0.8, 0.6], "x_axis": [1, 0, 0]}}
    anchors = {"up": [0.1, CRANK, 0.3], "aside": [0.4, 0.0, -0.1]}
    builder.ground(
        markers={"b": {**hinge["b"], "position": PIVOT.tolist()}, **{k: {"position": v} for k, v in anchors.items()}}
    )
    builder.rigid("crank", mass=1.0, inertia=[0.02, 0.01, 0.015], markers={"tip": {"position": [0, CRANK, 0]}})
    line = {"axis": [0, 1, 0], "x_axis": [1, 0, 0]}
    ends = {name: {"position": place.tolist(), **line} for name, place in (("near", NEAR), ("far", FAR))}
    builder.rigid("rod", mass=MASS, inertia=[0.05, 0.03, 0.05], markers=ends)
    tip = {"position": [ROCKER, 0, 0]}
    builder.rigid("rocker", mass=0.5, inertia=[0.03, 0.02, 0.04], markers={**hinge, "tip": tip})
    builder.universal("left", "ground.origin", "crank.origin").revolute("right", "ground.b", "rocker.b")
    if hinges:  # the first joint as turns about z, x and the rod's own line
        builder.rigid("ring", mass=1e-12, inertia=[1e-12] * 3, markers={"line": line})
        builder.universal("first", "crank.tip", "ring.origin").revolute("spin", "ring.line", "rod.near")
    else:
        builder.spherical("first", "crank.tip", "rod.near")
    builder.spherical("second", "rod.far", "rocker.tip")
    for name, place in anchors.items():
        free = float(np.linalg.norm(np.array(place) - [0, CRANK, 0]))
        builder.spring_damper(name, f"ground.{name}", "crank.tip", stiffness=900.0, damping=0.0, free_length=free)
    angles = {f"left.angle{k}": {"value": 0.0, "fixed": True} for k in (1, 2)}
    return builder.initial(angles).simulation(t_end=0.1, dt=1e-3, scheme="rk4").build()


def test_a_spinning_part_of_a_loop(model_of: Build) -> None:
    """Its linear system is the steady one of three hinges, of which the last is the spin; the whirl splits."""
    roots = []
    for hinges, spin in ((False, "rod.omega_y"), (True, "spin.angle_dot")):
        model = model_of(spinning(hinges))
        roots.append(np.sort(linearise(model, {spin: 300.0}).modal.every_eigenvalue.imag))
        still = np.sort(linearise(model, {}).modal.every_eigenvalue.imag)
        assert np.abs(roots[-1][-2:] / still[-2:] - 1).max() > 0.05
    assert relative_error(roots[0], roots[1]) < 1e-8
