"""Equilibria and inverse dynamics with friction that sticks, by hand."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Model, simulate
from runtime.operating.dynamics import Dynamics
from runtime.operating.equilibrium import NoEquilibrium
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


def pendulums(coulomb: float, viscous: float = 0.0) -> SceneRecord:
    """Two links of 0.6 m and 1 kg that hang; the upper hinge has friction."""
    builder, last = Scene("rubbing_pendulums").gravity(0.0, -9.81).ground(), "ground.origin"
    for k in range(2):
        tip = {"tip": {"position": [0.6, 0.0]}}
        builder.rigid(f"l{k}", mass=1.0, inertia=0.1, center_of_mass=[0.3, 0.0], markers=tip)
        friction = {} if k else {"friction": {"coulomb": coulomb, "viscous": viscous}}
        builder.revolute(f"j{k}", last, f"l{k}.origin", **friction)
        last = f"l{k}.tip"
    return builder.simulation(t_end=2.0, dt=0.01, scheme="rk4").build()


def test_a_hinge_holds_its_arm_out_while_the_rest_hangs(model_of: Build) -> None:
    """The upper arm stays level by 9.81 (0.3 + 0.6) N m; the lower one swings by omega^2 = 9.81 * 0.3 / 0.19.

    A run that begins there rests; with less friction there is no such equilibrium, and the force says so.
    """
    model = model_of(pendulums(9.0))
    found = model.equilibrium(initial={"l1.theta": -1.0})
    assert found.friction == {"j0.friction": pytest.approx(9.81 * 0.9, rel=1e-12)}
    assert found["l0.theta"] == 0.0 and found["l1.theta"] == pytest.approx(-np.pi / 2, abs=1e-12)
    assert found.stable and "held by j0.friction" in repr(found)
    assert sorted(found.eigenvalues.imag) == pytest.approx([-np.sqrt(2.943 / 0.19), np.sqrt(2.943 / 0.19)], rel=1e-9)
    assert model.modes(found).frequencies == pytest.approx([np.sqrt(2.943 / 0.19)], rel=1e-9)
    run = simulate(model, initial=found)
    assert not run["l0.theta"].any() and run["j0.friction_force"][-1] == pytest.approx(8.829, rel=1e-9)
    with pytest.raises(NoEquilibrium, match=r"j0\.friction would have to hold 8\.829, more than it can"):
        model_of(pendulums(8.5)).equilibrium(initial={"l1.theta": -1.0})


def test_what_turns_steadily_slides(model_of: Build) -> None:
    """A hinge that turns at 2 rad/s without weight needs coulomb + 2 viscous, to either side."""
    builder = Scene("turning").ground().rigid("rotor", mass=1.0, inertia=0.1)
    builder.revolute("axle", "ground.origin", "rotor.origin", friction={"coulomb": 0.5, "viscous": 0.1})
    model = model_of(builder.build())
    for rate, moment in ((2.0, 0.7), (-2.0, -0.7)):
        found = model.equilibrium(rates={"rotor.theta": rate})
        assert found.holding["rotor.theta"] == pytest.approx(moment, rel=1e-12) and not found.friction


def test_inverse_dynamics_adds_friction_by_the_sign_of_the_rate(model_of: Build) -> None:
    """At rest none; forward dynamics holds what it can, and goes back to the acceleration asked for."""
    dynamics = Dynamics(model_of(pendulums(20.0, 0.5)))
    q, a = [0.3, -1.0], [0.4, -0.2]
    still = dynamics.inverse_dynamics(q, [0.0, 0.0], a)
    bare = Dynamics(model_of(pendulums(1e-9)))
    assert still == pytest.approx(bare.inverse_dynamics(q, [0.0, 0.0], a), abs=1e-12)
    for rate in (1.5, -1.5):
        moment = 20.0 * np.sign(rate) + 0.5 * rate
        tau = dynamics.inverse_dynamics(q, [rate, 0.0], a)
        assert tau - bare.inverse_dynamics(q, [rate, 0.0], a) == pytest.approx([moment, 0.0], abs=1e-8)
        assert dynamics.forward_dynamics(q, [rate, 0.0], tau) == pytest.approx(a, abs=1e-12)
    held = dynamics.forward_dynamics([0.0, -1.0], [0.0, 0.0])
    assert held == pytest.approx([0.0, -9.81 * 0.3 * np.cos(1.0) / 0.19], abs=1e-12)
    lower, upper = ([dynamics.gravity([0.0, -np.pi / 2])[0] + side * 20.0, 0.0] for side in (-1, 1))
    for moment, accelerates in ((upper[0] - 0.1, 0), (upper[0] + 0.1, 1), (lower[0] - 0.1, -1)):
        found = dynamics.forward_dynamics([0.0, -np.pi / 2], [0.0, 0.0], [moment, 0.0])[0]
        assert found == pytest.approx(accelerates * 0.1 / 0.55, abs=1e-12)
