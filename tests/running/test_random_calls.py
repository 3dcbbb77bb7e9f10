"""Whatever is given to public functions, they answer with a result or an error of the project's own."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import pytest

from runtime import ArgumentError, SchemeError
from runtime.model import Model
from symgen.scene import Scene, SceneError, SceneRecord
from tests.support.random_calls import deep, faults, machine, targets

NAMES = ["hub.theta", "grip", "torque", "tip_y", "beam", "pivot", "hub.origin", "beam.q1"]


@pytest.mark.long
@pytest.mark.parametrize("seed", range(6))
def test_nonsense_is_refused_by_name(seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """500 calls with wrong kinds, values and shapes of one or two arguments."""
    monkeypatch.chdir(tmp_path)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = [f"{words}: {type(raw).__name__}: {raw}" for words, raw in faults(targets(tmp_path), seed, 500, NAMES)]
    assert not found, "\n".join(found)


@pytest.fixture(scope="module")
def model() -> Model:
    return machine().model()


SHORT: dict[str, Any] = {"t_end": 0.02, "scheme": "rk4", "dt": 1e-3}


@pytest.mark.parametrize("every", [-1, "", {"k": "x"}, 0, 1.5, True])
@pytest.mark.parametrize("how", [{"tolerance": 1e-3, "t_end": 0.02}, SHORT], ids=["tolerance", "steps"])
def test_intervals_of_checkpoints_are_counts(model: Model, every: Any, how: dict[str, Any]) -> None:
    """Under a tolerance, too, where they were taken without a word."""
    with pytest.raises((ArgumentError, SchemeError), match="checkpoint_every"):
        model.simulate(**how, checkpoint_every=every)


def test_what_is_no_study_is_named(model: Model) -> None:
    with pytest.raises((ArgumentError, SchemeError), match="seen_every"):
        model.ensemble(parameters={"grip": [1.0, 2.0]}, outputs=["tip_y"], **SHORT, seen_every=1e308)
    wrong: dict[str, Any] = {"points": -1, "states": -5, "m": -1, "progress": 5, "dt_range": (2.0, 1.0)}
    for name, value in wrong.items():
        with pytest.raises(ArgumentError, match=name):
            model.stability(scheme="rk4", t_end=0.02, **{name: value})
    data = {"t": [k * 1e-3 for k in range(21)], "tip_y": [0.0] * 21}
    with pytest.raises(ArgumentError, match="tip_y .deviation.*shape"):
        model.fit(data, ["grip"], deviation={"tip_y": [1.0, 2.0]}, **SHORT, seen_every=1e-3)
    with pytest.raises(ArgumentError, match="settle"):
        model.periodic(period=0.1, settle=10**30)


def test_lists_within_lists_are_named_at_any_depth(model: Model) -> None:
    with pytest.raises(SceneError, match="simulation.scheme"):
        SceneRecord.from_dict({"name": "a", "simulation": {"scheme": deep(3000)}})
    with pytest.raises(SceneError, match="nested too deeply"):
        Scene("a").simulation(scheme=deep(3000))
    nested: Any = deep(3000)
    with pytest.raises(ArgumentError, match="scheme"):
        model.simulate(scheme=nested)


def test_calls_by_place_are_told_the_name(model: Model) -> None:
    ask: Any = model
    with pytest.raises(ArgumentError, match="did you mean t_end=1.0"):
        ask.simulate(1.0)
    with pytest.raises(ArgumentError, match="parameters: is required by fit"):
        ask.fit({"t": [0.0]})


def test_a_wrong_word_of_a_scene_is_found_where_it_stands() -> None:
    """At the call, with what may be meant: a method, a keyword, a type, a name."""
    with pytest.raises(AttributeError, match="no method 'revolut'; did you mean 'revolute'"):
        Scene("s").revolut("hinge")
    number: Any = 3.0
    for call, words in (
        (lambda: Scene("s").rigid("b", mas=1.0), "bodies.0. 'b'.mas.*did you mean 'mass'"),
        (lambda: Scene("s").revolute("h", "a", "b", dampin=1.0), "joints.0. 'h'.dampin.*'damping'"),
        (lambda: Scene("s").measure("m", "distanc", "b.origin"), "measures.0. 'm'.type.*'distance'"),
        (lambda: Scene("s").joint("revolut", "h", "a", "b"), "joints.0. 'h'.type.*'revolute'"),
        (lambda: Scene("s").event("e", "t", dirction="rising"), "events.e.dirction.*'direction'"),
        (lambda: Scene("s").table("w", x=[0.0], yy=[0.0]), "tables.w.yy.*'y'"),
        (lambda: Scene("s").simulation(tend=1.0), "simulation.tend.*'t_end'"),
        (lambda: Scene("s", titel="x"), "titel.*'title'"),
        (lambda: Scene("s").input("u", rate=True), "inputs.u.rate.*'rates'"),
        (lambda: Scene("s").parameter(number, 1.0), "parameters.*not text"),
        (lambda: Scene("s").rates(number), "initial.rates.*not a table"),
    ):
        with pytest.raises(SceneError, match=words):
            call()
