"""What shows a solution as a page. The room that draws stands above this one and puts itself in here."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

SHOWS: dict[str, Callable[..., Any]] = {}  # "page": (solution, path, surfaces, beside) -> a page
