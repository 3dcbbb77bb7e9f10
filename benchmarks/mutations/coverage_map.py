"""Which tests execute which lines, and how long they take: pytest -p benchmarks.mutations.coverage_map --map FILE.

Models are made once and serve many tests, so what the generator executes for one is counted for all tests that ask
for it. The file is one JSON text: seconds (test -> s) and lines (file -> line -> tests, as positions in `tests`).
"""

from __future__ import annotations

import json
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import coverage
import pytest

ROOT = Path(__file__).resolve().parents[2]
MODEL = "model of "


class CoverageMap:
    """Contexts of the tracer are tests, and the models that they ask for."""

    def __init__(self, path: Path) -> None:
        self.path, self.tests, self.seconds = path, "", dict[str, float]()
        self.tracer = coverage.Coverage(
            data_file=None, source=[str(ROOT / "symgen"), str(ROOT / "runtime")], config_file=False
        )
        self.tracer.start()
        self.asked: dict[str, set[str]] = defaultdict(set)  # model -> tests
        self.made: set[str] = set()

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        """A context for each test, its fixtures included."""
        self.tests, began = item.nodeid, time.process_time()
        self.tracer.switch_context(item.nodeid)
        try:
            return (yield)
        finally:
            self.seconds[item.nodeid] = round(time.process_time() - began, 3)

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(self, fixturedef: Any) -> Iterator[None]:
        """Fixtures that make models say which."""
        result: Any = yield
        if fixturedef.argname in ("built_in", "model_of"):
            result = self._watched(result)
            fixturedef.cached_result = (result, *fixturedef.cached_result[1:])
        return result

    def _watched(self, load: Callable[[Any], Any]) -> Callable[[Any], Any]:
        def watched(key: Any) -> Any:
            name = MODEL + (key if isinstance(key, str) else str(hash(key.to_toml())))
            self.asked[name].add(self.tests)
            if name in self.made:
                return load(key)
            self.made.add(name)
            self.tracer.switch_context(name)
            try:
                return load(key)
            finally:
                self.tracer.switch_context(self.tests)

        return watched

    def pytest_sessionfinish(self) -> None:
        """Write the file."""
        self.tracer.stop()
        data, tests = self.tracer.get_data(), sorted(self.seconds)
        position = {test: k for k, test in enumerate(tests)}
        lines: dict[str, dict[int, list[int]]] = {}
        for file in data.measured_files():
            found = lines[str(Path(file).relative_to(ROOT))] = {}
            for line, contexts in data.contexts_by_lineno(file).items():
                seen = {test for name in contexts for test in self.asked.get(name, {name})} & position.keys()
                found[line] = sorted(position[test] for test in seen)
        text = {"tests": tests, "seconds": [self.seconds[test] for test in tests], "lines": lines}
        self.path.write_text(json.dumps(text) + "\n", encoding="utf-8")


def pytest_addoption(parser: pytest.Parser) -> None:
    """--map FILE."""
    parser.addoption("--map", type=Path, default=None, help="write which tests execute which lines")


def pytest_configure(config: pytest.Config) -> None:
    """Begin to trace, before the project is imported by tests."""
    if config.getoption("--map") is not None:
        config.pluginmanager.register(CoverageMap(config.getoption("--map").resolve()))
