"""exponential_adams with the Jacobian of all coordinates: order, its step by hand, where it is chosen, its price."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import factorial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import load_model, resume, simulate
from runtime.contract.model import Model
from runtime.contract.tape import arithmetic
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import SchemeError
from runtime.schemes.scheme import Scheme
from runtime.studies.stability.tangent import TangentStep
from runtime.studies.work_precision.methods import stiff_methods
from symgen.scene import Scene, SceneRecord
from symgen.scenes import generated_folder
from symgen.scenes.arm import arm
from tests.hand_derived.twin_oscillators import Params
from tests.hand_derived.twin_subcycling import matrices, radius
from tests.support.model_values import Array
from tests.support.order_case import OrderCase
from tests.support.prepared_runs import PreparedRuns

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
NAME = "exponential_adams"
JACOBIAN = {"linearisation": "jacobian"}


def built(model: Model, options: Mapping[str, str] = JACOBIAN) -> Scheme:
    return scheme_kind(NAME).build(NAME, model, 1.0, None, options)


CASES = {
    "hub_beam": OrderCase(0.8, 4e-2, 9e-10),  # a load that depends on time, gyroscopic forces
    "flexible_slider_crank_free": OrderCase(0.008, 2e-4, 5e-10, "quasi_static"),  # a loop
    "flexible_joint_arm": OrderCase(0.5, 1.25e-3, 8e-13),  # springs between coordinates
    "overdamped_joint": OrderCase(0.4, 2e-2, 2.7e-9),
}


@pytest.mark.parametrize("name", CASES)
def test_order_four(built_in: Load, name: str) -> None:
    """Law: the error of q_i at t_end falls with dt^4 or faster, the first step from a start without a past included."""
    case, model = CASES[name], built_in(name)
    exact = PreparedRuns(model, "dop853", start=case.start).end(case.t_end, case.dt / 160)
    runs, steps = PreparedRuns(model, NAME, None, JACOBIAN, case.start), [case.dt, case.dt / 2, case.dt / 4]
    errors = [float(np.max(np.abs(runs.end(case.t_end, step) - exact))) for step in steps]
    slope = float(np.polyfit(np.log(steps), np.log(errors), 1)[0])
    assert 3.7 < slope < 8.0, errors
    assert errors[-1] < case.cap, (slope, errors)


def pade(A: Array) -> Array:
    """The Pade approximation of exp(A) with a numerator of degree 4 and a denominator of degree 5."""

    def part(top: int, other: int, z: Array) -> Array:
        whole = factorial(top + other)
        weights = [
            factorial(top + other - k) * factorial(top) / (whole * factorial(k) * factorial(top - k))
            for k in range(top + 1)
        ]
        return np.asarray(sum(w * np.linalg.matrix_power(z, k) for k, w in enumerate(weights)))

    return np.asarray(np.linalg.solve(part(5, 4, -A), part(4, 5, A)))


def system(p: Params) -> Array:
    """(x, v)' = A (x, v) of two oscillators."""
    M, K, D = matrices(p)
    return np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])


def step_matrix(tangent: TangentStep, p: Params, dt: float) -> Array:
    """On x, v and what is remembered, q, v and a of the start of the last step."""
    model = tangent.scheme.model
    names = {"c": p.c, "w": p.w, "k_L": p.k_L, "zeta": p.zeta}
    c = tangent.scheme.constants(model.constants(model.parameter_vector(names)), dt)
    z = np.asarray(tangent.scheme.starter(0.0, np.zeros(2), np.zeros(2), np.zeros(0), c)).ravel()
    return np.asarray(tangent(z, c)[1])


def test_step_of_a_linear_system(built_in: Load) -> None:
    """By hand: the rational approximation of all of it, whatever motion led there; modes die out, slow or damped."""
    tangent = TangentStep(built(built_in("two_oscillators")))
    for p in (Params(c=0.5, w=3.0, k_L=1.7, zeta=0.0), Params(c=-0.6, w=200.0, k_L=0.9, zeta=0.07)):
        found, A = step_matrix(tangent, p, 0.2), system(p)
        state, nothing = np.eye(4), np.zeros((4, 4))
        along = np.block([[state, nothing], [nothing, state], [np.zeros((2, 4)), A[2:]]])  # accelerations by the law
        expected = np.block([[pade(0.2 * A), nothing], [state, nothing], [A[2:], np.zeros((2, 4))]])
        np.testing.assert_allclose(found @ along, expected, rtol=0, atol=1e-12 * np.abs(expected).max())
        assert radius(found) < 1.0 + 1e-12


@pytest.mark.parametrize("c", [0.3, 0.6])
def test_unresolved_modes_do_not_grow(built_in: Load, c: float) -> None:
    """Law: from H w = 1 to 1e4 not at all, at H w_L = 0.2 and 0.5."""
    tangent = TangentStep(built(built_in("two_oscillators")))
    for slow in (0.2, 0.5):
        for reach in np.geomspace(1.0, 1e4, 25):
            assert radius(step_matrix(tangent, Params(c=c, w=reach / slow, k_L=1.0, zeta=0.0), slow)) < 1.0 + 1e-12


def test_remainder_of_a_pushed_block(model_of: Build) -> None:
    """A force t^3 is exact. Of t^4 the cubic leaves tau^2 (tau + h) (tau - 5/6 h): by hand -13/360 h^5 of v a step."""
    h = 0.25
    for power, left in ((3, 0.0), (4, 13 / 360 * h**5)):
        builder = Scene(f"pushed_{power}").rigid("block", mass=1.0, inertia=1.0, free=True)
        model = model_of(builder.force("force", "block.origin", f"t**{power}", 0.0).build())
        v = PreparedRuns(model, NAME, None, JACOBIAN).samples(h, 9, 1)["v"][:, 0]
        exact = (h * np.arange(10)) ** (power + 1) / (power + 1)
        np.testing.assert_allclose(np.diff(v - exact)[1:], left, rtol=1e-9, atol=1e-13)


def test_where_it_is_chosen(built_in: Load, model_of: Build) -> None:
    """`auto` takes it where a step is hardly longer: few coordinates in few terms, not loops, long trees or space."""
    chosen = {}
    for model in (*map(built_in, ("flexible_joint_arm", "overdamped_joint", "flexible_slider_crank_free", "heavy_top")),
                  model_of(arm(10))):  # fmt: skip
        scheme = built(model, {})
        chosen[model.name] = scheme.options.linearisation
        assert type(built(model, {})) is type(scheme)
    assert list(chosen.values()) == ["jacobian", "jacobian", "stiffness", "stiffness", "stiffness"], chosen


def test_what_was_run_before_does_not_choose() -> None:
    """With 20 Newton steps on the loop in each evaluation both are about as long; `auto` goes by the usual one."""
    model = load_model(generated_folder("n_four_bar"))
    for options in ({"closure_iterations": 20}, {}):
        scheme = scheme_kind(NAME).build(NAME, model, 1e-3, None, options)
        assert scheme.options.linearisation == "stiffness"  # type: ignore[attr-defined]


def test_price_and_steps(built_in: Load) -> None:
    """An arm with stiff gears: a step is hardly longer than one with the stiffness, and half of them is enough."""
    model = built_in("flexible_joint_arm")
    price, other = (
        sum(arithmetic(stage) for stage in built(model, {"linearisation": word}).program().stages())
        for word in ("jacobian", "stiffness")
    )
    assert price < 1.2 * other
    exact = PreparedRuns(model, "dop853").end(2.0, 2e-4)

    def off(word: str, dt: float) -> float:
        return float(np.abs(PreparedRuns(model, NAME, None, {"linearisation": word}).end(2.0, dt) - exact).max())

    assert off("jacobian", 0.04) < 1.3e-3 < off("stiffness", 0.02)


def test_refusals(built_in: Load, model_of: Build) -> None:
    """Where there is no such Jacobian, that is said, and what to take."""
    for model in (built_in("heavy_top"), model_of(arm(10))):
        with pytest.raises(SchemeError, match="linearisation = 'jacobian' takes.*12 independent.*take 'stiffness'"):
            built(model)


def test_methods_to_be_tried(built_in: Load, model_of: Build) -> None:
    """Where the price of a step is against it, it may take fewer: `advise` tries both; elsewhere what was chosen."""
    tried = {
        model.name: [spec.options for spec in stiff_methods(model) if spec.scheme == NAME]
        for model in (built_in("flexible_joint_arm"), built_in("spin_up_beam"), model_of(arm(10)))
    }
    assert list(tried.values()) == [[{}], [{}, JACOBIAN], [{}]]


def test_a_beam_that_stands_by_spinning(built_in: Load) -> None:
    """Its stiffness comes from the motion: with the constant one steps of 0.1 s go astray, with the Jacobian not."""
    model = built_in("spin_up_beam")
    exact = PreparedRuns(model, "dop853").end(10.0, 0.01)

    def off(word: str) -> float:
        return float(np.abs(PreparedRuns(model, NAME, None, {"linearisation": word}).end(10.0, 0.1) - exact).max())

    assert off("jacobian") < 4e-8 < 1e-2 < off("stiffness")


def test_runs_go_on(built_in: Load, tmp_path: Path) -> None:
    """Order 4 where the torque on the hub ends within a step, and a resumed run is bitwise the whole one."""
    model = built_in("hub_beam")
    settings: dict[str, Any] = {"scheme": NAME, "options": JACOBIAN}

    def stop(t: float, t_end: float) -> None:
        if t >= 2.5:
            raise KeyboardInterrupt

    exact = simulate(model, t_end=3.0, dt=0.01, scheme="dop853", save_every=300).q[-1]
    runs = [simulate(model, t_end=3.0, dt=dt, save_every=25, **settings) for dt in (0.06, 0.03)]
    errors = [float(np.abs(run.q[-1] - exact).max()) for run in runs]
    assert errors[1] < 3e-8 and 12 < errors[0] / errors[1] < 22, errors
    path = tmp_path / "run.npz"
    simulate(model, t_end=3.0, dt=0.06, save_every=25, checkpoint=path, checkpoint_every=7, progress=stop, **settings)
    assert np.array_equal(resume(model, path).q, runs[0].q)
