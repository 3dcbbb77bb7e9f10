"""The paper's planar beam: a mesh of beam elements with masses lumped at its nodes (Eqs. 15-20).

Cubic elements without rotary inertia bend; the rotations, which have no mass, follow statically from the
deflections (static condensation, Guyan). Stretching is that of bars. The integrals of Eq. 20 are sums over the
nodes. Shapes in closed form, what a beam has otherwise, are the limit: frequencies converge with the square of the
elements.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, cast

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from symgen.scene.bodies import BeamBody
from symgen.scene.flexible import Foreshortening, ModalBody, ModalMarker
from symgen.schema.fields import Fault

Array = NDArray[np.float64]
HELD = {"free": (), "pinned": (0,), "clamped": (0, 1)}  # of deflection and slope at an end
RIGID = {"free-free": 2, "pinned-free": 1, "free-pinned": 1}  # motions without strain, which the frame has
DEFAULT_ENDS = "pinned-pinned"
GAUSS = np.polynomial.legendre.leggauss(4)


def lumped_mesh_faults(beam: BeamBody, space: str) -> Iterator[Fault]:
    """What a lumped mesh cannot have."""
    if space == "spatial":
        remedy = 'take FlexibleBody.from_mesh(LineMesh(...), mass="lumped") of symgen.fe'
        yield Fault("mesh", "a lumped mesh of a beam is planar", remedy)
    if beam.elements is None:
        yield Fault("elements", "is missing", "give the number of elements, 20 for instance")
        return
    numbers = ("length", "density", "area", "second_moment", "youngs_modulus", "damping_ratio", "damping_frequency")
    for key in numbers:
        if isinstance(getattr(beam, key), str):
            remedy = "give a number, or leave mesh out: shapes in closed form follow parameters"
            yield Fault(key, "is not a number, which the shapes of a mesh need", remedy)
    if beam.lateral is not None:
        yield from _ends_fault("lateral", beam.lateral.ends, beam.lateral.modes, beam.elements)
    if beam.axial is not None:
        yield from _ends_fault("axial", beam.axial.ends, beam.axial.modes, beam.elements)


def _ends_fault(key: str, ends: str | None, count: int, elements: int) -> Iterator[Fault]:
    known = {"lateral": HELD, "axial": {"free": (), "fixed": (0,)}}[key]
    parts = (ends or (DEFAULT_ENDS if key == "lateral" else "fixed-free")).split("-")
    if any(one not in known for one in parts):
        remedy = f"take two of {', '.join(known)}, or leave mesh out"
        yield Fault(f"{key}.ends", f"'{ends}' has static shapes, which a mesh has not", remedy)
        return
    massive = elements + 1 - sum(bool(known[one]) for one in parts)
    rigid = RIGID.get("-".join(parts), 0) if key == "lateral" else int(parts == ["free", "free"])
    if count > massive - rigid:
        yield Fault(f"{key}.modes", f"{count} are more than the {massive - rigid} of the mesh", "give more elements")


def lumped_beam(beam: BeamBody) -> ModalBody:
    """The modal body (Eqs. 15-20) of a beam with `mesh = "lumped"` whose faults were looked for.

    q_f: bending modes, then those of stretching, each mass-orthonormal.
    """
    mesh = _Mesh(beam)
    w, slope, bending = mesh.bending()
    u, pulled = mesh.stretching()
    values = np.concatenate([bending, pulled])
    nf, n_w = len(values), len(bending)
    phi_x, phi_y = np.zeros((len(mesh.x), nf)), np.zeros((len(mesh.x), nf))
    phi_x[:, n_w:], phi_y[:, :n_w] = u, w
    slopes = np.zeros_like(phi_y)
    slopes[:, :n_w] = slope
    m, x = mesh.masses, mesh.x
    cross = np.einsum("k,ka,kb->ab", m, phi_x, phi_y)
    omega = np.sqrt(values)
    ratio = float(beam.damping_ratio)
    damping = 2 * ratio * (omega if beam.damping_frequency is None else values / float(beam.damping_frequency))
    shortened = None
    if beam.stiffening:
        H = np.stack([mesh.shortening(phi_y, slopes, at) for at in x])
        shortened = Foreshortening(H=_rows(np.einsum("k,kab->ab", m, H)), xH=_rows(np.einsum("k,kab->ab", m * x, H)))
    places = {**beam.implicit_markers(), **beam.markers}
    return ModalBody(
        name=beam.name,
        mass=float(m.sum()),
        first_moment=(float(m @ x), 0.0),
        inertia=float(m @ x**2),
        M_ff=_rows(phi_x.T @ (m[:, None] * phi_x) + phi_y.T @ (m[:, None] * phi_y)),
        K_ff=_rows(np.diag(values)),
        D_ff=_rows(np.diag(damping)),
        phi_integral=_rows(np.stack([m @ phi_x, m @ phi_y])),
        rho_dot_phi=_row((m * x) @ phi_x),
        rho_cross_phi=_row((m * x) @ phi_y),
        phi_cross_phi=_rows(cross - cross.T),
        foreshortening=shortened,
        free=beam.free,
        markers={
            name: mesh.marker(float(one.at), one.angle, phi_x, phi_y, slopes, beam.stiffening)
            for name, one in places.items()
        },
    )


class _Mesh:
    """Equal elements of a beam: places x (n,) [m] and masses (n,) [kg] of the nodes."""

    def __init__(self, beam: BeamBody) -> None:
        self.beam, self.elements = beam, cast(int, beam.elements)
        self.h = float(beam.length) / self.elements
        self.x = np.linspace(0.0, float(beam.length), self.elements + 1)
        self.masses = np.full(self.elements + 1, float(beam.density) * float(beam.area) * self.h)
        self.masses[[0, -1]] /= 2

    def bending(self) -> tuple[Array, Array, Array]:
        """Deflections and slopes of the nodes (n, modes), and eigenvalues [rad^2/s^2]."""
        n, chosen = len(self.x), self.beam.lateral
        if chosen is None:
            return np.zeros((n, 0)), np.zeros((n, 0)), np.zeros(0)
        K, h = np.zeros((2 * n, 2 * n)), self.h
        block = np.array(
            [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h],
             [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]]
        )  # fmt: skip
        stiffness = float(self.beam.youngs_modulus) * float(self.beam.second_moment) / h**3
        for e in range(self.elements):
            K[2 * e : 2 * e + 4, 2 * e : 2 * e + 4] += stiffness * block
        ends = chosen.ends or DEFAULT_ENDS
        start, end = ends.split("-")
        held = {*HELD[start], *(2 * (n - 1) + k for k in HELD[end])}
        moving = [row for row in range(0, 2 * n, 2) if row not in held]
        turning = [row for row in range(1, 2 * n, 2) if row not in held]
        follow = -np.linalg.solve(K[np.ix_(turning, turning)], K[np.ix_(turning, moving)])
        condensed = K[np.ix_(moving, moving)] + K[np.ix_(moving, turning)] @ follow
        found = np.zeros((2 * n, chosen.modes))
        values, shapes = self._lowest(condensed, [row // 2 for row in moving], chosen.modes, RIGID.get(ends, 0))
        found[moving], found[turning] = shapes, follow @ shapes
        return found[::2], found[1::2], values

    def stretching(self) -> tuple[Array, Array]:
        """Displacements along the beam of the nodes (n, modes), and eigenvalues [rad^2/s^2]."""
        n, chosen = len(self.x), self.beam.axial
        if chosen is None:
            return np.zeros((n, 0)), np.zeros(0)
        K = np.zeros((n, n))
        stiffness = float(self.beam.youngs_modulus) * float(self.beam.area) / self.h
        for e in range(self.elements):
            K[e : e + 2, e : e + 2] += stiffness * np.array([[1.0, -1.0], [-1.0, 1.0]])
        start, end = (chosen.ends or "fixed-free").split("-")
        moving = list(range(start == "fixed", n - (end == "fixed")))
        found = np.zeros((n, chosen.modes))
        rigid = int(start == end == "free")
        values, found[moving] = self._lowest(K[np.ix_(moving, moving)], moving, chosen.modes, rigid)
        return found, values

    def _lowest(self, K: Array, nodes: list[int], count: int, rigid: int) -> tuple[Array, Array]:
        """Eigenvalues and mass-orthonormal shapes, the last entry that is not small positive."""
        wanted = (rigid, rigid + count - 1)
        values, shapes = la.eigh(K, np.diag(self.masses[nodes]), subset_by_index=wanted)
        for shape in shapes.T:
            shape *= np.sign(shape[np.flatnonzero(np.abs(shape) > 1e-6 * np.abs(shape).max())[-1]])
        return values, shapes

    def element(self, place: float) -> tuple[int, float]:
        """The element at a place [m], and where in it, 0 to 1."""
        e = min(int(place / self.h * (1 + 1e-12)), self.elements - 1)
        return e, place / self.h - e

    def shortening(self, phi_y: Array, slopes: Array, place: float) -> Array:
        """H = int_0^x w_a' w_b' dx up to a place [m]."""
        last, share = self.element(place)
        found = np.zeros((phi_y.shape[1], phi_y.shape[1]))
        for e in range(last + 1):
            end = share if e == last else 1.0
            for point, weight in zip(*GAUSS, strict=True):
                s = 0.5 * end * (1 + point)
                rates = self._slope(phi_y, slopes, e, s)
                found += 0.5 * end * weight * self.h * np.outer(rates, rates)
        return found

    def _slope(self, phi_y: Array, slopes: Array, e: int, s: float) -> Array:
        w = (6 * s * s - 6 * s) / self.h * (phi_y[e] - phi_y[e + 1])
        return np.asarray(w + (1 - 4 * s + 3 * s * s) * slopes[e] + (3 * s * s - 2 * s) * slopes[e + 1])

    def marker(self, at: float, angle: Any, phi_x: Array, phi_y: Array, slopes: Array, stiffening: bool) -> ModalMarker:
        """A point at a fraction of the length, between nodes by the shape functions of its element."""
        place = at * float(self.beam.length)
        e, s = self.element(place)
        a, b = 1 - 3 * s * s + 2 * s**3, 3 * s * s - 2 * s**3
        c, d = self.h * (s - 2 * s * s + s**3), self.h * (s**3 - s * s)
        return ModalMarker(
            position=(place, 0.0),
            angle=angle,
            shape_x=_row((1 - s) * phi_x[e] + s * phi_x[e + 1]),
            shape_y=_row(a * phi_y[e] + b * phi_y[e + 1] + c * slopes[e] + d * slopes[e + 1]),
            slope=_row(self._slope(phi_y, slopes, e, s)),
            foreshortening=_rows(self.shortening(phi_y, slopes, place)) if stiffening else None,
        )


def _row(values: Array) -> tuple[float, ...]:
    return tuple(float(value) for value in values)


def _rows(values: Array) -> tuple[tuple[float, ...], ...]:
    return tuple(_row(row) for row in values)
