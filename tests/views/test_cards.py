"""What a notebook shows: well-formed HTML without scripts, texts escaped, what was asked for in it."""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import replace
from html.parser import HTMLParser
from typing import Any

import pytest

from runtime import Model, Status, simulate
from runtime.contract.meter import Meter, progress_text
from runtime.studies.advice.advise import advise
from symgen.scenes import SCENES
from tests.running.test_solution import rod_model, rod_solution

LONE = {"br"}


class Balanced(HTMLParser):
    """Fails on a tag that is closed and was not open; collects names of tags."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.seen: set[str] = set()
        self.feed(text)
        assert not self.open, self.open

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        self.seen.add(tag)
        if tag not in LONE:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: Any) -> None:
        self.seen.add(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open and self.open.pop() == tag, tag


def shown(thing: Any) -> str:
    text = thing._repr_html_()
    assert "script" not in Balanced(text).seen
    return str(text)


@pytest.mark.parametrize("name", ["flexible_slider_crank", "spatial_slider_crank", "two_oscillators"])
def test_scenes_show_their_parts(name: str) -> None:
    scene = SCENES[name]()
    text = shown(scene)
    for part in (*scene.bodies, *scene.joints, *scene.loads):
        assert part.name in text


def test_models_show_partition_and_parameters(built_in) -> None:
    text = shown(built_in("flexible_slider_crank"))
    assert text.count("<path") >= 3 and "nan" not in text  # rods and beams as they stand at the start
    for word in ("13 coordinates", "group L", "rod.q1", "revolute", "rod.mass", "condensed"):
        assert word in text


def test_solutions_show_how_they_ended_with_small_curves() -> None:
    good = shown(rod_solution())
    assert "completed" in good and good.count("<svg") == 3  # two independent coordinates and a measure
    assert "-0.01 to 0.01" in good  # range of q1 = 0.01 cos 3t
    bad = shown(rod_solution(status=Status("diverged", 1.5, "rod.q1", "the step is <too> long", "take a smaller one")))
    assert "diverged" in bad and "Try: take a smaller one" in bad and "&lt;too&gt;" in bad


def test_titles_are_escaped() -> None:
    model = rod_model()
    wild = replace(model, description=replace(model.description, title="<b>bold"))
    assert "&lt;b&gt;bold" in shown(wild) and "&lt;b&gt;bold" in shown(replace(rod_solution(), model=wild))


def test_advice_shows_its_choice_and_the_candidates(built_in) -> None:
    advice = advise(built_in("two_oscillators"), t_end=2.0)
    text = shown(advice)
    assert advice.best.label in text and all(one.label in text for one in advice.candidates)


def test_progress_tells_rate_and_what_remains() -> None:
    """0.2 s of motion in 4 s: 0.05 s a second; 0.6 s of motion remain, 12 s."""
    assert progress_text("run", 0.4, 1.0, 4.0, 0.2).endswith("40.0 %  t = 0.4 s  0.05 s a second, 12 s left")
    assert progress_text("run", 0.0, 1.0, 0.0, 0.0).endswith("t = 0 s")


def test_a_run_shows_progress_where_it_is_asked_for(built_in, monkeypatch) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    terminal = Terminal()
    monkeypatch.setattr("sys.stderr", terminal)
    simulate(built_in("pendulum"), t_end=0.02, progress=True)
    assert "pendulum [" in terminal.getvalue()
    with Meter("quiet", io.StringIO()) as meter:
        meter(0.5, 1.0)


Load = Callable[[str], Model]


@pytest.mark.parametrize("steps, balanced", [(1, False), (2, True)])
def test_the_card_of_a_solution_has_a_balance_from_three_samples_on(built_in: Load, steps: int, balanced: bool) -> None:
    run = simulate(
        built_in("pendulum"), scheme="rk4", dt=1e-3, t_end=steps * 1e-3, seen_every=0.0, engine="interpreted"
    )
    assert ("energy balance" in run._repr_html_()) == balanced
