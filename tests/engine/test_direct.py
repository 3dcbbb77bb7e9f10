"""Functions called through CasADi's buffers."""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.engine.rows import Direct


def test_all_outputs_come_as_one_vector_that_stays() -> None:
    """Sparse ones, too, by hand; a further call changes nothing that was given before."""
    x, y = ca.SX.sym("x", 2), ca.SX.sym("y")
    sparse = ca.SX(3, 1)
    sparse[1] = x[0] * y
    called = Direct(ca.Function("f", [x, y], [sparse, ca.horzcat(x, 2 * x)]))
    first = called(np.array([2.0, 3.0]), 5.0)
    second = called(np.array([1.0, 0.0]), -1.0)
    np.testing.assert_array_equal(first, [0, 10, 0, 2, 3, 4, 6])
    np.testing.assert_array_equal(second, [0, -1, 0, 1, 0, 2, 0])
