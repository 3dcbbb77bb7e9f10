"""Code at once, better code when it has run long enough: how a program is compiled for either, and when.

The first code takes some 10 us an operation to make. Once calls have taken as long as better code is expected to take,
that is made in a background thread, and the next call uses it: the same bits, so a run may change over any time.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Mapping
from typing import Generic, NamedTuple, TypeVar

from runtime.contract.tape import Tape, code_length
from runtime.engine.compiled import CompilerError
from runtime.engine.llvm_code import Code, Compiler, Effort
from runtime.engine.llvm_ir import Form
from runtime.engine.program import Program, Repeat, Until

T = TypeVar("T")
INLINED = 10_000  # operations with every call written out: below, stages are inlined and z is local
WHOLE = 70_000  # below, each stage is one function when it is optimised
LONG = 50_000  # above, the first code is fetched faster in short functions
OPTIMISED = 200_000  # above, no passes
FIRST = Effort(passes=False, level=0)
BEST = Effort(passes=True, level=2)
SECONDS_PER_OPERATION = 6e-5  # of better code, about


class Tier(NamedTuple):
    """How something is compiled."""

    form: Form
    effort: Effort


def first_tier(program: Program, mathematics: str) -> Tier:
    """How a program is compiled at once."""
    return Tier(Form(1, mathematics, 100 if program_length(program) > LONG else 1000, False), FIRST)


def best_tier(program: Program, mathematics: str) -> Tier:
    """How it is compiled for a long run."""
    if written_out(program) <= INLINED:
        return Tier(Form(1, mathematics, 0, True), BEST)
    length = program_length(program)
    if length <= WHOLE:
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
    """What `build` makes of a tier: of the first at once; of the best when so many seconds were spent that it pays.

    kept: is it in the cache? operations: of what is compiled. wait: only the best will do. final: it is the best.
    """

    def __init__(
        self,
        build: Callable[[Tier], T],
        kept: Callable[[Tier], bool],
        first: Tier,
        best: Tier,
        operations: int,
        wait: bool,
    ) -> None:
        self._build, self._best = build, best
        self._left = operations * SECONDS_PER_OPERATION  # seconds to be spent before better code is made
        self._builder: threading.Thread | None = None
        self.final = wait or kept(best)
        self.code = build(best if self.final else first)

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
            self.code = self._build(self._best)
        except CompilerError:
            pass  # the first code is right, only slower: it stays
        self.final = True


def code_in_tiers(
    program: Program, first: Tier, best: Tier, wait: bool, tapes: Mapping[str, Tape] | None = None
) -> Tiers[Code]:
    """Code of a program; tapes: of stages that need not be read for the first code. Raises NoLlvm."""
    compiler = Compiler(program, tapes)
    return Tiers(
        lambda tier: compiler.build(*tier),
        lambda tier: compiler.is_kept(*tier),
        first,
        best,
        program_length(program),
        wait,
    )
