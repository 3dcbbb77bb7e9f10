"""Which expression of a scene has no value just ahead of where a run broke down: its item, argument, value and time.

A root of what becomes negative, a logarithm, a pole: the state behind it is not a number, and nothing in it tells why.
So the motion is continued from the last good state by its velocity and acceleration, and the expressions in the text of
the scene are read along it. Nothing is executed: the syntax tree is walked, and what it does not know has no say.
"""

from __future__ import annotations

import ast
import tomllib
import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.contract.model import EmittedModel
from runtime.contract.status import Status
from runtime.engine.rows import evaluate
from runtime.solutions.solution import Solution

ENDS_BY_EXPRESSIONS = (
    "not_finite",
    "step_too_short",
    "iteration_failed",
)  # statuses that an expression may be the cause of
OF_A_CONTROLLER = "the controller of input"  # whose own numbers are to blame
STEPS_AHEAD = 4.0  # steps that are looked at
PLACES_ON_THE_WAY = 65  # places on the way, and again between two of them
WORDS = ("title", "description", "name", "unit", "type")  # whose text is not an expression
ONE = {"loads": "load", "bodies": "body", "joints": "joint", "events": "event", "states": "state"}
ADVICE = (
    "Write it so that it has a value wherever the motion may go, such as by max(..., 0) in a root or logarithm, or end "
    "the run before by an event."
)


@dataclass(frozen=True)
class Fault:
    """Place k on the way at which a part of an expression has no value: what it is, its argument and that one's value.

    pole: it has one beside it, without bound.
    """

    k: int
    part: str
    argument: str
    wrong: str
    value: float
    pole: bool = False


def outside_its_domain(status: Status, solution: Solution, c: np.ndarray, step: float) -> Status:
    """The same status, or where an expression of the scene has no value just ahead, that one by name.

    solution: until the last good state. c (c_size,): constants of the model; step [s]: of the run.
    """
    model = solution.model
    if status.name not in ENDS_BY_EXPRESSIONS or not model.scene_toml or status.cause.startswith(OF_A_CONTROLLER):
        return status
    path = _Path(model, solution, c)
    ahead = np.linspace(0.0, STEPS_AHEAD * step, PLACES_ON_THE_WAY)
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        names = path.values(ahead)
        found = [(item, fault) for item, tree in expressions(model.scene_toml) for fault in faults(tree, names)]
        if not found:
            return status
        item, fault = min(found, key=lambda one: (one[1].pole, _is_seldom_read(one[0]), one[1].k))
        if fault.k:  # nearer
            ahead = np.linspace(ahead[fault.k - 1], ahead[fault.k], PLACES_ON_THE_WAY)
            tree = next(tree for name, tree in expressions(model.scene_toml) if name == item)
            closer = [one for one in faults(tree, path.values(ahead)) if one.part == fault.part]
            fault = min(closer, key=lambda one: one.k, default=None) or fault
    t = float(solution.t[-1]) + float(ahead[min(fault.k, PLACES_ON_THE_WAY - 1)])
    cause = (
        f"{item}: {fault.part} has no {'bound' if fault.pole else 'value'} where {fault.argument} {fault.wrong}: "
        f"it is {fault.value:.3g} at t = {t:.6g} s"
    )
    return Status("not_finite", status.time, None, cause, ADVICE)


def _is_seldom_read(item: str) -> bool:
    """Of actions, which are read when their event happens, and measures, on which a motion need not depend."""
    return ", action" in item or item.startswith("measure ")


class _Path:
    """The motion ahead of the last sample, by its velocity and acceleration there."""

    def __init__(self, model: EmittedModel, solution: Solution, c: np.ndarray) -> None:
        self.model, self.c, self.t = model, c, float(solution.t[-1])
        self.q = solution.q[-1]
        self.q_dot, self.q_ddot = (np.where(np.isfinite(x[-1]), x[-1], 0.0) for x in (solution.q_dot, solution.q_ddot))
        p = model.parameter_vector() if solution.parameters is None else solution.parameters
        self.known = {entry.name: float(value) for entry, value in zip(model.parameters, p, strict=True)}

    def values(self, ahead: np.ndarray) -> dict[str, np.ndarray]:
        """What expressions may name, at times (N,) from the sample on [s]."""
        s, t = ahead[:, None], self.t + ahead
        at = {"q": self.q + s * self.q_dot + s**2 / 2 * self.q_ddot, "q_dot": self.q_dot + s * self.q_ddot}
        named = {name: np.full(len(ahead), value) for name, value in self.known.items()}
        for suffix, values in (("", at["q"]), ("_dot", at["q_dot"])):
            named |= {f"{name}{suffix}": values[:, k] for k, name in enumerate(self.model.coordinates)}
        if self.model.state_measures:  # expressions of loads and events know no others
            found = evaluate(self.model.kernel("measures"), {**at, "t": t[:, None]}, self.c)["measures"]
            named |= dict(zip(self.model.state_measures, found.T, strict=True))
        return named | {"t": t, "pi": np.full(len(ahead), np.pi)}


# ---- the expressions of a scene ---------------------------------------------------------------------------------


def expressions(scene_toml: str) -> Iterator[tuple[str, ast.expr]]:
    """(item, syntax tree) of every text in a scene that may be one."""
    for section, entries in tomllib.loads(scene_toml).items():
        one = ONE.get(section, section.removesuffix("s"))
        if isinstance(entries, dict):
            named = list(entries.items())
        elif isinstance(entries, list) and all(isinstance(entry, dict) for entry in entries):
            named = [(entry.get("name", ""), entry) for entry in entries]
        else:
            yield from _texts(section, entries)
            continue
        for name, entry in named:
            yield from _texts(f"{one} {name!r}", entry)


def _texts(item: str, value: Any) -> Iterator[tuple[str, ast.expr]]:
    if isinstance(value, dict):
        for key, part in value.items():
            if key not in WORDS:
                yield from _texts(f"{item}, {key}", part)
    elif isinstance(value, list):
        for k, part in enumerate(value):
            yield from _texts(f"{item}[{k}]" if len(value) > 1 else item, part)
    elif isinstance(value, str):
        try:
            yield item, ast.parse(value, mode="eval").body
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            return


# ---- their values, and where they have none -------------------------------------------------------------------------

Names = Mapping[str, np.ndarray]
FUNCTIONS: dict[str, Callable[..., np.ndarray]] = {
    **{name: getattr(np, name) for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "abs")},
    **{"asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "atan2": np.arctan2, "sign": np.sign},
    "step": lambda x: (x >= 0) * 1.0,
    "min": lambda *values: np.minimum.reduce(values),
    "max": lambda *values: np.maximum.reduce(values),
}
OPERATORS: dict[type, Callable[..., np.ndarray]] = {
    **{ast.Add: np.add, ast.Sub: np.subtract, ast.Mult: np.multiply, ast.Div: np.divide, ast.Pow: np.power},
    **{ast.Lt: np.less, ast.LtE: np.less_equal, ast.Gt: np.greater, ast.GtE: np.greater_equal},
    **{ast.Eq: np.equal, ast.NotEq: np.not_equal, ast.USub: np.negative, ast.UAdd: np.positive},
}
DOMAINS: dict[str, tuple[str, Callable[[np.ndarray], np.ndarray]]] = {  # what is wrong, and where
    "sqrt": ("is negative", lambda x: x < 0),
    "log": ("is not positive", lambda x: x <= 0),
    "asin": ("is beyond 1", lambda x: np.abs(x) > 1),
    "acos": ("is beyond 1", lambda x: np.abs(x) > 1),
}


def faults(tree: ast.expr, names: Names) -> list[Fault]:
    """The first place at which each part of an expression has no value; none where it names what is not known."""
    reader = _Reader(names)
    try:
        reader.value(tree, np.ones(len(names["t"]), dtype=bool))
    except (KeyError, TypeError, RecursionError):
        return []
    return reader.faults


class _Reader:
    """Values (N,) of the nodes of a syntax tree; `where` tells at which places a part counts."""

    def __init__(self, names: Names) -> None:
        self.names, self.faults = names, list[Fault]()

    def value(self, node: ast.expr, counts: np.ndarray) -> np.ndarray:
        """Raises KeyError for what is not known."""
        if isinstance(node, ast.Constant):
            return np.full(len(counts), float(node.value))  # type: ignore[arg-type]
        if isinstance(node, ast.Name):
            return np.asarray(self.names[node.id])
        if isinstance(node, ast.Attribute):  # a coordinate
            return np.asarray(self.names[ast.unparse(node)])
        if isinstance(node, ast.UnaryOp):
            return OPERATORS[type(node.op)](self.value(node.operand, counts))
        if isinstance(node, ast.BinOp):
            return self._operation(node, self.value(node.left, counts), self.value(node.right, counts), counts)
        if isinstance(node, ast.Compare):
            ends = [self.value(one, counts) for one in (node.left, *node.comparators)]
            holds = [OPERATORS[type(op)](a, b) for op, a, b in zip(node.ops, ends, ends[1:], strict=False)]
            return np.asarray(np.logical_and.reduce(holds))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            return self._called(node, node.func.id, counts)
        raise KeyError(type(node).__name__)

    def _operation(self, node: ast.BinOp, a: np.ndarray, b: np.ndarray, counts: np.ndarray) -> np.ndarray:
        if isinstance(node.op, ast.Div):
            through = np.concatenate([[False], np.sign(b[1:]) * np.sign(b[:-1]) < 0])
            self._note(node, node.right, "is zero", b, counts & (b == 0))
            self._note(node, node.right, "passes zero", b, counts & through, pole=True)
        if isinstance(node.op, ast.Pow):
            self._note(node, node.left, "is negative", a, counts & (a < 0) & (b != np.round(b)))
            self._note(node, node.left, "is zero", a, counts & (a == 0) & (b < 0))
        return OPERATORS[type(node.op)](a, b)

    def _called(self, node: ast.Call, name: str, counts: np.ndarray) -> np.ndarray:
        if name == "where":
            holds = self.value(node.args[0], counts) != 0
            first, second = (
                self.value(one, counts & own) for one, own in zip(node.args[1:], (holds, ~holds), strict=True)
            )
            return np.where(holds, first, second)
        values = [self.value(one, counts) for one in node.args]
        if name in DOMAINS:
            wrong, outside = DOMAINS[name]
            self._note(node, node.args[0], wrong, values[0], counts & outside(values[0]))
        return FUNCTIONS[name](*values)

    def _note(
        self, node: ast.expr, argument: ast.expr, wrong: str, x: np.ndarray, bad: np.ndarray, pole: bool = False
    ) -> None:
        if bad.any():
            k = int(bad.argmax())
            self.faults.append(Fault(k, ast.unparse(node), ast.unparse(argument), wrong, float(x[k]), pole))
