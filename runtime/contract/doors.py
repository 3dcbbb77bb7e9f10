"""Methods of a model or solution that rooms above it give; `runtime` puts them in here, so nothing imports upward."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

# "stepper": (model, settings) -> a stepper; "sketch": model -> SVG
# "page": (solution, path, surfaces, beside) -> a page
OPENS: dict[str, Callable[..., Any]] = {}
