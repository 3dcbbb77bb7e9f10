"""The cache: folders of what can be made again, one for each kind. What is in them is run: it must be the user's own.

There is one way in. A folder is used if it belongs to the user and is closed to others (`refused_folder`); what is read
from it is an ordinary file of the user's that nobody else can write (`read_own`). Hashes catch damage, not malice.
"""

from __future__ import annotations

import os
import re
import stat
import time
from collections.abc import Iterator
from pathlib import Path

from runtime.contract.files import STALE, WRITING

_OLDER_LEFTOVER = re.compile("tmp[a-z0-9_]{8}")  # what 0.4 and older called files under way


def cache_folder() -> Path:
    """$SYMGEN_CACHE, else the user's cache folder."""
    chosen = os.environ.get("SYMGEN_CACHE")
    if chosen:
        return Path(chosen)
    try:
        return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "symgen"
    except RuntimeError:  # a user without a home, as in some containers: a place that is refused
        return Path(os.devnull) / "symgen"


def refused_folder(folder: Path) -> str:
    """Why a folder of the cache is not used, "" if it is: it must be the user's own; makes it where it is missing.

    One that others could read only, as older versions made some, is closed: what is in it is the user's.
    """
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        found = os.lstat(folder)
        if _is_own_folder(found) and found.st_mode & 0o077 and not found.st_mode & 0o022:
            os.chmod(folder, 0o700)
            found = os.lstat(folder)
    except OSError as error:
        return f"{folder} cannot be used: {error}"
    if not stat.S_ISDIR(found.st_mode):
        return f"{folder} is not a folder of its own"
    if os.name != "nt" and found.st_uid != os.getuid():
        return f"{folder} belongs to another user"
    if os.name != "nt" and found.st_mode & 0o077:
        return f"{folder} is open to other users (chmod 700 closes it)"
    return ""


def _is_own_folder(found: os.stat_result) -> bool:
    return os.name != "nt" and stat.S_ISDIR(found.st_mode) and found.st_uid == os.getuid()


def read_own(path: Path) -> bytes:
    """The bytes of an ordinary file of the user's. Raises OSError where it is another's, or others can write it.

    Looked at is the file that was opened, not what its name stands for a moment later; a link is not followed.
    """
    flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    with open(os.open(path, flags), "rb") as file:
        found = os.fstat(file.fileno())
        if not stat.S_ISREG(found.st_mode):
            raise PermissionError(f"{path} is not a regular file")
        if os.name != "nt" and found.st_uid != os.getuid():
            raise PermissionError(f"{path} belongs to another user")
        if os.name != "nt" and found.st_mode & 0o022:
            raise PermissionError(f"{path} can be written by other users")
        return file.read()


def leftovers(folder: Path, older: float = STALE) -> Iterator[Path]:
    """What killed processes and full disks left under way in a folder of the cache, older than so many seconds."""
    try:
        entries = list(os.scandir(folder))
    except OSError:
        return
    for entry in entries:
        if entry.name.startswith(WRITING) or _OLDER_LEFTOVER.fullmatch(entry.name):
            try:
                age = time.time() - entry.stat(follow_symlinks=False).st_mtime
            except OSError:  # another process has removed it
                continue
            if age >= older:
                yield Path(entry.path)
