"""Put faults into a copy of the project, one at a time, and run the tests: python -m tests.mutations --sites 200.

A fault is killed if a test fails. Models of built-in scenes are generated anew (pytest --fresh-models), and the
comparison with the code in the repository is left out: it notices any change, and says nothing of what is right.
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
from pathlib import Path

from tests.mutations.selection import LEFT_OUT, selected
from tests.mutations.sites import Site, sites

ROOT = Path(__file__).resolve().parents[2]
LONGEST = 900.0  # s: a fault that makes the tests last that long is noticed too
APART = "--ignore=tests/emission/test_drift.py"


def chosen(count: int, seed: int, only: str) -> list[Site]:
    """So many sites, drawn from all files alike by the number of their sites."""
    files = sorted(path for package in ("symgen", "runtime") for path in (ROOT / package).rglob("*.py"))
    kept = [path for path in files if not str(path.relative_to(ROOT)).startswith(LEFT_OUT)]
    all_sites = [site for path in kept if only in str(path) for site in sites(path)]
    return random.Random(seed).sample(all_sites, min(count, len(all_sites)))


def verdict(site: Site, copy: Path) -> tuple[str, str]:
    """(killed, survived or timeout, the test that failed) of a fault in a copy of the project."""
    target = copy / site.path.relative_to(ROOT)
    source = site.path.read_text(encoding="utf-8")
    target.write_text(site.applied(source), encoding="utf-8")
    environment = {**os.environ, "PYTHONPATH": str(copy), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-m", "pytest", "-q", "-x", "-n", "0", "-p", "no:cacheprovider", "--fresh-models", APART]
    try:
        for tests in selected(str(site.path.relative_to(ROOT))):
            result = subprocess.run(
                [*command, tests], cwd=copy, env=environment, capture_output=True, text=True, timeout=LONGEST
            )
            if result.returncode not in (0, 5):
                failed = [line for line in result.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
                return "killed", failed[0] if failed else "collection"
    except subprocess.TimeoutExpired:
        return "timeout", ""
    finally:
        target.write_text(source, encoding="utf-8")
    return "survived", ""


def main() -> None:
    """Draw sites, judge them, leave a table that is written anew after each."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutations", description=__doc__)
    parser.add_argument("--sites", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="part of a path")
    parser.add_argument("--out", default="mutations.json")
    arguments = parser.parse_args()
    rows: list[dict[str, object]] = []
    with tempfile.TemporaryDirectory() as work:
        copy = Path(shutil.copytree(ROOT, Path(work) / "copy", ignore=shutil.ignore_patterns(".git", "__pycache__")))
        for site in chosen(arguments.sites, arguments.seed, arguments.only):
            began = time.monotonic()
            found, test = verdict(site, copy)
            place = f"{site.path.relative_to(ROOT)}:{site.line}"
            fault = site.shown(site.path.read_text(encoding="utf-8"))
            rows.append({"place": place, "fault": fault, "verdict": found, "test": test})
            Path(arguments.out).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
            print(f"{found:9} {time.monotonic() - began:6.0f} s  {place}  {fault}  {test[:100]}", flush=True)
    seen = sum(row["verdict"] != "survived" for row in rows)
    print(f"{seen} of {len(rows)} faults seen")


if __name__ == "__main__":
    main()
