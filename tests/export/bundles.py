"""Exported C built by the machine's compiler and called through ctypes."""

from __future__ import annotations

import ctypes
import re
import shlex
import subprocess
from pathlib import Path

import numpy as np

from runtime.engine.c_source import find_compiler
from runtime.export.c_bundle import Exported, exported, write_c
from runtime.model import Model

STRICT = ("-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror")


def compiled(folder: Path, stem: str, *flags: str) -> Path:
    """A shared library of folder/stem.c."""
    library = folder / f"{stem}{abs(hash(flags))}.so"
    command = [
        *shlex.split(find_compiler() or "cc"),
        *flags,
        "-shared",
        "-fPIC",
        f"{stem}.c",
        "-o",
        str(library),
        "-lm",
    ]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return library


BEHIND, CANARY = 64, -7.25e107  # numbers behind each array that nobody may touch


class Bundle:
    """NAME.c with the memory of one instance; no call writes behind the arrays that the header asks for."""

    def __init__(self, one: Exported, library: Path, header: str) -> None:
        self.one, self._library = one, ctypes.CDLL(str(library))
        found = re.findall(rf"#define {one.prefix}(\w+) (\d+)\n", header)
        size = {name: int(value) for name, value in found}
        self._behind: list[np.ndarray] = []
        self.p, self.c, self.z, self.y, self.w = (self._array(size[name]) for name in ("P", "C", "Z", "OUTPUTS", "W"))
        self.dt = one.scheme.grid.dt_L
        self.call("defaults", self.p)
        self.call("constants", self.c, self.p, self.dt, self.w)
        self.call("first", self.z)

    def _array(self, size: int) -> np.ndarray:
        """(size,) of zeros, with canaries behind it."""
        whole = np.full(size + BEHIND, CANARY)
        self._behind.append(whole[size:])
        whole[:size] = 0.0
        return whole[:size]

    def call(self, name: str, *arguments: np.ndarray | float | int) -> int:
        """A function of the bundle; whole numbers are counts."""
        kinds = {float: ctypes.c_double, int: ctypes.c_long}
        given = [kinds[type(a)](a) if type(a) in kinds else ctypes.c_void_p(a.ctypes.data) for a in arguments]
        found = int(getattr(self._library, self.one.prefix + name)(*given))
        assert all((one == CANARY).all() for one in self._behind), f"{name} writes behind an array"
        return found

    def step(self, n: int = 1) -> None:
        self.call("step", self.z, self.c, self.w, n)

    def observe(self) -> np.ndarray:
        self.call("observe", self.y, self.z, self.c, self.w)
        return self.y


def bundle(model: Model, folder: Path, *flags: str, **how: object) -> Bundle:
    """A model exported into a folder, built and loaded."""
    one = exported(model, **how)  # type: ignore[arg-type]
    write_c(one, folder)
    stem = one.prefix[:-1]
    return Bundle(one, compiled(folder, stem, *(flags or (*STRICT, "-O1"))), (folder / f"{stem}.h").read_text())
