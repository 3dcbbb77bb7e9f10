"""Torsion of beams in space: an L-shaped cantilever against its exact deflection and finite elements; bars under
tension and in rotation against closed forms; what the ends of a beam ask for."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.linalg import eigh

from runtime import equilibrium, modes
from runtime.model import Model
from symgen.fe import LineMesh, Material, Section
from symgen.fe.frame import frame_structure
from symgen.scene import BeamBody, Scene, SceneError, SceneRecord, with_ends

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord, frozenset[str]], Model]
KERNELS = frozenset({"condensed", "closure", "velocities", "residual_jacobian"})
ALUMINIUM = Material(E=7e10, nu=0.3, rho=2700.0)
ARMS, SIDES = (0.4, 0.3), (0.02, 0.03)  # along y and z of the section
SECTION = Section.rectangle(*SIDES)
FIELDS = {
    "density": ALUMINIUM.rho, "area": SECTION.area, "youngs_modulus": ALUMINIUM.E, "shear_modulus": ALUMINIUM.G,
    "second_moment": SECTION.I_z, "second_moment_z": SECTION.I_y, "torsion_constant": SECTION.torsion,
}  # fmt: skip


def l_shape(count: int) -> SceneRecord:
    """Arms along x and y, clamped at the start, a force F along z at the end."""
    sets = {"lateral": {"modes": count}, "lateral_z": {"modes": count}, "torsion": {"modes": count - 1}}
    builder = Scene("angle", space="spatial").parameter("F", 100.0, "N", "load across the plane")
    corner = {"at": 1.0, "x_axis": (0.0, 1.0, 0.0)}
    builder.beam("one", length=ARMS[0], **FIELDS, **sets, markers={"corner": corner})
    builder.beam("two", length=ARMS[1], **FIELDS, **sets)
    builder.weld("root", "ground.origin", "one.start").weld("corner", "one.corner", "two.start")
    builder.force("load", "two.end", 0.0, 0.0, "F").measure("z", "z", of="two.end")
    return builder.build()


def exact_l_shape(elements: int) -> np.ndarray:
    """Frequencies of frame elements along both arms, the first node held."""
    steps = np.linspace(0.0, 1.0, elements + 1)
    one = np.outer(ARMS[0] * steps, [1.0, 0.0, 0.0])
    two = one[-1] + np.outer(ARMS[1] * steps[1:], [0.0, 1.0, 0.0])
    lines = [(k, k + 1) for k in range(2 * elements)]
    along_x, along_y = SECTION, Section.rectangle(*SIDES, y_axis=(-1.0, 0.0, 0.0))
    mesh = LineMesh(np.vstack([one, two]), lines, [along_x] * elements + [along_y] * elements)
    body = frame_structure(mesh, ALUMINIUM)
    K, M = (matrix.toarray()[6:, 6:] for matrix in (body.K, body.M))
    return np.sqrt(eigh(K, M, eigvals_only=True, subset_by_index=(0, 4)))


def test_an_l_shaped_cantilever_bends_and_twists(build: Build) -> None:
    """Static: F (a^3 + b^3) / (3 E I_y) + F b^2 a / (G J). Five frequencies, in the plane and across it, to 0.5 %."""
    model = build(l_shape(3), KERNELS | {"measures"})
    (a, b), F = ARMS, 1e-2  # small: turns of the corner stay linear
    bent, twisted = (a**3 + b**3) / (3 * ALUMINIUM.E * SECTION.I_y), b**2 * a / (ALUMINIUM.G * SECTION.torsion)
    rest = equilibrium(model, parameters={"F": F})
    c = model.constants(model.parameter_vector())
    out = np.asarray(model.evaluate("measures", q=rest.q, q_dot=rest.q_dot, t=0.0, c=c)["measures"]).ravel()
    assert out[0] == pytest.approx(F * (bent + twisted), rel=1e-6)
    np.testing.assert_allclose(modes(model, rest).frequencies[:5], exact_l_shape(24), rtol=5e-3)


def bar(**fields: object) -> Scene:
    """A stiff bar with torsion only, free to twist at its end."""
    builder = Scene("bar", space="spatial")
    torsion = {"torsion": {"ends": "fixed-free", "modes": 2}}
    return builder.beam("bar", length=ARMS[0], **{**FIELDS, **torsion, **fields})


def torsional(share: float) -> np.ndarray:
    """(k - 1/2) pi / L sqrt(G J / (rho I_p)) with G J times `share`, squared."""
    numbers = (np.arange(1, 3) - 0.5) * math.pi / ARMS[0]
    polar = ALUMINIUM.rho * (SECTION.I_y + SECTION.I_z)
    return np.asarray(numbers**2 * ALUMINIUM.G * SECTION.torsion * share / polar)


def test_torsion_under_tension(build: Build) -> None:
    """Stiffening: an axial force P straightens twisted fibres, G J + P I_p / A."""
    builder = bar(stiffening=True, lateral={"modes": 1}).parameter("P", 1.0, "N", "tension")
    builder.weld("root", "ground.origin", "bar.start").force("pull", "bar.end", "P", 0.0, 0.0)
    model = build(builder.build(), KERNELS)
    stiffer = 0.5 * ALUMINIUM.G * SECTION.torsion
    P = stiffer * SECTION.area / (SECTION.I_y + SECTION.I_z)
    for tension, share in ((0.0, 1.0), (P, 1.5), (-P, 0.5)):
        found = modes(model, parameters={"P": tension}).frequencies ** 2
        for expected in torsional(share):
            assert np.abs(found / expected - 1).min() < 1e-9


def test_torsion_in_rotation(build: Build) -> None:
    """The section's longer side turns into the plane of rotation: w^2 + Omega^2 (int y^2 - int z^2) / I_p about z."""
    turning = bar().parameter("omega", 1.0, "rad/s", "speed").revolute("axle", "ground.origin", "bar.start")
    turning.prescribed_angle("drive", "ground.origin", "bar.start", motion="omega * t")
    speed, model = 1e4, build(turning.build(), KERNELS)
    shift = speed**2 * (SECTION.I_z - SECTION.I_y) / (SECTION.I_z + SECTION.I_y)
    found = modes(model, parameters={"omega": speed}).frequencies ** 2
    np.testing.assert_allclose(found, torsional(1.0) + shift, rtol=1e-9)
    assert abs(shift) > 0.2 * torsional(1.0)[0]


@pytest.mark.parametrize(
    ("joint", "marker", "expected"),
    [
        ("weld", "start", "fixed-free"),
        ("revolute", "along", "free-free"),  # a hinge about the beam's line passes on no torque
        ("revolute", "start", "fixed-free"),
        ("spherical", "start", "free-free"),
        ("weld", "end", "free-fixed"),
    ],
)
def test_ends_of_torsion_by_what_is_attached(joint: str, marker: str, expected: str) -> None:
    builder = bar(torsion={"modes": 1}, markers={"along": {"at": 0.0, "axis": (1.0, 0.0, 0.0)}})
    builder.ground(markers={"along": {"axis": (1.0, 0.0, 0.0)}})
    ground = "along" if marker == "along" else "origin"
    body = with_ends(builder.joint(joint, "j", f"ground.{ground}", f"bar.{marker}").build()).body("bar")
    assert isinstance(body, BeamBody) and body.torsion is not None and body.torsion.ends == expected
    if (joint, marker) == ("weld", "start"):
        loaded = with_ends(builder.rigid("tip", mass=1.0, inertia=[1, 1, 1]).weld("w", "bar.end", "tip.origin").build())
        assert loaded.body("bar").torsion.ends == "fixed-loaded"  # type: ignore[union-attr]


def test_what_torsion_needs() -> None:
    with pytest.raises(SceneError, match=r"'bar'.shear_modulus.*is missing, which torsion needs"):
        bar(shear_modulus=0.0).weld("root", "ground.origin", "bar.start").build()
    planar = Scene("flat").beam(
        "bar", length=1.0, density=1.0, area=1.0, second_moment=1.0, youngs_modulus=1.0, torsion={"modes": 1}
    )
    with pytest.raises(SceneError, match=r"'bar'.torsion.*a planar beam does not twist"):
        planar.weld("root", "ground.origin", "bar.start").build()
