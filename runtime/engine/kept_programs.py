"""Prepared programs kept on disk, beside their machine code: a fresh process that steps a kept model derives nothing.

Stages are CasADi's own text of a Function, which keeps every operation in its order, so the bits are those of a program
that was derived. What is read was verified by the cache; what cannot be read is derived again without a word.
"""

from __future__ import annotations

import hashlib
import json
import zlib
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import casadi as ca

from runtime.contract.files import stamp_of
from runtime.contract.model import EmittedModel
from runtime.engine.object_cache import ObjectCache
from runtime.engine.prepare import Prepared
from runtime.engine.program import Call, Program, Repeat, Sequence, Until

MAX_KEPT_OPERATIONS = 1_000_000  # of the stages: reading takes a tenth of the time of preparing, and 4 bytes each
PACKAGES = ("contract", "engine", "schemes", "running")  # whose code programs and looks follow from


@cache
def _code() -> str:
    """What the code is that programs follow from."""
    folder = Path(__file__).resolve().parents[1]
    return f"{stamp_of(*(folder / name for name in PACKAGES))} {ca.CasadiMeta.version()}"


def key_of(model: EmittedModel, *facts: str) -> str:
    """The key of what follows from a model, these facts and the code as it is; "" where nothing is kept of the model.

    Kept is what follows from a folder, whose text is what its digest says.
    """
    kept = bool(model.folder) and not model.sources
    return hashlib.sha256(repr((_code(), (model.digest, *facts))).encode()).hexdigest() if kept else ""


def are_short(functions: list[ca.Function]) -> bool:
    """Are they worth keeping? Tables are not: their numbers would be read with each of their calls."""
    return sum(one.n_instructions() for one in functions) <= MAX_KEPT_OPERATIONS and not any(
        one.find_functions() for one in functions
    )


def kept_function(key: str, build: Callable[[], ca.Function]) -> ca.Function:
    """The Function of a key, built where none can be read; one of no key is not kept."""
    found = ObjectCache().read(key) if key else None
    if found is not None:
        with suppress(zlib.error, ValueError, RuntimeError):
            return ca.Function.deserialize(zlib.decompress(found[0]).decode())
    made = build()
    if key and made.is_a("SXFunction") and are_short([made]):
        ObjectCache().write(key, zlib.compress(made.serialize().encode(), 1), 0)
    return made


def write_prepared(key: str, prepared: Prepared) -> None:
    """Keep a program; where that is not possible, nothing is kept."""
    stages = {stage.name(): stage.serialize() for stage in prepared.program.stages()}
    content = {
        "order": _written(prepared.program),
        "stages": stages,
        "z_size": prepared.z_size,
        "constants": prepared.constants.serialize(),
    }
    ObjectCache().write(key, zlib.compress(json.dumps(content).encode(), 1), 0)


def read_prepared(key: str) -> Prepared | None:
    """The program of a key, None if there is none that can be read."""
    found = ObjectCache().read(key)
    if found is None:
        return None
    try:
        content = json.loads(zlib.decompress(found[0]))
        stages = {name: ca.Function.deserialize(text) for name, text in content["stages"].items()}
        constants = ca.Function.deserialize(content["constants"])
        return Prepared(_read(content["order"], stages), int(content["z_size"]), constants)
    except (zlib.error, ValueError, KeyError, TypeError, RuntimeError):
        return None


def _written(program: Program) -> Any:
    """The order of the stages: a name, a list of parts, or what is said of a repetition with its body."""

    def again(body: Any, node: Repeat | Until) -> Any:
        if isinstance(node, Repeat):
            return {"body": body, "count": node.count}
        return {"body": body, "flag": node.flag, "limit": node.limit, "usual": node.usual}

    return program.fold(lambda stage: stage.name(), list, again)


def _read(order: Any, stages: dict[str, ca.Function]) -> Program:
    if isinstance(order, str):
        return Call(stages[order])
    if isinstance(order, list):
        return Sequence(tuple(_read(part, stages) for part in order))
    body = _read(order["body"], stages)
    if "count" in order:
        return Repeat(body, order["count"])
    return Until(body, order["flag"], order["limit"], order["usual"])
