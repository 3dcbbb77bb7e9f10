"""What both halves agree on: records in the manifest, no knowledge in the spelling of names, bounds by use."""

from __future__ import annotations

import ast
import json
import re
from itertools import accumulate
from pathlib import Path

import numpy as np
import pytest

from runtime import ModelError, load_model
from runtime.contract.loading import FORMAT, described
from runtime.contract.records import STAGES, as_plain, description
from symgen.scene import Scene
from symgen.scenes import SCENES, generated_folder

ROOT = Path(__file__).resolve().parents[2]
BARE_NUMBER = re.compile(r"\s*-?\d+(\.\d*)?(e[-+]?\d+)?\s*,?\s*(#.*)?")
MOST_BARE_NUMBERS = 0.05
TAKING_APART = {"partition", "rpartition", "split", "rsplit", "startswith", "endswith", "removesuffix", "removeprefix"}
# text that is no name of a coordinate, row or parameter: commands, file endings, module names, keys of arrays, methods
READERS_OF_TEXT = {
    "runtime/contract/files.py",  # names of temporary files
    "runtime/contract/cache.py",  # the same
    "runtime/contract/arguments.py",  # annotations, paths
    "runtime/contract/errors.py",  # lines of a message
    "runtime/contract/escapes.py",  # text for other formats
    "runtime/engine/native_text.py",  # LLVM IR
    "runtime/engine/gpu.py",  # the same
    "runtime/schemes/switching/native_events.py",  # declarations of a header in C
    "runtime/results/impacts.py",  # columns of elements, by an ending that no name of a scene has
    "runtime/running/domains.py",  # items of the scene
    "runtime/engine/c_source.py",  # C
    "runtime/export/c_bundle.py",  # names in C
    "runtime/export/fmu.py",  # names of files, commands
    "runtime/export/fmu_texts.py",  # units, as XML says them; rates by their ending
    "runtime/contract/tape.py",  # names of functions in emitted code
    "runtime/results/run_settings.py",  # options of a run, as its statistics say them
    "runtime/results/stream.py",
    "runtime/results/export.py",
    "runtime/results/solution.py",  # where modules have moved to
    "runtime/results/dataset.py",  # what a column means, for xarray
    "runtime/results/motion_error.py",  # a state is judged as itself and as its integral
    "runtime/solutions/solution.py",  # columns of the CSV
    "runtime/running/columns.py",
    "runtime/views/viewer/page.py",  # a template in HTML
    "runtime/export/jax_functions.py",  # names of CasADi's and of JAX's operations
    "runtime/studies/convergence.py",  # names that scenes of one mechanism share, by body
}


OF_EXPRESSIONS = "runtime/running/domains.py"  # names the argument of an expression of the scene that has no value


def text_taken_apart(path: Path) -> set[str]:
    """Modules for patterns that the file imports and methods that split text that it calls."""
    nodes = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
    imported = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    imported |= {node.module for node in nodes if isinstance(node, ast.ImportFrom) and node.module}
    if path.as_posix().endswith(OF_EXPRESSIONS):
        imported -= {"tomllib"}
    assert not {"tomllib", "tomli"} & imported, path
    methods = [node.func for node in nodes if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)]
    called = {method.attr for method in methods if not (isinstance(method.value, ast.Name) and method.value.id == "np")}
    return {"re", "fnmatch"} & imported | called & TAKING_APART


def test_no_file_of_the_runtime_takes_names_apart() -> None:
    """No method that splits text, but for files that read text of another kind; of TOML expressions alone."""
    taking = {path.relative_to(ROOT).as_posix() for path in (ROOT / "runtime").rglob("*.py") if text_taken_apart(path)}
    assert taking == READERS_OF_TEXT


@pytest.mark.parametrize("name", ["flexible_slider_crank", "heavy_top", "two_oscillators"])
def test_records_survive_the_manifest(name: str) -> None:
    model = load_model(generated_folder(name))
    assert description(json.loads(json.dumps(as_plain(model.description)))) == model.description
    manifest = json.loads((generated_folder(name) / "manifest.json").read_text(encoding="utf-8"))
    defaults = {entry.name: entry.default for entry in model.parameters}
    assert described(manifest, defaults) == model.description


@pytest.mark.parametrize("name", ["flexible_slider_crank", "bricard", "chain", "two_oscillators"])
def test_functions_stand_on_a_ladder(name: str) -> None:
    """What a function takes is known at its stage; sizes are those of the emitted Function."""
    known = dict(zip(STAGES, accumulate(STAGES.values()), strict=True))
    model = load_model(generated_folder(name))
    for spec in model.description.functions:
        assert {signal.name for signal in spec.inputs} <= set(known[spec.stage]), spec.name
        kernel = model.kernel(spec.name)
        assert [tuple(signal.size) for signal in spec.inputs] == [kernel.size_in(k) for k in range(kernel.n_in())]
        assert [tuple(signal.size) for signal in spec.outputs] == [kernel.size_out(k) for k in range(kernel.n_out())]
        assert [signal.name for signal in (*spec.inputs, *spec.outputs)] == [*kernel.name_in(), *kernel.name_out()]


@pytest.mark.parametrize("name", SCENES)
def test_few_lines_are_bare_numbers(name: str) -> None:
    lines = (generated_folder(name) / "model.py").read_text(encoding="utf-8").splitlines()
    assert sum(bool(BARE_NUMBER.fullmatch(line)) for line in lines) <= MOST_BARE_NUMBERS * len(lines)


def test_an_older_format_is_refused_by_name(tmp_path: Path) -> None:
    (tmp_path / "manifest.json").write_text(json.dumps({"format": 1, "scene": "pendulum"}))
    with pytest.raises(ModelError, match=rf"symgen 0.3 or older.*{FORMAT}.*symgen generate"):
        load_model(tmp_path)


def rod(**fields: object) -> Scene:
    """A pendulum whose numbers are parameters with names that say nothing."""
    builder = Scene("rod").gravity(0.0, -9.81).parameter("a", 2.0).parameter("b", 0.5).parameter("mass", -3.0)
    values = {"mass": "a", "inertia": "a*b**2/3", "center_of_mass": ["b", 0.0], **fields}
    return builder.rigid("bar", **values).revolute("hinge", "ground.origin", "bar.origin")


def test_the_bound_of_a_parameter_belongs_to_its_use(model_of) -> None:
    """`a` is a mass, `b` a distance that may be negative, `mass` is not used as one; a*b**2/3 is an inertia."""
    model = model_of(rod().torque("motor", "bar.origin", "mass").build())
    bounds = {entry.name: entry.bound for entry in model.parameters if entry.kind == "declared"}
    assert bounds == {"a": "not negative", "b": "any", "mass": "any"}
    model.parameter_vector({"mass": -1.0, "b": -0.2})
    with pytest.raises(ModelError, match="'a' must be at least zero"):
        model.parameter_vector({"a": -0.2})


def test_an_expression_must_keep_its_sign(model_of) -> None:
    model = model_of(rod(mass="a - b").build())
    assert [(entry.item, entry.bound) for entry in model.description.bounded] == [
        ("bar.mass", "not negative"),
        ("bar.inertia", "not negative"),
    ]
    model.parameter_vector({"a": 0.6})
    with pytest.raises(ModelError, match=r"bar.mass = 'a - b' would be -0.1 but must be at least zero"):
        model.parameter_vector({"a": 0.4})


def test_evaluate_takes_what_it_needs_and_names_what_is_missing(model_of) -> None:
    model = load_model(generated_folder("pendulum"))
    c = model.constants(model.parameter_vector())
    q = model.initial_q
    values = {"q": q, "q_dot": np.zeros(len(q)), "t": 0.0, "c": c, "unknown": 1.0}
    kernel = model.kernel("energy")
    direct = kernel(**{name: values[name] for name in kernel.name_in()})
    assert {key: float(value) for key, value in model.evaluate("energy", **values).items()} == {
        key: float(direct[key]) for key in kernel.name_out()
    }
    with pytest.raises(ModelError, match="needs.* q"):
        model.evaluate("energy", c=c)


@pytest.mark.parametrize(
    "name, conservative",
    [("pendulum", True), ("flexible_slider_crank_free", True), ("flexible_slider_crank_torque", False)],
)
def test_conservative(name: str, conservative: bool) -> None:
    assert load_model(generated_folder(name)).conservative is conservative


def test_parameters_print_what_one_would_change() -> None:
    """Those of the scene, one a line; of the hundreds of numbers of shapes no more than how many there are."""
    parameters = load_model(generated_folder("flexible_slider_crank_free")).parameters
    own = [entry.name for entry in parameters if entry.kind != "data" and not entry.array]
    lines = repr(parameters).splitlines()
    assert [line.split()[0] for line in lines[: len(own)]] == own and len(own) < len(parameters) / 2
    assert lines[-1] == f"and {len(parameters) - len(own)} numbers of shapes, tables and meshes (kind data)"
