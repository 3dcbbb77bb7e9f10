"""Studies of many cases: what goes in, what comes out, what is refused, and what is left of one that was stopped."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import Any

import numpy as np
import pandas
import pytest
from scipy.stats import qmc

from runtime import SymgenError, ensemble
from runtime.model import Model
from runtime.studies.ensemble import ensemble_result
from tests.support.pendula import SHORT, pendula

pytestmark = pytest.mark.long

Load = Callable[[str], Model]


@pytest.mark.usefixtures("ctrl_c")
def test_ctrl_c_keeps_what_is_done(built_in: Load) -> None:
    """Cases that were not run are `interrupted`; those that were have their values."""
    told: list[float] = []

    def press(done: float, cases: float) -> None:
        if not told:
            signal.raise_signal(signal.SIGINT)
        told.append(done)

    model = built_in("pendulum")
    found = pendula(model, 9000, seen_every=5e-3, workers=1, progress=press)
    done = int(told[-1])
    assert 0 < done < 9000 and (found["status"][:done] == "completed").all()
    assert (found["status"][done:] == "interrupted").all() and np.isnan(found["tip_y"][done:]).all()
    np.testing.assert_array_equal(found["tip_y"][:5], pendula(model, 9000, seen_every=5e-3)["tip_y"][:5])


# ---- what goes in and out -----------------------------------------------------------------------------------------


def test_samples_and_tables_go_straight_in(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """And without xarray a dictionary of the same arrays comes out."""
    model = built_in("pendulum")
    points = qmc.scale(qmc.LatinHypercube(2, rng=1).random(6), [0.5, 0.9], [1.0, 1.1])
    mass = next(parameter.name for parameter in model.parameters if parameter.name == "rod.mass")
    columns = {mass: points[:, 0].tolist(), "length": points[:, 1].tolist()}
    settings: dict[str, Any] = {**SHORT, "reduce": {"tip_y": "end"}}
    by_name = ensemble(model, dict(zip((mass, "length"), points.T, strict=True)), **settings)
    assert by_name.identical(ensemble(model, pandas.DataFrame(columns), **settings))
    np.testing.assert_array_equal(by_name["length"], points[:, 1])
    monkeypatch.setattr(ensemble_result, "find_spec", lambda name: None)
    plain = ensemble(model, columns, **settings)
    assert isinstance(plain, dict) and set(plain) == {
        "case",
        mass,
        "length",
        "status",
        "time_reached",
        "tip_y_end",
    }
    np.testing.assert_array_equal(plain["tip_y_end"], by_name["tip_y_end"])


@pytest.mark.parametrize(
    "given, words",
    [
        ({"parameters": {"rod.colour": [1.0, 2.0]}}, "rod.colour"),
        ({"initial": {"rod.phi": [1.0, 2.0]}}, "rod.phi"),
        ({"parameters": {"rod.mass": [1.0, 2.0]}, "initial": {"rod.theta": [1.0, 2.0, 3.0]}}, "rod.theta.*3 values.*2"),
        ({"parameters": {"rod.mass": [1.0, float("nan")]}}, r"rod.mass\[1\].*nan"),
        ({"parameters": {"rod.mass": [1.0, -2.0]}}, r"rod.mass\[1\].*at least zero"),
        ({"parameters": {"rod.mass": np.ones((4, 3))}}, r"rod.mass.*shape \(4, 3\)"),
        ({"parameters": {"rod.mass": "heavy"}}, "rod.mass"),
        ({"parameters": {"rod.mass": 1.0}}, "one case"),
        ({"parameters": [1.0, 2.0]}, "parameters.*names"),
        ({"outputs": ["tip_z"]}, "tip_z"),
        ({"outputs": "tip_y"}, "outputs.*list"),
        ({"outputs": ["tip_y"], "reduce": {"tip_x": "max"}}, "tip_x.*none of the outputs"),
        ({"reduce": {"tip_y": "median"}}, "median.*max"),
        ({"reduce": {"tip_y": "max"}, "seen_every": 3e-3}, "reduce and seen_every"),
        ({"seen_every": -1.0}, "seen_every"),
        ({"inputs": {"push": [1.0, 2.0]}}, "no input 'push'"),
        ({"workers": 0}, "workers"),
        ({"scheme": "fastest"}, "fastest"),
    ],
)
def test_bad_input_is_named(built_in: Load, given: dict[str, Any], words: str) -> None:
    usual: dict[str, Any] = {**SHORT, "parameters": {"rod.mass": [1.0, 2.0]}, "outputs": ["tip_y"]}
    if "reduce" in given and "outputs" not in given:
        usual["outputs"] = None
    if "initial" in given and "parameters" not in given:
        usual["parameters"] = None
    with pytest.raises(SymgenError, match=words):
        ensemble(built_in("pendulum"), **{**usual, **given})
