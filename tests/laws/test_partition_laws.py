"""Another q_i on the way: the state is carried exactly, and a run finds the q_i that it needs."""

from __future__ import annotations

import importlib.util
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from runtime import SCHEMES, simulate
from runtime.model import Model
from runtime.running.planning import make_plan
from runtime.running.singular import exchange
from runtime.running.singular.exchange import carried, variant_of
from runtime.running.stepped_model import SteppedModel
from symgen.scene import Scene, SceneRecord
from symgen.variants import generate_variant

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]


def slider_crank(crank: float, rod: float, independent: str, theta: float = 0.5, rate: float = 8.0) -> SceneRecord:
    """Crank, rod and slider under gravity."""
    scene = Scene("slider_loop").gravity(0, -9.81)
    for name, length in (("crank", crank), ("rod", rod)):
        scene.rigid(
            name,
            mass=1.0,
            inertia=length**2 / 12,
            center_of_mass=(length / 2, 0),
            markers={"tip": {"position": (length, 0)}},
        )
    scene.rigid("slider", mass=0.5, inertia=0.01)
    scene.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.origin")
    scene.prismatic("slide", "ground.origin", "slider.origin").revolute("C", "rod.tip", "slider.origin")
    scene.initial({"crank.theta": theta, "rod.theta": -math.asin(crank * math.sin(theta) / rod)})
    scene.independent(independent).rates({"crank.theta": rate})
    return scene.simulation(t_end=2.0, dt=1e-3, scheme="single_rate").build()


def slider_on_an_arm(independent: str) -> SceneRecord:
    """A slider fixed to a turning arm: its x determines the arm except where the arm lies along x."""
    scene = Scene("arm").gravity(0, -9.81)
    scene.rigid("arm", mass=1.0, inertia=1 / 12, center_of_mass=(0.5, 0), markers={"tip": {"position": (1.0, 0)}})
    scene.rigid("slider", mass=1.0, inertia=0.01)
    scene.revolute("A", "ground.origin", "arm.origin").weld("W", "arm.tip", "slider.origin")
    scene.independent(independent).initial({"arm.theta": 0.5}).rates({"arm.theta": 6.0})
    return scene.simulation(t_end=2.0, dt=1e-3, scheme="single_rate").build()


@dataclass
class Switched:
    """A run of legs between which q_i is exchanged at will."""

    model: Model
    scheme: str
    dt: float
    m: list[int] | None = None
    _built: dict[int, SteppedModel] = field(default_factory=dict)

    def segment(self, model: Model) -> SteppedModel:
        if id(model) not in self._built:
            plan = make_plan(model, 1.0, self.dt, self.m, self.scheme, 1, None, 0.0)
            self._built[id(model)] = SteppedModel.of_run(model, plan, model.parameter_vector(), "auto")
        return self._built[id(model)]

    def run(self, parts: list[tuple[Model, int]]) -> np.ndarray:
        """q after so many steps on each model in turn."""
        segment = self.segment(parts[0][0])
        z = segment.start(self.model.initial_q, self.model.initial_q_dot)
        for model, steps in parts:
            if model is not segment.model:
                new = self.segment(model)
                z = carried(segment, z, new, segment.observed([segment.state(z)]))
                segment = new
            for _ in range(steps // 10):
                segment.run(z, 10)
        return np.asarray(segment.observed([segment.state(z)]).q[0])


@pytest.mark.parametrize("scheme", SCHEMES)
def test_equal_angles_exchange_to_rounding(built_in: Load, scheme: str) -> None:
    """All uprights of the windows have the same angle, so the discrete motion is the same whichever is in q_i."""
    model = built_in("n_four_bar")
    q_i = ["upright2.theta" if name == "upright0.theta" else name for name in model.q_i]
    other = variant_of(model, q_i, model.initial_q)
    runs = Switched(model, scheme, 1e-3)
    whole = runs.run([(model, 300)])
    switched = runs.run([(model, 50), (other, 30), (model, 100), (other, 120)])
    assert np.abs(switched - whole).max() < 1e-9


@pytest.mark.parametrize("scheme", SCHEMES)
def test_exchange_keeps_the_order_of_a_scheme(model_of: Build, scheme: str) -> None:
    """crank.theta and slider.x are related nonlinearly: the difference goes to zero with the step as errors do."""
    model = model_of(slider_crank(0.3, 1.0, "crank.theta"))
    other = variant_of(model, ["slider.x"], model.initial_q)
    order = SCHEMES[scheme].make.order
    steps = np.array([40, 80, 160]) if order > 2 else np.array([160, 320, 640])
    differences = []
    for n in steps:
        runs = Switched(model, scheme, 0.16 / float(n))
        whole = runs.run([(model, n)])
        differences.append(np.abs(runs.run([(model, n // 4), (other, n // 2), (model, n // 4)]) - whole).max())
    if differences[-1] > 1e-11:
        assert -np.polyfit(np.log(steps), np.log(differences), 1)[0] > min(order, 4) - 0.3
    assert differences[-1] < 2e-4


def test_exchange_there_and_back_is_the_identity(model_of: Build) -> None:
    """Both positions of central difference come back at rounding level; its last acceleration, which is only used to
    predict velocities, is that of another coordinate's discrete velocity and comes back to h^2.
    """
    model = model_of(slider_crank(0.3, 1.0, "crank.theta"))
    runs = Switched(model, "single_rate", 1e-3)
    there, back = runs.segment(variant_of(model, ["slider.x"], model.initial_q)), runs.segment(model)
    z = back.start(model.initial_q, model.initial_q_dot)
    back.run(z, 77)
    across = carried(back, z, there, back.observed([back.state(z)]))
    again = carried(there, across, back, there.observed([there.state(across)]))
    layout = back.plan.scheme.layout
    for name, tolerance in (("x", 1e-13), ("d", 1e-13), ("a", 1e-3), ("n", 0), ("t0", 0)):
        assert np.abs(again - z)[layout.slice(name)].max() <= tolerance, name


@pytest.mark.parametrize("scheme, m", [("printed", [4]), ("coupled", [4])])
def test_exchanged_coordinate_keeps_its_group(built_in: Load, scheme: str, m: list[int]) -> None:
    model = built_in("flexible_slider_crank_free")
    q_i = ["rod.theta" if name == "crank.theta" else name for name in model.q_i]
    other = variant_of(model, q_i, model.initial_q)
    assert [group.positions for group in other.groups] == [group.positions for group in model.groups]
    differences = []
    for n in (160, 320, 640):
        runs = Switched(model, scheme, 0.0016 / n, m)
        whole = runs.run([(model, n)])
        differences.append(np.abs(runs.run([(model, n // 4), (other, n // 2), (model, n // 4)]) - whole).max())
    assert differences[2] < 0.7 * differences[1] < 0.5 * differences[0]
    assert differences[2] < 1e-5


CASES: list[tuple[Any, tuple[Any, ...], str]] = [
    (slider_crank, (0.3, 1.0), "slider.x"),
    (slider_on_an_arm, (), "slider.x"),
    (slider_on_an_arm, (), "slider.y"),
]


@pytest.mark.parametrize("make, sizes, lost", CASES)
@pytest.mark.parametrize("scheme, error", [("dop853", 1e-8), ("rk4", 3e-4), ("single_rate", 3e-2)])
def test_a_run_finds_the_q_i_that_it_needs(
    model_of: Build, make: Any, sizes: tuple[Any, ...], lost: str, scheme: str, error: float
) -> None:
    """Through dead centres, where the first choice determines nothing: the motion is that of the good choice."""
    angle = "crank.theta" if make is slider_crank else "arm.theta"
    run = simulate(model_of(make(*sizes, lost)), scheme=scheme, seen_every=0.01)
    exact = simulate(model_of(make(*sizes, angle)), scheme="dop853", seen_every=0.01)
    assert run.status.ok and exact.status.ok and not exact.events
    assert [event.kind for event in run.events] == ["repartition"]
    assert angle in run.events[0].text and run.stats["events"] == 1
    assert np.array_equal(run.t, exact.t)
    assert np.abs(run.q - exact.q).max() < error
    assert np.array_equal(run.q_i[:, 0], run[lost])  # of the first model, whatever was stepped with
    assert run.constraint_error.max() < 1e-10 and run.constraint_rate_error.max() < 1e-10


def test_without_a_generator_the_run_says_what_to_do(
    model_of: Build, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(exchange, "entry_points", lambda group: [])
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path))
    run = simulate(model_of(slider_crank(0.3, 1.0, "slider.x")), scheme="rk4")
    assert run.status.name == "partition_lost"
    assert "slider.x no longer determines" in run.status.cause
    assert "partition.independent = ['crank.theta']" in run.status.advice
    assert 0.3 < run.status.time < 1.0 and run.t[-1] == run.status.time
    assert np.abs(run.energy_balance()).max() < 1e-3
    assert [event.kind for event in run.events] == ["no_variant"]


def test_a_variant_of_another_generator_is_not_taken(
    model_of: Build, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """The same scene and q_i, but one source of the generator differs: it is asked again."""
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path))
    model, asked = model_of(slider_crank(0.3, 1.0, "crank.theta")), []

    def counted(*arguments: Any, **further: Any) -> Path:
        asked.append(arguments[1])
        return generate_variant(*arguments, **further)

    monkeypatch.setattr(exchange, "entry_points", lambda group: [SimpleNamespace(load=lambda: counted)])
    for version in ("one", "one", "two"):
        monkeypatch.setattr(exchange, "made_by", lambda generate, version=version: version)
        variant_of(model, ["slider.x"], model.initial_q)
    assert len(asked) == 2


def test_the_sources_of_a_generator_are_its_version(tmp_path: Path) -> None:
    found = []
    for text in ("def f():\n    return 1\n", "def f():\n    return 1\n", "def f():\n    return 2\n"):
        (tmp_path / "generator.py").write_text(text)
        spec = importlib.util.spec_from_file_location("generator", tmp_path / "generator.py")
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        found.append(exchange.made_by(module.f))
    assert found[0] == found[1] != found[2]
