"""Shapes of a beam's mode set in closed form, orthogonal in mass and stiffness, by the names of its ends (Eq. 19)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from runtime.contract.beams.eigenfunctions import bending_functions, stretching_functions
from runtime.contract.beams.end_shapes import BENDING, STRETCHING, EndShapes
from runtime.contract.beams.shape_functions import Array, ShapeFunctions, gauss_points, polynomials

FEWEST_PANELS = 8
GRID = 16  # points a panel among which the largest value of a shape is sought
POLISHING = 4  # Newton steps to it
SIGN_THRESHOLD = 1e-6


class OrthogonalShapes(NamedTuple):
    """functions: shapes of largest value 1.  values (n,): squared frequencies for unit length, mass and stiffness."""

    functions: ShapeFunctions
    values: Array


def panels_for(modes: int) -> int:
    """Parts of the quadrature for sets of at most `modes` shapes: each holds at most half a period."""
    return max(FEWEST_PANELS, modes + 2)


def bending_shapes(ends: str, modes: int) -> OrthogonalShapes:
    """The first `modes` bending shapes of `ends`, end shapes among them.

    Raises ValueError for unknown ends or fewer modes than the ends have static shapes.
    """
    choice = _choice("lateral", BENDING, ends, modes)
    own = bending_functions(choice.start, choice.end, modes - len(choice.static))
    return _orthogonal(choice, own, own.wave_numbers**4, panels_for(modes), order=2)


def stretching_shapes(ends: str, modes: int) -> OrthogonalShapes:
    """The first `modes` longitudinal shapes of `ends`; errors as of `bending_shapes`."""
    choice = _choice("axial", STRETCHING, ends, modes)
    own = stretching_functions(choice.start, choice.end, modes - len(choice.static))
    return _orthogonal(choice, own, own.wave_numbers**2, panels_for(modes), order=1)


def slope_size(shapes: OrthogonalShapes) -> float:
    """The largest slope of all shapes."""
    return float(np.max(np.abs(shapes.functions.at(_grid(panels_for(shapes.functions.count)), 1))))


def _choice(kind: str, known: dict[str, EndShapes], ends: str, modes: int) -> EndShapes:
    if ends not in known:
        raise ValueError(f"unknown ends {ends!r} for {kind} modes; use one of {', '.join(known)}")
    least = max(1, len(known[ends].static))
    if modes < least:
        raise ValueError(
            f"{modes} {kind} modes asked for, but {ends} ends have {len(known[ends].static)} static shapes; "
            f"ask for at least {least}"
        )
    return known[ends]


def _orthogonal(choice: EndShapes, own: ShapeFunctions, values: Array, panels: int, order: int) -> OrthogonalShapes:
    """Shapes of largest value 1 that are orthogonal in mass and stiffness, and their eigenvalues, ascending.

    values: eigenvalues of the modes `own`. Cubics do no work on the modes between held ends, so the stiffness
    int phi_a^(order) phi_b^(order) has two diagonal blocks.
    """
    functions = own
    if choice.static:
        static = polynomials(list(choice.static))
        functions = static.beside(own)
        xi, mu = gauss_points(panels)
        phi, strain = functions.at(xi), static.at(xi, order)
        mass = phi.T @ (mu[:, None] * phi)
        split = static.count
        stiffness = np.diag(np.concatenate([np.zeros(split), values * np.diag(mass)[split:]]))
        stiffness[:split, :split] = strain.T @ (mu[:, None] * strain)
        if not choice.apart:
            stiffness[:split, split:] = strain.T @ (mu[:, None] * functions.at(xi, order)[:, split:])
            stiffness[split:, :split] = stiffness[:split, split:].T
        inverse = np.linalg.inv(np.linalg.cholesky(mass))
        reduced = inverse @ stiffness @ inverse.T
        values, vectors = np.linalg.eigh(0.5 * (reduced + reduced.T))
        functions = functions.mixed(inverse.T @ vectors)
    return OrthogonalShapes(functions.mixed(np.diag(_scales(functions, panels))), values)


def _grid(panels: int) -> Array:
    return np.linspace(0.0, 1.0, GRID * panels + 1)


def _scales(functions: ShapeFunctions, panels: int) -> Array:
    """Factors (n,) that make the largest value 1 and the first one above 1e-6 of it positive."""
    xi = _grid(panels)
    phi = functions.at(xi)
    each = np.arange(functions.count)
    place = xi[np.argmax(np.abs(phi), axis=0)]
    inside = (place > 0.0) & (place < 1.0)
    for _ in range(POLISHING):
        rate, bend = (np.diagonal(functions.at(place, order)) for order in (1, 2))
        place = np.where(inside, place - rate / np.where(inside, bend, 1.0), place)
    largest = np.abs(functions.at(place)[each, each])
    first = np.argmax(np.abs(phi) > SIGN_THRESHOLD * largest, axis=0)
    return np.asarray(np.sign(phi[first, each]) / largest)
