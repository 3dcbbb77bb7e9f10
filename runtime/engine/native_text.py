"""C of this package as LLVM IR that is checked in: compiled once when the project is developed, linked by llvmlite
on any machine.

A user needs no compiler: `NAME.ll` beside `NAME.c` is text for any processor, from which `load` makes machine code
for the one that runs. Developers write it anew with `python -m runtime.engine.native_text` after a change of the C;
it needs the wheel `ziglang`, and a test holds that the two belong together.

What is taken out of Clang's text so that every supported LLVM reads it, and every processor gets its own code:
attributes and target (they would fix a plain x86-64), metadata (no loop may be unrolled otherwise), marks of lifetime
and scope.
"""

from __future__ import annotations

import hashlib
import re
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

from runtime.engine.llvm_code import Effort, host, linked, machine_code, tools
from runtime.engine.object_cache import ObjectCache

PACKAGE = Path(__file__).resolve().parents[1]
CLANG = (
    "-target x86_64-linux-musl -S -emit-llvm -O1 -g0 -std=c11 -Wall -Wextra -Werror -ffp-contract=off -fno-vectorize "
    "-fno-slp-vectorize -fno-unroll-loops -fno-stack-protector -Wno-unused-command-line-argument"
).split()
EFFORT = Effort(passes=True, level=3)
MARKS = r",? !(tbaa|tbaa\.struct|noalias|alias\.scope|llvm\.loop|llvm\.access\.group|range) !\d+"


def sources() -> list[Path]:
    """The C files whose IR is checked in beside them."""
    return sorted(path.with_suffix(".c") for path in PACKAGE.rglob("*.ll"))


def compiled(source: Path) -> str:
    """The IR of a C file, by ziglang's Clang. Raises subprocess.CalledProcessError with what Clang says."""
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "text.ll"
        command = [sys.executable, "-m", "ziglang", "cc", *CLANG, source.name, "-o", str(target)]
        subprocess.run(command, cwd=source.parent, check=True, capture_output=True, text=True)
        return plain(target.read_text(encoding="utf-8"), source.name)


def plain(text: str, name: str) -> str:
    """Clang's text without attributes, target, metadata, marks of lifetime and scope; it says what it is made of."""
    kept = []
    for line in text.splitlines():
        if re.match(r"(; ModuleID|; Function Attrs|source_filename|target |attributes #|!)", line) or re.search(
            r"@llvm\.(lifetime|experimental\.noalias\.scope\.decl)", line
        ):
            continue
        line = re.sub(
            r",? !(tbaa|tbaa\.struct|noalias|alias\.scope|llvm\.loop|llvm\.access\.group|range) !\d+", "", line
        )
        line = re.sub(r" #\d+(?=( {|$))", "", line)
        kept.append(re.sub(r" +;.*$", "", line).replace(" dso_local", "").replace(" local_unnamed_addr", ""))
    body = re.sub(r"\n{3,}", "\n\n", "\n".join(kept)).strip()
    return f"; Written from {name} by `python -m runtime.engine.native_text`; do not edit.\n\n{body}\n"


@cache
def load(path: Path, effort: Effort = EFFORT) -> Any:
    """The engine of LLVM that holds the code of a checked-in text, for this processor; kept in the object cache.

    `get_function_address(name)` of it gives addresses. Raises NoLlvm where LLVM cannot be had.
    """
    text, stored = path.read_text(encoding="utf-8"), ObjectCache()
    key = hashlib.sha256("\n".join([text, repr(effort), *host()]).encode() + tools()).hexdigest()
    found = stored.read(key)
    if found is None:
        found = machine_code(text, effort, host()), 0
        stored.write(key, *found)
    return linked(found[0], host())


if __name__ == "__main__":
    for path in sources():
        path.with_suffix(".ll").write_text(compiled(path), encoding="utf-8")
        print(path.with_suffix(".ll").relative_to(PACKAGE.parent))
