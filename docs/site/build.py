"""The documentation site in one command, without network: `python docs/site/build.py [FOLDER]`, out/site by default.

Needs the extra `docs`. The pages are those of the repository; mkdocs.yml beside this file is an ordinary one.
"""

import json
import re
import runpy
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import yaml

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import mathematics  # noqa: E402
import moving  # noqa: E402
import pages  # noqa: E402
import reference  # noqa: E402

FRONT = "slider_crank_moves.html"


def staged(folder: Path, moves: Sequence[str]) -> None:
    """Everything that Zensical takes, below `folder`; moves: the examples that get a page in three dimensions."""
    docs = folder / "docs"
    shutil.copytree(pages.DOCS / "images", docs / "images", ignore=shutil.ignore_patterns("*.py"))
    made = runpy.run_path(str(pages.DOCS / "make_gallery.py"))
    examples = [name for names in made["SECTIONS"].values() for name in names]
    described = {name: made["described"](name) for name in examples}
    contents = {place: pages.page(place, path) for place, path in pages.sources().items()}
    contents |= pages.gallery(
        made["SECTIONS"], described, made["HEAD"], {name: moving.MOVING[name].state for name in moves}
    )
    contents |= {f"reference/{name}": text for name, text in reference.pages().items()}
    contents |= {
        "index.md": pages.front(f"{FRONT}#{moving.FRONT.state}"),
        "search.md": (HERE / "search.html").read_text(encoding="utf-8"),
    }
    for place, text in contents.items():
        (docs / place).parent.mkdir(parents=True, exist_ok=True)
        (docs / place).write_text(mathematics.as_mathml(text), encoding="utf-8")
    for name in ("site.css", "site.js"):
        shutil.copy(HERE / name, docs / name)
    moving.write("", docs / FRONT, moving.FRONT)
    for name in moves:
        moving.write(name, docs / "gallery" / f"{name}_moves.html", moving.MOVING[name])
    settings = (HERE / "mkdocs.yml").read_text(encoding="utf-8").replace("ROOT", str(pages.ROOT))
    nav = pages.navigation(list(contents), [f"reference/{name}" for name in reference.pages()])
    (folder / "mkdocs.yml").write_text(settings + yaml.safe_dump({"nav": nav}), encoding="utf-8")


def index(site: Path) -> list[dict[str, str]]:
    """What the search knows: address, title and text of each section of each page."""
    found = []
    for path in sorted(site.rglob("*.html")):
        article = re.search(r"<article.*?</article>", path.read_text(encoding="utf-8"), re.DOTALL)
        if article is None or path.name in ("404.html", "search.html"):
            continue
        for part in re.split(r"(?=<h[123] )", article[0]):
            heading = re.match(r'<h[123] id="([^"]*)".*?>(.*?)</h[123]>', part, re.DOTALL)
            if heading:
                words = (_plain(heading[2]).rstrip("¶# "), _plain(part[heading.end() :])[:1500])
                found.append({"to": f"{path.relative_to(site)}#{heading[1]}", "title": words[0], "text": words[1]})
    return found


def _plain(html: str) -> str:
    text = re.sub(r"<[^>]+>", " ", html)
    for entity, character in (("&lt;", "<"), ("&gt;", ">"), ("&quot;", '"'), ("&para;", ""), ("&amp;", "&")):
        text = text.replace(entity, character)
    return " ".join(text.split())


def build(target: Path, moves: Sequence[str] = tuple(moving.MOVING)) -> None:
    """Build the site into `target`, which is replaced. Ends with its words where Zensical finds a fault.

    moves: the examples that are shown in three dimensions.
    """
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        staged(folder, moves)
        command = [sys.executable, "-m", "zensical", "build", "--strict"]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        if done.returncode:
            sys.exit(done.stdout + done.stderr.partition("Traceback")[0])
        for path in (folder / "site").rglob("*.html"):  # a link to a folder shows its files where there is no server
            text = path.read_text(encoding="utf-8")
            path.write_text(re.sub(r'href="(\.[./]*?)/?"', r'href="\1/index.html"', text), encoding="utf-8")
        search = folder / "site" / "search.html"
        known = json.dumps(index(folder / "site"), ensure_ascii=True).replace("</", "<\\/")
        search.write_text(search.read_text(encoding="utf-8").replace('"KNOWN"', known), encoding="utf-8")
        shutil.rmtree(target, ignore_errors=True)
        shutil.copytree(folder / "site", target)


if __name__ == "__main__":
    place = Path(sys.argv[1]) if len(sys.argv) > 1 else pages.ROOT / "out" / "site"
    build(place)
    print(f"open {place / 'index.html'}")
