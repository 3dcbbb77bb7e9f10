"""Folders that leave functions out: what is there, what is derived on demand, and with the same bits."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from runtime import ModelError, load_model, simulate
from runtime.model import Model
from symgen.cli import main
from symgen.cli.runs import results_of
from symgen.cli.sources import opened_model
from symgen.generate import check, generate, leave, model_of
from symgen.scenes import SCENES
from symgen.scenes.pendulums import chain

QUADRATIC = {"condensed", "blocks", "augmented", "residual_jacobian", "dQ_hat_dq_i", "dQ_hat_dq_i_dot", "substep_2"}


@pytest.fixture(scope="module")
def ran() -> Model:
    """The hub beam after a run that asked for few functions."""
    model = model_of(SCENES["hub_beam"]())
    assert simulate(model, t_end=0.02, scheme="single_rate").status.ok
    return model


@pytest.fixture(scope="module")
def folder(ran: Model, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return leave(ran, tmp_path_factory.mktemp("left") / "model")


def test_what_ran_is_written_and_the_rest_named(ran: Model, folder: Path) -> None:
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    written, named = [entry["name"] for entry in manifest["functions"]], manifest["left_out"]
    assert {*written, "bounded"} == {*ran.operations, "bounded"} and "forward_dynamics" in written
    assert check(SCENES["hub_beam"](), folder) == ""
    assert sorted(written + named) == sorted(ran.builders) and "augmented" in named
    text, page = ((folder / name).read_text(encoding="utf-8") for name in ("model.py", "model.md"))
    assert "def forward_dynamics" in text and "def augmented" not in text
    assert all(f"`{name}`" in page.split("Not in this folder:")[1] for name in named)


@pytest.mark.long
def test_the_folder_runs_with_the_bits_of_the_run_it_was_left_by(ran: Model, folder: Path) -> None:
    loaded = load_model(folder)
    for scheme in ("single_rate", "exponential"):  # the latter asks for what is left out
        found, wanted = (simulate(model, t_end=0.02, scheme=scheme) for model in (loaded, ran))
        assert found.status.ok and np.array_equal(found.q, wanted.q) and np.array_equal(found.q_dot, wanted.q_dot)


def test_functions_left_out_are_derived_when_asked_for(ran: Model, folder: Path) -> None:
    loaded, rng = load_model(folder), np.random.default_rng(5)
    assert loaded.has("augmented") and not loaded.has("substep_7") and "augmented" not in loaded.operations
    kernel = loaded.kernel("augmented")
    values = {name: rng.standard_normal(kernel.size_in(name)) for name in kernel.name_in() if name != "c"}
    values["c"] = loaded.constants(loaded.parameter_vector())
    found, wanted = loaded.evaluate("augmented", **values), ran.evaluate("augmented", **values)
    assert all(np.array_equal(np.asarray(found[name]), np.asarray(wanted[name])) for name in wanted)
    assert loaded.operations["augmented"] == ran.operations["augmented"]


def test_without_a_generator_the_missing_function_is_refused_by_name(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("importlib.metadata.entry_points", lambda group: ())
    model = load_model(folder)
    assert simulate(model, t_end=0.01, scheme="single_rate").status.ok  # all that this needs is there
    with pytest.raises(ModelError, match="no generator is installed.*symgen generate .* --complete"):
        model.kernel("augmented")


def test_a_generator_that_derives_another_model_is_refused(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    class Other:
        def load(self) -> object:
            return lambda text: model_of(SCENES["pendulum"]())

    monkeypatch.setattr("importlib.metadata.entry_points", lambda group: [Other()])
    with pytest.raises(ModelError, match="derives another model"):
        load_model(folder).kernel("augmented")


@pytest.mark.long
def test_a_long_tree_is_written_without_what_grows_with_its_square(tmp_path: Path) -> None:
    scene = chain(8)
    whole = generate(scene, tmp_path / "all", largest=len(scene.coordinates()))
    assert not load_model(whole).builders.keys() ^ model_of(scene).builders.keys()
    short = generate(scene, tmp_path / "short", largest=len(scene.coordinates()) - 1)
    manifest = json.loads((short / "manifest.json").read_text(encoding="utf-8"))
    assert set(manifest["left_out"]) <= QUADRATIC and {"condensed", "augmented"} <= {*manifest["left_out"]}
    assert check(scene, short) == "" and check(scene, short, complete=True) != ""
    generate(scene, short, complete=True)
    assert "left_out" not in json.loads((short / "manifest.json").read_text(encoding="utf-8"))


def test_simulate_leaves_the_model_of_its_run(tmp_path: Path) -> None:
    scene, out = tmp_path / "beam.toml", tmp_path / "out"
    scene.write_text(SCENES["hub_beam"]().to_toml(), encoding="utf-8")
    words = ["--t-end", "0.02", "--no-plots", "--scheme", "single_rate", "--out", str(out)]
    assert main(["simulate", str(scene), *words]) == 0
    results = results_of(out)  # read with the model beside them
    assert "blocks" not in results.model.operations and "forward_dynamics" in results.model.operations
    path, stopped = tmp_path / "run.npz", []

    def stop(t: float, t_end: float) -> None:
        stopped.append(t)
        if len(stopped) == 2:
            raise KeyboardInterrupt

    model = opened_model(str(scene))
    part = simulate(model, t_end=0.02, scheme="single_rate", checkpoint=path, checkpoint_every=3, progress=stop)
    assert not part.status.ok
    scene.unlink()
    on = tmp_path / "on"
    assert main(["resume", str(path), str(out / "model"), "--out", str(on)]) == 0
    assert np.array_equal(results_of(on).q, results.q)


def test_a_folder_of_somebody_else_is_refused_before_the_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mine = tmp_path / "out" / "model" / "model.py"
    mine.parent.mkdir(parents=True)
    mine.write_text("mine = 1\n", encoding="utf-8")
    assert main(["simulate", "pendulum", "--t-end", "0.01", "--out", str(tmp_path / "out")]) == 2
    assert "was not written by symgen" in capsys.readouterr().err
    assert mine.read_text(encoding="utf-8") == "mine = 1\n" and not (tmp_path / "out" / "solution.npz").exists()
