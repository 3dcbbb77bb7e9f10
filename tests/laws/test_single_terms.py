"""Terms that laws of whole mechanisms do not see: each against a formula derived by hand in its docstring."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

from runtime import simulate
from runtime.model import Model
from runtime.operating.mode_solver import State
from runtime.results.stream import StreamFile
from runtime.running.singular.exchange import best_exchange
from runtime.schemes.catalogue import scheme_kind
from runtime.studies.stability.spectra import StepSpectrum
from symgen.joints import JOINTS
from symgen.modes.beam import beam_integrals, exact_bending, exact_stretching
from symgen.scene import Scene, SceneError, SceneRecord
from symgen.schema.expressions import parse_expression
from symgen.system.joint_templates import PlanarMarkers, r_a, r_b, t_a
from tests.hand_derived.spatial import spatial_scenes
from tests.hand_derived.spatial.twin_flexible_nodes import scattered
from tests.support.model_values import evaluate, make_state, random_states, relative_error

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]

# first clamped-free mode of a uniform beam: (b L) with cos(x) cosh(x) = -1, and L w'(L) / w(L) of its shape
ROOT = 1.8751040687119611
SIGMA = (math.cosh(ROOT) + math.cos(ROOT)) / (math.sinh(ROOT) + math.sin(ROOT))
TIP = math.cosh(ROOT) - math.cos(ROOT) - SIGMA * (math.sinh(ROOT) - math.sin(ROOT))
SLOPE = ROOT * (math.sinh(ROOT) + math.sin(ROOT) - SIGMA * (math.cosh(ROOT) - math.cos(ROOT))) / TIP


def clamped(space: str) -> Scene:
    """A beam of 2.5 m (a length that is not 1) clamped to the ground, one mode, rotational damper at its tip."""
    plane: dict[str, Any] = {"lateral": {"ends": "clamped-free", "modes": 1}}
    return (
        Scene("clamped", space=space)
        .beam("b", length=2.5, density=2000, area=1e-4, second_moment=1e-9, youngs_modulus=7e10, **plane)
        .weld("clamp", "ground.origin", "b.start")
        .rotational_spring_damper("damper", "ground.origin", "b.end", stiffness=0.0, damping=0.05)
        .measure("angle", "angle", "b.end")
        .measure("height", "y", "b.end")
        .simulation(t_end=0.1, dt=1e-4, scheme="rk4")
    )


def test_a_rotational_damper_at_the_tip_of_a_beam(model_of: Build) -> None:
    """With w = y(t) w(x) / w(L): modal mass rho A L / 4, rate of the tip's angle (SLOPE / L) y'. So
    y'' + 2 s y' + w0^2 y = 0 with 2 s = d (SLOPE / L)^2 / (rho A L / 4): the slope at a marker is divided by the
    length, and a marker's angular rate has its elastic part."""
    model = model_of(clamped("planar").initial({"b.q1": 1e-4}).build())
    run = simulate(model, t_end=4.0, dt=2e-4, scheme="rk4", seen_every=0.0)
    length, mass = 2.5, 2000 * 1e-4 * 2.5 / 4
    decay = 0.05 * (SLOPE / length) ** 2 / (2 * mass)
    height = run["height"]
    assert run["angle"] / height == pytest.approx(SLOPE / length, rel=1e-3)
    frequency = math.sqrt(7e10 * 1e-9 / (2000 * 1e-4)) * (ROOT / length) ** 2
    envelope = 0.5 * np.log(height**2 + ((np.gradient(height, run.t) + decay * height) / frequency) ** 2)
    assert -np.polyfit(run.t[10:-10], envelope[10:-10], 1)[0] == pytest.approx(decay, rel=5e-3)


@pytest.mark.parametrize("joint", ["prismatic", "revolute"])
@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_joint_damping_acts_on_both_bodies(model_of: Build, joint: str, space: str) -> None:
    """Two free bodies: damping in their joint changes neither their momentum nor their angular momentum."""
    inertia: Any = [0.3, 0.5, 0.4] if space == "spatial" else 0.4
    three = (0,) if space == "spatial" else ()
    builder = Scene("pair", space=space)
    for name, mass in (("a", 2.0), ("b", 3.0)):
        builder.rigid(name, mass=mass, inertia=inertia, free=True, markers={"m": {"position": (0.4, 0.2, *three)}})
    axis = {"axis": (0.0, 1.0, 0.0)} if space == "spatial" and joint == "prismatic" else {}
    builder.rigid("c", mass=1.0, inertia=inertia, markers={"m": {"position": (-0.3, 0.1, *three), **axis}})
    builder.joint(joint, "j", "a.m", "c.m", damping=0.8).weld("w", "c.center", "b.m")
    model = model_of(builder.simulation(t_end=0.1, dt=1e-3, scheme="rk4").build())
    for state in random_states(model, 3):
        values = state.values()
        damped = evaluate(model, "condensed", **values)
        p = model.parameter_vector({"j.damping": 1e-9})
        free = evaluate(model, "condensed", p=p, **values)
        force = damped["Q_hat"] - free["Q_hat"]  # of the damping alone, in q_i
        assert np.abs(force).max() > 1e-3
        shift = np.array([float(name.rpartition(".")[2] == "x") for name in model.q_i])
        assert shift.any()
        # a common translation along x moves R_o of every free body alike: virtual work of inner forces is zero
        assert abs(force @ shift) < 1e-12 * np.abs(force).max()


def test_a_chained_condition_holds_only_where_all_its_parts_do(model_of: Build) -> None:
    """1 N on 2 kg from 0.2 s to 0.5 s: velocity 0.15 m/s at the end, and 0 before."""
    scene = (
        Scene("pulse")
        .rigid("m", mass=2.0, inertia=1.0, free=True)
        .force("f", "m.center", "where(0.2 < t < 0.5, 1, 0)", 0)
        .simulation(t_end=1.0, dt=1e-3, scheme="rk4", seen_every=0.0)
    )
    run = simulate(model_of(scene.build()))
    rate = run.rate("m.x")
    assert abs(rate[run.t < 0.199]).max() == 0.0
    assert rate[-1] == pytest.approx(0.15, abs=1e-3)


@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_forward_dynamics_of_moving_trees_with_driven_joints(model_of: Build, space: str) -> None:
    """O(N) accelerations equal M_hat^-1 Q_hat where the substitutions have accelerations of their own (bias terms):
    at large rates, below a prescribed joint, with a flexible link."""
    axis = {"axis": (0.0, 0.0, 1.0)} if space == "spatial" else {}
    builder = Scene("driven", space=space).gravity(0, -9.81)
    inertia: Any = [0.02, 0.03, 0.04] if space == "spatial" else 0.03
    builder.rigid("base", mass=1.0, inertia=inertia, markers={"end": {"position": (0.7, 0.1)}})
    builder.rigid("mid", mass=0.5, inertia=inertia, markers={"end": {"position": (0.4, -0.2)}})
    bending: Any = {"lateral": {"ends": "clamped-free", "modes": 2}}
    if space == "spatial":
        bending |= {"second_moment_z": 2e-9, "lateral_z": {"ends": "clamped-free", "modes": 1}}
    builder.beam("tip", length=0.8, density=2000, area=1e-4, second_moment=1e-9, youngs_modulus=7e10, **bending)
    builder.ground(markers={"pin": {"position": (0.3, 0.2), **axis}})
    builder.prescribed_angle("drive", "ground.pin", "base.origin", "3*t + sin(5*t)")
    builder.revolute("pin", "ground.pin", "base.origin") if space == "planar" else None
    builder.revolute("knee", "base.end", "mid.origin").revolute("wrist", "mid.end", "tip.start")
    model = model_of(builder.simulation(t_end=0.1, dt=1e-3, scheme="rk4").build())
    assert model.has("forward_dynamics")
    for state in random_states(model, 4, rate=8.0):
        condensed = evaluate(model, "condensed", **state.values())
        expected = np.linalg.solve(condensed["M_hat"], condensed["Q_hat"])
        found = evaluate(model, "forward_dynamics", **state.values())["q_i_ddot"]
        assert relative_error(found, expected) < 1e-10


@pytest.mark.parametrize("scheme", ["printed", "coupled"])
def test_clock_of_three_groups(model_of: Build, scheme: str) -> None:
    """Each group is driven by its own force at its own frequency, nothing couples them: x'' = sin(w t), from rest,
    x = t / w - sin(w t) / w^2. A clock that is wrong in one group shows in that group's phase."""
    rates = {"a": 2.0, "b": 5.0, "c": 11.0}
    builder = Scene("clocks").structure(
        coordinates=list(rates),
        mass=np.eye(3),
        stiffness=np.zeros((3, 3)),
        force=[f"sin({rate}*t)" for rate in rates.values()],
    )
    builder.groups(A=["a"], B=["b"], C=["c"]).simulation(t_end=2.0, dt=0.01, m=[2, 3], scheme=scheme)
    model = model_of(builder.build())
    errors = []
    for dt in (0.01, 0.005):
        run = simulate(model, dt=dt, m=[2, 3], scheme=scheme, seen_every=0.0)
        exact = {name: run.t / rate - np.sin(rate * run.t) / rate**2 for name, rate in rates.items()}
        errors.append([abs(run[name] - exact[name]).max() for name in rates])
    finest = np.array([0.005, 0.0025, 0.005 / 6])  # step of each group
    assert np.all(np.array(errors[1]) < 0.5 * finest**2 * np.array(list(rates.values())) + 1e-5)
    assert np.all(np.log2(np.array(errors[0]) / np.array(errors[1])) > 1.9)


def test_second_order_integrals_of_a_flexible_body_in_space(model_of: Build) -> None:
    """phi_phi[a][b] = int Phi_a Phi_b^T dm is not symmetric. Kinetic energy of mass points with any modes, turning
    about the world's axes: T = 1/2 sum m |omega x (rho0 + Phi q) + Phi q'|^2, at omega along each axis."""
    nodes = scattered(7, 3, seed=5)
    scene = Scene("cloud", space="spatial").flexible("b", **spatial_scenes.flexible(nodes), free=True)
    model = model_of(scene.simulation(t_end=0.1, dt=1e-3, scheme="rk4").build())
    rng = np.random.default_rng(3)
    q_f, q_f_dot = rng.normal(size=3), rng.normal(size=3)
    for omega in (*np.eye(3), rng.normal(size=3)):
        values = dict.fromkeys([*model.coordinates, *model.q_i], 0.0)
        rates = dict(values)
        values.update({"b.e0": 1.0, **{f"b.q{k + 1}": q_f[k] for k in range(3)}})
        rates.update({f"b.turn_{axis}": omega[k] for k, axis in enumerate("xyz")})
        rates.update({f"b.q{k + 1}": q_f_dot[k] for k in range(3)})
        q_i = np.array([values[name] for name in model.q_i])
        q_i_dot = np.array([rates[name] for name in model.q_i])
        guess = np.array([values[name] for name in model.coordinates])
        state = make_state(model, q_i, q_i_dot, guess=guess)
        position = nodes.places(q_f)
        velocity = np.cross(omega, position) + nodes.drift(q_f_dot)
        expected = 0.5 * np.sum(nodes.masses[:, None] * velocity**2)
        found = evaluate(model, "energy", **state.values())
        assert float(found["kinetic"][0]) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("kept", [0, 1, 3, 5])
def test_a_stream_is_cut_where_it_is_told(kept: int, tmp_path: Path) -> None:
    table = StreamFile(tmp_path / "rows", [("t", ()), ("x", (2,))])
    rows = np.arange(15.0).reshape(5, 3)
    table.append(rows)
    table.keep(kept)
    assert table.rows == kept
    assert (tmp_path / "rows" / "samples.bin").stat().st_size == kept * 3 * 8
    table.append(rows[:1])
    np.testing.assert_array_equal(table.all_rows(), np.concatenate([rows[:kept], rows[:1]]))
    table.close()


@pytest.mark.parametrize("m", [2, 4])
def test_growth_of_a_stability_study_is_that_of_the_multipliers(built_in: Callable[[str], Model], m: int) -> None:
    """Undamped oscillators: exact multipliers have modulus one, so the growth is log(radius) / dt, no less."""
    model, dt = built_in("two_oscillators"), 2e-3
    c = model.constants(model.parameter_vector({"zeta": 0.0}))
    scheme = scheme_kind("printed").build("printed", model, dt, [m], {"common_update": "direct"})
    found = StepSpectrum(model, scheme, c)(State(0.0, np.zeros(2), np.zeros(2), np.zeros(0)), dt)
    assert found.radius > 1.0
    assert found.growth.max() == pytest.approx(math.log(found.radius) / dt, rel=1e-6)


def slider_crank_of_size(size: float) -> SceneRecord:
    """Lengths by a factor; the start is at 70 degrees of the crank."""
    inertia, at = 1e-3 * size**2, math.radians(70)
    lean = -math.asin(math.sin(at) / 2)
    builder = Scene("sized")
    builder.rigid("crank", mass=0.4, inertia=inertia, markers={"tip": {"position": (0.15 * size, 0)}})
    builder.rigid("rod", mass=0.2, inertia=inertia, markers={"tip": {"position": (0.3 * size, 0)}})
    builder.rigid("slider", mass=0.1, inertia=inertia)
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.origin")
    builder.prismatic("slide", "ground.origin", "slider.origin").revolute("C", "rod.tip", "slider.origin")
    builder.independent("crank.theta").initial({"crank.theta": at, "rod.theta": lean})
    return builder.simulation(t_end=0.1, dt=1e-3, scheme="single_rate").build()


def test_the_choice_of_an_exchange_does_not_depend_on_the_unit_of_length(model_of: Build) -> None:
    """A mechanism a hundred times larger or smaller is the same mechanism: same exchange, same gain. The slider's
    travel against the crank's angle counts r sin(phi) (1 + cos(phi) / sqrt(4 - sin(phi)^2)) over the length."""
    found = []
    for size in (0.01, 1.0, 100.0):
        model = model_of(slider_crank_of_size(size))
        state = make_state(model, model.initial_q[model.independent_columns], np.zeros(1))
        C_q = evaluate(model, "constraints", **state.values())["C_q"]
        found.append(best_exchange(model, state.q, C_q.reshape(len(model.constraints), -1)))
    assert found[0] is not None
    assert all(other is not None and (other.out, other.into) == (found[0].out, found[0].into) for other in found)
    assert [other.gain for other in found if other] == pytest.approx([found[0].gain] * 3, rel=1e-9)


def test_a_slide_measures_across_and_along() -> None:
    """b = a + s t + w n with t at angle phi, n at phi + 90 degrees: w across, s along."""
    phi, a, s, w = 0.7, (0.3, -0.2), 1.3, 0.4
    t, n = (math.cos(phi), math.sin(phi)), (-math.sin(phi), math.cos(phi))
    values = dict(zip((*r_a, *t_a), (*a, *t), strict=True))
    values |= dict(zip(r_b, (a[k] + s * t[k] + w * n[k] for k in range(2)), strict=True))
    across, along = (
        JOINTS[joint].rows_in_plane(PlanarMarkers(None))[0].C for joint in ("point_on_line", "prescribed_displacement")
    )
    assert float(across.subs(values)) == pytest.approx(w)
    assert float(along.subs({**values, sp.Symbol("f"): 0.0})) == pytest.approx(s)


def test_sections_of_a_beam_in_space_stay_across_it() -> None:
    """d(shape)/dx = turn x e_x: a deflection along y turns about z by its slope, one along z about -y."""
    beam = beam_integrals(
        (
            (0, exact_stretching("fixed-free", 1)),
            (1, exact_bending("clamped-free", 2)),
            (2, exact_bending("pinned-pinned", 1)),
        )
    )
    h = 1e-6
    for at in (0.31, 0.77):
        slope = (beam.point(at + h).shape - beam.point(at - h).shape) / (2 * h)
        across = np.cross(beam.point(at).turn.T, [1.0, 0.0, 0.0]).T
        assert np.abs(across[1:]).max(axis=1).min() > 0.1
        assert across[1:] == pytest.approx(slope[1:], abs=1e-6) and np.all(across[0] == 0)


@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_weight_is_the_slope_of_its_potential(model_of: Build, space: str) -> None:
    """A free body of 2 kg, centre of mass aside, gravity (3, -4[, 5]): -dU/dq = Q, and U = -m g . r of the centre."""
    three, inertia = (space == "spatial"), 0.3
    off, g = (0.2, -0.1, 0.3)[: 2 + three], (3.0, -4.0, 5.0)[: 2 + three]
    moments: Any = [inertia] * 3 if three else inertia
    builder = Scene("thrown", space=space).gravity(*g)
    builder.rigid("m", mass=2.0, inertia=moments, center_of_mass=off, free=True)
    for axis in "xyz"[: 2 + three]:
        builder.measure(axis, axis, "m.center")
    model = model_of(builder.simulation(t_end=0.1, dt=0.01, scheme="printed").build())
    c = model.constants(model.parameter_vector())
    at = random_states(model, 1, rate=0.0)[0]

    def potential(q: np.ndarray) -> float:
        return float(model.evaluate("energy", q=q, q_dot=0 * q, t=0.0, c=c)["potential"])

    force = evaluate(model, "condensed", **at.values())["Q_hat"]
    moved = [name for name in model.q_i if name in ("m.x", "m.y", "m.z", "m.theta")]
    for name in moved:
        row, k = model.q_i.index(name), model.coordinates.index(name)
        step = 1e-5 * np.eye(len(at.q))[k]
        assert force[row] == pytest.approx((potential(at.q - step) - potential(at.q + step)) / 2e-5, abs=1e-7)
    x = at.q[[model.coordinates.index(f"m.{axis}") for axis in "xyz"[: 2 + three]]]
    straight = model.initial_q.copy()
    straight[: len(x)] = x
    assert potential(straight) == pytest.approx(-2.0 * np.dot(g, x + off))


def test_the_distance_between_two_points_of_a_plane(model_of: Build) -> None:
    """3 along x and 4 along y: 5."""
    builder = Scene("apart").rigid("m", mass=1.0, inertia=1.0, free=True).initial({"m.x": 3.0, "m.y": 4.0})
    model = model_of(
        builder.measure("gap", "distance", "m.origin").simulation(t_end=0.1, dt=0.01, scheme="printed").build()
    )
    at = random_states(model, 1, rigid=0.0, rate=0.0)[0]
    c = model.constants(model.parameter_vector())
    found = model.evaluate("measures", q=at.q, q_dot=at.q_dot, t=0.0, c=c)
    assert float(np.ravel(np.asarray(found["measures"]))[model.measures.index("gap")]) == pytest.approx(5.0)


def test_the_axis_of_x_is_across_that_of_the_joint() -> None:
    """In the plane of x and y too: (2, 2, 0) is along (1, 1, 0)."""
    for x_axis, fine in (((2.0, 2.0, 0.0), False), ((1.0, -1.0, 0.0), True)):
        builder = Scene("axes", space="spatial").rigid("m", mass=1, inertia=[1, 1, 1])
        builder.ground(markers={"pin": {"axis": (1.0, 1.0, 0.0), "x_axis": x_axis}})
        builder.revolute("hinge", "ground.pin", "m.origin")
        if fine:
            builder.build()
        else:
            with pytest.raises(SceneError, match="along the axis"):
                builder.build()


def test_the_largest_of_twenty_is_the_limit() -> None:
    for name in ("min", "max"):
        parse_expression(f"{name}({', '.join(map(str, range(20)))})", frozenset(), "item")
        with pytest.raises(SceneError, match="20"):
            parse_expression(f"{name}({', '.join(map(str, range(21)))})", frozenset(), "item")
