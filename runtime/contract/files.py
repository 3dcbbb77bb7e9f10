"""Writing files so that a reader never sees half of one: to a temporary name first, then renamed."""

from __future__ import annotations

import hashlib
import os
import secrets
import stat
import time
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

from runtime.contract.errors import SymgenError


def stamp_of(*folders: Path) -> str:
    """A hash of names, sizes and times of the code and the data in folders: another one where a file has changed."""
    about = ((entry.path, entry.stat()) for root in folders for entry in _code_in(root))
    listed = sorted(f"{path} {status.st_size} {status.st_mtime_ns}" for path, status in about)
    return hashlib.sha256(repr(listed).encode()).hexdigest()


def _code_in(folder: Path | str) -> Iterator[os.DirEntry[str]]:
    for entry in os.scandir(folder):
        if entry.is_dir():
            yield from _code_in(entry.path)
        elif entry.name.endswith((".py", ".json")):
            yield entry


# Writing files so that a reader never sees half of one: to a temporary name first, then renamed.

WRITING = ".writing-"  # what temporary files begin with
STALE = 3600.0  # s: a temporary file this old was left by a process that is gone


class OutputError(SymgenError, ValueError):
    """A file or folder that cannot be written; the message says which and why."""


@contextmanager
def replacing(path: str | Path) -> Iterator[Path]:
    """A temporary file beside `path` (same suffix) to write to; it takes the place of `path` if nothing was raised.

    Missing folders are made. Raises OutputError if the place cannot be written.
    """
    target = Path(path)
    temporary = _temporary(target)
    try:
        yield temporary
        os.replace(temporary, target)
    except OSError as error:
        raise OutputError(_refusal(target, error)) from error
    finally:
        temporary.unlink(missing_ok=True)


def try_writing(path: str | Path) -> None:
    """See that `replacing` will work, before something long is begun: nothing is changed but missing folders.

    Raises OutputError for a folder, a device, and a place that cannot be written.
    """
    target = Path(path)
    try:
        if not stat.S_ISREG(os.stat(target).st_mode):
            raise OutputError(f"{target} is not a regular file; choose another name")
    except FileNotFoundError:
        pass
    except (OSError, ValueError) as error:
        raise OutputError(_refusal(target, error)) from error
    _temporary(target).unlink(missing_ok=True)


def _temporary(target: Path) -> Path:
    """An empty file beside the target, on the same file system; stale ones there are removed. Raises OutputError.

    Its mode is what the user's umask leaves of 644: never that others may write.
    """
    path = target.parent / f"{WRITING}{secrets.token_hex(8)}{target.suffix}"
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        for stale in target.parent.glob(f"{WRITING}*"):
            with suppress(OSError):  # another process was first, or it is not a file
                if time.time() - stale.lstat().st_mtime > STALE:
                    stale.unlink()
        os.close(os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o644))
    except (OSError, ValueError) as error:
        raise OutputError(_refusal(target, error)) from error
    return path


def write_text(path: str | Path, text: str) -> None:
    """Write UTF-8 text with Unix line ends. Raises OutputError."""
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")


def write_texts(folder: Path, texts: Mapping[str, str]) -> None:
    """Write files of a folder as `write_text`, by name: none takes its place before all are on the disk.

    They take their places in this order. Raises OutputError.
    """
    with ExitStack() as waiting:
        whole = []
        for name, text in texts.items():
            target = folder / name
            temporary = _temporary(target)
            waiting.callback(temporary.unlink, missing_ok=True)
            try:
                temporary.write_text(text, encoding="utf-8", newline="\n")
            except OSError as error:
                raise OutputError(_refusal(target, error)) from error
            whole.append((temporary, target))
        for temporary, target in whole:
            try:
                os.replace(temporary, target)
            except OSError as error:
                raise OutputError(_refusal(target, error)) from error


def _refusal(target: Path, error: Exception) -> str:
    reason = getattr(error, "strerror", None) or str(error)
    return f"{target} cannot be written ({reason}); choose another place or change its permissions"
