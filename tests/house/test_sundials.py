"""What SUNDIALS calls: native code for values and derivatives, each library with arrays of its own."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

from benchmarks.contenders.external import External
from benchmarks.contenders.sundials import METHODS, Sundials
from runtime.baselines.condensed_ode import start_of
from runtime.model import Model

Load = Callable[..., Model]


@pytest.mark.every_push("tumbling_body-idas", "flexible_joint_arm-cvodes")
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", ["flexible_joint_arm", "flexible_slider_crank_free", "tumbling_body"])
def test_derivatives_are_those_of_the_values(built_in: Load, method: str, name: str) -> None:
    """Native values, and derivatives by the emitted Jacobians, against CasADi's: a tree, a loop, an orientation."""
    model = built_in(name)
    given = start_of(model, None, None, None)
    equations = METHODS[method](model)
    rng, inputs = np.random.default_rng(2), list(equations.inputs.values())
    y = given.y.copy()
    n = len(model.q_i)
    y[n : 2 * n] += rng.normal(size=n)
    at = [0.3, y, *(rng.normal(size=one.numel()) for one in inputs[2:])]
    outputs = list(equations.outputs.values())
    values = ca.Function("values", [*inputs, equations.c], outputs)
    blocks = [ca.jacobian(out, into) for out in outputs for into in inputs]
    slopes = ca.Function("slopes", [*inputs, equations.c], blocks)(*at, given.c)
    native = Sundials(model, method, given).native
    assert native is not None
    found = native.function.call(at)
    for one, expected in zip(found, values.call([*at, given.c]), strict=True):
        np.testing.assert_allclose(np.asarray(one), np.asarray(expected), rtol=1e-10, atol=1e-10)
    jacobian = native.function.jacobian()
    marks = [ca.DM(out.numel(), 1) for out in outputs]
    names = [f"jac_{out}_{into}" for out in equations.outputs for into in equations.inputs]
    for where, one, expected in zip(names, jacobian.call([*map(ca.DM, at), *marks]), slopes, strict=True):
        if not where.endswith("_t"):  # nobody asks for these
            scale = max(1.0, float(np.abs(np.asarray(expected)).max(initial=0.0)))
            np.testing.assert_allclose(np.asarray(one), np.asarray(expected), rtol=0, atol=1e-9 * scale, err_msg=where)


def test_functions_of_one_shape_keep_their_own_constants() -> None:
    x, c = ca.SX.sym("x", 2), ca.SX.sym("c", 2)
    made = [External({"x": x}, {"y": c * x}, {("y", "x"): ca.diag(c)}, c, np.array([k, 2.0])) for k in (3.0, 5.0)]
    for one, k in zip(made, (3.0, 5.0), strict=True):
        np.testing.assert_array_equal(np.asarray(one.function([7.0, 1.0])).ravel(), [7 * k, 2.0])
        np.testing.assert_array_equal(np.asarray(one.function.jacobian()([0, 0], 0)), np.diag([k, 2.0]))
