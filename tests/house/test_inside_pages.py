"""The pages for who carries on: the code map is the map, every invariant is held by a test, every page can be found."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.house.test_architecture import PACKAGES

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
ARCHITECTURE = (DOCS / "inside" / "architecture.md").read_text(encoding="utf-8")
CODE = [path for package in ("symgen", "runtime", "generated") for path in (ROOT / package).rglob("*.md")]
PAGES = sorted({*ROOT.glob("*.md"), *DOCS.rglob("*.md"), *(ROOT / ".github").rglob("*.md"), *CODE})


def links(page: Path) -> list[str]:
    """Targets of the relative links of a page, as they are written."""
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    found = re.findall(r"\]\(([^)\s]+)\)", text)
    return [target for target in found if not re.match(r"https?://", target)]


def headings(page: Path) -> set[str]:
    """Anchors of a page, as they are made of its headings."""
    lines = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", line.lower()).strip().replace(" ", "-") for line in lines}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_relative_links_lead_to_what_exists(page: Path) -> None:
    for target in links(page):
        name, _, anchor = target.partition("#")
        place = page.parent / name if name else page
        assert place.exists(), target
        if anchor and place.suffix == ".md":
            assert anchor in headings(place), target


def test_every_page_is_found_from_the_readme() -> None:
    """By following links."""
    seen: set[Path] = set()
    waiting = [ROOT / "README.md"]
    while waiting:
        page = waiting.pop()
        if page in seen or page.suffix != ".md":
            continue
        seen.add(page)
        waiting += [(page.parent / target.partition("#")[0]).resolve() for target in links(page) if target[0] != "#"]
    assert not set(DOCS.rglob("*.md")) - seen


@pytest.mark.parametrize("package", PACKAGES)
def test_the_code_map_is_the_map(package: str) -> None:
    """The packages of the page are those of the architecture test, in its order; where to begin exists."""
    section = ARCHITECTURE.split(f"### {package}\n")[1].split("\n#")[0]
    rows = re.findall(r"^\| `(\w+)` \| (.+) \| `([\w./]+)` \|$", section, re.MULTILINE)
    assert [name for name, _, _ in rows] == [name for name in PACKAGES[package] if name]
    for name, _, first in rows:
        assert first.startswith(f"{package}/{name}") and (ROOT / first).exists(), first


def test_every_invariant_names_a_test_that_exists() -> None:
    defined = {
        name
        for path in (ROOT / "tests").rglob("test_*.py")
        for name in re.findall(r"^def (test_\w+)\(", path.read_text(encoding="utf-8"), re.MULTILINE)
    }
    invariants = re.findall(r"\*Architecture Invariant:\*(.*?)(?=\n\n|\Z)", ARCHITECTURE, re.DOTALL)
    assert len(invariants) > 10
    for invariant in invariants:
        named = re.findall(r"`(test_\w+)`", invariant)
        assert named and not set(named) - defined, invariant
