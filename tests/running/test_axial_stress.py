"""The stress of a beam without axial modes: N is by equilibrium wherever the measure can be asked for."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import DifferentiableRun, ModelError
from runtime.engine.c_source import find_compiler
from runtime.export.fmu import this_platform
from runtime.model import Model
from symgen import SceneError
from symgen.scene import Scene, SceneRecord
from tests.export.bundles import bundle
from tests.export.test_fmu import CO_SIMULATION, EXCHANGE, Master

Build = Callable[[SceneRecord], Model]
L, RHO, A, E, G = 1.0, 7800.0, 2e-4, 2.1e11, 9.81
BEAM = {"length": L, "density": RHO, "area": A, "second_moment": 6.7e-9, "youngs_modulus": E, "section_modulus": 6.7e-7}
IN_SPACE = {"second_moment_z": 3e-9, "section_modulus_z": 4e-7, "lateral_z": {"modes": 2}}
PLACES = {"quarter": 0.25, "middle": 0.5, "far": 0.8}
MARKERS = {name: {"at": at} for name, at in PLACES.items()}


def pendulum(gravity: float = 0.0, space: str = "planar", **more: object) -> Scene:
    """A beam on a hinge, with its stress at places and along it."""
    spatial = space == "spatial"
    scene = Scene("pendulum", space=space).gravity(0, -gravity, *((0,) if spatial else ()))
    scene.beam("rod", **BEAM, **(IN_SPACE if spatial else {}), lateral={"modes": 3}, markers=MARKERS, **more)
    scene.revolute("hinge", "ground.origin", "rod.start")
    for name in PLACES:
        scene.measure(name, "stress", of=f"rod.{name}")
    return scene.measure("peak", "stress", of="rod.all").simulation(dt=1e-4, scheme="rk4")


def slider_crank(**more: object) -> Scene:
    """A crank that drives a slider by a flexible rod."""
    scene = Scene("slider_crank").gravity(0, -G)
    scene.rigid("crank", mass=0.2, inertia=1e-3, markers={"tip": {"position": (0.15, 0)}})
    scene.beam("rod", **BEAM, lateral={"modes": 3}, stiffening=True, damping_ratio=0.3, markers=MARKERS, **more)
    scene.rigid("slider", mass=2.5, inertia=1e-3)
    scene.revolute("main", "ground.origin", "crank.origin").revolute("pin", "crank.tip", "rod.start")
    scene.revolute("wrist", "rod.end", "slider.origin").prismatic("guide", "ground.origin", "slider.origin")
    for name in PLACES:
        scene.measure(name, "stress", of=f"rod.{name}")
    scene.measure("peak", "stress", of="rod.all").measure("share", "expression", of="peak / 2.5e8", unit="1")
    return scene.initial({"crank.theta": 0.3}).rates({"crank.theta": 30.0}).simulation(dt=1e-5, scheme="rk4")


@pytest.mark.parametrize("space, rate", [("planar", "rod.theta_dot"), ("spatial", "hinge.angle_dot")])
def test_a_rotating_beam(model_of: Build, space: str, rate: str) -> None:
    """N(x) = rho A w^2 (L^2 - x^2) / 2, and no shape bends."""
    run = model_of(pendulum(space=space).build()).simulate(t_end=0.02, initial={rate: 50.0})
    for name, x in PLACES.items():
        np.testing.assert_allclose(run[name], RHO * 50.0**2 * (L**2 - x**2) / 2, rtol=1e-9)
    np.testing.assert_allclose(run["peak"], RHO * 50.0**2 * L**2 / 2, rtol=1e-9)
    assert run.stats["missing_stress.peak"] == pytest.approx(0.0, abs=1e-9)
    assert not any(one.kind == "stresses_missing" for one in run.events)


def test_a_pendulum_where_it_hangs(model_of: Build) -> None:
    """At the lowest point N(x) = rho A w^2 (L^2 - x^2) / 2 + rho A g (L - x), and a tip mass pulls by m (w^2 L + g)."""
    scene, m = pendulum(G), 0.4
    scene.rigid("tip", mass=m, inertia=1e-3).revolute("end", "rod.end", "tip.origin")
    start = {"rod.theta": -np.pi / 2, "rod.theta_dot": 6.0}
    run = model_of(scene.build()).simulate(t_end=1e-4, initial=start)
    for name, x in PLACES.items():
        own = RHO * A * (6.0**2 * (L**2 - x**2) / 2 + G * (L - x))
        assert run[name][0] == pytest.approx((own + m * (6.0**2 * L + G)) / A, rel=1e-9)


def test_loads_between_the_ends_count_where_they_act(model_of: Build) -> None:
    """Pulled along: by forces at a marker and at a place that moves, and by q_0 + q_1 s + q_2 s^2."""
    scene = Scene("pulled").gravity(0, 0).beam("rod", **BEAM, lateral={"modes": 2}, markers=MARKERS)
    scene.weld("root", "ground.origin", "rod.start").force("pull", "rod.middle", 30.0, 0.0)
    scene.moving_force("walk", "rod", place="0.3 + 4e4*t", components=(7.0, 0.0))
    scene.distributed("wind", "rod", components=("20 + 50*s + 90*s**2", 0.0), start=0.2, end=0.7)
    for name in PLACES:
        scene.measure(name, "stress", of=f"rod.{name}")
    run = model_of(scene.build()).simulate(t_end=1e-5, scheme="rk4", dt=1e-6)
    for name, x in PLACES.items():
        low = np.clip(x, 0.2, 0.7)
        N = 30.0 * (x < 0.5) + 20 * (0.7 - low) + 25 * (0.7**2 - low**2) + 30 * (0.7**3 - low**3)
        assert run[name][0] * A == pytest.approx(N + 7.0 * (x < 0.3), rel=1e-9, abs=1e-9)
        assert run[name][-1] * A == pytest.approx(N + 7.0 * (x < 0.7), rel=1e-6, abs=1e-9)


@pytest.mark.long
def test_a_rod_of_a_crank_is_as_one_that_stretches(model_of: Build) -> None:
    """Damped axial modes follow the equilibrium, and N / A is a twentieth of the stress."""
    how = {"start": "quasi_static", "tolerance": 1e-4, "t_end": 0.1, "seen_every": 5e-3}
    one, other = (model_of(slider_crank(**axial).build()).simulate(**how) for axial in ({}, {"axial": {"modes": 4}}))
    assert one.status.ok and other.status.ok
    for name in PLACES:
        assert np.abs(one[name] - other[name]).max() < 1e-3 * other[name].max()


def test_it_is_what_equilibrium_says(model_of: Build) -> None:
    """Measures at sections, with bending as the shapes know it, against N of `section_forces`."""
    run = model_of(slider_crank().build()).simulate(t_end=5e-3)
    forces = run.section_forces("rod", list(PLACES.values()))
    bent = run.section_forces("rod", list(PLACES.values()), way="modes")
    pulled, W = np.abs(forces.normal) / A, BEAM["section_modulus"]
    shear = 1.5 * np.abs(bent.shear) / A
    expected = np.maximum(pulled + np.abs(bent.moment) / W, np.hypot(pulled, np.sqrt(3) * shear))
    np.testing.assert_allclose(np.column_stack([run[name] for name in PLACES]), expected, rtol=1e-9)
    assert pulled.max() > 0.03 * expected.max()
    assert np.isnan(bent.normal).all() and (run["share"] == run["peak"] / 2.5e8).all()


def test_everything_that_shows_it_agrees(model_of: Build) -> None:
    """Columns, chosen outputs, steppers and what they read, lanes and an ensemble."""
    model, names = model_of(slider_crank().build()), ["peak", "share", "middle"]
    run = model.simulate(t_end=2e-3, dt=1e-5, scheme="rk4", samples=3)
    expected = np.column_stack([run[name] for name in names])
    few = model.simulate(t_end=2e-3, dt=1e-5, scheme="rk4", samples=3, outputs=names)
    np.testing.assert_allclose([few[name][-1] for name in names], expected[-1], rtol=1e-10)
    stepper = model.stepper()
    read = stepper.reader(names)
    np.testing.assert_allclose(read(), expected[0], rtol=1e-10)
    stepper.step(200)
    np.testing.assert_allclose(read(), expected[-1], rtol=1e-10)
    assert [stepper.measures[name] for name in names] == pytest.approx(expected[-1], rel=1e-10)
    lanes = model.lanes(3, outputs=names)
    lanes.reset({"crank.theta": 0.3, "crank.theta_dot": 30.0})
    np.testing.assert_allclose(lanes.step(None, 200), np.tile(expected[-1], (3, 1)), rtol=1e-10)
    many = model.ensemble({"crank.mass": [0.2, 0.3]}, t_end=2e-3, dt=1e-5, scheme="rk4", outputs=names)
    np.testing.assert_allclose([np.asarray(many[name])[0, -1] for name in names], expected[-1], rtol=1e-10)


def test_gradients_know_it(model_of: Build) -> None:
    """d peak / d w of the rotating beam: rho L^2 w."""
    run = DifferentiableRun(model_of(pendulum().build()), ["peak"], ["rod.theta_dot"], t_end=0.01, seen_every=5e-3)
    np.testing.assert_allclose(run.jacobian([50.0]).derivatives, RHO * L**2 * 50.0, rtol=1e-6)


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
def test_exported_code_has_it(model_of: Build, tmp_path: Path) -> None:
    model = model_of(slider_crank().build())
    own, stepper = bundle(model, tmp_path), model.stepper()
    own.step(100)
    stepper.step(100)
    names = [one.name for one in own.one.outputs]
    np.testing.assert_array_equal(own.observe(), stepper.reader(names)())
    assert own.observe()[names.index("peak")] == pytest.approx(stepper.measures["peak"], rel=1e-12)


@pytest.mark.long
@pytest.mark.skipif(find_compiler() is None or this_platform() != "linux64", reason="no C compiler, or elsewhere")
def test_units_have_it(model_of: Build, tmp_path: Path) -> None:
    """For co-simulation the bits of the runtime, and for model exchange the same at the start."""
    model = model_of(slider_crank().build())
    stepper, names = model.stepper(), ["peak", "share", "middle"]
    for kind, folder in ((CO_SIMULATION, "steps"), (EXCHANGE, "states")):
        (tmp_path / folder).mkdir()
        master = Master(model, tmp_path / folder, kind)
        master.begin()
        np.testing.assert_allclose(master.get(names), stepper.reader(names)(), rtol=1e-9)


def test_loads_states_and_events_cannot_use_it() -> None:
    """The motion would depend on its own accelerations."""
    changes: list[Callable[[Scene], Scene]] = [
        lambda scene: scene.torque("brake", "rod.start", "-1e-9 * peak"),
        lambda scene: scene.state("worn", "1e-9 * peak"),
        lambda scene: scene.event("breaks", when="peak - 1e8"),
        lambda scene: scene.event("breaks", when="share - 1").measure("share", "expression", of="peak / 1e8"),
        lambda scene: scene.measure("quick", "expression", of="peak_dot"),
    ]
    for change in changes:
        with pytest.raises(SceneError, match="'(peak|share)'.*normal force follows from accelerations"):
            change(pendulum()).build()
    stretched = pendulum(axial={"modes": 1}).event("breaks", when="peak - 1e8")
    assert stretched.build()


def test_what_has_no_normal_force_is_refused_by_name(model_of: Build) -> None:
    """A joint without one place, what sticks along the beam, and linear systems, whose outputs are of states."""
    with pytest.raises(SceneError, match="normal force of beam 'rod', and 'strap' acts on it at more than one marker"):
        scene = pendulum().spring_damper("strap", "rod.quarter", "rod.far", stiffness=10.0)
        model_of(scene.build())
    scene = pendulum().rigid("bead", mass=0.1, inertia=1e-4)
    with pytest.raises(SceneError, match="joint 'guide'.*axial modes"):
        model_of(scene.prismatic("guide", "rod.middle", "bead.origin", friction={"coulomb": 0.2}).build())
    model = model_of(pendulum(G).build())
    hanging = model.equilibrium({"rod.theta": -1.5})
    assert model.linearise(hanging).output_names == model.q_i
    with pytest.raises(ModelError, match="'peak'.*follows from accelerations"):
        model.linearise(hanging, outputs=["peak"])
