"""Ensembles on executors and in folders: the bits of one process, whatever happens to workers."""

from __future__ import annotations

import json
import multiprocessing
import os
import pickle
import shutil
import signal
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from runtime import ArgumentError, ModelError, NoResult, load_model
from symgen import Scene
from symgen.generate import generate

CASES = 60


def pendulum() -> Scene:
    return (
        Scene("sent_pendulum").parameter("l", 0.5).gravity(0, -9.81)
        .rigid("arm", mass=1.0, inertia=0.1, center_of_mass=("l", 0))
        .revolute("pin", "ground.origin", "arm.origin")
    )  # fmt: skip


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    return load_model(generate(pendulum().build(), tmp_path_factory.mktemp("made") / "pendulum"))


ASKED = {
    "parameters": {"l": np.linspace(0.3, 0.7, CASES)},
    "initial": {"arm.theta": 0.2},
    "scheme": "rk4",
    "dt": 1e-3,
    "t_end": 0.5,
    "reduce": {"arm.theta": ["end", "peak"], "arm.theta_dot": "rms"},
}


@pytest.fixture(scope="module")
def here(model):
    return model.ensemble(**ASKED, workers=1)


def two_processes() -> ProcessPoolExecutor:
    return ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn"))


def test_threads_as_executor_give_the_same_bits(model, here) -> None:
    with ThreadPoolExecutor(2) as pool:
        assert model.ensemble(**ASKED, executor=pool, chunk=7).identical(here)


def test_histories_in_parts_too(model) -> None:
    asked = {key: value for key, value in ASKED.items() if key != "reduce"} | {"outputs": ["arm.theta"], "samples": 10}
    whole = model.ensemble(**asked)
    with ThreadPoolExecutor(2) as pool:
        assert model.ensemble(**asked, executor=pool, chunk=25).identical(whole)


def test_a_folder_keeps_parts_and_the_same_call_goes_on(model, here, tmp_path) -> None:
    class Stop(Exception):
        pass

    def after_three(done: int, cases: int) -> None:
        if done >= 30:
            raise Stop

    with pytest.raises(Stop):
        model.ensemble(**ASKED, folder=tmp_path / "study", chunk=10, progress=after_three)
    kept = sorted((tmp_path / "study").glob("part-*.npz"))
    assert len(kept) == 3
    kept[1].write_bytes(kept[1].read_bytes()[:100])  # a damaged part is worked out again
    stamps = {path: path.stat().st_mtime_ns for path in (kept[0], kept[2])}
    told: list[int] = []
    again = model.ensemble(**ASKED, folder=tmp_path / "study", chunk=10, progress=lambda done, _: told.append(done))
    assert again.identical(here) and told[-1] == CASES
    assert stamps == {path: path.stat().st_mtime_ns for path in stamps}  # what was done is not done again


def test_folders_of_other_studies_and_other_files_are_refused(model, tmp_path) -> None:
    model.ensemble(**ASKED, folder=tmp_path / "study", chunk=30)
    with pytest.raises(ArgumentError, match="holds another study: .* of sent_pendulum, 60 cases by 30"):
        model.ensemble(**ASKED | {"dt": 2e-3}, folder=tmp_path / "study", chunk=30)
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("dear")
    with pytest.raises(ArgumentError, match="holds other files"):
        model.ensemble(**ASKED, folder=tmp_path / "mine")
    assert [path.name for path in (tmp_path / "mine").iterdir()] == ["letter.txt"]


def test_results_on_disk_are_those_in_memory(model, here, tmp_path) -> None:
    pytest.importorskip("zarr")
    folder = tmp_path / "study"
    found = model.ensemble(**ASKED, folder=folder, chunk=25, on_disk=True)
    assert (folder / "results.zarr").is_dir()
    assert found.isel(case=slice(20, 40)).load().identical(here.isel(case=slice(20, 40)))
    again = model.ensemble(**ASKED, folder=folder, chunk=25, on_disk=True)  # parts are there, the store is new
    assert again.load().identical(here)
    histories = {key: value for key, value in ASKED.items() if key != "reduce"} | {
        "outputs": ["arm.theta"],
        "samples": 9,
    }
    stored = model.ensemble(**histories, folder=tmp_path / "other", chunk=25, on_disk=True)
    assert stored.load().identical(model.ensemble(**histories))
    refined = {key: value for key, value in ASKED.items() if key not in ("scheme", "dt")} | {"tolerance": 1e-4}
    stored = model.ensemble(**refined, folder=tmp_path / "refined", chunk=25, on_disk=True)
    assert stored.load().identical(model.ensemble(**refined))


def test_results_on_disk_need_a_folder_and_zarr(model, tmp_path, monkeypatch) -> None:
    with pytest.raises(ArgumentError, match="give folder"):
        model.ensemble(**ASKED, on_disk=True)
    monkeypatch.setattr("runtime.studies.ensemble.store.find_spec", lambda name: None)
    with pytest.raises(NoResult, match=r"symgen\[zarr\]"):
        model.ensemble(**ASKED, folder=tmp_path / "study", on_disk=True)
    assert not (tmp_path / "study").exists()


class Unreliable:
    """An executor of one worker that fails so many times."""

    _max_workers = 1

    def __init__(self, failures: int) -> None:
        self.failures = failures

    def submit(self, function, /, *arguments):
        owner = self

        class Work:
            def done(self) -> bool:
                return True

            def result(self):
                if owner.failures > 0:
                    owner.failures -= 1
                    raise OSError("the network is gone")
                return function(*arguments)

            def cancel(self) -> bool:
                return True

        return Work()


def test_parts_that_fail_are_tried_again(model, here, tmp_path) -> None:
    assert model.ensemble(**ASKED, executor=Unreliable(3), chunk=30).identical(here)
    with pytest.raises(NoResult, match=r"cases from \d+ on failed 2 times.*the network is gone.*same folder goes on"):
        model.ensemble(**ASKED, executor=Unreliable(9), chunk=30, retries=1, folder=tmp_path / "study")
    assert model.ensemble(**ASKED, folder=tmp_path / "study", chunk=30).identical(here)


def test_a_worker_of_another_version_is_named(model, monkeypatch) -> None:
    from runtime.studies.ensemble import parts

    old = parts.own_version()

    class Elsewhere(Unreliable):
        def submit(self, function, /, *arguments):
            def call(*given):
                monkeypatch.setattr(parts, "own_version", lambda: "0.0.1")
                try:
                    return function(*given)
                finally:
                    monkeypatch.setattr(parts, "own_version", lambda: old)

            return super().submit(call, *arguments)

    with pytest.raises(ModelError, match=r"this worker has symgen 0\.0\.1, the study was begun with"):
        model.ensemble(**ASKED, executor=Elsewhere(0), chunk=29)


def test_a_model_arrives_where_its_folder_is_not(model, tmp_path, monkeypatch) -> None:
    folder = tmp_path / "away"
    shutil.copytree(model.folder, folder)
    sent = pickle.dumps(load_model(folder))
    shutil.rmtree(folder)
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    found = pickle.loads(sent)
    assert found.digest == model.digest and str(tmp_path / "cache") in found.folder
    same = found.simulate(t_end=0.1, scheme="rk4", dt=1e-3), model.simulate(t_end=0.1, scheme="rk4", dt=1e-3)
    assert np.array_equal(same[0].q, same[1].q)
    text = Path(found.folder, "model.py")
    text.write_text(text.read_text() + "\n# edited\n")
    assert pickle.loads(sent).digest == model.digest and "# edited" not in text.read_text()  # written anew


def test_a_cache_open_to_others_is_not_used_for_what_arrives(model, tmp_path, monkeypatch) -> None:
    folder = tmp_path / "away"
    shutil.copytree(model.folder, folder)
    sent = pickle.dumps(load_model(folder))
    shutil.rmtree(folder)
    (tmp_path / "cache" / "sent").mkdir(parents=True)
    (tmp_path / "cache" / "sent").chmod(0o777)
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    found = pickle.loads(sent)
    assert found.digest == model.digest and found.folder == ""  # of a folder of this process, which is gone
    assert not list((tmp_path / "cache" / "sent").iterdir())


TO_TOLERANCE = {key: value for key, value in ASKED.items() if key not in ("scheme", "dt")} | {"tolerance": 1e-4}


@pytest.mark.long
@pytest.mark.parametrize("asked", [ASKED, TO_TOLERANCE], ids=["steps", "tolerance"])
def test_killed_workers_are_replaced(model, asked, tmp_path) -> None:
    killed: list[int] = []

    def kill_one(done: int, cases: int) -> None:
        if not killed and done >= 12:
            victim = multiprocessing.active_children()[0]
            killed.append(victim.pid)
            os.kill(victim.pid, signal.SIGKILL)

    found = model.ensemble(**asked, executor=two_processes, chunk=3, folder=tmp_path / "study", progress=kill_one)
    assert killed and found.identical(model.ensemble(**asked, workers=1))


@pytest.mark.long
def test_a_broken_pool_says_what_to_do_and_the_folder_goes_on(model, here, tmp_path) -> None:
    killed: list[int] = []

    def kill_one(done: int, cases: int) -> None:
        if not killed and done >= 6:
            victim = multiprocessing.active_children()[0]
            killed.append(victim.pid)
            os.kill(victim.pid, signal.SIGKILL)

    pool = two_processes()
    with pytest.raises(NoResult, match="its workers have died.*give a function that makes one"):
        model.ensemble(**ASKED, executor=pool, chunk=1, folder=tmp_path / "study", progress=kill_one)
    pool.shutdown(wait=False)
    header = json.loads((tmp_path / "study" / "study.json").read_text())
    assert header["cases"] == CASES
    assert model.ensemble(**ASKED, folder=tmp_path / "study", chunk=1).identical(here)


@pytest.mark.long
@pytest.mark.skipif(find_spec("distributed") is None, reason="dask.distributed is not installed")
def test_a_dask_cluster_whose_workers_have_never_seen_the_folder(model, here, tmp_path, monkeypatch) -> None:
    from dask.distributed import Client, LocalCluster

    folder = tmp_path / "away"
    shutil.copytree(model.folder, folder)
    sent = load_model(folder)
    pickle.dumps(sent)  # packs its files while they are there
    folder.rename(tmp_path / "hidden")
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    with (
        LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, local_directory=str(tmp_path)
        ) as cluster,
        Client(cluster) as client,
    ):
        found = sent.ensemble(**ASKED, executor=client.get_executor(), chunk=10)
    assert found.identical(here)
    assert any((tmp_path / "cache" / "sent").glob("*/model.py"))


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"chunk": 0, "folder": "x"}, "chunk: must be a whole number of at least 1, not 0"),
        ({"retries": -1}, "retries: must be a whole number of at least 0, not -1"),
        ({"chunk": 5}, "chunk: applies to parts only"),
        ({"executor": 3}, "executor"),
    ],
)
def test_what_cannot_be_used_is_named(model, given, says, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ArgumentError) as error:
        model.ensemble(**ASKED, **given)
    assert says in str(error.value)
    assert not list(tmp_path.iterdir())


@pytest.mark.long
def test_the_command_line_works_in_processes_and_keeps_parts(tmp_path, monkeypatch, capsys) -> None:
    from symgen.cli import main

    monkeypatch.chdir(tmp_path)
    words = "sweep pendulum --over length=lin:0.8:1.2:8 --outputs tip_y --t-end 0.1 --quiet".split()
    assert main([*words, "--out", "one.csv"]) == 0
    assert main([*words, "--out", "two.csv", "--processes", "2", "--folder", "study"]) == 0
    assert Path("one.csv").read_text() == Path("two.csv").read_text()
    assert [path.name for path in Path("study").glob("part-*")] == ["part-000000000.npz"]
