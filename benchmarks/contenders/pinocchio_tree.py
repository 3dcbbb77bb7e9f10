"""Trees of hinges for Pinocchio, from its C++ headers (PyPI `pin`): aba called in a loop, and as a CasADi function.

Pinocchio is compiled here, for this processor. Its wheel has no CasADi bindings, so the expression is built in C++ and
handed over as the text of a serialised Function.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import subprocess
import tempfile
import weakref
from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path
from shutil import which

import casadi as ca
import numpy as np

from benchmarks.harness.result import Skipped
from runtime.contract.cache import cache_folder, refused_folder

SOURCE = Path(__file__).with_name("pinocchio_tree.cpp")
FLAGS = (
    "-std=c++17",
    "-O3",
    "-march=native",
    "-DNDEBUG",
    "-shared",
    "-fPIC",
    "-DBOOST_VARIANT_USE_RELAXED_GET_BY_DEFAULT",
)  # Pinocchio asks for joint types that are not in the collection


@dataclass(frozen=True)
class Hinge:
    """A body on a hinge about its z-axis. parent: index of a body from 1 on, 0 is the ground.

    place (3) [m] and turn (3 x 3): the hinge in the parent at angle 0. mass [kg], center (3) [m], inertia (3) about the
    centre of mass along the body's axes [kg m^2].
    """

    parent: int
    place: tuple[float, ...]
    turn: np.ndarray
    mass: float
    center: tuple[float, ...]
    inertia: tuple[float, float, float]

    def row(self) -> list[float]:
        """As pinocchio_tree.cpp takes it."""
        xx, yy, zz = self.inertia
        return [self.parent, *self.place, *self.turn.ravel(), self.mass, *self.center, xx, 0.0, yy, 0.0, 0.0, zz]


def version() -> str:
    """Of the package. Raises Skipped if it is not installed."""
    return _package("pin").version


class PinocchioTree:
    """Forward dynamics of a tree by Pinocchio. gravity (3) [m/s^2]."""

    def __init__(self, library: ctypes.CDLL, hinges: list[Hinge], gravity: tuple[float, float, float]) -> None:
        self._library, self.n = library, len(hinges)
        self._bodies = np.array([hinge.row() for hinge in hinges], dtype=float)
        self._gravity = np.array(gravity)

    def worker(self, state: np.ndarray) -> Callable[[int], None]:
        """What calls aba n times, without building anything; the accelerations stay in `state`."""
        build, call, drop = self._library.tree_new, self._library.aba_loop, self._library.tree_delete
        build.argtypes, build.restype = (ctypes.c_int, *[ctypes.c_void_p] * 2), ctypes.c_void_p
        call.argtypes, drop.argtypes = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_longlong), (ctypes.c_void_p,)
        tree = build(self.n, self._bodies.ctypes.data, self._gravity.ctypes.data)

        def work(n: int) -> None:
            call(tree, state.ctypes.data, n)

        weakref.finalize(work, drop, tree)
        return work

    def expression(self, folder: Path) -> ca.Function:
        """(angles, rates) -> accelerations."""
        path = folder / "aba.casadi"
        call = self._library.aba_expression
        call.argtypes = (ctypes.c_int, *[ctypes.c_void_p] * 2, ctypes.c_char_p)
        call(self.n, self._bodies.ctypes.data, self._gravity.ctypes.data, str(path).encode())
        return ca.Function.deserialize(path.read_text(encoding="utf-8"))


def library() -> ctypes.CDLL:
    """Compile pinocchio_tree.cpp, which takes minutes; kept with the compiled programs.

    Raises Skipped where something is missing.
    """
    compiler = which("g++") or which("clang++")
    if compiler is None:
        raise Skipped("no C++ compiler found")
    casadi = Path(ca.__file__).parent
    folders = [_headers("libpinocchio"), _headers("cmeel-eigen") / "eigen3", casadi / "include"]
    command = [
        compiler,
        *FLAGS,
        *(f"-I{place}" for place in folders),
        str(SOURCE),
        f"-L{casadi}",
        "-lcasadi",
        f"-Wl,-rpath,{casadi}",
    ]
    key = hashlib.sha256("\n".join([*command, version(), SOURCE.read_text(encoding="utf-8")]).encode()).hexdigest()
    folder = cache_folder() / "libraries"
    if refused := refused_folder(folder):
        raise Skipped(f"{refused}; set SYMGEN_CACHE to a folder of your own")
    target = folder / f"{key}.so"
    if not target.exists():
        _build(command, target)
    return ctypes.CDLL(str(target))


def _build(command: list[str], target: Path) -> None:
    with tempfile.TemporaryDirectory(dir=target.parent) as work:
        made = Path(work) / target.name
        result = subprocess.run([*command, "-o", str(made)], capture_output=True, text=True)
        if result.returncode != 0:
            raise Skipped(f"Pinocchio {version()} does not compile: {result.stderr[:500]}")
        os.replace(made, target)


def _headers(package: str) -> Path:
    return Path(str(_package(package).locate_file("cmeel.prefix/include")))


def _package(name: str) -> Distribution:
    try:
        return distribution(name)
    except PackageNotFoundError:
        raise Skipped(f"{name} is not installed; install the extra `benchmark`") from None
