"""Stress at places of solids: a fillet, a hole, NAFEMS LE1 and LE10, Lame's cylinder, and places outside."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import scipy.sparse.linalg as spla
from numpy.testing import assert_allclose

from runtime import ensemble, simulate
from symgen.fe import STEEL, FiniteElementError, FiniteElementWarning, FlexibleBody
from symgen.fe.stresses import error_rows, solid_structure
from symgen.generate import model_of
from symgen.scene import Scene

skfem = pytest.importorskip("skfem")
Array = np.ndarray
Map = Callable[[Array], Array]


def block(cells: tuple[int, int, int], shape: Map, curved: bool = True) -> Any:
    """Hexahedra of the unit cube, moved by `shape` (3, n) -> (3, n); with curved edges or straight ones."""
    mesh = skfem.MeshHex.init_tensor(*(np.linspace(0.0, 1.0, n + 1) for n in cells))
    mesh = skfem.MeshHex2.from_mesh(mesh) if curved else mesh
    return type(mesh)(shape(mesh.doflocs.copy()), mesh.t)


def statics(
    mesh: Any, fix: Map, loads: list[tuple[Map, Callable[[Array, Array], tuple[Any, ...]]]], order: int = 2
) -> Any:
    """(structure, displacements (n_dof,)) of STEEL; fix (3, n) -> (3, n) of bool; loads: faces and their tractions."""
    body = solid_structure(mesh, STEEL, order)
    basis, force = body.stress.basis, np.zeros(body.n_dof)
    for on, traction in loads:
        face = skfem.FacetBasis(mesh, basis.elem, facets=mesh.facets_satisfying(on, boundaries_only=True), intorder=6)
        for c in range(3):
            force[c::3] += skfem.LinearForm(lambda v, w, c=c, t=traction: v * t(w.x, w.n)[c]).assemble(face)
    free = np.flatnonzero(~fix(body.positions.T).T.ravel())
    u = np.zeros(body.n_dof)
    u[free] = spla.spsolve(body.K.tocsc()[free][:, free], force[free])
    return body, u


def at(body: Any, u: Array, places: Any) -> tuple[Array, Array]:
    """Components (m, 6) and error of the mesh (m,) [Pa]."""
    wanted = np.atleast_2d(np.asarray(places, dtype=float))
    found = body.stress.recovery.at(wanted, [f"at[{k}]" for k in range(len(wanted))], np.zeros(3))
    around = body.stress.of_elements(found.elements)
    errors = [float(np.linalg.norm(rows)) for rows in error_rows(around, u[:, None], found)]
    return (around.components(u[:, None])[0] @ found.values.T).T, np.array(errors)


def on_axes(x: Array) -> Array:
    """Held across the planes x = 0, y = 0 and z = 0."""
    return np.abs(x) < 1e-9


def quarter(inner: tuple[float, float], outer: tuple[float, float], thick: float) -> Map:
    """A quarter between two ellipses by their half axes."""

    def shape(p: Array) -> Array:
        c, s = np.cos(p[1] * np.pi / 2), np.sin(p[1] * np.pi / 2)
        x, y = (np.outer([inner[k]], 1 - p[0])[0] + outer[k] * p[0] for k in range(2))
        return np.array([x * c, y * s, thick * p[2]])

    return shape


@pytest.mark.parametrize("order, bound", [(2, 0.02), (1, 0.1)])
def test_a_pressed_cylinder(order: int, bound: float) -> None:
    """Lame: hoop stress p (b^2 / r^2 + 1) a^2 / (b^2 - a^2), at the bore 5/3 p for b = 2 a; plane strain."""
    mesh = block((4, 6, 1), quarter((1.0, 1.0), (2.0, 2.0), 0.3))
    body, u = statics(
        mesh,
        lambda x: np.array([x[0] < 1e-9, x[1] < 1e-9, (x[2] < 1e-9) | (x[2] > 0.3 - 1e-9)]),
        [(lambda x: np.hypot(x[0], x[1]) < 1.04, lambda x, n: (-1e6 * n[0], -1e6 * n[1], 0 * n[0]))],
        order,
    )
    radii = np.array([1.0, 1.03, 1.1, 1.3, 1.7, 2.0])
    turns = np.array([0.0, 0.31, 0.5, 0.8, 1.2, np.pi / 2])
    places = np.stack([radii * np.cos(turns), radii * np.sin(turns), np.full(6, 0.13)], axis=1)
    found, errors = at(body, u, places)
    hoop = 1e6 * (1 + 4 / radii**2) / 3
    c, s = np.cos(turns), np.sin(turns)
    assert_allclose(found[:, 0] * s**2 + found[:, 1] * c**2 - 2 * found[:, 5] * c * s, hoop, atol=bound * 5e6 / 3)
    assert np.all(errors < 4 * bound * 5e6 / 3) and errors[0] > errors[-1]


def test_nafems_le1() -> None:
    """An elliptic membrane, 10 MPa outwards at its rim: sigma_yy at the inner end of the long axis is 92.7 MPa."""
    mesh = block((4, 6, 1), quarter((2.0, 1.0), (3.25, 2.75), 0.02))
    rim = lambda x: (x[0] / 3.25) ** 2 + (x[1] / 2.75) ** 2 > 0.97  # noqa: E731
    body, u = statics(mesh, on_axes, [(rim, lambda x, n: (1e7 * n[0], 1e7 * n[1], 0 * n[0]))])
    found, errors = at(body, u, [2.0, 0.0, 0.01])
    assert found[0, 1] == pytest.approx(92.7e6, rel=0.02)
    assert abs(found[0, 1] - 92.7e6) < 2 * errors[0] < 12e6


@pytest.mark.long
def test_nafems_le10() -> None:
    """A thick elliptic plate under 1 MPa: sigma_yy on top of the inner end of the long axis is -5.38 MPa."""
    mesh = block((6, 8, 4), quarter((2.0, 1.0), (3.25, 2.75), 0.6))

    def fix(x: Array) -> Array:
        rim = np.abs((x[0] / 3.25) ** 2 + (x[1] / 2.75) ** 2 - 1) < 1e-3
        return np.array([(x[0] < 1e-9) | rim, (x[1] < 1e-9) | rim, rim & (np.abs(x[2] - 0.3) < 1e-9)])

    body, u = statics(mesh, fix, [(lambda x: x[2] > 0.6 - 1e-9, lambda x, n: (0 * x[0], 0 * x[0], 0 * x[0] - 1e6))])
    found, errors = at(body, u, [2.0, 0.0, 0.6])
    assert found[0, 1] == pytest.approx(-5.38e6, rel=0.03)
    assert abs(found[0, 1] + 5.38e6) < 2 * errors[0] < 2e6


def test_a_hole_in_a_strip() -> None:
    """Kirsch, for a strip of finite width by Heywood: K = 2 + (1 - d / w)^3 of the mean stress beside the hole."""
    radius, width, length = 0.01, 0.05, 0.1  # half of the strip

    def shape(p: Array) -> Array:
        r, s = p[0] ** 1.7, p[1]
        inner = radius * np.array([np.cos(s * np.pi / 2), np.sin(s * np.pi / 2)])
        rim = np.array([np.where(s <= 0.5, width, 2 * width * (1 - s)), np.where(s <= 0.5, 2 * length * s, length)])
        return np.array([*(inner + r * (rim - inner)), 0.002 * p[2]])

    pull = (lambda x: x[1] > length - 1e-9, lambda x, n: (0 * x[0], 0 * x[0] + 1e6, 0 * x[0]))
    body, u = statics(block((8, 10, 1), shape), on_axes, [pull])
    found, errors = at(body, u, [radius, 0.0, 0.001])
    heywood = (2 + (1 - radius / width) ** 3) / (1 - radius / width) * 1e6
    assert found[0, 1] == pytest.approx(heywood, rel=0.03)
    assert abs(found[0, 1] - heywood) < 2 * errors[0] < 0.5e6


def half(x: float) -> float:
    """Half of the width of the bar with a fillet: 20 mm, a quarter of an ellipse, 8 mm."""
    u = (0.040 - x) / 0.006
    return 0.020 if x <= 0.034 else 0.008 if x >= 0.040 else 0.008 + 0.012 * (1 - np.sqrt(max(0, 1 - u * u)))


def fillet_bar() -> FlexibleBody:
    along = np.r_[np.linspace(0, 0.03, 7)[:-1], np.linspace(0.03, 0.046, 13)[:-1], np.linspace(0.046, 0.15, 14)]
    mesh = skfem.MeshHex.init_tensor(along, np.linspace(-1, 1, 9), np.linspace(0, 0.008, 3))
    p = mesh.p.copy()
    p[1] *= np.array([half(x) for x in p[0]])
    ends = {"root": lambda at: at[:, 0] < 1e-9, "tip": lambda at: at[:, 0] > 0.15 - 1e-9}
    return FlexibleBody.from_mesh(
        skfem.MeshHex(p, mesh.t), STEEL, modes=3, mode_set="mixed", fixed=["root"], origin="root", interface=ends
    )


@pytest.mark.long
def test_a_bar_with_a_fillet() -> None:
    """41.6 MPa on the face and 44.05 half way through of a converged mesh; 14.465 in the shaft by beam theory.

    As gauges of a run, with the error of the mesh beside; what the gauges hold is what the mesh says.
    """
    body = fillet_bar()
    places = {"face": (0.0395, 0.0079, 0.004), "inside": (0.0395, 0.0079, 0.0), "shaft": (0.1, 0.0079, 0.0)}
    scene = Scene("bracket", space="spatial").parameter("F", 100.0, "N")
    scene.flexible("bar", **body.fields(damping_ratio=0.5, gauges=places)).weld("wall", "ground.origin", "bar.root")
    scene.force("tip", "bar.tip", 0.0, "F", 0.0).measure("unknown", "stress", "bar.face", component="mesh_error")
    scene.measure("most_unknown", "stress", "bar.all", component="mesh_error")
    model = model_of(scene.build())
    run = simulate(model, t_end=1e-4, start="equilibrium", samples=2)
    found = run.stresses("bar")
    face, inside, shaft = found.von_mises[0]
    assert face == pytest.approx(41.6e6, rel=0.015) and inside == pytest.approx(44.05e6, rel=0.025)
    assert shaft == pytest.approx(14.465e6, rel=1e-3)
    truth = np.array([41.6e6, 44.05e6, 14.465e6])
    assert np.all(np.abs(found.von_mises[0] - truth)[:2] < 2 * found.mesh_error[0, :2])
    assert np.all(found.mesh_error[0] < [4e6, 4e6, 0.3e6])
    largest = found.largest()
    assert largest.gauge == "inside" and largest.mesh_error == found.mesh_error[0, 1]
    assert run.stats["mesh_error.bar"] == pytest.approx(largest.mesh_error, rel=1e-6)
    exact = body.equilibrium_stresses(at=list(places.values()))
    assert_allclose(exact.von_mises(run.body_motion("bar"))[0], found.von_mises[0], rtol=1e-6)
    assert_allclose(exact.mesh_error(run.body_motion("bar"))[0], found.mesh_error[0], rtol=1e-6)
    modal = run.stresses("bar", way="modes")
    assert_allclose(run["unknown"], modal.mesh_error[:, 0], rtol=1e-6)
    assert_allclose(run["most_unknown"], modal.mesh_error.max(axis=1), rtol=1e-6)
    many = ensemble(model, {"F": np.array([100.0, 200.0])}, t_end=1e-4, start="equilibrium", reduce={"unknown": "peak"})
    one, two = np.asarray(many["unknown_peak"])
    assert two == pytest.approx(2 * one, rel=1e-6)


def small_bar(mesh: Any, order: int) -> FlexibleBody:
    ends = {"root": lambda at: at[:, 0] < 1e-9, "tip": lambda at: at[:, 0] > 0.2 - 1e-9}
    return FlexibleBody.from_mesh(mesh, STEEL, order=order, modes=2, origin="root", interface=ends)


SIDES = (np.linspace(0, 0.2, 6), np.linspace(-0.01, 0.01, 3), np.linspace(0, 0.01, 2))


@pytest.mark.parametrize("kind, order", [("MeshHex", 1), ("MeshHex", 2), ("MeshTet", 2)])
def test_places_outside(kind: str, order: int) -> None:
    """Refused, with the nearest node; a hundredth of a cell beside the body is its surface."""
    body = small_bar(getattr(skfem, kind).init_tensor(*SIDES), order)
    for place in ((0.1, 0.04, 0.0), (0.1, 0.5, 0.0), (0.1, 0.012, 0.0)):
        for ask in (body.equilibrium_stresses, body.stresses().at):
            with pytest.raises(
                FiniteElementError, match=r"at\[0\].*lies outside of the body; its nearest node, 0\.\d+ m"
            ):
                ask([place])
        with pytest.raises(FiniteElementError, match=r"gauges\['skin'\].*\(0.1, 0.*\) m lies outside"):
            body.fields(gauges={"skin": place})
    beside, on = body.stresses().at([(0.11, 0.0101, 0.0), (0.11, 0.01, 0.0)])
    assert_allclose(beside, on, atol=1e-6 * np.abs(on).max())
    fields = body.fields(gauges={"skin": (0.11, 0.0101, 0.0)})
    assert_allclose(fields["gauges"]["skin"]["position"], [0.11, 0.01, 0.0], atol=1e-9)


def test_linear_tetrahedra_are_no_mesh_for_stress() -> None:
    body = small_bar(skfem.MeshTet.init_tensor(*SIDES), 1)
    with pytest.warns(FiniteElementWarning, match="linear tetrahedra have one stress a cell"):
        body.stresses().at([(0.1, 0.01, 0.0)])


def test_errors_that_are_not_known() -> None:
    """Points inside the elements have no averages; a gauge of an older scene has no rows of errors."""
    body = small_bar(skfem.MeshHex.init_tensor(*SIDES), 1)
    fields = body.fields(gauges={"skin": (0.1, 0.01, 0.0)})
    for key in ("error_shapes", "error_fields", "error_forces"):
        del fields["gauges"]["skin"][key]
    scene = Scene("bar", space="spatial").flexible("bar", **fields).weld("wall", "ground.origin", "bar.root")
    run = simulate(model_of(scene.build()), scheme="rk4", dt=1e-8, t_end=1e-8)
    assert np.isnan(run.stresses("bar").mesh_error).all()
    with pytest.raises(FiniteElementError, match="mesh_error.*applies to places only"):
        body.equilibrium_stresses().mesh_error(run.body_motion("bar"))
    scene.measure("unknown", "stress", "bar.skin", component="mesh_error")
    with pytest.raises(Exception, match="gauge 'skin' does not know the error of its mesh"):
        scene.build()
