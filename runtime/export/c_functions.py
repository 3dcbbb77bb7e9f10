"""Functions of a model alone as C99: M_hat, Q_hat, their derivatives, and whatever else the model provides."""

from __future__ import annotations

import re
from collections.abc import Sequence

from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.contract.tape import read_tape
from runtime.engine.c_source import Style, source, tape_code

# what a simulation elsewhere needs
USUAL = (
    "constants",
    "closure",
    "velocities",
    "condensed",
    "accelerations",
    "measures",
    "dQ_hat_dq_i",
    "dQ_hat_dq_i_dot",
)


def function_files(model: Model, functions: Sequence[str] | None = None, name: str | None = None) -> dict[str, str]:
    """NAME_functions.h and NAME_functions.c of model functions by name, by default USUAL and those that these need.

    With sin, cos and exp of the C library, so bits are those of the runtime's functions. Raises ModelError for a
    function that the model does not have.
    """
    wanted = list(functions) if functions else [one for one in USUAL if model.has(one)]
    stem = re.sub(r"\W", "_", name or model.name)
    style, declared = Style(f"{stem}_"), list[str]()
    code = []
    for one in dict.fromkeys(["constants", *wanted]):
        kernel = model.kernel(one)
        tape = read_tape(kernel)
        clash = set(kernel.name_in()) & set(kernel.name_out())
        if clash:
            raise ModelError(f"function {one}", f"gives and takes {', '.join(clash)}", "leave it out")
        code.append(tape_code(f"{stem}_{one}", tape, tape.output_names, style, kept=""))
        declared.append(_declared(model, one, code[-1].text))
    work = max(1, *(part.work for part in code))
    guard = f"{stem}_FUNCTIONS_H"
    head = f"/* Functions of {model.name}. SI units; arrays column by column; w[{stem}_W] is for work. */\n"
    names = [f"   {label}: {', '.join(entries)}\n" for label, entries in _orders(model) if entries]
    header = (
        f"{head}/* In the order of\n{''.join(names)}*/\n#ifndef {guard}\n#define {guard}\n\n#define {stem}_W {work}\n\n"
        f'#ifdef __cplusplus\nextern "C" {{\n#endif\n\n'
        + "\n".join(declared)
        + "\n#ifdef __cplusplus\n}\n#endif\n#endif\n"
    )
    return {
        f"{stem}_functions.h": header,
        f"{stem}_functions.c": f'#include "{stem}_functions.h"\n\n{source(code, style)}',
    }


def _orders(model: Model) -> list[tuple[str, list[str]]]:
    p = [entry.name for entry in model.parameters]
    return [("q", model.coordinates), ("q_i", model.q_i), ("q_d", model.q_d), ("p", p), ("measures", model.measures)]


def _declared(model: Model, name: str, text: str) -> str:
    """What the function is, and its declaration: the last head in its text."""
    head = [line for line in text.splitlines() if line.startswith("void ")][-1].removesuffix(" {")
    spec = next((one for one in model.description.functions if one.name == name), None)
    kernel = model.kernel(name)
    sizes = [f"{out}[{kernel.size1_out(out)}x{kernel.size2_out(out)}]" for out in kernel.name_out()]
    sizes += [f"{given}[{kernel.numel_in(given)}]" for given in kernel.name_in() if kernel.numel_in(given)]
    return f"/* {spec.meaning + ': ' if spec else ''}{', '.join(sizes)} */\n{head};\n"
