"""An SX Function as straight-line code: one list of nodes in single assignment, printed as Python or as C; tables that
it calls as one operation; and its binding times, by which it is split into what can be computed once and what is left
(partial evaluation).
"""

from __future__ import annotations

import gc
import hashlib
import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from enum import IntEnum
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from runtime.contract import table_function

# Tables: piecewise polynomials that straight-line code calls as one operation, at a price that hardly depends on n.
#
# A table is data beside the code. In SX expressions it is a call (ca.OP_CALL) of the Function `table_KEY_ORDER` of
# table_function.py, on tapes a node whose value is `mark(key, order)`. The key is a hash of the numbers, so equal
# tables are one, in every process; engines take the numbers from here by it.
#
# A knot belongs to the row that it begins, so derivatives there are those from the right. Engines find the row by
#
#     inside = min(x, last)                      NaN is taken to the last row, whose polynomial gives NaN
#     bucket = trunc(max((inside - left) scale, 0))
#     row = starts[bucket]                       knots in buckets before; of an even grid the bucket itself
#     row += 2^l if inside >= knots[row + 2^l]   for l = levels - 1, ..., 0
#
# Rounding is monotone, so what lies in a bucket before is less than x: the row is exact. levels is 1 on an even grid
# and at most log2(n) elsewhere.

ORDERS = 8  # of derivatives, the value among them: what a mark has room for
LARGEST = np.finfo(float).max
NAME = re.compile(r"table_(\d+)_(\d)")
_SEARCH, _LEVEL, _ORIGIN, _POWER = 5, 4, 2, 3  # instructions: clamp and bucket, a halving, x - knot, a power


@dataclass(frozen=True, eq=False)
class Table:
    """Row r: the sum of powers[k, r] (x - knots[r])^k, from knots[r] to before knots[r + 1].

    knots (n + 1 and some that no x reaches,): the first twice, as the origin of what is before all of them.
    powers (degree + 1, n + 1). starts (buckets,), of an even grid (0,).
    """

    knots: np.ndarray
    powers: np.ndarray
    starts: np.ndarray
    left: float
    scale: float
    levels: int
    key: int

    @property
    def last(self) -> float:
        """The last knot."""
        return float(self.knots[self.powers.shape[1] - 1])

    def coefficients(self, order: int) -> np.ndarray:
        """(degree + 1 - order, rows) powers of the derivative of this order; (1, rows) zeros beyond the degree."""
        powers = self.powers
        for _ in range(order):
            powers = np.arange(1, len(powers))[:, None] * powers[1:] if len(powers) > 1 else 0 * powers
        return powers

    def __call__(self, x: np.ndarray | complex, order: int = 0) -> np.ndarray:
        """Values at x, or derivatives of this order; x may be complex, its real part chooses the row."""
        row = np.searchsorted(self.knots[1 : self.powers.shape[1]], np.real(x), side="right")
        powers, beyond = self.coefficients(order), x - self.knots[row]
        y = powers[-1][row]
        for power in powers[-2::-1]:
            y = power[row] + beyond * y
        return np.asarray(y)

    def instructions(self, order: int) -> int:
        """Of one evaluation."""
        search = _SEARCH + (self.starts.size > 0) + _LEVEL * self.levels
        return search + _ORIGIN + 1 + _POWER * (len(self.coefficients(order)) - 1)

    def plain(self) -> dict[str, Any]:
        """As data.json has it."""
        return {
            "key": self.key,
            "left": self.left,
            "scale": self.scale,
            "last": self.last,
            "levels": self.levels,
            "starts": self.starts.tolist(),
            "knots": self.knots.tolist(),
            "powers": self.powers.tolist(),
        }

    def shared(self) -> dict[str, Any]:
        """`plain`, as whoever makes Functions of it in this process has it: they are made once."""
        if self.key not in table_function.TABLES:
            table_function.TABLES[self.key] = self.plain()
        found: dict[str, Any] = table_function.TABLES[self.key]
        return found

    def function(self, order: int = 0) -> ca.Function:
        """What stands for it in expressions."""
        self.shared()
        return table_function.table(self.key, order)


_known: dict[int, Table] = {}  # by key, so each is the only one of its numbers


def table_of(points: np.ndarray, powers: np.ndarray) -> Table:
    """Polynomials (degree + 1, n + 1) before, between and behind rising points (n,), of which each begins a row."""
    knots, powers = np.append(points[0], points) + 0.0, np.asarray(powers, dtype=float) + 0.0  # no -0
    key = int.from_bytes(hashlib.sha256(knots.tobytes() + powers.tobytes()).digest()[:6])
    if key not in _known:
        starts, left, scale, levels = _buckets(points)
        knots = np.append(knots, np.full(1 << levels, LARGEST))
        _known[key] = Table(knots, powers, starts, left, scale, levels, key)
    return _known[key]


def table_from(plain: Mapping[str, Any]) -> Table:
    """The table of `Table.plain`, known from now on."""
    knots, powers, starts = (np.array(plain[name], dtype=float) for name in ("knots", "powers", "starts"))
    found = Table(knots, powers, starts, plain["left"], plain["scale"], plain["levels"], plain["key"])
    return _known.setdefault(found.key, found)


def _buckets(points: np.ndarray) -> tuple[np.ndarray, float, float, int]:
    """(starts, left, scale, levels): buckets about each point of an even grid, else as many as points."""
    n, first = len(points), float(points[0])
    with np.errstate(all="ignore"):
        length = (points[-1] - first) / (n - 1)
        for left in (first - length / 2, first):
            scale = float(1 / length) if np.isfinite(1 / length) else 0.0
            placed = np.nan_to_num((points - left) * scale, nan=0.0).astype(int)
            if np.array_equal(placed, np.arange(n)):
                return np.zeros(0), float(left), scale, 1
    counts = np.bincount(placed)
    starts = np.append(0, np.cumsum(counts)[:-1])
    return starts.astype(float), float(left), scale, int(counts.max()).bit_length()


def any_tables() -> bool:
    """Does this process know tables at all?"""
    return bool(_known)


def mark(key: int, order: int) -> float:
    """The value of a node that is a table."""
    return float(ORDERS * key + order)


def marked(value: float) -> tuple[Table, int]:
    """(table, order of the derivative) of a node's value."""
    key, order = divmod(int(value), ORDERS)
    return _known[key], order


def mark_of(function: ca.Function) -> float | None:
    """The value of a node that calls a Function; None if it is not a table."""
    found = NAME.fullmatch(function.name())
    return mark(int(found[1]), int(found[2])) if found and int(found[1]) in _known else None


# Long work on tapes without Python's search for cycles of garbage, which would take a third of the time.


@contextmanager
def no_collection() -> Iterator[None]:
    """No search for cycles meanwhile: the many tuples of tapes are in none, and each search looks at all of them."""
    collecting = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collecting:
            gc.enable()


# An SX Function as straight-line code: one list of nodes in single assignment. Printed as Python or as C.


class Node(NamedTuple):
    """One value: an input entry (op OP_INPUT: a = argument, b = entry), a constant, or op(a[, b]) of nodes.

    A table at a node (op OP_CALL) is the operation of one argument that `marked(value)` says.
    """

    op: int
    a: int
    b: int
    value: float


@dataclass(frozen=True)
class Tape:
    """Nodes in an order in which each uses earlier ones only; outputs[k] lists the node of every entry.

    patterns: of a packed tape the entries of each output that are listed; the others are zero. () where all are.
    """

    input_names: list[str]
    input_sizes: list[int]
    output_names: list[str]
    output_shapes: list[tuple[int, int]]
    nodes: list[Node]
    outputs: list[list[int]]
    patterns: tuple[ca.Sparsity, ...] = ()

    @property
    def operations(self) -> int:
        """How many operations one evaluation takes: arithmetic, without reading inputs and writing outputs.

        A table counts as the instructions that its evaluation takes.
        """
        return sum(node.op not in (ca.OP_INPUT, ca.OP_CONST) for node in self.nodes) + self.inside_tables

    @property
    def inside_tables(self) -> int:
        """What evaluations of tables take beyond one operation each."""
        tables = (marked(node.value) for node in self.nodes if node.op == ca.OP_CALL)
        return sum(table.instructions(order) - 1 for table, order in tables)

    @property
    def instructions(self) -> int:
        """CasADi's count for the Function this tape came from, in which constants, loads and stores are too."""
        return len(self.nodes) + sum(len(entries) for entries in self.outputs)

    def unpacked(self) -> Tape:
        """The same with every entry of the outputs listed."""
        if not self.patterns:
            return self
        nodes = list(self.nodes)
        parts = zip(self.patterns, self.outputs, strict=True)
        outputs = [_dense(pattern, entries, nodes) for pattern, entries in parts]
        return replace(self, nodes=nodes, outputs=outputs, patterns=())


BINARY = frozenset(
    (
        ca.OP_ADD,
        ca.OP_SUB,
        ca.OP_MUL,
        ca.OP_DIV,
        ca.OP_POW,
        ca.OP_CONSTPOW,
        ca.OP_LT,
        ca.OP_LE,
        ca.OP_EQ,
        ca.OP_NE,
        ca.OP_AND,
        ca.OP_OR,
        ca.OP_FMIN,
        ca.OP_FMAX,
        ca.OP_ATAN2,
        ca.OP_FMOD,
        ca.OP_COPYSIGN,
        ca.OP_IF_ELSE_ZERO,
        ca.OP_HYPOT,
    )
)
COMMUTING = (ca.OP_ADD, ca.OP_MUL)
UNUSED = -1


def read_tape(function: ca.Function, packed: bool = False) -> Tape:
    """The tape of an SX Function, structural zeros of its outputs as the number 0, or left out of a packed one.

    Raises ValueError for any other kind of Function.

    CasADi's derivatives of tables are written out as the tables' own.
    """
    if not function.is_a("SXFunction"):
        raise ValueError(f"{function.name()}: only a Function of SX expressions has a tape")
    shapes = [function.size_out(k) for k in range(function.n_out())]
    found = [[UNUSED] * function.nnz_out(k) for k in range(function.n_out())]
    nodes, plain = _read_nodes(function, found)
    patterns = tuple(function.sparsity_out(k) for k in range(function.n_out()))
    tape = Tape(
        function.name_in(),
        [function.nnz_in(k) for k in range(function.n_in())],
        function.name_out(),
        shapes,
        nodes,
        found,
        patterns,
    )
    if packed and plain:
        return tape
    tape = tape.unpacked()
    if plain:
        return tape
    return without_repetitions(read_tape(as_function(function.name(), tape)))  # and without products with 0 and 1


def _dense(pattern: ca.Sparsity, entries: list[int], nodes: list[Node]) -> list[int]:
    """All entries of an output, column by column, from those of its pattern."""
    if pattern.is_dense():
        return entries
    zero = Node(ca.OP_CONST, UNUSED, UNUSED, 0.0)
    if nodes[-1:] != [zero]:
        nodes.append(zero)
    result = [len(nodes) - 1] * pattern.numel()
    for place, entry in zip(pattern.find(), entries, strict=True):
        result[place] = entry
    return result


def _read_nodes(function: ca.Function, outputs: list[list[int]]) -> tuple[list[Node], bool]:
    """(nodes, are all calls tables?); outputs get the nodes of their entries."""
    holder: dict[int, int] = {}  # work register -> node that it holds now
    nodes: list[Node] = []
    operation, inputs, result_of = function.instruction_id, function.instruction_input, function.instruction_output
    called, plain = list[ca.SX](), True
    for k in range(function.n_instructions()):
        op = operation(k)
        if op in BINARY:  # most of them
            a, b = inputs(k)
            node = Node(op, holder[a], holder[b], 0.0)
        elif op == ca.OP_CONST:
            node = Node(op, UNUSED, UNUSED, function.instruction_constant(k))
        elif op == ca.OP_INPUT:
            argument, entry = inputs(k)
            node = Node(op, argument, entry, 0.0)
        elif op == ca.OP_OUTPUT:
            result, entry = result_of(k)
            outputs[result][entry] = holder[inputs(k)[0]]
            continue
        elif op == ca.OP_CALL:
            called = called or ca.vertsplit(function.instructions_sx())
            plain = plain and mark_of(called[k].which_function()) is not None
            found = _called(called[k].which_function(), [holder[one] for one in inputs(k)], nodes)
            holder.update(zip(result_of(k), found, strict=True))
            continue
        else:
            node = Node(op, holder[inputs(k)[0]], UNUSED, 0.0)
        holder[result_of(k)[0]] = len(nodes)
        nodes.append(node)
    return nodes, plain


def _called(function: ca.Function, arguments: Sequence[int], nodes: list[Node]) -> list[int]:
    """The nodes of the entries that a call gives, put behind the others: a table, or CasADi's derivative of one."""
    value = mark_of(function)
    if value is not None:
        nodes.append(Node(ca.OP_CALL, arguments[0], UNUSED, value))
        return [len(nodes) - 1]
    inner = read_tape(_written_out(function))
    number: list[int] = []
    for node in inner.nodes:
        if node.op == ca.OP_INPUT:
            number.append(arguments[node.b])
            continue
        if node.op != ca.OP_CONST:
            node = node._replace(a=number[node.a], b=UNUSED if node.b == UNUSED else number[node.b])
        number.append(len(nodes))
        nodes.append(node)
    return [number[k] for k in inner.outputs[0]]


def _written_out(function: ca.Function) -> ca.Function:
    """A derivative of a table as operations on tables: (entries of all arguments) -> entries of all results."""
    inputs = [ca.SX.sym("x", function.sparsity_in(k)) for k in range(function.n_in())]
    results = [ca.project(one, function.sparsity_out(k)) for k, one in enumerate(function.call(inputs, True, False))]
    given, found = (ca.vertcat(*(ca.vec(one.nz[:]) for one in some if one.nnz())) for some in (inputs, results))
    return ca.Function(function.name(), [given], [ca.densify(found)])


def node_value(node: Node, values: list[ca.SX], entries: list[ca.SX]) -> ca.SX:
    """The SX of a node from those of earlier nodes, and from the entries of its argument if it is an input."""
    if node.op == ca.OP_CONST:
        return ca.SX(node.value)
    if node.op == ca.OP_INPUT:
        return entries[node.b]
    if node.op == ca.OP_CALL:
        table, order = marked(node.value)
        return table.function(order)(values[node.a])
    if node.b == UNUSED:
        return ca.SX.unary(node.op, values[node.a])
    return ca.SX.binary(node.op, values[node.a], values[node.b])


def as_function(name: str, tape: Tape) -> ca.Function:
    """The SX Function of a tape, with CasADi's own simplifications."""
    inputs = [ca.SX.sym(label, size) for label, size in zip(tape.input_names, tape.input_sizes, strict=True)]
    entries = [ca.vertsplit(value) if value.numel() else [] for value in inputs]
    values: list[ca.SX] = []
    for node in tape.nodes:
        values.append(node_value(node, values, entries[node.a] if node.op == ca.OP_INPUT else []))
    zeros = {k for k, node in enumerate(tape.nodes) if node.op == ca.OP_CONST and node.value == 0.0}
    if tape.patterns:
        parts = zip(tape.patterns, tape.outputs, strict=True)
        outputs = [ca.SX(pattern, ca.vertcat(*(values[k] for k in found))) for pattern, found in parts]
    else:
        outputs = [
            ca.densify(_matrix(values, found, shape, zeros))
            for found, shape in zip(tape.outputs, tape.output_shapes, strict=True)
        ]
    return ca.Function(name, inputs, outputs, tape.input_names, tape.output_names)


def _matrix(values: list[ca.SX], found: list[int], shape: tuple[int, int], zeros: set[int]) -> ca.SX:
    """An output, its zeros left out."""
    kept = [place for place, entry in enumerate(found) if entry not in zeros]
    pattern = ca.Sparsity.nonzeros(*shape, kept) if kept else ca.Sparsity(*shape)
    return ca.SX(pattern, ca.vertcat(*(values[found[place]] for place in kept)) if kept else ca.SX(0, 1))


def arithmetic(function: ca.Function) -> int:
    """Operations of a Function: `Tape.operations` of its tape."""
    if function.find_functions():
        return read_tape(function).operations
    moves = (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST, ca.OP_PARAMETER)
    return sum(function.instruction_id(k) not in moves for k in range(function.n_instructions()))


def uses(tape: Tape) -> list[int]:
    """How often each node is used, as an argument or as an output entry."""
    count = [0] * len(tape.nodes)
    for node in tape.nodes:
        if node.op not in (ca.OP_INPUT, ca.OP_CONST):
            count[node.a] += 1
            if node.b != UNUSED:
                count[node.b] += 1
    for entries in tape.outputs:
        for entry in entries:
            count[entry] += 1
    return count


def without_repetitions(tape: Tape) -> Tape:
    """The tape with what stands twice once."""
    nodes: list[Node] = []
    number: list[int] = []
    seen: dict[Node, int] = {}
    for node in tape.nodes:
        if node.op == ca.OP_CONST:  # 0 and -0 are equal, but not the same
            number.append(len(nodes))
            nodes.append(node)
            continue
        if node.op != ca.OP_INPUT:
            a, b = number[node.a], UNUSED if node.b == UNUSED else number[node.b]
            node = Node(node.op, b, a, 0.0) if node.op in COMMUTING and b < a else Node(node.op, a, b, node.value)
        k = seen.setdefault(node, len(nodes))
        if k == len(nodes):
            nodes.append(node)
        number.append(k)
    return replace(tape, nodes=nodes, outputs=[[number[k] for k in entries] for entries in tape.outputs])


def shared(expressions: Sequence[ca.SX]) -> list[ca.SX]:
    """Expressions with what stands twice once. CasADi does that too, but writes out tables to compare them."""
    if not any_tables():
        return list(ca.cse(list(expressions)))
    whole = ca.vertcat(ca.SX(0, 1), *(ca.vec(one.nz[:]) for one in expressions if one.nnz()))
    symbols = ca.vertcat(ca.SX(0, 1), *ca.symvar(whole))
    function = ca.Function("shared", [symbols], [ca.densify(whole)])
    if not function.find_functions():
        return list(ca.cse(list(expressions)))
    tape = without_repetitions(read_tape(function))
    values, entries = list[ca.SX](), ca.vertsplit(symbols)
    for node in tape.nodes:
        values.append(node_value(node, values, entries))
    found = iter(values[k] for k in tape.outputs[0])
    return [ca.SX(one.sparsity(), ca.vertcat(*(next(found) for _ in range(one.nnz())))) for one in expressions]


def code_length(function: ca.Function) -> int:
    """Instructions of an SX Function as CasADi counts them, a table by what its evaluation takes."""
    inside = read_tape(function).inside_tables if function.find_functions() else 0
    return int(function.n_instructions()) + inside


# Binding time: tapes split into what can be computed once and what is left (partial evaluation).
#
# A value is known as soon as everything that it follows from is known. `split` is used for this three times:
#
#     known               computed             by
#     parameters p        once a run           symgen/tapes/hoisting.py: constants(p) -> c
#     c and steps h       once a run           runtime/engine/prepare.py: c -> [c, more]
#     z that is held      once a repetition    runtime/engine/prepare.py: a stage before the repetition


class Time(IntEnum):
    """When a value becomes known, in order. A number is known at RUN."""

    RUN = 0
    REPETITION = 1
    STEP = 2


class Place(NamedTuple):
    """Where what is left reads held values: entry first, first + 1, ... of an input, a new one if there is none."""

    name: str
    first: int


InputTime = Callable[[str, int], Time]  # of entry k of the input of that name


def binding_times(tape: Tape, of_input: InputTime) -> list[Time]:
    """The time of every node: the latest of its arguments'."""
    times: list[Time] = []
    for node in tape.nodes:
        if node.op == ca.OP_CONST:
            times.append(Time.RUN)
        elif node.op == ca.OP_INPUT:
            times.append(of_input(tape.input_names[node.a], node.b))
        elif node.b == UNUSED:
            times.append(times[node.a])
        else:
            times.append(max(times[node.a], times[node.b]))
    return times


def split(
    tapes: Mapping[str, Tape],
    inputs: Mapping[str, int],
    of_input: InputTime,
    at: Time,
    place: Place,
    hold_inputs: bool = False,
) -> tuple[Tape, dict[str, Tape]]:
    """(the values of the tapes that become known just at a time, each once; the tapes that read them from `place`).

    Held are the largest such values: those that something later reads. The first tape has `inputs` (name: size) and
    one output "held"; hold_inputs: plain entries of known inputs are held too, so that what is left does not read these
    inputs at all.
    """
    once = _Once(list(inputs))
    entries: dict[str, dict[int, int]] = {}  # of each tape {held node: its entry}
    for name, tape in tapes.items():
        times = binding_times(tape, of_input)
        later = _read_later(tape, times, at)
        kept = (ca.OP_CONST,) if hold_inputs else (ca.OP_CONST, ca.OP_INPUT)
        held = [k for k, node in enumerate(tape.nodes) if times[k] == at and k in later and node.op not in kept]
        entries[name] = once.take(tape, held)
    shape = (len(once.held), 1)
    values = Tape(list(inputs), list(inputs.values()), ["held"], [shape], once.nodes, [once.held])
    return values, {name: _rest(tape, entries[name], place, shape[0]) for name, tape in tapes.items()}


def _read_later(tape: Tape, times: list[Time], at: Time) -> set[int]:
    """Nodes that are outputs or arguments of a node that becomes known after that time."""
    read = {k for entries in tape.outputs for k in entries}
    for node, time in zip(tape.nodes, times, strict=True):
        if time > at and node.op != ca.OP_INPUT:
            read |= {node.a, node.b}
    return read


def below(nodes: list[Node], roots: Collection[int], stop: Callable[[int], bool] = lambda k: False) -> list[int]:
    """Nodes that the roots need, themselves included, in ascending order; not below nodes that `stop`."""
    needed = bytearray(max(roots, default=-1) + 1)
    for k in roots:
        needed[k] = True
    for k in range(len(needed) - 1, -1, -1):  # arguments stand before what uses them
        if not needed[k]:
            continue
        op, a, b, _ = nodes[k]
        if op not in (ca.OP_INPUT, ca.OP_CONST) and not stop(k):
            needed[a] = True
            if b != UNUSED:
                needed[b] = True
    return [k for k, wanted in enumerate(needed) if wanted]


def renumbered(node: Node, number: Mapping[int, int], argument: Mapping[int, int]) -> Node:
    """The node with other numbers of its arguments: of nodes by `number`, of inputs by `argument`."""
    if node.op == ca.OP_CONST:
        return node
    if node.op == ca.OP_INPUT:
        return Node(node.op, argument[node.a], node.b, 0.0)
    return Node(node.op, number[node.a], UNUSED if node.b == UNUSED else number[node.b], node.value)


class _Once:
    """Nodes of several tapes, equal ones once; held: those that what is left reads, by entry."""

    def __init__(self, inputs: list[str]) -> None:
        self.nodes: list[Node] = []
        self.held: list[int] = []
        self._inputs = {name: k for k, name in enumerate(inputs)}
        self._number: dict[Node, int] = {}
        self._entry: dict[int, int] = {}

    def take(self, tape: Tape, held: list[int]) -> dict[int, int]:
        """{node of the tape: its entry} for nodes to be held."""
        number: dict[int, int] = {}
        argument = {k: self._inputs[name] for k, name in enumerate(tape.input_names) if name in self._inputs}
        for k in below(tape.nodes, held):
            number[k] = self._place(renumbered(tape.nodes[k], number, argument))
        return {k: self._hold(number[k]) for k in held}

    def _place(self, node: Node) -> int:
        if node not in self._number:
            self._number[node] = len(self.nodes)
            self.nodes.append(node)
        return self._number[node]

    def _hold(self, number: int) -> int:
        if number not in self._entry:
            self._entry[number] = len(self.held)
            self.held.append(number)
        return self._entry[number]


def _rest(tape: Tape, held: Mapping[int, int], place: Place, count: int) -> Tape:
    """The tape with held nodes read from their entries."""
    names, sizes = list(tape.input_names), list(tape.input_sizes)
    if place.name not in names:
        names, sizes = [*names, place.name], [*sizes, 0]
    argument = names.index(place.name)
    sizes[argument] = place.first + count
    live = below(tape.nodes, {k for entries in tape.outputs for k in entries}, held.__contains__)
    number = {node: k for k, node in enumerate(live)}
    same = {k: k for k in range(len(names))}
    nodes = [
        Node(ca.OP_INPUT, argument, place.first + held[k], 0.0)
        if k in held
        else renumbered(tape.nodes[k], number, same)
        for k in live
    ]
    outputs = [[number[k] for k in entries] for entries in tape.outputs]
    return Tape(names, sizes, tape.output_names, tape.output_shapes, nodes, outputs)
