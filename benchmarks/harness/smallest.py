"""The smallest work of a benchmark: every part of it is run once, so that a test sees whether it still runs.

A module of `benchmarks.cases` names under SMALLEST those of its constants (cases, repeats, rounds) that are other then.
What it measures so says nothing about speed.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType


@contextmanager
def smallest(module: ModuleType) -> Iterator[None]:
    """The constants of a module at their smallest, and then as they were.

    Raises ValueError for a name under SMALLEST that is no constant of the module.
    """
    wanted = getattr(module, "SMALLEST", {})
    usual = {name: vars(module)[name] for name in wanted if name in vars(module)}
    if unknown := sorted(set(wanted) - set(usual)):
        raise ValueError(f"{module.__name__} has no constant {unknown[0]}, which its SMALLEST names")
    try:
        vars(module).update(wanted)
        yield
    finally:
        vars(module).update(usual)
