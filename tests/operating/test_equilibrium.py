"""Equilibria and steady rotation against hand-derived ones."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import brentq

from runtime import InitialStateError, ModelError, NoEquilibrium, equilibrium, linearise, modes, simulate
from runtime.model import Model
from runtime.start.start_state import start_state
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import on_hinge

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]
G = 9.81


def inverted_pendulum(stiffness: float = 0.0) -> SceneRecord:
    """A point of 2 kg on 0.5 m, upright at theta = 0, with a torsional spring and a torque."""
    builder = (
        on_hinge("inverted", "rod", "hinge", mass=2.0, inertia=0.0, center_of_mass=(0.0, 0.5))
        .parameter("push", 0.0, "N m", "constant torque")
        .gravity(0.0, -G)
        .torque("motor", "rod.origin", "push")
    )
    if stiffness:
        builder = builder.rotational_spring_damper("spring", "ground.origin", "rod.origin", stiffness=stiffness)
    return builder.build()


def conical_pendulum(length: float = 0.7) -> SceneRecord:
    """A point mass on a rod hinged to a vertical shaft without inertia of its own about the axis."""
    return (
        Scene("conical", space="spatial")
        .gravity(0.0, 0.0, -G)
        .rigid("shaft", mass=1.0, inertia=(0.3, 0.3, 0.3), markers={"hinge": {"axis": (0.0, -1.0, 0.0)}})
        .rigid("rod", mass=0.8, inertia=(0.0, 0.0, 0.0), center_of_mass=(0.0, 0.0, -length),
               markers={"hinge": {"axis": (0.0, -1.0, 0.0)}})
        .revolute("spin", "ground.origin", "shaft.origin")
        .revolute("swing", "shaft.hinge", "rod.hinge")
        .initial({"swing.angle": 0.3})
        .build()
    )  # fmt: skip


def test_a_pendulum_hangs(built_in: Load) -> None:
    """Hand: from any start but upright it ends hanging, with w^2 = m g s / J_0; upright it stays, and is unstable."""
    model = built_in("double_pendulum")
    found = equilibrium(model)
    assert found.stable and found.steady and not found.holding
    assert math.sin(found["upper.theta"]) == pytest.approx(-1.0, abs=1e-14)
    assert math.sin(found["lower.theta"]) == pytest.approx(-1.0, abs=1e-14)
    up = equilibrium(model, initial={"upper.theta": math.pi / 2, "lower.theta": math.pi / 2})
    assert not up.stable and up["upper.theta"] == math.pi / 2


@pytest.mark.parametrize("stiffness", [5.0, 15.0])
def test_an_inverted_pendulum_on_a_spring(model_of: Build, stiffness: float) -> None:
    """Hand: k theta = m g s sin theta. Upright is stable if k > m g s, with w^2 = (k - m g s) / J."""
    weight = 2.0 * G * 0.5
    model = model_of(inverted_pendulum(stiffness))
    upright = equilibrium(model)
    assert upright["rod.theta"] == 0 and upright.stable == (stiffness > weight)
    slope = (stiffness - weight) / (2.0 * 0.25)
    assert upright.eigenvalues[0] ** 2 == pytest.approx(-slope, rel=1e-12)
    if stiffness < weight:
        fallen = equilibrium(model, initial={"rod.theta": 0.01})
        theta = fallen["rod.theta"]
        assert fallen.stable and theta > 0.1
        assert stiffness * theta == pytest.approx(weight * math.sin(theta), rel=1e-12)


def test_what_it_takes_to_hold(model_of: Build) -> None:
    """Hand: held at theta the pendulum needs the torque -m g s sin theta; the same as a trimmed motor."""
    model, theta = model_of(inverted_pendulum()), 0.4
    needed = -2.0 * G * 0.5 * math.sin(theta)
    held = equilibrium(model, held={"rod.theta": theta})
    assert held.holding["rod.theta"] == pytest.approx(needed, rel=1e-13)
    trimmed = equilibrium(model, held={"rod.theta": theta}, inputs={"push": None})
    assert trimmed.trimmed["push"] == pytest.approx(needed, rel=1e-12)
    assert abs(trimmed.holding["rod.theta"]) < 1e-12
    given = equilibrium(model, held={"rod.theta": theta}, inputs={"push": 3.0})
    assert given.holding["rod.theta"] == pytest.approx(needed - 3.0, rel=1e-13)


@pytest.mark.parametrize("speed", [4.0, 6.0, 12.0])
def test_a_conical_pendulum(model_of: Build, speed: float) -> None:
    """Hand: cos theta = g / (L W^2) above W^2 = g / L, else hanging; about it w = W sin theta at constant W."""
    model, length = model_of(conical_pendulum()), 0.7
    found = equilibrium(model, rates={"spin.omega": speed})
    ratio = G / (length * speed**2)
    theta = math.acos(ratio) if ratio < 1 else 0.0
    assert abs(found["swing.angle"]) == pytest.approx(theta, abs=1e-10)
    assert found.stable and found.steady and found["spin.angle_dot"] == speed
    assert found.holding["spin.angle"] == pytest.approx(0.0, abs=1e-12)
    w = speed * math.sin(theta) if ratio < 1 else math.sqrt(G / length - speed**2)
    assert modes(model, found, locked=["spin.angle"]).frequencies[0] == pytest.approx(w, rel=1e-9)


def test_the_free_conical_pendulum_exchanges_momentum(model_of: Build) -> None:
    """Hand: H = (I + m L^2 s^2) W is conserved, so w^2 = W^2 s^2 (1 + 4 m L^2 c^2 / (I + m L^2 s^2))."""
    model, length, speed = model_of(conical_pendulum()), 0.7, 6.0
    found = modes(model, equilibrium(model, rates={"spin.angle": speed}))
    c = G / (length * speed**2)
    s2, about_axis = 1 - c**2, 0.8 * length**2
    w2 = speed**2 * s2 * (1 + 4 * about_axis * c**2 / (0.3 + about_axis * s2))
    assert list(found.rigid) == [True, False] and found.frequencies[0] == 0
    assert found.names[0] == "rigid spin.angle"
    assert found.frequencies[1] ** 2 == pytest.approx(w2, rel=1e-9)


def test_a_slider_crank_held_by_its_slider(built_in: Load) -> None:
    """Law of virtual work: the force that holds the slider is the power of gravity per slider rate."""
    model = built_in("slider_crank")
    found = equilibrium(model, held={"slider.x": 0.4}, initial={"crank.theta": 0.5})
    assert found["slider.x"] == pytest.approx(0.4, abs=1e-13)
    step = 1e-5
    near = [equilibrium(model, held={"crank.theta": found["crank.theta"] + turn}) for turn in (step, -step)]
    c = model.constants(model.parameter_vector())
    energy = model.kernel("energy")

    def potential(q: np.ndarray) -> float:
        values = {"q": q, "q_dot": np.zeros_like(q), "t": 0.0, "c": c}
        return float(energy(**{name: values[name] for name in energy.name_in()})["potential"])

    force = (potential(near[0].q) - potential(near[1].q)) / (near[0]["slider.x"] - near[1]["slider.x"])
    assert found.holding["slider.x"] == pytest.approx(force, rel=1e-7)


def test_no_equilibrium_is_told(model_of: Build) -> None:
    """A constant torque on a free rotor: the residual names the coordinate and the torque."""
    scene = (
        on_hinge("free_rotor", "rotor", "axle", mass=1.0, inertia=0.1)
        .parameter("push", 2.5, "N m", "constant torque")
        .torque("motor", "rotor.origin", "push")
        .build()
    )
    with pytest.raises(NoEquilibrium, match=r"2\.5 N m is left at rotor\.theta") as error:
        equilibrium(model_of(scene))
    assert error.value.residual == {"rotor.theta": pytest.approx(2.5)} and "t =" not in str(error.value)


def test_no_equilibrium_tells_of_which_time_the_loads_are(model_of: Build) -> None:
    """A pulse until 2 s on a free rotor: none while it acts, any angle after."""
    scene = on_hinge("pulse", "rotor", "axle", mass=1.0, inertia=0.1).parameter("push", 2.5, "N m", "torque")
    model = model_of(scene.torque("motor", "rotor.origin", "where(t < 2, push, 0)").build())
    with pytest.raises(NoEquilibrium, match=r"those of t = 0 s: give `t`, or `at_time`"):
        equilibrium(model)
    assert equilibrium(model, t=2.5)["rotor.theta"] == 0.0


def test_a_rotation_that_is_not_steady_is_told(model_of: Build) -> None:
    """A pendulum turned at a constant rate under gravity needs another torque at each angle."""
    found = equilibrium(model_of(inverted_pendulum()), rates={"rod.theta": 3.0})
    assert not found.steady and "not steady" in repr(found)


@pytest.mark.parametrize(
    "request_, message",
    [
        ({"held": {"rod.phi": 1.0}}, "no coordinate 'rod.phi'"),
        ({"inputs": {"push": None}}, "There must be as many"),
        ({"inputs": {"pull": None}, "held": {"rod.theta": 0.0}}, "no parameter 'pull'"),
        ({"parameters": {"rod.mass": -1.0}}, "must be at least zero"),
    ],
)
def test_wrong_requests(model_of: Build, request_: dict, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        equilibrium(model_of(inverted_pendulum()), **request_)


def test_a_place_out_of_reach(built_in: Load) -> None:
    with pytest.raises(InitialStateError, match="slider.x = 9"):
        equilibrium(built_in("slider_crank"), held={"slider.x": 9.0})


def buckled(end_force: float) -> SceneRecord:
    """A pinned beam with a lateral load that is zero by default, under an axial force."""
    return (
        Scene("strut")
        .parameter("P", end_force, "N", "compression")
        .beam("strut", length=2.0, density=2700.0, area=1e-4, second_moment=1e-9, youngs_modulus=7e10,
              lateral={"ends": "pinned-pinned", "modes": 3}, stiffening=True)
        .revolute("left", "ground.origin", "strut.start")
        .point_on_line("right", "ground.origin", "strut.end")
        .force("push", "strut.end", "-P", 0.0)
        .simulation(start="quasi_static")
        .build()
    )  # fmt: skip


def test_a_quasi_static_start_refuses_a_buckled_body(model_of: Build) -> None:
    """Beyond pi^2 E I / L^2 = 172.7 N the straight strut is an equilibrium that nobody meant, unless asked for."""
    model = model_of(buckled(200.0))
    p = model.parameter_vector()
    c = model.constants(p)
    with pytest.raises(InitialStateError, match="unstable"):
        start_state(model, p, c, 0.0, None)
    asked = start_state(model, p, c, 0.0, None, "quasi_static_unstable")
    assert not asked.q[[model.coordinates.index(name) for name in model.elastic]].any()
    below = model.parameter_vector({"P": 170.0})
    assert start_state(model, below, model.constants(below), 0.0, None).q.shape == asked.q.shape
    assert not equilibrium(model).stable and equilibrium(model, parameters={"P": 170.0}).stable


def test_linearise_takes_what_was_held_as_locked(built_in: Load) -> None:
    model = built_in("hub_beam")
    found = equilibrium(model, held={"hub.theta": 0.3})
    assert linearise(model, found).names == ["beam.q1", "beam.q2", "beam.q3"]
    assert linearise(model, found, locked=()).names == model.q_i


@pytest.mark.every_push("zigzag")
@pytest.mark.parametrize("start", ["up", "zigzag"])
def test_a_chain_comes_to_rest_from_anywhere(model_of: Build, start: str) -> None:
    """Hand: with the horizontal force H the link k of weight w hangs at tan theta_k = (k - (n - 1) / 2) w / H.

    Thrown up it passes positions, zigzag it starts in one, where its independent angles say nothing of the others.
    """
    n, length, span = 12, 1.5, 1.0
    builder = Scene(f"chain_{start}").gravity(0.0, -G).ground(markers={"hook": {"position": (span, 0.0)}})
    last, link = "ground.origin", length / n
    for k in range(n):
        builder.rigid(f"link{k}", mass=0.1, inertia=1e-5, center_of_mass=(link / 2, 0.0),
                      markers={"end": {"position": (link, 0.0)}})  # fmt: skip
        last = builder.revolute(f"hinge{k}", last, f"link{k}.origin") and f"link{k}.end"
    begin = {f"link{k}.theta": (5.5 - k) * 0.2 if start == "up" else (-1) ** k * 0.84 for k in range(n)}
    found = equilibrium(model_of(builder.initial(begin).revolute("hook", last, "ground.hook").build()))

    def angles(share: float) -> np.ndarray:
        return np.arctan((np.arange(n) - (n - 1) / 2) * share)

    weight_by_force = brentq(lambda share: link * np.cos(angles(share)).sum() - span, 1e-3, 1e3, xtol=1e-15)
    turned = [found[f"link{k}.theta"] for k in range(n)] - angles(weight_by_force)
    assert found.stable
    np.testing.assert_allclose(np.sin(turned / 2), 0.0, atol=1e-9)


@pytest.mark.long
def test_a_top_that_precesses(model_of: Callable[..., Model], built_in: Callable[..., Model]) -> None:
    """By hand: m g l = C (spin + p cos theta) p - A p^2 cos theta, where the tilt theta is sought.

    Its angles are those of hinges, on a ring without weight. A spin in body axes has no such rates, and the refusals
    say what has.
    """

    ring = (
        Scene("top", space="spatial")
        .gravity(0, 0, -9.81)
        .rigid("ring", mass=1e-12, inertia=[1e-12] * 3)
        .rigid(
            "top", mass=15.0, inertia=[0.25, 0.25, 0.5], orientation="zxz", markers={"foot": {"position": (0, 0, -1)}}
        )
        .universal("pivot", "ground.origin", "ring.origin")
        .revolute("spin", "ring.origin", "top.foot")
        .initial({"pivot.angle2": 0.5})
    )
    A, C, spin, p = 15.25, 0.5, 150.0, 2.0
    model = model_of(ring.build())
    found = equilibrium(model, rates={"pivot.angle1": p, "spin.angle": spin})
    tilt = found["top.theta2"]
    assert tilt == pytest.approx(found["pivot.angle2"], rel=1e-12)
    assert C * (spin + p * math.cos(tilt)) * p - A * p**2 * math.cos(tilt) == pytest.approx(15.0 * 9.81, rel=1e-9)
    with pytest.raises(ModelError, match="top.theta1 is an Euler angle.*universal and a revolute"):
        equilibrium(model, rates={"top.theta1": p})
    with pytest.raises(NoEquilibrium, match="turn of a body: give the spin as rates"):
        equilibrium(built_in("heavy_top"), rates={"top.e2": 75.0, "top.e3": -2.30769})


@pytest.mark.long
def test_a_beam_of_pieces_of_very_different_density(model_of: Build) -> None:
    """Densities that differ by 1e9 do not change what a tip force bends: F L^3 / (3 E I) of the whole, to 1e-3."""
    E, second, F = 7e10, 1e-9, 1.0
    builder, last = Scene("pieces"), "ground.origin"
    for k, (density, ends) in enumerate([(2700.0, "welded-welded"), (2.7e-6, "welded-heavy")]):
        bends = {"length": 1.0, "density": density, "area": 1e-4, "second_moment": second, "youngs_modulus": E}
        builder = builder.beam(f"piece{k}", **bends, lateral={"ends": ends, "modes": 4})
        builder, last = builder.weld(f"weld{k}", last, f"piece{k}.start"), f"piece{k}.end"
    model = model_of(builder.force("tip", last, 0.0, -F).measure("sag", "y", last).build())
    assert equilibrium(model).stable
    sag = simulate(model, start="equilibrium", t_end=1e-6, dt=1e-6, scheme="exponential", force=True)["sag"][0]
    assert sag == pytest.approx(-F * 2.0**3 / (3 * E * second), rel=1e-3)


def test_a_drive_by_a_table_holds_what_hangs_on_it(model_of: Build) -> None:
    """A light boom at 0.6 rad carries 100 kg on a hinge: by hand its end bends by m g cos(0.6) L^3 / 3 E I."""
    builder = Scene("boom").gravity(0, -G).table("luff", x=[0.0, 1.0, 2.0], y=[0.6, 0.6, 0.9])
    builder.beam(
        "boom", length=4.0, density=1.0, area=1e-5, second_moment=1e-6, youngs_modulus=2e11, lateral={"modes": 1}
    )
    builder.rigid("load", mass=100.0, inertia=0.0, center_of_mass=(0, -1.0))
    builder.revolute("foot", "ground.origin", "boom.start").revolute("hook", "boom.end", "load.origin")
    builder.prescribed_angle("cylinder", "ground.origin", "boom.start", motion="table('luff', t)")
    rest = equilibrium(model_of(builder.build()), t=0.5)
    assert abs(rest["boom.q1"]) == pytest.approx(100 * G * np.cos(0.6) * 4.0**3 / (3 * 2e11 * 1e-6), rel=1e-6)
    assert rest["load.theta"] == pytest.approx(0.0, abs=1e-8) and rest.stable
