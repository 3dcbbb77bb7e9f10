"""`symgen sweep` as a user calls it: every combination is a case, files hold the answer, mistakes are named."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import ensemble
from runtime.model import Model
from symgen.cli import main

SWEEP = ["sweep", "pendulum", "--over", "length=lin:0.9:1.1:3", "--over", "rod.theta_dot=0.5,2", "--t-end", "0.02"]


@pytest.mark.long
def test_every_combination_is_a_case(built_in: Callable[[str], Model], capsys, tmp_path: Path) -> None:
    """The table reads back as the answer of `ensemble`, bit for bit; the picture lies beside it."""
    path = tmp_path / "study.csv"
    code = main([*SWEEP, "--outputs", "tip_y", "--reduce", "max,end", "--out", str(path), "--json"])
    report = json.loads(capsys.readouterr().out)
    assert code == 0 and report["cases"] == 6 and report["status"] == {"completed": 6}
    lengths, speeds = np.repeat([0.9, 1.0, 1.1], 2), np.tile([0.5, 2.0], 3)
    expected = ensemble(
        built_in("pendulum"),
        {"length": lengths},
        {"rod.theta_dot": speeds},
        t_end=0.02,
        reduce={"tip_y": ["max", "end"]},
    )
    with path.open() as lines:
        rows = list(csv.DictReader(lines))
    for name in ("length", "initial.rod.theta_dot", "tip_y_max", "tip_y_end", "time_reached"):
        head = next(one for one in rows[0] if one.partition(" [")[0] == name)
        np.testing.assert_array_equal([float(row[head]) for row in rows], expected[name])
    assert {row["status"] for row in rows} == {"completed"} and "tip_y_max [m]" in rows[0]
    assert (tmp_path / "study.png").stat().st_size > 1000


def test_histories_as_a_table(capsys, tmp_path: Path) -> None:
    """A row a case and time, digits that read back exactly."""
    path = tmp_path / "study.csv"
    assert main([*SWEEP, "--outputs", "tip_y", "--seen-every", "0.01", "--out", str(path), "-q"]) == 0
    with path.open() as lines:
        rows = list(csv.DictReader(lines))
    assert [(row["case"], row["time [s]"]) for row in rows[:4]] == [
        ("0", "0"),
        ("0", "0.01"),
        ("0", "0.02"),
        ("1", "0"),
    ]
    assert len({row["tip_y [m]"] for row in rows}) > 9
    assert len(rows) == 18 and {row["status"] for row in rows} == {"completed"}


@pytest.mark.parametrize(
    "words, named",
    [
        (["--over", "length=lin:1:2"], "length=lin:1:2"),
        (["--over", "length=log:-1:2:5"], "length=log:-1:2:5"),
        (["--over", "width=1,2"], "width"),
        (["--over", "length=1,2", "--over", "length=3,4"], "twice"),
        (["--over", "length=1,2", "--out", "study.txt"], "study.txt"),
        (["--over", "length=1,2", "--seen-every", "2", "--reduce", "max"], "--reduce and samples"),
    ],
)
def test_mistakes_are_named(capsys, words: list[str], named: str) -> None:
    assert main(["sweep", "pendulum", *words, "--outputs", "tip_y", "--t-end", "0.02"]) == 2
    assert named in capsys.readouterr().err
