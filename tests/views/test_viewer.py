"""The page of a run in a real browser: no error, bodies where Python says, the slider moves them, small, no network."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import runtime.views.viewer.page as viewer
from runtime import OutputError, Solution, load_model, simulate
from runtime.contract.records import packed
from runtime.views.mechanism import scenery
from runtime.views.viewer.page import view
from runtime.views.viewer.record import view_record
from symgen.scenes import generated_folder
from tests.support.browser import screenshot, used

pytestmark = pytest.mark.long

BUNDLES = Path(str(viewer.__file__)).parent / "bundles"
FACTOR = 7.0
PROBE = """
const slider = document.getElementById("time"), seen = [];
for (const t of TIMES) {
  slider.value = t;
  slider.dispatchEvent(new Event("input"));
  const places = (body, b) => body.points.names.map((_, k) => symgenView.place([b, k]).toArray());
  seen.push(symgenView.run.bodies.flatMap(places));
}
document.documentElement.dataset.probe = JSON.stringify(seen);
"""


@cache
def solution(name: str) -> Solution:
    return simulate(load_model(generated_folder(name)), t_end=0.05)


@pytest.mark.parametrize("name", ["flexible_slider_crank", "spatial_slider_crank"])
def test_the_slider_moves_the_bodies_to_where_they_are(name: str, tmp_path: Path) -> None:
    """Positions of every marker in the page, deformation exaggerated, against those computed here."""
    run = solution(name)
    record = view_record(run)
    times = np.frombuffer(base64.b64decode(record["t"]))[[0, 70, -1]].tolist()  # between frames the page goes straight
    found = used(view(run).text, tmp_path, PROBE.replace("TIMES", str(times)), f"x={FACTOR}")
    assert "error" not in found and found["ready"] == "1"
    shown = scenery(run, np.array(times))
    expected = np.concatenate([shown.world(body, body.markers, FACTOR) for body in shown.bodies], axis=1)
    assert np.abs(np.array(found["probe"]) - expected).max() < 2e-6 * shown.size()
    assert np.ptp(expected, axis=0).max() > 1e-4 * shown.size()


def test_the_page_shows_something_and_a_moment_of_its_own(tmp_path: Path) -> None:
    page = view(solution("flexible_slider_crank")).text
    size = (1000, 560)
    pictures = [np.asarray(screenshot(page, tmp_path, f"t={t}&hide=names", size), dtype=int) for t in (0.0, 0.03)]
    stage = [picture[40:520, :600] for picture in pictures]
    assert all(len(np.unique(part.reshape(-1, 3), axis=0)) > 100 for part in stage)
    assert (np.abs(stage[0] - stage[1]).max(axis=2) > 60).sum() > 1000


def test_a_notebook_gets_a_frame_that_shows_something(tmp_path: Path) -> None:
    text = view(solution("flexible_slider_crank"))._repr_html_()
    assert re.match(r'<iframe sandbox="allow-scripts allow-same-origin allow-downloads" ', text)
    assert "<script" not in text
    below = f"<html><body><div style='height:300px'>a cell</div>{text}</body></html>"
    picture = np.asarray(screenshot(below, tmp_path, "", (1000, 900)), dtype=int)
    assert len(np.unique(picture[360:800, :600].reshape(-1, 3), axis=0)) > 100


def test_words_of_an_address_that_mean_nothing_here_are_said(tmp_path: Path) -> None:
    """A layer that the page does not have is named beside those that it has."""
    read = "document.documentElement.dataset.probe = JSON.stringify([document.querySelector('#hint').textContent, "
    read += "document.querySelector('#show [data-name=reactions]').checked, "
    read += "[1.5e8, 1234.56, 2e-5, 0].map(symgenView.digits)]);"
    page = view(solution("flexible_slider_crank")).text
    hint, reactions, numbers = used(page, tmp_path, read, "with=reactions,stress")["probe"]
    assert hint.startswith("with=stress: not in this page, which has bodies, joints")
    assert reactions and numbers == ["1.5e8", "1235", "2e-5", "0"]
    assert used(page, tmp_path, read, "with=reactions")["probe"][0].startswith("drag: turn")


def test_pages_are_small_and_ask_nothing_of_the_network() -> None:
    """Of the built-in scenes the four-bar with two flexible bars has the largest page."""
    page = view(simulate(load_model(generated_folder("flexible_four_bar")), error="off")).text
    assert len(page.encode()) < 1.0e6
    assert not re.search(r'(src|href)="http|import\(|fetch\("http|@import', page.replace(three(), ""))


def three() -> str:
    return (BUNDLES / "three.min.js").read_text(encoding="utf-8")


def test_twenty_thousand_vertices_with_eight_modes_stay_below_five_megabytes() -> None:
    """A surface on the finite-element rod, with as many modes as it has; two more would add 0.64 MB."""
    run = solution("spatial_slider_crank")
    n, nf = 20_000, 6
    around = np.linspace(0.0, 200.0 * np.pi, n)
    surface = {
        "vertices": np.stack([np.linspace(0.0, 0.3, n), 0.01 * np.cos(around), 0.01 * np.sin(around)], axis=1),
        "triangles": np.stack([np.arange(n - 2), np.arange(1, n - 1), np.arange(2, n)], axis=1),
        "shapes": np.ones((n, 3, nf)),
    }
    (own,) = run.model.description.drawing.surfaces
    packing = {key: packed(values, "<i4" if key == "triangles" else "<f4") for key, values in surface.items()}
    drawing = replace(run.model.description.drawing, surfaces=[replace(own, **packing, stresses="")])
    described = replace(run.model.description, drawing=drawing)
    size = len(view(replace(run, model=replace(run.model, description=described))).text.encode())
    assert size + 2 * 16 * n < 5.0e6


@pytest.mark.long
def test_pages_do_not_grow_with_the_run() -> None:
    """0.7 MB and 0.2 MB of motion for the hub with a beam, as the guide says; with ten times the samples, too."""
    model = load_model(generated_folder("hub_beam"))
    few, many = (len(view(simulate(model, samples=n, error="off")).text.encode()) / 1e6 for n in (1_000, 10_000))
    assert 0.6 < few < 1.0 and many < few + 0.1


def test_a_second_run_stands_pale_beside_the_first(tmp_path: Path) -> None:
    """Its bodies where it is at the same times, its curves up to where it ended; joints are those of the first."""
    one, other = solution("hub_beam"), simulate(load_model(generated_folder("hub_beam")), t_end=0.03, scheme="rk4")
    record = view_record(one, other)
    own, pale = ([body for body in record["bodies"] if body["pale"] is which] for which in (False, True))
    assert [body["name"] for body in own if not body["ground"]] == [body["name"] for body in pale]
    assert record["joints"] == view_record(one)["joints"]
    t = np.frombuffer(base64.b64decode(record["t"]))
    seen = np.frombuffer(base64.b64decode(next(body for body in pale if body["name"] == "beam")["q"]), "<f4").reshape(
        len(t), -1
    )
    expected = other.interpolate(np.minimum(t, other.t[-1]), "q")[
        :, [one.name.startswith("beam.q") for one in other.model.description.coordinates]
    ]
    np.testing.assert_allclose(seen, expected, rtol=1e-6, atol=1e-12)
    group = record["curves"][0]
    curve_t = np.frombuffer(base64.b64decode(record["curve_t"]))
    last = np.frombuffer(base64.b64decode(group["values"][-1]), "<f4")
    assert len(group["pale"]) == len(group["names"]) / 2
    assert np.array_equal(np.isnan(last), curve_t > other.t[-1])
    found = used(view(one, beside=other).text, tmp_path, "document.documentElement.dataset.probe = '1'")
    assert "error" not in found and found["ready"] == "1"


def test_scene_names_cannot_break_out_of_the_page(tmp_path: Path) -> None:
    run = solution("hub_beam")
    title = "</script><script>document.title='gone'</script> @@data@@"
    wild = replace(run, model=replace(run.model, description=replace(run.model.description, title=title)))
    found = used(view(wild).text, tmp_path, "document.documentElement.dataset.probe = JSON.stringify(document.title)")
    assert found["ready"] == "1" and "error" not in found and found["probe"] != "gone"


def test_a_page_of_another_ending_is_refused(tmp_path: Path) -> None:
    run = solution("spatial_slider_crank")
    with pytest.raises(OutputError, match="html"):
        run.view(tmp_path / "page.pdf")
    run.view(tmp_path / "page.html")
    assert (tmp_path / "page.html").stat().st_size > 600_000


def test_the_bundles_are_those_that_were_made() -> None:
    listed = json.loads((BUNDLES / "bundles.json").read_text(encoding="utf-8"))
    assert set(listed) >= {"three.min.js", "uplot.min.js", "uplot.min.css", "three.LICENSE", "uplot.LICENSE"}
    for name, digest in listed.items():
        assert hashlib.sha256((BUNDLES / name).read_bytes()).hexdigest() == digest, name
