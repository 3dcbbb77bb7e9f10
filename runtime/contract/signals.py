"""Inputs u as functions of time: held values, values with rates, values behind a filter, functions.

A kernel of the emitted code takes u, charts of orientations, and sides of jumps by the motion. What the runtime calls
takes [c, sides, charts, w] instead of c, where w are the numbers that u(t) is made of; so whatever evaluates a model
has them as well. Sides are zero where nobody holds them.

    an input             its numbers in w                     u(t), s = t - since
    plain                value                                value
    rates = true         x, x', x'', x'''                     x + x' s + x'' s^2 / 2 + x''' s^3 / 6, and its rates
    filter = w0          r (the target), x, x' (at `since`)   x'' = w0^2 (r - x) - 2 w0 x', solved exactly
    a function of time   (not read)                           f(t), f'(t), f''(t)
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from math import isnan
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError, is_finite_number, shown_value
from runtime.contract.orientations import IDENTITY
from runtime.contract.records import InputRecord, Parameter

SINCE = "inputs.since"
TRIED = (0.37, 1.9)  # s, at which a traced function is compared with the function itself
SUFFIXES = ("", "_dot", "_ddot", "_dddot")


class Signals:
    """The inputs of a model: names and defaults of w, and u(t, w). sources: functions of t in place of held numbers."""

    def __init__(self, inputs: Sequence[InputRecord], sources: Mapping[str, ca.Function] | None = None) -> None:
        self.inputs, self.sources = list(inputs), dict(sources or {})
        self.first: dict[str, int] = {}
        self.parameters: list[Parameter] = []
        for entry in self.inputs:
            self.first[entry.name] = len(self.parameters)
            self.parameters += held_numbers(entry)
        if any(entry.rates for entry in self.inputs):
            self.parameters.append(Parameter(SINCE, "s", "when the inputs with rates were given", "input", 0.0))
        self.names = [parameter.name for parameter in self.parameters]

    @property
    def entries(self) -> list[str]:
        """Names of the entries of u."""
        return [entry.name + end for entry in self.inputs for end in SUFFIXES[: 3 if entry.rates else 1]]

    @property
    def size(self) -> int:
        """Length of w."""
        return len(self.names)

    def u(self, t: ca.SX, w: ca.SX) -> ca.SX:
        """(n_u,) the entries of u at a time."""
        parts = []
        for entry in self.inputs:
            own = w[self.first[entry.name] :]
            if entry.name in self.sources:
                parts += _of_function(self.sources[entry.name], t, entry.rates)
            elif not entry.rates:
                parts.append(own[0])
            else:
                parts += _moving(entry, ca.vertsplit(own[: len(held_numbers(entry))]), t - w[self.size - 1])
        return ca.vertcat(*parts)

    def moved(self, w: np.ndarray, t: float) -> np.ndarray:
        """(n_w,) w that means the same from t on, with `since` = t."""
        if SINCE not in self.names:
            return w.copy()
        found, s = w.copy(), t - float(w[-1])
        for entry in self.inputs:
            if entry.rates:
                k, own = self.first[entry.name], held_numbers(entry)
                now = [float(part) for part in _moving(entry, [float(x) for x in w[k : k + len(own)]], s)]
                found[k : k + len(own)] = [w[k], *now[:2]] if entry.filter else [*now, w[k + 3]]
        found[-1] = t
        return found

    def held_as(self, u: Mapping[str, float], t: float) -> np.ndarray:
        """(n_w,) w of the inputs that are u (by name, rates with their endings) at a time, and go on from there."""
        w = np.array([parameter.default for parameter in self.parameters])
        for entry in self.inputs:
            k = self.first[entry.name]
            x, v, a = ((u[entry.name + end] if entry.rates or not end else 0.0) for end in SUFFIXES[:3])
            if entry.filter:
                w[k : k + 3] = x + (a / entry.filter + 2 * v) / entry.filter, x, v
            elif entry.rates:
                w[k : k + 4] = x, v, a, 0.0
            else:
                w[k] = x
        if SINCE in self.names:
            w[-1] = t
        return w

    def changed(self, w: np.ndarray, t: float, values: Mapping[str, float]) -> np.ndarray:
        """(n_w,) w with other numbers by name from t on. Raises ArgumentError for other names and infinite numbers."""
        found = self.moved(w, t)
        for name, value in values.items():
            if name not in self.names or name == SINCE:
                raise ArgumentError(f"there is no input {name!r}; there are {', '.join(self.names) or 'none'}")
            if name in self.sources:
                raise ArgumentError(f"input {name!r} is a function of time in this run: it cannot be set")
            number = value.item() if isinstance(value, np.ndarray) and value.ndim == 0 else value
            if not is_finite_number(number):
                raise ArgumentError(f"input {name!r} must be a finite number, not {shown_value(value)}")
            found[self.names.index(name)] = number
        return found


def held_numbers(entry: InputRecord) -> list[Parameter]:
    """What w holds of an input, as parameters: they can be changed by name like those of the scene."""

    def one(name: str, unit: str, meaning: str, default: float) -> Parameter:
        return Parameter(name, unit, meaning, "data" if entry.hidden else "input", default)

    own = one(entry.name, entry.unit, entry.meaning, entry.default)
    per_second = [f"{entry.unit or '1'}/s", f"{entry.unit or '1'}/s^2", f"{entry.unit or '1'}/s^3"]
    if entry.filter:
        return [
            own,
            one(f"{entry.name}.start", entry.unit, "value behind the filter", entry.default),
            one(f"{entry.name}.start_dot", per_second[0], "its rate", 0.0),
        ]
    if entry.rates:
        words = ("rate", "acceleration", "jerk")
        names = [f"{entry.name}{suffix}" for suffix in SUFFIXES[1:]]
        return [own, *(one(*each, 0.0) for each in zip(names, per_second, words, strict=True))]
    return [own]


def _moving(entry: InputRecord, own: Sequence[Any], s: Any) -> list[Any]:
    """[x, x', x''] a time s after the numbers of an input were given (numbers or SX)."""
    if not entry.filter:
        x, v, a, j = own
        return [x + s * (v + s * (a / 2 + s * j / 6)), v + s * (a + s * j / 2), a + s * j]
    w0, (r, x_0, v_0) = entry.filter, own
    off, b = x_0 - r, v_0 + w0 * (x_0 - r)  # critically damped: x = r + (off + b s) exp(-w0 s)
    decay = np.exp(-w0 * s) if isinstance(s, float) else ca.exp(-w0 * s)
    x, v = r + (off + b * s) * decay, (v_0 - w0 * b * s) * decay
    return [x, v, w0**2 * (r - x) - 2 * w0 * v]


def _of_function(function: ca.Function, t: ca.SX, rates: bool) -> list[ca.SX]:
    value = function(t)
    if not rates:
        return [value]
    time = ca.SX.sym("time")
    f = function(time)
    f_t = ca.jacobian(f, time)
    first, second = (ca.substitute(one, time, t) for one in (f_t, ca.jacobian(f_t, time)))
    return [value, first, second]


def traced(function: Callable[[Any], Any], name: str) -> ca.Function:
    """A function of time as straight-line code: called once with a symbol. Raises ArgumentError if it cannot be."""
    t = ca.SX.sym("t")
    try:
        with warnings.catch_warnings():  # CasADi announces that NumPy's functions of its symbols will change
            warnings.simplefilter("ignore", FutureWarning)
            value = function(t)
            value = ca.vertcat(*value) if isinstance(value, list | np.ndarray) else ca.SX(value)
        found = ca.Function("input", [t], [ca.densify(value)])
    except Exception as error:  # whatever a user's function raises
        reason = (str(error) or type(error).__name__).splitlines()[0]
        raise ArgumentError(
            f"the function for input {name!r} cannot be traced with a symbolic time ({reason}): write it with NumPy's "
            "functions and casadi.if_else, or give (times, values)"
        ) from error
    if found.numel_out(0) != 1:
        raise ArgumentError(f"the function for input {name!r} must give one number, not {found.numel_out(0)}")
    if any(isnan(float(found(time))) and _is_number(function, time) for time in TRIED):
        raise ArgumentError(
            f"the function for input {name!r} cannot take a symbol: it converts it to a number, as math.sin and "
            "float do. Write np.sin for math.sin, casadi.if_else for a choice, or give (times, values)"
        )
    return found


def _is_number(function: Callable[[Any], Any], time: float) -> bool:
    """Does a function of a user give a number at a time [s]?"""
    try:
        return not isnan(float(function(time)))
    except Exception:  # whatever it raises, it is not a number
        return False


def as_called(kernel: ca.Function, sides: int, charts: int, signals: Signals, c_size: int) -> ca.Function:
    """A kernel of the emitted code as the runtime calls it: with [c, sides, charts, w] for its c, with [p, w] for p.

    sides: how many jumps may be held; charts: how many orientations have one; c_size: length of c. Without all of them
    it is the kernel itself.
    """
    names, first, end = kernel.name_in(), c_size + sides, c_size + sides + 4 * charts
    if not sides and not charts and not signals.inputs:
        return kernel
    if kernel.name() == "constants" or "p" in names:
        p, w = ca.SX.sym("p", kernel.size1_in(0)) if names else ca.SX(0, 1), ca.SX.sym("w", signals.size)
        of_p = kernel.call([p] if names else [])
        if kernel.name() == "constants":
            of_p = [ca.densify(ca.vertcat(of_p[0], ca.DM.zeros(sides), ca.DM(IDENTITY * charts), w))]
        return ca.Function(kernel.name(), [ca.vertcat(p, w)], of_p, ["p"], kernel.name_out())
    behind_c = {"c", "side", "chart", "u"} if signals.inputs else {"c", "side", "chart"}
    if behind_c.isdisjoint(names):
        return kernel
    given = {name: ca.SX.sym(name, *kernel.size_in(name)) for name in names if name not in behind_c}
    both = ca.SX.sym("c", end + signals.size)
    call: dict[str, Any] = {**given, "c": both[:c_size], "side": both[c_size:first], "chart": both[first:end]}
    if "u" in names and signals.inputs:
        call["u"] = signals.u(given.setdefault("t", ca.SX.sym("t")), both[end:])
    found = kernel.call({name: call[name] for name in names})
    outputs = [ca.densify(found[name]) for name in kernel.name_out()]
    return ca.Function(kernel.name(), [*given.values(), both], outputs, [*given, "c"], kernel.name_out())
