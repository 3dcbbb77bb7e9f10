"""Friction and stops by modes against two other ways, by hand: velocity-level time stepping, and steep smooth laws.

Time stepping after Moreau knows no modes and no events: every step solves for impulses within their bounds. Its error
falls with the step, that of the smooth law F tanh(v / eps) with eps; both tend to what runs by modes give.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import Model, simulate
from symgen.scene import Scene, SceneRecord
from tests.support.time_stepping import Law, Links, moreau

Build = Callable[[SceneRecord], Model]
GRAVITY = 9.81
ARM: Law = {"coulomb": 0.6, "breakaway": 1.0, "stribeck_velocity": 0.1, "viscous": 0.05}
LOOP: Law = {"coulomb": 0.3, "breakaway": 0.5, "stribeck_velocity": 0.2, "viscous": 0.02}


def courses(t: np.ndarray, rates: np.ndarray, still: float, least: float = 0.03) -> list[list[int]]:
    """Signs of each joint's rate (N, joints) one after the other, zero within `still`; what is shorter than least [s]
    is left out.
    """
    found = []
    for column in rates.T:
        signs = np.where(np.abs(column) <= still, 0, np.sign(column)).astype(int)
        starts = np.flatnonzero(np.diff(signs, prepend=signs[0] + 5))
        ends = np.append(starts[1:], len(t))
        long = [int(signs[a]) for a, b in zip(starts, ends, strict=True) if (b - a) * (t[1] - t[0]) >= least]
        found.append([sign for k, sign in enumerate(long) if k == 0 or sign != long[k - 1]])
    return found


def arm(drives: Sequence[Callable[[float], float]]) -> Links:
    """Two links of 0.6 m in a plane without weight."""
    return Links([ARM] * 2, (), (0.6, 0.6), (0.1, 0.1), drives)


def drive(t: float) -> float:
    return float(2.2 * np.sin(3 * t))


def second(t: float) -> float:
    return float(1.8 * np.sin(7.1 * t))


def crank(t: float) -> float:
    return float(2.5 * np.sin(2 * t))


def arm_scene(dt: float) -> SceneRecord:
    builder = Scene("rubbing_arm").ground()
    for k in range(2):
        tip = {"tip": {"position": [0.6, 0.0]}}
        builder.rigid(f"l{k}", mass=1.0, inertia=0.1, center_of_mass=[0.3, 0.0], markers=tip)
    builder.revolute("j0", "ground.origin", "l0.origin", friction=ARM)
    builder.revolute("j1", "l0.tip", "l1.origin", friction=ARM)
    builder.effort("d0", coordinate="j0.angle", value="2.2 * sin(3 * t)")
    builder.effort("d1", coordinate="j1.angle", value="1.8 * sin(7.1 * t)")
    return builder.simulation(t_end=6.0, dt=dt, scheme="rk4").build()


LENGTHS, SPAN = (0.4, 1.0, 0.8), 1.2


def four_bar() -> Links:
    """Driven by its crank."""
    return Links([LOOP] * 4, (), LENGTHS, [length**2 / 12 for length in LENGTHS], (crank,), GRAVITY, SPAN)


def four_bar_scene(law: Law, torque: str | None, **simulation: object) -> SceneRecord:
    builder = Scene("rubbing_four_bar").gravity(0.0, -GRAVITY).ground(markers={"right": {"position": [SPAN, 0.0]}})
    for k, length in enumerate(LENGTHS):
        markers = {"tip": {"position": [length, 0.0]}}
        shape = {"inertia": length**2 / 12, "center_of_mass": [length / 2, 0.0], "markers": markers}
        builder.rigid(f"l{k}", mass=1.0, **shape)
    ends = [
        ("ground.origin", "l0.origin"),
        ("l0.tip", "l1.origin"),
        ("l1.tip", "l2.tip"),
        ("ground.right", "l2.origin"),
    ]
    for k, (a, b) in enumerate(ends):
        builder.revolute(f"j{k}", a, b, friction=law)
    if torque is not None:
        builder.effort("drive", coordinate="j0.angle", value=torque)
    builder.initial({"l0.theta": {"value": 0.6, "fixed": True}, "l1.theta": 0.5, "l2.theta": 1.5})
    return builder.simulation(**{"t_end": 6.0, "dt": 0.01, "scheme": "rk4", **simulation}).build()


def seen(run: object, n: int, joints: int) -> tuple[np.ndarray, np.ndarray]:
    """Angles (N, n) and rates of joints (N, joints)."""
    angles = np.stack([run[f"l{k}.theta"] for k in range(n)], axis=1)  # type: ignore[index]
    return angles, np.stack([run[f"j{k}.friction_velocity"] for k in range(joints)], axis=1)  # type: ignore[index]


@pytest.mark.long
def test_a_four_bar_with_four_frictions_holds_to_the_last_bit(model_of: Build) -> None:
    """Four rows hold one motion: nothing creeps in 100 s, and the forces carry the weight with least sum of squares.

    By hand: virtual work of the weight is that of the four moments, which stand in the ratio of the joints' rates.
    """
    run = simulate(model_of(four_bar_scene({"coulomb": 2.0}, None, t_end=100.0, dt=0.05)))
    assert run.status.ok
    assert {one.kind for one in run.events} <= {"start_changed"}  # the angles that are given close the loop nearly
    angles, rates = seen(run, 3, 4)
    assert not np.ptp(angles, axis=0).any() and not rates.any()
    links = Links([LOOP] * 4, (), LENGTHS, (0.0, 0.0, 0.0), (), GRAVITY, SPAN)
    phi = angles[0]
    motion = np.linalg.svd(links.closure(phi)[1])[2][-1]
    ratio = links.G @ motion
    work = links.force(0.0, phi, np.zeros(3)) @ motion
    forces = [run[f"j{k}.friction_force"][-1] for k in range(4)]
    assert forces == pytest.approx((-work * ratio / (ratio @ ratio)).tolist(), rel=1e-9)
    assert sum(abs(force) for force in forces) > 0.5


def test_a_four_bar_slides_and_sticks_as_time_stepping_has_it(model_of: Build) -> None:
    """The first 1.5 s: all slide, rates of single joints pass through zero within the motion, and two reversals."""
    run = simulate(model_of(four_bar_scene(LOOP, "2.5 * sin(2 * t)")), t_end=1.5, dt=0.005, samples=301)
    angles, rates = seen(run, 3, 4)
    links = four_bar()
    errors = []
    for every in (1, 2):
        by_steps, joints = moreau(links, angles[0], 0.005 / every, 1.5)
        errors.append(np.abs(by_steps[::every] - angles).max())
    assert courses(run.t, rates, 0.0) == courses(run.t, joints[::2], 1e-9)
    assert errors[1] < 0.02
    assert errors[0] / errors[1] > 1.6
    assert run.balance.largest < 1e-4


@pytest.mark.long
def test_a_four_bar_changes_alike_at_every_step(model_of: Build) -> None:
    """43 changes in 6 s, five of them at once where it comes to rest, one joint after the other where it starts."""
    model = model_of(four_bar_scene(LOOP, "2.5 * sin(2 * t)"))
    runs = {dt: simulate(model, dt=dt, seen_every=0.02) for dt in (0.01, 0.005, 0.0025)}
    texts = [[event.text for event in run.events] for run in runs.values()]
    assert len(texts[0]) > 40 and texts[0] == texts[1] == texts[2]
    fine, rates = seen(runs[0.0025], 3, 4)
    errors = [np.abs(seen(runs[dt], 3, 4)[0] - fine).max() for dt in (0.01, 0.005)]
    assert errors[1] < 1e-4 and errors[0] / errors[1] > 6
    links = four_bar()
    by_steps = {h: moreau(links, fine[0], h, 6.0) for h in (4e-3, 2e-3)}
    off = [np.abs(angles[:: round(0.02 / h)] - fine).max() for h, (angles, _) in by_steps.items()]
    assert off[1] < 0.015 and off[0] / off[1] > 1.5
    still = ~rates.any(axis=1)
    still[1:-1] &= still[2:] & still[:-2]
    assert still.sum() > 50 and np.abs(by_steps[2e-3][1][::10][still]).max() < 1e-4


@pytest.mark.long
def test_an_arm_is_the_limit_of_time_stepping_and_of_smooth_laws(model_of: Build) -> None:
    """Errors of both fall by the first order; signs of the rates follow one another as in the run."""
    run = simulate(model_of(arm_scene(0.0025)), seen_every=0.01)
    angles, rates = seen(run, 2, 2)
    links = arm((drive, second))
    by_steps = [moreau(links, angles[0], h, 6.0) for h in (2e-3, 1e-3, 5e-4)]
    off = [np.abs(found[:: (len(found) - 1) // 600] - angles).max() for found, _ in by_steps]
    assert off[2] < 3e-3 and off[0] / off[2] > 2.5
    assert courses(run.t, rates, 0.0) == courses(run.t, by_steps[2][1][::20], 1e-9)
    smooth = [_smooth(links, angles[0], eps, run.t) for eps in (1e-2, 1e-3)]
    off = [np.abs(found[:2].T - angles).max() for found in smooth]
    assert off[1] < 0.03 and off[0] / off[1] > 4
    ways = [courses(run.t, one, still) for one, still in ((rates, 0.0), ((links.G @ smooth[1][2:]).T, 2e-3))]
    reversals = [[[sign for sign in joint if sign] for joint in way] for way in ways]  # short rests are not told there
    assert reversals[0] == reversals[1]


def _smooth(links: Links, phi: np.ndarray, eps: float, t: np.ndarray) -> np.ndarray:
    def rates_of(t: float, y: np.ndarray) -> np.ndarray:
        phi, rates = np.split(y, 2)
        v = links.G @ rates
        rubbing = links.G.T @ (links.bounds(v) * np.tanh(v / eps))
        return np.concatenate([rates, np.linalg.solve(links.mass(phi), links.force(t, phi, rates) - rubbing)])

    start = np.concatenate([phi, np.zeros(len(phi))])
    found = solve_ivp(rates_of, (t[0], t[-1]), start, "Radau", t, rtol=1e-7, atol=1e-9)
    return np.asarray(found.y)


ARM_LENGTH, CRANK_LENGTH, FEET = 0.7, 0.4, 0.6
RAISED = {"crank1.theta": 1.9, "crank2.theta": 1.2}


def cranks(name: str) -> Scene:
    """Two cranks on the ground, that fall."""
    builder = Scene(name).gravity(0.0, -GRAVITY).ground(markers={"right": {"position": [FEET, 0.0]}})
    for k, foot in ((1, "origin"), (2, "right")):
        tip = {"tip": {"position": [CRANK_LENGTH, 0.0]}}
        half = [CRANK_LENGTH / 2, 0.0]
        builder.rigid(f"crank{k}", mass=1.0, inertia=CRANK_LENGTH**2 / 12, center_of_mass=half, markers=tip)
        builder.revolute(f"shoulder{k}", f"ground.{foot}", f"crank{k}.origin")
    return builder.simulation(t_end=0.5, dt=1e-3, scheme="rk4")


@pytest.mark.long
def test_a_five_bar_whose_arms_stick_together_is_a_four_bar(model_of: Build) -> None:
    """What sticks has a row whose coefficients change with the motion that is left: its bias acts on the others."""
    builder = cranks("sticking_five_bar")
    for k in (1, 2):
        tip = {"tip": {"position": [ARM_LENGTH, 0.0]}}
        half = [ARM_LENGTH / 2, 0.0]
        builder.rigid(f"arm{k}", mass=1.0, inertia=ARM_LENGTH**2 / 12, center_of_mass=half, markers=tip)
        builder.revolute(f"elbow{k}", f"crank{k}.tip", f"arm{k}.origin")
    builder.revolute("middle", "arm1.tip", "arm2.tip", friction={"coulomb": 1e4})
    held = {name: {"value": value, "fixed": True} for name, value in RAISED.items()}
    run = simulate(model_of(builder.initial({**held, "arm1.theta": 0.6, "arm2.theta": 2.4}).build()))

    angle = float(run["arm2.theta"][0] - run["arm1.theta"][0])  # both arms in the axes of the first, as one body
    along, first = np.array([np.cos(angle), np.sin(angle)]), np.array([ARM_LENGTH, 0.0])
    middles = np.array([first / 2, first - along * ARM_LENGTH / 2])
    inertia = 2 * ARM_LENGTH**2 / 12 + np.sum((middles - middles.mean(axis=0)) ** 2)
    end = {"end": {"position": list(first - along * ARM_LENGTH)}}
    builder = cranks("four_bar_of_them")
    builder.rigid("arm1", mass=2.0, inertia=inertia, center_of_mass=list(middles.mean(axis=0)), markers=end)
    builder.revolute("elbow1", "crank1.tip", "arm1.origin").revolute("elbow2", "crank2.tip", "arm1.end")
    at = {name: float(run[name][0]) for name in ("crank2.theta", "arm1.theta")}
    other = simulate(model_of(builder.initial({"crank1.theta": held["crank1.theta"], **at}).build()))

    assert run.status.ok and other.status.ok and np.ptp(run["crank1.theta"]) > 0.05
    for name in ("crank1.theta", "crank2.theta", "arm1.theta"):
        np.testing.assert_allclose(run[name], other[name], rtol=0, atol=1e-11)
