"""CasADi functions as native code that C calls by address: what a step is made of, and what is said of its states."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Any, NamedTuple

import casadi as ca

from runtime.contract.tape import no_collection, read_tape
from runtime.engine.llvm_code import FIRST_EFFORT, Compiler
from runtime.engine.program import Form

CHUNK = 1000  # statements of a function


class NativeFunction(NamedTuple):
    """A function (x, c) of two vectors; in_place: x becomes the result, else an array y before it does."""

    function: ca.Function
    in_place: bool


class FunctionCode(NamedTuple):
    """addresses by name, of `void f([y, ]x, c, w)`; work: entries of w; keep: what must outlive them."""

    addresses: Mapping[str, int]
    work: int
    keep: Any


def native_functions(functions: Mapping[str, NativeFunction], mathematics: str) -> FunctionCode:
    """Code of them, from the cache or compiled; mathematics: own or library. Raises NoLlvm."""
    return _FunctionsCompiler(functions).build(Form(1, mathematics, CHUNK, False), FIRST_EFFORT)


class _FunctionsCompiler(Compiler[FunctionCode]):
    """Of functions in one module."""

    def __init__(self, functions: Mapping[str, NativeFunction]) -> None:
        self._functions = functions
        digest = hashlib.sha256()
        for name, one in functions.items():
            text = repr(read_tape(one.function)).encode() if one.function.find_functions() else one.function.serialize()
            digest.update(f"{name} {one.in_place} ".encode())
            digest.update(text if isinstance(text, bytes) else text.encode())
        super().__init__(digest.digest())

    def printed(self, form: Form) -> tuple[str, int]:
        """See llvm_ir.py."""
        from runtime.engine.llvm_ir import functions_ir

        with no_collection():
            tapes = {name: read_tape(_of_arrays(one)) for name, one in self._functions.items()}
            found: tuple[str, int] = functions_ir(tapes, form)
            return found

    def loaded(self, engine: Any, work: int) -> FunctionCode:
        """Their addresses."""
        addresses = {name: int(engine.get_function_address(name)) for name in self._functions}
        return FunctionCode(addresses, work, engine)


def _of_arrays(one: NativeFunction) -> ca.Function:
    """The function with its inputs by the names of arrays, and its result in z."""
    function = one.function
    x, c = (ca.SX.sym(name, function.size1_in(k)) for k, name in enumerate("xc"))
    if one.in_place:
        return ca.Function(function.name(), [x, c], [ca.densify(function(x, c))], ["z", "c"], ["z_next"])
    y = ca.SX.sym("y", function.numel_out(0))
    found = ca.densify(ca.vec(ca.SX(function(x, c))))
    return ca.Function(function.name(), [y, x, c], [found], ["z", "x", "c"], ["z_next"])
