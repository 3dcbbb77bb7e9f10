"""What an installation brings, what each part of it needs, and that facts about it stand in one place."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
GROUPS = PROJECT["dependency-groups"]
PACKAGES = ("symgen", "runtime", "generated")
WORKFLOW = ROOT / ".github" / "workflows" / "ci.yml"

BLOCKED_RUN = """
import sys
from importlib.abc import MetaPathFinder

class Refuse(MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {"sympy", "pydantic", "matplotlib", "PIL", "symgen"}:
            raise ImportError(f"{name} is blocked by the test")

sys.meta_path.insert(0, Refuse())
from runtime import load_model, simulate

for scheme in ("printed", "coupled"):
    solution = simulate(load_model(sys.argv[1]), t_end=0.01, scheme=scheme, engine="interpreted")
    solution.save(sys.argv[2])
    print(solution.status.name, len(solution.t) > 2)
"""


def test_a_generated_model_runs_without_what_derives_and_draws(tmp_path: Path) -> None:
    """In a fresh interpreter where SymPy, pydantic, Matplotlib, Pillow and symgen cannot be imported."""
    folder, result = ROOT / "generated" / "flexible_slider_crank", tmp_path / "run.npz"
    command = [sys.executable, "-c", BLOCKED_RUN, str(folder), str(result)]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert run.stdout.splitlines() == ["completed True"] * 2
    assert result.is_file()


def test_the_dependencies_are_those_of_all_groups() -> None:
    """`pip install .` brings all that the README's first command needs; a part can be installed by its group."""
    assert PROJECT["project"]["dependencies"] == GROUPS["run"] + GROUPS["derive"] + GROUPS["views"]


NOT_TRIED = {"ruff", "mypy", "zensical", "mkdocstrings-python"}  # lint, and the site: with the newest only


def test_the_oldest_are_the_lower_bounds() -> None:
    """CI runs everything with them, so that each bound is true; each requirement has one."""
    wanted = {*PROJECT["project"]["dependencies"], *PROJECT["project"]["optional-dependencies"]["dev"]}
    bounds = dict(entry.split(">=") for entry in wanted)
    lines = (ROOT / ".ci" / "oldest.txt").read_text(encoding="utf-8").splitlines()
    pinned = dict(line.split("==") for line in lines if not line.startswith("#"))
    assert pinned.keys() == bounds.keys() - NOT_TRIED

    def release(version: str) -> list[int]:
        parts = [int(part) for part in version.split(".")]
        return parts + [0] * (3 - len(parts))

    for name, version in pinned.items():
        assert release(version) == release(bounds[name]), name


def test_packages_are_named_and_typed() -> None:
    named = PROJECT["tool"]["setuptools"]["packages"]["find"]["include"]
    assert named == [pattern for package in PACKAGES for pattern in (package, f"{package}.*")]
    for package in PACKAGES:
        assert (ROOT / package / "py.typed").is_file()
        assert "py.typed" in PROJECT["tool"]["setuptools"]["package-data"][package]


IMPORTED_AS = {"pin": "pinocchio", "scikit-fem": "skfem", "pillow": "PIL"}


def _third_party(path: Path, seen: set[Path]) -> set[str]:
    """Packages that a file imports, wherever, and the files of `tests` that it imports."""
    seen.add(path)
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        names = [node.module or ""] if isinstance(node, ast.ImportFrom) else []
        names += [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
        for name in names:
            further = ROOT / (name.replace(".", "/") + ".py")
            if name.startswith("tests.") and further.is_file() and further not in seen:
                found |= _third_party(further, seen)
            found.add(name.partition(".")[0])
    return found - {*sys.stdlib_module_names, *PACKAGES, "", "tests", "benchmarks"}


def test_the_extra_benchmark_brings_what_the_benchmarks_import() -> None:
    wanted = PROJECT["project"]["dependencies"] + PROJECT["project"]["optional-dependencies"]["benchmark"]
    names = [re.match(r"[\w-]+", entry)[0] for entry in wanted]
    there = {IMPORTED_AS.get(name, name) for name in names}
    assert not {
        str(path): missing
        for path in (ROOT / "benchmarks").rglob("*.py")
        if (missing := _third_party(path, set()) - there)
    }


def test_nothing_is_uploaded_by_mistake() -> None:
    assert "Private :: Do Not Upload" in PROJECT["project"]["classifiers"]


def test_the_version_stands_in_one_place() -> None:
    """In pyproject.toml. Programs read it from the installed package; the citation and the changelog follow it."""
    version = PROJECT["project"]["version"]
    assert f"\nversion: {version}\n" in (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    releases = re.findall(r"^## \[?(\d[\d.]*)\]?", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert releases[0] == version
    sources = [path for package in PACKAGES for path in (ROOT / package).rglob("*.py")]
    assert not [path for path in sources if f'"{version}"' in path.read_text(encoding="utf-8")]


def formats_of_the_code() -> dict[str, str]:
    """Version of each format: the constants FORMAT, a number for the manifest, else "symgen NAME VERSION"."""
    found = {}
    for path in (path for package in PACKAGES for path in (ROOT / package).rglob("*.py")):
        for value in re.findall(
            r"^FORMAT(?:: \w+)? = (\d+|\"symgen \w+ \d+\")$", path.read_text("utf-8"), re.MULTILINE
        ):
            *name, version = value.strip('"').removeprefix("symgen ").split()
            found[name[0] if name else "manifest"] = version
    return found


def test_the_changelog_holds_the_versions_of_formats() -> None:
    """The last column of its table is the code as it is."""
    table = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8").split("## Versions of formats")[1]
    rows = re.findall(r"^\| (\w+)[^|]*\|.*\| *(\d+) \|$", table, re.MULTILINE)
    assert dict(rows) == formats_of_the_code()


def test_the_oldest_casadi_is_the_one_that_is_allowed() -> None:
    (bound,) = [requirement for requirement in GROUPS["run"] if requirement.startswith("casadi")]
    oldest = (ROOT / ".ci" / "oldest.txt").read_text(encoding="utf-8").splitlines()
    assert bound.replace(">=", "==") in oldest


def test_the_workflow_runs_what_the_project_claims() -> None:
    """Each Python from the oldest that is required, on three systems; the oldest CasADi; no compiler."""
    text = WORKFLOW.read_text(encoding="utf-8")
    pythons = re.findall(r'"(3\.\d+)"', text.partition("python: [")[2].partition("]")[0])
    assert PROJECT["project"]["requires-python"] == f">={min(pythons)}"
    assert {"3.11", "3.12", "3.13", "3.14"} <= set(pythons)
    for needed in (".ci/run", ".ci/oldest.txt", "cc: none", "ubuntu-latest", "macos-latest", "windows-latest"):
        assert needed in text


@pytest.mark.long
def test_what_the_readme_says_collects_the_tests() -> None:
    """`pytest` alone, which leaves out what is long: marks that contradict each other would stop it."""
    command = [sys.executable, "-m", "pytest", "--collect-only", "-q", "-n", "0", "-p", "no:cacheprovider"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    assert "test_packaging.py" in run.stdout
