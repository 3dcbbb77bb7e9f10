"""Put faults into a copy of the project, one at a time, and run the tests: python -m tests.mutations --sites 200.

A fault is killed if a test fails. Tests are those that execute its line (coverage_map.py finds them once, by running
all tests), in the order of selection.py, until one fails. Models of built-in scenes are generated anew
(--fresh-models), and the comparison with the code in the repository is left out: it notices any change, and says
nothing of what is right.

The table is written after each fault; a run that was stopped goes on with what is missing.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from importlib.util import cache_from_source
from pathlib import Path

from tests.mutations.selection import LEFT_OUT, CoverageMap
from tests.mutations.sites import ROOT, Site, sites

SLOWER, AT_LEAST = 4.0, 60.0  # a fault that makes tests last so many times longer, or so many seconds, is noticed too
PYTEST = ["-m", "pytest", "-q", "-x", "-n", "0", "-p", "no:cacheprovider", "--fresh-models"]
NOT_ALL = ["tests/emission/test_drift.py", "tests/views", "tests/house/test_docs.py", "tests/house/test_examples.py"]


def chosen(count: int, seed: int, only: str) -> list[Site]:
    """So many sites, drawn from all files alike by the number of their sites."""
    files = sorted(path for package in ("symgen", "runtime") for path in (ROOT / package).rglob("*.py"))
    kept = [path for path in files if not str(path.relative_to(ROOT)).startswith(LEFT_OUT)]
    all_sites = [site for path in kept if only in str(path) for site in sites(path)]
    return random.Random(seed).sample(all_sites, min(count, len(all_sites)))


def make_map(path: Path) -> None:
    """Run all tests once, traced."""
    left_out = [f"--ignore={place}" for place in NOT_ALL]
    command = [part for part in PYTEST if part != "-x"]
    traced = ["-p", "tests.mutations.coverage_map", "--map", str(path.resolve())]
    subprocess.run([sys.executable, *command, *traced, *left_out, "tests"], cwd=ROOT, check=False)


def verdict(site: Site, copy: Path, found: CoverageMap, budget: float) -> tuple[str, str]:
    """(killed, survived, timeout or not executed; the test that failed) of a fault in a copy of the project."""
    tests, seconds = found.of(site, budget)
    if not tests:
        return "not executed", ""
    target, source = copy / site.path.relative_to(ROOT), site.path.read_text(encoding="utf-8")
    _put(target, site.applied(source))
    try:
        result = subprocess.run(
            [sys.executable, *PYTEST, *tests],
            cwd=copy,
            env={**os.environ, "PYTHONPATH": str(copy)},
            capture_output=True,
            text=True,
            timeout=AT_LEAST + SLOWER * seconds,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return "timeout", ""
    finally:
        _put(target, source)
    if result.returncode == 0:
        return "survived", ""
    failed = [line for line in result.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return "killed", failed[0] if failed else "collection"


def _put(target: Path, text: str) -> None:
    """Write a file of Python so that no byte code of another text is taken for its own."""
    Path(cache_from_source(str(target))).unlink(missing_ok=True)
    target.write_text(text, encoding="utf-8")


def main() -> None:
    """Draw sites, judge them, leave a table."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutations", description=__doc__)
    parser.add_argument("--sites", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="part of a path")
    parser.add_argument("--budget", type=float, default=90.0, help="seconds of tests a fault")
    parser.add_argument("--map", type=Path, default=Path("mutations-map.json"), help="made where it is not there")
    parser.add_argument("--out", type=Path, default=Path("mutations.json"))
    arguments = parser.parse_args()
    if not arguments.map.exists():
        make_map(arguments.map)
    found = CoverageMap.read(arguments.map)
    rows = json.loads(arguments.out.read_text(encoding="utf-8")) if arguments.out.exists() else []
    done = {(row["place"], row["fault"]) for row in rows}
    with tempfile.TemporaryDirectory() as work:
        copy = Path(shutil.copytree(ROOT, Path(work) / "copy", ignore=shutil.ignore_patterns(".git", "__pycache__")))
        for site in chosen(arguments.sites, arguments.seed, arguments.only):
            place = f"{site.path.relative_to(ROOT)}:{site.line}"
            fault = site.shown(site.path.read_text(encoding="utf-8"))
            if (place, fault) in done:
                continue
            began = time.monotonic()
            ended, test = verdict(site, copy, found, arguments.budget)
            rows.append({"place": place, "fault": fault, "verdict": ended, "test": test})
            arguments.out.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
            print(f"{ended:9} {time.monotonic() - began:6.0f} s  {place}  {fault}  {test[:100]}", flush=True)
    seen = sum(row["verdict"] in ("killed", "timeout") for row in rows)
    print(f"{seen} of {len(rows)} faults seen")


if __name__ == "__main__":
    main()
