"""Mass matrix and Q_v of planar bodies against Lagrange's equations of their mass points (Eqs. 15-20)."""

from __future__ import annotations

import casadi as ca
import numpy as np

from symgen.algebra.rows import to_matrix
from symgen.bodies.planar_body import BodyCoordinates, PlanarBody
from symgen.bodies.shape_integrals import PointShape, ShapeIntegrals

MODES, POINTS = 2, 5


def cloud() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Masses (n,), places (n, 2) and shapes (n, 2, nf) of points."""
    rng = np.random.default_rng(5)
    return rng.uniform(0.5, 2.0, POINTS), rng.normal(size=(POINTS, 2)), 0.3 * rng.normal(size=(POINTS, 2, MODES))


def integrals(m: np.ndarray, rho: np.ndarray, phi: np.ndarray) -> ShapeIntegrals:
    """The sums over the points that the body is told."""
    none = ca.SX(MODES, MODES)
    along = np.einsum("k,kj,kja->a", m, rho, phi)
    about = np.einsum("k,ka->a", m, rho[:, :1] * phi[:, 1] - rho[:, 1:] * phi[:, 0])
    pairs = np.einsum("k,kia,kib->ab", m, phi, phi)
    across = np.einsum("k,ka,kb->ab", m, phi[:, 0], phi[:, 1])
    sums = [m.sum(), m @ rho, m @ (rho**2).sum(axis=1), np.einsum("k,kja->ja", m, phi), along, about, pairs]
    given = [ca.SX(ca.DM(value)) for value in [*sums, across - across.T]]
    return ShapeIntegrals(*given, none, none, none, none)


def test_planar_bodies_are_those_of_lagrange() -> None:
    q, v = (ca.SX.sym(name, 3 + MODES) for name in "qv")
    m, rho, phi = cloud()
    A = ca.vertcat(ca.horzcat(ca.cos(q[2]), -ca.sin(q[2])), ca.horzcat(ca.sin(q[2]), ca.cos(q[2])))
    places = [q[:2] + A @ (ca.DM(one) + ca.DM(shape) @ q[3:]) for one, shape in zip(rho, phi, strict=True)]
    rates = [ca.jtimes(place, q, v) for place in places]
    T = sum((mass * ca.sumsqr(rate) / 2 for mass, rate in zip(m, rates, strict=True)), ca.SX(0))
    M, momenta = ca.hessian(T, v)
    Q_v = ca.gradient(T, q) - ca.jtimes(momenta, q, v)
    parts = [ca.vertsplit(one) for one in (q, v)]
    (x, y, theta, *q_f), (x_dot, y_dot, theta_dot, *q_f_dot) = parts
    columns = list(range(3 + MODES))
    own = BodyCoordinates(columns, [x, y], theta, q_f, [x_dot, y_dot], theta_dot, q_f_dot)
    body = PlanarBody("cloud", own, integrals(m, rho, phi))
    found = [{} for _ in columns]
    for row, column, value in body.mass_entries():
        found[row][column] = found[column][row] = value
    force = body.quadratic_velocity_force()
    mine = [to_matrix(found, range(len(found))), ca.vertcat(*(force[column] for column in columns))]
    shape = PointShape(*(ca.SX(ca.DM(value)) for value in (rho[0], 0.0, phi[0], np.zeros(MODES))), ca.SX(MODES, MODES))
    point = body.marker(shape)
    by_q = [[row.get(column, ca.SX(0)) for column in columns] for row in point.r_columns]
    mine += [ca.vertcat(*point.r), ca.vertcat(*point.r_dot), ca.vertcat(*point.bias)]
    mine.append(ca.vertcat(*(ca.horzcat(*row) for row in by_q)))
    theirs = [M, Q_v, places[0], rates[0], ca.jtimes(rates[0], q, v), ca.jacobian(places[0], q)]
    both = ca.Function(
        "both", [q, v], [ca.vec(ca.densify(one - other)) for one, other in zip(mine, theirs, strict=True)]
    )
    rng = np.random.default_rng(6)
    for difference in both(rng.normal(size=3 + MODES), rng.normal(size=3 + MODES)):
        assert np.abs(np.array(difference)).max() < 1e-13
