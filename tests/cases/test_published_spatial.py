"""Published and computed reference values of spatial mechanisms: P3, P4, P5, and F3 posed in space."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from runtime import Model, load_model, reference_solution, simulate
from symgen.generate import generate
from symgen.scenes import generated_folder
from symgen.scenes.beams import spin_up_beam
from symgen.scenes.spatial import heavy_top
from tests.support.planar_in_space import posed

pytestmark = pytest.mark.long

P3 = {
    0.5: (0.9682836791067775, -1.2246251594363333, 0.7501466094377676),
    1.0: (0.5105014611872206, -1.649167599394806, 0.1401231145532866),
}
P4 = {0.1: 0.52383647556958, 0.5: 0.74324942478637, 1.0: 0.50142092237955, 10.0: 0.61962291706135}
P5 = {0.2: (0.60555056138, 0.59895768179, -0.52398302743), 1.0: (0.17334396410, 0.64008859207, -0.74849079113)}


@cache
def model(name: str) -> Model:
    return load_model(generated_folder(name))


def test_p3_bricard_mechanism() -> None:
    """IFToMM A04: a ring with one redundant constraint, position of P3."""
    solution = reference_solution(model("bricard"), t_end=1.0, times=np.array(list(P3)), rtol=1e-12, atol=1e-13)
    for k, expected in enumerate(P3.values()):
        found = [solution[f"P3_{axis}"][k] for axis in "xyz"]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10)
    assert np.max(solution.constraint_error) < 1e-10


def test_p4_flyball_governor() -> None:
    """IFToMM A05: travel of the slider; the strong damper needs an implicit method."""
    solution = reference_solution(
        model("flyball_governor"),
        "Radau",
        t_end=10.0,
        times=np.array(list(P4)),
        rtol=1e-9,
        atol=1e-11,
    )
    np.testing.assert_allclose(solution["height.travel"], list(P4.values()), rtol=0, atol=1e-8)


def test_p4_at_a_coarse_step() -> None:
    """The scheme with its own error control at 10 ms, eighty times the fast time constant: still 1e-8 m."""
    solution = simulate(model("flyball_governor"), t_end=1.0, dt=1e-2, scheme="radau", seen_every=0.1)
    assert solution.status.ok
    for second in (0.1, 0.5, 1.0):
        k = int(np.argmin(np.abs(solution.t - second)))
        assert abs(solution["height.travel"][k] - P4[second]) < 1e-8


def test_p5_heavy_top(tmp_path) -> None:  # type: ignore[no-untyped-def]
    """Spin 150 rad/s: position of the centre of mass, and the energy kept; Euler angles xzy, singular only along x."""
    top = load_model(generate(heavy_top("xzy"), tmp_path / "top"))
    solution = reference_solution(top, t_end=1.0, times=np.array(list(P5)), rtol=1e-12, atol=1e-13)
    for k, expected in enumerate(P5.values()):
        np.testing.assert_allclose([solution[f"top.{axis}"][k] for axis in "xyz"], expected, rtol=0, atol=1e-9)
        assert abs(solution.total_energy[k] - 5435.6967908655) < 1e-6


def test_f3_in_space(tmp_path) -> None:  # type: ignore[no-untyped-def]
    """The spin-up beam posed in space follows the planar one past its largest deflection."""
    planar = model("spin_up_beam")
    spatial = load_model(generate(posed(spin_up_beam(), planar), tmp_path / "beam"))
    flat, high = (simulate(beam, t_end=8.0, dt=1e-3, seen_every=0.02) for beam in (planar, spatial))
    lag = -high["tip_x"] * np.sin(high["pivot.angle"]) + high["tip_y"] * np.cos(high["pivot.angle"])
    assert abs(lag.min() / -0.57438 - 1) < 3e-3
    for name in ("tip_x", "tip_y", *planar.q_i):
        np.testing.assert_allclose(high[name], flat[name], rtol=0, atol=1e-12)
