"""Where a fault can be put into a file, and what it looks like: one small change of one expression."""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

COMPARISONS: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.GtE,
    ast.LtE: ast.Gt,
    ast.Gt: ast.LtE,
    ast.GtE: ast.Lt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
}
ARITHMETIC: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.Pow: ast.Mult,
}
ROOT = Path(__file__).resolve().parents[2]
THRESHOLD = 1e3  # numbers that are not whole become this much larger: a loosened tolerance


@dataclass(frozen=True)
class Site:
    """A change of one line: `text` takes the place of columns first:last (UTF-8 bytes) of the line.

    first_line to last_line: the function that it is in, or the whole file.
    """

    path: Path
    line: int
    first: int
    last: int
    text: str
    first_line: int
    last_line: int

    def applied(self, source: str) -> str:
        """The file with the fault in it."""
        lines = source.encode("utf-8").splitlines(keepends=True)
        old = lines[self.line - 1]
        lines[self.line - 1] = old[: self.first] + self.text.encode("utf-8") + old[self.last :]
        return b"".join(lines).decode("utf-8")

    def shown(self, source: str) -> str:
        """`old -> new`."""
        old = source.encode("utf-8").splitlines()[self.line - 1][self.first : self.last].decode("utf-8")
        return f"{old} -> {self.text}"


def sites(path: Path) -> list[Site]:
    """All sites of a file: of its functions and of the constants of the module, not of annotations and messages."""
    source = path.read_text(encoding="utf-8")
    tree = ast.parse(source)
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    whole, found = (1, len(source.splitlines())), []
    for node in _executed(tree):
        for changed in _changes(node):
            if isinstance(node, ast.expr) and node.lineno == node.end_lineno and node.end_col_offset is not None:
                text = ast.unparse(changed)
                text = f"({text})" if isinstance(changed, ast.BinOp | ast.BoolOp | ast.Compare) else text
                around = [(f.lineno, f.end_lineno or f.lineno) for f in functions]
                around = [(a, b) for a, b in around if a <= node.lineno <= b]
                inside = min(around, key=lambda ends: ends[1] - ends[0], default=whole)
                found.append(Site(path, node.lineno, node.col_offset, node.end_col_offset, text, *inside))
    return found


def _executed(node: ast.AST) -> Iterator[ast.AST]:
    """Nodes that do something when the program runs."""
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "returns", "decorator_list", "type_params") or isinstance(node, ast.Raise):
            continue
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST) and not isinstance(child, ast.JoinedStr | ast.Import | ast.ImportFrom):
                yield child
                yield from _executed(child)


def _changes(node: ast.AST) -> Iterator[ast.expr]:
    """Faulty forms of an expression."""
    if isinstance(node, ast.Compare) and type(node.ops[0]) in COMPARISONS:
        changed = copy.deepcopy(node)
        changed.ops[0] = COMPARISONS[type(node.ops[0])]()
        yield changed
    elif isinstance(node, ast.BoolOp):
        yield ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)
    elif isinstance(node, ast.BinOp) and type(node.op) in ARITHMETIC:
        yield ast.BinOp(node.left, ARITHMETIC[type(node.op)](), node.right)
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.Not):
        yield node.operand
    elif isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield ast.Constant(not node.value)
    elif isinstance(node, ast.Constant) and isinstance(node.value, int):
        yield ast.Constant(node.value + 1)
    elif isinstance(node, ast.Constant) and isinstance(node.value, float):
        yield ast.Constant(node.value * THRESHOLD if node.value else 1.0)
    elif (
        isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("neg", "sub", "add", "mul")
    ):
        if node.func.id == "neg":
            yield node.args[0]
        elif len(node.args) == 2:
            yield ast.Call(ast.Name("sub" if node.func.id == "add" else "add"), node.args, [])
