"""Machine code kept on disk, by key: a private folder, contents verified on reading, size bounded.

A file holds the SHA-256 of what follows, the length of the work array (8 bytes) and the object. The hash catches
damage, not malice: the folder must belong to the user and be closed to others, else nothing is read or written there.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
from math import inf
from pathlib import Path

from runtime.contract.cache import cache_folder, leftovers, read_own, refused_folder
from runtime.contract.files import OutputError, replacing
from runtime.contract.log import CACHE

MOST_CACHE_BYTES = 256 * 2**20
_HEAD = 32 + 8


class ObjectCache:
    """Objects in a folder, `objects` of the cache folder by default.

    written: bytes by this process since it last saw how many there are; a sixteenth of MOST_CACHE_BYTES may be too
    many.
    """

    written = inf

    def __init__(self, folder: Path | None = None) -> None:
        self.folder = folder or cache_folder() / "objects"

    def refused(self) -> str:
        """Why the folder is not used, "" if it is; makes it where it is missing."""
        return refused_folder(self.folder)

    def read(self, key: str) -> tuple[bytes, int] | None:
        """(object, length of the work array), None if there is none; a damaged file is removed."""
        path = self.folder / f"{key}.o"
        if not path.exists() or self.refused():
            return None
        try:
            content = read_own(path)
            if len(content) <= _HEAD or hashlib.sha256(content[32:]).digest() != content[:32]:
                path.unlink(missing_ok=True)
                return None
            os.utime(path)  # the least recently used go first
        except OSError:
            return None
        return content[_HEAD:], int.from_bytes(content[32:_HEAD], "little")

    def has(self, key: str) -> bool:
        """Is there one? Whether it is whole shows when it is read."""
        return (self.folder / f"{key}.o").exists()

    def write(self, key: str, code: bytes, work: int) -> None:
        """Keep an object; where that is not possible, nothing is kept."""
        if self.refused():
            return
        payload = work.to_bytes(8, "little") + code
        try:
            with replacing(self.folder / f"{key}.o") as temporary:
                temporary.write_bytes(hashlib.sha256(payload).digest() + payload)
        except OutputError as error:
            CACHE.warning("a compiled program was not kept: %s", error)
            return
        ObjectCache.written += len(payload)
        if ObjectCache.written > MOST_CACHE_BYTES / 16:
            self._bound()

    def _bound(self) -> None:
        """Remove what was left under way, and the least recently used until MOST_CACHE_BYTES are left."""
        for path in leftovers(self.folder):
            _remove(path)
        total, ObjectCache.written = 0, 0
        for path, size, _ in sorted(self.entries(), key=lambda entry: -entry[2]):
            total += size
            if total > MOST_CACHE_BYTES:
                _remove(path)

    def entries(self) -> list[tuple[Path, int, float]]:
        """(file, bytes, time of its last use) of every object."""
        found = []
        for path in self.folder.glob("*.o"):
            with contextlib.suppress(OSError):  # another process may have removed it
                about = path.stat()
                found.append((path, about.st_size, about.st_mtime))
        return found

    def clear(self) -> int:
        """Remove every object and what was left under way; how many files there were."""
        found = [*(path for path, _, _ in self.entries()), *leftovers(self.folder, older=-1.0)]
        for path in found:
            _remove(path)
        return len(found)


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):  # another process may have removed it
        path.unlink(missing_ok=True)
