"""Models kept in the cache: generated once, loaded from then on without what derives.

What a kept model leaves out is derived when it is asked for, and kept in its folder from then on.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import tempfile
import time
import zlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

import casadi as ca

from runtime.contract.cache import cache_folder, leftovers, read_own, refused_folder
from runtime.contract.errors import ModelError, SymgenError
from runtime.contract.files import WRITING, OutputError, replacing
from runtime.contract.loading import load_folder
from runtime.contract.log import CACHE
from runtime.contract.model import EmittedModel

MOST_KEPT = 100  # of a kind
M = TypeVar("M", bound=EmittedModel)
Generate = Callable[[Path], Path]


class KeptModels:
    """The models of a kind (`models` of scenes, `variants` of models), each in a folder by its name."""

    def __init__(self, kind: str) -> None:
        self.folder = cache_folder() / kind

    def model(self, name: str, kind: type[M], generate: Generate) -> M | None:
        """The model of this name, generated into a folder where there is none that can be read.

        None where the cache cannot be used, or takes no more. Raises what `generate` raises of the scene.
        """
        if refused := refused_folder(self.folder):
            CACHE.warning("the cache is not used: %s", refused)
            return None
        found = self._read(name, kind)
        if found is not None:
            CACHE.debug("%s/%s: read", self.folder.name, name)
            return found
        began = time.perf_counter()
        if self._write(name, generate):
            found = self._read(name, kind)
        if found is None:
            CACHE.warning("%s/%s: the cache takes no more", self.folder.name, name)
        else:
            CACHE.info("%s/%s: generated in %.3g s", self.folder.name, name, time.perf_counter() - began)
        return found

    def entries(self) -> list[Path]:
        """Folders of the models."""
        under_way = set(leftovers(self.folder, older=-1.0))
        with suppress(OSError):
            return [path for path in self.folder.iterdir() if path not in under_way and path.is_dir()]
        return []

    def clear(self) -> int:
        """Remove all models and what was left under way; how many there were."""
        found = [*self.entries(), *leftovers(self.folder, older=-1.0)]
        for path in found:
            _remove(path)
        return len(found)

    def _read(self, name: str, kind: type[M]) -> M | None:
        folder = self.folder / name
        try:
            found = load_folder(folder, kind, read=read_own)
        except ModelError:
            return None
        with suppress(OSError):
            os.utime(folder)  # the least recently used go first
        return with_kept_functions(found, folder)

    def _write(self, name: str, generate: Generate) -> bool:
        """The folder, complete at once: others see all of it or nothing. The oldest go where there are many."""
        folder = self.folder / name
        for path in leftovers(self.folder):
            _remove(path)
        try:
            with tempfile.TemporaryDirectory(dir=self.folder, prefix=WRITING, ignore_cleanup_errors=True) as place:
                made = generate(Path(place) / "model")
                _remove(folder)  # one that cannot be loaded
                with suppress(OSError):  # another process was first
                    made.rename(folder)
        except OSError:
            return False
        except SymgenError as error:
            if isinstance(error, OutputError) or isinstance(error.__cause__, OutputError):  # such as a full disk
                return False
            raise
        with suppress(OSError):
            for old in sorted(self.entries(), key=lambda one: one.stat().st_mtime)[:-MOST_KEPT]:
                _remove(old)
        return True


FUNCTIONS = "functions"  # folder of a kept model in which those are that its text leaves out


def with_kept_functions(model: M, folder: Path) -> M:
    """A model that was loaded from this folder of the cache; what it leaves out is read from there, or kept there."""
    emitted = {spec.name for spec in model.description.functions}
    return replace(model, builders=KeptFunctions(folder / FUNCTIONS, model.builders, emitted))


class KeptFunctions(Mapping[str, Callable[[], ca.Function]]):
    """What builds each function of a kept model; those that its text leaves out are derived once and kept.

    A file holds the SHA-256 of what follows, and CasADi's own text of the function, packed: every operation in its
    order, so the bits are those of the function that was derived.

    Parameters
    ----------
    folder : Path
        Of the functions, inside that of the model.
    builders : mapping
        What derives each function, by name.
    emitted : collection of str
        Functions that the text of the model has.
    """

    def __init__(self, folder: Path, builders: Mapping[str, Callable[[], ca.Function]], emitted: set[str]) -> None:
        self._folder, self._builders, self._emitted = folder, builders, emitted

    def __getitem__(self, name: str) -> Callable[[], ca.Function]:
        build = self._builders[name]
        return build if name in self._emitted else lambda: self._read(name) or self._kept(name, build())

    def __contains__(self, name: object) -> bool:
        return name in self._builders

    def __iter__(self) -> Iterator[str]:
        return iter(self._builders)

    def __len__(self) -> int:
        return len(self._builders)

    def of(self, builders: Mapping[str, Callable[[], ca.Function]]) -> KeptFunctions:
        """The same functions by other builders: of a model that this process has derived already."""
        return KeptFunctions(self._folder, builders, self._emitted)

    def files(self) -> dict[str, bytes]:
        """The functions that are kept until now, as they are kept."""
        found: dict[str, bytes] = {}
        for name in self._builders:
            with suppress(OSError):
                found[name] = read_own(self._folder / name)
        return found

    def _read(self, name: str) -> ca.Function | None:
        """The function as it was kept; None where there is none that can be read."""
        with suppress(OSError, ValueError, RuntimeError, zlib.error):
            content = read_own(self._folder / name)
            if hashlib.sha256(content[32:]).digest() == content[:32]:
                return ca.Function.deserialize(zlib.decompress(content[32:]).decode())
        return None

    def _kept(self, name: str, made: ca.Function) -> ca.Function:
        """The function, kept where that is possible; not one with tables, whose numbers come from the model's text."""
        if not made.find_functions() and not refused_folder(self._folder):
            packed = zlib.compress(made.serialize().encode(), 1)
            with suppress(OutputError), replacing(self._folder / name) as temporary:
                temporary.write_bytes(hashlib.sha256(packed).digest() + packed)
        return made


def generated_aside(kind: type[M], generate: Generate) -> M:
    """A model that is not kept: generated into a folder of this process, loaded, and the folder removed."""
    with tempfile.TemporaryDirectory(prefix="symgen-") as place:
        return replace(load_folder(generate(Path(place) / "model"), kind), folder="")


def _remove(path: Path) -> None:
    """A file, a link or a folder, as far as it can be removed."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        with suppress(OSError):
            path.unlink()
