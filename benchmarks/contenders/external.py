"""Native programs as CasADi Functions: integrators of CasADi call the same code as steps, with exact Jacobians.

CasADi loads Functions from shared libraries; the one made here copies arguments and results, and calls code by LLVM
whose addresses it is given.
"""

from __future__ import annotations

import ctypes
import shutil
import tempfile
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from benchmarks.contenders.by_c_compiler import compile_source
from runtime.contract.tape import code_length, shared
from runtime.engine.native import NativeProgram
from runtime.engine.prepare import prepare
from runtime.engine.program import Call

VALUES, SLOPES = range(2)  # the two programs of an external Function
BEST = 20_000  # operations up to which they are compiled as well as steps: beyond, that takes long and gains a tenth
TIMED, ENOUGH = 20, 1e-3  # bursts, and how long each lasts [s]
HEAD = """
#include <string.h>
typedef void (*program)(double *, const double *, double *, long long);
static struct { program run; double *z; const double *c; double *w; } bound[2];
void bind(int k, program run, double *z, const double *c, double *w) {
  bound[k].run = run; bound[k].z = z; bound[k].c = c; bound[k].w = w;
}
void repeat(int k, long long n) {
  while (n-- > 0) bound[k].run(bound[k].z, bound[k].c, bound[k].w, 1);
}
static int called(int k, const double **arg, const long long *in, int n_in,
                  double **res, const long long *out, int n_out) {
  double *z = bound[k].z;
  for (int i = 0; i < n_in; z += in[i++])
    if (arg[i]) memcpy(z, arg[i], in[i] * sizeof(double)); else memset(z, 0, in[i] * sizeof(double));
  bound[k].run(bound[k].z, bound[k].c, bound[k].w, 1);
  for (int i = 0; i < n_out; z += out[i++])
    if (res[i]) memcpy(res[i], z, out[i] * sizeof(double));
  return 0;
}
"""
Shapes = Mapping[str, ca.Sparsity]


@dataclass
class BoundProgram:
    """A program with its arrays; z holds inputs and outputs one after another."""

    engine: NativeProgram
    operations: int
    z: np.ndarray
    c: np.ndarray

    def __post_init__(self) -> None:
        self.code = self.engine.tiers.code
        self.w = np.zeros(self.code.work + 1)

    def addresses(self) -> list[ctypes.c_void_p]:
        """Of the code and its arrays."""
        run: Any = self.code.run
        return [
            ctypes.cast(run, ctypes.c_void_p),
            *(ctypes.c_void_p(array.ctypes.data) for array in (self.z, self.c, self.w)),
        ]


class External:
    """(inputs) -> outputs as `function`, native; expressions in the inputs and in c.

    inputs, outputs: vectors by name. slopes: the derivatives of outputs by inputs that will be asked for, by both
    names; the others are taken as zero. values (c_size,): c. Raises CompilerError without LLVM or a C compiler.
    """

    def __init__(
        self,
        inputs: Mapping[str, ca.SX],
        outputs: Mapping[str, ca.SX],
        slopes: Mapping[tuple[str, str], ca.SX],
        c: ca.SX,
        values: np.ndarray,
    ) -> None:
        pairs = [(out, into) for out in outputs for into in inputs]
        blocks = {
            f"jac_{out}_{into}": slopes.get((out, into), ca.SX(outputs[out].numel(), inputs[into].numel()))
            for out, into in pairs
        }
        results = {VALUES: [ca.densify(value) for value in outputs.values()]}
        results[SLOPES] = [ca.vec(block.nz[:]) for block in blocks.values() if block.nnz()]
        self._programs = [_program(list(inputs.values()), result, c, values) for _, result in sorted(results.items())]
        given, found = ({name: ca.Sparsity.dense(x.numel()) for name, x in some.items()} for some in (inputs, outputs))
        marks = {f"out_{name}": ca.Sparsity(value.numel(), 1) for name, value in outputs.items()}
        source = HEAD + _exported("f", VALUES, given, found)
        source += _exported("jac_f", SLOPES, {**given, **marks}, {name: one.sparsity() for name, one in blocks.items()})
        self._library, self.function = _loaded(source)
        for k, program in enumerate(self._programs):
            self._library.bind(k, *program.addresses())

    @property
    def operations(self) -> tuple[int, int]:
        """Of the values, and of the derivatives."""
        return self._programs[VALUES].operations, self._programs[SLOPES].operations

    def seconds(self, which: int) -> float:
        """CPU time [s] of one more evaluation at the last place: of the values (VALUES), the derivatives (SLOPES)."""
        repeat, count, found = self._library.repeat, 1, list[float]()
        repeat.argtypes = (ctypes.c_int, ctypes.c_longlong)
        while len(found) < TIMED:
            began = time.thread_time()
            repeat(which, count)
            spent = time.thread_time() - began
            if spent < ENOUGH:
                count *= 2
            else:
                found.append(spent / count)
        return min(found)


def _program(inputs: list[ca.SX], results: list[ca.SX], c: ca.SX, values: np.ndarray) -> BoundProgram:
    """[inputs, results] -> [inputs, results]."""
    given, result = ca.vertcat(*inputs), ca.vertcat(*results)
    z = ca.SX.sym("z", given.numel() + result.numel())
    (result,) = shared(ca.substitute([result], [given], [z[: given.numel()]]))
    stage = ca.Function("external", [z, c], [ca.vertcat(z[: given.numel()], result)], ["z", "c"], ["z_next"])
    prepared = prepare(Call(stage), z.numel(), c.numel())
    operations = sum(code_length(one) for one in prepared.program.stages())
    engine = NativeProgram(prepared.program, wait=operations <= BEST)
    return BoundProgram(engine, operations, prepared.widened(np.zeros(z.numel())), prepared.ready(values))


def _exported(name: str, k: int, inputs: Shapes, outputs: Shapes) -> str:
    """What CasADi asks a library for, about one Function: program k."""
    arrays, calls = [], []
    for side, shapes in (("in", inputs), ("out", outputs)):
        rows = [[one.size1(), one.size2(), *one.colind(), *one.row()] for one in shapes.values()]
        addresses = _list(f"{name}_{side}_{i}" for i in range(len(rows)))
        arrays += [f"static const long long {name}_{side}_{i}[] = {{{_list(row)}}};" for i, row in enumerate(rows)]
        arrays += [
            f"static const long long *const {name}_{side}_shapes[] = {{{addresses}}};",
            f"static const char *const {name}_{side}_names[] = {{{_list(chr(34) + one + chr(34) for one in shapes)}}};",
            f"static const long long {name}_{side}_sizes[] = {{{_list(one.nnz() for one in shapes.values())}}};",
            f"long long {name}_n_{side}(void) {{ return {len(rows)}; }}",
            f"const long long *{name}_sparsity_{side}(long long i) {{ return {name}_{side}_shapes[i]; }}",
            f"const char *{name}_name_{side}(long long i) {{ return {name}_{side}_names[i]; }}",
        ]
    calls = [
        f"int {name}(const double **arg, double **res, long long *iw, double *w, int mem) {{",
        f"  return called({k}, arg, {name}_in_sizes, {len(inputs)}, res, {name}_out_sizes, {len(outputs)});",
        "}\n",
    ]
    return "\n".join([*arrays, *calls])


def _list(entries: object) -> str:
    return ", ".join(str(entry) for entry in entries)  # type: ignore[attr-defined]


def _loaded(source: str) -> tuple[ctypes.CDLL, ca.Function]:
    """A copy of the library with arrays of its own, and its Function; loaded it is not needed on disk any more."""
    library = compile_source(source)
    with tempfile.TemporaryDirectory() as folder:
        own = Path(shutil.copy(library, folder))
        return ctypes.CDLL(str(own)), ca.external("f", str(own))
