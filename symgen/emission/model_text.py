"""model.py: every kernel as a function that builds its CasADi Function. Imports casadi only."""

from __future__ import annotations

import inspect
import textwrap
from collections.abc import Iterable, Sequence

from runtime.contract import table_function
from runtime.contract.records import FunctionSpec, Signal
from runtime.contract.tape import Tape
from symgen.emission.expression_text import TapeText
from symgen.emission.labels import Labels
from symgen.emission.layout import output_lines
from symgen.pipeline import Derived


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
        f'"""{scene.title or scene.name}: equations of motion, emitted by symgen from the scene `{scene.name}`.',
        "",
        "Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.",
    ]
    kinds = (("q_i", "independent", derived.system.choice.independent), ("q_d", "dependent", derived.dependent))
    for name, what, columns in kinds:
        if columns:
            entries = (f"{k} {eq.names[c]} [{eq.coordinates[c].unit}]" for k, c in enumerate(columns))
            lines += ["", f"{name}, the {what} coordinates by index:", *_wrapped(entries)]
    return "\n".join([*lines, '"""', "", "import casadi as ca", ""])


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
    lines = [f'"""{spec.meaning}{equation if spec.equation else ""}.', ""]
    lines += [f"takes {_signal(signal)}" for signal in spec.inputs]
    lines += [f"gives {_signal(signal)}" for signal in spec.outputs]
    return [*lines, f"{spec.operations} operations.", '"""']


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
