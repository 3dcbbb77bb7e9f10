"""Advice in words, for a person and for a shell, and as plain values."""

from __future__ import annotations

from math import isfinite
from typing import Any

from runtime.studies.advice.advise import Advice
from runtime.studies.advice.methods import left_out


def advice_data(advice: Advice) -> dict[str, Any]:
    """Plain values, SI units."""
    method = advice.method
    return {
        "model": advice.model.name,
        "tolerance": advice.tolerance,
        "graded": advice.graded,
        "t_end": advice.t_end,
        "scheme": method.scheme,
        "m": list(method.m or ()),
        "options": dict(method.options),
        "dt": advice.dt,
        "error": advice.best.error,
        "operations": advice.best.operations,
        "gain": advice.gain if isfinite(advice.gain) else None,
        "reason": advice.reason,
        "left_out": left_out(advice.model),
        "automatic": {"scheme": advice.automatic[0], "tolerance": advice.tolerance, "reason": advice.automatic[1]},
        "candidates": [
            {"method": one.label, "dt": one.dt, "operations": one.operations, "error": one.error}
            if one.answer
            else {"method": one.label, "dt": None, "operations": None, "error": None, "failure": one.failure}
            for one in advice.candidates
        ],
    }


def advice_lines(advice: Advice, scene: str = "") -> list[str]:
    """For a person: candidates, advice, the command; scene: the words that it was given by."""
    lines = [
        f"{advice.model.name}: to reach {advice.tolerance:g} in {', '.join(advice.graded)} over {advice.t_end:g} s:"
    ]
    for one in advice.candidates:
        came = f"dt = {one.dt:<8g} s  {one.operations:9.3g} operations  error {one.error:.2g}"
        lines.append(f"  {one.label:34} {came if one.answer else one.failure}")
    lines += [one for one in (left_out(advice.model), advice.reason) if one]
    words = f"symgen simulate {scene or advice.model.name} --scheme auto --tolerance {advice.tolerance:g}"
    lines += [f"to a tolerance ({advice.automatic[1]}): {words}"]
    return [*lines, f"run it with: {advised_command(advice, scene)}"]


def advised_command(advice: Advice, scene: str = "") -> str:
    """The words for `symgen simulate`; scene: what it calls the scene (the model's name by default)."""
    method = advice.method
    words = ["symgen simulate", scene or advice.model.name, f"--scheme {method.scheme}"]
    words += [f"--m {','.join(map(str, method.m))}"] if method.m else []
    for name, value in method.options.items():
        words.append(f"--option {name}={','.join(map(str, value)) if isinstance(value, tuple) else value}")
    return " ".join([*words, f"--dt {advice.dt:g}"])
