"""Large trees: what crosses between slow and fast coordinates, its price, and schemes that are built on it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import casadi as ca
import numpy as np
import pytest
from numpy.polynomial import Polynomial

from runtime.contract.model import Model
from runtime.contract.tape import arithmetic
from runtime.engine.prepare import prepare
from runtime.schemes import decoupled
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.step_limit import slow_decay_limit
from symgen.generate import model_of as on_demand
from symgen.pipeline import derive
from symgen.scene import Scene, SceneRecord
from symgen.scenes import SCENES
from symgen.scenes.arm import arm
from symgen.scenes.chain import chain
from symgen.scenes.spatial_arm import spatial_arm
from tests.support.model_values import evaluate, random_states
from tests.support.prepared_runs import PreparedRuns

Build = Callable[[SceneRecord], Model]
KERNELS = {"slow_response", "fast_rows", "trunk_response", "branch_motion"}


def crowded_arm() -> SceneRecord:
    """Seven links in space, two of them flexible: a driven hinge between, a link aside, a spring and damper."""
    builder = Scene("crowded_arm", space="spatial").gravity(0.0, 0.3, -9.81)
    turned = [{"axis": [0, 1, 0], "x_axis": [1, 0, 0]}, {"axis": [0, 0, 1], "x_axis": [1, 0, 0]}]
    builder.ground(markers={"far": turned[0]})
    mode, body = {"ends": "clamped-free", "modes": 1}, {"mass": 0.3, "inertia": [1e-3, 6e-3, 6e-3]}
    before = "ground"
    for k in range(7):
        here, there, link = turned[k % 2], turned[(k + 1) % 2], f"link{k}"
        if k in (2, 6):
            ends = {"near": {"at": 0.0, **here}, "far": {"at": 0.5, **there}}
            builder.beam(
                link, length=0.5, density=7800.0, area=2e-5, second_moment=1e-11, second_moment_z=2e-11,
                youngs_modulus=2e11, lateral=mode, lateral_z=mode, markers=ends,
            )  # fmt: skip
        else:
            ends = {"near": here, "far": {"position": [0.5, 0, 0], **there}}
            builder.rigid(link, **body, center_of_mass=[0.25, 0, 0], markers=ends)
        builder.revolute(f"hinge{k}", f"{before}.far", f"{link}.near")
        before = link
    builder.rigid("aside", **body, center_of_mass=[0.1, 0.02, 0], markers={"near": turned[1]})
    builder.revolute("hinge7", "link0.far", "aside.near")
    builder.prescribed_angle("drive", "link4.far", "link5.near", motion="0.3 * sin(4 * t)")
    builder.spring_damper("rope", "ground.origin", "link6.far", stiffness=50.0, damping=0.3, free_length=0.5)
    builder.groups(L=["hinge*.angle"], S=["link*.q*"])
    return builder.simulation(t_end=0.1, dt=1e-4, m=[4], scheme="decoupled").build()


@pytest.mark.parametrize(
    "scene",
    [arm(8), chain(4, 2), spatial_arm(5), crowded_arm()],
    ids=["arm", "chain of flexible links", "in space", "two flexible links in space"],
)
def test_slow_response_and_fast_rows_are_those_of_the_condensed_equations(scene: SceneRecord) -> None:
    """(39): y'' = M_LL^-1 Q_L, N = M_LL^-1 M_LS; the rows of q_S are M_SS - M_SL N and Q_S - M_SL y''."""
    model = on_demand(scene)
    L, S = (group.positions for group in model.groups)
    n = len(model.q_i)
    for state in random_states(model, 2):
        condensed = evaluate(model, "condensed", **state.values())
        M_hat, Q_hat = condensed["M_hat"].reshape(n, n), condensed["Q_hat"].ravel()
        N = np.linalg.solve(M_hat[np.ix_(L, L)], M_hat[np.ix_(L, S)])
        y_ddot = np.linalg.solve(M_hat[np.ix_(L, L)], Q_hat[L])
        found = evaluate(model, "slow_response", **state.values())
        np.testing.assert_allclose(found["y_ddot"].ravel(), y_ddot, rtol=0, atol=1e-9 * np.abs(y_ddot).max())
        np.testing.assert_allclose(found["N"].reshape(len(L), len(S)), N, rtol=0, atol=1e-10 * np.abs(N).max())
        rows = evaluate(model, "fast_rows", **state.values(), crossing=found["crossing"].ravel())
        M_SL = M_hat[np.ix_(S, L)]
        M_bar, force = M_hat[np.ix_(S, S)] - M_SL @ N, Q_hat[S] - M_SL @ y_ddot
        np.testing.assert_allclose(
            rows["M_bar_SS"].reshape(len(S), len(S)), M_bar, rtol=0, atol=1e-10 * np.abs(M_bar).max()
        )
        np.testing.assert_allclose(rows["rhs_S"].ravel(), force, rtol=0, atol=1e-9 * np.abs(force).max())


@pytest.mark.parametrize("build", [lambda: arm(8), lambda: carrying_arm()], ids=["arm", "payload and damper"])
def test_branches_on_the_response_of_the_trunk_move_as_the_condensed_equations_say(
    model_of: Build, build: Callable[[], SceneRecord]
) -> None:
    """(38): q_i'' = M_hat^-1 Q_hat, of the trunk by a_T + X phi, of the branches alone."""
    model = model_of(build())
    L, S = (group.positions for group in model.groups)
    n = len(model.q_i)
    for state in random_states(model, 2):
        condensed = evaluate(model, "condensed", **state.values())
        a = np.linalg.solve(condensed["M_hat"].reshape(n, n), condensed["Q_hat"].ravel())
        trunk = evaluate(model, "trunk_response", **state.values())
        branch = evaluate(model, "branch_motion", **state.values(), interface=trunk["interface"].ravel())
        a_L = trunk["trunk_ddot"].ravel() + trunk["X_trunk"].reshape(len(L), -1) @ branch["phi"].ravel()
        scale = 1e-9 * np.abs(a).max()
        np.testing.assert_allclose(a_L + branch["branch_ddot"].ravel(), a[L], rtol=0, atol=scale)
        np.testing.assert_allclose(branch["q_S_ddot"].ravel(), a[S], rtol=0, atol=scale)


def carrying_arm() -> SceneRecord:
    """An arm whose flexible link carries a rigid body on a hinge and is held by a spring and a damper at its start."""
    data = arm(8).to_dict()
    data["bodies"].append(
        {"type": "rigid", "name": "payload", "mass": 0.2, "inertia": 0.01, "center_of_mass": (0.1, 0)}
    )
    data["joints"].append({"type": "revolute", "name": "grip", "marker_a": "link8.end", "marker_b": "payload.origin"})
    data["partition"]["groups"][0]["coordinates"].append("payload.theta")
    data["loads"] = [
        {
            "type": "rotational_spring_damper",
            "name": "gear",
            "marker_a": "link7.end",
            "marker_b": "link8.start",
            "stiffness": 2.0,
            "damping": 0.002,
        }
    ]
    return SceneRecord.from_dict(data)


def test_scenes_without_a_large_tree_in_two_groups_have_no_such_kernels() -> None:
    for name in ("hub_beam", "flexible_slider_crank_free", "chain"):
        assert not KERNELS & derive(SCENES[name]()).tapes.keys()


def test_sub_steps_cost_the_same_whatever_the_mechanism(model_of: Build) -> None:
    """`decoupled`, `coupled` and `printed` on arms: holds grow by 137 operations a link, sub-steps not at all."""
    held = {"common_update": "direct", "slow_interpolation": "held_at_the_middle"}
    still = {"slow_accelerations": "held"}
    counts: dict[str, list[dict[str, int]]] = {"decoupled": [], "coupled": [], "printed": [], "still": []}
    kinds = {"still": "decoupled"}
    for links in (8, 12):
        for name, options in (("decoupled", {}), ("coupled", {}), ("printed", held), ("still", still)):
            scheme = scheme_kind(kinds.get(name, name)).build(
                kinds.get(name, name), model_of(arm(links)), 1.0, [8], options
            )
            prepared = prepare(scheme.program(), scheme.layout.size, scheme.c_size)
            counts[name].append({stage.name(): arithmetic(stage) for stage in prepared.program.stages()})
    most = {"decoupled": ("sub_step_1", 60), "coupled": ("sub_step_1", 110), "printed": ("sub_step_2_1", 40)}
    for name, (sub_step, most_operations) in most.items():
        small, large = counts[name]
        assert small[sub_step] == large[sub_step] <= most_operations
    small, large = counts["decoupled"]
    assert large["hold_1"] - small["hold_1"] == 4 * 137 and small["hold_1"] <= 1140  # 5524 at 40 links
    assert large["finish"] - small["finish"] == 4 * 30 and small["finish"] <= 255
    small, large = ({"hold": sum(one.values()) - one["sub_step_1"]} for one in counts["coupled"])
    assert large["hold"] - small["hold"] <= 4 * 135 and small["hold"] <= 1220
    small, large = counts["still"]
    assert large["hold_1"] - small["hold_1"] <= 4 * 137 and small["hold_1"] <= 1141
    small, large = counts["printed"]
    assert large["common_update"] - small["common_update"] <= 4 * 80


def test_sub_steps_in_space_cost_the_same_whatever_the_mechanism() -> None:
    """`decoupled` on arms with hinges about two axes: 181 operations a sub-step, and order 2."""
    counts, models = [], [on_demand(spatial_arm(links)) for links in (5, 8)]
    for model in models:
        scheme = scheme_kind("decoupled").build("decoupled", model, 1.0, [8], {})
        prepared = prepare(scheme.program(), scheme.layout.size, scheme.c_size)
        counts.append({stage.name(): arithmetic(stage) for stage in prepared.program.stages()})
    assert counts[0]["sub_step_1"] == counts[1]["sub_step_1"] <= 185
    assert counts[1]["hold_1"] <= 8 * 500
    exact, runs = PreparedRuns(models[0], "dop853").end(0.1, 2e-4), PreparedRuns(models[0], "decoupled", [8])
    errors = [float(np.abs(runs.end(0.1, step) - exact)[:5].max()) for step in (2e-3, 1e-3)]
    assert errors[1] < 1.8e-6 and 1.8 < np.log2(errors[0] / errors[1]) < 2.4, errors


@pytest.mark.parametrize(
    "scheme, options, cap", [("decoupled", {"slow_accelerations": "held"}, 1e-6), ("coupled", {}, 6e-7)]
)
def test_sub_steps_of_a_large_tree_are_second_order(
    model_of: Build, scheme: str, options: dict[str, str], cap: float
) -> None:
    """Slope and cap on an arm of 8 links: the major step resolves its first mode only."""
    model = model_of(arm(8))
    exact = PreparedRuns(model, "dop853").end(0.1, 2e-4)
    runs = PreparedRuns(model, scheme, [8], options)
    steps = [2e-3, 1e-3, 5e-4]
    errors = [float(np.max(np.abs(runs.end(0.1, step) - exact)[:8])) for step in steps]
    assert float(np.polyfit(np.log(steps), np.log(errors), 1)[0]) == pytest.approx(2.0, abs=0.15), errors
    assert errors[-1] < cap, errors


def test_cubic_slow_accelerations_are_worth_twenty_of_held_ones(model_of: Build) -> None:
    """Link angles of the arm of 8 links, thrown: what is left of second order is that of the sub-steps."""
    model, largest = model_of(arm(8)), []
    rates = np.array([2 * np.cos(int(name[4]) - 1) if "theta" in name else 0.0 for name in model.coordinates])

    def thrown(scheme: str, m: list[int] | None = None, word: str = "") -> PreparedRuns:
        runs = PreparedRuns(model, scheme, m, {"slow_accelerations": word} if word else {})
        runs.state = replace(runs.state, q_dot=rates)
        return runs

    exact = thrown("dop853").end(0.1, 2e-4)
    for word in ("held", "cubic"):
        errors = [np.abs(thrown("decoupled", [8], word).end(0.1, dt) - exact)[:8].max() for dt in (2e-3, 1e-3)]
        largest.append(max(error / dt**2 for error, dt in zip(errors, (2e-3, 1e-3), strict=True)))
    assert largest[0] > 20 * largest[1] and largest[1] < 0.12, largest


@pytest.mark.parametrize("reach", [0.2, 0.4])
def test_cubic_slow_accelerations_are_of_fourth_order(model_of: Build, reach: float) -> None:
    """Law: a slow mode, the fast one at rest beside it, loses (w H)^6 / 700 a step, and (w H)^5 / 51 of its phase."""
    model = model_of(SCENES["two_oscillators"]())
    runs = PreparedRuns(model, "decoupled", [64], parameters={"c": 0.0, "w": 2.0, "k_L": 1.0, "zeta": 0.0})
    k, steps = model.q_i.index("x_L"), 40
    x, v = (runs.samples(reach, steps, 1)[name][:, k] for name in ("x", "v"))
    turned = np.unwrap(np.arctan2(-v, x))
    decay, late = np.log(np.hypot(x, v)), turned - turned[0] - reach * np.arange(steps + 1)
    assert 0 < (decay[10] - decay[-1]) / (steps - 10) < reach**6 / 100
    assert abs(late[-1]) < steps * reach**5 / 30 + reach**4 / 20, late[-1]


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_values_in_middles_move_polynomials_exactly(count: int) -> None:
    """Law: y'' = s^p, p < count, from rest at -1/2: y' and y are its integrals, at the middle and at the end."""
    for first, end in ((0, 0.5), (-1, 0.0)):
        for power in range(count):
            values = [ca.SX(float(first - k) ** power) for k in range(count)]
            x, v = (float(one) for one in decoupled.moved(values, first, end, ca.SX(2.0)))
            rate = Polynomial([0.0] * power + [1.0]).integ(lbnd=-0.5)
            assert v == pytest.approx(2 * rate(end), abs=1e-13)
            assert x == pytest.approx(4 * rate.integ(lbnd=-0.5)(end), abs=1e-13)


def test_held_slow_velocities_change_what_is_of_second_order(model_of: Build) -> None:
    """Both ways of `coupled` differ by a part of the error, which falls with it."""
    model, far = model_of(carrying_arm()), []
    for dt in (1e-3, 2.5e-4):
        ends = [
            PreparedRuns(model, "coupled", [10], {"slow_velocity": word}).end(0.06, dt) for word in ("auto", "followed")
        ]
        far.append(np.abs(ends[0] - ends[1]).max())
    assert 0 < far[1] < 1e-7 and 6 < far[0] / far[1] < 40, far


@pytest.mark.parametrize("m", [2, 10])
def test_held_slow_velocities_are_stable_up_to_the_limit(m: int) -> None:
    """v <- v - H d (3 v - v_last) / 2 has a multiplier -1 at the limit for h = H / m and decays below it."""
    d = 7.0
    limit = slow_decay_limit(np.diag([-d, -1.0, -900.0]), [0, 1], m)
    assert limit is not None and limit.by_decay and limit.rate == pytest.approx(d)
    for share, stable in ((0.99, True), (1.01, False)):
        x = share * limit.h * m * d
        assert (np.abs(np.linalg.eigvals(np.array([[1 - 1.5 * x, x / 2], [1.0, 0.0]]))).max() < 1) == stable
