"""Where compiled programs and models made on demand are kept."""

from __future__ import annotations

import os
from pathlib import Path


def cache_folder() -> Path:
    """$SYMGEN_CACHE, else the user's cache folder."""
    chosen = os.environ.get("SYMGEN_CACHE")
    if chosen:
        return Path(chosen)
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "symgen"
