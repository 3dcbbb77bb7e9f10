"""N, Q and M along beams against textbooks, a turning beam and one way against the other; what shapes leave out."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import ArgumentError, ModelError, Solution, simulate
from runtime.model import Model
from symgen.bodies.beam_sets import missing_share
from symgen.cli import main
from symgen.modes.beam import exact_bending
from symgen.scene import Scene, SceneError, SceneRecord
from symgen.system.build import build_system
from tests.cases.test_beams_of_pieces import fast_slider_crank

Build = Callable[[SceneRecord], Model]
L, RHO_A, G = 2.0, 3.0, 9.81
STIFF = {"length": L, "density": 1000.0, "area": 3e-3, "second_moment": 1.0, "youngs_modulus": 1e11}  # no deflection
AT = (0.0, 0.2, 0.5, 0.9, 1.0)
X = L * np.array(AT)


def at_rest(model_of: Build, builder: Scene) -> Solution:
    """The beam `b` as the builder loads it, in elastic equilibrium."""
    return simulate(model_of(builder.build()), scheme="rk4", dt=1e-9, t_end=2e-9, start="quasi_static")


def forces(run: Solution, way: str = "equilibrium") -> tuple[np.ndarray, ...]:
    found = run.section_forces("b", AT, way)  # type: ignore[arg-type]
    return found.normal[0], found.shear[0], found.moment[0]


def test_cantilever_with_a_load_a_moment_and_a_pull_at_its_tip(model_of: Build) -> None:
    """N = P, Q = F, M = F (L - x) + M_0, both ways."""
    builder = Scene("cantilever").beam("b", **STIFF, lateral={"modes": 2}, axial={"modes": 1})
    builder.weld("wall", "ground.origin", "b.start").force("tip", "b.end", 7.0, -3.0).torque("key", "b.end", 2.0)
    run = at_rest(model_of, builder)
    for way in ("equilibrium", "modes"):
        normal, shear, moment = forces(run, way)
        np.testing.assert_allclose(normal, 7.0, rtol=1e-6)
        np.testing.assert_allclose(shear, -3.0, rtol=1e-6)
        np.testing.assert_allclose(moment, 2.0 - 3.0 * (L - X), rtol=1e-6)


def test_simply_supported_beam_under_its_weight_and_a_load(model_of: Build) -> None:
    """M = w x (L - x) / 2 and the triangle P a (L - x) / L behind the load at a = 0.4 m; with one mode only."""
    builder = Scene("supported").gravity(0.0, -G).ground(markers={"right": {"position": (L, 0.0)}})
    builder.beam("b", **STIFF, lateral={"modes": 1}, markers={"load": {"at": 0.2}})
    builder.revolute("left", "ground.origin", "b.start").point_on_line("roller", "ground.right", "b.end")
    run = at_rest(model_of, builder.force("load", "b.load", 0.0, -50.0))
    _, shear, moment = forces(run)
    w, a = RHO_A * G, 0.4
    triangle = np.where(X <= a, X * (L - a) / L, a * (L - X) / L)
    np.testing.assert_allclose(moment, w * X * (L - X) / 2 + 50.0 * triangle, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(shear, w * (X - L / 2) - 50.0 * np.where(a > X, (L - a) / L, -a / L), rtol=1e-6)
    assert np.abs(forces(run, "modes")[2] - moment).max() > 1.0  # one sine is no triangle


def test_beam_welded_at_both_ends_under_its_weight(model_of: Build) -> None:
    """Statically indeterminate: M = -w L^2 / 12 at the walls, w L^2 / 24 in the middle, by the end shapes."""
    builder = Scene("walls").gravity(0.0, -G).ground(markers={"right": {"position": (L, 0.0)}})
    builder.beam("b", **STIFF, lateral={"modes": 3}).weld("one", "ground.origin", "b.start")
    run = at_rest(model_of, builder.weld("two", "ground.right", "b.end"))
    np.testing.assert_allclose(forces(run)[2][[0, 2, 4]], RHO_A * G * L**2 * np.array([-1, 0.5, -1]) / 12, rtol=1e-6)


def test_hanging_bar(model_of: Build) -> None:
    """N = rho A g (L - x) below a ceiling, exact by equilibrium with one shape."""
    builder = Scene("bar").gravity(G, 0.0).beam("b", **STIFF, axial={"modes": 1})
    run = at_rest(model_of, builder.weld("ceiling", "ground.origin", "b.start"))
    np.testing.assert_allclose(forces(run)[0], RHO_A * G * (L - X), rtol=1e-6, atol=1e-6)
    assert np.isnan(forces(run, "modes")[2]).all()  # no bending shapes


def test_a_linear_load_along_the_beam_and_across(model_of: Build) -> None:
    """N = int (4 + 6 s) ds and M = int (s - x) (1 - 3 s) ds beyond x, of a load on 0.3 to 1.5 m."""
    builder = Scene("linear").beam("b", **STIFF, lateral={"modes": 2}).weld("wall", "ground.origin", "b.start")
    builder.distributed("wind", "b", components=("4 + 6*s", "1 - 3*s"), frame="body", start=0.15, end=0.75)
    normal, shear, moment = forces(at_rest(model_of, builder))
    low, end = np.clip(X, 0.3, 1.5), 1.5
    np.testing.assert_allclose(normal, 4 * (end - low) + 3 * (end**2 - low**2), rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(shear, (end - low) - 1.5 * (end**2 - low**2), rtol=1e-6, atol=1e-6)
    expected = (end**2 - low**2) / 2 - (end**3 - low**3) - X * ((end - low) - 1.5 * (end**2 - low**2))
    np.testing.assert_allclose(moment, expected, rtol=1e-6, atol=1e-6)


def test_turning_beam(model_of: Build) -> None:
    """N = rho A w^2 (L^2 - x^2) / 2 at constant speed; with an angular acceleration Q and M of a linear load."""
    scene = (
        Scene("turning")
        .beam("b", **STIFF, lateral={"modes": 2}, stiffening=True)
        .revolute("axis", "ground.origin", "b.start")
        .prescribed_angle("drive", "ground.origin", "b.start", motion="5.0 * t + 2.0 * t ** 2")
        .build()
    )
    run = simulate(model_of(scene), scheme="rk4", dt=1e-7, t_end=2e-7, start="quasi_static")
    normal, shear, moment = forces(run)
    np.testing.assert_allclose(normal, RHO_A * 25.0 * (L**2 - X**2) / 2, rtol=1e-6, atol=1e-6)
    alpha = 4.0  # load -rho A alpha x along the beam
    np.testing.assert_allclose(shear, -RHO_A * alpha * (L**2 - X**2) / 2, rtol=1e-5, atol=1e-6)
    expected = -RHO_A * alpha * ((L**3 - X**3) / 3 - X * (L**2 - X**2) / 2)
    np.testing.assert_allclose(moment, expected, rtol=1e-5, atol=1e-6)


@pytest.mark.long
def test_bending_moment_of_a_fast_rod_and_the_modes_that_each_way_needs(model_of: Build) -> None:
    """Five modes: both ways agree to 1 % of the largest moment. Equilibrium is there with one, the sum is 13 % off."""

    def rod(modes: int) -> Solution:
        model = model_of(fast_slider_crank(1, modes))
        return simulate(model, scheme="rk4", dt=1e-5, t_end=6e-3, seen_every=0.0002, start="quasi_static")

    reference, coarse = rod(5).section_forces("rod0", way="modes"), rod(1)
    size = abs(reference.largest("moment").value)
    off = {way: coarse.section_forces("rod0", way=way).moment - reference.moment for way in ("equilibrium", "modes")}
    assert np.abs(off["equilibrium"]).max() < 0.013 * size
    assert np.abs(off["modes"]).max() > 0.1 * size
    largest = coarse.section_forces("rod0").largest("moment")
    assert 0.3 < largest.at < 0.7 and largest.t in coarse.t


def test_measures_of_a_section_are_the_sum_of_the_modes(model_of: Build) -> None:
    builder = Scene("cantilever").beam(
        "b", **STIFF, lateral={"modes": 3}, axial={"modes": 1}, markers={"m": {"at": 0.2}}
    )
    builder.weld("wall", "ground.origin", "b.start").force("tip", "b.end", 7.0, -3.0)
    for kind in ("normal_force", "shear_force", "bending_moment"):
        builder.measure(kind[:5], kind, "b.m")
    run = at_rest(model_of, builder)
    expected = run.section_forces("b", 0.2, "modes")
    for name, values in (("norma", expected.normal), ("shear", expected.shear), ("bendi", expected.moment)):
        np.testing.assert_allclose(run[name], values[:, 0], rtol=1e-12)
    units = {measure.name: measure.unit for measure in run.model.description.measures}
    assert (units["shear"], units["bendi"]) == ("N", "N m")


def test_what_a_measure_leaves_out_is_told(model_of: Build) -> None:
    """Two cubics under the weight w: w L^2 / 12 of w L^2 / 2 lack at the root; under a tip force nothing."""
    for g, push, lacking in ((G, 0.0, 1 / 6), (0.0, -3.0, 0.0)):
        builder = Scene("cantilever").gravity(0.0, -g)
        builder.beam("b", **STIFF, lateral={"modes": 2, "ends": "welded-welded"})
        builder.weld("wall", "ground.origin", "b.start").force("tip", "b.end", 0.0, push)
        run = at_rest(model_of, builder.measure("root", "bending_moment", "b.start"))
        assert run.stats["missing_force.root"] == pytest.approx(lacking, rel=1e-6, abs=1e-6)
        assert [event.kind for event in run.events] == ["sections_missing"] * (lacking > 0)
    assert run["root"][0] == pytest.approx(-3.0 * L, rel=1e-6)


@pytest.mark.long
def test_what_shapes_leave_out_is_told_by_the_run_and_before_it(
    model_of: Build, tmp_path: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two welded halves with two clamped-free modes each lack 22 % of the deflection (2.46 mm against 3.155 mm)."""
    good = fast_slider_crank(2, 2)
    bodies = [
        {**body, "lateral": {"ends": "clamped-free", "modes": 2}} if body["type"] == "beam" else body
        for body in good.to_dict()["bodies"]
    ]
    bad = SceneRecord.from_dict({**good.to_dict(), "bodies": bodies})
    run = simulate(model_of(bad), scheme="rk4", dt=2e-5, t_end=5e-3, seen_every=0.0005)
    assert 0.1 < run.stats["missing_shapes.rod0"] < 0.3
    assert [event.kind for event in run.events] == ["shapes_missing"] * 2 and run.stats["events"] == 2
    path = tmp_path / "bad.toml"
    path.write_text(bad.to_toml(), encoding="utf-8")
    assert main(["show", str(path)]) == 0
    assert "rod0.lateral: 2 clamped-free shapes miss 51 %" in capsys.readouterr().out
    assert build_system(good).equations.static_residuals == []
    assert 0 < float(run.stats["deflection.rod0"]) < 0.05 and 0 < float(run.stats["slope.rod1"]) < 0.2


def test_shares_that_clamped_free_modes_miss_are_those_of_a_sum_of_modes() -> None:
    """A moment at the end of clamped-free modes, held by a force there; exact: two thirds of M^2 L / 4 EI.

    Mode k of largest value 1 at the end has mass 1/4 and stiffness b^4 / 4; the moment and its force -M / L do the work
    phi_k'(1) - phi_k(1) on it.
    """
    b = np.array([1.875104068711961, 4.694091132974175, 7.854757438237613])
    sigma = (np.cosh(b) + np.cos(b)) / (np.sinh(b) + np.sin(b))
    slope = b * (np.sinh(b) + np.sin(b) - sigma * (np.cosh(b) - np.cos(b))) / 2
    phi = (np.cosh(b) - np.cos(b) - sigma * (np.sinh(b) - np.sin(b))) / 2
    held = 3 * float(np.sum(4 * (slope - phi) ** 2 / b**4))  # a moment at the end, held by forces at both
    assert missing_share(exact_bending("clamped-free", 3), [1]) == pytest.approx(1 - held, rel=1e-6)
    assert abs(missing_share(exact_bending("pinned-welded", 1), [1])) < 1e-12


def test_section_forces_of_what_has_none(model_of: Build, built_in: Callable[[str], Model]) -> None:
    run = simulate(built_in("flexible_four_bar"), dt=1e-5, t_end=2e-5)
    with pytest.raises(ModelError, match="no beam 'crank'; it has coupler, rocker"):
        run.section_forces("crank")
    with pytest.raises(ArgumentError, match="fractions of its length from 0 to 1"):
        run.section_forces("coupler", 1.5)
    with pytest.raises(ArgumentError, match="give one of equilibrium, modes"):
        run.section_forces("coupler", way="guess")  # type: ignore[arg-type]
    builder = Scene("spring").beam("b", **STIFF, lateral={"ends": "clamped-free", "modes": 2})
    builder.weld("wall", "ground.origin", "b.start").spring_damper("own", "b.start", "b.end", stiffness=1.0)
    with pytest.raises(ModelError, match="own acts on b at two places"):
        at_rest(model_of, builder).section_forces("b")
    assert math.isfinite(run.stats["deflection.coupler"])


@pytest.mark.parametrize(
    ("marker", "kind", "problem"),
    [
        ("r.origin", "bending_moment", "'r' is not a beam"),
        ("b.end", "normal_force", "'b' has no axial shapes, which would know its normal force"),
    ],
)
def test_measures_of_what_has_no_section(marker: str, kind: str, problem: str) -> None:
    builder = Scene("bad").rigid("r", mass=1.0, inertia=1.0, free=True)
    builder.beam("b", **STIFF, lateral={"ends": "clamped-free", "modes": 1}, free=True)
    with pytest.raises(SceneError, match=problem):
        builder.measure("s", kind, marker).build()


def test_a_measure_that_no_shapes_know_is_refused_by_name() -> None:
    bending = {"ends": "clamped-free", "modes": 1}
    builder = Scene("bad", space="spatial")
    builder.beam("b", **STIFF, second_moment_z=1e-9, lateral=bending, free=True)
    with pytest.raises(SceneError, match="'b' has no torsion shapes, which would know its torsion moment"):
        builder.measure("T", "torsion_moment", "b.end").build()
