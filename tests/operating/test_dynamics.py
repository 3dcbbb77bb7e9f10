"""Inverse dynamics and its terms: round trips, bodies and loops by hand, motors, Jacobians against measures."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import InitialStateError, ModelError
from runtime.contract.coordinates import independent
from runtime.contract.orientations import rotation
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.support.model_values import evaluate, random_states

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
LOOPS = ["four_bar", "flexible_slider_crank_free", "bricard", "spatial_slider_crank"]


@pytest.mark.parametrize("name", ["double_pendulum", "tumbling_body", *LOOPS])
def test_forward_and_inverse_dynamics_undo_each_other(built_in: Load, name: str) -> None:
    model, rng = built_in(name), np.random.default_rng(3)
    for state in random_states(model, 3, rigid=0.05):
        q, v = independent(model, state.q, state.q_dot)
        a, at = 10 * rng.normal(size=len(q)), {"near": state.q}
        tau = model.inverse_dynamics(q, v, a, **at)
        assert model.forward_dynamics(q, v, tau, **at) == pytest.approx(a, rel=1e-9, abs=1e-9)
        scale = np.abs(tau).max()
        terms = model.mass_matrix(q, **at) @ a + model.coriolis(q, v, **at) + model.gravity(q, **at)
        assert tau == pytest.approx(terms, abs=1e-12 * scale)
        free = model.forward_dynamics(q, v, **at)
        assert model.inverse_dynamics(q, v, free, **at) == pytest.approx(0 * q, abs=1e-9 * scale)


def test_a_free_body_by_newton_and_euler(model_of: Build) -> None:
    """m a, and I omega' + omega x I omega in axes of the body, in any orientation."""
    inertia, m = np.array([0.2, 0.3, 0.4]), 2.0
    body: dict[str, Any] = {
        "mass": m,
        "inertia": inertia,
        "free": True,
        "markers": {"tip": {"position": (0.5, 0.0, 0.1)}},
    }
    model = model_of(Scene("body", space="spatial").gravity(0, 0, -9.81).rigid("b", **body).build())
    rng = np.random.default_rng(1)
    q, v, a = rng.normal(size=(3, 6))
    assert model.q_i[3:] == ["b.turn_x", "b.turn_y", "b.turn_z"]
    omega = v[3:]
    expected = np.concatenate([m * (a[:3] + [0, 0, 9.81]), inertia * a[3:] + np.cross(omega, inertia * omega)])
    assert model.inverse_dynamics(q, v, a) == pytest.approx(expected, rel=1e-12, abs=1e-12)
    turning = rotation(q[3:]) @ omega
    velocity = v[:3] + np.cross(turning, rotation(q[3:]) @ [0.5, 0.0, 0.1])
    assert model.jacobian("b.tip", q) @ v == pytest.approx(np.concatenate([velocity, turning]), abs=1e-12)


def parallelogram(coupler: float = 2.0) -> Scene:
    """Two cranks of 0.5 m and a coupler, each a rod with its mass in the middle; motors at both cranks."""
    bar: dict[str, Any] = {"mass": 1.0, "inertia": 0.02, "center_of_mass": (0.25, 0.0)}
    tip = {"tip": {"position": (0.5, 0.0)}}
    builder = Scene("parallelogram").gravity(0.0, -9.81).ground(markers={"foot": {"position": (2.0, 0.0)}})
    builder.rigid("left", **bar, markers=tip).rigid("right", **bar, markers=tip)
    builder.rigid(
        "coupler", mass=2.0, inertia=0.1, center_of_mass=(1.0, 0.0), markers={"end": {"position": (coupler, 0.0)}}
    )
    builder.revolute("a", "ground.origin", "left.origin").revolute("b", "ground.foot", "right.origin")
    builder.revolute("c", "left.tip", "coupler.origin").revolute("d", "coupler.end", "right.tip")
    for name in "abc":
        builder.input(f"tau_{name}", unit="N m").effort(f"motor_{name}", f"{name}.angle", f"tau_{name}")
    angles = {"left.theta": 0.8, "right.theta": 0.8, "coupler.theta": 0.0}
    return builder.initial(angles).independent("left.theta")


def test_motors_of_a_closed_chain_by_hand(model_of: Build) -> None:
    """J = 2 (I + m r^2) + M l^2 and the weights' slope; the motor of the coupler turns it back by the same angle, so
    the generalised force is tau_a + tau_b - tau_c, which values of least norm share alike."""
    model = model_of(parallelogram().build())
    q, a = 0.9, 3.0
    J = 2 * (0.02 + 0.25**2) + 2.0 * 0.5**2
    force = J * a + (2 * 0.25 + 2.0 * 0.5) * 9.81 * math.cos(q)
    assert model.inverse_dynamics([q], [1.2], [a]) == pytest.approx(force, rel=1e-9)
    found = model.inverse_dynamics([q], [1.2], [a], motors=["tau_a", "tau_b", "tau_c"])
    assert found == pytest.approx([force / 3, force / 3, -force / 3], rel=1e-8)
    assert model.inverse_dynamics([q], [1.2], [a], motors=["tau_b"]) == pytest.approx(force, rel=1e-8)
    motion = model.forward_dynamics([q], [1.2], parameters=dict(zip(("tau_a", "tau_b", "tau_c"), found, strict=True)))
    assert motion == pytest.approx(a, rel=1e-8)


def test_what_cannot_be_is_refused(model_of: Build, built_in: Load) -> None:
    pendulum, chain = built_in("double_pendulum"), model_of(parallelogram().build())
    with pytest.raises(ModelError, match="q must be 2 finite numbers"):
        pendulum.gravity([0.1])
    with pytest.raises(ModelError, match="no input 'motor'"):
        pendulum.inverse_dynamics([0.1, 0.2], [0, 0], [0, 0], motors=["motor"])
    with pytest.raises(ModelError, match="no marker 'left.top' in use; it has .*left.tip"):
        chain.jacobian("left.top", [0.9])
    cart = Scene("cart").rigid("c", mass=1.0, inertia=1.0).rigid("p", mass=1.0, inertia=1.0,
                                                                        center_of_mass=(0.0, -1.0))  # fmt: skip
    cart.prismatic("rail", "ground.origin", "c.origin").revolute("pin", "c.origin", "p.origin")
    cart.input("push").effort("motor", "rail.travel", "push")
    with pytest.raises(ModelError, match="motors push .* cannot make this motion"):
        model_of(cart.build()).inverse_dynamics([0.1, 0.2], [0, 0], [1, 2], motors=["push"])
    short = parallelogram(1.2).initial({"left.theta": 0.0, "right.theta": 2.2, "coupler.theta": 0.4})
    with pytest.raises(InitialStateError, match="do not close"):
        model_of(short.build()).gravity([math.pi])  # the tip is 2 m from where the other can be


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_jacobians_are_the_rates_of_measures(model_of: Build, space: str) -> None:
    """Of a point of a stiffened beam on a moving hub: x, y, z and the angle, elastic parts and foreshortening too."""
    three = (0.1,) if space == "spatial" else ()
    inertia: Any = [0.3, 0.5, 0.4] if space == "spatial" else 0.4
    more: dict[str, Any] = {"second_moment_z": 2e-9, "lateral_z": {"modes": 1}} if space == "spatial" else {}
    builder = Scene("arm", space=space).rigid("hub", mass=1.0, inertia=inertia,
                                                     markers={"rim": {"position": (0.2, 0.1, *three)}})  # fmt: skip
    builder.beam("rod", length=1.2, density=2700.0, area=1e-4, second_moment=1e-9, youngs_modulus=7e10,
                 lateral={"modes": 2, "ends": "clamped-free"}, stiffening=True, markers={"mid": {"at": 0.6}},
                 **more)  # fmt: skip
    builder.revolute("axle", "ground.origin", "hub.origin").revolute("pin", "hub.rim", "rod.start")
    axes = "xyz"[: 3 if space == "spatial" else 2]
    for axis in axes:
        builder.measure(axis, axis, "rod.mid")
    builder.measure("angle", "angle", "rod.mid") if space == "planar" else None
    model = model_of(builder.build())
    for state in random_states(model, 3, elastic=0.05):
        rates = evaluate(model, "measures", **state.values())["measures"]
        rate_of = dict(zip(model.measures, rates, strict=True))
        J = model.jacobian("rod.mid", state.q_i)
        found = J @ state.q_i_dot
        assert [rate_of[f"{axis}_dot"] for axis in axes] == pytest.approx(found[: len(axes)], rel=1e-10, abs=1e-12)
        if space == "planar":
            assert found[5] == pytest.approx(rate_of["angle_dot"], rel=1e-10)
