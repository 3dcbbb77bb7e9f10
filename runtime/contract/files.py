"""Writing files so that a reader never sees half of one: to a temporary name first, then renamed."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from runtime.contract.errors import SymgenError


class OutputError(SymgenError, ValueError):
    """A file or folder that cannot be written; the message says which and why."""


@contextmanager
def replacing(path: str | Path) -> Iterator[Path]:
    """A temporary file beside `path` (same suffix) to write to; it takes the place of `path` if nothing was raised.

    Missing folders are made. Raises OutputError if the place cannot be written.
    """
    target = Path(path)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=target.parent, prefix=".writing-", suffix=target.suffix)
        os.close(handle)
    except (OSError, ValueError) as error:
        raise OutputError(_refusal(target, error)) from error
    temporary = Path(name)
    try:
        yield temporary
        os.chmod(temporary, 0o644)
        os.replace(temporary, target)
    except OSError as error:
        raise OutputError(_refusal(target, error)) from error
    finally:
        temporary.unlink(missing_ok=True)


def write_text(path: str | Path, text: str) -> None:
    """Write UTF-8 text with Unix line ends. Raises OutputError."""
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")


def _refusal(target: Path, error: Exception) -> str:
    reason = getattr(error, "strerror", None) or str(error)
    return f"{target} cannot be written ({reason}); choose another place or change its permissions"
