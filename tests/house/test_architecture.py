"""Walls of the architecture, by walking the AST: imports, dangerous calls, docstrings."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from graphlib import TopologicalSorter
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import generated
import runtime
import symgen
from runtime import SCHEMES
from symgen import scene

ROOT = Path(__file__).resolve().parents[2]
OWN = ("symgen", "runtime", "tests", "benchmarks", "examples")
FORBIDDEN_CALLS = {"eval", "exec", "sympify", "compile", "__import__", "parse_expr"}
FORBIDDEN_IMPORTS = {"pickle", "cloudpickle", "dill", "marshal", "shelve"}
SUSPECT = re.compile("|".join([*FORBIDDEN_CALLS, *FORBIDDEN_IMPORTS, "shell"]))  # without these words a file is clean

# The packages of each half, from what everything stands on to what stands on everything, and what each may import.
# They are folders or files directly under the half; "" is the half's own __init__.py.
RUNTIME_PACKAGES = {
    "contract": "",
    "engine": "contract",
    "schemes": "contract engine",
    "results": "contract engine schemes",
    "operating": "contract schemes results",
    "views": "contract schemes results operating",
    "solutions": "contract engine schemes results operating views",
    "start": "contract schemes operating",
    "baselines": "contract engine schemes start solutions",
    "running": "contract engine schemes start results solutions operating baselines",
    "export": "contract engine schemes start baselines running",
    "gradients": "contract engine schemes start results solutions operating running views",
    "orbits": "contract schemes results solutions operating running gradients views",
    "studies": "baselines contract engine schemes start results solutions operating running gradients orbits views",
    "structures": "contract engine results views",
    "model": "contract operating baselines running export gradients orbits studies views",
    "": "contract schemes results solutions operating baselines running gradients orbits studies views model",
}
SYMGEN_PACKAGES = {
    "notation": "",
    "modes": "",
    "fe": "modes",
    "schema": "",
    "joints": "schema",
    "loads": "joints schema",
    "couplings": "joints loads schema",
    "scene": "couplings joints loads schema",
    "algebra": "scene schema",
    "bodies": "algebra modes scene",
    "system": "algebra bodies couplings joints loads scene schema",
    "choice": "algebra system",
    "condensed": "algebra system choice",
    "kernels": "notation algebra system choice condensed",
    "tapes": "system kernels",
    "pipeline": "choice condensed kernels scene system tapes",
    "emission": "notation pipeline scene schema",
    "derivation": "emission pipeline",
    "mechanism": "couplings derivation joints loads scene schema",
    "generate": "derivation mechanism",
    "urdf": "joints mechanism scene schema",
    "scenes": "mechanism scene",
    "variants": "emission mechanism pipeline scene",
    "refinement": "mechanism schema",
    "cli": "kernels emission generate mechanism pipeline scene scenes schema urdf",
    "": "cli mechanism schema",
}
PACKAGES = {"runtime": RUNTIME_PACKAGES, "symgen": SYMGEN_PACKAGES}
# Imports inside functions that point upwards, (module, what it imports): there are none.
UPWARDS: set[tuple[str, str]] = set()
# Names that a package gives when they are asked for are where they stand.
GIVEN = {f"runtime.{name}": f"runtime.{home}.{name}" for name, home in runtime._HOMES.items()} | {
    f"{package.__name__}.{name}": f"{home}.{name}"
    for package in (symgen, scene)
    for name, home in package._HOMES.items()
}


def files(*folders: str) -> list[Path]:
    return sorted(path for folder in folders for path in (ROOT / folder).rglob("*.py"))


def module_name(path: Path) -> str:
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"), filename=str(path))


@cache
def imports(path: Path) -> tuple[str, ...]:
    """Absolute names of every module the file imports, inside functions too; what only types need is free."""
    return tuple(_imports(path))


def for_types(node: ast.AST) -> bool:
    """Is it `if TYPE_CHECKING:`?"""
    return isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"


def run_nodes(node: ast.AST) -> Iterator[ast.AST]:
    """All below it but what only type checkers read."""
    for child in ast.iter_child_nodes(node):
        if for_types(child):
            for other in child.orelse:  # type: ignore[attr-defined]
                yield other
                yield from run_nodes(other)
        else:
            yield child
            yield from run_nodes(child)


def _imports(path: Path) -> Iterator[str]:
    package = module_name(path) if path.name == "__init__.py" else module_name(path).rpartition(".")[0]
    for node in run_nodes(tree(path)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level:
                parents = package.split(".")[: len(package.split(".")) - node.level + 1]
                base = ".".join([*parents, *([base] if base else [])])
            names = [f"{base}.{alias.name}" for alias in node.names]
            if any(name not in GIVEN for name in names):
                yield base
            yield from (GIVEN.get(name, name) for name in names)


def within(name: str, package: str) -> bool:
    return name == package or name.startswith(package + ".")


def offences(rule: Callable[[Path], Iterable[Any]], *folders: str) -> dict[str, list[Any]]:
    """What every file of the folders does against the rule, by the names of the files that do."""
    found = {module_name(path): list(rule(path)) for path in files(*folders)}
    assert found
    return {name: wrong for name, wrong in found.items() if wrong}


def test_packages_are_ours() -> None:
    for package in (runtime, symgen, generated):
        assert package.__file__ is not None
        assert Path(package.__file__).resolve().is_relative_to(ROOT)


def of_the_generator(path: Path) -> list[str]:
    return [name for name in imports(path) if any(within(name, other) for other in ("symgen", "sympy", "generated"))]


def test_runtime_imports_neither_symgen_nor_sympy() -> None:
    assert not offences(of_the_generator, "runtime")


def test_runtime_loads_without_the_generator() -> None:
    """In a fresh interpreter: importing runtime and running a model brings in no symgen, sympy or pydantic, and of
    SciPy, whose import takes longer than the run, only what the default run needs: nothing."""
    folder = ROOT / "generated" / "pendulum"
    program = (
        "import sys, runtime; runtime.simulate(runtime.load_model(sys.argv[1]), t_end=0.1); "
        "print(sorted({'symgen', 'sympy', 'pydantic', 'scipy.integrate', 'scipy.sparse'} & set(sys.modules)))"
    )
    result = subprocess.run([sys.executable, "-c", program, str(folder)], cwd=ROOT, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert result.stdout.strip() == "[]"


def test_generated_code_imports_casadi_only() -> None:
    assert not offences(lambda path: {name.split(".")[0] for name in imports(path)} - {"casadi"}, "generated")


def beyond_the_contract(path: Path) -> list[str]:
    taken = [name for name in imports(path) if within(name, "runtime")]
    given = ("runtime.contract", "runtime.model", "runtime.structures")
    return [name for name in taken if not any(within(name, one) for one in given)]


def test_derivation_takes_from_the_runtime_the_contract_only() -> None:
    """And the classes of models, which it gives to users; the command line is there to bring both halves together."""
    found = offences(beyond_the_contract, "symgen")
    assert not {name: taken for name, taken in found.items() if not within(name, "symgen.cli")}


def package_of(module: str, half: str) -> str:
    """The package of a module: its first name below the half; __main__ is the half's own."""
    first = module.partition(".")[2].partition(".")[0] if module != half else ""
    return "" if first == "__main__" else first


@pytest.mark.parametrize("package", PACKAGES)
def test_packages_are_as_the_map_says(package: str) -> None:
    """Every package is on the map, in an order in which nothing imports what stands later: so there are no circles."""
    map_ = PACKAGES[package]
    modules = [module_name(path) for path in files(package)]
    assert {package_of(module, package) for module in modules} == set(map_)
    order = list(map_)
    for name, uses in map_.items():
        assert all(order.index(used) < order.index(name) for used in uses.split()), f"{name} stands too low"


def edges(path: Path) -> list[tuple[str, str]]:
    """(module, file of its package that it imports), those that point upwards left out."""
    module = module_name(path)
    package = module.partition(".")[0]
    known = modules(package)
    names = {name for name in imports(path) if within(name, package)}
    targets = {next(own for own in lines_up(name) if own in known) for name in names}
    # `from a.b import c` names both a.b and a.b.c: only a.b.c if it is a file
    deepest = {name for name in targets if not any(within(other, name) and other != name for other in targets)}
    return [(module, name) for name in sorted(deepest - {module}) if (module, name) not in UPWARDS]


@cache
def modules(package: str) -> frozenset[str]:
    return frozenset(module_name(path) for path in files(package))


def lines_up(name: str) -> Iterator[str]:
    """The name and those of the packages that it is in."""
    while name:
        yield name
        name = name.rpartition(".")[0]


def against_the_map(path: Path) -> set[str]:
    module = module_name(path)
    package = module.partition(".")[0]
    own = package_of(module, package)
    known = PACKAGES[package]
    used = {package_of(name, package) for _, name in edges(path)} - {own, ""}
    return used - set(known[own].split())


def test_imports_follow_the_map() -> None:
    """By file: packages that its own may not import."""
    assert not offences(against_the_map, "runtime", "symgen")


@pytest.mark.parametrize("package", [runtime, symgen], ids=lambda package: package.__name__)
def test_public_names_are_imported_from_where_type_checkers_see_them(package: ModuleType) -> None:
    """A package gives its names when they are asked for; the imports that it shows to type checkers say the same."""
    content = tree(Path(str(package.__file__)))
    (block,) = [node for node in content.body if for_types(node)]
    shown = {
        alias.name: node.module for node in ast.walk(block) if isinstance(node, ast.ImportFrom) for alias in node.names
    }
    assert set(shown) == set(package.__all__)
    for name, module in shown.items():
        at_home = getattr(import_module(str(module)), name, None) or import_module(f"{module}.{name}")
        assert getattr(package, name) is at_home, name


def test_every_scheme_of_the_catalogue_can_be_imported() -> None:
    assert all(kind.make and kind.options for kind in SCHEMES.values())


@pytest.mark.parametrize("package", PACKAGES)
def test_files_import_each_other_in_no_circle(package: str) -> None:
    """Imports inside functions are counted."""
    graph = {module_name(path): {name for _, name in edges(path)} for path in files(package)}
    TopologicalSorter(graph).prepare()  # raises CycleError with the circle


def calls(path: Path) -> Iterator[tuple[str, int]]:
    """(bare or dotted name, line) of every call; of methods only those of imported modules count."""
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.Call):
            if isinstance(node.func, ast.Name):
                yield node.func.id, node.lineno
            elif isinstance(node.func, ast.Attribute) and isinstance(node.func.value, ast.Name):
                yield f"{node.func.value.id}.{node.func.attr}", node.lineno


def dangerous(path: Path) -> list[tuple[str, int]]:
    """(name, line) of eval, exec, sympify, pickle, a shell; np.load only with pickle refused."""
    if not SUSPECT.search(path.read_text(encoding="utf-8")):
        return []
    bad = [
        (name, line)
        for name, line in calls(path)
        if name in FORBIDDEN_CALLS or name in {"builtins.eval", "builtins.exec", "sp.sympify", "sympy.sympify"}
    ]
    bad += [
        (name, 0)
        for name in imports(path)
        if name.split(".")[0] in FORBIDDEN_IMPORTS or name.rpartition(".")[2] in {"sympify", "parse_expr"}
    ]
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.keyword) and node.arg == "allow_pickle":
            if not (isinstance(node.value, ast.Constant) and node.value.value is False):
                bad.append(("allow_pickle", node.value.lineno))
        if isinstance(node, ast.keyword) and node.arg == "shell":
            bad.append(("shell", node.value.lineno))
    return bad


def test_nothing_evaluates_text() -> None:
    assert not offences(dangerous, "symgen", "runtime", "benchmarks", "examples", "generated")


def undocumented(node: ast.AST, prefix: str) -> Iterator[str]:
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef) or child.name.startswith("_"):
            continue
        overload = any(isinstance(d, ast.Name) and d.id == "overload" for d in child.decorator_list)
        if ast.get_docstring(child) is None and not overload:
            yield f"{prefix}.{child.name}"
        if isinstance(child, ast.ClassDef):
            yield from undocumented(child, f"{prefix}.{child.name}")


def without_docstring(path: Path) -> Iterator[str]:
    content = tree(path)
    if content.body and ast.get_docstring(content) is None:
        yield "the module"
    yield from undocumented(content, module_name(path))


def test_public_things_have_docstrings() -> None:
    assert not offences(without_docstring, "symgen", "runtime")
