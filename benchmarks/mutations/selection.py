"""Which tests to run for a fault: those that execute its line; those that look at its room and short ones first."""

from __future__ import annotations

import ast
import json
import re
from dataclasses import dataclass
from pathlib import Path

from benchmarks.mutations.sites import ROOT, Site

DERIVED = ["tests/laws/test_single_terms.py", "tests/hand_derived", "tests/laws"]
ROOMS = {
    "symgen/scene": ["tests/scene", "tests/bad_scenes", "tests/house/test_trust.py"],
    "symgen/modes": ["tests/derivation", "tests/fe", *DERIVED],
    "symgen/fe": ["tests/fe"],
    "symgen": DERIVED,
    "runtime/contract": ["tests/house", "tests/emission", "tests/running", "tests/laws"],
    "runtime/results": ["tests/running", "tests/views", "tests/laws"],
    "runtime/running": ["tests/running", "tests/cases"],
    "runtime/schemes": ["tests/laws", "tests/running"],
    "runtime/studies": ["tests/studies", "tests/laws", "tests/cli"],
    "runtime": ["tests/laws", "tests/running", "tests/studies"],
}
# rooms whose faults a person sees at once, or that only say things
LEFT_OUT = (
    "symgen/cli",
    "symgen/scenes",
    "runtime/views",
    "symgen/notation/symbols.py",
    "symgen/notation/fields.py",
)
MOST = 400  # tests of a fault


def looking_at(path: str) -> list[str]:
    """Test folders that look at the room of a file, those that see most first."""
    return ROOMS[max((room for room in ROOMS if path.startswith(room)), key=len)]


@dataclass(frozen=True)
class CoverageMap:
    """What coverage_map.py left: tests, the seconds that each takes, and which of them execute a line of a file."""

    tests: list[str]
    seconds: list[float]
    lines: dict[str, dict[int, list[int]]]

    @classmethod
    def read(cls, path: Path) -> CoverageMap:
        """From its file."""
        text = json.loads(path.read_text(encoding="utf-8"))
        lines = {file: {int(line): tests for line, tests in found.items()} for file, found in text["lines"].items()}
        return cls(text["tests"], text["seconds"], lines)

    def of(self, site: Site, budget: float) -> tuple[list[str], float]:
        """(Tests for a fault in the order to run them, the seconds that they take), at most about `budget` seconds."""
        path = str(site.path.relative_to(ROOT))
        rooms = looking_at(path)

        def order(test: int) -> tuple[int, float]:
            near = next((k for k, room in enumerate(rooms) if self.tests[test].startswith(room)), len(rooms))
            return near, self.seconds[test]

        chosen, spent = list[str](), 0.0
        for test in sorted(self._executing(site, path), key=order):
            if spent + self.seconds[test] <= budget and len(chosen) < MOST:
                chosen.append(self.tests[test])
                spent += self.seconds[test]
        return chosen, spent

    def _executing(self, site: Site, path: str) -> set[int]:
        """Tests that execute the line, or, where it is executed on import, a line that uses what it names."""
        lines = self.lines.get(path, {})
        if lines.get(site.line):
            return set(lines[site.line])
        name = _named(site)
        using = set() if name is None else {test for file in self.lines for test in self._using(file, name)}
        if using:
            return using
        inside = (tests for line, tests in lines.items() if site.first_line <= line <= site.last_line)
        function = {test for tests in inside for test in tests}
        return function or {test for tests in lines.values() for test in tests}

    def _using(self, file: str, name: str) -> set[int]:
        pattern, found = re.compile(rf"\b{name}\b"), set[int]()
        for number, text in enumerate((ROOT / file).read_text(encoding="utf-8").splitlines(), 1):
            if pattern.search(text):
                found |= set(self.lines[file].get(number, []))
        return found


def _named(site: Site) -> str | None:
    """The constant of a module or class whose value the fault is in."""
    tree = ast.parse(site.path.read_text(encoding="utf-8"))
    scopes: list[ast.Module | ast.ClassDef] = [tree, *(node for node in tree.body if isinstance(node, ast.ClassDef))]
    for node in (node for scope in scopes for node in scope.body):
        if isinstance(node, ast.Assign | ast.AnnAssign) and node.lineno <= site.line <= (node.end_lineno or 0):
            target = node.targets[0] if isinstance(node, ast.Assign) else node.target
            return target.id if isinstance(target, ast.Name) else None
    return None
