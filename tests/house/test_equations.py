"""The page that leads from an equation of the paper to the code, in both directions."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "theory" / "equations.md"
LAST_EQUATION = 72
RANGE = r"\((\d+)\)(?:-\((\d+)\))?"
PAPER = ("central_difference", "printed")  # files that hold its steps


def rows() -> Iterator[tuple[range, list[str]]]:
    """(equations, places) of each row of the page."""
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        if found := re.match(rf"\| {RANGE} \|[^|]*\|(.*)\|$", line):
            first, last, places = found.groups()
            yield range(int(first), int(last or first) + 1), re.findall(r"`([^`]+)`", places)


PLACES = [(place, numbers) for numbers, places in rows() for place in places]


def docstrings(path: Path) -> dict[str, str]:
    """Docstrings of a file by qualified name; the file's own under ""."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    found = {"": ast.get_docstring(tree) or ""}

    def visit(node: ast.AST, prefix: str) -> None:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.FunctionDef | ast.ClassDef):
                found[prefix + child.name] = ast.get_docstring(child) or ""
                visit(child, f"{prefix}{child.name}.")

    visit(tree, "")
    return found


def cited(text: str) -> set[int]:
    """Numbers of equations: (46)-(47), (38), Eq. (20), Eqs. 15-20, (Eqs. 39, 72)."""
    text = re.sub(r"\s+", " ", text)
    found = {n for first, last in re.findall(RANGE, text) for n in range(int(first), int(last or first) + 1)}
    for group in re.findall(r"Eqs?\. ([\d, -]+)", text):
        for first, last in re.findall(r"(\d+)(?:-(\d+))?", group):
            found.update(range(int(first), int(last or first) + 1))
    return found


def test_every_equation_is_in_the_table_in_order() -> None:
    listed = [numbers for numbers, _ in rows()]
    assert sorted({n for numbers in listed for n in numbers}) == list(range(1, LAST_EQUATION + 1))
    starts = [numbers.start for numbers in listed]
    assert starts == sorted(starts)


@pytest.mark.parametrize(("place", "numbers"), PLACES, ids=lambda value: str(value))
def test_places_exist_and_cite_their_equation(place: str, numbers: range) -> None:
    path, _, name = place.partition(":")
    text = docstrings(ROOT / path)[name]
    assert set(numbers) <= cited(text), (place, sorted(set(numbers) - cited(text)))


@pytest.mark.parametrize("module", PAPER)
def test_what_cites_an_equation_is_its_place(module: str) -> None:
    """Every function of the files that hold the paper's steps is listed with every equation that it cites."""
    path = f"runtime/schemes/{module}.py"
    listed = {(place, n) for place, numbers in PLACES for n in numbers}
    for name, text in docstrings(ROOT / path).items():
        if name and not name[0].isupper():  # classes cite what their options are about
            missing = {n for n in cited(text) if (f"{path}:{name}", n) not in listed}
            assert not missing, (name, sorted(missing))


def test_the_scheme_is_cited_completely_where_it_steps() -> None:
    """Fig. 5 is (40)-(71): the files of the paper's scheme cite all of them in the docstrings of functions."""
    found = set()
    for module in PAPER:
        texts = docstrings(ROOT / "runtime" / "schemes" / f"{module}.py")
        found |= {n for name, text in texts.items() if name for n in cited(text)}
    assert found >= set(range(40, 72))
