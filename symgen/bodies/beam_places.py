"""Points of a beam that are no markers: means over a part of it, and places that move."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Protocol, TypeVar

import casadi as ca
import numpy as np

from runtime.contract.flexible import ShapeFunctions, gauss_points, panels_for
from symgen.algebra.parameters import ParameterTable
from symgen.algebra.scalar import ZERO, add, mul
from symgen.algebra.vectors import Vector, zeros
from symgen.bodies.beam_sets import mode_sets, set_choices
from symgen.bodies.shape_integrals import PointShape
from symgen.bodies.spatial_moments import SpatialPoint
from symgen.modes.beam import TORSION, TURN
from symgen.scene import BeamBody

Point = TypeVar("Point", covariant=True)


class _Points(Protocol[Point]):
    def point(self, at: float) -> Point:
        """Shapes at a fraction of the length."""


def stations(body: BeamBody, start: float, end: float) -> tuple[np.ndarray, np.ndarray]:
    """Gauss points and weights on a part of the length: products of shapes are integrated to rounding."""
    panels = panels_for(max((one.modes for one in set_choices(body)), default=1))
    xi, weights = gauss_points(panels, end - start)
    return start + xi, weights


def mean_point(data: _Points[Any], xi: np.ndarray, weights: np.ndarray) -> Any:
    """The mean of the shapes at points of a beam by weights; H and deflections are linear in them."""
    points = [data.point(float(at)) for at in xi]
    share = weights / weights.sum()
    cls = type(points[0])
    values = {}
    for one in fields(cls):
        mean = sum(w * getattr(point, one.name) for w, point in zip(share, points, strict=True))
        size = max((float(np.abs(getattr(point, one.name)).max(initial=0.0)) for point in points), default=0.0)
        values[one.name] = np.where(np.abs(mean) < 1e-13 * size, 0.0, mean)
    return cls(**values)


@dataclass(frozen=True)
class MovingPlace:
    """A place x = L xi on a beam, as SX: of each set of modes its axis and the values there.

    sets: (axis, first mode, phi, dphi/dxi, d2phi/dxi2).
    """

    length: ca.SX
    xi: ca.SX
    sets: list[tuple[int, int, list[ca.SX], list[ca.SX], list[ca.SX]]]


def moving_place(body: BeamBody, place: ca.SX, table: ParameterTable) -> MovingPlace:
    """At `place` [m] from the start of a beam."""
    length = table.of(body, "length")
    xi, sets, first = place / length, [], 0
    for (axis, modes), choice in zip(mode_sets(body), set_choices(body), strict=True):
        key = f"beam/{axis}-{choice.ends}{choice.modes}"
        value, rate, second = (_values(modes.functions, xi, order, key, table) for order in range(3))
        sets.append((axis, first, value, rate, second))
        first += modes.modes
    return MovingPlace(length, xi, sets)


def _values(functions: ShapeFunctions, xi: ca.SX, order: int, key: str, table: ParameterTable) -> list[ca.SX]:
    """d^order phi / d xi^order of each shape; the numbers of the shapes are data in p."""
    meaning = "shapes along the beam"
    powers = table.data(functions.powers, f"{key}.powers", "1", meaning)
    numbers = table.data(functions.wave_numbers[None, :], f"{key}.wave_numbers", "1", meaning)
    waves = table.data(functions.waves.reshape(-1, functions.count), f"{key}.waves", "1", meaning)
    basis: list[ca.SX] = []
    for k in range(len(functions.wave_numbers)):
        b = numbers[0, k]
        phase, scale = mul(b, xi), b**order if order else ca.SX(1)
        turns = ((ca.cos(phase), ca.sin(phase)), (-ca.sin(phase), ca.cos(phase)), (-ca.cos(phase), -ca.sin(phase)))
        cosine, sine = turns[order]
        sign = ca.SX(-1.0 if order == 1 else 1.0)
        basis += [scale * cosine, scale * sine, scale * sign * ca.exp(-phase), scale * ca.exp(phase - b)]
    found = []
    for a in range(functions.count):
        value = ZERO
        for power in range(order, powers.shape[0]):
            factor = float(np.prod(np.arange(power - order + 1, power + 1)))
            value = add(value, mul(powers[power, a], factor * xi ** (power - order)))
        for row, entry in enumerate(basis):
            if not waves[row, a].is_zero():
                value = add(value, mul(waves[row, a] + ZERO, entry))
        found.append(value)
    return found


def frame_shape(nf: int) -> PointShape:
    """The origin of a planar beam's frame, which does not bend."""
    return PointShape(ca.SX(2, 1), ca.SX(0), ca.SX(2, nf), ca.SX(nf, 1), ca.SX(nf, nf))


def place_shape(nf: int, place: MovingPlace) -> PointShape:
    """The point of a planar beam at a place that moves."""
    Phi, slope = ca.SX(2, nf), ca.SX(nf, 1)
    for axis, first, values, rates, _ in place.sets:
        for a, (value, rate) in enumerate(zip(values, rates, strict=True), start=first):
            Phi[axis, a] = value
            if axis == 1:
                slope[a] = rate / place.length
    return PointShape(ca.vertcat(place.length * place.xi, 0), ca.SX(0), Phi, slope, ca.SX(nf, nf))


def frame_point(nf: int) -> SpatialPoint:
    """The origin of a beam's frame in space, which does not bend."""
    return _unturned(zeros(), [zeros() for _ in range(nf)], [zeros() for _ in range(nf)])


def place_point(nf: int, place: MovingPlace) -> SpatialPoint:
    """The point of a beam in space at a place that moves."""
    shapes, turns = ([zeros() for _ in range(nf)] for _ in range(2))
    for axis, first, values, rates, _ in place.sets:
        for a, (value, rate) in enumerate(zip(values, rates, strict=True), start=first):
            if axis == TORSION:
                turns[a][0] = value
                continue
            shapes[a][axis] = value
            if axis in TURN:
                about, sign = TURN[axis]
                turns[a][about] = sign * rate / place.length
    return _unturned([place.length * place.xi, ZERO, ZERO], shapes, turns)


def _unturned(position: Vector, shapes: list[Vector], turns: list[Vector]) -> SpatialPoint:
    axes = [[ca.SX(float(i == j)) for j in range(3)] for i in range(3)]
    return SpatialPoint(position, shapes, turns, [], axes, [ca.SX(1), ZERO, ZERO, ZERO])
