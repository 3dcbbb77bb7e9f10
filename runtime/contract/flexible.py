"""Flexible bodies as both halves mean them: shapes of uniform beams in closed form, what moves a body and acts on it,
and the unit causes of its stresses.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

# Shapes in closed form: polynomials and the eigenfunctions of a uniform beam, with all their derivatives.

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ShapeFunctions:
    """n shapes phi_a(xi) on [0, 1]: a polynomial plus waves cos, sin and exponentials that decay from either end.

    powers (p, n): coefficients of 1, xi, xi^2, ...  wave_numbers (k,).  waves (k, 4, n): coefficients of cos b xi,
    sin b xi, exp(-b xi) and exp(-b (1 - xi)) for each wave number b. The exponentials never grow, so that high modes
    are as exact as low ones.
    """

    powers: Array
    wave_numbers: Array
    waves: Array

    @property
    def count(self) -> int:
        """Number of shapes."""
        return int(self.powers.shape[1])

    def at(self, xi: Array, order: int = 0) -> Array:
        """d^order phi / d xi^order at the points xi (k,), shape (k, n)."""
        points = np.asarray(xi, dtype=float)
        raised = np.zeros((len(points), len(self.powers)))
        for power in range(order, len(self.powers)):
            factor = float(np.prod(np.arange(power - order + 1, power + 1)))
            raised[:, power] = factor * points ** (power - order)
        b, phase = self.wave_numbers, points[:, None] * self.wave_numbers
        turned = phase + order * (np.pi / 2)
        decays = (-1.0) ** order * np.exp(-phase), np.exp(phase - b)
        basis = np.stack([np.cos(turned), np.sin(turned), *decays], axis=-1) * (b**order)[:, None]
        return raised @ self.powers + basis.reshape(len(points), -1) @ self.waves.reshape(-1, self.count)

    def mixed(self, combination: Array) -> ShapeFunctions:
        """Shapes that are combinations of these: combination (n, m) has a column for each new one."""
        return ShapeFunctions(self.powers @ combination, self.wave_numbers, self.waves @ combination)

    def beside(self, other: ShapeFunctions) -> ShapeFunctions:
        """These shapes, then the others."""
        waves = np.zeros((len(self.wave_numbers) + len(other.wave_numbers), 4, self.count + other.count))
        waves[: len(self.wave_numbers), :, : self.count] = self.waves
        waves[len(self.wave_numbers) :, :, self.count :] = other.waves
        numbers = np.concatenate([self.wave_numbers, other.wave_numbers])
        highest = max(len(self.powers), len(other.powers))
        both = [np.pad(one, ((0, highest - len(one)), (0, 0))) for one in (self.powers, other.powers)]
        return ShapeFunctions(np.hstack(both), numbers, waves)


def polynomials(rows: Sequence[Sequence[float]]) -> ShapeFunctions:
    """Polynomials by their coefficients of 1, xi, xi^2, ...; all of them have as many."""
    return ShapeFunctions(np.array(rows, dtype=float).T, np.zeros(0), np.zeros((0, 4, len(rows))))


_gauss = cache(lambda: np.polynomial.legendre.leggauss(12))  # most runs take none


def gauss_points(panels: int, end: float = 1.0) -> tuple[Array, Array]:
    """Points and weights on [0, end]: 12 Gauss points in each of `panels` parts.

    A product of two waves of at most half a period a part is integrated to rounding.
    """
    (points, weights), size = _gauss(), end / panels
    starts = size * np.arange(panels)[:, None]
    return (starts + 0.5 * size * (1.0 + points)).ravel(), np.tile(0.5 * size * weights, panels)


# Which shapes a beam's ends ask for: static shapes of loaded ends and the modes between held ends (Craig-Bampton).
#
# A force or a moment at an end bends the beam into a cubic. Modes of free vibration alone have no moment (or no force)
# at a free end and so add up to that cubic very slowly; with the cubic among the shapes the static answer is exact,
# and
# the modes with the loaded ends held add what inertia bends.

Polynomial = tuple[float, ...]  # coefficients of 1, xi, xi^2, ...


@dataclass(frozen=True)
class EndShapes:
    """static: shapes of unit displacements of the loaded ends. start, end: how the ends of the modes are held.

    apart: do the static shapes do no work on the modes? So it is with cubics.
    """

    static: tuple[Polynomial, ...]
    start: str
    end: str
    apart: bool = True


def bent_by_inertia(cubic: Polynomial, value: float) -> Polynomial:
    """The cubic with what its own inertia adds at the squared frequency `value` (rho A L^4 / E I), ends clamped.

    c + value psi: the fourth derivative of psi is c, psi and its slope are zero at both ends. A little less stiff in
    motion, and at rest too stiff in the second order of value.
    """
    psi = [0.0] * 4 + [c / ((k + 1) * (k + 2) * (k + 3) * (k + 4)) for k, c in enumerate(cubic)]
    deflection, slope = sum(psi), sum(k * p for k, p in enumerate(psi))
    psi[2], psi[3] = slope - 3.0 * deflection, 2.0 * deflection - slope
    return tuple(c + value * p for c, p in zip((*cubic, 0.0, 0.0, 0.0, 0.0), psi, strict=True))


DEFLECTION, SLOPE = (0.0, 0.0, 3.0, -2.0), (0.0, 0.0, -1.0, 1.0)
INERTIA = 3.5  # loads to 0.07 %, tip masses from a tenth of the beam's mass on to 0.1 %

# "welded" ends carry a force and a moment, "pinned" ends a force. Deflection and slope of a welded start are zero; of
# a pinned start the deflection is, and then that of the end where there is something (else the mean rotation).
# A "heavy" end is a welded one whose two shapes also serve the beam's own inertia.
BENDING: dict[str, EndShapes] = {
    "welded-welded": EndShapes((DEFLECTION, SLOPE), "clamped", "clamped"),
    "welded-heavy": EndShapes(
        (bent_by_inertia(DEFLECTION, INERTIA), bent_by_inertia(SLOPE, INERTIA)), "clamped", "clamped", apart=False
    ),
    "welded-pinned": EndShapes(((0.0, 0.0, 1.5, -0.5),), "clamped", "pinned"),
    "pinned-welded": EndShapes(((0.0, -0.5, 0.0, 0.5),), "pinned", "clamped"),
    **{
        f"{start}-{end}": EndShapes((), start, end)
        for start, end in (
            ("pinned", "pinned"),
            ("clamped", "free"),
            ("free", "clamped"),
            ("free", "free"),
            ("pinned", "free"),
            ("free", "pinned"),
            ("clamped", "pinned"),
            ("clamped", "clamped"),
        )
    },
}
STRETCHING: dict[str, EndShapes] = {
    "fixed-loaded": EndShapes(((0.0, 1.0, 0.0, 0.0),), "fixed", "fixed"),
    **{f"{a}-{b}": EndShapes((), a, b) for a in ("fixed", "free") for b in ("fixed", "free")},
}


# Eigenfunctions of a uniform beam and of a uniform bar in closed form, by the way their ends are held (Eq. 19).

# end -> orders of the derivatives that vanish there
BENDING_CONDITIONS = {"clamped": (0, 1), "pinned": (0, 2), "free": (2, 3)}
ROOT_STEPS = 12


def bending_functions(start: str, end: str, count: int) -> ShapeFunctions:
    """First `count` elastic bending eigenfunctions, phi'''' = b^4 phi, in any scale; frequencies are b^2.

    start, end: "clamped", "pinned" or "free"; rigid motions are left out.
    """
    numbers = bending_wave_numbers(start, end, count)
    waves = np.zeros((count, 4, count))
    for k, b in enumerate(numbers):
        rows = [_values(b, 0.0, order) for order in BENDING_CONDITIONS[start]]
        rows += [_values(b, 1.0, order) for order in BENDING_CONDITIONS[end]]
        waves[k, :, k] = np.linalg.svd(np.array(rows))[2][-1]
    return ShapeFunctions(np.zeros((4, count)), numbers, waves)


def bending_wave_numbers(start: str, end: str, count: int) -> Array:
    """Roots b (count,) of the frequency equation, ascending, by Newton's method from their asymptotes."""
    n, ends = np.arange(1, count + 1), {start, end}
    if ends == {"pinned"}:
        return np.asarray(np.pi * n, dtype=np.float64)
    if "pinned" in ends:  # tan b = tanh b
        b = (n + 0.25) * np.pi
        for _ in range(ROOT_STEPS):
            b = b - (np.sin(b) - np.cos(b) * np.tanh(b)) / (
                np.cos(b) + np.sin(b) * np.tanh(b) - np.cos(b) / np.cosh(np.minimum(b, 300.0)) ** 2
            )
        return np.asarray(b, dtype=np.float64)
    sign = 1.0 if len(ends) == 1 else -1.0  # cos b cosh b = 1 for equal ends, -1 for clamped and free
    b = (n + 0.5 * sign) * np.pi
    for _ in range(ROOT_STEPS):
        small = sign / np.cosh(np.minimum(b, 300.0))
        b = b - (np.cos(b) - small) / (-np.sin(b) + small * np.tanh(b))
    return np.asarray(b, dtype=np.float64)


def _values(b: float, xi: float, order: int) -> list[float]:
    """Derivatives of the four waves at xi, over b^order."""
    turned = b * xi + order * np.pi / 2
    return [np.cos(turned), np.sin(turned), (-1.0) ** order * np.exp(-b * xi), np.exp(-b * (1.0 - xi))]


def stretching_functions(start: str, end: str, count: int) -> ShapeFunctions:
    """First `count` elastic longitudinal eigenfunctions, u'' = -b^2 u, of ends "fixed" or "free"; frequencies are b."""
    same = start == end
    numbers = np.asarray(np.pi * (np.arange(1, count + 1) - (0.0 if same else 0.5)), dtype=np.float64)
    waves = np.zeros((count, 4, count))
    waves[np.arange(count), 1 if start == "fixed" else 0, np.arange(count)] = 1.0
    return ShapeFunctions(np.zeros((4, count)), numbers, waves)


# Shapes of a beam's mode set in closed form, orthogonal in mass and stiffness, by the names of its ends (Eq. 19).

FEWEST_PANELS = 8
POINTS_OF_PANEL = 16  # points a panel among which the largest value of a shape is sought
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
    return np.linspace(0.0, 1.0, POINTS_OF_PANEL * panels + 1)


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


# What moved a flexible body and what acted on it, as the recovery of its stresses takes it.


@dataclass(frozen=True, eq=False)
class MarkerForce:
    """A force and moment (N, 6) [N, N m] at a marker, in body axes; position (3,) [m] of the marker while unbent.

    The moment is about the place of the marker in the bent body.
    """

    marker: str
    position: np.ndarray
    wrench: np.ndarray


@dataclass(frozen=True, eq=False)
class BodyMotion:
    """N samples of a flexible body, vectors in its own axes.

    t (N,) [s]; q_f, q_f_dot, q_f_ddot (N, nf); acceleration (N, 3) [m/s^2] of the frame's origin less gravity; omega
    [rad/s], alpha [rad/s^2] (N, 3); forces: of the joints and loads on it, one for each.
    """

    body: str
    t: np.ndarray
    q_f: np.ndarray
    q_f_dot: np.ndarray
    q_f_ddot: np.ndarray
    acceleration: np.ndarray
    omega: np.ndarray
    alpha: np.ndarray
    forces: list[MarkerForce] = field(default_factory=list)

    def field(self) -> np.ndarray:
        """(N, 3, 3) G = alpha~ + omega~ omega~: the acceleration of a point at rest in the frame is a_o + G rho."""
        return spin_field(self.omega, self.alpha)


def spin_field(omega: np.ndarray, alpha: np.ndarray) -> np.ndarray:
    """(N, 3, 3) alpha~ + omega~ omega~."""
    turning = cross_matrix(omega)
    return np.asarray(cross_matrix(alpha) + turning @ turning)


def cross_matrix(v: np.ndarray) -> np.ndarray:
    """(N, 3, 3) with cross_matrix(v) w = v x w, for v (N, 3)."""
    found = np.zeros((len(v), 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        found[:, k, j], found[:, j, k] = v[:, i], -v[:, i]
    return found


# What loads a flexible body at each moment, as amounts of unit causes: mode acceleration with inertia relief.
#
# The inertia forces -M a of the acceleration of its points, less its rigid part, and the forces at its interfaces:
#
#     a = a_o + G rho0 + sum_a G_a phi_a,   G = alpha~ + omega~ omega~,  G_a = G q_a + 2 omega~ q_a' + 1 q_a''
#
# All of it is linear in 9 fields x_i e_j (i slowest), 9 nf fields phi_a,i e_j (a slowest, then i), and the forces and
# moments (6) of each interface. Weight and a_o are rigid: they load nothing.

INTERFACE_PLACE = 1e-9  # of the size of the body: a marker of another name there stands for the interface


class UnknownInterface(Exception):
    """Forces act at a marker that stands for no interface; its argument is the marker's name."""


def causes(motion: BodyMotion, interfaces: Mapping[str, np.ndarray], size: float) -> np.ndarray:
    """(N, 9 + 9 nf + 6 interfaces) amounts of the unit causes; interfaces: name -> position (3,) [m].

    size [m]: of the body. Raises UnknownInterface.
    """
    G, turning = motion.field(), 2.0 * cross_matrix(motion.omega)
    modes = (
        motion.q_f[:, :, None, None] * G[:, None]
        + motion.q_f_dot[:, :, None, None] * turning[:, None]
        + motion.q_f_ddot[:, :, None, None] * np.eye(3)
    )
    N = len(motion.t)
    forces = {name: np.zeros((N, 6)) for name in interfaces}
    for one in motion.forces:
        forces[_interface(one.marker, one.position, interfaces, size)] += one.wrench
    fields = [-G.transpose(0, 2, 1).reshape(N, -1), -modes.transpose(0, 1, 3, 2).reshape(N, -1)]
    return np.hstack([*fields, *forces.values()])


def _interface(marker: str, position: np.ndarray, interfaces: Mapping[str, np.ndarray], size: float) -> str:
    """The interface that a marker stands for: of its name, else at its place."""
    if marker in interfaces:
        return marker
    for name, place in interfaces.items():
        if np.abs(place - position).max() <= INTERFACE_PLACE * size:
            return name
    raise UnknownInterface(marker)
