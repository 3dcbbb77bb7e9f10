"""Geometric stiffness of finite-element bodies: against statics, exact turning beams and the rod of a slider-crank."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from numpy.testing import assert_allclose

from runtime import modes, simulate
from runtime.model import Model
from symgen.fe import FiniteElementError, FlexibleBody, LineMesh, Material, Section
from symgen.fe.inertia import stress_stiffening
from symgen.fe.static import held_solve
from symgen.scene import Scene, SceneError, SceneRecord
from tests.cases.test_beams_of_pieces import fast_slider_crank
from tests.operating.test_exact_modes import ROTATING

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord, frozenset[str]], Model]
LENGTH, Y, Z = 1.0, 0.010, 0.012
MATERIAL = Material(E=2.0e11, nu=0.0, rho=7800.0)
SECTION = Section.rectangle(Y, Z)
MASS = MATERIAL.rho * Y * Z * LENGTH


def line(elements: int = 30, **choices: object) -> FlexibleBody:
    """A cantilever of beam elements, held at `root`."""
    places = np.linspace(0.0, LENGTH, elements + 1)[:, None] * np.array([1.0, 0.0, 0.0])
    mesh = LineMesh(places, [(k, k + 1) for k in range(elements)], SECTION)
    ends = {"root": [0], "tip": [elements]}
    given = {"modes": 6, "mode_set": "mixed", "fixed": ["root"], "origin": "root", "stiffening": True} | choices
    return FlexibleBody.from_mesh(mesh, MATERIAL, interface=ends, **given)


def solid(cells: int, count: int) -> FlexibleBody:
    """The same of quadratic hexahedra, one over the section."""
    skfem = pytest.importorskip("skfem")
    sides = [np.linspace(0.0, LENGTH, cells + 1), np.array([-Y / 2, Y / 2]), np.array([-Z / 2, Z / 2])]
    return FlexibleBody.from_mesh(
        skfem.MeshHex.init_tensor(*sides),
        MATERIAL,
        interface={"root": lambda at: at[:, 0] < 1e-9, "tip": lambda at: at[:, 0] > LENGTH - 1e-9},
        modes=count,
        mode_set="mixed",
        fixed=["root"],
        origin="root",
        stiffening=True,
    )


def test_second_order_displacements_are_the_foreshortening_of_a_beam() -> None:
    """H_x = int phi'^T phi' from the root, sampled from the nodal rotations: at the tip, over the mass, times x."""
    body = line(60, modes=4)
    assert body.stiffening is not None
    turns = body.structure.nodal(body.modes.shapes, 3)  # rotations (theta_y, theta_z) = (-w', v')
    x = np.linspace(0.0, LENGTH, 61)
    products = np.einsum("kia,kib->kab", turns[:, 1:], turns[:, 1:])
    H = np.concatenate([np.zeros((1, 4, 4)), np.cumsum(0.5 * (products[1:] + products[:-1]), axis=0) / 60])
    size = np.abs(H[-1]).max()
    assert_allclose(body.stiffening.at["tip"][0], H[-1], atol=1e-3 * size)
    assert_allclose(body.stiffening.H[0], MASS * np.trapezoid(H, x, axis=0), atol=1e-3 * size * MASS)
    moment = MASS * np.trapezoid(x[:, None, None] * H, x, axis=0)
    assert_allclose(body.stiffening.xH[0, 0], moment, atol=1e-3 * size * MASS)
    assert np.abs(body.stiffening.at["root"]).max() == 0.0  # held
    assert np.abs(body.stiffening.at["tip"][1]).max() < 1e-9 * size  # a force across it pulls nothing


def test_supports_drop_out_of_balanced_loads() -> None:
    """Pulled at both ends with 1 N: int phi'^T phi', whichever end is held for the single loads, or six plain rows."""
    body = line(24, modes=3)
    parts, shapes = body.interfaces, body.modes.shapes
    turns = body.structure.nodal(shapes, 3)[:, 1:]
    middle = 0.5 * (turns[1:] + turns[:-1])
    expected = np.einsum("kia,kib->ab", middle, middle) / 24
    for held in ("root", "tip", None):
        solve = held_solve(body.structure, parts[held].rows(body.structure)) if held else body.statics.supported
        found = stress_stiffening(body.structure, shapes, body.origin, list(parts.values()), solve)
        assert_allclose(found.at["tip"][0] - found.at["root"][0], expected, atol=1e-2 * np.abs(expected).max())


def turning(body: FlexibleBody) -> SceneRecord:
    builder = Scene("turning", space="spatial").parameter("omega", 1.0, "rad/s", "speed")
    builder.flexible("beam", **body.fields()).revolute("axis", "ground.origin", "beam.root")
    return builder.prescribed_angle("drive", "ground.origin", "beam.root", motion="omega * t").build()


@pytest.mark.parametrize(
    ("made", "worst"), [(lambda: line(), 4e-3), (lambda: solid(24, 8), 5e-3)], ids=["frame", "solid"]
)
def test_a_turning_cantilever(build: Build, made: Callable[[], FlexibleBody], worst: float) -> None:
    """Exact Euler-Bernoulli frequencies out of the plane of rotation and in it; speeds in each direction's own unit."""
    wanted = frozenset({"condensed", "closure", "velocities", "residual_jacobian"})
    model = build(turning(made()), wanted)
    for speed in (2.0, 6.0):
        for height, square in ((Z, 0.0), (Y, speed**2)):
            unit = math.sqrt(MATERIAL.E / MATERIAL.rho / 12.0) * height / LENGTH**2
            found = modes(model, parameters={"omega": speed * unit}).frequencies / unit
            for exact in np.sqrt(np.array(ROTATING[speed]) ** 2 - square):
                assert np.abs(found / exact - 1.0).min() < worst


def test_column_of_elements_under_a_load(build: Build) -> None:
    """w^2 = w_0^2 (1 - P / P_cr) of a cantilever pushed at its tip: P_cr = pi^2 EI / 4 L^2 by the marker's H."""
    builder = Scene("column", space="spatial").parameter("P", 1.0, "N", "compression")
    builder.flexible("beam", **line().fields()).weld("wall", "ground.origin", "beam.root")
    builder.force("push", "beam.tip", "-P", 0.0, 0.0)
    wanted = frozenset({"condensed", "closure", "velocities", "residual_jacobian"})
    model = build(builder.build(), wanted)
    critical = math.pi**2 * MATERIAL.E * SECTION.I_z / (4 * LENGTH**2)
    stable, beyond = (modes(model, parameters={"P": share * critical}) for share in (0.99, 1.01))
    assert stable.system.modal.stable and not beyond.system.modal.stable


def test_a_body_without_it_has_none_of_its_terms() -> None:
    plain = line(stiffening=False).fields()
    assert "stiffening" not in plain and all("foreshortening" not in marker for marker in plain["markers"].values())


def test_stresses_of_matrices_are_not_known() -> None:
    body = line().structure
    with pytest.raises(FiniteElementError, match="stiffening.*the stresses of a body from matrices are not known"):
        FlexibleBody.from_matrices(
            body.K, body.M, body.positions, dofs=6, interface={"root": [1]}, modes=2, stiffening=True
        )


def test_foreshortening_of_a_marker_has_its_size() -> None:
    fields = line(modes=2).fields()
    fields["markers"]["tip"]["foreshortening"] = [[[1.0, 0.0]]] * 3
    with pytest.raises(SceneError, match=r"'beam'.markers.tip.foreshortening\[0\].*1 rows instead of 2"):
        Scene("bad", space="spatial").flexible("beam", **fields, free=True).build()


def test_rod_of_a_fast_slider_crank_from_elements(build: Build) -> None:
    """The case of tests/cases/test_beams_of_pieces.py with a meshed rod, up to its largest deflection near 4 ms.

    With the stiffness of its stresses the deflection is that of a beam with the same two free modes, without it a sixth
    more. The section is widened across the plane, E and rho in proportion less, so that these are the lowest modes.
    """
    share = 0.007 / 0.03
    n = 16
    places = np.linspace(0.0, 0.3, n + 1)[:, None] * np.array([1.0, 0.0, 0.0])
    body = FlexibleBody.from_mesh(
        LineMesh(places, [(k, k + 1) for k in range(n)], Section.rectangle(0.006, 0.03)),
        Material(E=2e11 * share, nu=0.3, rho=7870.0 * share),
        interface={"big": [0], "middle": [n // 2], "small": [n]}, modes=2, origin="big", stiffening=True,
    )  # fmt: skip
    along = {"position": (0.0, 0.0, 0.0), "axis": (1.0, 0.0, 0.0)}
    builder = Scene("fast", space="spatial").ground(markers={"rail": along})
    builder.rigid("crank", mass=0.36, inertia=(1e-3, 1e-2, 1e-2), markers={"tip": {"position": (0.15, 0.0, 0.0)}})
    builder.flexible("rod", **body.fields())
    builder.rigid("slider", mass=7870.0 * 42e-6 * 0.15, inertia=(1e-5, 1e-5, 1e-5), markers={"rail": along})
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.big")
    builder.prismatic("slide", "ground.rail", "slider.rail").spherical("C", "rod.small", "slider.origin")
    for name, marker in (("a", "rod.big"), ("b", "rod.small"), ("m", "rod.middle")):
        builder.measure(f"{name}_x", "x", of=marker).measure(f"{name}_y", "y", of=marker)
    builder.initial({"A.angle": 0.0, "B.angle": 0.0, "slide.travel": 0.45}).rates({"A.angle": 150.0})
    needed = "condensed closure velocities accelerations constraints reactions energy measures"
    model = build(builder.build(), frozenset(needed.split()))
    without = {entry.name: 0.0 for entry in model.parameters if ".H[" in entry.array or ".xH[" in entry.array}

    def deflection(of: Model, parameters: dict[str, float]) -> float:
        run = simulate(
            of, scheme="rk4", dt=1e-5, t_end=0.005, seen_every=0.0005, parameters=parameters, engine="interpreted"
        )
        a, b, m = (np.column_stack([run[f"{name}_x"], run[f"{name}_y"]]) for name in "abm")
        chord, arm = b - a, m - a
        return float(np.abs((chord[:, 0] * arm[:, 1] - chord[:, 1] * arm[:, 0]) / np.hypot(*chord.T)).max())

    free = fast_slider_crank(1, 2).to_dict()
    rod = next(body for body in free["bodies"] if body["name"] == "rod0")
    rod["lateral"] = {"ends": "free-free", "modes": 2}
    same = build(SceneRecord.from_dict(free), frozenset(needed.split()))
    found = deflection(model, {})
    assert found == pytest.approx(deflection(same, {}), rel=1e-4)
    assert found == pytest.approx(3.155e-3, rel=0.03)  # what two free modes are good for
    assert without and deflection(model, without) == pytest.approx(3.73e-3, rel=0.03)
