"""The peak of this process's own memory."""

from __future__ import annotations

import resource
from pathlib import Path


def peak_memory() -> float:
    """[MB]; where /proc is not, that of `getrusage`, which in a child is never below what its parent had."""
    status = Path("/proc/self/status")
    if status.exists():
        for line in status.read_text().splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
