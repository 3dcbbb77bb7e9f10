"""The documentation site: built offline by one command, asks nothing of the network, its links lead somewhere."""

from __future__ import annotations

import json
import re
import runpy
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

import pytest

pytestmark = pytest.mark.long

ROOT = Path(__file__).resolve().parents[2]
OWN = {"sitemap.xml", "404.html"}  # made for servers


class Page(HTMLParser):
    """What a page loads, where it links to, and the anchors it has."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.loads: list[str] = []
        self.links: list[str] = []
        self.anchors: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        given = {key: value or "" for key, value in attributes}
        self.anchors |= {given[key] for key in ("id", "name") if key in given}
        if tag in ("script", "img", "iframe", "source", "video") and given.get("src"):
            self.loads.append(given["src"])
        if tag == "link" and given.get("rel") not in ("next", "prev", "canonical"):
            self.loads.append(given["href"])
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site") / "built"
    runpy.run_path(str(ROOT / "docs" / "site" / "build.py"))["build"](folder, moves=["five_bar_robot"])
    return folder


@pytest.fixture(scope="module")
def pages(site: Path) -> dict[Path, Page]:
    found = [path for path in site.rglob("*.html") if path.name not in OWN and not path.stem.endswith("_moves")]
    return {path: Page(path.read_text(encoding="utf-8")) for path in found}


def test_pages_load_nothing_from_elsewhere(site: Path, pages: dict[Path, Page]) -> None:
    for path, page in pages.items():
        assert page.loads
        for address in page.loads:
            assert "//" not in address or address.startswith("data:"), (path.name, address)
            place = (path.parent / unquote(address.partition("#")[0])).resolve()
            assert address.startswith("data:") or place.is_file(), (path.name, address)
    for style in site.rglob("*.css"):
        text = style.read_text(encoding="utf-8")
        assert "@import" not in text and not re.search(r"url\([\"']?https?:", text)


def test_links_lead_to_pages_and_anchors(pages: dict[Path, Page]) -> None:
    outside = 0
    for path, page in pages.items():
        for address in page.links:
            if re.match(r"(https?|mailto):", address):
                outside += 1
                continue
            target, _, anchor = address.partition("#")
            place = (path.parent / unquote(target)).resolve() if target else path
            assert place.is_file(), (path.name, address)
            if anchor and place in pages:
                assert unquote(anchor) in pages[place].anchors, (path.name, address)
    assert outside > 0  # the test sees links


def test_every_page_of_the_repository_is_in_the_site(site: Path, pages: dict[Path, Page]) -> None:
    docs = ROOT / "docs"
    names = [path.relative_to(docs).with_suffix(".html") for path in docs.rglob("*.md")]
    wanted = {name.with_name("index.html") if name.stem == "README" else name for name in names}
    wanted |= {Path("index.html"), Path("changes.html"), Path("contributing.html"), Path("security.html")}
    wanted |= {Path("gallery") / f"{path.stem}.html" for path in (ROOT / "examples").glob("*.py")}
    assert wanted <= {path.relative_to(site) for path in pages}


def test_equations_are_mathematics_and_docstrings_are_there(site: Path) -> None:
    stiffening = (site / "theory" / "stiffening.html").read_text(encoding="utf-8")
    assert "<math" in stiffening and "$$" not in stiffening
    reference = (site / "reference" / "models-and-runs.html").read_text(encoding="utf-8")
    assert "Load a folder written by" in reference and "simulate" in reference


def test_the_search_page_knows_the_pages(site: Path) -> None:
    text = (site / "search.html").read_text(encoding="utf-8")
    known = json.loads(re.search(r"const known = (\[.*\]), field = ", text, re.DOTALL)[1].replace("<\\/", "</"))  # type: ignore[index]
    assert any("stepper" in entry["text"] for entry in known)
    assert {entry["to"].partition("#")[0] for entry in known} >= {"index.html", "guide/scenes.html", "gallery.html"}


def test_the_front_page_moves(site: Path) -> None:
    moving = (site / "slider_crank_moves.html").read_text(encoding="utf-8")
    assert "https://" not in re.sub(r"(?s)<script>.*?</script>|<!--.*?-->", "", moving)
    assert len(moving) < 1_500_000


def test_examples_move_where_they_stand(site: Path) -> None:
    """The page of the five-bar robot holds its motion; the others of the list are made by the command alone."""
    page = (site / "gallery" / "five_bar_robot.html").read_text(encoding="utf-8")
    (source,) = re.findall(r'<iframe class="motion"[^>]* src="([^"#]*)#', page)
    assert "symgenView" in (site / "gallery" / source).read_text(encoding="utf-8")
    listed = runpy.run_path(str(ROOT / "docs" / "site" / "moving.py"))["MOVING"]
    assert len(listed) >= 6 and all((ROOT / "examples" / f"{name}.py").is_file() for name in listed)
