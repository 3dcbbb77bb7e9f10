"""The page of a comparison in a real browser: the verdict is what the numbers say, and follows the tolerance."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from runtime import load_model
from runtime.running.ladder import Method
from runtime.running.problem import Problem
from runtime.studies.work_precision.comparison import Comparison, WorkCurve
from runtime.studies.work_precision.comparison_files import comparison_data
from runtime.studies.work_precision.comparison_page import comparison_page
from runtime.studies.work_precision.reference import Reference
from runtime.studies.work_precision.trial import Trial
from symgen.scenes import generated_folder
from tests.support.browser import screenshot, used

READ = """
const slider = document.getElementById("tolerance"), seen = [];
const text = (place) => document.querySelector(place).textContent;
for (const tolerance of [1e-3, 1e-5, 1e-9]) {
  slider.min = -12;
  slider.value = Math.log10(tolerance);
  slider.dispatchEvent(new Event("input"));
  seen.push([text("#verdict"), text("#use"), document.querySelectorAll("#methods tbody tr").length]);
}
const low = (place) => document.querySelector(place).getBoundingClientRect().bottom;
seen.push([low("#plot"), low("#methods"), document.querySelectorAll("#methods tr.failed").length]);
document.documentElement.dataset.probe = JSON.stringify(seen);
"""


def trial(label: str, dt: float, seconds: float, error: float, failure: str = "") -> Trial:
    steps = round(1.0 / dt)
    return Trial(label, dt, steps, seconds, 2 * steps, error, error, failure=failure)


@pytest.fixture(scope="module")
def page() -> str:
    """coupled: error = dt, 1 us a step; rk4: error = dt^4, 100 us a step; one method that always failed.

    To 1e-3: coupled 1 ms (dt 1e-3), rk4 562 us (dt = 10^-0.75). To 1e-5: coupled 100 ms, rk4 10^1.25 steps, 1.78 ms.
    """
    problem = Problem.of(load_model(generated_folder("two_oscillators")), 1.0)
    reference = Reference(problem, lambda t: np.ones((len(t), 2)), ["x_L", "x_S"])
    steps = [10.0**-k for k in (1, 2, 3, 4, 5)]
    coupled, rk4, radau = Method("coupled", (4,)), Method("rk4"), Method("radau")
    failed = [trial("radau", 0.1, 1e-3, np.inf, "diverged")]
    curves = [
        WorkCurve(coupled.label, coupled, [trial(coupled.label, dt, 1e-7 / dt, dt) for dt in steps], 1.0, None),
        WorkCurve(rk4.label, rk4, [trial(rk4.label, dt, 1e-4 / dt, dt**4) for dt in steps[:2]], 4.0, None),
        WorkCurve(radau.label, radau, failed, np.nan, None, "diverged"),
    ]
    comparison = Comparison(reference, 1e-3, curves)
    return comparison_page(comparison, comparison_data(comparison), "springs.toml")


def test_the_verdict_follows_the_tolerance(page: str, tmp_path: Path) -> None:
    """To 1e-3 coupled takes 0.1 ms and rk4 sqrt(10) ms by interpolation... at 1e-5 rk4 is ahead, at 1e-9 nobody is."""
    found = used(page, tmp_path, READ)
    assert "error" not in found and found["ready"] == "1"
    loose, tight, impossible, places = found["probe"]
    assert loose[0].startswith("coupled m=4 is fastest to an error of 10⁻³: 100 µs for 1 s of motion, 10 times as fast")
    assert loose[1] == "Use it: symgen simulate springs.toml --scheme coupled --m 4 --dt 0.001"
    assert tight[0].startswith(
        "rk4 is fastest to an error of 10⁻⁵: 1.78 ms for 1 s of motion, 5.6 times as fast as coupled"
    )
    assert tight[1] == "Use it: symgen simulate springs.toml --scheme rk4 --dt 0.01"
    assert impossible[0].startswith("No method reached an error of 10⁻⁹")
    assert loose[2] == 3 and places[2] == 1
    assert places[0] < 768 and places[1] < 768  # seen without scrolling


def test_nothing_is_cut_at_any_width(page: str, tmp_path: Path) -> None:
    read = "const right = () => Math.max(...[...document.querySelectorAll('#both, #both *')].map((one) => "
    read += "one.getBoundingClientRect().right)); const body = document.body; document.documentElement.dataset.probe = "
    read += (
        "JSON.stringify([1300, 1180, 850].map((width) => { body.style.width = `${width - 44}px`; return right(); }));"
    )
    found = used(page, tmp_path, read)["probe"]
    assert all(right <= width for right, width in zip(found, (1300, 1180, 850), strict=True))


def test_the_picture_is_there_and_small(page: str, tmp_path: Path) -> None:
    assert len(page.encode()) < 60_000
    seen = np.asarray(screenshot(page, tmp_path), dtype=int)[110:600, 90:660]
    assert len(np.unique(seen.reshape(-1, 3), axis=0)) > 50


def test_the_page_asks_nothing_of_the_network_and_says_how_it_was_measured(page: str) -> None:
    assert 'src="' not in page and 'href="' not in page and "fetch(" not in page
    for word in ("machine", "versions", "reference", "SHA-256"):
        assert word in page
