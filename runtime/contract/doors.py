"""Methods of a model that rooms above it give: they put themselves in here, so that nothing imports upward."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

OPENS: dict[str, Callable[..., Any]] = {}  # "stepper": (model, settings) -> a stepper; "sketch": model -> SVG
