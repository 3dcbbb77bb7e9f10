"""Equilibria and inverse dynamics with friction that sticks, by hand."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Model, ModelError, NoEquilibrium, simulate
from runtime.operating.dynamics import Dynamics
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


def test_a_rigid_stop_is_open_within_and_pushes_what_rests_on_it(model_of: Build) -> None:
    """2 kg on a vertical rail over a stop at zero: m (a + g) above it; on it the weight rests; beyond it is refused."""
    builder = Scene("lift").gravity(0.0, -9.81).ground(markers={"up": {"angle": np.pi / 2}})
    builder.rigid("block", mass=2.0, inertia=1.0, markers={"up": {"angle": np.pi / 2}})
    limits = {"lower": 0.0, "upper": 3.0, "restitution": 0.2}
    builder.prismatic("rail", "ground.up", "block.up", limits=limits).initial({"block.y": 1.0})
    builder.input("lift", unit="N").force("pull", "block.origin", 0.0, "min(max(lift, -60), 60)")
    model = model_of(builder.build())
    (name,) = model.q_i
    assert name == "block.y" and model.mass_matrix([0.5]) == pytest.approx(2.0)
    assert model.gravity([0.5]) == pytest.approx(2 * 9.81) == model.gravity([0.0])
    assert model.inverse_dynamics([0.5], [0.3], [1.5]) == pytest.approx(2 * (9.81 + 1.5))
    assert model.inverse_dynamics([0.5], [0.3], [1.5], motors=["lift"]) == pytest.approx(2 * (9.81 + 1.5))
    assert model.forward_dynamics([0.5], [0.0]) == pytest.approx(-9.81)
    assert model.forward_dynamics([0.0], [0.0]) == pytest.approx(0.0, abs=1e-12)
    assert model.forward_dynamics([0.0], [0.0], [2 * 9.81 + 1.0]) == pytest.approx(0.5)
    assert model.forward_dynamics([3.0], [0.0], [2 * 9.81 + 1.0]) == pytest.approx(0.0, abs=1e-12)
    assert model.forward_dynamics([3.0], [0.0]) == pytest.approx(-9.81)
    for asked in (lambda q: model.inverse_dynamics(q, [0.0], [0.0]), lambda q: model.forward_dynamics(q, [0.0])):
        with pytest.raises(ModelError, match=r"rail\.limits\.lower .*q is 0\.1 beyond it"):
            asked([-0.1])
    with pytest.raises(ModelError, match="too few or at their limits"):
        model.inverse_dynamics([0.5], [0.3], [30.0], motors=["lift"])


def test_a_motor_with_a_small_limit_is_solved_for(model_of: Build) -> None:
    """It gives 0.2 N m at most, less than a unit, and 0.05 are needed."""
    builder = (
        Scene("small").ground().rigid("rotor", mass=1.0, inertia=0.1).revolute("axle", "ground.origin", "rotor.origin")
    )
    builder.input("tau").torque("motor", "rotor.origin", "min(max(tau, -0.2), 0.2)")
    model = model_of(builder.build())
    assert model.inverse_dynamics([0.0], [0.0], [0.5], motors=["tau"]) == pytest.approx(0.05, rel=1e-9)


@pytest.mark.parametrize("rate", [1.5, -1.5])
def test_friction_by_the_joints_own_force_is_in_inverse_dynamics(model_of: Build, rate: float) -> None:
    """A slide under m g: m a + mu m g; a hinge: |m (a_c - g)| mu r, a_c of the centre at l. At rest none."""
    sign, a = np.sign(rate), 0.7
    slide = Scene("slide").gravity(0.0, -9.81).rigid("block", mass=2.0, inertia=1.0)
    model = model_of(slide.prismatic("rail", "ground.origin", "block.origin", friction={"mu": 0.3}).build())
    assert model.inverse_dynamics([0.2], [rate], [a]) == pytest.approx(2 * a + sign * 0.3 * 2 * 9.81, rel=1e-12)
    assert model.inverse_dynamics([0.2], [0.0], [a]) == pytest.approx(2 * a, rel=1e-12)
    with pytest.raises(ModelError, match="forward dynamics at a state do not solve for"):
        model.forward_dynamics([0.2], [rate])
    m, L, J, q = 3.0, 0.4, 0.2, 0.6
    for space in ("planar", "spatial"):
        weight = (0.0, -9.81) if space == "planar" else (0.0, -9.81, 0.0)
        arm = Scene(f"{space}_arm", space=space).gravity(*weight)
        arm.rigid("arm", mass=m, inertia=J if space == "planar" else [J, J, J], center_of_mass=[L, 0.0][: len(weight)]
                  if space == "planar" else [L, 0.0, 0.0])  # fmt: skip
        arm.revolute("pin", "ground.origin", "arm.origin", friction={"mu": 0.1, "radius": 0.05})
        model = model_of(arm.build())
        along, across = np.array([np.cos(q), np.sin(q)]), np.array([-np.sin(q), np.cos(q)])
        R = m * np.linalg.norm(-L * rate**2 * along + L * a * across + [0.0, 9.81])
        expected = (J + m * L**2) * a + m * 9.81 * L * np.cos(q) + sign * 0.1 * 0.05 * R
        assert model.inverse_dynamics([q], [rate], [a]) == pytest.approx(expected, rel=1e-12)
        assert model.gravity([q]) == pytest.approx(m * 9.81 * L * np.cos(q), rel=1e-12)
        with pytest.raises(ModelError, match="depends on accelerations"):
            model.coriolis([q], [rate])
