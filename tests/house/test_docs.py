"""The pages: their code and commands run; names of tests and equation numbers exist."""

from __future__ import annotations

import re
import runpy
import shlex
import shutil
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import get_args

import pytest

from runtime import SCHEMES
from runtime.contract.status import StatusName
from runtime.schemes.printed import INTERPOLATIONS
from symgen.cli import main
from symgen.cli.table import COMMANDS
from symgen.scene import SceneRecord
from symgen.schema.expressions import ARITY

ROOT = Path(__file__).resolve().parents[2]
README = ROOT / "README.md"
DOCS = ROOT / "docs"
GUIDE, THEORY, EVIDENCE = (DOCS / shelf for shelf in ("guide", "theory", "evidence"))
MEASURED = EVIDENCE / "benchmarks.md"  # written by the benchmark program
PAGES = [README, ROOT / "CHANGELOG.md", *(page for page in sorted(DOCS.rglob("*.md")) if page != MEASURED)]
LAST_EQUATION = 72
EXTRAS = {"training": "jax"}  # what the Python of a page imports


def read(page: Path) -> str:
    return page.read_text(encoding="utf-8")


def blocks(page: Path, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", read(page), re.DOTALL | re.MULTILINE)


def page_id(page: Path) -> str:
    return page.stem


@pytest.mark.every_push(
    "README",
    "scenes",
    "bodies",
    "events",
    "errors",
    "stepping",
    "motions",
    "operating-points",
    "generated-code",
    "constraints",
    "friction",
)
@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "python")], ids=page_id)
def test_python_runs(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """All Python of a page, as one program, in an empty folder."""
    if page.stem in EXTRAS:
        pytest.importorskip(EXTRAS[page.stem], reason=f"needs the extra {EXTRAS[page.stem]}")
    monkeypatch.chdir(tmp_path)
    script = tmp_path / "page.py"
    script.write_text("\n".join(blocks(page, "python")), encoding="utf-8")
    runpy.run_path(str(script), run_name="__main__")


def test_the_readme_example_draws_with_defaults_only() -> None:
    (block,) = blocks(README, "python")
    assert ".plot(" in block and not re.search(r"scheme|dt=|m=", block), "defaults only"


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "toml")], ids=page_id)
def test_scenes_in_toml_are_scenes(page: Path) -> None:
    for block in blocks(page, "toml"):
        scene = SceneRecord.from_toml_text(block)
        assert SceneRecord.from_toml_text(scene.to_toml()) == scene


def commands(page: Path) -> list[str]:
    """Of `symgen`, in their order; the demo's is in `test_demo_leaves_everything`, platforms are in `tests/export`."""
    lines = [line for block in blocks(page, "sh") for line in block.splitlines()]
    return [line for line in lines if re.match(r"symgen (?!demo)", line) and "--platform" not in line]


@pytest.mark.long
@pytest.mark.parametrize("page", [page for page in PAGES[2:] if commands(page)], ids=page_id)
def test_commands_run(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    for line in commands(page):
        if "export fmu" in line and not any(map(shutil.which, ("cc", "gcc", "clang"))):
            continue
        assert main(shlex.split(line, comments=True)[1:]) == 0, (line, capsys.readouterr().err)


@pytest.mark.parametrize("page", sorted(GUIDE.glob("*.md")), ids=page_id)
def test_guides_begin_with_what_one_types(page: Path) -> None:
    lines = read(page).splitlines()
    assert not re.findall(r"`test_\w+`", read(page)), "names of tests belong to other shelves"
    if page.stem not in ("coming-from", "trust"):
        assert any(line.startswith(("```", "|")) for line in lines[:22]), "it begins with what one types"


def test_the_readme_has_the_two_commands() -> None:
    commands = [line for block in blocks(README, "sh") for line in block.splitlines()]
    assert commands == ["pip install -e . && symgen demo slider-crank", 'pip install -e ".[dev]" && pytest']


def test_pictures_are_small() -> None:
    pictures = list((DOCS / "images").glob("*.png"))
    assert pictures and all(picture.stat().st_size < 200_000 for picture in pictures)


@cache
def defined_tests() -> set[str]:
    return {
        name
        for path in (ROOT / "tests").rglob("test_*.py")
        for name in re.findall(r"^def (test_\w+)\(", read(path), re.MULTILINE)
    }


@pytest.mark.parametrize("page", PAGES, ids=page_id)
def test_tests_that_are_named_exist(page: Path) -> None:
    named = set(re.findall(r"`(test_\w+)`", read(page)))
    assert not named - defined_tests()


@pytest.mark.parametrize("page", PAGES, ids=page_id)
def test_files_that_are_named_exist(page: Path) -> None:
    for name in re.findall(r"`((?:symgen|runtime|tests|examples|docs|generated)/[\w./*]*)`", read(page)):
        assert list(ROOT.glob(name.rstrip("/"))), name


@pytest.mark.parametrize("page", PAGES, ids=page_id)
def test_no_machine_is_in_a_page(page: Path) -> None:
    assert not re.search(r"(?<![\w.])/(home|root|tmp|work|usr|Users)\b", read(page))
    assert all(character.isascii() for character in read(page))


def equations(text: str) -> Iterator[int]:
    for group in re.findall(r"Eqs?\. \(?([\d\s,and()-]+)", text):
        yield from map(int, re.findall(r"\d+", group))


@pytest.mark.parametrize("page", PAGES, ids=page_id)
def test_equation_numbers_of_pages(page: Path) -> None:
    assert all(1 <= number <= LAST_EQUATION for number in equations(read(page)))


def test_equation_numbers_of_docstrings() -> None:
    for path in [*(ROOT / "symgen").rglob("*.py"), *(ROOT / "runtime").rglob("*.py")]:
        assert all(1 <= number <= LAST_EQUATION for number in equations(read(path))), path


def schema_keys() -> set[str]:
    schema = SceneRecord.json_schema()
    return {key for part in (schema, *schema["$defs"].values()) for key in part.get("properties", {})}


def schema_types() -> set[str]:
    return {
        part["properties"]["type"]["const"]
        for part in SceneRecord.json_schema()["$defs"].values()
        if "const" in part.get("properties", {}).get("type", {})
    }


def test_the_pages_of_scenes_are_complete() -> None:
    words = set(re.findall(r"\w+", "".join(read(page) for page in GUIDE.glob("*.md"))))
    assert not schema_keys() - words
    assert not schema_types() - words
    assert not set(ARITY) - words


def test_pages_name_every_scheme_option_reading_and_status() -> None:
    words = set(re.findall(r"\w+", read(THEORY / "schemes.md")))
    assert (
        not {*SCHEMES, *INTERPOLATIONS, *(name for kind in SCHEMES.values() for name in kind.options.names())} - words
    )
    assert not set(get_args(StatusName)) - set(re.findall(r"\w+", read(GUIDE / "errors.md")))


def test_pages_name_every_command_and_function() -> None:
    from symgen.kernels.specification import table

    assert table() in read(THEORY / "functions.md")
    text = read(GUIDE / "cli.md")
    for command in COMMANDS:
        assert re.search(rf"^- `{command}\b", text, re.MULTILINE), command


@pytest.mark.long
def test_the_first_steps_lead_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The program and the commands of the page leave what the page says."""
    page = GUIDE / "first-steps.md"
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pump.py").write_text("\n".join(blocks(page, "python")), encoding="utf-8")
    runpy.run_path("pump.py", run_name="__main__")
    for line in commands(page):
        assert main(shlex.split(line)[1:]) == 0, line
    named = set(re.findall(r"`(\w+\.(?:png|html|csv|md))`", read(page)))
    assert len(named) >= 5
    assert not [
        name for name in named if not (tmp_path / name).is_file() and not (tmp_path / "results" / name).is_file()
    ]
