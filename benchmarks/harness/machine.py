"""On what the numbers were measured."""

from __future__ import annotations

import os
import platform
import subprocess
from importlib.metadata import version
from pathlib import Path

from benchmarks.contenders.by_c_compiler import COMMON_FLAGS, SMALL_FLAGS
from runtime.engine.c_source import find_compiler


def describe_machine() -> dict[str, str]:
    """Processor, compiler with flags, and versions."""
    return {
        "processor": f"{_processor()}, {os.cpu_count()} cores",
        "compiler": _compiler(),
        "flags": " ".join((*SMALL_FLAGS, *COMMON_FLAGS)),
        "python": platform.python_version(),
        **{package: version(package) for package in ("casadi", "llvmlite", "numpy", "sympy")},
    }


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), platform.machine())


def _compiler() -> str:
    compiler = find_compiler()
    if compiler is None:
        return "none"
    result = subprocess.run([compiler, "--version"], capture_output=True, text=True, timeout=60)
    return result.stdout.splitlines()[0] if result.stdout else compiler
