"""How many public functions that take or give arrays say their shapes: a count that may only rise."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ARRAY = re.compile(r"\bndarray\b|\bNDArray\b|\bArray\b")
# (n,), (N, n_i), (2 n, 2 n), (n_i), nf x nf, or a word about the shape
SIZE = r"\w+(?: \w+)?(?: ?[-+*/] ?\w+)?"
SHAPE = re.compile(rf"\({SIZE},(?: ?{SIZE}(?:, ?{SIZE})*,?)?\)|\([nN]\w*\)|\b\w+ x \w+\b|\bshape\b")
FLOOR = 0.58  # share that is reached; raise it with the share


def functions() -> Iterator[tuple[str, ast.FunctionDef]]:
    """Public functions, and public methods of public classes, of both packages."""
    for path in (path for package in ("symgen", "runtime") for path in sorted((ROOT / package).rglob("*.py"))):
        body = ast.parse(path.read_text(encoding="utf-8")).body
        classes = [node for node in body if isinstance(node, ast.ClassDef) and not node.name.startswith("_")]
        for node in [*body, *(method for one in classes for method in one.body)]:
            if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
                yield str(path.relative_to(ROOT)), node


def handles_arrays(function: ast.FunctionDef) -> bool:
    arguments = function.args
    notes = [one.annotation for one in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs)]
    return any(note is not None and ARRAY.search(ast.unparse(note)) for note in [*notes, function.returns])


def test_public_array_functions_name_shapes() -> None:
    found = [(path, function) for path, function in functions() if handles_arrays(function)]
    without = [
        f"{path}:{function.lineno} {function.name}"
        for path, function in found
        if not SHAPE.search(ast.get_docstring(function) or "")
    ]
    share = 1 - len(without) / len(found)
    assert len(found) > 100
    assert share >= FLOOR, f"{share:.3f} of {len(found)}: " + ", ".join(without)


def test_what_counts_as_a_shape() -> None:
    for text in ("M (n, n)", "c (c_size,)", "(2 n_i, 2 n_i)", "the rates v (n_i)", "nf x nf", "(N, n_c - n_R)"):
        assert SHAPE.search(text), text
    for text in ("(Eqs. 68-71)", "the times", "[m]", "(largest radius of all)", "f(t)"):
        assert not SHAPE.search(text), text
