"""Mechanisms in which every coordinate is driven, against torques derived by hand."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from runtime import ModelError, SchemeError, simulate
from runtime.model import Model
from runtime.studies.stability.chart import stability_chart
from symgen.cli import main
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import on_rail

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]
G = 9.81


def scotch_yoke() -> SceneRecord:
    """A crank of radius 0.15 m, driven, whose pin slides in the slot of a yoke of 2 kg that moves along x."""
    return (
        Scene("scotch_yoke")
        .gravity(0.0, -G)
        .parameter("speed", 4.0, "rad/s", "speed of the crank")
        .rigid("crank", mass=1.5, inertia=0.02, center_of_mass=(0.05, 0.0), markers={"pin": {"position": (0.15, 0.0)}})
        .rigid("yoke", mass=2.0, inertia=0.1, markers={"slot": {"angle": math.pi / 2}})
        .revolute("axle", "ground.origin", "crank.origin")
        .prismatic("guide", "ground.origin", "yoke.origin")
        .point_on_line("pin", "yoke.slot", "crank.pin")
        .prescribed_angle("drive", "ground.origin", "crank.origin", motion="speed * t + 0.3 * sin(5 * t)")
        .simulation(t_end=2.0, dt=0.01)
        .build()
    )


def test_scotch_yoke(model_of: Build) -> None:
    """Hand: x = r cos f; T = (I_G + m_c s^2) f'' + m_c g s cos f + m r^2 sin f (f'' sin f + f'^2 cos f)."""
    model = model_of(scotch_yoke())
    assert not model.q_i and not {"condensed", "dQ_hat_dq_i", "augmented"} & set(model.builders)
    solution = simulate(model)
    t, r, m, s = solution.t, 0.15, 2.0, 0.05
    f, f1, f2 = 4 * t + 0.3 * np.sin(5 * t), 4 + 1.5 * np.cos(5 * t), -7.5 * np.sin(5 * t)
    torque = (
        (0.02 + 1.5 * s**2) * f2 + 1.5 * G * s * np.cos(f) + m * r**2 * np.sin(f) * (f2 * np.sin(f) + f1**2 * np.cos(f))
    )
    assert solution.status.ok and t[-1] == pytest.approx(2.0)
    np.testing.assert_allclose(solution.motor("drive"), torque, rtol=0, atol=1e-12 * np.abs(torque).max())
    np.testing.assert_allclose(solution["yoke.x"], r * np.cos(f), atol=1e-14)
    np.testing.assert_allclose(solution["yoke.x_ddot"], -r * (f2 * np.sin(f) + f1**2 * np.cos(f)), atol=1e-12)
    np.testing.assert_allclose(solution.motor("drive") * f1, solution.energy["power_driven"], atol=1e-12)
    assert not solution.error.measured and "nothing is integrated" in str(solution.error)


def four_bar() -> SceneRecord:
    """Crank 0.2, coupler 0.6, rocker 0.4, ground 0.5 m; uniform bars, the crank at 3 rad/s."""
    builder = (
        Scene("driven_four_bar")
        .gravity(0.0, -G)
        .ground(markers={"D": {"position": (0.5, 0.0)}})
        .parameter("speed", 3.0, "rad/s", "speed of the crank")
    )
    for name, length, mass in (("crank", 0.2, 1.0), ("coupler", 0.6, 2.0), ("rocker", 0.4, 1.5)):
        builder = builder.rigid(
            name,
            mass=mass,
            inertia=mass * length**2 / 12,
            center_of_mass=(length / 2, 0.0),
            markers={"tip": {"position": (length, 0.0)}},
        )
    return (
        builder.revolute("A", "ground.origin", "crank.origin")
        .revolute("B", "crank.tip", "coupler.origin")
        .revolute("C", "coupler.tip", "rocker.tip")
        .revolute("D", "ground.D", "rocker.origin")
        .prescribed_angle("drive", "ground.origin", "crank.origin", motion="speed * t")
        .initial({"coupler.theta": 0.8, "rocker.theta": 1.6})
        .simulation(t_end=4.2, dt=0.02)
        .build()
    )


def hand_derived_torque(t: float, speed: float) -> tuple[float, float]:
    """(torque, rocker's angle): the loop by the cosine rule, rates by Cramer's rule, torque by virtual power.

    a e^(i phi) + b e^(i beta) = d + c e^(i gamma), twice differentiated; T phi' = sum m (a_G + g) . v_G + J w' w.
    """
    a, b, c, d, phi = 0.2, 0.6, 0.4, 0.5, speed * t
    x, y = d - a * math.cos(phi), -a * math.sin(phi)  # from B to D
    span = math.hypot(x, y)
    beta = math.atan2(y, x) + math.acos((b**2 + span**2 - c**2) / (2 * b * span))
    gamma = math.atan2(a * math.sin(phi) + b * math.sin(beta), a * math.cos(phi) + b * math.cos(beta) - d)
    D = math.sin(beta - gamma)
    w_b = -a * speed * math.sin(phi - gamma) / (b * D)
    w_c = a * speed * math.sin(beta - phi) / (c * D)
    # i b beta'' e^(i beta) - i c gamma'' e^(i gamma) = h, h = a phi'^2 e^(i phi) + b beta'^2 e^(i beta) - c ...
    turn = np.exp(1j * np.array([phi, beta, gamma]))
    h = a * speed**2 * turn[0] + b * w_b**2 * turn[1] - c * w_c**2 * turn[2]
    e_b = (h / turn[2]).real / (-b * math.sin(beta - gamma))
    e_c = (h / turn[1]).real / (c * math.sin(gamma - beta))
    power = 0.0
    start_v, start_a = 1j * a * speed * turn[0], -a * speed**2 * turn[0]
    for mass, length, base_v, base_a, w, e, u in (
        (1.0, a, 0.0, 0.0, speed, 0.0, turn[0]),
        (2.0, b, start_v, start_a, w_b, e_b, turn[1]),
        (1.5, c, 0.0, 0.0, w_c, e_c, turn[2]),
    ):
        v = base_v + 1j * w * length / 2 * u
        acceleration = base_a + (1j * e - w**2) * length / 2 * u
        power += mass * (np.conj(acceleration + 1j * G) * v).real + mass * length**2 / 12 * e * w
    return float(power / speed), gamma


def test_driven_four_bar(model_of: Build) -> None:
    """Two turns of the crank: the motor's torque and the rocker's angle."""
    model = model_of(four_bar())
    assert model.loop_unknowns and not model.q_i
    solution = simulate(model)
    wanted = [hand_derived_torque(float(t), 3.0) for t in solution.t]
    torque = np.array([torque for torque, _ in wanted])
    np.testing.assert_allclose(solution.motor("drive"), torque, rtol=0, atol=1e-12 * np.abs(torque).max())
    angle = np.unwrap([gamma for _, gamma in wanted])
    np.testing.assert_allclose(solution["rocker.theta"] - angle, solution["rocker.theta"][0] - angle[0], atol=1e-12)
    assert solution.constraint_error.max() < 1e-15 and solution.status.ok


def test_long_steps_keep_the_branch(model_of: Build) -> None:
    """A sample in each tenth of a turn is the same as one in each thousandth: the loop is followed in between."""
    model = model_of(four_bar())
    coarse, fine = (simulate(model, dt=dt, t_end=2.0) for dt in (0.2, 0.002))
    np.testing.assert_allclose(coarse.q, fine.q[::100], atol=1e-13)


def test_a_drive_that_cannot_go_on(model_of: Build) -> None:
    """Crank 0.3 and coupler 0.2 m: the run ends, with its time, where coupler and rocker are in line."""
    model = model_of(four_bar())
    dead = math.acos((0.5**2 + 0.3**2 - 0.6**2) / (2 * 0.5 * 0.3))
    solution = simulate(model, parameters={"crank.tip.x": 0.3, "coupler.tip.x": 0.2}, t_end=1.5, dt=0.001)
    assert solution.status.name == "constraints_lost" and 3.0 * solution.t[-1] == pytest.approx(dead, abs=0.01)


def test_motors_of_scenes_with_freedoms(built_in: Load) -> None:
    """Law: torque times prescribed rate is the drive's power, also where the rest of the mechanism moves freely."""
    solution = simulate(built_in("flexible_slider_crank"), t_end=0.005)
    drive = next(j.name for j in solution.model.description.joints if j.type.startswith("prescribed"))
    power = solution.energy["power_driven"]
    np.testing.assert_allclose(solution.motor(drive) * 150.0, power, rtol=1e-12, atol=1e-9)
    assert np.abs(power).max() > 1.0


def test_wrong_requests(model_of: Build, built_in: Load) -> None:
    solution = simulate(model_of(scotch_yoke()), t_end=0.1)
    with pytest.raises(ModelError, match="no prescribed motion 'axle'; it has drive"):
        solution.motor("axle")
    with pytest.raises(SchemeError, match="every coordinate of model scotch_yoke is driven"):
        simulate(model_of(scotch_yoke()), outputs=["yoke.x"])
    with pytest.raises(SchemeError, match="dt must be a positive number"):
        simulate(model_of(scotch_yoke()), dt=-1.0)
    with pytest.raises(ModelError, match="nothing is stepped"):
        stability_chart(model_of(scotch_yoke()))


@pytest.mark.long
def test_on_the_command_line(tmp_path, capsys: pytest.CaptureFixture[str]) -> None:  # type: ignore[no-untyped-def]
    path = tmp_path / "scotch_yoke.toml"
    path.write_text(scotch_yoke().to_toml(), encoding="utf-8")
    assert main(["simulate", str(path), "--out", str(tmp_path / "run"), "--plots"]) == 0
    assert "completed" in capsys.readouterr().out
    assert main(["show", str(path)]) == 0


def test_samples_far_apart_stay_on_the_branch(model_of: Build) -> None:
    """Three radians of the crank from sample to sample: the angles are those of samples 0.03 rad apart."""
    model = model_of(four_bar())
    fine, coarse = (simulate(model, dt=dt, t_end=8.0, seen_every=0.0) for dt in (0.01, 1.0))
    assert coarse.status.ok and np.abs(coarse.q - fine.q[::100]).max() < 1e-12


def test_samples_lie_seen_every_apart(model_of: Build) -> None:
    run = simulate(model_of(four_bar()), dt=0.01, t_end=0.2, seen_every=0.04)
    assert run.t == pytest.approx(np.arange(6) * 0.04)


MOTION = "abs(t - 0.005) + where(t > 0.007, t - 0.007, 0)"


def test_a_driven_velocity_that_jumps_is_told_with_its_impulse(model_of: Callable[[SceneRecord], Model]) -> None:
    """A slider of 2 kg on |t - 0.005|: its velocity turns from -1 to 1 m/s, no energy is gained; then to 2 m/s: 3 J."""
    scene = (
        on_rail("turned", "slider", "rail", mass=2.0, inertia=0.1)
        .prescribed_displacement("drive", "ground.origin", "slider.origin", motion=MOTION)
        .simulation(t_end=0.01, dt=1e-3)
        .build()
    )
    run = simulate(model_of(scene))
    told = [(event.time, event.text) for event in run.events if event.kind == "velocity_jump"]
    assert [time for time, _ in told] == pytest.approx([0.005, 0.007], abs=1e-9)
    assert "rate of slider.x by 2, the energy by 0 J" in told[0][1]
    assert "rate of slider.x by 1, the energy by 3 J" in told[1][1]


def test_a_driven_position_that_jumps_is_refused(model_of: Build) -> None:
    """Where every freedom is driven, too, by a run and by a quasi-static motion; where it goes there, it runs."""

    def door(motion: str) -> Model:
        scene = Scene("door").rigid("b", mass=1.0, inertia=0.1).revolute("h", "ground.origin", "b.origin")
        scene.prescribed_angle("drive", "ground.origin", "b.origin", motion=motion)
        return model_of(scene.simulation(t_end=0.5).build())

    jumping = door("where(t > 0.25, 1, 0)")
    for run in (jumping.simulate, jumping.quasi_static_motion):
        with pytest.raises(ModelError, match=r"drive.*jumps by 1 at t = 0.25 s.*finite time"):
            run()
    assert door("where(t > 0.25, min((t - 0.25) / 0.01, 1), 0)").simulate().status.name == "completed"
