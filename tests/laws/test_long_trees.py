"""Long chains: accelerations against the articulated-body recursion, written here from Featherstone's book; energy.

R. Featherstone, Rigid Body Dynamics Algorithms, Springer, 2008, chapter 7. In a plane, of links that hang one on the
other: with R_O absolute, link k turns by theta_k about the end of link k - 1; spatial vectors (angular, x, y) about the
joint of each link, in the directions of the ground.
"""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from runtime.contract.tape import as_function
from runtime.model import Model
from symgen import Scene, SceneError
from symgen.kernels.kernel import Kernel
from symgen.tapes.hoisting import unhoisted

LENGTH, MASS, INERTIA, GRAVITY = 0.4, 0.7, 0.05, 9.81


def chain(links: int) -> Scene:
    """Uniform links of which each hangs on the end of the one before."""
    scene, previous = Scene("long_chain").gravity(0, -GRAVITY), "ground.origin"
    for k in range(links):
        scene.rigid(
            f"b{k}",
            mass=MASS,
            inertia=INERTIA,
            center_of_mass=(LENGTH / 2, 0),
            markers={"end": {"position": (LENGTH, 0)}},
        ).revolute(f"j{k}", previous, f"b{k}.origin")
        previous = f"b{k}.end"
    return scene


def recursion(theta: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """theta'' (n,) of absolute angles by the articulated-body algorithm; velocities and gravity are in the biases."""
    n = len(theta)
    arms = LENGTH * np.stack([np.cos(theta), np.sin(theta)], axis=1)  # from joint to joint
    S = np.array([1.0, 0.0, 0.0])
    articulated, bias = np.zeros((n, 3, 3)), np.zeros((n, 3))
    for k in range(n):
        x, y = arms[k] / 2
        articulated[k] = np.array(
            [[INERTIA + MASS * (x * x + y * y), -MASS * y, MASS * x], [-MASS * y, MASS, 0], [MASS * x, 0, MASS]]
        )
        pull = -MASS * rate[k] ** 2 * arms[k] / 2 + np.array([0.0, MASS * GRAVITY])  # force = M a + this
        bias[k] = np.array([x * pull[1] - y * pull[0], *pull])
    D, u, lean = np.zeros(n), np.zeros(n), np.zeros((n, 3))
    for k in range(n - 1, -1, -1):
        lean[k], D[k], u[k] = articulated[k] @ S, S @ articulated[k] @ S, -S @ bias[k]
        if k == 0:
            break
        # what link k asks of the end of link k - 1, whose absolute turning it does not take: moments stay there
        left = articulated[k] - np.outer(lean[k], lean[k]) / D[k]
        force = bias[k] + lean[k] * u[k] / D[k]
        x, y = arms[k - 1]
        carry = np.array(
            [[1.0, 0.0, 0.0], [-y, 1.0, 0.0], [x, 0.0, 1.0]]
        )  # acceleration of the end, by that at the joint
        carry[0, 0] = 0.0  # angles are absolute: a link does not turn with the one before
        turning = np.array([0.0, *(-(rate[k - 1] ** 2) * arms[k - 1])])
        articulated[k - 1] += carry.T @ left @ carry
        bias[k - 1] += carry.T @ (force + left @ turning)
    found, a = np.zeros(n), np.zeros(3)
    for k in range(n):
        found[k] = (u[k] - lean[k] @ a) / D[k]
        x, y = arms[k]
        at_joint = a[1:]
        end = at_joint + found[k] * np.array([-y, x]) - rate[k] ** 2 * arms[k]
        a = np.array([0.0, *end])
    return found


def accelerations(model: Model, theta: np.ndarray, rate: np.ndarray) -> np.ndarray:
    c = model.constants(model.parameter_vector())
    found = model.evaluate("forward_dynamics", q_i=theta, q_i_dot=rate, c=c, q_d=0, q_d_dot=0, t=0)["q_i_ddot"]
    return np.asarray(found).ravel()


def test_the_recursion_is_right_for_two_links() -> None:
    """Lagrange's equations of a double pendulum of rods with absolute angles, solved as a full system."""
    theta, rate = np.array([0.3, -1.1]), np.array([2.0, -0.7])
    d = theta[0] - theta[1]
    coupling = MASS * LENGTH**2 / 2
    M = np.array(
        [
            [INERTIA + MASS * LENGTH**2 * 1.25, coupling * np.cos(d)],
            [coupling * np.cos(d), INERTIA + MASS * LENGTH**2 / 4],
        ]
    )
    weight = MASS * GRAVITY * LENGTH * np.array([1.5 * np.cos(theta[0]), 0.5 * np.cos(theta[1])])
    Q = -weight + coupling * np.sin(d) * np.array([-(rate[1] ** 2), rate[0] ** 2])
    assert np.allclose(recursion(theta, rate), np.linalg.solve(M, Q), rtol=1e-13)


@pytest.mark.parametrize("links", [30, pytest.param(150, marks=pytest.mark.long)])
def test_accelerations_are_those_of_the_recursion(links: int) -> None:
    rng = np.random.default_rng(links)
    theta, rate = rng.uniform(-1.5, 1.5, links), rng.uniform(-1, 1, links)
    model = chain(links).model()
    expected = recursion(theta, rate)
    assert np.abs(accelerations(model, theta, rate) - expected).max() <= 1e-10 * np.abs(expected).max()


@pytest.mark.long
def test_a_long_chain_keeps_its_energy() -> None:
    links = 120
    model = chain(links).initial({f"b{k}.theta": -1.2 for k in range(links)}).model()
    run = model.simulate(scheme="rk4", t_end=0.1, dt=5e-4, samples=10)
    energy = sum(run.energy[kind] for kind in ("kinetic", "potential"))
    assert run.status.name == "completed"
    assert np.abs(energy - energy[0]).max() <= 1e-8 * MASS * GRAVITY * LENGTH * links**2


def test_scenes_too_large_say_what_they_would_take() -> None:
    with pytest.raises(SceneError, match=r"6300 coordinates, more than 6000: .*full matrix, alone \d+ MB"):
        chain(2100).build()


def test_sums_as_deep_as_long_chains_have_are_derived() -> None:
    x, p = ca.SX.sym("x", 3000), ca.SX.sym("p")
    deep = x[0]
    for k in range(1, 3000):
        deep = deep + x[k]
    tape = unhoisted(Kernel({"x": x}, {"y": -deep}), p)
    values = np.random.default_rng(0).uniform(-1, 1, 3000)
    found = as_function("y", tape).call([ca.DM(values)])
    assert abs(float(found[0]) + values.sum()) <= 1e-11


def test_a_long_chain_is_assembled_and_its_matrix_of_constraints_is_right() -> None:
    """R_k - R_(k-1) - A(theta_(k-1)) (L, 0) = 0, and its slopes, by hand; more than 90 % of C_q is zero."""
    links = 120
    angles = np.random.default_rng(4).uniform(-1.5, 1.5, links)
    model = chain(links).initial({f"b{k}.theta": float(one) for k, one in enumerate(angles)}).model()
    x, y, theta = model.initial_q.reshape(links, 3).T
    arms = LENGTH * np.stack([np.cos(angles), np.sin(angles)])
    assert np.array_equal(theta, angles)
    assert np.abs(np.stack([x, y])[:, 1:] - np.cumsum(arms, axis=1)[:, :-1]).max() < 1e-12
    wanted = np.zeros((2 * links, 3 * links))
    for k in range(links):
        wanted[[2 * k, 2 * k + 1], [3 * k, 3 * k + 1]] = 1.0
        if k:
            wanted[[2 * k, 2 * k + 1], [3 * k - 3, 3 * k - 2]] = -1.0
            wanted[[2 * k, 2 * k + 1], 3 * k - 1] = arms[1, k - 1], -arms[0, k - 1]
    c = model.constants(model.parameter_vector())
    found = model.evaluate("constraints", q=model.initial_q, q_dot=0 * model.initial_q, t=0.0, c=c)
    signs = np.sign(np.asarray(found["C_q"])[range(2 * links), np.tile([0, 1], links) + 3 * np.repeat(range(links), 2)])
    assert np.abs(signs[:, None] * np.asarray(found["C_q"]) - wanted).max() < 1e-14
    assert np.abs(np.asarray(found["C"])).max() < 1e-12


def test_rows_that_depend_on_each_other_do_not_stop_the_assembly_of_a_long_chain() -> None:
    """The last link hangs on the one before by two hinges at one place: a row more of each kind than there are."""
    links = 110
    scene = chain(links).revolute("again", f"b{links - 2}.end", f"b{links - 1}.origin")
    model = scene.initial({f"b{k}.theta": 0.02 * k for k in range(links)}).model()
    x, y, theta = model.initial_q.reshape(links, 3).T
    arms = LENGTH * np.stack([np.cos(theta), np.sin(theta)])
    assert np.abs(np.diff(np.stack([x, y])) - arms[:, :-1]).max() < 1e-12
    assert len(model.redundant) == 2
