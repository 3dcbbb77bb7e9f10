"""Step programs by the machine's C compiler: a second opinion on the compiled engine. Libraries are kept by content."""

from __future__ import annotations

import ctypes
import hashlib
import os
import shlex
import subprocess
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np

from runtime.contract.cache import cache_folder, refused_folder
from runtime.contract.errors import CompilerError
from runtime.engine.c_source import Style, find_compiler, program_code, source
from runtime.engine.program import Program

# -ffp-contract=off keeps compiled code bit-identical to the CasADi virtual machine (no fused multiply-add)
COMMON_FLAGS = ("-shared", "-fPIC", "-march=native", "-ffp-contract=off", "-fno-math-errno")
LARGE_SOURCE = 10_000  # lines
SMALL_FLAGS = ("-O3",)
# of -O1, without the passes that take quadratic time on long straight-line code (a third of the time, same speed)
LARGE_FLAGS = ("-O1", "-fno-dse", "-fno-tree-dse", "-fno-tree-pta", "-fno-ivopts", "-fno-schedule-insns2")


@cache
def _identity(compiler: str) -> str:
    """Compiler version and what -march=native means on this processor."""
    command = [*shlex.split(compiler), "-march=native", "-E", "-v", "-x", "c", os.devnull]
    try:
        result = subprocess.run(command, capture_output=True, text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise CompilerError(f"{compiler} does not answer: {error}") from error
    kept = [line for line in result.stderr.splitlines() if "-march" in line or "version" in line]
    return "\n".join(line for line in kept if "/tmp" not in line)


def compile_source(source: str, large: bool = False) -> Path:
    """Shared library of a C source, from the cache if it is there. Raises CompilerError."""
    compiler = find_compiler()
    if compiler is None:
        raise CompilerError("no C compiler found; set CC, or install gcc")
    flags = (*(LARGE_FLAGS if large else SMALL_FLAGS), *COMMON_FLAGS)
    key = hashlib.sha256("\n".join([source, *flags, compiler, _identity(compiler)]).encode()).hexdigest()
    folder = cache_folder() / "libraries"
    if refused := refused_folder(folder):
        raise CompilerError(f"{refused}; set SYMGEN_CACHE to a folder of your own")
    target = folder / f"{key}.so"  # named by content: the loader caches libraries by path
    if not target.exists():
        _build(compiler, flags, source, folder, target)
    return target


def _build(compiler: str, flags: tuple[str, ...], source: str, folder: Path, target: Path) -> None:
    try:
        with tempfile.TemporaryDirectory(dir=folder) as work:
            source_file, library = Path(work) / "program.c", Path(work) / "program.so"
            source_file.write_text(source, encoding="utf-8")
            command = [*shlex.split(compiler), *flags, "-o", str(library), str(source_file), "-lm"]
            result = subprocess.run(command, capture_output=True, text=True)
            if result.returncode != 0:
                raise CompilerError(f"{compiler} failed: {result.stderr.strip()[:2000]}")
            os.replace(library, target)
    except OSError as error:
        raise CompilerError(f"cannot compile in {folder}: {error}; set SYMGEN_CACHE to a writable folder") from error


def program_source(program: Program) -> str:
    """C source with `void run(double *z, const double *c, double *w, long n)`, which applies the program n times.

    w: of `work_size` entries, for one call at a time.
    """
    code = program_code("run", program, Style())
    return source([code], Style()) + f"const long work_size = {code.work};\n"


class CompiledProgram:
    """A program as native code by the machine's C compiler."""

    name = "c"

    def __init__(self, program: Program) -> None:
        self.note = ""
        text = program_source(program)
        self.source_lines = text.count("\n")
        large = self.source_lines > LARGE_SOURCE
        self.library = compile_source(text, large)
        try:
            loaded = ctypes.CDLL(str(self.library))
        except (OSError, AttributeError):  # a damaged file in the cache: build it again, once
            self.library.unlink(missing_ok=True)
            self.library = compile_source(text, large)
            try:
                loaded = ctypes.CDLL(str(self.library))
            except (OSError, AttributeError) as error:
                raise CompilerError(f"the compiled program cannot be loaded: {error}") from error
        self._run, self._work = loaded.run, ctypes.c_long.in_dll(loaded, "work_size").value
        self._run.argtypes = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_long)
        self._run.restype = None

    def run_rows(self, z: np.ndarray, c: np.ndarray, counts: np.ndarray, rows: np.ndarray) -> None:
        """Apply the program counts (N,) times, each count followed by a copy of z to the next of rows (N, z_size)."""
        for count, row in zip(counts, rows, strict=True):
            self.run(z, c, int(count))
            row[:] = z

    def bound(self, z: np.ndarray, c: np.ndarray) -> Callable[[int], None]:
        """`run` with z and c fixed, which must stay where they are: only the number of steps is left to give."""
        work = np.empty(self._work + 1)

        def go(n: int) -> None:
            self._run(z.ctypes.data, c.ctypes.data, work.ctypes.data, n)

        return go

    def run(self, z: np.ndarray, c: np.ndarray, n: int) -> None:
        """Apply the program n times to z, in place."""
        work = np.empty(self._work + 1)  # of this call: threads may run one program at once
        self._run(z.ctypes.data, c.ctypes.data, work.ctypes.data, n)
