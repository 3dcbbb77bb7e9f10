"""Models, solutions and steppers go to other processes by folder and hash."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from runtime import load_model, simulate
from runtime.contract import loading
from runtime.contract.errors import ModelError
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
    """Neither by a pickle nor by a worker of an ensemble, and none of its code runs before that is seen."""
    meant = load_model(generate(pushed(2.0), tmp_path / "model"))
    text = pickle.dumps(meant)
    generate(pushed(2.0).model_copy(update={"title": "another"}), tmp_path / "model")
    ran: list[Path] = []
    with monkeypatch.context() as patch:
        patch.setattr(loading, "_module", lambda path, text: ran.append(path))
        with pytest.raises(ModelError, match="generated anew"):
            pickle.loads(text)
        with pytest.raises(ModelError, match="another model than was meant"):
            load_model(tmp_path / "model", meant.digest)
    assert not ran
    with pytest.raises(ModelError, match="without one"):
        pickle.dumps(replace(load_model(tmp_path / "model"), folder=""))


def test_a_pickle_wants_the_folder_of_its_model(tmp_path: Path) -> None:
    """As the guide says: another machine has not the folder; it derives the scene, or loads a copy of the folder."""
    model = load_model(generate(pushed(2.0), tmp_path / "here"))
    text = pickle.dumps(model)
    (tmp_path / "here").rename(tmp_path / "there")
    with pytest.raises(ModelError, match="here"):
        pickle.loads(text)
    assert load_model(tmp_path / "there").digest == model.digest
