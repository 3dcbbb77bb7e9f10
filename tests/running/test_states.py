"""States of controllers, filters and actuators: part of the motion, of every scheme and of every linear system."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

from runtime import (
    SCHEMES,
    campbell,
    ensemble,
    equilibrium,
    gradient,
    linearise,
    modes,
    resume,
    simulate,
)
from runtime.gradients import End
from runtime.model import Model
from symgen.scene import Scene, SceneError, SceneRecord
from tests.support.augmented import augmented_run
from tests.support.scenes import on_rail

Build = Callable[[SceneRecord], Model]
J, D, KP, KI, WANTED = 0.02, 0.01, 0.2, 0.5, 30.0  # a rotor with friction and its PI controller


def rotor(**changes: Any) -> SceneRecord:
    """A PI controller of the speed, its integral a state."""
    builder = (
        Scene("rotor")
        .input("wanted", WANTED, "rad/s")
        .rigid("rotor", mass=1.0, inertia=J)
        .revolute("axle", "ground.origin", "rotor.origin", damping=D)
        .measure("angle", "angle", "rotor.origin")
        .state("total", "wanted - angle_dot", unit="rad")
        .torque("motor", "rotor.origin", f"{KP} * (wanted - angle_dot) + {KI} * total")
        .simulation(t_end=0.5, dt=1e-3, scheme="rk4")
    )
    return SceneRecord.from_dict({**builder.build().to_dict(), **changes})


def arm() -> SceneRecord:
    """A PID controller holds an arm under gravity: a loop of third order."""
    return (
        Scene("arm")
        .input("wanted", 0.5, "rad")
        .gravity(0, -9.81)
        .rigid("arm", mass=1.0, inertia=0.02, center_of_mass=(0.5, 0))
        .revolute("axle", "ground.origin", "arm.origin", damping=0.01)
        .measure("angle", "angle", "arm.origin")
        .state("total", "wanted - angle", unit="rad s")
        .torque("motor", "arm.origin", "20 * (wanted - angle) - 3 * angle_dot + 8 * total")
        .simulation(t_end=1.0, dt=1e-3, scheme="dop853")
        .build()
    )


CLOSED = np.array([[-(D + KP) / J, KI / J], [-1.0, 0.0]])
REST = -np.linalg.solve(CLOSED, [KP * WANTED / J, WANTED])


@pytest.mark.every_push("rk4", "coupled")
@pytest.mark.parametrize("scheme", SCHEMES)
def test_every_scheme_closes_the_loop(model_of: Build, scheme: str) -> None:
    """(w, total) = x_0 + exp(A t) (0 - x_0) of the loop by hand."""
    run = simulate(model_of(rotor()), scheme=scheme, seen_every=0.01)
    exact = np.array([REST - expm(CLOSED * t) @ REST for t in run.t])
    tolerance = 2e-3 if SCHEMES[scheme].make.order == 2 else 1e-9  # of 33 rad/s, 500 steps
    np.testing.assert_allclose(run["rotor.theta_dot"], exact[:, 0], atol=tolerance)
    np.testing.assert_allclose(run["total"], exact[:, 1], atol=tolerance)
    np.testing.assert_allclose(run["total_dot"], WANTED - exact[:, 0], atol=tolerance)
    assert np.abs(run.energy_balance()).max() < 2e-3  # of 7 J; the controller's own numbers are no energy


def test_a_filter_and_an_actuator_in_a_row(model_of: Build) -> None:
    """A force through two lags of first order: the mass moves as the transfer function's step response says."""
    a, b = 20.0, 5.0
    scene = (
        on_rail("lag", "cart", "rail", mass=1.0, inertia=0.1)
        .input("wish", 0.0, "N")
        .state("signal", f"{a} * (wish - signal)", unit="N")
        .state("force", f"{b} * (signal - force)", initial=0.25, unit="N")
        .force("push", "cart.origin", "force", 0.0)
        .simulation(t_end=1.0, dt=1e-3, scheme="rk4")
        .build()
    )
    run = simulate(model_of(scene), inputs={"wish": 2.0}, initial={"signal": 0.5}, seen_every=0.1)
    A = np.array([[-a, 0, 0, 0], [b, -b, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])
    both = np.block([[A, np.array([[2 * a], [0], [0], [0]])], [np.zeros((1, 5))]])
    exact = np.array([(expm(both * t) @ [0.5, 0.25, 0, 0, 1])[:4] for t in run.t])
    for k, name in enumerate(("signal", "force", "cart.x_dot", "cart.x")):
        np.testing.assert_allclose(run[name], exact[:, k], atol=1e-10)


@pytest.mark.long
def test_states_beside_loops_groups_and_partitions(model_of: Build) -> None:
    """A four-bar whose motor follows a filtered torque: condensed and stepped with sub-steps, and with others chosen.

    The filter stands for a torque given as a function of time, 1 - exp(-8 t).
    """

    def four_bar(torque: str) -> Scene:
        return (
            Scene("four_bar")
            .rigid("crank", mass=1.0, inertia=0.02, markers={"end": {"position": (0.2, 0)}})
            .rigid("coupler", mass=1.0, inertia=0.05, markers={"end": {"position": (0.7, 0)}})
            .rigid("rocker", mass=1.0, inertia=0.04, markers={"end": {"position": (0.5, 0)}})
            .ground(markers={"right": {"position": (0.8, 0)}})
            .revolute("A", "ground.origin", "crank.origin")
            .revolute("B", "crank.end", "coupler.origin")
            .revolute("C", "coupler.end", "rocker.end")
            .revolute("E", "ground.right", "rocker.origin")
            .torque("motor", "crank.origin", torque)
            .initial({"crank.theta": {"value": 1.0, "fixed": True}, "coupler.theta": 0.5, "rocker.theta": 1.6})
            .simulation(t_end=0.5, dt=1e-3, scheme="rk4")
        )

    given = simulate(model_of(four_bar("1 - exp(-8 * t)").build()))
    filtered = four_bar("torque").state("torque", "8 * (1 - torque)", unit="N m")
    plain = simulate(model_of(filtered.build()))
    chosen = simulate(model_of(filtered.independent("crank.theta").groups(slow=["crank.*"]).build()))
    for run in (plain, chosen):
        np.testing.assert_allclose(run["rocker.theta"], given["rocker.theta"], atol=1e-10)
        np.testing.assert_allclose(run.joint_force("C"), given.joint_force("C"), atol=1e-8)


def test_operating_points_of_closed_loops(model_of: Build) -> None:
    """The integral carries the weight; a wanted angle solved for; the loop's own third-order polynomial."""
    model = model_of(arm())
    rest = equilibrium(model)
    weight = 9.81 * 0.5
    assert rest["arm.theta"] == pytest.approx(0.5, abs=1e-12) and rest.stable
    assert rest["total"] == pytest.approx(weight * np.cos(0.5) / 8, rel=1e-12)
    trimmed = equilibrium(model, held={"arm.theta": 1.0}, inputs={"wanted": None})
    assert trimmed.trimmed["wanted"] == pytest.approx(1.0, rel=1e-12)
    assert trimmed["total"] == pytest.approx(weight * np.cos(1.0) / 8, rel=1e-12)
    inertia = 0.02 + 0.25
    roots = np.roots([inertia, 3.01, 20 - weight * np.sin(0.5), 8])
    system = linearise(model, rest, inputs=["wanted"], outputs=["angle", "total"])
    assert system.state_names == ["arm.theta", "arm.theta_dot", "total"]
    np.testing.assert_allclose(np.sort_complex(np.linalg.eigvals(system.A_state)), np.sort_complex(roots), rtol=1e-11)
    found = modes(model, rest)
    np.testing.assert_allclose(found.frequencies, np.sort(np.abs(roots[roots.imag >= 0])), rtol=1e-11)
    s = 1j * 4.0
    answer = (20 * s + 8) / (inertia * s**3 + 3.01 * s**2 + (20 - weight * np.sin(0.5)) * s + 8)
    np.testing.assert_allclose(system.frequency_response(np.array([0.0, 4.0]))[:, 0, 0], [1.0, answer], rtol=1e-11)


def test_the_closed_loop_is_the_slope_of_the_simulation(model_of: Build) -> None:
    """exp(A T) against central differences of runs, states of the controller included, to 1e-7."""
    model, T, e = model_of(arm()), 0.2, 1e-5
    rest = equilibrium(model)
    exact = expm(linearise(model, rest).A_state * T)
    names, stepper, columns = ["arm.theta", "arm.theta_dot", "total"], model.stepper(), []
    for name in names:
        ends = []
        for sign in (e, -e):
            stepper.reset({one: rest[one] + sign * (one == name) for one in names})
            stepper.step(200)
            ends.append([{**stepper.state, **stepper.measures}[one] for one in names])
        columns.append((np.array(ends[0]) - np.array(ends[1])) / (2 * e))
    np.testing.assert_allclose(np.array(columns).T, exact, rtol=1e-7, atol=1e-8)


def test_a_run_with_states_is_gone_on_with(model_of: Build, tmp_path: Any) -> None:
    model, kept = model_of(rotor()), tmp_path / "run.npz"
    whole = simulate(model, checkpoint=kept, checkpoint_every=200)
    np.testing.assert_array_equal(resume(model, kept).q_dot, whole.q_dot)


@pytest.mark.parametrize(
    "change, words",
    [
        ({"states": {"total": {"rate": "total_dot"}}}, "unknown name 'total_dot'"),
        ({"states": {"total": {"rate": "1 +"}}}, r"states.total.rate"),
        ({"states": {"wanted": {"rate": "1"}}}, "already used"),
        ({"states": {"total": {"rate": "0", "initial": "x"}}}, "not a number"),
        (
            {
                "joints": [
                    {"type": "revolute", "name": "a", "marker_a": "ground.origin", "marker_b": "rotor.origin"},
                    {
                        "type": "prescribed_angle",
                        "name": "b",
                        "marker_a": "ground.origin",
                        "marker_b": "rotor.origin",
                        "motion": "total",
                    },
                ]
            },
            "driven by the mechanism's own motor",
        ),
    ],
)
def test_wrong_states_are_refused_by_name(change: dict[str, Any], words: str) -> None:
    with pytest.raises(SceneError, match=words):
        rotor(**change)


def test_a_campbell_diagram_of_a_closed_loop(model_of: Build) -> None:
    """Roots of J x^2 + (D + KP) x + KI = 0 by hand: two real ones, which meet at (D + KP)^2 = 4 KI J and vibrate then.

    With the angle, which nothing holds, there are three modes below and two above.
    """
    inertia = np.linspace(0.012, 0.036, 9)
    found = campbell(model_of(rotor()), "rotor.inertia", inertia, parameters={"wanted": 0.0})
    assert found.frequencies.shape == (9, 3) and found.names[0] == "rigid rotor.theta"
    for row, J_here in zip(found.eigenvalues, inertia, strict=True):
        roots = np.roots([J_here, D + KP, KI])
        exact = np.sort_complex(np.r_[0.0, roots[roots.imag >= 0]])
        np.testing.assert_allclose(np.sort_complex(row[np.isfinite(row)]), exact, rtol=1e-8, atol=1e-8)
    gone = np.isnan(found.frequencies)
    assert gone.sum(axis=0).tolist() in ([0, 5, 0], [0, 0, 5]) and not gone[:4].any()


def test_in_space_both_derivations_agree(model_of: Build) -> None:
    """A filtered input and two states on a spatial tree: condensed steps against DOP853 on the augmented form (28)."""
    scene = (
        Scene("crane", space="spatial")
        .input("wanted", 0.3, "rad", filter=8.0)
        .gravity(0, 0, -9.81)
        .rigid(
            "boom",
            mass=1.0,
            inertia=(0.1, 0.2, 0.3),
            center_of_mass=(0.3, 0, 0),
            markers={"tip": {"position": (0.6, 0, 0)}},
        )
        .rigid("load", mass=0.5, inertia=(0.1, 0.2, 0.3), center_of_mass=(0.2, 0.1, 0))
        .revolute("slew", "ground.origin", "boom.origin")
        .spherical("hook", "boom.tip", "load.origin")
        .measure("angle", "angle", "boom.origin")
        .state("total", "wanted - angle", unit="rad s")
        .state("effort", "5 * (total - effort) + wanted_dot")
        .torque("motor", "boom.origin", "3 * (wanted - angle) + 2 * effort - 0.5 * angle_dot")
        .simulation(t_end=0.3, dt=1e-3, scheme="rk4", seen_every=0.1)
        .build()
    )
    model = model_of(scene).with_inputs({"wanted": 0.7})
    run = simulate(model)
    other = augmented_run(model, t_end=0.3, times=run.t)
    for name in ("total", "effort", "boom.x", "load.z", "wanted_ddot"):
        np.testing.assert_allclose(run[name], other[name], atol=1e-8)


def test_ensembles_and_gradients(model_of: Build) -> None:
    """Cases with other inputs and other states at the start, and the slope by both, of the linear loop by hand."""
    model, wanted, start = model_of(rotor()), np.array([10.0, 20.0]), np.array([0.1, 0.3])
    found = ensemble(model, {"wanted": wanted}, initial={"total": start}, reduce={"total": "end"})
    transition = expm(CLOSED * 0.5)
    rests = np.outer(wanted / WANTED, REST)
    exact = [rest + transition @ (np.array([0.0, one]) - rest) for rest, one in zip(rests, start, strict=True)]
    np.testing.assert_allclose(np.asarray(found["total_end"]), np.array(exact)[:, 1], atol=1e-9)
    slope = gradient(model, End("total"), ["wanted", "total.integral_dot"])
    by_wanted = ((np.eye(2) - transition) @ REST)[1] / WANTED
    np.testing.assert_allclose([slope["wanted"], slope["total.integral_dot"]], [by_wanted, transition[1, 1]], rtol=1e-8)
