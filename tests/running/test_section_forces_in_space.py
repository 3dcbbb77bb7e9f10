"""Section forces of beams in space against textbooks, and against the joints that hold a moving beam."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import Solution, simulate
from runtime.contract.coordinates import independent
from runtime.model import Model
from runtime.results.body_motion import frame_motion
from symgen.scene import Scene, SceneRecord
from tests.hand_derived.spatial.twin_spatial import euler_A
from tests.support.spatial_motion import frames

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
L, AT = 2.0, (0.0, 0.3, 0.8)
X = L * np.array(AT)
SIZE = {"length": L, "density": 1000.0, "area": 3e-3}
STIFF: dict[str, Any] = {
    **SIZE, "second_moment": 1.0, "second_moment_z": 0.5, "youngs_modulus": 1e11, "shear_modulus": 4e10,
    "torsion_constant": 1.0, "torsion": {"modes": 1}, "lateral": {"modes": 2}, "lateral_z": {"modes": 2},
}  # fmt: skip
TURNED = euler_A("zyx", np.array([0.3, 0.5, -0.8]))
NAMES = ("normal", "shear", "shear_z", "torsion", "moment_y", "moment")
KINDS = ("normal_force", "shear_force", "shear_force_z", "torsion_moment", "bending_moment_y", "bending_moment")


def test_cantilever_in_any_direction(model_of: Build) -> None:
    """Force (7, -3, 4) and moment (2, 5, -6) at the tip, along the beam's axes, both ways; and as measures.

    N = 7, Q = (-3, 4), T = 2, M_y = 5 - 4 (L - x), M_z = -6 - 3 (L - x).
    """
    axes = {f"about_{axis}": {"at": 1.0, "axis": np.eye(3)[k]} for k, axis in enumerate("xyz")}
    builder = Scene("cantilever", space="spatial")
    builder.ground(markers={"wall": {"axis": TURNED[:, 2], "x_axis": TURNED[:, 0]}})
    builder.beam("b", **STIFF, axial={"modes": 1}, markers={**axes, "m": {"at": AT[1]}})
    builder.weld("wall", "ground.wall", "b.start").force("tip", "b.end", 7.0, -3.0, 4.0, frame="body")
    for axis, moment in zip("xyz", (2.0, 5.0, -6.0), strict=True):
        builder.torque(f"turn_{axis}", f"b.about_{axis}", moment)
    for name, kind in zip(NAMES, KINDS, strict=True):
        builder.measure(name, kind, "b.m")
    run = simulate(model_of(builder.build()), scheme="rk4", dt=1e-9, t_end=2e-9, start="quasi_static")
    expected = dict(zip(NAMES, (7.0, -3.0, 4.0, 2.0, 5.0 - 4.0 * (L - X), -6.0 - 3.0 * (L - X)), strict=True))
    for way in ("equilibrium", "modes"):
        found = run.section_forces("b", AT, way)  # type: ignore[arg-type]
        for name, value in expected.items():
            np.testing.assert_allclose(getattr(found, name)[0], np.broadcast_to(value, 3), rtol=1e-6, err_msg=name)
    for name in NAMES:
        np.testing.assert_allclose(run[name][0], np.broadcast_to(expected[name], 3)[1], rtol=1e-6)
    units = [measure.unit for measure in run.model.description.measures if not measure.name.endswith("_dot")]
    assert units == ["N"] * 3 + ["N m"] * 3
    largest = run.section_forces("b").largest("moment_y")
    assert largest.at == 1.0 and largest.value == pytest.approx(5.0, rel=1e-6)


def turning(model_of: Build, axis: tuple[float, ...], motion: str) -> Solution:
    builder = Scene("turning", space="spatial").ground(markers={"axle": {"axis": axis}})
    builder.beam("b", **STIFF, markers={"axle": {"at": 0.0, "axis": axis}}, stiffening=True)
    builder.revolute("axle", "ground.axle", "b.axle").prescribed_angle("drive", "ground.axle", "b.axle", motion=motion)
    return simulate(model_of(builder.build()), scheme="rk4", dt=1e-7, t_end=2e-7, start="quasi_static")


def test_turning_beams(model_of: Build) -> None:
    """About z: N = rho A w^2 (L^2 - x^2) / 2, M_z of the load -rho A alpha x. About x: T = -rho I_p alpha (L - x)."""
    run = turning(model_of, (0.0, 0.0, 1.0), "5.0 * t + 2.0 * t ** 2").section_forces("b", AT)
    rho_a = SIZE["density"] * SIZE["area"]
    np.testing.assert_allclose(run.normal[0], rho_a * 25.0 * (L**2 - X**2) / 2, rtol=1e-6)
    expected = -rho_a * 4.0 * ((L**3 - X**3) / 3 - X * (L**2 - X**2) / 2)
    # the sections of this thick beam turn with its frame, which is what its own inertia adds
    np.testing.assert_allclose(run.moment[0], expected - SIZE["density"] * 1.0 * 4.0 * (L - X), rtol=1e-5)
    run = turning(model_of, (1.0, 0.0, 0.0), "5.0 * t + 2.0 * t ** 2").section_forces("b", AT)
    np.testing.assert_allclose(run.torsion[0], -SIZE["density"] * 1.5 * 4.0 * (L - X), rtol=1e-5)


def test_a_moving_beam_balances_its_joints(model_of: Build) -> None:
    """At the start of the beam the balance of all that is beyond is what the hinge does, at its end what is welded on.

    A soft beam on a skew hinge with an offset mass at its tip, a spring and friction; joint forces are another way.
    """
    builder = Scene("hanging", space="spatial").gravity(0.4, -1.1, -9.81)
    axle = {"axis": TURNED[:, 2], "x_axis": TURNED[:, 0]}
    builder.ground(markers={"axle": axle, "far": {"position": (1.0, 1.0, 1.0)}})
    soft = {
        **STIFF, "second_moment": 2e-8, "second_moment_z": 1e-8, "torsion_constant": 1e-8,
        "lateral": {"ends": "welded-pinned", "modes": 1}, "lateral_z": {"ends": "welded-pinned", "modes": 1},
        "stiffening": True, "markers": {"middle": {"at": 0.5}},
    }  # fmt: skip
    builder.beam("b", **soft).rigid("tip", mass=1.0, inertia=[0.1, 0.1, 0.1], center_of_mass=(0.1, 0.2, -0.1))
    builder.revolute("axle", "ground.axle", "b.start", damping=0.3).weld("end", "b.end", "tip.origin")
    builder.spring_damper("spring", "ground.far", "b.middle", stiffness=50.0, damping=1.0)
    scene = builder.build()
    run = simulate(model_of(scene), scheme="rk4", dt=2e-4, t_end=0.1, seen_every=0.02, start="quasi_static")
    found = run.section_forces("b", (0.0, 1.0))
    assert np.abs(run["b.q1"]).max() > 1e-3 and np.abs(run["b.q3"]).max() > 1e-3
    for sample in range(1, len(run.t)):
        frame = frames(scene, run.q[sample], run.q_dot[sample], run.q_ddot[sample])["b"]
        on_beam, on_tip = (run.joint_force(name)[sample].reshape(2, 3) @ frame.A for name in ("axle", "end"))
        friction = np.array([0.0, 0.0, 0.3 * (frame.A.T @ frame.omega)[2]])
        here = np.array([getattr(found, name)[sample] for name in NAMES]).T.reshape(2, 2, 3)
        size = np.abs(here).max(axis=(0, 2))
        assert np.abs(here[0, 0] + on_beam[0]).max() < 1e-6 * size[0]
        assert np.abs(here[0, 1] + on_beam[1] - friction).max() < 1e-5 * size[1]
        assert abs(np.linalg.norm(here[1, 0]) - np.linalg.norm(on_tip[0])) < 1e-9 * size[0]


def test_motion_of_a_frame() -> None:
    """Rates of A: A' = A omega~ by a complex step along the motion, alpha by differences of omega."""
    rng = np.random.default_rng(3)
    theta, rate, second = rng.normal(size=(3, 1, 4))
    theta /= np.linalg.norm(theta)
    rate -= theta * (theta @ rate.T)
    second -= theta * (theta @ second.T + rate @ rate.T)
    here, h = frame_motion(theta, rate, second), 1e-5
    near = [frame_motion(theta + s * rate + s**2 / 2 * second, rate + s * second, second) for s in (h, -h)]
    A_dot, alpha = (near[0].A - near[1].A)[0] / (2 * h), (near[0].omega - near[1].omega)[0] / (2 * h)
    spin = here.A[0].T @ A_dot
    np.testing.assert_allclose([spin[2, 1], spin[0, 2], spin[1, 0]], here.omega[0], atol=1e-8)
    np.testing.assert_allclose(alpha, here.alpha[0], atol=1e-8)
    moment = rng.normal(size=(1, 3))
    np.testing.assert_allclose(here.moment((here.W[0].T @ moment[0])[None]), moment, rtol=1e-12)


def test_sections_of_a_beam_in_space_turn_with_it(model_of: Build) -> None:
    """Inertia about the ends of a thick beam: rho A L^3 / 3 + rho I L, about z with I_z and about y with I_y."""
    rho, A, L, section = 1000.0, 0.04, 0.5, (3e-4, 7e-4)
    for axis, own in (((0.0, 0.0, 1.0), section[0]), ((0.0, 1.0, 0.0), section[1])):
        place = {"axis": axis}
        builder = Scene("thick", space="spatial").ground(markers={"pin": place})
        builder.beam(
            "beam",
            length=L,
            density=rho,
            area=A,
            second_moment=section[0],
            second_moment_z=section[1],
            youngs_modulus=1e9,
            lateral={"ends": "clamped-free", "modes": 1},
            markers={"pin": {"at": 0.0, **place}},
        )
        model = model_of(builder.revolute("pin", "ground.pin", "beam.pin").build())
        k, c = model.q_i.index("pin.angle"), model.constants(model.parameter_vector())
        q, still = model.initial_q, np.zeros(len(model.coordinates))
        d, (q_i, q_i_dot) = model.dependent_columns, independent(model, q, still)
        at = {"q_i": q_i, "q_d": q[d], "q_i_dot": q_i_dot, "q_d_dot": still[d]}
        found = float(np.asarray(model.evaluate("condensed", **at, t=0.0, c=c)["M_hat"])[k, k])
        assert found == pytest.approx(rho * A * L**3 / 3 + rho * own * L, rel=3e-3), axis
