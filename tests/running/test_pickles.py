"""Models, solutions and steppers go to other processes by folder, hash and files."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from runtime import ModelError, load_model, simulate
from runtime.contract import loading
from runtime.model import Model
from symgen.generate import generate
from symgen.scene import SceneRecord
from tests.support.scenes import on_rail


def pushed(mass: float) -> SceneRecord:
    return (
        on_rail("pushed", "cart", "rail", mass=mass, inertia=0.1)
        .input("force", 0.0, "N")
        .force("push", "cart.origin", "force", 0.0)
        .simulation(t_end=0.1, dt=1e-3, scheme="rk4")
        .build()
    )


def test_models_and_solutions(model_of: Callable[[SceneRecord], Model]) -> None:
    model = model_of(pushed(2.0)).with_inputs({"force": lambda t: ca.sin(9 * t)})
    text = pickle.dumps(model)
    assert len(text) < 10_000
    run, copy = simulate(model), pickle.loads(text)
    np.testing.assert_array_equal(simulate(copy).q, run.q)
    again = pickle.loads(pickle.dumps(run))
    np.testing.assert_array_equal(again["cart.x"], run["cart.x"])
    assert again.status == run.status and again.model.digest == model.digest


def test_steppers_go_on_where_they_were(model_of: Callable[[SceneRecord], Model]) -> None:
    stepper = model_of(pushed(2.0)).stepper(dt=2e-3)
    stepper.step({"force": 3.0}, 10)
    copy = pickle.loads(pickle.dumps(stepper))
    for one in (stepper, copy):
        one.step(10)
    np.testing.assert_array_equal(copy.save().z, stepper.save().z)
    assert copy.time == stepper.time == pytest.approx(0.04)


def test_what_has_changed_is_not_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A pickle brings the model that was meant; of the changed folder no code runs."""
    meant = load_model(generate(pushed(2.0), tmp_path / "model"))
    text = pickle.dumps(meant)
    generate(pushed(2.0).model_copy(update={"title": "another"}), tmp_path / "model")
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    ran: list[Path] = []
    found, module = pickle.loads(text), loading._module
    assert found.digest == meant.digest and found.title != "another" and str(tmp_path / "cache") in found.folder
    with monkeypatch.context() as patch:
        patch.setattr(loading, "_module", lambda path, text: (ran.append(path), module(path, text))[1])
        pickle.loads(text)
        assert ran == [Path(found.folder) / "model.py"]
        ran.clear()
        with pytest.raises(ModelError, match="a different model"):
            load_model(tmp_path / "model", meant.digest)
    assert not ran
    with pytest.raises(ModelError, match="without one"):
        pickle.dumps(replace(load_model(tmp_path / "model"), folder=""))


def test_a_pickle_brings_the_files_of_its_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    model = load_model(generate(pushed(2.0), tmp_path / "here"))
    text = pickle.dumps(model)
    (tmp_path / "here").rename(tmp_path / "there")
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    assert pickle.loads(text).digest == load_model(tmp_path / "there").digest == model.digest


@pytest.mark.parametrize(
    "text",
    [b"cruntime.results.solution\nSolution\n.", b"cruntime.contract.loading\n_reloaded\n(Vfolder\nVdigest\ntR."],
    ids=["solution", "model"],
)
def test_pickles_of_an_older_version_are_refused(text: bytes) -> None:
    with pytest.raises(ModelError, match="was written by an older version"):
        pickle.loads(text)
