"""The page of a run: figures by hand in it, everything inside one file, and the run again from what it says."""

from __future__ import annotations

import re
import shlex
from dataclasses import replace
from functools import cache
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

from runtime import ArgumentError, OutputError, Solution, Status, load_model, simulate
from runtime.contract.status import Event
from runtime.studies.convergence import Convergence, ModellingError
from symgen import Scene
from symgen.cli import main
from symgen.scenes import generated_folder
from tests.support.browser import screenshot, used

PREFIXES = {"n": 1e-9, "\u00b5": 1e-6, "m": 1e-3, "k": 1e3, "M": 1e6}
MASS, SPEED, LENGTH = 2.0, 3.0, 0.5  # of a body that a drive turns about a pivot in a plane without gravity


@cache
def turning() -> Solution:
    """A point mass on a massless arm at constant speed: the pivot carries m r w^2, and the drive nothing."""
    scene = (
        Scene("wheel", title="Turning mass")
        .parameter("speed", SPEED, "rad/s", "of the drive")
        .rigid(
            "arm", mass=MASS, inertia=1e-3, center_of_mass=(LENGTH, 0.0), markers={"tip": {"position": (LENGTH, 0.0)}}
        )
        .revolute("pivot", "ground.origin", "arm.origin")
        .prescribed_angle("drive", "ground.origin", "arm.origin", motion="speed * t")
        .measure("height", "y", of="arm.tip")
    )
    return scene.model().simulate(t_end=1.0, scheme="rk4", dt=1e-3)


class Text(HTMLParser):
    """Rows of tables by section, links to elsewhere, the lines to copy, and pages inside."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.rows: dict[str, list[list[str]]] = {}
        self.outside: list[str] = []
        self.lines: list[str] = []
        self.frames: list[str] = []
        self.scripts = 0
        self._tag, self._section, self._table = "", "", False
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._tag = tag
        self._table = self._table or tag == "table"
        self.scripts += tag == "script"
        for name, value in attrs:
            if name in ("src", "href") and not (value or "").startswith("data:"):
                self.outside.append(str(value))
            if name == "srcdoc":
                self.frames.append(str(value))
        if tag == "tr":
            self.rows.setdefault(self._section, []).append([])
        elif tag in ("td", "th"):
            self.rows[self._section][-1].append("")
        elif tag == "pre":
            self.lines.append("")

    def handle_endtag(self, tag: str) -> None:
        self._tag = "" if tag in ("h2", "pre", "td", "th") else self._tag
        self._table = self._table and tag != "table"

    def handle_data(self, data: str) -> None:
        if self._tag == "h2":
            self._section = data
        elif self._tag == "pre":
            self.lines[-1] += data
        elif self._tag and self._table and self.rows.get(self._section) and self.rows[self._section][-1]:
            self.rows[self._section][-1][-1] += data

    def row(self, section: str, name: str) -> list[str]:
        """The row of a section that begins with a name."""
        return next(row for row in self.rows[section] if row[0] == name)


def number(cell: str) -> float:
    """The SI value of a cell with a prefixed unit."""
    value, unit = cell.split(" ", 1)
    return float(value) * (PREFIXES[unit[0]] if unit not in ("m", "N m") and unit[0] in PREFIXES else 1.0)


def read(run: Solution, tmp_path: Path) -> Text:
    run.page(tmp_path / "page.html")
    return Text((tmp_path / "page.html").read_text(encoding="utf-8"))


def test_it_has_the_figures_of_a_turning_mass(tmp_path: Path) -> None:
    """By hand: m r w^2 = 9 N in the pivot all along, the tip at 0.5 m where 3 t = pi / 2, 171.9 deg = 3 rad at last."""
    found = read(turning(), tmp_path)
    head = (tmp_path / "page.html").read_text(encoding="utf-8").partition("</header>")[0]
    assert "<h1>Turning mass</h1>" in head and "1 body, 2 joints" in head
    assert found.row("Result", "status")[1].startswith("completed")
    assert found.row("Key figures", "height")[1:3] == ["500 mm", "0.524"]  # the sample next to pi / 6
    assert found.row("Key figures", "arm.theta")[1:3] == ["171.9°", "1"]
    assert found.row("Reactions and loads", "pivot")[1] == "9 N"
    assert found.row("Parameters", "speed") == ["speed", "3", "3", "rad/s", "of the drive"]
    assert found.row("Parameters", "arm.mass")[1] == "2"
    assert "?" not in found.row("Result", "method")[1]
    assert found.row("Result", "error of the steps")[1].endswith("nothing is integrated")


def test_rounding_is_no_figure_of_it(tmp_path: Path) -> None:
    """A table on a parallel crank stays level, to rounding; a force across a rail is 5 N without a share along it."""
    cranks = {"tip": {"position": (0.3, 0.0)}}
    scene = (
        Scene("table")
        .gravity(0.0, -9.81)
        .ground(markers={"right": {"position": (0.5, 0.0)}})
        .rigid("a", mass=1.0, inertia=0.1, markers=cranks)
        .rigid("b", mass=1.0, inertia=0.1, markers=cranks)
        .rigid("table", mass=2.0, inertia=0.1, markers={"right": {"position": (0.5, 0.0)}})
        .revolute("A", "ground.origin", "a.origin")
        .revolute("B", "ground.right", "b.origin")
        .revolute("C", "a.tip", "table.origin")
        .revolute("D", "b.tip", "table.right")
        .prescribed_angle("drive", "ground.origin", "a.origin", motion="0.7 + sin(3 * t) / 3")
        .initial({"a.theta": 0.7, "b.theta": 0.7})
    )
    found = read(scene.model().simulate(t_end=2.0), tmp_path)
    named = [row[0] for row in found.rows["Key figures"]]
    assert "b.theta" in named and "table.theta" not in named
    cells = [cell for part in ("Key figures", "Reactions and loads") for row in found.rows[part] for cell in row]
    assert cells and not [cell for cell in cells if "e-1" in cell or "e-2" in cell]


@pytest.mark.long
def test_peaks_of_a_cantilever_are_those_by_hand(tmp_path: Path) -> None:
    """P L^3 / (3 E I) = 0.3125 mm at the end, P L = 5 N m and 6 P L / (b h^2) = 7.5 MPa at the clamp."""
    b, h, L, P = 0.01, 0.02, 0.5, 10.0
    scene = (
        Scene("shelf")
        .beam("beam", length=L, density=7800.0, youngs_modulus=2e11, area=b * h, second_moment=b * h**3 / 12,
              section_modulus=b * h**2 / 6, lateral={"modes": 3})
        .weld("wall", "ground.origin", "beam.start")
        .force("tip", "beam.end", 0.0, -P)
        .measure("stress", "stress", of="beam.all")
        .simulation(t_end=1e-4, scheme="rk4", dt=1e-6, start="quasi_static")
    )  # fmt: skip
    found = read(scene.model().simulate(), tmp_path)
    deflection = found.row("Key figures", "deflection of beam")
    assert number(deflection[1]) == pytest.approx(P * L**3 / (3 * 2e11 * b * h**3 / 12), rel=1e-3)
    assert deflection[5] == "end"
    section = "Stresses and section forces"
    moment, stress = (
        found.row(section, "bending moment about z in beam"),
        found.row(section, "von Mises stress in beam"),
    )
    assert moment[1] in ("5 N m", "-5 N m") and moment[3] == stress[3] == "start"
    assert number(stress[1]) == pytest.approx(P * L * 6 / (b * h**2), rel=1e-3)


def test_a_status_and_events_are_in_it(tmp_path: Path) -> None:
    """A run that failed says why; impacts have their own table."""
    failed = Status("diverged", 0.5, "arm.theta", "the step is too long", "take a smaller one")
    late = Event(0.5, "event", "late rises", "late", "rising")
    hit = Event(0.25, "impact", "", "pivot.limits.lower", impulse=0.125, before=-2.0, after=1.0, energy_lost=0.0375)
    run = simulate(load_model(generated_folder("pendulum")), t_end=0.01, outputs=["rod.theta"])
    found = read(replace(run, status=failed, events=[hit, late]), tmp_path)
    status = found.row("Result", "status")[1]
    assert status == "diverged at t = 0.5 s, coordinate arm.theta. the step is too long. take a smaller one"
    assert found.rows["Events"][1:] == [["0.5", "event", "late rises"]]
    assert found.row("Impacts", "0.25") == [
        "0.25", "pivot.limits.lower", "2 rad/s", "1 rad/s", "0.125 N m s", "37.5 mJ", "-"
    ]  # fmt: skip
    assert found.row("Result", "error of the model")[1].startswith("not estimated")


@pytest.mark.long
def test_errors_of_steps_and_model_are_in_it(tmp_path: Path) -> None:
    """An error that was not estimated says so; the error of the model stands beside it where it is given."""
    model = load_model(generated_folder("hub_beam"))
    off = model.simulate(t_end=0.1, error="off")
    assert read(off, tmp_path).row("Result", "error of the steps")[1] == "not estimated: it was switched off"
    run = model.simulate(t_end=0.1)
    assert read(run, tmp_path).row("Result", "error of the steps")[1].startswith(f"{run.error.largest:.2g} of the")
    told = Convergence("hub_beam", "motion", {"tip_y": ModellingError("tip_y", "m", 0.35, 7e-4, "beam.lateral", 2e-9)})
    off.page(tmp_path / "page.html", convergence=told)
    row = Text((tmp_path / "page.html").read_text(encoding="utf-8")).row("Result", "tip_y")
    assert row == ["tip_y", "350 mm", "700 µm (0.2 %)", "2 nm", "beam.lateral"]


def swing(pieces: int) -> Scene:
    """A soft beam of welded pieces on a hinge, that falls; without stiffening few pieces are far off."""
    scene, last = Scene("swing").gravity(0.0, -9.81), "ground.origin"
    beam = {"density": 7870.0, "area": 4.2e-5, "second_moment": 1.26e-10, "youngs_modulus": 2e11}
    for k in range(pieces):
        scene.beam(f"piece{k}", length=1.0 / pieces, **beam, lateral={"modes": 1})
        scene.joint("weld" if k else "revolute", f"joint{k}", last, f"piece{k}.start")
        last = f"piece{k}.end"
    return scene.measure("tip", "y", of=last).initial({f"piece{k}.theta": 0.1 for k in range(pieces)})


def test_half_the_pieces_are_on_the_page_by_themselves(tmp_path: Path) -> None:
    """What `convergence` tells of the same run, and what was not turned; switched off it says so."""
    model = swing(2).model()
    run = model.simulate(t_end=0.3)
    told = model.convergence(run=run, knobs=["half"])
    assert told["tip"].error > 0
    found = read(run, tmp_path)
    assert found.row("Result", "error of the model")[1].startswith("of the motion, estimated with other models")
    assert found.row("Result", "tip")[2].endswith(f"({100 * told['tip'].relative:.2g} %)")
    text = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert "turned piece0.pieces 2 -&gt; 1" in text and "cannot be turned: piece0.shear" in text
    run.page(tmp_path / "off.html", convergence="off")
    row = Text((tmp_path / "off.html").read_text(encoding="utf-8")).row("Result", "error of the model")
    assert row[1] == "not estimated: it was switched off"
    with pytest.raises(ArgumentError, match="convergence.*half, all, off"):
        run.page(tmp_path / "other.html", convergence="halves")


def test_why_no_error_of_the_model_is_told(tmp_path: Path) -> None:
    """A model without its scene is refused by name, and where nothing can be halved it says what can be turned."""
    model = swing(1).model()
    run = model.simulate(t_end=0.05)
    row = read(run, tmp_path).row("Result", "error of the model")[1]
    assert row.startswith("not told") and "piece0.modes" in row
    bare = replace(run, model=replace(model, scene_toml=""))
    row = read(bare, tmp_path).row("Result", "error of the model")[1]
    assert row.startswith("not estimated: model swing") and "without its scene" in row


@pytest.mark.every_push("two_oscillators")
@pytest.mark.parametrize("name", ["flexible_four_bar", "two_oscillators"])
def test_it_is_one_file_that_asks_nothing_of_the_network(name: str, tmp_path: Path) -> None:
    """No scripts but those of the view inside, no addresses; 1.4 MB with two flexible bars, half of it code."""
    run = simulate(load_model(generated_folder(name)), error="off")
    found = read(run, tmp_path)
    assert found.scripts == 0 and not found.outside
    assert (tmp_path / "page.html").stat().st_size < 1.5e6
    assert len(found.frames) == (name != "two_oscillators")
    for frame in found.frames:
        inside = Text(frame)
        assert not inside.outside and inside.scripts == 4 and len(frame.encode()) < 1.0e6


def test_what_it_says_makes_the_run_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The scene and the command of a page, of a run with another method, step, parameter and start: the same bits."""
    model = load_model(generated_folder("flexible_slider_crank_torque"))
    torque = next(entry for entry in model.parameters if entry.kind == "declared")
    changed, start = {torque.name: 1.5 * torque.default}, {"crank.theta": 0.3}
    run = model.simulate(t_end=0.02, scheme="coupled", dt=4e-5, m=[4], parameters=changed, initial=start)
    found = read(run, tmp_path)
    command, lines, scene = found.lines
    monkeypatch.chdir(tmp_path)
    Path("scene.toml").write_text(scene, encoding="utf-8")
    assert main([*shlex.split(command)[1:], "--no-plots"]) == 0
    again = Solution.load("results/solution.npz", model)
    assert np.array_equal(again.t, run.t) and np.abs(again.q - run.q).max() < 1e-12
    assert f"parameters={changed!r}" in lines and "start='given'" in lines


@pytest.mark.long
def test_its_lines_for_python_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A run that goes on later, by steps of their own error, from a tolerance: the lines alone have a way to say t0."""
    model = load_model(generated_folder("four_bar"))
    run = model.simulate(t0=1.0, t_end=1.2, scheme="dopri5", tolerance=1e-6, options={"error_of": "step"})
    lines, scene = read(run, tmp_path).lines
    values = re.search(r"simulate\(\n(.*?)\n\)", lines, re.DOTALL)
    assert values and "t0=1.0" in lines and "tolerance=1e-06" in lines and "'error_of': 'step'" in lines
    monkeypatch.chdir(tmp_path)
    Path("scene.toml").write_text(scene, encoding="utf-8")
    Path("lines.py").write_text(lines.replace("page.html", "again.html"), encoding="utf-8")
    import runpy

    again = runpy.run_path("lines.py")["run"]
    assert np.array_equal(again.t, run.t) and np.abs(again.q - run.q).max() < 1e-12 and Path("again.html").is_file()


@pytest.mark.long
def test_inputs_of_python_are_named_as_missing(tmp_path: Path) -> None:
    scene = (
        Scene("cart")
        .input("push", 0.0, "N")
        .rigid("cart", mass=1.0, inertia=1.0)
        .prismatic("rail", "ground.origin", "cart.origin")
        .force("push", "cart.origin", "push", 0.0)
    )
    model = scene.model()
    driven = read(model.simulate(t_end=0.1, inputs={"push": lambda t: 2 * t}), tmp_path)
    text = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert "Inputs that Python drove, and that these lines lack: push." in text and len(driven.lines) == 2
    fixed = read(model.simulate(t_end=0.1, inputs={"push": 3.0}), tmp_path)
    assert "inputs={'push': 3.0}" in fixed.lines[0]


@pytest.mark.long
def test_what_stops_and_events_set_is_no_setting(tmp_path: Path) -> None:
    """A ball bounces on a rigid stop, and an event sets the wind: the lines make the same motion from the scene."""
    scene = (
        Scene("ball")
        .input("wind", 0.0, "N")
        .gravity(0, -9.81)
        .rigid("ball", mass=1.0, inertia=1.0)
        .ground(markers={"up": {"angle": np.pi / 2}})
        .prismatic("fall", "ground.up", "ball.origin", limits={"lower": 0.0, "restitution": 0.5})
        .force("wind", "ball.origin", 0.0, "wind")
        .initial({"ball.y": 1.0, "ball.theta": np.pi / 2})
        .event("late", when="t - 0.3", action={"wind": 1.0})
    )
    model = scene.model()
    run = model.simulate(t_end=1.0, scheme="rk4", dt=1e-3)
    assert run.parameters[[one.name for one in model.parameters].index("wind")] == 1.0
    lines = read(run, tmp_path).lines[1]
    assert "inputs" not in lines and "parameters" not in lines
    assert "Set by events, and at the start as the scene has them: wind." in (tmp_path / "page.html").read_text("utf-8")


@pytest.mark.long
def test_impacts_on_rigid_and_elastic_stops_are_in_it(tmp_path: Path) -> None:
    """By hand: 2 kg at 1 m/s, restitution 1/2, loses 3/4 J; the elastic stop at the other end turns the speed."""
    for stop, after, impulse, lost in (
        ({"restitution": 0.5}, "0.5 m/s", 3.0, 0.75),
        ({"stiffness": 2e4}, "1 m/s", 4.0, 0.0),
    ):
        scene = (
            Scene("block")
            .rigid("block", mass=2.0, inertia=0.1)
            .prismatic("rail", "ground.origin", "block.origin", limits={"upper": 0.2, **stop})
            .rates({"block.x": 1.0})
        )
        run = scene.model().simulate(t_end=0.4, tolerance=1e-8, seen_every=1e-4)
        found = read(run, tmp_path)
        header, row = found.rows["Impacts"]
        assert header[:5] == ["t [s]", "where", "speed before", "speed after", "impulse"]
        assert row[:1] == ["0.2"] and row[1].startswith("rail.") and row[2:4] == ["1 m/s", after]
        assert row[4] == f"{impulse:g} N s"
        text = (tmp_path / "page.html").read_text("utf-8")
        assert f"1 impact; energy lost in all: {1e3 * lost:g} mJ" in text if lost else "1 impact" in text
        assert "Events" not in found.rows
        assert not any("_mode" in row[0] for row in found.rows["Key figures"])


def test_a_run_that_kept_outputs_shows_these(tmp_path: Path) -> None:
    """A pendulum let go at rest: its angle is largest at the start; reactions were not kept."""
    run = simulate(load_model(generated_folder("pendulum")), t_end=0.2, outputs=["rod.theta"])
    found = read(run, tmp_path)
    assert found.rows["Key figures"][1][0] == "rod.theta" and found.rows["Key figures"][1][1].endswith("°")
    assert "Reactions and loads" not in found.rows


@pytest.mark.long
def test_a_page_needs_the_name_of_one(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="must end in .html"):
        turning().page(tmp_path / "page.pdf")


@pytest.mark.long
def test_it_looks_like_a_page_in_a_browser(tmp_path: Path) -> None:
    """The frame of the moving view has no error and is not blank; nothing is wider than the window."""
    text = turning().page(tmp_path / "a.html").text
    wide = (
        "document.documentElement.dataset.probe = JSON.stringify([document.documentElement.scrollWidth, innerWidth]);"
    )
    scroll, window = used(text, tmp_path, wide)["probe"]
    assert scroll <= window
    picture = np.asarray(screenshot(text, tmp_path, "", (1100, 2400)), dtype=int)
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) > 300
