"""The emitted functions as the runtime calls them: with [c, charts, numbers of inputs] for c, or with p."""

from __future__ import annotations

from typing import Any

import casadi as ca

from runtime.contract.orientations import with_charts
from runtime.contract.signals import Signals, with_signals


def as_called(kernel: ca.Function, charts: int, signals: Signals, c_size: int) -> ca.Function:
    """An emitted Function with its charts and its inputs behind c (of c_size), where there are any."""
    if charts:
        kernel = with_charts(kernel, charts, c_size)
    if signals.inputs:
        kernel = with_signals(kernel, signals, c_size + 4 * charts)
    return kernel


def of_parameters(kernel: ca.Function, constants: ca.Function) -> ca.Function:
    """A Function of the parameters p instead of c."""
    names = [argument for argument in kernel.name_in() if argument != "c"]
    inputs = {argument: ca.SX.sym(argument, *kernel.size_in(argument)) for argument in names}
    p = ca.SX.sym("p", constants.numel_in(0))
    call: dict[str, Any] = dict(inputs)
    if "c" in kernel.name_in():
        call["c"] = constants(p)
    outputs = kernel(**call)
    values = [outputs[key] for key in kernel.name_out()]
    return ca.Function(kernel.name(), [*inputs.values(), p], values, [*names, "p"], kernel.name_out())
