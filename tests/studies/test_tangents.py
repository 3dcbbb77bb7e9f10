"""The amplification matrix is that of the step that runs: iterations at their fixed point, no memory that is none."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import SCHEMES, simulate
from runtime.model import Model
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import Stepper
from runtime.start.start_state import start_state
from runtime.studies.stability.chart import StabilityStudy, stability_chart, states_along
from runtime.studies.stability.spectra import ExactMotion, TangentStep
from symgen.scene import SceneRecord
from tests.support.model_values import Array

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]

# a double pendulum in motion, its torque a function of time; one group of coordinates
ARM = """
name = "driven_arm"
gravity = [0.0, -9.81]

[simulation]
t_end = 2.0
dt = 0.001

[initial]
coordinates."upper.theta" = 0.3
rates."upper.theta" = 1.0

[[bodies]]
type = "rigid"
name = "upper"
mass = 1.0
inertia = 0.08333333333333333
center_of_mass = [0.5, 0.0]
markers.tip = { position = [1.0, 0.0] }

[[bodies]]
type = "rigid"
name = "lower"
mass = 1.0
inertia = 0.08333333333333333
center_of_mass = [0.5, 0.0]

[[joints]]
type = "revolute"
name = "shoulder"
marker_a = "ground.origin"
marker_b = "upper.origin"

[[joints]]
type = "revolute"
name = "elbow"
marker_a = "upper.tip"
marker_b = "lower.origin"

[[loads]]
type = "torque"
name = "motor"
marker = "upper.origin"
value = "8*sin(9*t)"
"""


class Step:
    """One major step of a scheme on a model's own motion, and its tangent."""

    def __init__(self, model: Model, name: str, dt: float, m: list[int] | None, options: dict[str, Any]) -> None:
        self.scheme = scheme_kind(name).build(name, model, dt, m, options)
        self.stepper = Stepper(self.scheme, "interpreted")
        p = model.parameter_vector()
        self.c = model.constants(p)
        self.ready, self.state, self.dt = self.stepper.ready(self.c, dt), start_state(model, p, self.c, 0.0, None), dt
        self.tangent = TangentStep(self.scheme)

    def start(self) -> Array:
        return self.stepper.start(0.0, self.state.q, self.state.q_dot, self.c, self.dt)

    def after(self, z: Array, steps: int = 1) -> Array:
        z = z.copy()
        self.stepper.run(z, self.ready, steps)
        return z

    def matrix(self, z: Array) -> Array:
        return self.tangent(self.stepper.state(z).copy(), self.scheme.constants(self.c, self.dt))[1]

    def differences(self, z: Array, h: float = 1e-6) -> Array:
        """The same by central differences of the step that runs."""
        columns, found = self.tangent.columns, []
        for k in columns:
            ends = []
            for sign in (1.0, -1.0):
                moved = z.copy()
                moved[k] += sign * h
                ends.append(self.after(moved)[columns])
            found.append((ends[0] - ends[1]) / (2 * h))
        return np.array(found).T


@pytest.mark.parametrize("scene, dt", [("two_oscillators", 0.02), ("flexible_slider_crank", 2e-5)])
@pytest.mark.parametrize("m", [1, 3])
def test_a_sweep_has_the_tangent_of_what_it_converges_to(built_in: Load, scene: str, dt: float, m: int) -> None:
    """Also where nothing moves: there one sweep is enough for the value, but not for the derivative."""
    model = built_in(scene)
    swept = Step(model, "printed", dt, [m], {})
    at_once = Step(model, "printed", dt, [m], {"common_update": "direct", "newton_iterations": 4})
    for scale in (0.0, 1.0):
        z, other = swept.start(), at_once.start()
        columns, others = swept.tangent.columns, at_once.tangent.columns
        z[columns] *= scale
        other[others] = z[columns]
        ours, wanted = swept.matrix(z), at_once.matrix(other)
        size = np.abs(wanted).max(axis=1, keepdims=True) + np.abs(wanted).max(axis=0, keepdims=True)
        assert np.all(np.abs(ours - wanted) <= 1e-7 * size)


@pytest.mark.parametrize(
    "name, options",
    [
        ("printed", {}),
        ("radau", {"eps": 1e-14}),
    ],
)
def test_iterated_steps_have_the_tangent_of_their_differences(
    model_of: Build, name: str, options: dict[str, Any]
) -> None:
    step = Step(model_of(SceneRecord.from_toml_text(ARM)), name, 0.01, None, options)
    z = step.after(step.start(), 7)
    ours, wanted = step.matrix(z), step.differences(z)
    assert np.abs(ours - wanted).max() < 1e-5 * np.abs(wanted).max()


@pytest.mark.parametrize("name", ["coupled"])
def test_one_group_holds_nothing(model_of: Build, name: str) -> None:
    """No multiplier of a step belongs to numbers that no step writes, and the forces are those of the time."""
    model = model_of(SceneRecord.from_toml_text(ARM))
    step = Step(model, name, 1e-3, None, {})
    z = step.after(step.start(), 7)
    sizes = np.abs(np.linalg.eigvals(step.matrix(z)))
    assert np.sum(sizes > 0.5) == 2 * len(model.q_i)
    runs = [simulate(model, scheme=scheme, t_end=1.0, dt=5e-4, seen_every=1.0) for scheme in (name, "rk4")]
    np.testing.assert_allclose(runs[0].q_i[-1], runs[1].q_i[-1], rtol=0, atol=2e-4)


@pytest.mark.parametrize("name", list(SCHEMES))
def test_a_short_step_has_the_multipliers_of_the_motion(built_in: Load, name: str) -> None:
    """Two for each independent coordinate, near one; what else a scheme remembers vanishes."""
    model = built_in("flexible_slider_crank")
    step = Step(model, name, 1e-6, None, {})
    sizes = np.abs(np.linalg.eigvals(step.matrix(step.after(step.start(), 5))))
    assert np.sum(sizes > 0.5) == 2 * len(model.q_i)


def test_stability_of_the_default_sweep_is_that_of_the_direct_update(built_in: Load) -> None:
    """Neutral up to 2 over the fastest frequency: both routes to the common update say so."""
    model = built_in("two_oscillators")
    c = model.constants(model.parameter_vector())
    states, exact = states_along(model, t_end=5.0, count=3), ExactMotion(model, c)
    limits = [
        StabilityStudy(model, "printed", [1], options, c, states, 5.0, exact).curve(np.geomspace(0.02, 0.3, 8)).limit
        for options in ({}, {"common_update": "direct"})
    ]
    assert limits[0] is not None and limits[0] == pytest.approx(0.0866, rel=2e-3)
    assert limits[0] == pytest.approx(limits[1], rel=1e-6)


def test_a_sweep_arrives_where_a_group_passes_through_zero(built_in: Load) -> None:
    """x_S and its acceleration vanish together while x_L pushes: rounding of the coupling is all that is left."""
    run = simulate(built_in("two_oscillators"), scheme="printed", m=[1], dt=0.01, t_end=200.0, seen_every=20.0)
    direct = simulate(
        built_in("two_oscillators"),
        scheme="printed",
        m=[1],
        dt=0.01,
        t_end=200.0,
        seen_every=20.0,
        options={"common_update": "direct"},
    )
    assert run.status.name == "completed" and run.error.measured
    np.testing.assert_allclose(run.q_i, direct.q_i, rtol=0, atol=1e-9)


def test_exact_motion_goes_on_from_shorter_times(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """Twenty times one after the other take little more than a step each, and give what each alone gives."""
    model = built_in("double_pendulum")
    c = model.constants(model.parameter_vector({}))
    (state,) = states_along(model, t_end=1.0, count=1)
    times = np.geomspace(2e-4, 2e-2, 20)
    alone = [ExactMotion(model, c)(state, dt) for dt in times]
    plain, steps = TangentStep.__call__, []

    def counted(self: TangentStep, z: Array, c: Array) -> tuple[Array, Array]:
        steps.append(1)
        return plain(self, z, c)

    exact = ExactMotion(model, c)
    monkeypatch.setattr(TangentStep, "__call__", counted)
    np.testing.assert_allclose([exact(state, dt) for dt in times], alone, rtol=1e-6)
    assert len(steps) == 4 + 19


def test_an_unstable_chart_says_how_fast_it_grows(built_in: Load) -> None:
    """Steps far above the limit only: none is stable, and no growth is claimed to be zero."""
    (row,) = stability_chart(
        built_in("two_oscillators"), "printed", m=[[8]], states=2, points=3, dt_range=(0.05, 0.08)
    ).table()
    assert row["dt_limit"] is None and row["largest_growth_below_limit"] is None
    assert row["growth_at_smallest_dt"] > 0
