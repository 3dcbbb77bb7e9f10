"""model.py: every kernel as a function that builds its CasADi Function. Imports casadi only.

A tape as readable Python statements: values used once are written in place, the rest get a name.

How an output is written: sparse ones by entry, matrices by rows, lists of points by points, vectors by entry.

Names in the emitted text: of the entries of every argument, and of the rows and columns of every output.
"""

from __future__ import annotations

import inspect
import json
import keyword
import re
import textwrap
from collections.abc import Iterable, Mapping, Sequence

import casadi as ca

from runtime.contract import table_function
from runtime.contract.escapes import python_docstring, shown
from runtime.contract.records import FunctionSpec, Signal
from runtime.contract.tape import UNUSED, Node, Tape, marked, uses
from symgen.notation.symbols import BY_NAME
from symgen.pipeline import Derived

LONGEST_INLINE = 96
_ATOM, _POWER, _UNARY, _PRODUCT, _SUM, _COMPARE = 6, 5, 4, 3, 2, 1

_INFIX = {
    ca.OP_ADD: ("+", _SUM),
    ca.OP_SUB: ("-", _SUM),
    ca.OP_MUL: ("*", _PRODUCT),
    ca.OP_DIV: ("/", _PRODUCT),
    ca.OP_LT: ("<", _COMPARE),
    ca.OP_LE: ("<=", _COMPARE),
    ca.OP_EQ: ("==", _COMPARE),
    ca.OP_NE: ("!=", _COMPARE),
}
_CALL = {
    ca.OP_SQRT: "sqrt",
    ca.OP_EXP: "exp",
    ca.OP_LOG: "log",
    ca.OP_SIN: "sin",
    ca.OP_COS: "cos",
    ca.OP_TAN: "tan",
    ca.OP_ASIN: "asin",
    ca.OP_ACOS: "acos",
    ca.OP_ATAN: "atan",
    ca.OP_SINH: "sinh",
    ca.OP_COSH: "cosh",
    ca.OP_TANH: "tanh",
    ca.OP_FABS: "fabs",
    ca.OP_SIGN: "sign",
    ca.OP_FLOOR: "floor",
    ca.OP_CEIL: "ceil",
    ca.OP_NOT: "logic_not",
    ca.OP_ATAN2: "atan2",
    ca.OP_FMIN: "fmin",
    ca.OP_FMAX: "fmax",
    ca.OP_AND: "logic_and",
    ca.OP_OR: "logic_or",
    ca.OP_FMOD: "fmod",
    ca.OP_COPYSIGN: "copysign",
    ca.OP_HYPOT: "hypot",
}


class TapeText:
    """Statements of one tape and the text of each output entry.

    labels maps an input name to the local names of its entries, tables the key of a table to its name.
    """

    def __init__(self, tape: Tape, labels: Mapping[str, list[str]], tables: Mapping[int, str]) -> None:
        self.tape = tape
        self._labels, self._tables = labels, tables
        self._uses = uses(tape)
        self._text: list[tuple[str, int]] = []
        self.statements: list[str] = []
        self.inputs_used: dict[str, set[int]] = {name: set() for name in tape.input_names}
        self._temporaries = 0
        for k, node in enumerate(tape.nodes):
            text, level = self._render(node)
            if self._needs_name(k, node, text):
                name = f"w{self._temporaries}"
                self._temporaries += 1
                self.statements.append(f"{name} = {text}")
                text, level = name, _ATOM
            self._text.append((text, level))

    def output(self, position: int) -> list[str]:
        """Texts of the entries of an output, column by column."""
        return [self._text[entry][0] for entry in self.tape.outputs[position]]

    def _needs_name(self, k: int, node: Node, text: str) -> bool:
        if node.op in (ca.OP_INPUT, ca.OP_CONST):
            return False
        return self._uses[k] > 1 or len(text) > LONGEST_INLINE

    def _child(self, k: int, level: int) -> str:
        text, own = self._text[k]
        return f"({text})" if own < level else text

    def _render(self, node: Node) -> tuple[str, int]:
        if node.op == ca.OP_CONST:
            return repr(node.value), _ATOM if node.value >= 0 else _UNARY
        if node.op == ca.OP_INPUT:
            name = self.tape.input_names[node.a]
            self.inputs_used[name].add(node.b)
            return self._labels[name][node.b], _ATOM
        if node.op in _INFIX:
            sign, level = _INFIX[node.op]
            # the right operand is bracketed at equal level, so that the order of evaluation is kept bit for bit
            return f"{self._child(node.a, level)} {sign} {self._child(node.b, level + 1)}", level
        if node.op == ca.OP_NEG:
            return f"-{self._child(node.a, _POWER)}", _UNARY
        if node.op == ca.OP_SQ:
            return f"{self._child(node.a, _ATOM)}**2", _POWER
        if node.op == ca.OP_TWICE:
            return f"2 * {self._child(node.a, _UNARY)}", _PRODUCT
        if node.op == ca.OP_INV:
            return f"1 / {self._child(node.a, _UNARY)}", _PRODUCT
        if node.op in (ca.OP_POW, ca.OP_CONSTPOW):
            return f"{self._child(node.a, _ATOM)}**{self._child(node.b, _ATOM)}", _POWER
        if node.op == ca.OP_IF_ELSE_ZERO:
            return f"ca.if_else({self._text[node.a][0]}, {self._text[node.b][0]}, 0)", _ATOM
        if node.op == ca.OP_CALL:
            table, order = marked(node.value)
            which = json.dumps(self._tables[table.key]) + (f", {order}" if order else "")
            return f"table({which})({self._text[node.a][0]})", _ATOM
        if node.op == ca.OP_ASSIGN:
            return self._text[node.a]
        arguments = [node.a] if node.b == UNUSED else [node.a, node.b]
        return f"ca.{_CALL[node.op]}({', '.join(self._text[a][0] for a in arguments)})", _ATOM


WIDTH = 116
ZEROS = ("0.0", "-0.0")
SPARSE = 1 / 3  # share of zeros from which entries are written one by one
SMALL = 3  # entries: a vector this short is written in one go
TALL = 12  # rows: a matrix no taller is written by columns where it has more of them


def output_lines(name: str, size: Sequence[int], entries: Sequence[str], names: Sequence[Sequence[str]]) -> list[str]:
    """Statements that make the output: entries column by column, names along rows and columns ([] for none)."""
    rows, columns = size
    zeros = sum(entry in ZEROS for entry in entries)
    if zeros == len(entries):
        return [f"{name} = ca.SX({rows}, {columns})"]
    if len(entries) > SMALL and zeros > SPARSE * len(entries):
        return _by_entry(name, rows, columns, entries, names)
    if columns == 1:
        return _vector(name, entries, names[0])
    if rows == 1:
        return [f"{name} = ca.horzcat(", *(f"    {line}" for line in _filled(entries)), ")"]
    along = (
        (columns, [entries[k * rows : (k + 1) * rows] for k in range(columns)], names[1], "horzcat", "vertcat")
        if rows <= TALL < columns or (names[1] and not names[0])
        else (rows, [entries[k::rows] for k in range(rows)], names[0], "vertcat", "horzcat")
    )
    count, parts, labels, outer, inner = along
    lines = [f"{name} = ca.{outer}("]
    for k in range(count):
        lines += _part(inner, parts[k], labels[k] if labels else "")
    return [*lines, ")"]


def _by_entry(name: str, rows: int, columns: int, entries: Sequence[str], names: Sequence[Sequence[str]]) -> list[str]:
    """Only what is not zero, row by row under the row's name."""
    lines = [f"{name} = ca.SX({rows}, {columns})"]
    for row in range(rows):
        found = [(column, entries[column * rows + row]) for column in range(columns)]
        found = [(column, entry) for column, entry in found if entry not in ZEROS]
        label = names[0][row] if names[0] else ""
        if columns == 1:
            lines += [_noted(f"{name}[{row}] = {entry}", label) for _, entry in found]
            continue
        lines += [f"# {shown(label)}"] if label and found else []
        lines += [f"{name}[{row}, {column}] = {entry}" for column, entry in found]
    return lines


def _vector(name: str, entries: Sequence[str], labels: Sequence[str]) -> list[str]:
    whole = f"{name} = ca.vertcat({', '.join(entries)})"
    if len(entries) <= SMALL and len(whole) <= WIDTH:
        return [whole]
    if labels:
        noted = (_noted(f"    {entry},", label) for entry, label in zip(entries, labels, strict=True))
        return [f"{name} = ca.vertcat(", *noted, ")"]
    return [f"{name} = ca.vertcat(", *(f"    {line}" for line in _filled(entries)), ")"]


def _part(function: str, entries: Sequence[str], label: str) -> list[str]:
    """A row or column of a matrix, on one line if it fits."""
    whole = _noted(f"    ca.{function}({', '.join(entries)}),", label)
    if len(whole) <= WIDTH:
        return [whole]
    return [_noted(f"    ca.{function}(", label), *(f"        {line}" for line in _filled(entries)), "    ),"]


def _filled(entries: Sequence[str]) -> list[str]:
    """Entries with commas, as many on a line as fit."""
    lines: list[str] = []
    for entry in entries:
        if lines and len(lines[-1]) + len(entry) + 2 <= WIDTH - 12:
            lines[-1] += f" {entry},"
        else:
            lines.append(f"{entry},")
    return lines


def _noted(text: str, label: str) -> str:
    return f"{text}  # {shown(label)}" if label else text


# what the emitted functions call their own: temporaries, arguments, outputs
RESERVED = re.compile(
    r"^(w\d+|c\d*|p\d*|t|ca|table|lam_R\d*|crossing\d*|interface\d*|shift\d*|push\d*|q\w*|M\w*|C\w*|Q\w*|inputs|outputs)$"
)


def local_names(names: Iterable[str], taken: Iterable[str] = ()) -> list[str]:
    """Distinct Python identifiers for names, clear of those taken and of what the emitted functions use themselves."""
    used = set(taken)
    chosen: list[str] = []
    for name in names:
        text = re.sub(r"\W+", "_", name).strip("_")
        if RESERVED.match(text) or text in BY_NAME or keyword.iskeyword(text) or text[:1].isdigit():
            text = f"x_{text}"
        while text in used:
            text += "_"
        chosen.append(text)
        used.add(text)
    return chosen


class Labels:
    """Names of a model's entries: `arguments` by input name, `tables` by key, rows of outputs by symbol of size."""

    def __init__(self, derived: Derived) -> None:
        eq, choice = derived.system.equations, derived.system.choice
        reduced = derived.system.reduced
        names = local_names(reduced.names)
        self.plain = names[: len(eq.names)]
        q_i, q_d = [names[c] for c in choice.independent], [names[c] for c in derived.dependent]
        slow = [k for group in derived.groups[:-1] for k in group.positions]
        self.arguments = {"q": self.plain, "q_i": q_i, "q_d": q_d, "t": ["t"]}
        for source in ("q", "q_i", "q_d"):
            self.arguments[f"{source}_dot"] = [f"{name}_dot" for name in self.arguments[source]]
            self.arguments[f"{source}_ddot"] = [f"{name}_ddot" for name in self.arguments[source]]
        omega = {f"{name}_dot": name.replace("turn_", "omega_") for name in names[len(eq.names) :]}
        for rates in ("q_i_dot", "q_d_dot"):
            self.arguments[rates] = [omega.get(name, name) for name in self.arguments[rates]]
        charts = [f"{rotation.body}.chart_{k}" for rotation in reduced.rotation_vectors for k in range(4)]
        self.arguments["chart"] = local_names(charts, names)
        self.arguments["lam_R"] = [f"lam_R{k}" for k in range(len(derived.redundant))]
        self.arguments["q_L_ddot"] = [f"{q_i[k]}_ddot" for k in slow]
        if "shifted_solution" in derived.tapes:
            sizes = {signal.name: signal.size[0] for signal in derived.functions["shifted_solution"].inputs}
            self.arguments |= {name: [f"{name}{k}" for k in range(sizes[name])] for name in ("shift", "push")}
        moving = [f"{name}{end}" for name in names for end in ("", "_dot", "_ddot")]
        moving += [*omega.values(), *self.arguments["chart"]]
        self.arguments["p"] = local_names((entry.name for entry in derived.parameters), moving)
        self.tables = {table.key: name for name, table in derived.scene.curves().items()}
        self.arguments["u"] = local_names(eq.u, [*moving, *self.arguments["p"]])
        taken = [*moving, *self.arguments["p"], *self.arguments["u"]]
        self.arguments["side"] = local_names((f"side_of_{name}" for name in eq.sides), taken)
        self.arguments["c"] = self._constants(derived.tapes["constants"])
        independent = [reduced.names[c] for c in choice.independent]
        self.rows: dict[str, list[str]] = {
            "n": eq.names,
            "n_i": independent,
            "n_d": [reduced.names[c] for c in derived.dependent],
            "n_c": [row.label for row in eq.constraints],
            "n_const": self.arguments["c"],
            "loops": [eq.constraints[row].label for row in choice.loop_rows],
            "joints": eq.joints,
            "measures": list(eq.measures),
            "acceleration measures": list(eq.accelerated),
            "events": [*eq.events, *eq.kinks],
            "conditions in t": [item for item, _ in eq.switching],
        }
        self.rows |= {f"n_{group.name}": [independent[k] for k in group.positions] for group in derived.groups}

    def _constants(self, tape: Tape) -> list[str]:
        """An entry of c that is a parameter keeps its name, the others are counted."""
        found = []
        for k, entry in enumerate(tape.outputs[0]):
            node = tape.nodes[entry]
            found.append(self.arguments["p"][node.b] if node.op == ca.OP_INPUT else f"c{k}")
        return found

    def along(self, shape: str, size: Sequence[int]) -> list[list[str]]:
        """Names along each side of an output of this shape; [] for a side whose entries have none."""
        found = [self.rows.get(symbol, []) for symbol in shape.split(" x ")]
        found += [[]] * (2 - len(found))
        return [names if len(names) == count else [] for names, count in zip(found, size, strict=True)]


def model_text(derived: Derived) -> str:
    """Text of model.py."""
    labels = Labels(derived)
    parts = [_header(derived), *([_tables_text()] if derived.scene.tables else [])]
    parts += [_function_text(derived.functions[name], tape, labels) for name, tape in derived.tapes.items()]
    listing = "\n".join(f'    "{name}": {name},' for name in derived.tapes)
    parts.append(f"FUNCTIONS = {{\n{listing}\n}}\n")
    return "\n\n".join(parts)


def _header(derived: Derived) -> str:
    scene, eq = derived.scene, derived.system.reduced
    lines = [
        f"{scene.title or scene.name}: equations of motion, emitted by symgen from the scene `{scene.name}`.",
        "",
        "Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.",
    ]
    kinds = (("q_i", "independent", derived.system.choice.independent), ("q_d", "dependent", derived.dependent))
    for name, what, columns in kinds:
        if columns:
            entries = (f"{k} {eq.names[c]} [{eq.coordinates[c].unit}]" for k, c in enumerate(columns))
            lines += ["", f"{name}, the {what} coordinates by index:", *_wrapped(entries)]
    return "\n".join([python_docstring([*lines, ""]), "", "import casadi as ca", ""])


def _tables_text() -> str:
    """How tables are read: the text of table_function.py behind its imports."""
    return inspect.getsource(table_function).partition("import casadi as ca\n")[2].strip() + "\n"


def _wrapped(entries: Iterable[str]) -> list[str]:
    joined = ", ".join(entry.replace(" ", "\x00") for entry in entries)
    return [
        line.replace("\x00", " ")
        for line in textwrap.wrap(joined, 108, initial_indent="    ", subsequent_indent="    ")
    ]


def _docstring(spec: FunctionSpec) -> list[str]:
    equation = f" (Eq. {spec.equation})" if spec.equation.isdigit() else f" (Eqs. {spec.equation})"
    lines = [f"{spec.meaning}{equation if spec.equation else ''}.", ""]
    lines += [f"takes {_signal(signal)}" for signal in spec.inputs]
    lines += [f"gives {_signal(signal)}" for signal in spec.outputs]
    return python_docstring([*lines, f"{spec.operations} operations.", ""]).split("\n")


def _signal(signal: Signal) -> str:
    """Name, shape in symbols and numbers, unit, meaning."""
    rows, columns = signal.size
    size = str(rows) if columns == 1 else f"{rows} x {columns}"
    shape = size if size == signal.shape else f"{signal.shape} = {size}"
    return f"{signal.name} ({shape}) [{signal.unit}]: {signal.meaning}"


def _function_text(spec: FunctionSpec, tape: Tape, labels: Labels) -> str:
    text = TapeText(tape, labels.arguments, labels.tables)
    body = _docstring(spec)
    for argument, size in zip(tape.input_names, tape.input_sizes, strict=True):
        body.append(f'{argument} = ca.SX.sym("{argument}", {size})')
    for argument in tape.input_names:
        body += _unpack(argument, sorted(text.inputs_used[argument]), labels.arguments[argument])
    body += _outlined(f"intermediate terms ({len(text.statements)})", text.statements)
    outputs: list[str] = []
    for position, signal in enumerate(spec.outputs):
        names = labels.along(signal.shape, signal.size)
        outputs += output_lines(signal.name, signal.size, text.output(position), names)
    body += _outlined("outputs", outputs)
    quoted = f"{_quoted(tape.input_names)}, {_quoted(tape.output_names)}"
    body += [
        f"inputs, outputs = [{', '.join(tape.input_names)}], [{_densified(tape.output_names)}]",
        f'return ca.Function("{spec.name}", inputs, outputs, {quoted})',
    ]
    return "\n".join([f"def {spec.name}() -> ca.Function:", *(f"    {line}" if line else "" for line in body)]) + "\n"


def _densified(names: Sequence[str]) -> str:
    return ", ".join(f"ca.densify({name})" for name in names)


def _quoted(names: Sequence[str]) -> str:
    return "[" + ", ".join(f'"{name}"' for name in names) + "]"


def _outlined(heading: str, lines: Sequence[str]) -> list[str]:
    return [f"# {heading}", *lines] if lines else []


def _unpack(argument: str, entries: list[int], labels: list[str]) -> list[str]:
    if argument == "t":
        return []
    return [f"{labels[entry]} = {argument}[{entry}]" for entry in entries]
