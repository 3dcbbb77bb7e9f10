"""A step program on an NVIDIA GPU: a thread a case, from the LLVM IR that lanes on the CPU are made of.

The operations are those of the CPU in their order, each rounded to nearest by itself: no product and sum are fused that
the text does not fuse, division and square root are those of IEEE, and sin, cos and exp are our own. What calls
functions of the C library, which every platform rounds in its own way, is refused by name.

    IR of the program -> PTX by LLVM -> machine code by `ptxas` where its wheel is installed, else by the driver
"""

from __future__ import annotations

import ctypes
import hashlib
import re
import struct
import subprocess
import tempfile
import threading
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.errors import CompilerError
from runtime.contract.tape import no_collection
from runtime.engine.llvm_code import NoLlvm, program_digest, tools
from runtime.engine.llvm_ir import program_ir
from runtime.engine.mathematics import LIBRARY_BINARY, LIBRARY_UNARY
from runtime.engine.native import lane_form
from runtime.engine.object_cache import ObjectCache
from runtime.engine.program import Program
from runtime.engine.table_code import ARRAYS, COUNT, MARKS, numbers_of

TRIPLE = "nvptx64-nvidia-cuda"
LEAST = "sm_70"  # the oldest that today's compilers know
THREADS = 64  # of a block: cases need many registers
MOST_DEVICE_BYTES = 1 << 30  # of rows that are on the device at a time
EXTRA = "pip install 'symgen[gpu]'"

# One case: the program, n times, on z and c of its row. Compiled for the host, the same text is tested there.
CASE = """
define void @one_case(ptr %rows, ptr %w, i64 %z, i64 %c, i64 %apart, i64 %work, i64 %n, i64 %k) {
  %row = mul i64 %k, %apart
  %at = getelementptr i8, ptr %rows, i64 %row
  %pz = getelementptr double, ptr %at, i64 %z
  %pc = getelementptr double, ptr %at, i64 %c
  %own = mul i64 %k, %work
  %pw = getelementptr double, ptr %w, i64 %own
  call void @run(ptr %pz, ptr %pc, ptr %pw, i64 %n)
  ret void
}
"""
KERNEL = """
declare i32 @llvm.nvvm.read.ptx.sreg.tid.x()
declare i32 @llvm.nvvm.read.ptx.sreg.ctaid.x()
declare i32 @llvm.nvvm.read.ptx.sreg.ntid.x()
define ptx_kernel void @cases(ptr %rows, ptr %w, i64 %z, i64 %c, i64 %apart, i64 %work, i64 %n, i64 %cases) {
  %t = call i32 @llvm.nvvm.read.ptx.sreg.tid.x()
  %b = call i32 @llvm.nvvm.read.ptx.sreg.ctaid.x()
  %d = call i32 @llvm.nvvm.read.ptx.sreg.ntid.x()
  %first = mul i32 %b, %d
  %i = add i32 %first, %t
  %k = zext i32 %i to i64
  %in = icmp ult i64 %k, %cases
  br i1 %in, label %go, label %out
go:
  call void @one_case(ptr %rows, ptr %w, i64 %z, i64 %c, i64 %apart, i64 %work, i64 %n, i64 %k)
  br label %out
out:
  ret void
}
"""


class NoGpu(CompilerError):
    """There is no GPU, or a program that it does not take; the message says what is missing."""


def case_ir(program: Program) -> tuple[str, int]:
    """(IR with `one_case`, entries of the work array of a case). Raises NoGpu for what has other bits on a GPU."""
    with no_collection():
        text, work = program_ir(program, lane_form(program, 1)[0])
    library = [name for name in (*LIBRARY_UNARY, *LIBRARY_BINARY) if re.search(rf"call double @{name}\(", text)]
    if library:
        raise NoGpu(f"the model uses {', '.join(library)} of the C library, which a GPU rounds otherwise: use the CPU")
    return _with_numbers(text) + CASE, work


def _with_numbers(text: str) -> str:
    """With the numbers of tables written out, which code of the CPU finds in arrays of its process."""
    marks = re.search(rf"^@{MARKS} = constant .*?\[(i64 .*)\]$", text, flags=re.M)
    if marks is None:
        return text
    arrays = [array for mark in re.findall(r"i64 (\d+)", marks[1]) for array in numbers_of(float(mark))]
    written = []
    for k, array in enumerate(arrays):
        numbers = [float(value) for value in array.ravel()] or [0.0]
        listed = ", ".join(f"double 0x{struct.pack('>d', value).hex().upper()}" for value in numbers)
        written.append(f"@numbers_{k} = internal constant [{len(numbers)} x double] [{listed}]")
    places = ", ".join(f"ptr @numbers_{k}" for k in range(len(arrays)))
    own = f"@{ARRAYS} = internal constant [{len(arrays)} x ptr] [{places}]"
    text = re.sub(rf"^@({MARKS}|{COUNT}) = .*\n", "", text, flags=re.M)  # nothing is filled in
    return re.sub(rf"^@{ARRAYS} = .*$", "\n".join([*written, own]), text, flags=re.M)


def ptx_of(program: Program, architecture: str = LEAST) -> tuple[str, int]:
    """(PTX with the kernel `cases`, entries of the work array of a case); kept in the object cache.

    Raises NoGpu, NoLlvm.
    """
    stored = ObjectCache()
    own = Path(__file__).read_bytes()
    key = hashlib.sha256(program_digest(program) + tools() + own + architecture.encode()).hexdigest()
    found = stored.read(key)
    if found is None:
        text, work = case_ir(program)
        found = _ptx(text, architecture).encode(), work
        stored.write(key, *found)
    return found[0].decode(), found[1]


def _ptx(text: str, architecture: str) -> str:
    """PTX of IR with `one_case`."""
    try:
        import llvmlite.binding as llvm

        llvm.initialize_all_targets()
        llvm.initialize_all_asmprinters()
        target = llvm.Target.from_triple(TRIPLE)
    except (ImportError, OSError, RuntimeError) as error:
        raise NoLlvm(f"llvmlite cannot write PTX: {error}") from error
    machine = target.create_target_machine(cpu=architecture, opt=3)
    inside = re.sub(
        r"^define void @(run|run_blocks|run_rows|one_case)\(", r"define internal void @\1(", text, flags=re.M
    )
    module = llvm.parse_assembly(inside + KERNEL, context=llvm.create_context())
    module.triple, module.data_layout = TRIPLE, str(machine.target_data)
    module.verify()
    options = llvm.create_pipeline_tuning_options(speed_level=3)
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    return str(machine.emit_assembly(module))


def find_ptxas() -> Path | None:
    """The assembler of the wheel `nvidia-cuda-nvcc`, None where it is not installed."""
    spec = find_spec("nvidia")
    for folder in (spec.submodule_search_locations or []) if spec else []:
        for place in (Path(folder) / "cuda_nvcc" / "bin", Path(folder) / "cu13" / "bin"):
            for name in ("ptxas", "ptxas.exe"):
                if (place / name).is_file():
                    return place / name
    return None


def assembled(ptx: str, architecture: str) -> bytes | None:
    """Machine code of PTX, None where `ptxas` is not installed. Raises NoGpu with what it says."""
    ptxas = find_ptxas()
    if ptxas is None:
        return None
    with tempfile.TemporaryDirectory() as folder:
        source, code = Path(folder) / "cases.ptx", Path(folder) / "cases.cubin"
        source.write_text(ptx, encoding="ascii")
        command = [str(ptxas), "--fmad=false", f"-arch={architecture}", str(source), "-o", str(code)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            raise NoGpu(f"ptxas does not take the program: {done.stderr.strip()[-500:]}")
        return code.read_bytes()


class Gpu:
    """The first device of a driver, by `cuda.bindings.driver`; architecture: such as "sm_90". Raises NoGpu."""

    def __init__(self, driver: Any) -> None:
        self._driver = driver
        try:
            self.call("cuInit", 0)
            device = self.call("cuDeviceGet", 0)
            numbers = driver.CUdevice_attribute
            major = self.call("cuDeviceGetAttribute", numbers.CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR, device)
            minor = self.call("cuDeviceGetAttribute", numbers.CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR, device)
            self._context = self.call("cuDevicePrimaryCtxRetain", device)
        except (RuntimeError, NoGpu) as error:
            raise NoGpu(f"no NVIDIA GPU can be used: {error}") from error
        self.architecture = f"sm_{major}{minor}"

    def call(self, name: str, *arguments: Any) -> Any:
        """A function of the driver: its one result, or None. Raises NoGpu by name."""
        status, *results = getattr(self._driver, name)(*arguments)
        if int(status) != 0:
            raise NoGpu(f"{name} of the NVIDIA driver failed: {getattr(status, 'name', status)}")
        return results[0] if results else None

    def enter(self) -> None:
        """Make the device that of this thread."""
        self.call("cuCtxSetCurrent", self._context)

    def kernel(self, program: Program) -> tuple[Any, int]:
        """(the kernel `cases` of a program, entries of the work array of a case)."""
        self.enter()
        ptx, work = ptx_of(program, self.architecture)
        code = assembled(ptx, self.architecture) or ptx.encode() + b"\0"
        return self.call("cuModuleGetFunction", self.call("cuModuleLoadData", code), b"cases"), work


@cache
def the_gpu() -> Gpu:
    """The device of this machine. Raises NoGpu."""
    try:
        from cuda.bindings import driver
    except ImportError as error:
        raise NoGpu(f"the library that talks to the NVIDIA driver is not installed: {EXTRA}") from error
    return Gpu(driver)


class GpuCode:
    """Code of a program for rows (count, size, 1) on a device; see LaneCode of native.py."""

    width = 1

    def __init__(self, program: Program, gpu: Gpu) -> None:
        self._gpu, (self._kernel, self._work) = gpu, gpu.kernel(program)
        self._lock = threading.Lock()
        self._room = [0, 0]  # bytes of rows and of work arrays
        self._place: list[Any] = [None, None]

    def run(self, blocks: np.ndarray, z: int, c: int, n: int) -> None:
        """Apply the program n times to each row, whose z and c begin at these entries. Raises NoGpu."""
        count, size, _ = blocks.shape
        most = max(1, MOST_DEVICE_BYTES // (8 * (size + self._work)))
        with self._lock:
            self._gpu.enter()
            for first in range(0, count, most):
                self._run(blocks[first : first + most], z, c, n)

    def _run(self, rows: np.ndarray, z: int, c: int, n: int) -> None:
        count, size, _ = rows.shape
        own, work = (self._memory(k, 8 * count * length) for k, length in enumerate((size, self._work)))
        self._gpu.call("cuMemcpyHtoD", own, rows.ctypes.data, rows.nbytes)
        values = (own, work, z, c, 8 * size, self._work, n, count)
        kinds = (None, None, *[ctypes.c_int64] * 6)
        blocks = -(-count // THREADS)
        self._gpu.call("cuLaunchKernel", self._kernel, blocks, 1, 1, THREADS, 1, 1, 0, 0, (values, kinds), 0)
        self._gpu.call("cuMemcpyDtoH", rows.ctypes.data, own, rows.nbytes)

    def _memory(self, which: int, wanted: int) -> Any:
        """Room for so many bytes on the device."""
        if self._place[which] is None or self._room[which] < wanted:
            if self._place[which] is not None:
                self._gpu.call("cuMemFree", self._place[which])
                self._place[which] = None
            self._place[which] = self._gpu.call("cuMemAlloc", max(8, wanted))
            self._room[which] = wanted
        return self._place[which]
