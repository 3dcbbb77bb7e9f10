"""Ensembles to a tolerance: what is told of each case against motions with far more steps, bits, statuses, refusals."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from functools import cache

import numpy as np
import pytest

from runtime import ArgumentError, SchemeError, load_model
from runtime.contract.coordinates import followed
from runtime.results.motion_error import amplitudes, errors_of_many, motion_error
from runtime.studies.ensemble.refined_rows import shown_orders
from symgen import Scene
from symgen.generate import generate
from symgen.scenes import SCENES

# scene, scheme, tolerance, end [s], ranges of parameters and of initial values
CASES = {
    "pendulum": ("double_pendulum", "rk4", 1e-4, 5.0, {"lower.mass": (0.7, 1.3)}, {"upper.theta": (-0.5, 0.5)}),
    "loose": ("double_pendulum", "rk4", 1e-2, 3.0, {"lower.mass": (0.7, 1.3)}, {"upper.theta": (-0.5, 0.5)}),
    "auto": ("double_pendulum", None, 1e-3, 5.0, {"lower.mass": (0.7, 1.3)}, {"lower.theta": (-0.5, 0.5)}),
}
LONG = {
    "hub": ("hub_beam", "exponential_rk4", 1e-3, 5.0, {"torque": (5.0, 15.0)}, {"hub.theta_dot": (0.0, 0.5)}),
    "arm": ("flexible_joint_arm", "exponential_rk4", 1e-3, 2.0, {"shoulder_torque": (15.0, 35.0)}, {}),
    "fine": ("flexible_joint_arm", "exponential_rk4", 1e-5, 2.0, {"shoulder_torque": (15.0, 35.0)}, {}),
    "crank": (
        "flexible_slider_crank_free", "exponential_rk4", 1e-3, 0.05,
        {"slider.mass": (0.06, 0.09)}, {"crank.theta_dot": (140.0, 160.0)},
    ),
}  # fmt: skip
TURN = np.pi / np.sqrt(3.0)  # rad: RMS of an angle about its mean, modulo a turn: of what turns on
SAMPLES, FINER = 60, 8


def drawn(ranges, n: int, rng) -> dict[str, np.ndarray]:
    return {name: rng.uniform(*both, n) for name, both in ranges.items()}


def told_and_true(case, n: int):
    """(the answer, true RMS errors over amplitudes (cases,)), by the same samples of motions with far more steps."""
    scene, scheme, tolerance, end, parameters, initial = case
    model, rng = SCENES[scene]().model(), np.random.default_rng(5)
    varied = {"parameters": drawn(parameters, n, rng), "initial": drawn(initial, n, rng)}
    names = followed(model)[0]
    asked = {**varied, "outputs": names, "samples": SAMPLES, "t_end": end}
    found = model.ensemble(**asked, scheme=scheme, tolerance=tolerance)
    steps = FINER * int(found["steps"].max())
    near = model.ensemble(**asked, scheme=found.attrs["scheme"], dt=end / steps)
    off = [np.sqrt(np.mean((found[one] - near[one]).values ** 2, axis=1)) for one in names]
    sizes = [amplitude(near[one].values, "theta" in one) for one in names]
    return found, np.max([a / np.maximum(b, 1e-6 * np.max(sizes)) for a, b in zip(off, sizes, strict=True)], axis=0)


def amplitude(values: np.ndarray, angle: bool) -> np.ndarray:
    """RMS about the mean (cases,), of an angle that turns on and on at most that of a whole turn."""
    found = values.std(axis=1)
    return np.where(angle & (np.ptp(values, axis=1) > 2 * np.pi), np.minimum(found, TURN), found)


# Shares of cases that are told less than a third of the truth: coarse levels of these two show a chance order.
TOO_SMALL = {"loose": 0.12, "arm": 0.15}


def check(name: str) -> None:
    """Cases meet the tolerance that they are said to meet, and few are told far too small."""
    found, true, tolerance = answered(name)
    assert (found["status"] == "completed").mean() > 0.98
    assert (true <= tolerance).mean() >= 0.98
    assert np.mean(true > 3 * found["error"].values) <= TOO_SMALL.get(name, 0.1)


# Shares of cases that are told within a factor of 3; 0.9 is asked, and met by the ten cases of the benchmark
# `ensemble_tolerance`. Where errors of several modes cancel at some step, or a step is far from where the order shows,
# a case is told too large, up to 115 times.
WITHIN_THREE = {"pendulum": 0.9, "loose": 0.75, "auto": 0.65, "hub": 0.9, "arm": 0.7, "fine": 0.65, "crank": 0.9}


def check_factor(name: str) -> None:
    """Half of the cases are told closely, the others rather too large."""
    found, true, _ = answered(name)
    ratio = found["error"].values / true
    assert np.mean((ratio >= 1 / 3) & (ratio <= 3)) >= WITHIN_THREE[name]
    assert 0.7 < np.median(ratio) < 2.5


@cache
def answered(name: str):
    case = {**CASES, **LONG}[name]
    return *told_and_true(case, 200), case[2]


@pytest.mark.every_push("pendulum")
@pytest.mark.parametrize("name", CASES)
def test_cases_are_within_the_tolerance(name) -> None:
    check(name)


@pytest.mark.long
@pytest.mark.parametrize("name", LONG)
def test_cases_of_stiff_motions_are_within_the_tolerance(name) -> None:
    check(name)


@pytest.mark.parametrize("name", CASES)
def test_what_is_told_is_near_the_truth(name) -> None:
    check_factor(name)


@pytest.mark.long
@pytest.mark.parametrize("name", LONG)
def test_what_is_told_of_stiff_motions_is_near_the_truth(name) -> None:
    check_factor(name)


def test_errors_of_many_motions_are_those_of_each() -> None:
    """`errors_of_many` against `motion_error`, motion by motion: what rests, turns on, moves, and states."""
    scene = Scene("all_kinds").rigid("wheel", mass=1.0, inertia=0.1).revolute("axle", "ground.origin", "wheel.origin")
    scene.rigid("block", mass=1.0, inertia=0.1).prismatic("rail", "ground.origin", "block.origin")
    scene.state("level", rate="-level", initial=1.0)
    model, rng = scene.model(), np.random.default_rng(3)
    n = len(followed(model)[0])
    t = np.linspace(0.0, 1.0, 40)
    y = np.cumsum(rng.normal(size=(5, 2 * n, 40)), axis=2) * 10.0 ** rng.uniform(-3, 1, (5, 2 * n, 1))
    y[1, 0] = 0.0
    other = y + 1e-3 * rng.normal(size=y.shape) * np.abs(y).max(axis=2, keepdims=True)
    relative, rates = errors_of_many(model, y, other)
    for k in range(5):
        (q, v), (other_q, other_v) = ((one[k, :n].T, one[k, n:].T) for one in (y, other))
        sizes = amplitudes(model, np.concatenate([q, other_q]))
        each = motion_error(model, t, q, other_q, sizes, (v, other_v))
        assert relative[k] == pytest.approx(list(each.relative.values()), rel=1e-12)
        told = [each.judged[f"{name}_dot"] for name in followed(model)[0]]
        assert rates[k] == pytest.approx(told, rel=1e-12)


@pytest.mark.parametrize("ratios", [(2.0, 2.0), (1.3, 1.7)])
@pytest.mark.parametrize("order", [1.0, 2.0, 4.0])
def test_three_levels_show_their_order(order: float, ratios: tuple[float, float]) -> None:
    """Errors C h^p at h, h / r1, h / (r1 r2), by their differences."""
    h = np.array([1.0, 1 / ratios[0], 1 / (ratios[0] * ratios[1])])
    first, second = -np.diff(h**order)
    shown = shown_orders(np.array([first / second]), np.array([ratios[0]]), np.array([ratios[1]]))
    assert shown == pytest.approx(order, abs=0.06)  # the spacing of the orders that are tried


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    scene = (
        Scene("told_pendulum").parameter("l", 0.5).gravity(0, -9.81)
        .rigid("arm", mass=1.0, inertia=0.1, center_of_mass=("l", 0))
        .revolute("pin", "ground.origin", "arm.origin")
    )  # fmt: skip
    return load_model(generate(scene.build(), tmp_path_factory.mktemp("made") / "pendulum"))


ASKED = {
    "parameters": {"l": np.linspace(0.3, 0.7, 90)},
    "initial": {"arm.theta": 0.2},
    "tolerance": 1e-5,
    "t_end": 1.0,
    "reduce": {"arm.theta": ["end", "peak"], "arm.theta_dot": "rms"},
}


@pytest.fixture(scope="module")
def here(model):
    return model.ensemble(**ASKED, workers=1)


def test_workers_parts_and_neighbours_leave_the_bits(model, here, tmp_path) -> None:
    assert model.ensemble(**ASKED, workers=2).identical(here)
    with ThreadPoolExecutor(2) as pool:
        assert model.ensemble(**ASKED, executor=pool, chunk=7).identical(here)
    folder = tmp_path / "study"
    assert model.ensemble(**ASKED, folder=folder, chunk=40).identical(here)
    (folder / "part-000000040.npz").unlink()
    assert model.ensemble(**ASKED, folder=folder, chunk=40).identical(here)
    with pytest.raises(ArgumentError, match="another study"):
        model.ensemble(**{**ASKED, "tolerance": 1e-4}, folder=folder, chunk=40)


def test_a_case_is_the_run_with_its_steps(model, here) -> None:
    for case in (0, 44, 89):
        steps, length = int(here["steps"][case]), float(here["l"][case])
        alone = model.simulate(
            scheme=here.attrs["scheme"], dt=1.0 / steps, t_end=1.0, seen_every=1.0, force=True,
            parameters={"l": length}, initial={"arm.theta": 0.2}, outputs=["arm.theta"],
        )  # fmt: skip
        assert float(here["arm.theta_end"][case]) == alone.outputs["arm.theta"][-1]


def test_histories_keep_their_times_and_have_errors(model) -> None:
    asked = {name: value for name, value in ASKED.items() if name != "reduce"}
    asked |= {"outputs": ["arm.theta", "kinetic"], "seen_every": 0.3}
    found = model.ensemble(**asked)
    assert found["time"].values == pytest.approx([0.0, 0.3, 0.6, 0.9, 1.0])
    assert found["arm.theta"].shape == (90, 5)
    assert (found["status"] == "completed").all()
    near = model.ensemble(
        asked["parameters"], asked["initial"], scheme="rk4", dt=1e-4, t_end=1.0,
        outputs=["arm.theta"], seen_every=0.3,
    )  # fmt: skip
    off = np.sqrt(np.mean((found["arm.theta"] - near["arm.theta"]).values ** 2, axis=1))
    assert np.mean(off <= 5 * found["error.arm.theta"].values) >= 0.9
    assert found["error.arm.theta"].attrs["units"] == "rad"
    assert "dt" not in found.attrs and found.attrs["tolerance"] == 1e-5


@pytest.mark.long
def test_cases_with_impacts_and_friction_are_told_as_others() -> None:
    """A pendulum with a stop and friction in its hinge, against runs to 1e-8."""
    scene = (
        Scene("swing")
        .parameter("l", 0.5)
        .gravity(0, -9.81)
        .rigid("arm", mass=1.0, inertia=0.1, center_of_mass=("l", 0))
    )
    stop, friction = {"lower": -2.5, "restitution": 0.6}, {"coulomb": 0.05}
    model = scene.revolute("pin", "ground.origin", "arm.origin", limits=stop, friction=friction).model()
    lengths, asked = np.linspace(0.4, 0.6, 6), {"t_end": 2.0, "outputs": ["arm.theta"], "samples": 20}
    found = model.ensemble({"l": lengths}, {"arm.theta": -0.5}, tolerance=1e-4, **asked)
    assert (found["status"] == "completed").all()
    for case, length in enumerate(lengths):
        near = model.simulate(parameters={"l": float(length)}, initial={"arm.theta": -0.5}, tolerance=1e-8, **asked)
        assert len(near.events) >= 3
        exact = near.outputs["arm.theta"]
        true = np.sqrt(np.mean((found["arm.theta"].values[case] - exact) ** 2)) / np.std(exact)
        assert true <= 1e-4 and true / 3 <= found["error"].values[case] <= 3 * true


@pytest.mark.long
def test_contacts_that_no_level_resolves_are_not_completed() -> None:
    """A pendulum on a very stiff stop keeps its energy, or is said to be inaccurate; the others never come to it."""
    scene = Scene("on_a_stop").parameter("k", 2e7).rigid("rod", mass=1.0, inertia=1.0)
    scene.revolute("pin", "ground.origin", "rod.origin").measure("a", "angle", of="rod.origin")
    model = scene.torque("drive", "rod.origin", "-10*sin(a) + where(a < -1.2, k*(-1.2 - a), 0)").model()
    start, names = np.array([0.1, 0.2, 0.3, 1.5]), ["rod.theta", "rod.theta_dot"]
    found = model.ensemble(
        None, {"rod.theta": start}, scheme="rk4", tolerance=1e-2, t_end=2.0, reduce=dict.fromkeys(names, "end")
    )
    theta, rate = (found[f"{name}_end"].values for name in names)
    energy = rate**2 / 2 + 10 * (1 - np.cos(theta)) + 1e7 * np.minimum(theta + 1.2, 0) ** 2
    lost = np.abs(energy / (10 * (1 - np.cos(start))) - 1)
    done = found["status"].values == "completed"
    assert done[:3].all() and (lost[done] < 0.05).all()
    assert set(found["status"].values[~done]) <= {"inaccurate"}


@pytest.mark.long
def test_cases_without_an_answer_are_not_completed() -> None:
    """A chaotic double pendulum for so long that no step of this price reaches the tolerance."""
    model, n = SCENES["double_pendulum"]().model(), 10
    rng = np.random.default_rng(2)
    found = model.ensemble(
        initial={"upper.theta": rng.uniform(1.5, 2.8, n), "lower.theta": rng.uniform(1.5, 2.8, n)},
        scheme="rk4", tolerance=1e-4, t_end=12.0, reduce={"upper.theta": "end"},
    )  # fmt: skip
    missed = found["status"].values == "inaccurate"
    assert missed.any()
    told = found["error"].values[missed]
    assert (np.isnan(told) | (told > 1e-4 / 3)).all()
    assert (found["error"].values[~missed] <= 1e-4).all()
    assert np.isfinite(found["upper.theta_end"].values[missed]).all()


@pytest.mark.parametrize(
    ("given", "named"),
    [
        ({"dt": 1e-3}, "dt"),
        ({"tolerance": 0.0}, "tolerance"),
        ({"tolerance": "fine"}, "tolerance"),
        ({"tolerance": float("nan")}, "tolerance"),
        ({"m": [2]}, "auto"),
        ({"scheme": "rk4", "options": {"error_of": "step"}}, "error_of"),
        ({"scheme": "euler"}, "euler"),
    ],
)
def test_what_does_not_go_with_a_tolerance_is_refused(model, given, named) -> None:
    with pytest.raises((SchemeError, ArgumentError), match=named):
        model.ensemble(**{**ASKED, **given})
