"""An advice as plain values and as lines of text."""

from __future__ import annotations

from typing import Any

import numpy as np

from runtime.studies.advice.advise import Advice
from runtime.studies.work_precision.dense_methods import left_out


def advice_data(advice: Advice) -> dict[str, Any]:
    """Plain values, SI units."""
    spec, groups = advice.spec, advice.groups
    return {
        "model": advice.model.name,
        "tolerance": advice.tolerance,
        "graded": advice.graded,
        "tried": advice.tried,
        "t_end": advice.t_end,
        "scheme": spec.scheme,
        "m": list(spec.m or ()),
        "options": dict(spec.options),
        "dt": advice.dt,
        "error": advice.trial.error,
        "seconds": advice.seconds,
        "stability_limit": advice.limit,
        "gain": advice.gain if np.isfinite(advice.gain) else None,
        "reason": advice.reason,
        "left_out": left_out(advice.model),
        "automatic": None
        if advice.automatic is None
        else {"scheme": advice.automatic[0], "tolerance": advice.tolerance, "reason": advice.automatic[1]},
        "modes": [
            {
                "lowest": mode.lowest,
                "highest": mode.highest,
                "least_damping": mode.least_damping,
                "coordinates": mode.coordinates,
            }
            for mode in advice.modes
        ],
        "groups": None if groups is None else {"slow": groups.slow, "fast": groups.fast, "gap": groups.gap},
        "candidates": [
            {
                "method": one.label,
                "dt": one.best.setting if one.best else None,
                "seconds": one.best.seconds if one.best else None,
                "error": one.best.error if one.best else None,
            }
            for one in advice.searches
        ],
    }


def advice_lines(advice: Advice, scene: str = "") -> list[str]:
    """For a person: frequencies, groups, candidates, advice, the command; scene: the words that it was given by."""
    lines = [f"{advice.model.name}: coupled frequencies over {advice.tried:g} s [rad/s]"]
    for mode in advice.modes:
        damped = f", damping {mode.least_damping:.2g}" if mode.least_damping > 1e-3 else ""
        lines.append(f"  {mode.lowest:10.5g} to {mode.highest:<10.5g} {', '.join(mode.coordinates)}{damped}")
    if advice.groups is not None:
        lines.append(
            f"widest gap {advice.groups.gap:.3g}: slow {', '.join(advice.groups.slow)}; "
            f"fast {', '.join(advice.groups.fast)}"
        )
    lines.append(f"to reach {advice.tolerance:g} in {', '.join(advice.graded)}:")
    for one in advice.searches:
        if one.best is None:
            lines.append(f"  {one.label:34} not reached in useful time")
        else:
            lines.append(
                f"  {one.label:34} dt = {one.best.setting:<10.4g} s  {one.best.seconds * 1e3:9.4g} ms  "
                f"error {one.best.error:.2g}"
            )
    lines += [one for one in (left_out(advice.model), advice.reason) if one]
    if advice.automatic is not None:
        words = f"symgen simulate {scene or advice.model.name} --scheme auto --tolerance {advice.tolerance:g}"
        lines += [f"to a tolerance ({advice.automatic[1]}): {words}"]
    return [*lines, f"run it with: {command(advice, scene)}"]


def command(advice: Advice, scene: str = "") -> str:
    """The words for `symgen simulate`; scene: what it calls the scene (the model's name by default)."""
    spec = advice.spec
    words = [f"symgen simulate {scene or advice.model.name} --scheme {spec.scheme} --dt {advice.dt:.6g}"]
    if spec.m:
        words.append(f"--m {','.join(map(str, spec.m))}")
    for name, value in spec.options.items():
        text = ",".join(map(str, value)) if isinstance(value, tuple) else value
        words.append(f"--option {name}={text}")
    return " ".join(words)
