"""Section forces of frames by equilibrium: an L under weight and loads, a turning beam, free vibrations."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from runtime import Solution, simulate
from runtime.contract.flexible import BodyMotion, MarkerForce
from symgen.fe import FiniteElementError, FlexibleBody, LineMesh, Material, Section
from symgen.fe.frame import FrameElements
from symgen.generate import model_of
from symgen.scene import Scene
from tests.fe.test_mode_acceleration import bar

pytestmark = pytest.mark.long

A_SIDE, B_SIDE, WIDE, HIGH = 0.4, 0.3, 0.02, 0.01
MATERIAL = Material(E=2.0e11, nu=0.3, rho=7800.0)
LINE_MASS = MATERIAL.rho * WIDE * HIGH
EIGHTH = np.arange(9) / 8


def crank(modes: int, **choices: object) -> FlexibleBody:
    """An L in the xy-plane: 0.4 m along x from the root, then 0.3 m along y to the tip, eight lines each."""
    first = [(A_SIDE * s, 0.0, 0.0) for s in EIGHTH]
    second = [(A_SIDE, B_SIDE * s, 0.0) for s in EIGHTH[1:]]
    section = Section.rectangle(WIDE, HIGH, y_axis=(1.0, -1.0, 0.0))  # in the plane, on either side
    mesh = LineMesh([*first, *second], [(k, k + 1) for k in range(16)], section)
    given = {"mode_set": "mixed", "fixed": ["root"], "origin": "root"} | choices
    return FlexibleBody.from_mesh(mesh, MATERIAL, interface={"root": [0], "tip": [16]}, modes=modes, **given)


def test_an_l_frame_under_its_weight_and_a_load() -> None:
    """At the start of each line: the statics of all that is beyond, with two modes that hold little of it."""
    body, g, load = crank(2), 0.01, np.array([3e-3, -2e-3, 5e-3])
    builder = Scene("crank", space="spatial").gravity(0.0, 0.0, -g).flexible("frame", **body.fields())
    builder.weld("wall", "ground.origin", "frame.root").force("pull", "frame.tip", *load.tolist())
    run = simulate(model_of(builder.build()), scheme="rk4", dt=1e-9, t_end=1e-9, start="quasi_static")
    found = body.section_forces().of(run.body_motion("frame")).values[0]
    tip, corner, weight = np.array([A_SIDE, B_SIDE, 0.0]), np.array([A_SIDE, 0.0, 0.0]), np.array([0.0, 0.0, -g])
    for line in range(16):
        for end in (0, 1):
            s = (line % 8 + end) / 8
            at = np.array([A_SIDE * s, 0, 0]) if line < 8 else np.array([A_SIDE, B_SIDE * s, 0])
            force, moment = load.copy(), np.cross(tip - at, load)
            parts = [(at, corner), (corner, tip)] if line < 8 else [(at, tip)]
            for start, stop in parts:
                pushed = LINE_MASS * np.linalg.norm(stop - start) * weight
                force, moment = force + pushed, moment + np.cross((start + stop) / 2 - at, pushed)
            # lines along x have y along -y of the mesh, then z = x cross y down; lines along y have y along x
            axes = (
                np.array([[1, 0, 0], [0, -1, 0], [0, 0, -1]])
                if line < 8
                else np.array([[0, 1, 0], [1, 0, 0], [0, 0, -1]])
            )
            expected = np.concatenate([axes @ force, axes @ moment])
            assert_allclose(found[line, end], expected, atol=2e-6 * np.abs(load).max())


def turning(body: FlexibleBody, motion: str, dt: float, t_end: float) -> Solution:
    builder = Scene("arm", space="spatial").flexible("frame", **body.fields())
    builder.revolute("axle", "ground.origin", "frame.root")
    builder.prescribed_angle("drive", "ground.origin", "frame.root", motion=motion)
    every = max(1, round(t_end / dt / 20))
    return simulate(
        model_of(builder.build()), scheme="rk4", dt=dt, t_end=t_end, start="quasi_static", seen_every=every * dt
    )


def test_a_turning_and_a_twisted_beam() -> None:
    """About z: N = rho A w^2 (L^2 - x^2) / 2 and M of the load -rho A alpha x; about x: T = -rho I_p alpha (L - x)."""
    x = A_SIDE * EIGHTH
    mesh = LineMesh([(at, 0.0, 0.0) for at in x], [(k, k + 1) for k in range(8)], Section.rectangle(WIDE, HIGH))
    beam = FlexibleBody.from_mesh(
        mesh, MATERIAL, interface={"root": [0]}, modes=1, mode_set="mixed", fixed=["root"], origin="root"
    )
    run = turning(beam, "30.0 * t + 0.5 * t ** 2", 1e-9, 1e-9)
    forces = beam.section_forces().of(run.body_motion("frame"))
    normal = LINE_MASS * 30.0**2 / 2 * (A_SIDE**2 - x**2)
    bending = -LINE_MASS * ((A_SIDE**3 - x**3) / 3 - x * (A_SIDE**2 - x**2) / 2)
    for values, expected in ((forces.part("normal"), normal), (forces.part("moment"), bending)):
        assert_allclose(values[0, :, 0], expected[:-1], atol=1e-6 * np.abs(expected).max())
        assert_allclose(values[0, :, 1], expected[1:], atol=1e-6 * np.abs(expected).max())
    assert forces.largest("normal").line == 0 and forces.largest("normal").value == pytest.approx(normal[0], rel=1e-6)
    N, still = 1, np.zeros((1, 3))
    alpha = np.array([[5.0, 0.0, 0.0]])
    motion = BodyMotion("frame", np.zeros(N), *np.zeros((3, N, 1)), still, still, alpha)
    polar = MATERIAL.rho * WIDE * HIGH * (WIDE**2 + HIGH**2) / 12
    held = MarkerForce("root", np.zeros(3), np.array([[0, 0, 0, polar * A_SIDE * 5.0, 0, 0]]))
    motion.forces.append(held)
    twisted = beam.section_forces().of(motion).part("torsion")
    assert_allclose(twisted[0, :, 0], -polar * 5.0 * (A_SIDE - x[:-1]), rtol=1e-9)


def test_a_free_vibration_is_held_by_its_own_inertia() -> None:
    """q'' = -omega^2 q of free modes: the forces are those of K phi - omega^2 M phi, zero at the tip.

    The sum of modal forces leaves out the inertia between the nodes.
    """
    body = crank(6, mode_set="free", fixed=[])
    q, still = np.eye(6), np.zeros((6, 3))
    motion = BodyMotion("frame", np.arange(6.0), q, 0 * q, -q * body.modes.eigenvalues, still, still, still)
    forces, beams = body.section_forces(), body.structure.stress
    assert isinstance(beams, FrameElements)
    shapes = body.modes.shapes
    expected = beams.ends(shapes, -(shapes * body.modes.eigenvalues)[beams.dofs])
    found, modal = forces.of(motion).values, forces.of_modes(q, motion.t).values
    for mode in range(6):
        size = np.abs(expected[mode]).max(axis=(0, 1))
        scale = np.repeat([size[:3].max(), size[3:].max()], 3)
        assert np.abs((found - expected)[mode] / scale).max() < 1e-6
        assert np.abs(found[mode, -1, 1] / scale).max() < 1e-6 < 0.1 < np.abs((modal - expected)[mode] / scale).max()
    assert np.abs(expected[..., 3]).max() > 0.01 * np.abs(expected[..., 5]).max()  # some of them twist


def test_what_does_not_fit_is_named() -> None:
    forces = crank(2).section_forces()
    still = np.zeros((1, 3))
    pin = MarkerForce("pin", np.ones(3), np.zeros((1, 6)))
    for modes, acting, problem in ((1, [], "frame has 1 modes, not 2"), (2, [pin], "marker 'pin'.*not an interface")):
        with pytest.raises(FiniteElementError, match=problem):
            forces.of(BodyMotion("frame", np.zeros(1), *np.zeros((3, 1, modes)), still, still, still, acting))
    with pytest.raises(FiniteElementError, match="which.*'bending' is not known"):
        forces.of_modes(np.zeros((1, 2))).largest("bending")  # type: ignore[arg-type]
    with pytest.raises(FiniteElementError, match="the body is not a frame"):
        bar(1, cells=2).section_forces()
