"""Every named limit that ends a run, or makes it say a word, is where the pages say: just inside nothing happens.

The numbers are written out here: a limit that somebody loosens is noticed.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.linalg import eigvalsh
from scipy.optimize import brentq

from runtime import Model, ModelError, simulate
from runtime.results.motion_error import MotionError
from runtime.running.monitor import Monitor
from runtime.running.outcome import with_error
from runtime.running.planning import make_plan
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import start_vector
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import driven_bob

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
INSIDE, BEYOND = 0.99, 1.01


def watched(model: Model, scheme: str = "single_rate") -> tuple[Monitor, np.ndarray]:
    """A monitor at the model's own start, and that state."""
    built = scheme_kind(scheme).build(scheme, model, 1e-3, None, {})
    c = model.constants(model.parameter_vector())
    monitor = Monitor(model, built, c)
    z = start_vector(built, 0.0, model.initial_q, model.initial_q_dot, c)
    assert monitor.first(z) is None
    return monitor, z


def named(monitor: Monitor, z: np.ndarray) -> str | None:
    status = monitor.after(z.copy(), last=True)
    return None if status is None else status.name


def put(monitor: Monitor, z: np.ndarray, field: str, value: float) -> np.ndarray:
    changed = z.copy()
    changed[monitor.scheme.layout.slice(field)] = value
    return changed


def test_growth(built_in: Load) -> None:
    monitor, z = watched(built_in("pendulum"))
    for factor, expected in ((INSIDE, None), (BEYOND, "diverged")):
        assert named(monitor, put(monitor, z, "d", factor * 1e6 * monitor.scale)) == expected


def test_closure(built_in: Load) -> None:
    monitor, z = watched(built_in("four_bar"))
    for factor, expected in ((INSIDE, None), (BEYOND, "constraints_lost")):
        assert named(monitor, put(monitor, z, "closure_error", factor * 1e-2 * monitor.length)) == expected


def test_constraints(built_in: Load) -> None:
    """Coupler and rocker of four_bar close the loop where their lengths enclose the way from the crank's tip."""
    model = built_in("four_bar")
    monitor, z = watched(model, "rk4")
    angle, rocker = float(model.initial_q[model.coordinates.index("crank.theta")]), 0.25
    longest = float(np.hypot(0.3 - 0.1 * np.cos(angle), 0.1 * np.sin(angle))) + rocker
    for length, expected in ((0.8 * longest, None), (1.1 * longest, "constraints_lost")):
        monitor.c = monitor.scheme.constants(model.constants(model.parameter_vector({"coupler.tip.x": length})))
        assert named(monitor, z) == expected


def stiffened_arm() -> SceneRecord:
    """A beam on a hinge with second-order stiffening: its truncated kinetic energy loses its sign when it bends far."""
    arm = Scene("arm").beam(
        "arm",
        length=0.6,
        density=2700.0,
        area=4e-5,
        second_moment=1.3e-11,
        youngs_modulus=7e10,
        lateral={"ends": "clamped-free", "modes": 2},
        stiffening=True,
    )
    return arm.revolute("hinge", "ground.origin", "arm.start").build()


def test_mass_that_is_nearly_lost(model_of: Build) -> None:
    """A tenth of what M_hat is without deflections explains a breakdown of the numbers; rigid bodies never do."""
    model = model_of(stiffened_arm())
    place, c = model.q_i.index("arm.q1"), model.constants(model.parameter_vector())

    def M_hat(bent: float) -> np.ndarray:
        q_i = model.initial_q[model.independent_columns].copy()
        q_i[place] = bent
        found = model.evaluate("condensed", q_i=q_i, q_d=np.zeros(2), q_i_dot=0 * q_i, q_d_dot=np.zeros(2), t=0.0, c=c)
        return np.array(found["M_hat"])

    def share(bent: float) -> float:
        return float(eigvalsh(M_hat(bent), M_hat(0.0))[0])

    limit = brentq(lambda bent: share(bent) - 0.1, 0.0, 0.2)
    for factor, expected in ((BEYOND, "mass_not_positive"), (INSIDE, "diverged")):
        monitor, z = watched(model)
        z[monitor.scheme.layout.slice("x")][place] = factor * limit
        assert monitor.after(z) is None
        assert named(monitor, put(monitor, z, "d", BEYOND * 1e6 * monitor.scale)) == expected


@pytest.mark.parametrize("mode, share, turn", [(0, 0.4, None), (1, None, 1.0)])
def test_deflection(built_in: Load, mode: int, share: float | None, turn: float | None) -> None:
    """The first mode of a clamped beam moves its end by 0.4 of its length first, the second turns it by a radian."""
    model = built_in("hub_beam")
    monitor, z = watched(model)
    p = model.parameter_vector()
    points = {key: np.asarray(value) for key, value in model.kernel("geometry")(p=p).items()}
    modes = sum(entry.elastic for entry in model.description.coordinates)
    length = float(np.ptp(points["positions"][:, -modes:], axis=1).max()) if share else 1.0
    spread = points["shapes" if share else "turns"]
    most = float(np.linalg.norm(spread[:, mode::modes], axis=0).max())
    limit = (share * length if share else turn or 0.0) / most
    position = model.q_i.index(next(e.name for e in model.description.coordinates if e.elastic)) + mode
    for factor, expected in ((INSIDE, None), (BEYOND, "deflection_too_large")):
        bent = z.copy()
        bent[monitor.scheme.layout.slice("x")][position] = factor * limit
        assert named(monitor, bent) == expected


def test_a_word_about_the_error_and_a_status(built_in: Load) -> None:
    """3 % of an amplitude is said, a tenth is no accurate run."""
    run = simulate(built_in("pendulum"), scheme="rk4", dt=0.01, t_end=0.1, error="off")
    for error, said, status in (
        (0.0297, False, "completed"),
        (0.0303, True, "completed"),
        (0.101, False, "inaccurate"),
    ):
        own = {"rod.theta": error}
        found = with_error(run, MotionError(own, own, own, own, own))
        assert ("remark" in found.stats, found.status.name) == (said, status)


def test_a_small_jump_of_a_prescribed_velocity_is_refused(model_of: Build) -> None:
    """A ten-thousandth of the largest velocity."""
    motion = "sin(3 * t) + 3e-4 * ((t - 0.05003) ** 2 + 1e-40) ** 0.5"  # a kink that no condition tells of
    builder = driven_bob("driven", motion)
    model = model_of(builder.simulation(t_end=0.1, dt=1e-3, scheme="single_rate").build())
    with pytest.raises(ModelError, match="its velocity jumps by 0.0003"):
        simulate(model)


def test_a_part_of_a_step_is_a_step(built_in: Load) -> None:
    for part, steps in ((1e-7, 10), (1e-5, 11)):
        assert make_plan(built_in("pendulum"), (10 + part) * 1e-3, 1e-3, None, "rk4", 1, None, 0.0).steps == steps
