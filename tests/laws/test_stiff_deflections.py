"""Exponential Runge-Kutta steps on the stiff deflections: what they are made of, orders, matrices, limits, prices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np
import pytest

from benchmarks.scenes.arm import arm
from runtime.contract.tape import arithmetic
from runtime.engine.prepare import prepare
from runtime.model import Model
from runtime.operating.mode_solver import State
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.scheme import Scheme
from runtime.schemes.stage_equations import StageEquations
from runtime.schemes.step_limit import limit_beside_deflections
from runtime.studies.stability.spectra import TangentStep
from symgen.generate import model_of as on_demand
from symgen.kernels import deflection_kernels
from symgen.pipeline import derive
from symgen.scene import SceneError, SceneRecord
from symgen.scenes import SCENES
from symgen.scenes.pendulums import chain
from symgen.scenes.spatial import spatial_chain
from tests.hand_derived.twin_oscillators import Params
from tests.hand_derived.twin_subcycling import generator, matrices, pade_of_five, radius
from tests.support.model_values import Array, evaluate, random_states
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
NAME = "exponential_rk4"


def built(model: Model) -> Scheme:
    return scheme_kind(NAME).build(NAME, model, 1.0, None, {})


def deflections(model: Model) -> tuple[Array, Array, Array]:
    """B, K, D at default parameters."""
    found = StageEquations(model, ca.SX(np.append(model.constants(model.parameter_vector()), 1.0))).deflections()
    return np.array(ca.DM(found.B)), np.array(ca.DM(found.K)), np.array(ca.DM(found.D))


def with_stiff(scene: SceneRecord, *names: str) -> SceneRecord:
    data = scene.to_dict()
    data["partition"] = {**data.get("partition", {}), "stiff": list(names)}
    return SceneRecord.from_dict(data)


def test_modes_and_springs_are_found(built_in: Load) -> None:
    """A gear spring turns link and rotor; a beam's modes have its K_ff and D_ff; a linear structure has K and D."""
    arm_model = built_in("flexible_joint_arm")
    B, K, D = deflections(arm_model)
    for k in (1, 2):
        column = B[:, k - 1]
        assert column[arm_model.q_i.index(f"link{k}.theta")] == -column[arm_model.q_i.index(f"rotor{k}.theta")]
        assert np.abs(column).sum() == 2
    np.testing.assert_allclose(K, 3e4 * np.eye(2), rtol=1e-14)
    assert not D.any()
    damped = built_in("flexible_slider_crank_torque")
    B, K, D = deflections(damped)
    modes = [damped.q_i.index(name) for name in damped.elastic if name in damped.q_i]
    np.testing.assert_array_equal(B, np.eye(len(damped.q_i))[:, modes])
    q = np.zeros(len(damped.coordinates))
    full = evaluate(damped, "augmented", q=q, q_dot=q, t=0.0)["K"].reshape(len(q), len(q))
    columns = [damped.coordinates.index(damped.q_i[k]) for k in modes]
    np.testing.assert_allclose(K, full[np.ix_(columns, columns)], rtol=1e-14)
    assert (np.diag(D) > 0).all()


def test_a_scene_says_what_is_stiff() -> None:
    """By names or patterns; none at all leaves the functions out; a name that stands for nothing is an error."""
    scene = SCENES["flexible_joint_arm"]()
    assert derive(with_stiff(scene, "gear2")).tapes["deflections"].output_shapes[0] == (4, 1)
    assert "deflections" not in derive(with_stiff(scene)).tapes
    assert "deflections" not in derive(SCENES["double_pendulum"]()).tapes
    with pytest.raises(SceneError, match="partition.stiff.*gear3.*gear1, gear2"):
        derive(with_stiff(scene, "gear3"))


def test_the_response_along_a_tree_is_the_condensed_one(model_of: Build) -> None:
    """q_i'' = M_hat^-1 Q_hat and X = M_hat^-1 B by one elimination; every link is flexible here."""
    model = model_of(chain(4, 2))
    n, B = len(model.q_i), deflections(model)[0]
    for state in random_states(model, 2):
        condensed = evaluate(model, "condensed", **state.values())
        M_hat, Q_hat = condensed["M_hat"].reshape(n, n), condensed["Q_hat"].ravel()
        found = evaluate(model, "deflection_response", **state.values())
        for ours, wanted in (
            (found["q_i_ddot"].ravel(), np.linalg.solve(M_hat, Q_hat)),
            (found["X"].reshape(n, -1), np.linalg.solve(M_hat, B)),
        ):
            np.testing.assert_allclose(ours, wanted, rtol=0, atol=1e-9 * np.abs(wanted).max())


@pytest.mark.parametrize(
    "params", [Params(c=0.5, w=20.0, k_L=1.7, zeta=0.0), Params(c=-0.6, w=15.0, k_L=0.9, zeta=0.07)]
)
def test_amplification_matrix(built_in: Load, params: Params) -> None:
    """Law: where all stiffness is in deflections, a step is one Pade step of degree (5, 5), |R| = 1 or less."""
    model = built_in("two_oscillators")
    scheme = built(model)
    tangent, names = TangentStep(scheme), {"c": params.c, "w": params.w, "k_L": params.k_L, "zeta": params.zeta}
    rest = State(0.0, np.zeros(2), np.zeros(2), np.zeros(0))
    for dt in (0.03 / params.w, 4.0 / params.w, 400.0 / params.w):
        c = scheme.constants(model.constants(model.parameter_vector(names)), dt)
        z = np.asarray(scheme.starter(0.0, rest.q_i, rest.q_i_dot, rest.loop, c)).ravel()
        wanted = pade_of_five(dt * generator(params))
        np.testing.assert_allclose(tangent(z, c)[1], wanted, rtol=0, atol=1e-11 * max(1.0, np.abs(wanted).max()))
        assert radius(wanted) < 1 + 1e-10


@dataclass(frozen=True)
class Case:
    """A scene, t_end and the coarsest of three steps [s], a cap on the error of q_i at the finest, about 1.5 times the
    measured one, bounds of the slope, the start."""

    scene: Callable[[], SceneRecord]
    t_end: float
    dt: float
    cap: float
    slope: tuple[float, float]
    start: str | None = None


CASES = {
    "time-dependent load": Case(SCENES["hub_beam"], 0.8, 4e-2, 1.5e-9, (3.9, 4.2)),
    "loop": Case(SCENES["flexible_slider_crank_free"], 0.008, 2e-4, 1.5e-8, (3.2, 4.8), "quasi_static"),
    "modal damping": Case(SCENES["flexible_slider_crank_torque"], 0.02, 5e-4, 1.5e-11, (3.7, 4.8)),
    "joint spring": Case(SCENES["flexible_joint_arm"], 0.5, 1.25e-3, 1e-12, (3.5, 8.0)),
    "strong damper": Case(SCENES["overdamped_joint"], 0.2, 1e-2, 1.2e-10, (3.8, 4.2)),
    "all links flexible": Case(lambda: chain(3, 2), 0.25, 3e-3, 2.3e-8, (3.5, 4.8)),
    "in space": Case(lambda: spatial_chain(1, 2), 0.05, 6e-4, 2e-10, (3.5, 7.0)),
}


@pytest.mark.parametrize("name", CASES)
def test_order_four(model_of: Build, name: str) -> None:
    """Law: the error of q_i at t_end falls with dt^4; where modes are not resolved yet it falls faster."""
    case = CASES[name]
    model = model_of(case.scene())
    exact = PreparedRuns(model, "dop853", start=case.start).end(case.t_end, case.dt / 64)
    runs, steps = PreparedRuns(model, NAME, start=case.start), [case.dt, case.dt / 2, case.dt / 4]
    errors = [float(np.max(np.abs(runs.end(case.t_end, step) - exact))) for step in steps]
    slope = float(np.polyfit(np.log(steps), np.log(errors), 1)[0])
    assert errors[-1] < case.cap, (slope, errors)
    assert case.slope[0] < slope < case.slope[1], (slope, errors)


def test_slow_coordinates_do_not_feel_unresolved_modes(model_of: Build) -> None:
    """Angles of an arm whose fastest mode turns 29 times a step, against a reference that resolves it."""
    model = model_of(arm(8, 3, 100.0))
    exact = PreparedRuns(model, "dop853").end(0.1, 1e-4)
    error = np.abs(PreparedRuns(model, NAME).end(0.1, 0.1 / 8) - exact)[:8]
    assert error.max() < 1e-5, error.max()


def test_the_limit_is_that_of_the_rest(model_of: Build) -> None:
    """x_S stiff only: x_L oscillates at sqrt(k_L / M_LL), x_S at rest beside it, and sqrt(2) over that is the limit:

    for q'' = -q the stages give |R|^2 = 1 - (2 h^6 - h^8) / 3456.
    """
    params = Params(c=0.5, w=2000.0, k_L=1.7, zeta=0.0)
    M, K, _ = matrices(params)
    limit = limit_beside_deflections(-np.linalg.solve(M, K), np.zeros((2, 2)), np.array([[0.0], [1.0]]), 2**0.5, 2.785)
    assert limit is not None and limit.h == pytest.approx(np.sqrt(2 / params.k_L), rel=1e-5)
    model = model_of(with_stiff(SCENES["two_oscillators"](), "x_S"))
    runs = PreparedRuns(model, NAME, parameters={"c": params.c, "w": params.w, "k_L": params.k_L, "zeta": 0.0})
    amplitudes = [np.abs(runs.samples(limit.h * share, 8000, 8000)["x"][-1]).max() for share in (0.9, 1.2)]
    assert amplitudes[0] < 2 < 1e6 < amplitudes[1]


@pytest.mark.parametrize("scene", [chain(5, 2), spatial_chain(2, 4)], ids=["plane", "space"])
def test_shifted_solutions_along_a_tree(scene: SceneRecord, monkeypatch: pytest.MonkeyPatch) -> None:
    """(M_hat + B (kappa K + delta D) B^T) x = B f for complex shifts and forces, by the dense matrices."""
    monkeypatch.setattr(deflection_kernels, "shorter_than_dense", lambda n, n_s, in_space: True)
    model = on_demand(scene)
    n, (B, K, D), random = len(model.q_i), deflections(model), np.random.default_rng(3)
    for state in random_states(model, 2):
        M_hat = evaluate(model, "condensed", **state.values())["M_hat"].reshape(n, n)
        kappa, delta = complex(*random.uniform(0, 1e-3, 2)), complex(*random.uniform(0, 1e-2, 2))
        f = random.normal(size=len(K)) + 1j * random.normal(size=len(K))
        wanted = np.linalg.solve(M_hat + B @ (kappa * K + delta * D) @ B.T, B @ f)
        shift, push = np.array([kappa.real, kappa.imag, delta.real, delta.imag]), np.concatenate([f.real, f.imag])
        found = evaluate(model, "shifted_solution", **state.values(), shift=shift, push=push)
        x = found["x_re"].ravel() + 1j * found["x_im"].ravel()
        np.testing.assert_allclose(x, wanted, rtol=0, atol=1e-10 * np.abs(wanted).max())


@pytest.mark.parametrize("scene, dt", [(chain(3, 3), 2e-3), (spatial_chain(2, 4), 2e-4)], ids=["plane", "space"])
def test_steps_along_a_tree_are_those_of_the_dense_block(
    scene: SceneRecord, dt: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ten steps of a chain whose links are all flexible and damped, by shifted solutions and by n_s equations."""
    monkeypatch.setattr(deflection_kernels, "shorter_than_dense", lambda n, n_s, in_space: True)
    data = scene.to_dict()
    for body in data["bodies"]:
        body["damping_ratio"] = 0.02
    model = on_demand(SceneRecord.from_dict(data))
    dense = replace(model, builders={k: v for k, v in model.builders.items() if k != "shifted_solution"}, _kernels={})
    ends = [PreparedRuns(one, NAME, engine="interpreted").samples(dt, 10, 10)["x"][-1] for one in (model, dense)]
    assert model.has("shifted_solution") and not dense.has("shifted_solution")
    np.testing.assert_allclose(ends[0], ends[1], rtol=0, atol=1e-12)


def test_price_with_all_links_flexible() -> None:
    """4,200 operations a link with two modes, with 5 of them and for each further one."""
    counts = []
    for links in (5, 7):
        scheme = built(on_demand(chain(links, 2)))
        prepared = prepare(scheme.program(), scheme.layout.size, scheme.c_size)
        counts.append(sum(arithmetic(one) for one in prepared.program.stages()))
    assert counts[0] <= 5 * 4_200 and counts[1] - counts[0] <= 2 * 4_200, counts


def test_price(model_of: Build) -> None:
    """420 operations for each further link of an arm; 1,550 for its three modes."""
    counts = []
    for links in (8, 12):
        stages = built(model_of(arm(links))).program().stages()
        counts.append(sum(arithmetic(stage) for stage in stages))
    assert counts[1] - counts[0] <= 4 * 425
    assert counts[1] <= 12 * 425 + 1_550
