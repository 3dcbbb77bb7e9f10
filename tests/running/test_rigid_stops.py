"""Rigid stops of joints: closed forms of bounces, laws of impacts, rests, starts, and what is refused."""

from __future__ import annotations

from collections.abc import Callable
from math import pi, sqrt
from typing import Any

import numpy as np
import pytest

from runtime import SCHEMES, InitialStateError, Model, ModelError, ensemble, simulate
from runtime.schemes.switching.settle import settled
from symgen.scene import Scene, SceneError, SceneRecord

Build = Callable[[SceneRecord], Model]
REST = 4.063712768872  # s: sqrt(2 / g) (1 + 2 (.8 + .8^2 + ...)) = 9 sqrt(2 / 9.81)


def ball(e: float | str, **limits: Any) -> Scene:
    """1 kg that falls by 1 m along an upright rail onto a stop."""
    scene = Scene("ball").gravity(0.0, -9.81).rigid("ball", mass=1.0, inertia=0.1)
    scene.ground(markers={"up": {"position": (0.0, 0.0), "angle": pi / 2}})
    scene.prismatic("rail", "ground.up", "ball.origin", limits={"lower": 0.0, "restitution": e, **limits})
    return scene.initial({"ball.y": 1.0}).simulation(t_end=5.0, dt=0.01, scheme="rk4")


def rod(space: str, e: float, **fields: Any) -> Scene:
    """A rod that falls from level onto a stop 1 rad below; its angle is rod.theta, or pin.angle in space."""
    spatial = space == "spatial"
    scene = Scene("rod", space=space).gravity(*((0.0, -9.81, 0.0)[: 3 if spatial else 2]))
    about: Any = (0.1, 0.1, 0.1) if spatial else 0.1
    centre = (0.5, 0.0, 0.0) if spatial else (0.5, 0.0)
    scene.rigid("rod", mass=1.0, inertia=about, center_of_mass=centre)
    scene.revolute("pin", "ground.origin", "rod.origin", limits={"lower": -1.0, "restitution": e}, **fields)
    return scene.simulation(t_end=3.0, dt=0.01, scheme="rk4")


def links(n: int, random: np.random.Generator, friction: bool) -> SceneRecord:
    """A chain of unlike links whose joints have stops at parameters low0, high0, ..."""
    scene, last = Scene("links").gravity(0.0, -9.81), "ground.origin"
    for k in range(n):
        length, mass = random.uniform(0.3, 1.2, 2)
        scene.rigid(f"link{k}", mass=mass, inertia=0.1 * mass, center_of_mass=(length / 2, 0.1 * length),
                    markers={"tip": {"position": (length, 0.0)}})  # fmt: skip
        scene.parameter(f"low{k}", -9.0, "rad").parameter(f"high{k}", 9.0, "rad")
        limits = {"lower": f"low{k}", "upper": f"high{k}", "restitution": round(float(random.uniform()), 3)}
        more = {"friction": {"coulomb": 0.4}} if friction and k % 2 else {}
        scene.revolute(f"hinge{k}", last, f"link{k}.origin", limits=limits, **more)
        last = f"link{k}.tip"
    return scene.simulation(t_end=1.0, dt=0.005, scheme="rk4").build()


@pytest.mark.every_push("rk4", "radau", "single_rate")
@pytest.mark.parametrize("scheme", list(SCHEMES))
def test_bounces_come_to_rest_when_their_sum_says(model_of: Build, scheme: str) -> None:
    """Infinitely many in 9 sqrt(2 h / g); what is told of them balances the energy, and what rests does not move."""
    run = simulate(model_of(ball(0.8).build()), scheme=scheme, error="off")
    assert run.status.ok
    assert [one.time for one in run.events if one.kind == "rest"] == pytest.approx([REST], abs=1e-8)
    hits = [one.time for one in run.events if one.kind == "impact"]
    flights = np.diff(hits[:20])
    assert flights == pytest.approx(2 * sqrt(2 / 9.81) * 0.8 ** np.arange(1, 20), rel=1e-5, abs=1e-10)
    rests = run.t > REST
    assert np.abs(run["ball.y_dot"][rests]).max() < 1e-12 and np.ptp(run["ball.y"][rests]) < 1e-12
    assert not run["rail.lower_mode"][rests].any() and (run["rail.lower_mode"][run.t < REST - 1e-3] == 1).all()
    assert run.balance.largest < 1e-8


@pytest.mark.every_push("how0")
@pytest.mark.parametrize("how", [{"dt": 0.5}, {"scheme": "auto", "tolerance": 1e-6}])
def test_the_time_of_rest_does_not_hang_on_the_step(model_of: Build, how: dict[str, Any]) -> None:
    run = simulate(model_of(ball(0.8).build()), **how)
    assert [one.time for one in run.events if one.kind == "rest"] == pytest.approx([REST], abs=1e-8)
    assert run.status.ok and run.error.largest < 1e-6


def test_plastic_loses_all_and_elastic_keeps_all(model_of: Build) -> None:
    """At an impact by 4.4 m/s, and over five of them: to 1e-13 of the energy."""
    run = simulate(model_of(ball(0.0).build()))
    assert run["ball.y_dot"][-1] == 0 and [one.kind for one in run.events] == ["impact", "mode"]
    assert run.energy["kinetic"][-1] + run.energy["potential"][-1] == pytest.approx(0.0, abs=1e-10)  # 2e-12 m deep
    assert run.balance.largest < 1e-13
    run = simulate(model_of(ball(1.0).build()))
    energy = run.energy["kinetic"] + run.energy["potential"]
    assert np.ptp(energy) < 1e-13 * energy[0] and len(run.events) == 6
    s = run.t[-1] - (2 * 5 + 1) * sqrt(2 / 9.81)  # since the sixth
    assert run["ball.y"][-1] == pytest.approx(sqrt(2 * 9.81) * s - 9.81 * s**2 / 2, abs=1e-9)


def test_forces_and_impulses_of_a_stop_are_outputs(model_of: Build, tmp_path: Any) -> None:
    """Impulses m v (1 + e) of each bounce, and the weight once it rests, as a column of files, too."""
    run = simulate(model_of(ball(0.8).build()))
    stop, first = run.stop("rail"), sqrt(2 * 9.81)
    assert stop.impulses[:5, 1] == pytest.approx([1.8 * first * 0.8**k for k in range(5)], rel=1e-9)
    assert stop.impulses[0, 0] == pytest.approx(first / 9.81, abs=1e-11)
    at_rest = run.t > REST
    assert stop.force[at_rest] == pytest.approx(9.81, rel=1e-13) and not stop.force[~at_rest].any()
    assert (run["rail.stop_force"] == stop.force).all()
    run.export(tmp_path / "run.csv")
    assert "rail.stop_force [N]" in (tmp_path / "run.csv").read_text().splitlines()[0]
    run.save(tmp_path / "run.npz")
    kept = type(run).load(tmp_path / "run.npz", run.model).stop("rail")
    assert (kept.force == stop.force).all() and (kept.impulses == stop.impulses).all()
    with pytest.raises(ModelError, match="no joint with friction 'rail'"):
        run.friction("rail")


def test_a_stop_tells_of_its_own_joint_only(model_of: Build) -> None:
    """One ball bounces, a block beside it is held by friction of 30 N before its stop, another one by its stop.

    What a stop gave, and its force, is what momentum changes by beside gravity; what friction holds is not the stop's.
    """
    scene = Scene("three").gravity(0.0, -9.81)
    scene.ground(markers={"up": {"position": (0.0, 0.0), "angle": pi / 2}})
    for name, more in (("ball", {}), ("block", {"friction": {"coulomb": 30.0}}), ("weight", {})):
        scene.rigid(name, mass=2.0, inertia=0.1)
        limits = {"lower": 0.0, "restitution": 0.5}
        scene.prismatic(f"{name}_rail", "ground.up", f"{name}.origin", limits=limits, **more)
    scene.initial({"ball.y": 1.0, "block.y": 0.5, "weight.y": 0.0}).simulation(t_end=1.0, dt=0.01, scheme="rk4")
    run = simulate(model_of(scene.build()), seen_every=0.0)
    for name in ("ball", "block", "weight"):
        stop = run.stop(f"{name}_rail")
        gave = stop.impulses[:, 1].sum() + np.trapezoid(stop.force, run.t)
        held = -np.trapezoid(run.friction("block_rail").force, run.t) if name == "block" else 0.0
        momentum = 2.0 * (run[f"{name}.y_dot"][-1] - run[f"{name}.y_dot"][0])
        assert gave + abs(held) - 2.0 * 9.81 * run.t[-1] == pytest.approx(momentum, abs=1e-9), name
    assert len(run.stop("ball_rail").impulses) == 2
    assert run.stop("block_rail").impulses.shape == (0, 2) and not run.stop("block_rail").force.any()
    assert run.stop("block_rail").at_rest == 0 and run.stop("weight_rail").at_rest == pytest.approx(1.0)


@pytest.mark.every_push("0.0", "0.17")
@pytest.mark.parametrize("falls", [0.0, 0.1, 0.17, 0.23, 0.3])
def test_a_ball_that_rests_is_held_when_it_is_struck(model_of: Build, falls: float) -> None:
    """The lower ball lies on the ground, or has come to rest there to rounding; the upper one falls on it by 1 m and
    leaves with e v: the ground holds.
    """
    scene = Scene("two").gravity(0.0, -9.81).ground(markers={"up": {"position": (0.0, 0.0), "angle": pi / 2}})
    scene.rigid("lower", mass=3.0, inertia=0.1).rigid("upper", mass=1.0, inertia=0.1)
    scene.prismatic("ground_rail", "ground.up", "lower.origin", limits={"lower": 0.0, "restitution": 0.0})
    scene.prismatic("between", "lower.origin", "upper.origin", limits={"lower": 0.0, "restitution": 0.6})
    scene.initial({"lower.y": falls, "upper.y": 1.0}).simulation(t_end=0.95, dt=0.01, scheme="rk4")
    run = simulate(model_of(scene.build()), seen_every=0.0)
    hit, v = sqrt(2 / 9.81), sqrt(2 * 9.81)
    rests, after = run.t > sqrt(2 * falls / 9.81) + 1e-9, run.t > hit
    assert run["lower.y"][rests] == pytest.approx(0.0, abs=1e-10) and not run["lower.y_dot"][rests].any()
    flying = 0.6 * v * (run.t[after] - hit) - 9.81 * (run.t[after] - hit) ** 2 / 2
    assert run["upper.y"][after] == pytest.approx(flying, abs=1e-9)
    assert run.stop("between").impulses == pytest.approx(np.array([[hit, 1.6 * v]]), abs=1e-9)
    assert run.stop("ground_rail").force[-1] == pytest.approx(3.0 * 9.81, rel=1e-12)
    assert run.balance.largest < 1e-9


def test_an_upper_stop_pushes_back(model_of: Build) -> None:
    """Its force and impulse are negative along the coordinate: a block that is pressed on by 10 N."""
    scene = Scene("press").rigid("m", mass=2.0, inertia=0.1).rates({"m.x": 1.0}).force("press", "m.origin", 10.0, 0.0)
    scene.prismatic("rail", "ground.origin", "m.origin", limits={"upper": 0.1, "restitution": 0.0})
    stop = simulate(model_of(scene.simulation(t_end=0.5, dt=0.01, scheme="rk4").build())).stop("rail")
    assert stop.force[-1] == pytest.approx(-10.0, rel=1e-13)
    assert stop.impulses[:, 1] == pytest.approx([-2 * sqrt(1 + 2 * 5 * 0.1)], rel=1e-10)


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_a_rod_upon_a_stop(model_of: Build, space: str) -> None:
    """Its first speed by its energy, then e times that; it comes to rest and is held against its weight."""
    angle = "rod.theta" if space == "planar" else "pin.angle"
    run = simulate(model_of(rod(space, 0.6).build()))
    inertia, speed = 0.1 + 0.25, sqrt(9.81 * np.sin(1.0) / 0.35)
    hits = [one for one in run.events if one.kind == "impact"]
    words = hits[0].text.split()
    assert (float(words[4]), float(words[8][:-1])) == pytest.approx((speed, 0.6 * speed), rel=2e-5)
    assert float(words[9]) == pytest.approx(inertia * speed**2 * (1 - 0.36) / 2, rel=1e-5)
    rests = [one.time for one in run.events if one.kind == "rest"]
    assert len(rests) == 1 and run[angle][-1] == pytest.approx(-1.0, abs=1e-9) and run[f"{angle}_dot"][-1] == 0
    assert run.balance.largest < 1e-6 and run.error.largest < 1e-6


@pytest.mark.every_push("0.37-0.31")
@pytest.mark.parametrize("inertia, centre", [(0.1, 0.5), (0.37, 0.31), (1.3, 0.31)])
def test_an_arm_upon_a_plastic_stop_does_the_same_at_any_speed(model_of: Build, inertia: float, centre: float) -> None:
    """Without weight the way does not depend on the speed, and rounding at 1e6 rad/s is no motion of what rests."""
    scene = Scene("whip").rigid("rod", mass=1.0, inertia=inertia, center_of_mass=(centre, 0.0),
                                markers={"tip": {"position": (1.0, 0.0)}})  # fmt: skip
    scene.rigid("arm", mass=0.7, inertia=0.1, center_of_mass=(centre, 0.1)).revolute("elbow", "rod.tip", "arm.origin")
    scene.revolute("pin", "ground.origin", "rod.origin", limits={"lower": -1.0, "restitution": 0.0})
    model, ends, told = model_of(scene.simulation(t_end=1.5, dt=0.01, scheme="rk4").build()), [], []
    for w in (1.0, 1e4, 1e6):
        start = {"rod.theta_dot": -w, "arm.theta_dot": -2.0 * w}
        run = simulate(model, initial=start, t_end=1.5 / w, dt=0.01 / w, error="off")
        told.append([(one.kind, round(one.time * w, 6)) for one in run.events])
        ends.append(run.q[-1])
        assert run.status.ok
    assert told[0] == told[1] == told[2] and told[0][0][0] == "impact"
    assert ends[1] == pytest.approx(ends[0], abs=1e-7) and ends[2] == pytest.approx(ends[0], abs=1e-7)


def test_the_order_of_a_scheme_is_kept_across_impacts(model_of: Build) -> None:
    model = model_of(rod("planar", 0.6).build())
    ends = [simulate(model, t_end=1.2, dt=dt, error="off")["rod.theta"][-1] for dt in (0.02, 0.01, 0.005, 0.00125)]
    errors = np.abs(np.array(ends[:3]) - ends[3])
    assert np.log2(errors[:-1] / errors[1:]).min() > 3.5 and errors[2] < 1e-8


def test_a_rattle_between_two_stops_is_geometric(model_of: Build) -> None:
    """The n-th way takes (b - a) / (v e^n); what is lost is told."""
    scene = Scene("rattle").rigid("m", mass=2.0, inertia=0.1).rates({"m.x": 4.0})
    scene.prismatic("rail", "ground.origin", "m.origin", limits={"lower": -0.1, "upper": 0.3, "restitution": 0.9})
    run = simulate(model_of(scene.simulation(t_end=2.0, dt=0.01, scheme="rk4").build()))
    ways = 0.4 / (4.0 * 0.9 ** np.arange(1, len(run.events)))
    assert [one.time for one in run.events] == pytest.approx(0.075 + np.append(0.0, ways.cumsum()), abs=1e-9)
    assert [one.name for one in run.events[:3]] == [f"rail.limits.{end}" for end in ("upper", "lower", "upper")]
    assert abs(run["m.x_dot"][-1]) == pytest.approx(4.0 * 0.9 ** len(run.events), rel=1e-12)
    assert run.balance.largest < 1e-12


@pytest.mark.every_push("slider.x")
@pytest.mark.parametrize("independent", ["crank.theta", "slider.x"])
def test_a_slider_crank_at_its_end_stop(model_of: Build, independent: str) -> None:
    """One degree of freedom: all its rates turn back by e, whatever is independent, and e^2 of the energy is left."""
    scene = Scene("slider_crank").ground()
    tip = {"tip": {"position": (0.3, 0.0)}}
    scene.rigid("crank", mass=1.0, inertia=0.02, center_of_mass=(0.15, 0.0), markers=tip)
    scene.rigid("rod", mass=0.6, inertia=0.03, center_of_mass=(0.4, 0.0), markers={"tip": {"position": (0.8, 0.0)}})
    scene.rigid("slider", mass=2.0, inertia=0.1)
    scene.revolute("main", "ground.origin", "crank.origin").revolute("big", "crank.tip", "rod.origin")
    scene.revolute("small", "rod.tip", "slider.origin")
    scene.prismatic("rail", "ground.origin", "slider.origin", limits={"upper": 1.0, "restitution": 0.5})
    scene.initial({"crank.theta": 1.2}).rates({"crank.theta": -5.0}).independent(independent)
    model = model_of(scene.simulation(t_end=0.35, dt=1e-3, scheme="rk4").build())
    run = simulate(model)
    (hit,) = run.events
    after = int(np.searchsorted(run.t, hit.time))
    kinetic = run.energy["kinetic"]
    assert np.ptp(kinetic[:after]) < 1e-8 * kinetic[0] and np.ptp(kinetic[after:]) < 1e-8 * kinetic[0]
    assert kinetic[-1] == pytest.approx(kinetic[0] / 4, rel=1e-8)
    assert run["slider.x"].max() < 1.0 + 1e-9 and run.balance.largest < 1e-9


def test_a_flexible_link_upon_a_stop(model_of: Build) -> None:
    """The hub turns back, its beam swings on: the impulse acts on the hub alone, and takes (1 - e^2) v^2 / 2A."""
    flat = {"lateral": {"ends": "clamped-free", "modes": 3}, "second_moment": 2e-9}
    scene = Scene("arm").beam("arm", length=1.0, density=2700.0, area=1e-4, youngs_modulus=7e10, **flat)
    scene.revolute("pin", "ground.origin", "arm.start", limits={"upper": 0.5, "restitution": 0.4})
    scene.rates({"arm.theta": 2.0})
    model = model_of(scene.simulation(t_end=0.5, dt=2e-4, scheme="exponential_rk4").build())
    run = simulate(model)
    hit = next(one for one in run.events if one.kind == "impact")
    at = {"q_i": np.zeros(4), "q_d": np.zeros(len(model.q_d)), "q_i_dot": np.zeros(4), "t": 0.0}
    c = model.constants(model.parameter_vector())
    own = model.evaluate("elements", **at, q_d_dot=np.zeros(len(model.q_d)), c=c)
    A = np.linalg.inv(np.array(own["M_hat"]))[model.q_i.index("arm.theta"), model.q_i.index("arm.theta")]
    assert float(hit.text.split()[9]) == pytest.approx((1 - 0.16) * 2.0**2 / (2 * A), rel=1e-5)
    after = int(np.searchsorted(run.t, hit.time))
    assert run["arm.theta"].max() < 0.5 + 1e-9 and run["arm.theta_dot"][after] < 0
    assert np.abs(run.energy["elastic"][after:]).max() > 1e-3  # it swings
    assert run.status.ok and run.balance.largest < 1e-4 * run.energy["kinetic"][0]


@pytest.mark.every_push("3-False", "2-True")
@pytest.mark.parametrize("friction", [False, True])
@pytest.mark.parametrize("n", [2, 3, 5])
def test_impacts_of_random_mechanisms_obey_their_law(model_of: Build, n: int, friction: bool) -> None:
    """Momentum changes along what is touched only, impulses push, nobody comes nearer, energy is lost as p says."""
    random = np.random.default_rng(n)
    model = model_of(links(n, random, friction))
    stops = [k for k, one in enumerate(model.mode_events) if one.side]
    for _ in range(20):
        angles, rates = random.uniform(-1, 1, n), random.normal(size=n) * 3
        touched = [(k, side) for k in range(n) for side in ("low", "high") if random.random() < 0.4]
        ends = {f"{side}{k}": float(angles[k]) for k, side in {k: (k, s) for k, s in touched}.values()}
        p = model.parameter_vector(ends)
        c = model.constants(p)
        at: dict[str, Any] = {"q_i": np.cumsum(angles), "q_i_dot": np.cumsum(rates), "t": 0.0, "c": c}
        at["q_d"] = model.evaluate("closure", **at, q_d=np.zeros(len(model.q_d)))["q_d_next"]
        at["q_d_dot"] = model.evaluate("velocities", **at)["q_d_dot"]
        at = {key: np.asarray(value).ravel() for key, value in at.items()}
        none = np.zeros(len(model.mode_events))
        found = settled(model, {key: at[key] for key in at if key != "c"}, c, none.astype(bool), none)
        assert found is not None
        own = {name: np.asarray(value) for name, value in model.evaluate("elements", **at).items()}
        side = np.array([model.mode_events[k].side for k in stops])
        G = side[:, None] * own["G"][[model.mode_events[k].row for k in stops]]
        near, e, M = own["gap"].ravel() < 1e-9, own["restitution"].ravel(), own["M_hat"]
        before, after = G @ at["q_i_dot"], G @ (at["q_i_dot"] + found.push)
        impulse, rest = np.linalg.lstsq(G[near].T, M @ found.push, rcond=None)[:2]
        assert np.abs(G[near].T @ impulse - M @ found.push).max(initial=0.0) < 1e-9, rest
        assert (after[near] > -1e-9).all() and (impulse > -1e-8).all()
        if len(found.impacts) == 1:
            k = stops.index(found.impacts[0].k)
            A = G[k] @ np.linalg.solve(M, G[k])
            if np.abs(np.delete(impulse, np.flatnonzero(np.flatnonzero(near) == k))).max(initial=0.0) < 1e-9:
                assert after[k] == pytest.approx(-e[k] * before[k], abs=1e-8)
                taken = [v @ M @ v / 2 for v in (at["q_i_dot"], at["q_i_dot"] + found.push)]
                assert taken[0] - taken[1] == pytest.approx((1 - e[k] ** 2) * before[k] ** 2 / (2 * A), rel=1e-7)
        taken = [v @ M @ v for v in (at["q_i_dot"], at["q_i_dot"] + found.push)]
        assert taken[1] <= taken[0] * (1 + 1e-12)


@pytest.mark.long
def test_links_between_stops_change_modes_alike_at_every_step(model_of: Build) -> None:
    """With friction, hundreds of impacts: as many, of the same stops, with half the step; angles stay within."""
    scene, last = Scene("links").gravity(0.0, -9.81), "ground.origin"
    for k in range(3):
        scene.rigid(f"link{k}", mass=1.0, inertia=0.08, center_of_mass=(0.5, 0.0),
                    markers={"tip": {"position": (1.0, 0.0)}})  # fmt: skip
        more = {"friction": {"coulomb": 0.3}} if k == 1 else {}
        limits = {"lower": -0.6, "upper": 0.4, "restitution": 0.5}
        scene.revolute(f"hinge{k}", last, f"link{k}.origin", limits=limits, **more)
        last = f"link{k}.tip"
    model = model_of(scene.simulation(t_end=1.5, dt=0.005, scheme="rk4").build())
    runs = [simulate(model, dt=dt, error="off", seen_every=0.005) for dt in (0.005, 0.0025)]
    told = [[(one.kind, one.name) for one in run.events] for run in runs]
    assert told[0] == told[1] and len(told[0]) > 60
    assert np.abs(runs[0].q_i - runs[1].q_i).max() < 1e-4
    joints = np.diff(runs[1].q_i, axis=1, prepend=0.0)
    assert joints.min() > -0.6 - 1e-8 and joints.max() < 0.4 + 1e-8
    assert runs[1].balance.largest < 1e-2


def test_friction_and_a_plastic_stop_in_one_joint(model_of: Build) -> None:
    """Case (b) of the Friction example of the Modelica Standard Library from its start on: digits as printed there."""
    friction = {"coulomb": 3.0, "stribeck": 5.0, "breakaway": 8.008, "stribeck_velocity": 0.5, "viscous": 1.0}
    scene = Scene("spring").rigid("block", mass=1.0, inertia=0.1).measure("x", "x", "block.origin")
    limits = {"lower": -0.4, "upper": 0.4, "restitution": 0.0}
    scene.prismatic("rail", "ground.origin", "block.origin", friction=friction, limits=limits)
    scene.force("spring", "block.origin", "-500 * (x + 0.25)", 0.0).rates({"block.x": -5.0})
    run = simulate(model_of(scene.simulation(t_end=10.0, dt=0.001, scheme="rk4").build()))
    assert run.events[0].time == pytest.approx(0.060597096, abs=1e-9)
    assert run.events[-1].time == pytest.approx(1.045973749, abs=2e-9)
    assert run["x"][-1] == pytest.approx(-0.2475140, abs=1e-7) and np.ptp(run["x"][1060:]) == 0.0


@pytest.mark.parametrize("coulomb", [0.0, 2.0])
def test_a_stop_lets_go_when_it_would_pull(model_of: Build, coulomb: float) -> None:
    """Pressed by 10 N that falls by 10 N/s: it opens when that is gone, with friction of 2 N when it is beyond that."""
    scene = Scene("press").rigid("m", mass=1.0, inertia=0.1).rates({"m.x": 1.0})
    more = {"friction": {"coulomb": coulomb}} if coulomb else {}
    scene.prismatic("rail", "ground.origin", "m.origin", limits={"upper": 0.1, "restitution": 0.0}, **more)
    scene.force("press", "m.origin", "10 - 10 * t", 0.0)
    run = simulate(model_of(scene.simulation(t_end=2.0, dt=0.01, scheme="rk4").build()))
    opens = [one.time for one in run.events if one.text.endswith("opens")]
    assert opens == pytest.approx([1.0 + coulomb / 10], abs=1e-9)
    s = 2.0 - opens[0]
    assert run["m.x"][-1] == pytest.approx(0.1 - 10 * s**3 / 6, abs=1e-9)


def test_a_stop_beside_friction_opens_where_it_would_pull(model_of: Build) -> None:
    """1 kg on its stop along an upright rail, lifted by 20 t N, beside a block that rubs: off at 9.81 / 20 s."""
    scene = ball(0.5).rigid("block", mass=1.0, inertia=0.1).rates({"block.x": 1.0})
    scene.prismatic(
        "table", "ground.origin", "block.origin", friction={"coulomb": 1.0}, limits={"upper": 0.1, "restitution": 0.5}
    )
    scene.force("lift", "ball.origin", 0.0, "20 * t").initial({"ball.y": 0.0})
    run = simulate(model_of(scene.build()), t_end=1.0)
    assert [one.time for one in run.events if one.text.endswith("opens")] == pytest.approx([0.4905], abs=1e-9)
    assert run["ball.y"][-1] == pytest.approx(20 * (1 - 0.4905) ** 3 / 6, abs=1e-9)
    assert run["block.x"][-1] == pytest.approx(0.1 - 0.25 * (1 - 2 * 0.1) / 2, abs=1e-9)


@pytest.mark.parametrize("pull", [-1.0, 1.0])
def test_what_came_to_rest_without_a_load_neither_sticks_nor_passes(model_of: Build, pull: float) -> None:
    """Plastic upon a stop and nothing presses: a pull takes it away, a push does not take it through."""
    scene = Scene("still").rigid("m", mass=1.0, inertia=0.1).rates({"m.x": 1.0})
    scene.prismatic("rail", "ground.origin", "m.origin", limits={"upper": 0.1, "restitution": 0.0})
    scene.force("pull", "m.origin", f"{pull} * 0.5 * (abs(t - 1) + t - 1)", 0.0)
    run = simulate(model_of(scene.simulation(t_end=2.0, dt=0.01, scheme="rk4").build()))
    assert run["m.x"][-1] == pytest.approx(0.1 if pull > 0 else 0.1 - 1 / 6, abs=1e-8)


def test_a_start_beyond_a_stop_is_refused_or_moved(model_of: Build) -> None:
    """By name, in runs and steppers; moved at the scene's wish, and what comes inwards then is an impact."""
    model = model_of(ball(0.8).build())
    for begin in (lambda: simulate(model, initial={"ball.y": -0.25}), lambda: model.stepper().reset({"ball.y": -0.25})):
        with pytest.raises(InitialStateError, match=r"rail\.limits\.lower of model ball: .* 0\.25 beyond it; begin"):
            begin()
    run = simulate(model, initial={"ball.y": 0.0, "ball.y_dot": -3.0})
    assert run.events[0].text.startswith("rail.limits.lower is hit at 3 and left at 2.4, 1.62 J lost")
    assert run["ball.y_dot"][0] == pytest.approx(2.4) and run.balance.largest < 1e-8
    moved = simulate(model_of(ball(0.8, beyond="moved").build()), initial={"ball.y": -0.25})
    assert abs(moved["ball.y"]).max() < 1e-12 and not moved["rail.lower_mode"].any()
    assert "ball.y: -0.25 -> " in str(moved.stats["initial_changes"])


@pytest.mark.long
def test_steppers_ensembles_and_resumed_runs_bounce_alike(model_of: Build, tmp_path: Any) -> None:
    model = model_of(ball(0.8).build())
    run = simulate(model)
    stepper = model.stepper()
    stepper.step(n=500)
    assert stepper.state["ball.y"] == run["ball.y"][-1] and [str(one) for one in stepper.events] == [
        str(one) for one in run.events
    ]
    many = ensemble(model, initial={"ball.y": np.array([0.5, 1.0])}, outputs=["ball.y"])
    assert np.asarray(many["ball.y"])[1, -1] == run["ball.y"][-1]
    kept, path = tmp_path / "half.npz", tmp_path / "run.npz"

    def copied(t: float, t_end: float) -> None:
        if t >= 2.5 and not kept.exists():
            kept.write_bytes(path.read_bytes())

    simulate(model, checkpoint=path, checkpoint_every=50, progress=copied)
    resumed = model.resume(kept)
    assert (resumed.q == run.q).all() and resumed.balance.largest < 1e-8
    assert [str(one) for one in resumed.events] == [str(one) for one in run.events]


def test_an_equilibrium_is_found_between_stops_and_on_them(model_of: Build) -> None:
    """On a spring: between its stops, and below one of them at rest on it, with what the spring leaves of the weight.

    What is held beyond a stop is refused.
    """

    def sprung(at: float) -> Model:
        scene = ball(0.5).measure("y", "y", "ball.origin").force("spring", "ball.origin", 0.0, f"100 * ({at} - y)")
        return model_of(scene.build())

    found = sprung(0.5).equilibrium()
    assert found["ball.y"] == pytest.approx(0.5 - 0.0981, abs=1e-9)
    found = sprung(0.05).equilibrium()
    assert found["ball.y"] == pytest.approx(0.0, abs=1e-12)
    assert found.friction == {"rail.limits.lower": pytest.approx(9.81 - 5.0, rel=1e-12)}
    with pytest.raises(ModelError, match=r"lies 0\.1 beyond rail\.limits\.lower"):
        sprung(0.05).equilibrium(held={"ball.y": -0.1})


def pendulum(lower: float, upper: float, side: float = -1.0) -> Scene:
    """1 kg at 1 m below (side -1) or above its hinge, between two stops."""
    scene = Scene("pendulum").gravity(0.0, -9.81).rigid("rod", mass=1.0, inertia=1e-9, center_of_mass=(0.0, side))
    limits = {"lower": lower, "upper": upper, "restitution": 0.2}
    return scene.revolute("hinge", "ground.origin", "rod.origin", limits=limits)


def test_a_joint_with_both_stops_has_equilibria(model_of: Build) -> None:
    """It hangs between them with sqrt(g / l); outside it leans on one with m g l sin(angle), and a run rests there."""
    between = model_of(pendulum(-0.3, 0.3).simulation(t_end=0.1, dt=0.01, scheme="rk4").build())
    assert between.equilibrium(initial={"rod.theta": 0.1})["rod.theta"] == pytest.approx(0.0, abs=1e-12)
    assert between.modes().frequencies == pytest.approx([sqrt(9.81)], rel=1e-8)
    assert repr(between.modes()) == "<1 mode of pendulum: rod.theta 3.13209 rad/s (0.4985 Hz)>"
    assert between.linearise().K == pytest.approx(9.81, rel=1e-12)
    assert not simulate(between, start="equilibrium")["rod.theta"].any()
    leaning = model_of(pendulum(0.2, 0.5).simulation(t_end=0.1, dt=0.01, scheme="rk4").build())
    found = leaning.equilibrium()
    assert found["rod.theta"] == pytest.approx(0.2, abs=1e-12) and found.stable and not len(found.eigenvalues)
    assert found.friction == {"hinge.limits.lower": pytest.approx(9.81 * np.sin(0.2), rel=1e-10)}
    run = simulate(leaning, initial={"rod.theta": 0.4}, start="equilibrium")
    assert np.ptp(run["rod.theta"]) == 0 and run["hinge.stop_force"] == pytest.approx(9.81 * np.sin(0.2), rel=1e-10)
    said = f"<stop: largest force {9.81 * np.sin(0.2):.6g}, 0 impulses, at rest for 0.1 s>"
    assert str(run.stop("hinge")) == said
    assert not len(leaning.modes()) and leaning.linearise().M.shape == (0, 0)
    for start, side in ((0.1, -1), (-0.1, 1)):  # upright it falls to either side
        found = model_of(pendulum(-0.3, 0.3, 1.0).build()).equilibrium(initial={"rod.theta": start})
        assert found["rod.theta"] == pytest.approx(-0.3 * side, abs=1e-12)
        assert list(found.friction.values()) == pytest.approx([side * 9.81 * np.sin(0.3)], rel=1e-10)


def test_one_link_leans_while_the_other_hangs(model_of: Build) -> None:
    """The upper link level on its stop by 9.81 (0.3 + 0.6) N m, the lower one swings by omega^2 = 9.81 * 0.3 / 0.19."""
    scene, last = Scene("leaning").gravity(0.0, -9.81), "ground.origin"
    for k, limits in enumerate(({"lower": 0.0, "upper": 1.0}, {"lower": -3.0, "upper": 3.0})):
        tip = {"tip": {"position": (0.6, 0.0)}}
        scene.rigid(f"l{k}", mass=1.0, inertia=0.1, center_of_mass=(0.3, 0.0), markers=tip)
        scene.revolute(f"j{k}", last, f"l{k}.origin", limits={**limits, "restitution": 0.5})
        last = f"l{k}.tip"
    found = model_of(scene.build()).equilibrium(initial={"l0.theta": 0.5, "l1.theta": -1.0})
    assert found["l0.theta"] == pytest.approx(0.0, abs=1e-12) and found["l1.theta"] == pytest.approx(-pi / 2, abs=1e-12)
    assert found.friction == {"j0.limits.lower": pytest.approx(9.81 * 0.9, rel=1e-10)}
    assert sorted(found.eigenvalues.imag) == pytest.approx([-sqrt(2.943 / 0.19), sqrt(2.943 / 0.19)], rel=1e-9)
    assert found.model.modes(found).frequencies == pytest.approx([sqrt(2.943 / 0.19)], rel=1e-9)


def test_a_four_bar_leans_on_a_stop_of_its_rocker(model_of: Build) -> None:
    """Of a dependent joint: the force is what holds the rocker there without the stop; out of reach it is refused."""

    def four_bar(**limits: float) -> Model:
        scene = Scene("four_bar").gravity(0.0, -9.81).ground(markers={"b": {"position": (1.0, 0.0)}})
        for name, length in (("a", 0.4), ("c", 1.0), ("r", 0.7)):
            tip = {"tip": {"position": (length, 0.0)}}
            scene.rigid(name, mass=1.0, inertia=0.05, center_of_mass=(length / 2, 0.0), markers=tip)
        scene.revolute("j1", "ground.origin", "a.origin").revolute("j2", "a.tip", "c.origin")
        scene.revolute("j3", "c.tip", "r.tip")
        scene.revolute("j4", "ground.b", "r.origin", limits={**limits, "restitution": 0.3} if limits else None)
        return model_of(scene.initial({"a.theta": 1.0, "c.theta": 0.3, "r.theta": 1.5}).build())

    found, free = four_bar(lower=1.0, upper=2.2).equilibrium(), four_bar()
    assert found["r.theta"] == pytest.approx(2.2, abs=1e-9) and not len(found.eigenvalues)
    by_hand = free.equilibrium(held={"r.theta": found["r.theta"]}, initial=found.initial_values())
    assert found.friction == {"j4.limits.upper": pytest.approx(by_hand.holding["r.theta"], rel=1e-8)}
    with pytest.raises(ModelError, match=r"beyond j4\.limits\.lower"):
        four_bar(lower=2.8).equilibrium()


def test_an_impact_on_a_driven_cart_tells_apart_what_the_stop_took(model_of: Build) -> None:
    """The cart goes on at V: the stop takes J w^2 (1 - e^2) / 2, the drive gives V times what momentum changes by."""
    scene = Scene("cart").rigid("cart", mass=2.0, inertia=0.1)
    scene.rigid("rod", mass=1.5, inertia=0.1, center_of_mass=(0.0, -0.4))
    scene.prismatic("rail", "ground.origin", "cart.origin")
    scene.prescribed_displacement("drive", "ground.origin", "cart.origin", "-3.0 * t")
    scene.revolute("hinge", "cart.origin", "rod.origin", limits={"upper": 0.5, "restitution": 0.6})
    run = simulate(model_of(scene.rates({"rod.theta": 2.0}).simulation(t_end=0.4, dt=0.01, scheme="rk4").build()))
    took = 0.5 * (0.1 + 1.5 * 0.4**2) * 2.0**2 * (1 - 0.6**2)
    gave = -3.0 * 1.5 * 0.4 * np.cos(0.5) * -(1 + 0.6) * 2.0
    (text,) = [one.text for one in run.events if one.kind == "impact"]
    assert text.endswith(f"2 and left at 1.2, {took:.6g} J lost, work done by the prescribed motion: {gave:.6g} J")
    assert run.balance.largest < 1e-8


@pytest.mark.parametrize(
    ("limits", "item", "says"),
    [
        ({"lower": 0.0}, "limits", "have neither restitution nor stiffness; give a restitution, or a stiffness"),
        ({"restitution": 0.5}, "limits", "have neither lower nor upper"),
        ({"lower": 0.5, "upper": 0.2, "restitution": 0.5}, "limits", "lower 0.5 is not below upper 0.2"),
        ({"lower": 0.0, "restitution": 1.2}, "limits.restitution", "1.2 is above 1"),
        ({"lower": 0.0, "restitution": -0.1}, "limits.restitution", "negative"),
        ({"lower": 0.0, "restitution": 0.5, "stiffness": 1e3}, "limits", "has a restitution and a stiffness"),
        ({"lower": 0.0, "restitution": 0.5, "damping": 1.0}, "limits", "has a restitution and damping"),
        ({"lower": 0.0, "stiffness": 1e3, "beyond": "moved"}, "limits.beyond", "applies to rigid stops only"),
        ({"lower": 0.0, "restitution": 0.5, "beyond": "pushed"}, "limits.beyond", "pushed"),
    ],
)
def test_stops_that_cannot_be_are_refused_by_name(limits: dict[str, Any], item: str, says: str) -> None:
    scene = Scene("m").rigid("m", mass=1.0, inertia=0.1)
    with pytest.raises(SceneError) as raised:
        scene.prismatic("rail", "ground.origin", "m.origin", limits=limits).build()
    assert f"'rail'.{item}" in str(raised.value) and says in str(raised.value), raised.value


def test_parameters_keep_stops_apart_and_restitutions_below_one(model_of: Build) -> None:
    model = model_of(ball("e", upper="top").parameter("e", 0.5).parameter("top", 2.0, "m").build())
    with pytest.raises(ModelError, match="1 - restitution' would be -0.5 but must be at least zero"):
        simulate(model, parameters={"e": 1.5})
    with pytest.raises(ModelError, match="upper - lower' would be -1 but must be at least zero"):
        simulate(model, parameters={"top": -1.0})


def test_a_stop_on_a_prescribed_way_is_refused(model_of: Build) -> None:
    scene = Scene("driven").rigid("crank", mass=1.0, inertia=0.1).rigid("bob", mass=1.0, inertia=0.1, free=True)
    scene.revolute("pin", "ground.origin", "crank.origin", limits={"upper": 1.0, "restitution": 0.5})
    scene.prescribed_angle("drive", "ground.origin", "crank.origin", motion="sin(t)")
    with pytest.raises(SceneError, match=r"pin.limits.*along a prescribed motion"):
        model_of(scene.simulation(t_end=1.0, dt=0.01, scheme="rk4").build())
