"""An input file of Abaqus or CalculiX, made plain for meshio: nodes in one block, sets as numbers.

meshio keeps the last of several *NODE blocks only, takes GENERATE with one row of three numbers, and leaves out sets in
sets. Steps are left out: what a mesh is stands before the first one.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from symgen.fe.structure import FiniteElementError

Block = tuple[int, str, list[str]]  # line, keyword line, data lines


def plain_deck(file: Path) -> str:
    """The text of nodes, elements and sets. Raises FiniteElementError with the line, for several parts."""
    nodes: dict[int, str] = {}
    elements: list[str] = []
    sets: dict[str, dict[str, list[int]]] = {"NSET": {}, "ELSET": {}}
    for number, head, data in _blocks(file.read_text(encoding="utf-8", errors="replace")):
        keyword = head.split(",")[0].strip("* ").upper()
        if keyword in ("PART", "INSTANCE") and nodes:
            raise FiniteElementError(
                file.name, f"line {number}: a second {keyword}", "export one body, *PART by itself"
            )
        if keyword == "NODE":
            for line in data:
                name, *place = [word.strip() for word in line.split(",")]
                place = [word or "0" for word in [*place, "", "", ""][:3]]  # what is left out is zero
                nodes[_whole(file, number, name)] = ", ".join([name, *place])
            _named(sets["NSET"], head, [_whole(file, number, line.split(",")[0]) for line in data])
        elif keyword == "ELEMENT":
            kept = [part for part in head.split(",") if part.split("=")[0].strip().upper() != "ELSET"]
            elements += [",".join(kept), *data]
            _named(sets["ELSET"], head, [_whole(file, number, line.split(",")[0]) for line in _first_lines(data)])
        elif keyword in sets:
            _named(sets[keyword], head, _members(file, number, head, data, sets[keyword]))
        elif keyword == "INCLUDE":
            raise FiniteElementError(file.name, f"line {number}: {head[:60]}", "insert the included file there")
    lines = ["*NODE", *nodes.values(), *elements]
    for keyword, named in sets.items():
        for name, members in named.items():
            lines += [f"*{keyword}, {keyword}={name}", *(str(one) for one in dict.fromkeys(members))]
    return "\n".join(lines) + "\n"


def _blocks(text: str) -> Iterator[Block]:
    """Keyword lines before the first step, with the lines of data after each."""
    current: Block | None = None
    for number, line in enumerate(text.splitlines(), 1):
        stripped = line.strip()
        if not stripped or stripped.startswith("**"):
            continue
        if not stripped.startswith("*"):
            if current is not None:
                current[2].append(stripped)
            continue
        if current is not None:
            yield current
        if stripped.upper().split(",")[0].strip() == "*STEP":
            return
        current = (number, stripped, [])
    if current is not None:
        yield current


def _first_lines(data: list[str]) -> Iterator[str]:
    """Lines that begin an element: a line that ends with a comma goes on in the next one."""
    begins = True
    for line in data:
        if begins:
            yield line
        begins = not line.endswith(",")


def _named(known: dict[str, list[int]], head: str, members: list[int]) -> None:
    """Adds members to the set that a keyword line names, if it names one."""
    for part in head.split(",")[1:]:
        key, _, name = part.partition("=")
        if key.strip().upper() in ("NSET", "ELSET") and name.strip():
            known.setdefault(name.strip(), []).extend(members)


def _members(file: Path, number: int, head: str, data: list[str], known: dict[str, list[int]]) -> list[int]:
    generated = any(part.strip().upper() == "GENERATE" for part in head.split(","))
    found: list[int] = []
    by_name = {name.upper(): name for name in known}
    for line in data:
        words = [word.strip() for word in line.split(",") if word.strip()]
        if generated:
            first, last, *step = (_whole(file, number, word) for word in words)
            found += range(first, last + 1, step[0] if step else 1)
            continue
        for word in words:
            found += known[by_name[word.upper()]] if word.upper() in by_name else [_whole(file, number, word)]
    return found


def _whole(file: Path, number: int, word: str) -> int:
    try:
        return int(word)
    except ValueError as error:
        problem = f"the block of line {number}: {word.strip()[:40]!r} is neither a number nor a set before it"
        raise FiniteElementError(file.name, problem, "check the line, or leave the set out") from error
