"""Emitted functions as functions of JAX: traced from their straight-line code, so that jit, vmap and grad go through.

A tape is a list of operations in single assignment; each is one operation of `jax.lax` in 64 bits. What depends on the
parameters only is the function `constants`, whose tape stands before that of the function. JAX is imported when a
function is asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.jax_library import import_jax, require_64_bits
from runtime.contract.model import EmittedModel
from runtime.contract.signals import Signals, as_called
from runtime.contract.tape import Node, Tape, marked, read_tape, without_repetitions

SMALL_POWER = 16  # up to which a whole exponent is multiplied out


@dataclass(frozen=True, eq=False, repr=False)
class JaxFunction:
    """A function of a model for JAX: arrays by position or by name -> {output: array}, SI units, 64 bits.

    Attributes
    ----------
    name : str
        Of the function.
    inputs : dict of str to int
        Lengths of the arguments, in order. `t` may be a number.
    outputs : dict of str to tuple
        Shapes of the results: (), (n,) or (n, m).
    operations : int
        Arithmetic operations of one evaluation, `constants` included.
    defaults : dict of str to array
        Of `p`, where it may be left out.
    """

    name: str
    inputs: Mapping[str, int]
    outputs: Mapping[str, tuple[int, ...]]
    operations: int
    defaults: Mapping[str, np.ndarray]
    compiled: Callable[[dict[str, Any]], dict[str, Any]] = field(repr=False)
    instead: Mapping[str, tuple[str, int]] = field(default_factory=dict, repr=False)
    optional: frozenset[str] = frozenset()
    timed: bool = False  # is t asked for by u only, as the model has it?

    def __call__(self, *values: Any, **by_name: Any) -> dict[str, Any]:
        """Evaluate at arrays or tracers.

        Parameters
        ----------
        *values, **by_name
            The arguments. `p` and `u` may be left out: they are those of the model. `c`, the value of the function
            `constants`, may be given instead of `p`: it is computed once then, outside a loop.

        Returns
        -------
        dict of str to jax.Array
            The outputs by name.

        Raises
        ------
        ArgumentError
            For an unknown or a missing argument, one of another length, and where JAX computes with 32 bits.
        """
        require_64_bits(f"function {self.name}")
        return self.compiled(self._checked(values, by_name))

    def _checked(self, values: tuple[Any, ...], by_name: dict[str, Any]) -> dict[str, Any]:
        if len(values) > len(self.inputs):
            raise ArgumentError(f"function {self.name}", f"takes {len(self.inputs)} arguments", self._takes)
        given = dict(zip(self.inputs, values, strict=False))
        for name, value in by_name.items():
            if name in given or (name not in self.inputs and name not in self.instead):
                problem = "is given twice" if name in given else "is not taken"
                raise ArgumentError(f"argument {name!r} of function {self.name}", problem, self._takes)
            given[name] = value
        replaced = {self.instead[name][0] for name in given if name in self.instead}
        for name in replaced & given.keys():
            raise ArgumentError(f"argument {name!r} of function {self.name}", "is given beside c", "give one of them")
        unread = replaced | ({"t"} if self.timed and "u" in given else set())
        for name in self.inputs:
            if name not in given and name not in unread:
                if name in self.defaults:
                    given[name] = self.defaults[name]
                elif name not in self.optional:
                    raise ArgumentError(f"argument {name!r} of function {self.name}", "is missing", self._takes)
        return {name: self._real(name, value) for name, value in given.items()}

    def _real(self, name: str, value: Any) -> Any:
        """The value, checked."""
        value = value if hasattr(value, "aval") else np.asarray(value)
        size = self.inputs[name] if name in self.inputs else self.instead[name][1]
        if value.shape != (size,) and not (size == 1 and value.shape == ()):
            raise ArgumentError(
                f"argument {name!r} of function {self.name}",
                f"has shape {value.shape}",
                f"give {size} numbers, and take jax.vmap for many of them",
            )
        if not (np.issubdtype(value.dtype, np.floating) or np.issubdtype(value.dtype, np.integer)):
            raise ArgumentError(f"argument {name!r} of function {self.name}", f"is {value.dtype}", "give real numbers")
        return value

    @property
    def _takes(self) -> str:
        return f"it takes {', '.join(self.inputs)}"

    def __repr__(self) -> str:
        results = ", ".join(f"{name} {shape}" for name, shape in self.outputs.items())
        return f"<JaxFunction {self.name}: ({', '.join(self.inputs)}) -> {results}>"


def to_jax(model: EmittedModel, function: str | ca.Function) -> JaxFunction:
    """Give a function of the model as a function of JAX, for jit, vmap and grad on whatever device JAX has.

    Parameters
    ----------
    model : Model
        The mechanism.
    function : str or casadi.Function
        The name of an emitted function, such as ``"condensed"`` (`M_hat`, `Q_hat`), ``"forward_dynamics"``,
        ``"measures"``, ``"dQ_hat_dq_i"``; or any CasADi Function of SX expressions that is made of them, such as
        ``model.ode().f``.

    Returns
    -------
    JaxFunction
        ``f(q_i=..., q_d=..., ...)`` gives its outputs by name: numbers (), vectors (n,) and matrices (n, m), SI units,
        equal to CasADi's to rounding. It is compiled at its first call.

    Raises
    ------
    ImportError
        If JAX is not installed (extra `jax`).
    ArgumentError
        If JAX computes with 32 bits, and for what is no function.
    ModelError
        For a function that the model does not have, or with an operation that is not translated.

    Notes
    -----
    The arguments are those of `model.function`: names of the paper, the inputs `u` in the order of `input_entries`, the
    parameters `p` last; `u` and `p` left out are those of the model. Derivatives are those of the code as it stands:
    `closure` is one Newton step, and charts of bodies that turn freely are where `c` has them.

    References
    ----------
    A. Griewank and A. Walther, Evaluating Derivatives, 2nd ed., SIAM, 2008.
    """
    import_jax()
    require_64_bits("to_jax")
    if isinstance(function, ca.Function):
        return _of_expressions(function)
    if not isinstance(function, str):
        raise ArgumentError("function", f"is a {type(function).__name__}", "give a name, or a CasADi Function")
    return _of_kernel(model, function)


# ---- The two sorts of functions ----------------------------------------------------------------------------------


def _of_expressions(function: ca.Function) -> JaxFunction:
    """Any Function of SX expressions."""
    import jax

    traced = _Traced(function.name(), function)
    for name, size in zip(function.name_in(), traced.tape.input_sizes, strict=True):
        if size != function.numel_in(name):
            raise ModelError(f"argument {name} of function {function.name()}", "is sparse", "densify it")

    def run(given: dict[str, Any]) -> dict[str, Any]:
        return traced(given)

    sizes = dict(zip(traced.tape.input_names, traced.tape.input_sizes, strict=True))
    return JaxFunction(function.name(), sizes, traced.shapes, traced.tape.operations, {}, jax.jit(run))


def _of_kernel(model: EmittedModel, name: str) -> JaxFunction:
    """An emitted function: of c, which follows from p, and of u, which follows from t and the inputs' numbers."""
    import jax

    model.kernel(name)  # refuses a function that was not generated
    counts, size = (len(model.description.held), len(model.description.orientations)), model.emitted_c_size
    own, constants = (as_called(model.builders[key](), *counts, Signals([]), size) for key in (name, "constants"))
    kernel = _Traced(name, own, _scalars(model, name))
    of_p = _Traced("constants", constants) if "c" in own.name_in() else None
    sizes = {key: length for key, length in zip(own.name_in(), kernel.tape.input_sizes, strict=True) if key != "c"}
    values, n_w = model.parameter_vector(), model.signals.size
    sizes.setdefault("p", len(values) - n_w)
    held = values[sizes["p"] :]
    of_w = _Traced("inputs", _inputs_over_time(model.signals)) if "u" in sizes else None
    timed = (
        of_w is not None and "t" not in sizes and any(node.op == ca.OP_INPUT and not node.a for node in of_w.tape.nodes)
    )
    if timed:
        sizes = {"t": 1, **sizes}

    def run(given: dict[str, Any]) -> dict[str, Any]:
        if of_p is not None and "c" not in given:
            given = {**given, "c": of_p({"p": given["p"]})["c"]}
        if of_w is not None and "u" not in given:
            given = {**given, "u": of_w({"t": given.get("t", 0.0), "w": held})["u"]}
        return kernel(given)

    return JaxFunction(
        name,
        sizes,
        kernel.shapes,
        kernel.tape.operations + (of_p.tape.operations if of_p is not None else 0),
        {"p": values[: sizes["p"]]},
        jax.jit(run),
        {"c": ("p", own.size1_in("c"))} if of_p is not None else {},
        frozenset({"u"} if of_w is not None else ()),
        timed,
    )


def _inputs_over_time(signals: Signals) -> ca.Function:
    """(t, w) -> u as the model has it."""
    t, w = ca.SX.sym("t"), ca.SX.sym("w", signals.size)
    return ca.Function("inputs", [t, w], [ca.densify(signals.u(t, w))], ["t", "w"], ["u"])


def _scalars(model: EmittedModel, name: str) -> frozenset[str]:
    """Outputs that are numbers, as the description says: a vector of one entry is none."""
    own = (one for one in model.description.functions if one.name == name)
    return frozenset(output.name for one in own for output in one.outputs if output.shape == "1")


# ---- A tape as operations of JAX ---------------------------------------------------------------------------------


class _Traced:
    """A tape that is traced when it is called: {argument: (size,)} -> {output: array}."""

    def __init__(self, name: str, function: ca.Function, scalars: frozenset[str] = frozenset()) -> None:
        self.tape = _tape(name, function)
        _refuse_unknown(name, self.tape)
        self._scalars = scalars

    @property
    def shapes(self) -> dict[str, tuple[int, ...]]:
        """Of the outputs."""
        shapes = zip(self.tape.output_names, self.tape.output_shapes, strict=True)
        return {name: self._shape(name, *shape) for name, shape in shapes}

    def _shape(self, name: str, rows: int, columns: int) -> tuple[int, ...]:
        if name in self._scalars:
            return ()
        return (rows,) if columns == 1 else (rows, columns)

    def __call__(self, given: Mapping[str, Any]) -> dict[str, Any]:
        import jax.numpy as jnp

        operations = _operations()
        arguments = [jnp.asarray(given[name], dtype=np.float64).reshape(-1) for name in self.tape.input_names]
        values: list[Any] = []
        for node in self.tape.nodes:
            values.append(_value(node, values, arguments, operations))
        found = {}
        for name, entries, shape in zip(
            self.tape.output_names, self.tape.outputs, self.tape.output_shapes, strict=True
        ):
            column = self._column(entries, values, arguments)
            found[name] = column.reshape(shape[::-1]).T.reshape(self._shape(name, *shape))
        return found

    def _column(self, entries: list[int], values: list[Any], arguments: list[Any]) -> Any:
        """Entries of an output: what is computed, arguments and numbers as one array, of which they are picked."""
        import jax.numpy as jnp

        nodes = self.tape.nodes
        ends = np.cumsum([0, *self.tape.input_sizes])
        numbers = list(dict.fromkeys(k for k in entries if nodes[k].op == ca.OP_CONST))
        given = [*arguments] if any(nodes[k].op == ca.OP_INPUT for k in entries) else []
        worked = list(dict.fromkeys(k for k in entries if nodes[k].op not in (ca.OP_CONST, ca.OP_INPUT)))
        first = int(ends[-1]) if given else 0
        place = {k: first + n for n, k in enumerate([*worked, *numbers])}
        place |= {k: int(ends[nodes[k].a]) + nodes[k].b for k in entries if nodes[k].op == ca.OP_INPUT}
        parts = [*given, *([jnp.stack([values[k] for k in worked])] if worked else [])]
        parts += [np.array([nodes[k].value for k in numbers])] if numbers else []
        if not parts:
            return jnp.zeros(0)
        picked = np.array([place[k] for k in entries])
        whole = jnp.concatenate(parts) if len(parts) > 1 else jnp.asarray(parts[0])
        return whole if np.array_equal(picked, np.arange(whole.size)) else whole[picked]


def _tape(name: str, function: ca.Function) -> Tape:
    """Raises ModelError for what is no straight-line code of known operations and tables."""
    try:
        return without_repetitions(read_tape(function))
    except (ValueError, RuntimeError) as error:
        raise ModelError(
            f"function {name}",
            f"is not straight-line code ({str(error).splitlines()[0]})",
            "give a Function of SX expressions",
        ) from error


def _refuse_unknown(name: str, tape: Tape) -> None:
    """Raises ModelError for an operation that is not translated."""
    operations = _operations()
    for node in tape.nodes:
        if node.op not in (ca.OP_INPUT, ca.OP_CONST, ca.OP_CALL, ca.OP_CONSTPOW) and node.op not in operations.all:
            raise ModelError(
                f"function {name}",
                f"has the operation {_name(node.op)!r}, which is not translated to JAX",
                "write it with other functions",
            )


@cache
def _name(op: int) -> str:
    names = [one[3:].lower() for one in dir(ca) if one.startswith("OP_") and getattr(ca, one) == op]
    return names[0] if names else str(op)


class _Operations(NamedTuple):
    """Of one and of two arguments, by CasADi's numbers."""

    unary: dict[int, Callable[[Any], Any]]
    binary: dict[int, Callable[[Any, Any], Any]]

    @property
    def all(self) -> set[int]:
        """Their numbers."""
        return {*self.unary, *self.binary}


def _value(node: Node, values: list[Any], arguments: list[Any], operations: _Operations) -> Any:
    """The value of a node from those before it."""
    from jax import lax

    if node.op == ca.OP_INPUT:
        return lax.index_in_dim(arguments[node.a], node.b, keepdims=False)
    if node.op == ca.OP_CONST:
        return np.float64(node.value)
    if node.op == ca.OP_CALL:
        return _table(node, values[node.a])
    if node.op == ca.OP_CONSTPOW:
        return _power(values[node.a], values[node.b])
    if node.op in operations.unary:
        return operations.unary[node.op](values[node.a])
    return operations.binary[node.op](values[node.a], values[node.b])


def _table(node: Node, x: Any) -> Any:
    """A piecewise polynomial, or its derivative; a knot belongs to the row that it begins."""
    import jax.numpy as jnp

    table, order = marked(node.value)
    powers, knots = jnp.asarray(table.coefficients(order)), jnp.asarray(table.knots)
    row = jnp.searchsorted(knots[1 : table.powers.shape[1]], x, side="right")
    y, beyond = powers[-1][row], x - knots[row]
    for power in powers[-2::-1]:
        y = power[row] + beyond * y
    return y


def _power(base: Any, exponent: Any) -> Any:
    """A number as exponent: multiplied out if it is small and whole, so that its derivatives at 0 are finite."""
    from jax import lax

    if isinstance(exponent, np.float64) and exponent == round(exponent) and abs(exponent) <= SMALL_POWER:
        return lax.integer_pow(base, int(exponent))
    return lax.pow(base, exponent)


@cache
def _operations() -> _Operations:
    import jax.numpy as jnp
    from jax import lax

    def truth(condition: Any) -> Any:
        return lax.convert_element_type(condition, np.float64)

    def chosen(condition: Any, yes: Any, no: Any) -> Any:
        return lax.select(condition, jnp.asarray(yes), jnp.asarray(no))

    named = "sin cos tan exp log sqrt asin acos atan sinh cosh tanh asinh acosh atanh floor ceil log1p expm1 sign erf"
    unary: dict[int, Callable[[Any], Any]] = {
        getattr(ca, f"OP_{name.upper()}"): getattr(lax, name) for name in named.split()
    }
    unary |= {
        ca.OP_NEG: lax.neg,
        ca.OP_FABS: lax.abs,
        ca.OP_SQ: lambda a: lax.mul(a, a),
        ca.OP_TWICE: lambda a: lax.add(a, a),
        ca.OP_INV: lambda a: lax.div(np.float64(1.0), a),
        ca.OP_NOT: lambda a: truth(lax.eq(a, np.float64(0.0))),
        ca.OP_ASSIGN: lambda a: a,
    }

    def both(a: Any, b: Any) -> Any:
        return truth(lax.bitwise_and(lax.ne(a, np.float64(0.0)), lax.ne(b, np.float64(0.0))))

    def either(a: Any, b: Any) -> Any:
        return truth(lax.bitwise_or(lax.ne(a, np.float64(0.0)), lax.ne(b, np.float64(0.0))))

    binary: dict[int, Callable[[Any, Any], Any]] = {
        ca.OP_ADD: lax.add,
        ca.OP_SUB: lax.sub,
        ca.OP_MUL: lax.mul,
        ca.OP_DIV: lax.div,
        ca.OP_POW: lax.pow,
        ca.OP_LT: lambda a, b: truth(lax.lt(a, b)),
        ca.OP_LE: lambda a, b: truth(lax.le(a, b)),
        ca.OP_EQ: lambda a, b: truth(lax.eq(a, b)),
        ca.OP_NE: lambda a, b: truth(lax.ne(a, b)),
        ca.OP_AND: both,
        ca.OP_OR: either,
        # of equal arguments the first, as in CasADi's derivatives; of a NaN and a number the number
        ca.OP_FMIN: lambda a, b: chosen(lax.bitwise_or(lax.le(a, b), lax.ne(b, b)), a, b),
        ca.OP_FMAX: lambda a, b: chosen(lax.bitwise_or(lax.ge(a, b), lax.ne(b, b)), a, b),
        ca.OP_ATAN2: lax.atan2,
        ca.OP_FMOD: lax.rem,
        ca.OP_COPYSIGN: jnp.copysign,
        ca.OP_HYPOT: jnp.hypot,
        ca.OP_IF_ELSE_ZERO: lambda a, b: chosen(lax.ne(a, np.float64(0.0)), b, np.float64(0.0)),
    }
    return _Operations(unary, binary)
