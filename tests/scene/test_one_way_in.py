"""From a scene to answers in two calls: `scene.model()`, and the methods of a model."""

from __future__ import annotations

import inspect
import os
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import runtime
from runtime import Solution
from runtime.contract.lazy_method import LazyMethod
from runtime.model import Model
from symgen import Scene, SceneError, load_model
from symgen.generate import generate

PROGRAM = """
import sys
from symgen import Scene

scene = Scene("kept").rigid("rod", mass=2.0, inertia=0.3, free=True).rates({"rod.theta": 1.0})
assert scene.model().simulate(t_end=0.01).status.ok
print(*sys.modules)
"""
METHODS = [
    (kind, name) for kind in (Model, Solution) for name, one in vars(kind).items() if isinstance(one, LazyMethod)
]


def pendulum(length: float = 1.0) -> Scene:
    return (
        Scene("kept_pendulum")
        .gravity(0, -9.81)
        .rigid("rod", mass=2.0, inertia=0.3, markers={"top": {"position": [0.0, length]}})
        .revolute("hinge", "ground.origin", "rod.top")
        .initial({"rod.theta": 0.3})
    )


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache" / "models"


def test_a_scene_gives_a_model_and_a_model_a_motion(cache: Path, tmp_path: Path) -> None:
    """The motion is that of the generated folder, bit for bit, and its frequency that of a physical pendulum."""
    run = pendulum().model().simulate(t_end=0.5)
    assert run.status.ok and run.stats["tolerance"] == 1e-3
    own = runtime.simulate(load_model(generate(pendulum().build(), tmp_path / "own")), t_end=0.5)
    assert np.array_equal(run.q, own.q)
    (frequency,) = pendulum().model().modes(pendulum().model().equilibrium()).frequencies
    assert frequency == pytest.approx(np.sqrt(2.0 * 9.81 / (0.3 + 2.0)), rel=1e-9)


def test_a_model_is_generated_once(cache: Path) -> None:
    first = pendulum().model()
    (folder,) = cache.iterdir()
    written = (folder / "model.py").stat().st_mtime_ns
    assert pendulum().model().digest == first.digest
    assert (folder / "model.py").stat().st_mtime_ns == written
    pendulum(length=0.9).model()
    assert len(list(cache.iterdir())) == 2


def test_a_damaged_model_is_generated_again(cache: Path) -> None:
    pendulum().model()
    (folder,) = cache.iterdir()
    (folder / "model.py").write_text("raise SystemExit\n")
    assert pendulum().model().simulate(t_end=0.1).status.ok


@pytest.mark.skipif(os.name == "nt", reason="permissions are those of Unix")
def test_code_is_not_taken_from_a_folder_that_others_can_write(cache: Path) -> None:
    cache.mkdir(parents=True)
    cache.chmod(0o777)
    assert pendulum().model().simulate(t_end=0.1).status.ok
    assert not list(cache.iterdir())


def test_a_bad_scene_is_refused_by_its_item() -> None:
    with pytest.raises(SceneError, match="hinge"):
        pendulum().revolute("hinge", "ground.origin", "rod.top").model()


def test_a_file_is_a_scene_to_which_more_is_added(tmp_path: Path, cache: Path) -> None:
    (tmp_path / "pendulum.toml").write_text(pendulum().build().to_toml())
    scene = Scene.from_toml(tmp_path / "pendulum.toml")
    assert scene.build() == pendulum().build()
    assert scene.measure("angle", "coordinate", of="rod.theta").model().measures[0] == "angle"


@pytest.mark.parametrize(("kind", "name"), METHODS, ids=[f"{kind.__name__}.{name}" for kind, name in METHODS])
def test_methods_show_what_they_take(kind: type, name: str) -> None:
    """Each takes the object first, names every argument, and says what it does."""
    function = getattr(kind, name)
    known = list(inspect.signature(function).parameters)
    assert known[0] == kind.__name__.lower() and len(known) > 0
    assert (inspect.getdoc(function) or "").strip()
    assert name in dir(kind)


@pytest.mark.long
def test_a_kept_model_runs_without_what_derives(cache: Path) -> None:
    words = [sys.executable, "-c", PROGRAM]
    seen = [subprocess.run(words, capture_output=True, text=True, check=True).stdout.split() for _ in range(2)]
    assert "sympy" in seen[0]
    assert not {"sympy", "symgen.pipeline", "matplotlib"} & set(seen[1])


def long_scene() -> Scene:
    """48 coordinates, of which each function is derived when it is asked for."""
    scene, previous = Scene("kept_chain").gravity(0, -9.81), "ground.origin"
    for k in range(16):
        scene.rigid(f"b{k}", mass=1.0, inertia=0.1, markers={"end": {"position": [0.5, 0.0]}})
        scene.revolute(f"j{k}", previous, f"b{k}.origin")
        previous = f"b{k}.end"
    return scene


LONG_PROGRAM = f"""
import sys
from symgen import Scene

{inspect.getsource(long_scene)}
run = long_scene().model().simulate(t_end=0.01, dt=1e-3, scheme="rk4")
assert run.status.ok
print(run.q.tobytes().hex(), *(name for name in sys.modules if name in ("symgen.pipeline", "symgen.derivation")))
"""


@pytest.mark.long
def test_functions_of_a_large_scene_are_derived_once_and_kept(cache: Path) -> None:
    words = [sys.executable, "-c", LONG_PROGRAM]
    first, second = (subprocess.run(words, capture_output=True, text=True, check=True).stdout.split() for _ in "ab")
    assert "symgen.pipeline" in first and second == first[:1]  # the same bits, and nothing derives
    (folder,) = cache.iterdir()
    assert {"forward_dynamics", "constraints"} <= {path.name for path in (folder / "functions").iterdir()}
    assert "augmented" not in {path.name for path in (folder / "functions").iterdir()}
    for path in (folder / "functions").iterdir():
        path.write_bytes(path.read_bytes()[:-1] + b"?")
    third = subprocess.run(words, capture_output=True, text=True, check=True).stdout.split()
    assert third[:1] == first[:1]


def test_what_a_large_scene_was_not_asked_for_is_derived_later(cache: Path) -> None:
    model = long_scene().model()
    assert "augmented" not in model.operations and model.has("augmented")
    q = np.random.default_rng(1).standard_normal(48)
    values = {"q": q, "q_dot": q[::-1], "t": 0.0, "c": model.constants(model.parameter_vector())}
    found = [one.evaluate("augmented", **values)["M"] for one in (model, long_scene().model(), long_scene().model())]
    masses = np.tile([1.0, 1.0, 0.1], 16)
    assert all(np.array_equal(np.asarray(M), np.diag(masses)) for M in found)


def test_a_large_model_goes_to_other_machines_with_the_functions_that_it_has(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Pickled after a run; there, where its folder and the generator are not, the same run has the same bits."""
    model = long_scene().model()
    settings = {"t_end": 0.01, "dt": 1e-3, "scheme": "rk4", "error": "off"}
    run = model.simulate(**settings)
    sent = pickle.dumps(model)
    monkeypatch.setattr("importlib.metadata.entry_points", lambda group: ())
    assert np.array_equal(pickle.loads(sent).simulate(**settings).q, run.q)  # from its folder
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "there"))
    (folder,) = cache.iterdir()
    folder.rename(tmp_path / "gone")
    assert np.array_equal(pickle.loads(sent).simulate(**settings).q, run.q)  # of its files
    assert (tmp_path / "there" / "sent").is_dir()
