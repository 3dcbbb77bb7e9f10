"""Put faults into a copy of the project, one at a time, and run the tests: python -m benchmarks.mutations --sites 200.

A fault is killed if a test fails. Tests are those that execute its line (coverage_map.py finds them once, by running
all tests), in the order of selection.py, until one fails. Models of built-in scenes are generated anew
(--fresh-models), and the comparison with the code in the repository is left out: it notices any change, and says
nothing of what is right.

The record (record.py) is written after each fault; a run goes on with as many sites as are missing.
"""

from __future__ import annotations

import argparse
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from importlib.util import cache_from_source
from pathlib import Path

from benchmarks.mutations.record import OPEN, Record, drawn
from benchmarks.mutations.selection import LEFT_OUT, CoverageMap
from benchmarks.mutations.sites import ROOT, Site, sites

LEAST = 0.95  # share of the faults that can be told that must be seen
SLOWER, AT_LEAST = 4.0, 60.0  # a fault that makes tests last so many times longer, or so many seconds, is noticed too
PYTEST = ["-m", "pytest", "-q", "-x", "-n", "0", "-p", "no:cacheprovider", "--fresh-models"]
NOT_ALL = ["tests/emission/test_drift.py", "tests/views", "tests/house/test_docs.py", "tests/house/test_examples.py"]


def all_sites(only: str = "") -> list[Site]:
    """Of all files whose path has this in it."""
    files = sorted(path for package in ("symgen", "runtime") for path in (ROOT / package).rglob("*.py"))
    kept = [path for path in files if not str(path.relative_to(ROOT)).startswith(LEFT_OUT)]
    return [site for path in kept if only in str(path) for site in sites(path)]


def make_map(path: Path) -> None:
    """Run all tests once, traced."""
    left_out = [f"--ignore={place}" for place in NOT_ALL]
    command = [part for part in PYTEST if part != "-x"]
    traced = ["-p", "benchmarks.mutations.coverage_map", "--map", str(path.resolve())]
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
            preexec_fn=_hear_interrupts,
        )
    except subprocess.TimeoutExpired:
        return "timeout", ""
    finally:
        _put(target, source)
    if result.returncode == 0:
        return "survived", ""
    failed = [line for line in result.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return "killed", failed[0] if failed else "collection"


def _hear_interrupts() -> None:
    """What runs in the background ignores Ctrl-C, and with it tests that press it would fail without a fault."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def _put(target: Path, text: str) -> None:
    """Write a file of Python so that no byte code of another text is taken for its own."""
    Path(cache_from_source(str(target))).unlink(missing_ok=True)
    target.write_text(text, encoding="utf-8")


def command_line() -> argparse.ArgumentParser:
    """What may be asked for."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.mutations", description=__doc__)
    parser.add_argument("--sites", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="part of a path")
    parser.add_argument("--budget", type=float, default=90.0, help="seconds of tests a fault")
    parser.add_argument("--map", type=Path, default=Path("mutations-map.json"), help="made where it is not there")
    parser.add_argument("--record", type=Path, default=Path(__file__).with_name("record.json"))
    parser.add_argument("--seconds", type=float, default=float("inf"), help="begin no other fault after so long")
    parser.add_argument("--score", action="store_true", help=f"of the record; fails below {LEAST:.0%}%")
    parser.add_argument("--again", action="store_true", help="judge again what survived")
    return parser


def main() -> None:
    """Draw sites, judge them, leave a table."""
    arguments = command_line().parse_args()
    if arguments.score:
        record = Record.read(arguments.record)
        seen, told, _ = record.seen()
        print(record.score())
        sys.exit(seen < LEAST * told)
    if not arguments.map.exists():
        make_map(arguments.map)
    found, record = CoverageMap.read(arguments.map), Record.read(arguments.record)
    every = drawn(all_sites(arguments.only), arguments.seed)
    judged = [one for one in every if one in record.rows]
    left = [one for one in judged if arguments.again and record.rows[one][0] in OPEN]
    left += [one for one in every if one not in record.rows][: max(0, arguments.sites - len(judged))]
    print(f"{len(judged)} of {len(record.rows)} sites of the record are in the code; {len(left)} to judge")
    with tempfile.TemporaryDirectory() as work:
        copy = Path(shutil.copytree(ROOT, Path(work) / "copy", ignore=shutil.ignore_patterns(".git", "__pycache__")))
        started = time.monotonic()
        for one in left:
            site, began = every[one], time.monotonic()
            if began - started > arguments.seconds:
                break
            ended, test = verdict(site, copy, found, arguments.budget)
            record.add(one, ended, test)
            took = time.monotonic() - began
            print(f"{ended:9} {took:6.0f} s  {one[0]}:{site.line}  {one[2]}  {test[:100]}", flush=True)
    print(record.score())


if __name__ == "__main__":
    main()
