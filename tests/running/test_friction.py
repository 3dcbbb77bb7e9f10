"""Friction in joints that sticks: published cases by their numbers, held exactly, in every scheme; what is refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import SCHEMES, Model, ModelError, Solution, ensemble, simulate
from runtime.schemes.switching.complementarity import complementary
from symgen.scene import Scene, SceneError, SceneRecord

Build = Callable[[SceneRecord], Model]
# the Friction example of the Modelica Standard Library: F = v + 5 + 10 exp(-2 v), and 1.001 of F(0) holds
PUBLISHED = {"coulomb": 5.0, "stribeck": 10.0, "breakaway": 15.015, "stribeck_velocity": 0.5, "viscous": 1.0}
PULLED = {2.0: 11.498782452, 5.0: 1.768489613}


def block(friction: dict[str, Any], pull: str | float, **simulation: Any) -> SceneRecord:
    """1 kg on a rail."""
    builder = Scene("block").input("more", 0.0, "N").ground().rigid("block", mass=1.0, inertia=0.1)
    builder.prismatic("rail", "ground.origin", "block.origin", friction=friction)
    builder.force("pull", "block.origin", pull, 0.0).measure("x", "x", "block.origin")
    return builder.simulation(**{"t_end": 5.0, "dt": 0.01, "scheme": "rk4", **simulation}).build()


def links(n: int, frictions: dict[int, dict[str, Any]], space: str = "planar") -> SceneRecord:
    """A chain of links of 1 kg and 1 m in a plane, or about axes one across the other in space."""
    builder = Scene("links", space=space).gravity(0.0, -9.81).ground()
    spatial, last = space == "spatial", "ground.origin"
    for k in range(n):
        more = {"inertia": [0.02, 0.08, 0.08]} if spatial else {"inertia": 0.08}
        marker = {"position": [1.0, 0.1, 0.2], "axis": [0.3, 0.4, 0.5]} if spatial else {"position": [1.0, 0.1]}
        builder.rigid(f"link{k}", mass=1.0, center_of_mass=[0.5, 0.0], markers={"tip": marker}, **more)
        friction = {"friction": frictions[k]} if k in frictions else {}
        builder.revolute(f"hinge{k}", last, f"link{k}.origin", **friction)
        last = f"link{k}.tip"
    return builder.simulation(t_end=1.0, dt=0.01, scheme="rk4").build()


@pytest.mark.every_push("exponential-4", "single_rate-2")
@pytest.mark.parametrize(
    ("scheme", "order"), [("rk4", 4), ("exponential", 4), ("dopri5", 5), ("single_rate", 2), ("coupled", 2)]
)
def test_a_block_that_sticks_and_slides_is_the_published_one(model_of: Build, scheme: str, order: int) -> None:
    """By the order of the scheme across one release and two reversals; rk4 at 1 ms to 3e-9 m, the digits printed."""
    model = model_of(block(PUBLISHED, "25 * sin(pi * t / 2)"))

    def errors(dt: float) -> float:
        run = simulate(model, scheme=scheme, dt=dt)
        assert [round(event.time, 2) for event in run.events] == [0.41, 2.44, 4.44]
        return max(abs(run["x"][round(t / dt)] - x) for t, x in PULLED.items())

    first, second = errors(0.02), errors(0.01)
    assert np.log2(first / second) > order - 0.4
    if scheme == "rk4":
        assert errors(0.001) < 3e-9


def test_a_release_and_reversals_are_located(model_of: Build) -> None:
    """Times printed with the case; the mode is among the measures, and heat balances the energy."""
    run = simulate(model_of(block(PUBLISHED, "25 * sin(pi * t / 2)")), dt=0.001)
    assert [event.time for event in run.events] == pytest.approx([0.410143129, 2.442690420, 4.441942431], abs=2e-9)
    assert [event.text for event in run.events] == [
        "rail.friction slides forwards", "rail.friction slides backwards", "rail.friction slides forwards"
    ]  # fmt: skip
    modes = run["rail.friction_mode"]
    assert [modes[0], modes[1000], modes[3000], modes[-1]] == [0, 1, -1, 1]
    assert np.abs(run.energy_balance()).max() < 1e-6


@pytest.mark.parametrize("how", [{}, {"scheme": "dopri5", "options": {"tolerance": 1e-6}}])
@pytest.mark.parametrize("start", [0.43, 0.433])
def test_a_load_that_jumps_lets_go_of_what_was_held(model_of: Build, how: dict[str, Any], start: float) -> None:
    """At the end of a step and within one: 5 N against 3 N that hold, x = t^2 from there on."""
    run = simulate(model_of(block({"coulomb": 3.0}, f"5 * step(t - {start})", t_end=1.0)), **how)
    assert [event.text for event in run.events] == ["rail.friction slides forwards"]
    assert run.status.ok and run["x"][-1] == pytest.approx((1.0 - start) ** 2, abs=1e-11)


def test_force_mode_and_heat_of_a_joint_are_outputs(model_of: Build, tmp_path: Path) -> None:
    """By hand: 1 kg at 4 m/s, pulled by 2 N against 3 N, stops after 4 s; 8 J + 16 J become heat; then 2 N hold it.

    The same in files; heat is of all samples, so that a run which keeps some columns only does not have it.
    """
    builder = Scene("braked").ground().rigid("block", mass=1.0, inertia=0.1).rates({"block.x": 4.0})
    builder.prismatic("rail", "ground.origin", "block.origin", friction={"coulomb": 3.0})
    builder.force("pull", "block.origin", 2.0, 0.0)
    model = model_of(builder.simulation(t_end=5.0, dt=0.03, scheme="rk4").build())
    run = simulate(model)
    found = run.friction("rail")
    moving = run.t < 4.0
    assert found.force[moving] == pytest.approx(-3.0, abs=1e-12) and found.force[~moving] == pytest.approx(
        -2.0, abs=1e-12
    )
    assert found.mode.tolist() == np.where(moving, 1.0, 0.0).tolist()
    assert found.velocity == pytest.approx(np.maximum(4.0 - run.t, 0.0), abs=1e-11)
    assert found.power == pytest.approx(3.0 * np.maximum(4.0 - run.t, 0.0), abs=1e-11)
    assert found.heat[-1] == pytest.approx(24.0, abs=1e-10) and run.balance.largest < 1e-10
    run.export(tmp_path / "run.csv")
    table = np.genfromtxt(tmp_path / "run.csv", delimiter=",", names=True, deletechars="")
    assert np.array_equal(table["rail.friction_heat_[J]"], found.heat)
    assert np.array_equal(table["rail.friction_force_[N]"], run["rail.friction_force"])
    run.save(tmp_path / "run.npz")
    assert np.array_equal(Solution.load(tmp_path / "run.npz").friction("rail").heat, found.heat)
    kept = simulate(model, outputs=["rail.friction_force", "rail.friction_power"])
    assert np.array_equal(kept.outputs["rail.friction_power"], found.power)
    with pytest.raises(ModelError, match=r"no output 'rail\.friction_heat'"):
        simulate(model, outputs=["rail.friction_heat"])
    with pytest.raises(ModelError, match="no joint with friction 'axle'; it has rail"):
        run.friction("axle")


@pytest.mark.every_push("rk4", "single_rate", "radau")
@pytest.mark.parametrize("scheme", list(SCHEMES))
def test_what_holds_holds_without_creep(model_of: Build, scheme: str) -> None:
    """100 s under a load that swings below the bound: no digit moves; regularised laws creep by millimetres."""
    model = model_of(block({"coulomb": 8.0}, "2 + 3 * sin(2 * pi * t)"))
    run = simulate(model, scheme=scheme, t_end=100.0, dt=0.02, force=True)
    assert not run.events
    assert not run["block.x"].any()
    assert not run["block.x_dot"].any()


@pytest.mark.parametrize("angle", [0.0, 0.3])
def test_friction_whose_coefficient_is_zero_holds_nothing(model_of: Build, angle: float) -> None:
    """By hand: pulled by 2 (t - 1) N from 1 s on along a rail of any angle, 1/3 m cos(angle) at 2 s."""
    scene = Scene("slippery").ground(markers={"rail": {"position": (0, 0), "angle": angle}}).parameter("mu", 0.0, "N")
    scene.rigid("m", mass=1.0, inertia=0.1).initial({"m.theta": angle})
    scene.prismatic("rail", "ground.rail", "m.origin", friction={"coulomb": "mu"})
    scene.force("pull", "m.origin", "2 * max(t - 1, 0)", 0.0)
    run = simulate(model_of(scene.simulation(t_end=2.0, dt=0.01, scheme="rk4").build()))
    assert run["m.x"][-1] == pytest.approx(np.cos(angle) ** 2 / 3, abs=1e-9)
    slides = run.friction("rail")
    moving = np.abs(slides.velocity) > 1e-9
    assert (slides.mode[moving] == np.sign(slides.velocity[moving])).all() and not slides.force.any()


@pytest.mark.parametrize("less", [1e-3, 1e-6, 1e-8])
def test_what_comes_to_rest_under_nearly_its_bound_is_held(model_of: Build, less: float) -> None:
    """From -4 m/s against 3 N and a pull of nearly 3 N: at rest after 2/3 s and 4/3 m, where friction can hold it."""
    builder = Scene("nearly").ground().rigid("block", mass=1.0, inertia=0.1).rates({"block.x": -4.0})
    builder.prismatic("rail", "ground.origin", "block.origin", friction={"coulomb": 3.0})
    builder.force("pull", "block.origin", 3.0 - less, 0.0)
    run = simulate(model_of(builder.simulation(t_end=50.0, dt=0.05, scheme="rk4").build()))
    assert [event.time for event in run.events] == pytest.approx([4 / (6 - less)], abs=1e-9)
    assert run["block.x"][-1] == pytest.approx(-8 / (6 - less), abs=1e-9) and run["block.x_dot"][-1] == 0.0


@pytest.mark.parametrize("pull", [2.0, -2.0])
def test_what_nothing_rubs_sets_out_without_a_change_of_mode(model_of: Build, pull: float) -> None:
    """1 kg pulled by 2 N from rest over a coefficient of zero: x = t^2, from the start in the mode of its way."""
    scene = Scene("pulled").ground().rigid("block", mass=1.0, inertia=0.1).parameter("mu", 0.0, "N")
    scene.prismatic("rail", "ground.origin", "block.origin", friction={"coulomb": "mu"})
    scene.force("pull", "block.origin", pull, 0.0)
    run = simulate(model_of(scene.simulation(t_end=1.0, dt=0.01, scheme="rk4").build()))
    assert not run.events and (run.friction("rail").mode == np.sign(pull)).all()
    assert run["block.x"][-1] == pytest.approx(pull / 2, rel=1e-12)


def test_a_spring_lets_a_block_stick_for_good(model_of: Build) -> None:
    """Case (b) of the same example from its stop on: it sticks at -.2475140 m, .985376654 s later, and stays."""
    friction = {"coulomb": 3.0, "stribeck": 5.0, "breakaway": 8.008, "stribeck_velocity": 0.5, "viscous": 1.0}
    builder = Scene("spring").ground().rigid("block", mass=1.0, inertia=0.1)
    builder.prismatic("rail", "ground.origin", "block.origin", friction=friction).measure("x", "x", "block.origin")
    builder.force("spring", "block.origin", "-500 * (x + 0.25)", 0.0).initial({"block.x": -0.4})
    run = simulate(model_of(builder.simulation(t_end=10.0, dt=0.001, scheme="rk4").build()))
    assert run.events[-1].time == pytest.approx(1.045973749 - 0.060597096, abs=3e-9)
    assert run["x"][-1] == pytest.approx(-0.2475140, abs=1e-7)
    assert run["block.x_dot"][-1] == 0.0
    assert np.ptp(run["x"][1000:]) == 0.0


@pytest.mark.every_push("rubbing2-spatial", "rubbing0-planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
@pytest.mark.parametrize("rubbing", [(0,), (1,), (0, 2), (0, 1, 2, 3)])
def test_locked_equations_are_those_of_constraints(model_of: Build, space: str, rubbing: tuple[int, ...]) -> None:
    """At random states and modes: by pivots and by M_hat as by multipliers of the rows that stick."""
    law = {"coulomb": 1.0, "breakaway": 1.5, "stribeck_velocity": 2.0, "viscous": 0.1}
    model = model_of(links(4, dict.fromkeys(rubbing, law), space))
    random = np.random.default_rng(3)
    c = model.constants(model.parameter_vector())
    for _ in range(5):
        modes = random.integers(-1, 2, len(rubbing))
        c[model.element_modes - model.signals.size] = modes
        at: dict[str, Any] = {"q_i": random.normal(size=4), "q_i_dot": random.normal(size=4), "t": 0.0, "c": c}
        at["q_d"] = model.evaluate("closure", **at, q_d=np.zeros(len(model.q_d)))["q_d_next"]
        at["q_d_dot"] = model.evaluate("velocities", **at)["q_d_dot"]
        own = {name: np.array(value) for name, value in model.evaluate("elements", **at).items()}
        G, n = own["G"][modes == 0], int((modes == 0).sum())
        whole = np.block([[own["M_hat"], G.T], [G, np.zeros((n, n))]])
        found = np.linalg.solve(whole, np.concatenate([own["Q_hat"].ravel(), -own["G_bias"].ravel()[modes == 0]]))
        by_pivots = np.array(model.evaluate("forward_dynamics", **at)["q_i_ddot"]).ravel()
        condensed = {name: np.array(value) for name, value in model.evaluate("condensed", **at).items()}
        by_matrix = np.linalg.solve(condensed["M_hat"], condensed["Q_hat"]).ravel()
        scale = np.abs(found).max()
        assert np.abs(by_pivots - found[:4]).max() < 1e-12 * scale
        assert np.abs(by_matrix - found[:4]).max() < 1e-12 * scale
        assert not np.any(G @ by_pivots)
        forces = np.array(model.evaluate("element_forces", **at, q_i_ddot=by_pivots)["f_rel"]).ravel()[modes == 0]
        viscous = 0.1 * own["v_rel"].ravel()[modes == 0]  # zero where it really sticks
        assert np.abs(forces + viscous + found[4:]).max(initial=0.0) < 1e-11 * scale


def test_a_link_that_sticks_on_a_driven_crank_turns_with_it(model_of: Build) -> None:
    """Angle a = sin(3 t) + 3 at both; what holds the link is its inertia, the hinge's acceleration and no weight."""
    builder = Scene("driven").ground().rigid("crank", mass=1.0, inertia=0.1, markers={"tip": {"position": [0.5, 0.0]}})
    builder.rigid("link", mass=2.0, inertia=0.1, center_of_mass=[0.3, 0.0])
    builder.revolute("base", "ground.origin", "crank.origin")
    builder.prescribed_angle("motor", "ground.origin", "crank.origin", motion="sin(3*t)")
    builder.revolute("hinge", "crank.tip", "link.origin", friction={"coulomb": 100.0})
    builder.rates({"link.theta": 3.0}).simulation(t_end=1.0, dt=0.005, scheme="rk4")
    run = model_of(builder.build()).simulate()
    assert np.abs(run["link.theta"] - np.sin(3 * run.t)).max() < 1e-8
    # about the hinge: (J + m c^2) a'' + m c l a'', the centripetal part of the hinge points along the link
    moment = -(0.1 + 2.0 * 0.3**2 + 2.0 * 0.3 * 0.5) * 9 * np.sin(3 * run.t)
    assert run.friction("hinge").force == pytest.approx(moment, abs=1e-6)


@pytest.mark.long
def test_an_arm_with_friction_in_both_joints_changes_modes_alike_at_every_step(model_of: Build) -> None:
    """Driven, with Stribeck in both; energy balances with the heat, and both joints stick at times."""
    law = {"coulomb": 0.6, "breakaway": 1.0, "stribeck_velocity": 0.1, "viscous": 0.05}
    builder = Scene("arm").ground()
    for k in range(2):
        tip = {"tip": {"position": [0.6, 0.0]}}
        builder.rigid(f"link{k}", mass=1.0, inertia=0.1, center_of_mass=[0.3, 0.0], markers=tip)
    builder.revolute("shoulder", "ground.origin", "link0.origin", friction=law)
    builder.revolute("elbow", "link0.tip", "link1.origin", friction=law)
    builder.effort("drive", coordinate="shoulder.angle", value="2.2 * sin(3 * t)")
    builder.effort("drive2", coordinate="elbow.angle", value="1.8 * sin(7.1 * t)")
    model = model_of(builder.simulation(t_end=6.0, dt=0.01, scheme="rk4").build())
    runs = {dt: simulate(model, dt=dt) for dt in (0.02, 0.01, 0.005, 0.0025)}
    changes = {dt: [event.text for event in run.events] for dt, run in runs.items()}
    assert [len(texts) for texts in changes.values()] == [39] * 4
    assert len({tuple(texts) for texts in changes.values()}) == 1
    assert {0.0, 1.0, -1.0} == set(runs[0.0025]["elbow.friction_mode"]) == set(runs[0.0025]["shoulder.friction_mode"])
    fine = runs[0.0025]["link1.theta"]
    errors = [np.abs(runs[dt]["link1.theta"] - fine[:: round(dt / 0.0025)]).max() for dt in (0.02, 0.01)]
    assert errors[0] / errors[1] > 6
    assert errors[1] < 2e-4
    assert np.abs(runs[0.0025].energy_balance()).max() < 1e-4
    stuck = (runs[0.0025]["elbow.friction_mode"] == 0) & (np.roll(runs[0.0025]["elbow.friction_mode"], 1) == 0)
    relative = runs[0.0025]["link1.theta_dot"] - runs[0.0025]["link0.theta_dot"]
    assert stuck.sum() > 10
    assert not relative[stuck].any()


@pytest.mark.long
def test_what_settles_solves_the_complementarity_problem() -> None:
    """Random symmetric A with bounds of friction and of stops, against projected Gauss-Seidel to 1e-13."""
    random = np.random.default_rng(7)
    for n in (1, 2, 4, 8):
        for _ in range(60):
            root = random.normal(size=(n, n + 1))
            A, b = root @ root.T, 3 * random.normal(size=n)
            stop = random.random(n) < 0.3
            upper = np.where(stop, np.inf, random.uniform(0.1, 2.0, n))
            lower = np.where(stop, 0.0, -upper)
            sides = complementary(A, b, lower, upper)
            assert sides is not None
            f = np.zeros(n)
            for _ in range(20_000):
                before = f.copy()
                for k in range(n):
                    f[k] = np.clip(f[k] - (b[k] + A[k] @ f) / A[k, k], lower[k], upper[k])
                if np.abs(f - before).max() < 1e-13:
                    break
            expected = np.where(f >= upper, 1, np.where(f <= lower, -1, 0))
            assert sides.tolist() == expected.tolist()


def pile(n: int) -> Scene:
    """Blocks one on the other, each rubs on the one below it and is pulled by a parameter."""
    scene, below = Scene("pile"), "ground.origin"
    for k in range(n):
        scene.parameter(f"pull{k}", 0.0, "N").rigid(f"b{k}", mass=MASSES[k], inertia=0.1)
        scene.prismatic(f"j{k}", below, f"b{k}.origin", friction={"coulomb": FRICTIONS[k]})
        scene.force(f"pull{k}", f"b{k}.origin", f"pull{k}", 0.0)
        below = f"b{k}.origin"
    return scene.simulation(t_end=0.01, dt=0.01, scheme="rk4")


MASSES, FRICTIONS = (5.0, 0.3, 2.0, 0.8), (6.0, 4.0, 1.5, 0.7)


@pytest.mark.long
def test_a_pile_of_blocks_sets_out_as_coulomb_says(model_of: Build) -> None:
    """From rest, 40 sets of pulls: each force of friction is within its bound, at it against the sliding, and where it
    is within it nothing slides. Only one motion does so, found here by Gauss-Seidel; loads are constant: v = a t.
    """
    n, random, model = 4, np.random.default_rng(3), model_of(pile(4).build())
    D = np.eye(n) - np.eye(n, k=-1)  # relative velocities of positions x
    A, sliding = D @ np.diag(1 / np.array(MASSES)) @ D.T, np.zeros(n, dtype=int)
    for _ in range(40):
        pulls = random.uniform(-12, 12, n)
        b, f, bound = D @ (pulls / MASSES), np.zeros(n), np.array(FRICTIONS)
        for _ in range(5000):
            for k in range(n):
                f[k] = np.clip(f[k] - (b[k] + A[k] @ f) / A[k, k], -bound[k], bound[k])
        run = simulate(model, parameters={f"pull{k}": pulls[k] for k in range(n)}, error="off")
        assert run.status.ok
        a = (pulls + D.T @ f) / MASSES
        assert [run[f"b{k}.x_dot"][-1] for k in range(n)] == pytest.approx((0.01 * a).tolist(), abs=1e-12)
        assert [run.friction(f"j{k}").force[-1] for k in range(n)] == pytest.approx(f.tolist(), abs=1e-10)
        sliding += np.abs(f) >= bound
    assert (sliding >= 5).all() and (sliding <= 38).all()


def test_modes_are_not_inputs_of_the_user(model_of: Build) -> None:
    """They are neither listed nor set; an input that jumps decides anew, in a stepper too."""
    model = model_of(block({"coulomb": 8.0}, "more"))
    assert model.inputs == ["more"]
    with pytest.raises(ModelError, match="has no input 'rail.friction_mode'"):
        simulate(model, inputs={"rail.friction_mode": 1.0})
    times = [0.0, 1.0, 2.0, 3.0]
    run = simulate(model, inputs={"more": (times, [0.0, 10.0, 0.0, -7.0])}, t_end=4.0)
    assert [event.text for event in run.events] == ["rail.friction slides forwards", "rail.friction sticks"]
    assert run["block.x"][-1] == pytest.approx(1.0 + 2.0 * 0.25 - 8 * 0.25**2 / 2, abs=1e-9)
    stepper = model.stepper(dt=0.01)
    for value in (0.0, 10.0, 0.0, -7.0):
        stepper.step({"more": value}, 100)
    assert stepper.state["block.x"] == run["block.x"][-1]
    assert [event.text for event in stepper.events] == [event.text for event in run.events]
    many = ensemble(model, {"more": [7.0, 9.0]}, outputs=["block.x"], t_end=1.0)
    assert np.asarray(many["block.x"])[:, -1] == pytest.approx([0.0, 0.5], abs=1e-9)


@pytest.mark.parametrize(
    ("friction", "message"),
    [
        ({"coulomb": 2.0, "breakaway": 1.0, "stribeck_velocity": 0.1}, "breakaway: 1 is below coulomb"),
        ({"coulomb": 1.0, "breakaway": 2.0}, "over no velocity; give a stribeck_velocity"),
        ({"coulomb": 1.0, "breakaway": 2.0, "stribeck_velocity": 0.0}, "0.0 must be positive"),
        ({"coulomb": 1.0, "stribeck_velocity": 0.1}, "has no effect"),
        ({"coulomb": -1.0}, "-1.0 must be not negative"),
        ({"coulomb": 0.0}, "is zero"),
        ({"breakaway": 1.0}, "coulomb"),
        ({"mue": 0.3}, "unknown key 'mue'"),
    ],
)
def test_friction_that_cannot_be_is_refused(friction: dict[str, Any], message: str) -> None:
    """The message names the joint, says what is wrong and what to do."""
    with pytest.raises(SceneError, match=message) as caught:
        block(friction, 0.0)
    assert "rail" in str(caught.value)


def test_friction_needs_one_free_direction_and_a_breakaway_that_stays(model_of: Build) -> None:
    """A weld has none; a parameter may not take the breakaway below Coulomb's value later."""
    with pytest.raises(SceneError, match="'fixed'.*friction"):
        builder = Scene("none").ground().rigid("block", mass=1.0, inertia=0.1)
        builder.weld("fixed", "ground.origin", "block.origin", friction={"coulomb": 1.0}).build()
    model = model_of(block({"coulomb": 1.0, "breakaway": 2.0, "stribeck_velocity": 0.1}, 0.0))
    with pytest.raises(ModelError, match="breakaway - coulomb' would be -2 but must be at least zero"):
        simulate(model, parameters={"rail.friction.coulomb": 4.0})


def test_what_friction_makes_wrong_is_refused(model_of: Build) -> None:
    """Forces inside of a body on a joint that sticks, and the impulse of a prescribed velocity that jumps."""
    flat = {"lateral": {"ends": "clamped-free", "modes": 1}, "second_moment": 1e-10}
    arm = Scene("held_arm").gravity(0.0, -9.81).ground()
    arm.beam("arm", length=1.0, density=2700.0, area=1e-4, youngs_modulus=7e10, **flat)
    arm.revolute("pin", "ground.origin", "arm.start", friction={"coulomb": 0.5})
    run = simulate(model_of(arm.simulation(t_end=0.2, dt=1e-3, scheme="exponential_rk4").build()))
    assert run.status.whole and run.section_forces("arm", way="modes").moment.shape[0] == 201
    with pytest.raises(ModelError, match='pin.friction at arm: sticks and slides.*way="modes"'):
        run.section_forces("arm")
    driven = Scene("driven").ground().rigid("crank", mass=1.0, inertia=0.1, markers={"tip": {"position": [1.0, 0.0]}})
    driven.prescribed_angle("drive", "ground.origin", "crank.origin", motion="abs(t - 0.5)")
    driven.rigid("bob", mass=1.0, inertia=0.1, center_of_mass=[0.5, 0.0])
    driven.revolute("axle", "ground.origin", "crank.origin")
    driven.revolute("pin", "crank.tip", "bob.origin", friction={"coulomb": 0.5})
    with pytest.raises(ModelError, match="pin.friction.*prescribed velocity that jumps does not know"):
        simulate(model_of(driven.simulation(t_end=1.0, dt=1e-2, scheme="rk4").build()))
