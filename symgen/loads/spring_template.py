"""Translational spring-damper between two points: length, force and potential derived in SymPy."""

from __future__ import annotations

from functools import cache

import sympy as sp

from symgen.template import Template, derivative

d = sp.symbols("d_x d_y")
d_dot = sp.symbols("d_dot_x d_dot_y")
k, c, l_0, length = sp.symbols("k c l_0 length")


@cache
def template() -> Template:
    """Force on point b (minus that on a): -dV/dd - c l_dot dl/dd, with V = 1/2 k (l - l_0)^2, l = |d|.

    Written with (1 - l_0/l) so that a spring of zero free length without damper needs no square root.
    """
    squared = d[0] ** 2 + d[1] ** 2
    length_rate = derivative(sp.sqrt(squared), dict(zip(d, d_dot, strict=True)))
    outputs: dict[str, sp.Expr] = {"length": sp.sqrt(squared)}
    for axis, name in enumerate("xy"):
        gradient = sp.diff(sp.sqrt(squared), d[axis])
        spring = -k * (1 - l_0 / length) * d[axis]
        damper = -c * (length_rate * gradient).subs(squared, length**2)
        outputs[f"force_{name}"] = spring + sp.simplify(damper)
    outputs["potential"] = k * (length - l_0) ** 2 / 2
    rate = length_rate.subs(squared, length**2)
    outputs["dissipated"] = sp.expand(c * rate**2)
    return Template(outputs)
