"""The pages of the site from those of the repository: links, gallery cards, the front page."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
MOVED = {
    "CHANGELOG.md": "changes.md",
    "CONTRIBUTING.md": "contributing.md",
    "README.md": "index.md",
    "SECURITY.md": "security.md",
}
SHELVES = {"guide": "Guide", "theory": "Theory", "evidence": "Evidence", "inside": "Inside", "paper": "Paper"}
LINK = re.compile(r"(!?\[[^\]]*\])\(([^)\s#]*)(#[^)\s]*)?\)")
BLOCK = re.compile(r"(^```.*?^```)", re.DOTALL | re.MULTILINE)


def sources() -> dict[str, Path]:
    """Where each page of the site comes from, by its place in the site."""
    found = {str(path.relative_to(DOCS)): path for path in sorted(DOCS.rglob("*.md"))}
    return found | {place: ROOT / name for name, place in MOVED.items() if name != "README.md"}


def page(place: str, path: Path) -> str:
    """A page's Markdown with links as the site has them."""
    text = path.read_text(encoding="utf-8")
    parts = BLOCK.split(text)
    parts[::2] = [LINK.sub(lambda found: _link(found, path.parent, place), part) for part in parts[::2]]
    return "".join(parts)


def _link(found: re.Match[str], folder: Path, place: str) -> str:
    words, target, anchor = found[1], found[2], found[3] or ""
    if not target or target.startswith(("http:", "https:", "mailto:")):
        return found[0]
    up = "../" * place.count("/")
    inside = (folder / target).resolve().relative_to(ROOT)
    if inside.parts[0] == "examples" and inside.suffix == ".py":
        return f"{words}({up}gallery/{inside.stem}.md)"
    if str(inside) in MOVED:
        return f"{words}({up}{MOVED[str(inside)]}{anchor})"
    if inside.parts[0] == "docs" and inside.suffix in (".md", ".png"):
        return f"{words}({up}{Path(*inside.parts[1:])}{anchor})"
    return f"{words[1:-1]} (`{inside}`)"  # a file of the repository that the site does not have


def gallery(
    sections: dict[str, list[str]], described: dict[str, tuple[str, str]], head: str, moving: dict[str, str]
) -> dict[str, str]:
    """The gallery's page with cards, and a page with picture and program for each example.

    moving: the examples that also have a page in three dimensions, and the moment at which it opens.
    """
    parts, pages = [head.replace(" A click on a picture opens the script.", "")], {}
    for section, names in sections.items():
        parts.append(f'\n## {section}\n\n<div class="cards">')
        for name in names:
            shows, checks = described[name]
            title = name.replace("_", " ")
            parts.append(
                f'<div class="card"><a href="gallery/{name}.html"><img loading="lazy" alt="{title}" '
                f'src="images/gallery/{name}.png"></a><p><strong>{_html(shows)}</strong></p></div>'
            )
            program = (ROOT / "examples" / f"{name}.py").read_text(encoding="utf-8")
            pages[f"gallery/{name}.md"] = (
                f"# {title.capitalize()}\n\n{shows}\n\n{_frame(name, title, moving)}"
                f"![{title}](../images/gallery/{name}.png)\n\n{checks}\n\n"
                f"```python\n{program}```\n"
            )
        parts.append("</div>")
    return pages | {"gallery.md": "\n".join(parts) + "\n"}


def _frame(name: str, title: str, moving: dict[str, str]) -> str:
    """The page in three dimensions, loaded when it comes into sight."""
    if name not in moving:
        return ""
    source = f"{name}_moves.html#{moving[name]}"
    return f'<iframe class="motion" loading="lazy" title="{title}" src="{source}"></iframe>\n\n'


def _html(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")


def front(moving: str) -> str:
    """The front page: what it is, the mechanism that moves, the README's example, where to go."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"^```python\n.*?^```", readme, re.DOTALL | re.MULTILINE)
    start = re.search(r"^```sh\n.*?^```", readme, re.DOTALL | re.MULTILINE)
    assert start
    return f"""---
hide: [navigation, toc]
---

# symgen

A mechanism with flexible bodies, described in twenty lines, becomes readable CasADi functions, and a motion that is
stepped, checked and judged.

<iframe class="motion" loading="lazy" title="A slider-crank with a flexible rod" src="{moving}"></iframe>

{example}

{start[0]}

- [First steps](guide/first-steps.md), then the [gallery](gallery.md)
- [Which method is fast enough?](guide/schemes.md) Error against operations for your own model
- [Coming from another program](guide/coming-from.md)

[![Error against operations](images/advice.png)](guide/schemes.md)
"""


def navigation(places: list[str], topics: list[str]) -> list[object]:
    """The tabs and what is below them, in the order of docs/pages.md."""
    listed = (DOCS / "pages.md").read_text(encoding="utf-8")
    tabs: list[object] = [{"Home": ["index.md", "search.md", "changes.md", "contributing.md", "security.md"]}]
    tabs.append({"Gallery": ["gallery.md", *sorted(place for place in places if place.startswith("gallery/"))]})
    for shelf, title in SHELVES.items():
        own = [place for place in places if place.startswith(f"{shelf}/")]
        tabs.append({title: sorted(own, key=lambda place: (place not in listed, listed.find(f"({place})")))})
    return [*tabs, {"Reference": topics}]
