"""Translational spring-damper between two points: length, force and potential derived in SymPy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import casadi as ca
import sympy as sp

from symgen.algebra.template import Template, derivative

SMALLEST = 1e-24  # m2: points nearer than that have met
k, c, l_0, length = sp.symbols("k c l_0 length")


def _vectors(dimension: int) -> tuple[list[sp.Symbol], list[sp.Symbol]]:
    return (
        [sp.Symbol(f"d_{axis}") for axis in "xyz"[:dimension]],
        [sp.Symbol(f"d_dot_{axis}") for axis in "xyz"[:dimension]],
    )


@cache
def template(dimension: int) -> Template:
    """Force on point b (minus that on a): -dV/dd - c l_dot dl/dd, with V = 1/2 k (l - l_0)^2, l = |d|.

    Written with (1 - l_0/l) so that a spring of zero free length without damper needs no square root.
    """
    d, d_dot = _vectors(dimension)
    squared = sp.Add(*(component**2 for component in d))
    length_rate = derivative(sp.sqrt(squared), dict(zip(d, d_dot, strict=True)))
    outputs: dict[str, sp.Expr] = {"length": sp.sqrt(squared)}
    for axis, component in zip("xyz", d, strict=False):
        gradient = sp.diff(sp.sqrt(squared), component)
        spring = -k * (1 - l_0 / length) * component
        damper = -c * (length_rate * gradient).subs(squared, length**2)
        outputs[f"force_{axis}"] = spring + sp.simplify(damper)
    outputs["potential"] = k * (length - l_0) ** 2 / 2
    rate = length_rate.subs(squared, length**2)
    outputs["dissipated"] = sp.expand(c * rate**2)
    return Template(outputs)


@dataclass(frozen=True)
class SpringForce:
    """Force on point b [N], stored energy [J], dissipated power [W]."""

    force: list[ca.SX]
    potential: ca.SX
    dissipated: ca.SX


def evaluate(
    d: Sequence[ca.SX], d_dot: Sequence[ca.SX], stiffness: ca.SX, damping: ca.SX, free_length: ca.SX
) -> SpringForce:
    """The spring between points a distance vector d apart (2 or 3 components)."""
    if free_length.is_zero() and not damping.is_zero():
        return _through_zero(ca.vertcat(*d), ca.vertcat(*d_dot), stiffness, damping)
    form, (names, rates) = template(len(d)), _vectors(len(d))
    values = {
        **dict(zip(names, d, strict=True)),
        **dict(zip(rates, d_dot, strict=True)),
        k: stiffness,
        c: damping,
        l_0: free_length,
    }
    values[length] = form.evaluate(values, ["length"])["length"]
    forces = [f"force_{axis}" for axis in "xyz"[: len(d)]]
    out = form.evaluate(values, [*forces, "potential", "dissipated"])
    return SpringForce([out[name] for name in forces], out["potential"], out["dissipated"])


def _through_zero(d: ca.SX, d_dot: ca.SX, stiffness: ca.SX, damping: ca.SX) -> SpringForce:
    """Zero free length, with a damper: the points may meet, where no line between them is left for the damper.

    Force on b: -k d - c (d_dot . d) d / |d|^2.
    """
    squared, along = ca.fmax(ca.dot(d, d), SMALLEST), ca.dot(d_dot, d)
    force = -stiffness * d - damping * along / squared * d
    return SpringForce(ca.vertsplit(force), stiffness * ca.dot(d, d) / 2, damping * along * along / squared)
