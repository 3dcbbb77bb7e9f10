"""Sums over the poles of a rational approximation: polynomials of a matrix are what solutions pole by pole give."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from runtime.schemes.partial_fractions import Adjugate, Resolvents, poles


@pytest.mark.parametrize("n", [1, 2, 3])
@pytest.mark.parametrize("degree, share", [(3, 0.5), (5, 1.0)])
def test_polynomials_are_solutions_pole_by_pole(n: int, degree: int, share: float) -> None:
    """Law: sums of r^k h^(2-k) x, (r^2 - h^2 J) x = u sum_j (h / r)^j y_j, stiffnesses eight powers of ten apart."""
    rng, count = np.random.default_rng(n), 4
    J, h = ca.SX.sym("J", n, n), ca.SX.sym("h")
    y = [ca.SX.sym("y", n) for _ in range(count)]
    resolvents = Resolvents(J, ca.SX(n, n), h, share, poles(degree), Adjugate(h * h * J))
    sums = ca.Function("sums", [J, h, *y], [ca.densify(one) for one in resolvents.sums(y)])
    for length in (1e-4, 1e-2, 1.0):
        root = rng.normal(size=(n, n))
        matrix = -(root @ root.T + 0.1 * np.eye(n)) @ np.diag(10.0 ** np.linspace(0, 8, n))
        given, sub_step = rng.normal(size=(count, n)), share * length
        wanted = np.zeros((4, n))
        for pole in poles(degree):
            r = pole.r
            f = sum(pole.weights[0] * (sub_step / r) ** (j + 1) * one for j, one in enumerate(given))
            x = np.linalg.solve(r * r * np.eye(n) - sub_step**2 * matrix, f)
            wanted += [(pole.share * r**k * x).real * sub_step ** (2 - k) for k in range(4)]
        for k, found in enumerate(sums(matrix, length, *given)):
            np.testing.assert_allclose(np.array(found).ravel(), wanted[k], rtol=0, atol=1e-11 * np.abs(wanted[k]).max())
