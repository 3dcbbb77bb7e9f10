"""Pictures and animations: written, labelled, and the exaggeration does what it says."""

from __future__ import annotations

import sys
import time
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image

from runtime import ArgumentError, ModelError, OutputError, Solution, Status, simulate
from runtime.contract.records import Coordinate
from runtime.views import plots
from runtime.views.animation import animate
from runtime.views.curves import Curves
from runtime.views.film import film
from symgen.scene import Scene
from tests.running.test_solution import rod_solution


@pytest.mark.every_push("coordinates", "snapshots", "energies")
@pytest.mark.parametrize("draw", [plots.coordinates, plots.energy_balance])
def test_every_picture_is_written_and_labelled_with_units(draw, tmp_path) -> None:
    figure = draw(rod_solution(), tmp_path / "picture.png")
    with Image.open(tmp_path / "picture.png") as image:
        assert image.width > 400 and image.height > 300
    for ax in figure.axes:
        assert "[" in ax.get_ylabel()
    assert "[" in figure.axes[-1].get_xlabel()


def test_no_pyplot_state_is_touched(tmp_path) -> None:
    before = sys.modules.get("matplotlib.pyplot")
    plots.coordinates(rod_solution(), tmp_path / "picture.svg")
    assert sys.modules.get("matplotlib.pyplot") is before


def test_panels_separate_rigid_from_elastic_and_leave_out_what_rests() -> None:
    figure = plots.coordinates(rod_solution())
    assert [ax.get_title(loc="left") for ax in figure.axes] == [
        "angles: rod.theta",
        "measures: tip",
        "rod: deformation: rod.q1",
    ]
    chosen = plots.coordinates(rod_solution(), names=["rod.q1", "tip"])
    assert len(chosen.axes) == 2
    assert len(plots.coordinates(rod_solution(), names="tip").axes) == 1
    with pytest.raises(ModelError):
        plots.coordinates(rod_solution(), names=["rod.q7"])


def test_many_coordinates_and_bodies_stay_readable() -> None:
    small = rod_solution()
    bodies = [f"link{k}" for k in range(40)]
    coordinates = [
        Coordinate(f"{body}.{part}", body, kind, unit)
        for body in bodies
        for part, kind, unit in (("theta", "angle", "rad"), ("q1", "modal", "m"))
    ]
    names = [coordinate.name for coordinate in coordinates]
    described = replace(small.model.description, coordinates=coordinates, q_i=names, q_d=[])
    model = replace(small.model, description=described)
    q = np.outer(np.sin(small.t), np.arange(1.0, 81.0))
    many = replace(small, model=model, q=q, q_dot=q, q_ddot=q, q_i=q)
    figure = plots.coordinates(many)
    assert len(figure.axes) == plots.MAX_PANELS
    legends = [ax.get_legend() for ax in figure.axes]
    assert len(legends[0].get_texts()) == 40  # complete, and a single curve is named in the title
    assert legends[2] is None and "link0.q1" in figure.axes[2].get_title(loc="left")  # behind the measure


@pytest.mark.every_push("motion")
@pytest.mark.parametrize("draw", [plots.motion, plots.deformation, plots.forces, plots.energy_balance])
def test_what_is_looked_at_first_has_units_with_prefixes(draw) -> None:
    figure = draw(rod_solution())
    assert figure._repr_png_().startswith(b"\x89PNG")
    labels = [ax.get_ylabel() for ax in figure.axes]
    assert all(label.startswith("[") and label.endswith("]") for label in labels)


def test_values_in_pictures_are_one_to_a_thousand_of_their_unit() -> None:
    """theta = sin t [rad], q1 = 0.01 cos 3t [m]."""
    figure = plots.coordinates(rod_solution(), names=["rod.theta", "rod.q1"])
    angle, mode = figure.axes
    assert angle.get_ylabel() == "[°]" and mode.get_ylabel() == "[mm]"
    assert angle.lines[0].get_ydata().max() == pytest.approx(np.degrees(np.sin(np.linspace(0, 2, 41)).max()))
    assert mode.lines[0].get_ydata()[0] == pytest.approx(10.0)


def test_euler_parameters_never_share_an_axis_with_metres() -> None:
    run = rod_solution()
    free = [Coordinate(f"box.{n}", "box", "euler_parameter", "1") for n in ("e0", "e1")]
    free += [Coordinate(f"box.{n}", "box", "position", "m") for n in ("x", "y")]
    described = replace(run.model.description, coordinates=free, q_i=[entry.name for entry in free], q_d=[])
    q = np.stack([np.cos(run.t), np.sin(run.t), run.t, run.t**2], axis=1)
    moved = replace(run, model=replace(run.model, description=described), q=q, q_dot=q, q_ddot=q, q_i=q)
    shown = {ax.get_title(loc="left"): len(ax.lines) for ax in plots.coordinates(moved).axes}
    assert shown == {"positions": 2, "Euler parameters": 2, "measures: tip": 1}
    assert all("Euler" not in ax.get_title(loc="left") for ax in plots.motion(moved).axes)


def test_what_moves_by_millimetres_gets_an_axis_beside_metres() -> None:
    """A lift of metres, a buffer of 19 mm and one of 15 mm far from zero: two panels."""
    run = rod_solution()
    free = [Coordinate(f"{n}.y", n, "position", "m") for n in ("lift", "buffer", "stop")]
    described = replace(
        run.model.description, coordinates=free, q_i=[entry.name for entry in free], q_d=[], measures=[]
    )
    q = np.stack([3 * run.t, 0.0095 * np.cos(9 * run.t), 2.0 + 0.0075 * np.sin(9 * run.t)], axis=1)
    moved = replace(run, model=replace(run.model, description=described), q=q, q_dot=q, q_ddot=q, q_i=q)
    shown = [[line.get_label() for line in ax.lines] for ax in plots.motion(moved).axes]
    assert sorted(map(len, shown)) == [1, 2]


def test_own_axes_are_drawn_into_in_their_own_colours() -> None:
    ax = Figure().add_subplot()
    ax.set_prop_cycle(color=["magenta"])
    returned = plots.coordinates(rod_solution(), names=["rod.q1"], ax=ax)
    assert returned is ax.figure and ax.lines[0].get_color() == "magenta"
    with pytest.raises(ArgumentError, match="one unit"):
        plots.coordinates(rod_solution(), names=["rod.q1", "rod.theta"], ax=ax)


@pytest.mark.long
def test_two_runs_are_drawn_with_their_difference(tmp_path) -> None:
    """The second run's q1 is larger by 1 mm at all times; theta is the same."""
    first, second = rod_solution(), rod_solution(81)
    second.q[:, 3] += 1e-3
    figure = plots.difference(first, second, tmp_path / "two.png")
    gaps = {ax.get_title(loc="left"): ax.lines[0].get_ydata() for ax in figure.axes[1::2]}
    q1 = next(values for name, values in gaps.items() if name == "difference, at most 1 mm")
    assert np.allclose(q1, 1.0, atol=2e-3)
    with pytest.raises(ArgumentError, match="no time"):
        plots.difference(first, replace(second, t=second.t + 10.0))


def test_several_runs_are_drawn_with_their_differences_to_the_first() -> None:
    first, *others = (rod_solution() for _ in range(3))
    for k, run in enumerate(others):
        run.q[:, 3] += (k + 1) * 1e-3
    right = plots.difference(first, others).axes[1::2]
    q1 = next(ax for ax in right if ax.get_title(loc="left") == "difference, at most 2 mm")
    assert all(np.allclose(line.get_ydata(), k, atol=2e-3) for line, k in zip(q1.lines, (1, 2), strict=True))


@pytest.mark.long
def test_section_forces_along_a_cantilever(model_of, tmp_path) -> None:
    """Hand, to first order: M = -F (L - x) and Q = -F at every section; nothing is pulled."""
    builder = Scene("cantilever").beam("arm", length=0.5, density=7800.0, youngs_modulus=2e11, area=2e-4,
                                              second_moment=6.7e-9, lateral={"modes": 2})  # fmt: skip
    builder.weld("wall", "ground.origin", "arm.start").force("tip", "arm.end", 0.0, -0.3)
    run = simulate(model_of(builder.simulation(t_end=2e-6, dt=1e-6, scheme="rk4", start="quasi_static").build()))
    axes = plots.section_forces(run, "arm", tmp_path / "arm.png").axes
    drawn = {ax.get_title(loc="left").partition(",")[0]: ax.lines[0].get_xydata() for ax in axes}
    x, moment = drawn["bending moment about z"].T
    assert np.allclose(moment, -150.0 * (1.0 - x), atol=0.05)  # N mm
    assert np.allclose(drawn["shear force along y"][:, 1], -300.0, atol=0.1)  # mN
    with pytest.raises(ModelError, match="no beam"):
        plots.section_forces(run, "wall")


def test_motors_and_equal_curves(built_in) -> None:
    """The motor of a driven crank is among the forces; curves that cover each other are one with all their names."""
    run = simulate(built_in("flexible_slider_crank"), t_end=2e-3)
    motors = next(ax for ax in plots.forces(run).axes if ax.get_title(loc="left").startswith("motor torques"))
    (drive,) = (joint.name for joint in run.model.description.joints if joint.type == "prescribed_angle")
    (line,) = motors.lines
    drawn, own = np.asarray(line.get_ydata()), run.motor(drive)
    assert np.allclose(drawn / np.abs(drawn).max(), own / np.abs(own).max())
    curves = Curves("", "m", ["a", "b", "c"], np.array([[1.0, 2.0], [1.0, 3.0], [1.0, 2.0]]))
    assert curves.merged().names == ["a, c", "b"] and curves.merged().values.tolist() == [[1.0, 2.0], [1.0, 3.0]]


def test_a_run_that_failed_says_so_in_the_title() -> None:
    figure = plots.energy_balance(rod_solution(status=Status("diverged", 1.5)))
    assert "diverged" in figure.get_suptitle()


def test_one_sample_can_be_drawn() -> None:
    solution = rod_solution(1)
    for draw in (plots.coordinates, plots.energy_balance):
        draw(solution)


def test_unknown_picture_formats_are_refused(tmp_path) -> None:
    with pytest.raises(OutputError, match="png"):
        plots.coordinates(rod_solution(), tmp_path / "picture.xyz")


def test_film_follows_the_motion() -> None:
    solution = rod_solution()
    shown = film(solution, frames=11, exaggeration=3.0)
    rod, ghost = shown.line("rod", "beam"), shown.line("rod", "ghost")
    assert rod.xy.shape == (11, 2, 5) and shown.t[-1] == 2.0
    theta, q1 = solution.interpolate(shown.t, "rod.theta"), solution.interpolate(shown.t, "rod.q1")
    tip = np.stack([2.0 * np.cos(theta) - 3.0 * q1 * np.sin(theta), 2.0 * np.sin(theta) + 3.0 * q1 * np.cos(theta)])
    assert np.allclose(rod.xy[:, :, 4], tip.T, atol=1e-14)
    assert np.allclose(ghost.xy[:, 0, 4], 2.0 * np.cos(theta), atol=1e-14)


def test_automatic_exaggeration_shows_five_per_cent() -> None:
    shown = film(rod_solution())
    rod, ghost = shown.line("rod", "beam").xy, shown.line("rod", "ghost").xy
    size = np.ptp(np.append(ghost, np.zeros((60, 2, 1)), axis=2), axis=(0, 2)).max()
    seen = np.linalg.norm(rod - ghost, axis=1).max() / size
    assert 0.04 <= seen <= 0.05 and shown.exaggeration > 1.0
    still = rod_solution()
    still.q[:, 3] = still.q_dot[:, 3] = 0.0
    assert film(still).exaggeration == 1.0


@pytest.mark.long
def test_gif_has_all_frames_and_is_quick(tmp_path) -> None:
    started = time.perf_counter()
    animate(rod_solution(), tmp_path / "motion.gif", frames=60, fps=25)
    assert time.perf_counter() - started < 5.0
    with Image.open(tmp_path / "motion.gif") as image:
        assert image.n_frames == 60 and image.info["duration"] == 40 and image.info["loop"] == 0
        first = np.asarray(image.convert("RGB"), dtype=int)
        image.seek(30)
        assert np.abs(np.asarray(image.convert("RGB"), dtype=int) - first).max() > 50


def test_what_cannot_be_animated_is_refused(tmp_path) -> None:
    solution = rod_solution()
    solution.save(tmp_path / "run.npz")
    with pytest.raises(ModelError, match="no drawing"):
        film(Solution.load(tmp_path / "run.npz"))
    with pytest.raises(ValueError, match="frames"):
        film(solution, frames=0)
    with pytest.raises(ValueError, match="exaggeration"):
        film(solution, exaggeration=float("nan"))
    with pytest.raises(ValueError, match="fps"):
        animate(solution, tmp_path / "a.gif", fps=1000)
    with pytest.raises(OutputError, match="gif or .mp4"):
        animate(solution, tmp_path / "a.avi")


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # the library leaves pipes open
def test_mp4_has_all_frames_of_the_film(tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also in a folder whose name the encoder could take for an option; and what moves, moves."""
    ffmpeg = pytest.importorskip("imageio_ffmpeg")
    monkeypatch.chdir(tmp_path)
    animate(rod_solution(), "-y/motion.mp4", frames=12, fps=25)
    found = ffmpeg.read_frames("./-y/motion.mp4")
    about = next(found)
    frames = [np.frombuffer(one, dtype=np.uint8).astype(int) for one in found]
    assert about["codec"] == "h264" and about["fps"] == 25 and len(frames) == 12
    assert np.abs(frames[6] - frames[0]).max() > 50
    assert [path.name for path in (tmp_path / "-y").iterdir()] == ["motion.mp4"]


def test_without_an_encoder_the_extra_is_named(tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with pytest.raises(ImportError, match=r"symgen\[film\]"):
        animate(rod_solution(), tmp_path / "motion.mp4")


@pytest.mark.long
def test_a_point_that_moves_along_a_line_has_a_picture_with_two_axes() -> None:
    """A mass on a vertical rail: the picture is not narrower than a fifth of its height."""
    scene = (
        Scene("mass")
        .rigid("mass", mass=1.0, inertia=1.0)
        .ground(markers={"up": {"angle": np.pi / 2}})
        .prismatic("rail", "ground.up", "mass.origin")
        .initial({"mass.theta": np.pi / 2})
        .rates({"mass.y": 1.0})
    )
    (ax,) = plots.snapshots(scene.model().simulate(t_end=1.0)).axes
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    assert right - left >= 0.19 * (high - low) and low <= 0 < 1 <= high


def test_snapshots_are_the_film_at_their_times_with_paths(built_in, tmp_path) -> None:
    """A pendulum: the tip's path is a circle about the hinge, and each instant ends on it at the angle of the run."""
    run = simulate(built_in("pendulum"), t_end=0.5)
    ax = Figure().subplots()
    plots.snapshots(run, tmp_path / "few.png", instants=3, traces=["rod.tip"], ax=ax)
    path, *lines = ax.lines
    length = np.hypot(*path.get_xydata().T)
    assert np.ptp(length) < 1e-9
    rods = [line.get_xydata()[-1] for line in lines if len(line.get_xydata()) == 2]
    angles = [run.interpolate(t, "rod.theta") for t in (0.0, 0.25, 0.5)]
    assert np.allclose(rods, length[0] * np.column_stack([np.cos(angles), np.sin(angles)]), atol=1e-6)
    with pytest.raises(ModelError, match="rod.tip"):
        plots.snapshots(run, traces=["rod.end"])
    plots.snapshots(run, instants=[-1e-13, 0.5 + 1e-13])  # ends of the run, but for rounding
    with pytest.raises(ArgumentError):
        plots.snapshots(run, instants=[0.6])
