"""Bodies from reduced matrices against the full models they were reduced from; units."""

from __future__ import annotations

import re
import warnings
from typing import Any

import numpy as np
import pytest
import scipy.linalg as la
from numpy.testing import assert_allclose

from runtime import simulate
from symgen.fe import STEEL, FiniteElementError, FiniteElementWarning, FlexibleBody, LineMesh, Material, Section
from symgen.generate import model_of
from symgen.scene import Scene

N, LENGTH = 10, 0.3
NODES = np.array([(LENGTH * k / N, 0.0, 0.0) for k in range(N + 1)])
ENDS = {"a": NODES[0], "b": NODES[N]}
FULL: dict[str, Any] = {"mode_set": "fixed_interface", "origin": "a", "interface": {"a": [0], "b": [N]}}


def full(modes: int = 4) -> FlexibleBody:
    mesh = LineMesh(NODES, [(k, k + 1) for k in range(N)], Section.rectangle(0.016, 0.008))
    return FlexibleBody.from_mesh(mesh, STEEL, modes=modes, **FULL)


def reduction(body: FlexibleBody, modes: int = 4) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """K, M and T (n_dof, n) of Craig and Bampton by definition: static shapes of the ends, modes with both held."""
    K, M = body.structure.K.toarray(), body.structure.M.toarray()
    ends = np.r_[0:6, 6 * N : 6 * N + 6]
    inner = np.setdiff1d(np.arange(len(K)), ends)
    static = -np.linalg.solve(K[np.ix_(inner, inner)], K[np.ix_(inner, ends)])
    normal = la.eigh(K[np.ix_(inner, inner)], M[np.ix_(inner, inner)])[1][:, :modes]
    T = np.zeros((len(K), 12 + modes))
    T[ends, :12], T[inner, :12], T[inner, 12:] = np.eye(12), static, normal
    return T.T @ K @ T, T.T @ M @ T, T


def second_order(body: FlexibleBody, T: np.ndarray) -> dict[str, np.ndarray]:
    """Integrals of the reduced shapes by those of the full model: of all shapes T, as of its modes."""
    from symgen.fe.inertia import inertia_integrals

    T_scaled, scale = T, la.cholesky(T.T @ body.structure.M @ T, lower=False)
    orthonormal = la.solve_triangular(scale.T, T_scaled.T, lower=True).T  # M-orthonormal: T = orthonormal @ scale
    these = inertia_integrals(body.structure, orthonormal, body.origin)
    return {
        "rho_psi": np.einsum("aij,ab->bij", these.rho_phi, scale),
        "psi_psi": np.einsum("abij,ac,bd->cdij", these.phi_phi, scale, scale),
    }


def test_a_reduced_body_is_the_full_one() -> None:
    """Frequencies, mass, first moment, inertia and markers of Craig and Bampton's body, from K and M alone."""
    body = full()
    K, M, _ = reduction(body)
    with pytest.warns(FiniteElementWarning, match="do not say how mass lies inside"):
        found = FlexibleBody.from_reduced(K, M, interface=ENDS, origin="a")
    assert found.nf == body.nf == 10
    assert_allclose(found.frequencies, body.frequencies, rtol=1e-9)
    assert_allclose(found.integrals.mass, body.integrals.mass, rtol=1e-12)
    assert_allclose(found.integrals.first_moment, body.integrals.first_moment, atol=1e-12)
    assert_allclose(found.integrals.moments, body.integrals.moments, atol=1e-9 * body.integrals.moments.max())
    for name, marker in body.markers.items():
        mine = found.markers[name]
        assert_allclose(mine.position, marker.position, atol=1e-15)
        for kind in ("shape", "rotation"):
            both = [np.asarray(getattr(one, kind)) for one in (mine, marker)]
            assert_allclose(both[0] @ both[0].T, both[1] @ both[1].T, atol=1e-7 * np.abs(both[1] @ both[1].T).max())


@pytest.mark.long
def test_the_motion_of_a_reduced_rod() -> None:
    """A pendulum of it that swings fast: that of the full body where the second-order inertia is given."""
    body = full()
    K, M, T = reduction(body)
    given = FlexibleBody.from_reduced(K, M, interface=ENDS, origin="a", **second_order(body, T))
    runs = []
    for one in (body, given):
        scene = Scene("pendulum", space="spatial").gravity(0, -9.81, 0).flexible("rod", **one.fields())
        scene.revolute("hinge", "ground.origin", "rod.a").measure("tip", "y", of="rod.b")
        scene.torque("motor", "rod.b", 0.2)
        runs.append(simulate(model_of(scene.build()), scheme="rk4", dt=2e-7, t_end=1e-4))
    assert np.abs(runs[0]["tip"] - runs[1]["tip"]).max() < 1e-9 * np.abs(runs[0]["tip"]).max()


@pytest.mark.long
def test_stress_by_recovery_matrices() -> None:
    """Gauges by the matrix that the program writes: bending stress E z'' e at the root of a bar under a force."""
    body = full()
    K, M, T = reduction(body)
    # of the first element: sigma = E (u_1 - u_0) / h, from displacements of the nodes
    rows = np.zeros((6, len(T)))
    rows[0, 6], rows[0, 0] = STEEL.E * N / LENGTH, -STEEL.E * N / LENGTH
    recovery = {"root": {"position": NODES[0], "stress": rows @ T}}
    with pytest.warns(FiniteElementWarning):
        found = FlexibleBody.from_reduced(K, M, interface=ENDS, origin="a", recovery=recovery)
    scene = Scene("bar", space="spatial").flexible("bar", **found.fields()).weld("wall", "ground.origin", "bar.a")
    scene.force("pull", "bar.b", 1000.0, 0, 0).measure("sigma", "stress", of="bar.root", component="xx")
    run = simulate(model_of(scene.build()), scheme="rk4", dt=1e-9, t_end=1e-9, start="quasi_static")
    assert run["sigma"][0] == pytest.approx(1000.0 / (0.016 * 0.008), rel=1e-6)
    assert run.stresses("bar", way="modes").at("root")[0, 0] == pytest.approx(run["sigma"][0], rel=1e-9)


def in_millimetres(matrix: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """A matrix of N/m and kg (energies) in N/mm and t: of angles N mm and t mm^2."""
    scale = np.where(angles, 1.0, 1e-3)
    return 1e3 * matrix * scale[:, None] * scale


def test_units() -> None:
    """Matrices in mm, t, s by hand: a translation's stiffness over 1e3, that of an angle times 1e3, a mass over 1e3."""
    body = full()
    K, M, T = reduction(body)
    angles = (np.arange(len(K)) < 12) & (np.arange(len(K)) % 6 >= 3)
    assert in_millimetres(K, angles)[0, 0] == pytest.approx(K[0, 0] / 1e3)
    assert in_millimetres(K, angles)[3, 3] == pytest.approx(1e3 * K[3, 3])
    millimetres = {name: 1e3 * place for name, place in ENDS.items()}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", FiniteElementWarning)
        found = FlexibleBody.from_reduced(
            in_millimetres(K, angles), in_millimetres(M, angles), interface=millimetres, units="mm-t-s", origin="a"
        )
    assert_allclose(found.frequencies, body.frequencies, rtol=1e-9)
    assert found.integrals.mass == pytest.approx(body.integrals.mass)
    full_angles = body.structure.component >= 3
    K_full, M_full = (in_millimetres(one.toarray(), full_angles) for one in (body.structure.K, body.structure.M))
    again = FlexibleBody.from_matrices(
        K_full, M_full, 1e3 * NODES, dofs=6, units="mm-t-s", modes=4, **{**FULL, "interface": {"a": [1], "b": [N + 1]}}
    )
    assert_allclose(again.frequencies, body.frequencies, rtol=1e-9)
    with pytest.warns(FiniteElementWarning, match=r"300 m long \(read in mm, t, s: 0.301 kg and 0.3 m\)"):
        FlexibleBody.from_matrices(
            K_full, M_full, 1e3 * NODES, dofs=6, modes=4, **{**FULL, "interface": {"a": [1], "b": [N + 1]}}
        )
    with pytest.raises(FiniteElementError, match="units.*'inch' are not known"):
        FlexibleBody.from_matrices(K_full, M_full, NODES, dofs=6, units="inch", modes=1, **FULL)


def test_materials_that_cannot_be_meant() -> None:
    mesh = LineMesh(NODES, [(k, k + 1) for k in range(N)], Section.rectangle(0.016, 0.008))
    for material, problem in (
        (Material(2.1e5, 0.3, 7850.0), r"E = 2.1e\+05 Pa \(read in MPa: 2.1e\+11 Pa\)"),
        (Material(2.1e11, 0.3, 7.85e-9), r"rho = 7.85e-09 kg/m\^3 \(read in t/mm\^3: 7.85e\+03 kg/m\^3\)"),
    ):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always", FiniteElementWarning)
            FlexibleBody.from_mesh(mesh, material, modes=1, **FULL)
        assert any(re.search(problem, str(one.message)) for one in told)


def test_what_does_not_fit_is_named() -> None:
    K, M, _ = reduction(full())
    supported = K.copy()
    supported[0, 0] *= 2
    lower = np.tril(K)
    for given, problem in (
        ({"K": supported}, "rigid motions of the interface nodes leave .* of the stiffness forces"),
        ({"K": lower}, "K: is not symmetric"),
        ({"K": K[:9, :9], "M": M[:9, :9]}, "the 2 interface nodes alone have 12 rows"),
        ({"M": M[:-1, :-1]}, "M: is .* K is"),
        ({"interface": {"a": NODES[0], "b": NODES[5]}}, "check places, units"),
        ({"interface": {"a": NODES[0], "b": (0.0, 1.0)}}, "is not a place"),
        ({"origin": "c"}, "'c' is not an interface"),
        ({"modes": 20}, "20 asked for, the matrices have 10"),
        ({"recovery": {"root": np.zeros((6, 3))}}, r"recovery\['root'\].*6 x 16"),
        ({"rho_psi": np.zeros(3), "psi_psi": np.zeros(3)}, "give .16, 3, 3. and .16, 16, 3, 3."),
        ({"rho_psi": np.zeros((16, 3, 3)), "psi_psi": np.zeros((16, 16, 3, 3))}, "its trace is not M"),
    ):
        arguments = {"K": K, "M": M, "interface": ENDS, **given}
        with pytest.raises(FiniteElementError, match=problem), warnings.catch_warnings():
            warnings.simplefilter("ignore", FiniteElementWarning)
            FlexibleBody.from_reduced(arguments.pop("K"), arguments.pop("M"), **arguments)
