"""Stresses of solids by equilibrium: static and turning bars against the textbook, few modes against many."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.testing import assert_allclose

from runtime import Solution, simulate
from runtime.contract.flexible import BodyMotion, MarkerForce
from runtime.model import Model
from symgen.fe import FiniteElementError, FlexibleBody, Material
from symgen.scene import Scene, SceneRecord

pytestmark = pytest.mark.long

skfem = pytest.importorskip("skfem")
Build = Callable[[SceneRecord], Model]
L, Y, Z, CELLS = 0.3, 0.010, 0.012, 16
MATERIAL = Material(E=2.0e11, nu=0.0, rho=7800.0)


def bar(count: int, cells: int = CELLS, **choices: object) -> FlexibleBody:
    """A bar along x of quadratic hexahedra, its free modes or those with the root held."""
    sides = [np.linspace(0.0, L, cells + 1), np.array([-Y / 2, Y / 2]), np.array([-Z / 2, Z / 2])]
    ends = {"root": lambda at: at[:, 0] < 1e-9, "tip": lambda at: at[:, 0] > L - 1e-9}
    given = {"mode_set": "free", "origin": "root"} | choices
    return FlexibleBody.from_mesh(skfem.MeshHex.init_tensor(*sides), MATERIAL, interface=ends, modes=count, **given)


def test_a_pulled_and_bent_bar(model_of: Build) -> None:
    """sigma_xx = P / A - M y / I in the middle, with two free modes that hold neither the pull nor the moment.

    A joint and a load at markers of other names at the places of the interfaces; the weight makes no difference.
    """
    body = bar(2)
    fields = body.fields()
    fields["markers"] |= {"pulled": fields["markers"]["tip"], "turned": fields["markers"]["tip"]}
    builder = Scene("bar", space="spatial").flexible("bar", **fields)
    builder.weld("wall", "ground.origin", "bar.root").force("pull", "bar.pulled", 9e-4, 0.0, 0.0, frame="body")
    builder.torque("key", "bar.turned", 7e-6)
    run = simulate(model_of(builder.build()), scheme="rk4", dt=1e-9, t_end=1e-9, start="quasi_static")
    stresses = body.equilibrium_stresses()
    (tensor,) = stresses.of(run.body_motion("bar"))[:1]
    middle = np.abs(stresses.points[:, 0] - L / 2) < L / CELLS
    expected = 9e-4 / (Y * Z) - 7e-6 * stresses.points[:, 1] / (Z * Y**3 / 12)
    size = np.abs(expected).max()
    assert_allclose(tensor[0, 0][middle], expected[middle], atol=1e-6 * size)
    assert np.abs(tensor[1, 1][middle]).max() < 1e-6 * size and np.abs(tensor[0, 1][middle]).max() < 1e-6 * size
    lacking = body.stresses().of(run.body_motion("bar").q_f)[0][0, 0]
    assert np.abs(lacking - expected)[middle].max() > 0.1 * size
    (surface,) = body.equilibrium_stresses(at=[L / 2, Y / 2, 0.0]).von_mises(run.body_motion("bar"))[:1]
    assert_allclose(surface, abs(9e-4 / (Y * Z) - 7e-6 * 6 / (Z * Y**2)), rtol=1e-5)


def driven(model_of: Build, count: int, motion: str, t_end: float, dt: float) -> tuple[FlexibleBody, Solution]:
    """The bar on an axle at its root, turned about z by a prescribed motion."""
    body = bar(count, mode_set="mixed", fixed=["root"])
    builder = Scene("arm", space="spatial").flexible("bar", **body.fields())
    builder.revolute("axle", "ground.origin", "bar.root")
    builder.prescribed_angle("drive", "ground.origin", "bar.root", motion=motion)
    every = max(1, round(t_end / dt / 20))
    run = simulate(
        model_of(builder.build()), scheme="rk4", dt=dt, t_end=t_end, start="quasi_static", seen_every=every * dt
    )
    return body, run


def test_a_turning_bar(model_of: Build) -> None:
    """Mean sigma_xx of a slice of elements is that of rho w^2 (L^2 - x^2) / 2, by a mode that does not stretch."""
    speed = 300.0
    body, run = driven(model_of, 1, f"{speed} * t", 1e-8, 1e-8)
    motion, basis = run.body_motion("bar"), body.structure.stress.basis  # type: ignore[union-attr]
    stress = body.equilibrium_stresses().of(motion)[0][0, 0].reshape(basis.dx.shape)
    centres = np.asarray(basis.global_coordinates())[0].mean(axis=1)
    slices = (stress * basis.dx).sum(axis=1) / basis.dx.sum(axis=1)
    h = L / CELLS
    exact = MATERIAL.rho * speed**2 / 2 * (L**2 - centres**2 - h**2 / 12)
    assert_allclose(slices, exact, rtol=1e-6)


def test_few_modes_suffice_where_equilibrium_is_asked(model_of: Build) -> None:
    """Started from rest in 5 ms, an arm's von Mises stress inside: one mode against four; their sum is 2 % off."""
    found = {}
    for count in (1, 4):
        body, run = driven(model_of, count, "40.0 * t ** 3 / 5e-3", 5e-3, 2e-5)
        motion, points = run.body_motion("bar"), body.stresses().points
        near = np.abs(points[:, 0] - L / 2) < 0.4 * L
        found[count] = body.equilibrium_stresses().von_mises(motion)[:, near]
        if count == 1:
            modal = body.stresses().von_mises(motion.q_f)[:, near]
    size = found[4].max()
    assert np.abs(found[1] - found[4]).max() < 0.002 * size and np.abs(modal - found[4]).max() > 0.02 * size


def test_motions_that_do_not_fit() -> None:
    body, N = bar(1, cells=2), 3
    still = np.zeros((N, 3))
    pin = MarkerForce("pin", np.array([L / 3, 0.0, 0.0]), np.zeros((N, 6)))
    stresses = body.equilibrium_stresses(at=[0.0, 0.0, 0.0])
    for modes, forces, problem in (
        (2, [], "motion.*rod has 2 modes, not 1"),
        (1, [pin], "marker 'pin'.*it is not an interface"),
    ):
        motion = BodyMotion("rod", np.zeros(N), *np.zeros((3, N, modes)), still, still, still, forces)
        with pytest.raises(FiniteElementError, match=problem):
            stresses.of(motion)
    with pytest.raises(FiniteElementError, match="at.*has rows that are not points"):
        body.equilibrium_stresses(at=[1.0, 2.0])
