"""Machine code of a step program: printed as LLVM IR, compiled by LLVM, kept in the object cache, loaded."""

from __future__ import annotations

import ctypes
import hashlib
import threading
import time
from abc import abstractmethod
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, Generic, NamedTuple, TypeVar

import casadi as ca

from runtime.contract.errors import CompilerError
from runtime.contract.log import CACHE, COMPILE
from runtime.contract.tape import code_length, no_collection, read_tape
from runtime.engine.object_cache import ObjectCache
from runtime.engine.program import Form, Program, Repeat, Until
from runtime.engine.table_code import bind_native

T = TypeVar("T")
PRINTER = ("llvm_ir", "mathematics", "table_code", "llvm_code", "derivatives")  # files of this folder


class Effort(NamedTuple):
    """What the compiler does: passes over the IR or none, and the level of its code generator (0 to 3)."""

    passes: bool
    level: int


class Processor(NamedTuple):
    """Name and features as LLVM writes them; "" is the plainest of the kind."""

    name: str
    features: str


class Code(NamedTuple):
    """`run(z, c, w, n)`, `run_blocks(z, c, w, n, blocks, apart)` and `run_rows` on addresses; see llvm_ir.py.

    work: entries of w. keep holds what must outlive it.
    """

    run: Callable[[int, int, int, int], None]
    run_blocks: Callable[[int, int, int, int, int, int], None]
    run_rows: Callable[[int, int, int, int, int, int, int], None]
    work: int
    keep: Any


class NoLlvm(CompilerError):
    """llvmlite is not there or does not work here."""


@cache
def _llvm() -> Any:
    """llvmlite's binding, ready for this machine. Raises NoLlvm."""
    try:
        import llvmlite.binding as llvm

        llvm.initialize_native_target()
        llvm.initialize_native_asmprinter()
        llvm.Target.from_default_triple()
    except (ImportError, OSError, RuntimeError) as error:
        raise NoLlvm(f"llvmlite cannot be used: {error}") from error
    return llvm


def find_llvm() -> str:
    """Why there is no LLVM, "" if there is."""
    try:
        _llvm()
    except NoLlvm as error:
        return str(error)
    return ""


@cache
def host() -> Processor:
    """This machine's processor."""
    llvm = _llvm()
    return Processor(llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten())


class Compiler(Generic[T]):
    """Makes code of something in any form. Raises NoLlvm where LLVM cannot be had.

    digest: of what it is; a subclass says what is printed, and what is called of it.
    """

    def __init__(self, digest: bytes) -> None:
        _llvm()
        self._digest = digest

    @abstractmethod
    def printed(self, form: Form) -> tuple[str, int]:
        """(IR, entries of the work array)."""

    @abstractmethod
    def loaded(self, engine: Any, work: int) -> T:
        """What is called of the code that an engine of LLVM holds, as long as it lives."""

    def build(self, form: Form, effort: Effort, processor: Processor | None = None) -> T:
        """Code from the cache, or compiled and kept there."""
        processor, stored = processor or host(), ObjectCache()
        key = self._key(form, effort, processor)
        found = stored.read(key)
        if found is None:
            began = time.perf_counter()
            text, work = self.printed(form)
            found = machine_code(text, effort, processor), work
            del text
            stored.write(key, *found)
            COMPILE.info("program %.12s: compiled in %.3g s", key, time.perf_counter() - began)
        else:
            CACHE.debug("program %.12s: read", key)
        return self.loaded(linked(found[0], processor), found[1])

    def is_kept(self, form: Form, effort: Effort) -> bool:
        """Is this code in the cache?"""
        return ObjectCache().has(self._key(form, effort, host()))

    def _key(self, form: Form, effort: Effort, processor: Processor) -> str:
        """Of the program itself, not of its IR: a program that is in the cache is not printed."""
        text = "\n".join([repr(form), repr(effort), *processor])
        return hashlib.sha256(self._digest + tools() + text.encode()).hexdigest()


class ProgramCompiler(Compiler[Code]):
    """Of a program."""

    def __init__(self, program: Program) -> None:
        self._program = program
        super().__init__(program_digest(program))

    def printed(self, form: Form) -> tuple[str, int]:
        """See llvm_ir.py."""
        with no_collection():
            from runtime.engine.llvm_ir import program_ir

            found: tuple[str, int] = program_ir(self._program, form)
            return found

    def loaded(self, engine: Any, work: int) -> Code:
        """Its three entries."""
        p, n = ctypes.c_void_p, ctypes.c_int64
        kinds = {"run": (p, p, p, n), "run_blocks": (p, p, p, n, n, n), "run_rows": (p, p, p, p, n, p, n)}
        found: dict[str, Any] = {
            name: ctypes.CFUNCTYPE(None, *kind)(engine.get_function_address(name)) for name, kind in kinds.items()
        }
        return Code(**found, work=work, keep=engine)


def machine_code(text: str, effort: Effort, processor: Processor) -> bytes:
    """The object file of a module of IR. Raises NoLlvm."""
    llvm = _llvm()
    module = llvm.parse_assembly(text, context=llvm.create_context())
    del text  # a hundred bytes an operation
    machine = _machine(processor, effort.level)
    if effort.passes:
        options = llvm.create_pipeline_tuning_options(speed_level=3)
        builder = llvm.create_pass_builder(machine, options)
        builder.getModulePassManager().run(module, builder)
    return bytes(machine.emit_object(module))


def _machine(processor: Processor, level: int) -> Any:
    target = _llvm().Target.from_default_triple()
    return target.create_target_machine(cpu=processor.name, features=processor.features, opt=level, jit=True)


def linked(code: bytes, processor: Processor) -> Any:
    """The engine that holds an object file's code; what it gives addresses of lives as long as it does."""
    llvm = _llvm()
    # in LLVM's own context: one of its own could be collected before the engine that needs it
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine(processor, 0))
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    bind_native(engine)
    return engine


@cache
def tools() -> bytes:
    """What besides the program decides about the code: compiler, CasADi and the text of the printer."""
    llvm = _llvm()
    parts = [str(llvm.llvm_version_info), llvm.get_default_triple(), ca.CasadiMeta.version()]
    parts += [Path(__file__).with_name(f"{name}.py").read_text(encoding="utf-8") for name in PRINTER]
    return hashlib.sha256("\n".join(parts).encode()).digest()


def program_digest(program: Program) -> bytes:
    """What is computed: the stages and their order."""
    numbers = {stage.name(): k for k, stage in enumerate(program.stages())}

    def again(body: str, node: Repeat | Until) -> str:
        head = f"repeat {node.count}" if isinstance(node, Repeat) else f"until {node.flag} {node.limit}"
        return f"{head} ({body})"

    control = program.fold(lambda stage: str(numbers[stage.name()]), " ".join, again)
    digest = hashlib.sha256(control.encode())
    for stage in program.stages():
        # with the numbers of tables the text were long
        digest.update(repr(read_tape(stage)).encode() if stage.find_functions() else stage.serialize().encode())
    return digest.digest()


# ---- Code at once, better code when it has run long enough: how a program is compiled for either, and when.
#
# The first code takes some 10 us an operation to make. Once calls have taken as long as better code is expected to
# take, that is made in a background thread, and the next call uses it: the same bits, so a run may change over at
# any time.

INLINED = 10_000  # operations with every call written out: below, stages are inlined and z is local
WHOLE_STAGE_OPERATIONS = 70_000  # below, each stage is one function when it is optimised
LONG_CODE_OPERATIONS = 50_000  # above, the first code is fetched faster in short functions
OPTIMISED = 200_000  # above, no passes
FIRST_EFFORT = Effort(passes=False, level=0)
BEST = Effort(passes=True, level=2)
SECONDS_PER_OPERATION = 6e-5  # of better code, about


class Tier(NamedTuple):
    """How something is compiled."""

    form: Form
    effort: Effort


def first_tier(program: Program, mathematics: str) -> Tier:
    """How a program is compiled at once."""
    return Tier(
        Form(1, mathematics, 100 if program_length(program) > LONG_CODE_OPERATIONS else 1000, False), FIRST_EFFORT
    )


def best_tier(program: Program, mathematics: str) -> Tier:
    """How it is compiled for a long run."""
    if written_out(program) <= INLINED:
        return Tier(Form(1, mathematics, 0, True), BEST)
    length = program_length(program)
    if length <= WHOLE_STAGE_OPERATIONS:
        return Tier(Form(1, mathematics, 0, False), BEST)
    return Tier(Form(1, mathematics, 300, False), BEST if length <= OPTIMISED else Effort(passes=False, level=2))


def program_length(program: Program) -> int:
    """Operations of the distinct stages."""
    return sum(code_length(stage) for stage in program.stages())


def written_out(program: Program) -> int:
    """Operations of a program with every call of a stage written out, a repetition's once, what is seldom done not."""

    def again(body: int, node: Repeat | Until) -> int:
        return 0 if isinstance(node, Until) and not node.usual else body

    return int(program.fold(code_length, lambda parts: sum(parts), again))


class Tiers(Generic[T]):
    """Code of the first tier at once; of the best when so many seconds were spent that it pays.

    operations: of what is compiled. wait: only the best will do. final: it is the best.
    """

    def __init__(self, compiler: Compiler[T], first: Tier, best: Tier, operations: int, wait: bool) -> None:
        self._compiler, self._best = compiler, best
        self._left = operations * SECONDS_PER_OPERATION  # seconds to be spent before better code is made
        self._builder: threading.Thread | None = None
        self.final = wait or compiler.is_kept(*best)
        self.code = compiler.build(*(best if self.final else first))

    def use(self, call: Callable[[T], object]) -> None:
        """A call of the code: one code for all of it, whatever is built meanwhile; the time it takes counts."""
        if self.final:
            call(self.code)
            return
        began = time.perf_counter()
        call(self.code)
        self._left -= time.perf_counter() - began
        if self._left < 0 and self._builder is None:
            self._builder = threading.Thread(target=self._improve, name="symgen better code")
            self._builder.start()

    def finish(self) -> None:
        """Change to the best code now, and wait for it."""
        if self._builder is not None:
            self._builder.join()
        elif not self.final:
            self._improve()

    def _improve(self) -> None:
        try:
            self.code = self._compiler.build(*self._best)
        except CompilerError:
            pass  # the first code is right, only slower: it stays
        self.final = True
