"""Planar mechanisms from their material points, in absolute coordinates with multipliers: no part of the generator.

Nothing is known of a body but where its points are. Each has R_x, R_y, theta and, if it bends, modal coordinates q_f:

    r(s) = R + A(theta) (L s + psi(s) q_f - q_f^T H(s) q_f / 2, phi(s) q_f),    H(s) = 1/L int_0^s phi'^T phi' ds

Kinetic energy T is a sum over points of a Gauss quadrature, potential V one of weights and curvatures; where bending
shortens a beam (H), T is cut after second order in (q_f, q_f') by differentiating T(e q_f, e q_f') twice by e.
Lagrange's equations of the first kind follow by automatic differentiation,

    M a + C_q^T lam = dT/dq - dV/dq - (d^2 T/dv dq) v + Q,    C'' = -2 alpha C' - alpha^2 C

with Baumgarte's terms, and DOP853 integrates (q, v). Shapes, quadratures and frequencies are computed here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

GAUSS, PANELS = 8, 6  # points a panel, panels a beam: shapes of five half waves to rounding
ALPHA = 20.0  # 1/s, of Baumgarte's terms
Array = np.ndarray
Shapes = Callable[[Array], tuple[Array, Array, Array]]  # s -> values, d/ds, d^2/ds^2, (modes, points)


def sines(modes: int) -> Shapes:
    """sin(k pi s)."""
    k = np.pi * np.arange(1, modes + 1)[:, None]
    return lambda s: (np.sin(k * s), k * np.cos(k * s), -(k**2) * np.sin(k * s))


def cantilever(modes: int) -> Shapes:
    """Clamped at 0, free at 1: roots of cosh b cos b = -1, largest value 1, positive beside the clamp."""
    odd = np.pi * (np.arange(modes) + 0.5)
    b = np.array([brentq(lambda x: np.cos(x) + 1 / np.cosh(x), one - 0.5, one + 0.5, xtol=1e-15) for one in odd])[
        :, None
    ]
    rest = (np.sin(b) - np.cos(b) - np.exp(-b)) / (np.sinh(b) + np.sin(b))  # 1 - sigma, without cancellation
    sigma = 1.0 - rest

    def at(s: Array) -> tuple[Array, Array, Array]:
        grow, fall, c, n = rest / 2 * np.exp(b * s), (1 + sigma) / 2 * np.exp(-b * s), np.cos(b * s), np.sin(b * s)
        values = (
            grow + fall - c + sigma * n,
            b * (grow - fall + n + sigma * c),
            b**2 * (grow + fall + c - sigma * n),
        )
        return values[0] / 2, values[1] / 2, values[2] / 2

    return at


def quadrature(end: float = 1.0) -> tuple[Array, Array]:
    """Points and weights on [0, end]."""
    x, w = np.polynomial.legendre.leggauss(GAUSS)
    edges = np.linspace(0.0, end, PANELS + 1)
    half = np.diff(edges) / 2
    points = (edges[:-1] + half)[:, None] + half[:, None] * x
    return points.ravel(), (half[:, None] * w).ravel()


@dataclass(frozen=True)
class Beam:
    """length [m], mass a length [kg/m], E I [N m^2]; along: shapes along the beam and their stiffness [N/m]."""

    length: float
    line_mass: float
    bending: float
    shapes: Shapes
    shortens: bool = False
    damping_ratio: float = 0.0
    along: tuple[Shapes, Array] | None = None
    turning: float = 0.0  # kg m^2, of the sections
    false_mass: Array | None = None  # of q_f, beside that of the points [kg]


class Points:
    """A mechanism that grows body by body and joint by joint; coordinates are named `body.x`, `body.q1`, ..."""

    def __init__(self, gravity: float = 0.0) -> None:
        self.gravity, self.names = gravity, list[str]()
        self.q, self.v, self.t = list[ca.SX](), list[ca.SX](), ca.SX.sym("t")
        self.T, self.V, self.Q = ca.SX(0), ca.SX(0), dict[str, ca.SX]()
        self.constraints: list[ca.SX] = []
        self.places: dict[str, Callable[[float], ca.SX]] = {}

    def _coordinates(self, body: str, names: Sequence[str]) -> tuple[ca.SX, ca.SX]:
        q, v = ca.SX.sym(f"{body}_q", len(names)), ca.SX.sym(f"{body}_v", len(names))
        self.names += [f"{body}.{name}" for name in names]
        self.q, self.v = [*self.q, q], [*self.v, v]
        return q, v

    def __getitem__(self, name: str) -> ca.SX:
        return ca.vertcat(*self.q)[self.names.index(name)]

    def rate(self, name: str) -> ca.SX:
        """Of a coordinate."""
        return ca.vertcat(*self.v)[self.names.index(name)]

    def rigid(self, body: str, mass: float, inertia: float, center: float = 0.0) -> None:
        """Centre of mass on its x-axis; places are along it [m]."""
        q, v = self._coordinates(body, ("x", "y", "theta"))
        self.places[body] = lambda at: q[:2] + at * ca.vertcat(ca.cos(q[2]), ca.sin(q[2]))
        r = self.places[body](center)
        velocity = ca.jtimes(r, q, v)
        self.T += (mass * ca.sumsqr(velocity) + inertia * v[2] ** 2) / 2
        self.V += mass * self.gravity * r[1]

    def beam(self, body: str, beam: Beam) -> None:
        """Places are fractions of its length."""
        s, weights = quadrature()
        phi, _, curvature = beam.shapes(s)
        bends, stretches = len(phi), 0 if beam.along is None else len(beam.along[1])
        nf = bends + stretches
        q, v = self._coordinates(body, ("x", "y", "theta", *(f"q{k + 1}" for k in range(nf))))
        q_f, v_f, w = q[3:], v[3:], q[3 : 3 + bends]

        def place(at: float) -> ca.SX:
            values = np.array([float(one) for one in beam.shapes(np.array([at]))[0][:, 0]])
            x, y = ca.SX(beam.length * at), ca.dot(ca.DM(values), w)
            if beam.along is not None:
                x = x + ca.dot(ca.DM(beam.along[0](np.array([at]))[0][:, 0]), q_f[bends:])
            if beam.shortens:
                inner, parts = quadrature(at) if at > 0 else (np.zeros(1), np.zeros(1))
                slope = beam.shapes(inner)[1]
                x = x - ca.bilin(ca.DM((slope * parts) @ slope.T / beam.length), w, w) / 2
            c, n = ca.cos(q[2]), ca.sin(q[2])
            return q[:2] + ca.vertcat(c * x - n * y, n * x + c * y)

        self.places[body] = place
        kinetic = ca.SX(0)
        for at, weight in zip(s, weights, strict=True):
            mass = beam.line_mass * beam.length * weight
            r = place(float(at))
            kinetic += mass * ca.sumsqr(ca.jtimes(r, q, v)) / 2
            self.V += mass * self.gravity * r[1]
        kinetic += beam.turning * v[2] ** 2 / 2
        if beam.false_mass is not None:
            kinetic += ca.bilin(beam.false_mass, v_f, v_f) / 2 + v[2] ** 2 * ca.bilin(beam.false_mass, q_f, q_f) / 2
        self.T += _cut(kinetic, q_f, v_f) if beam.shortens else kinetic
        K = np.zeros((nf, nf))
        K[:bends, :bends] = beam.bending / beam.length**3 * (curvature * weights) @ curvature.T
        if beam.along is not None:
            K[bends:, bends:] = beam.along[1]
        self.V += ca.bilin(K, q_f, q_f) / 2
        modal = beam.line_mass * beam.length * (phi**2 @ weights)
        for k in range(bends if beam.damping_ratio else 0):
            name, damping = f"{body}.q{k + 1}", 2 * beam.damping_ratio * np.sqrt(K[k, k] * modal[k])
            self.Q[name] = -damping * self.rate(name)

    def pin(self, a: str | tuple[float, float], b: str, at_a: float = 0.0, at_b: float = 0.0) -> None:
        """Two places coincide; a: a body, or a place of the ground."""
        fixed = ca.DM(a) if isinstance(a, tuple) else self.places[a](at_a)
        self.constraints.append(self.places[b](at_b) - fixed)

    def hold(self, expression: ca.SX) -> None:
        """An expression of coordinates and t stays zero."""
        self.constraints.append(expression)

    def force(self, name: str, value: ca.SX) -> None:
        """A generalised force on a coordinate, beside others."""
        self.Q[name] = self.Q.get(name, ca.SX(0)) + value

    def equations(self) -> ca.Function:
        """(t, q, v) -> (M, right-hand side, C_q, gamma)."""
        q, v, t = ca.vertcat(*self.q), ca.vertcat(*self.v), self.t
        momentum = ca.gradient(self.T, v)
        force = ca.gradient(self.T - self.V, q) - ca.jtimes(momentum, q, v)
        force += ca.vertcat(*(self.Q.get(name, ca.SX(0)) for name in self.names))
        C = ca.vertcat(*self.constraints)
        rate = ca.jtimes(C, q, v) + ca.jacobian(C, t)
        gamma = -ca.jtimes(rate, q, v) - ca.jacobian(rate, t) - 2 * ALPHA * rate - ALPHA**2 * C
        outputs = [ca.jacobian(momentum, v), force, ca.jacobian(C, q), gamma]
        return ca.Function("equations", [t, q, v], [ca.densify(one) for one in outputs], {"cse": True})

    def motion(
        self, q: Array, v: Array, times: Array, breaks: Sequence[float] = (), rtol: float = 1e-9, atol: float = 1e-12
    ) -> Array:
        """q (N, n) at ascending times, from the first on; breaks: times at which forces jump."""
        equations, n = self.equations(), len(self.names)

        def slope(t: float, y: Array) -> Array:
            M, force, C_q, gamma = (np.asarray(one) for one in equations(t, y[:n], y[n:]))
            k = len(gamma)
            matrix = np.block([[M, C_q.T], [C_q, np.zeros((k, k))]])
            return np.concatenate([y[n:], np.linalg.solve(matrix, np.concatenate([force, gamma]).ravel())[:n]])

        rows, y, edges = [q], np.concatenate([q, v]), [times[0], *breaks, times[-1]]
        for start, end in zip(edges, edges[1:], strict=False):
            inside = times[(times > start) & (times <= end)]
            asked = inside if len(inside) and inside[-1] == end else np.append(inside, end)
            # a jump belongs to what follows it: the last evaluation of a piece is beside its end
            found = solve_ivp(
                lambda t, y, end=end: slope(min(t, np.nextafter(end, -1.0)), y),
                (start, end),
                y,
                method="DOP853",
                t_eval=asked,
                rtol=rtol,
                atol=atol,
            )
            y = found.y[:, -1]
            rows += list(found.y[:n, : len(inside)].T)
        return np.array(rows)


def _cut(kinetic: ca.SX, q_f: ca.SX, v_f: ca.SX) -> ca.SX:
    """Its terms up to second order in (q_f, v_f)."""
    e = ca.SX.sym("e")
    both = ca.vertcat(q_f, v_f)
    scaled = ca.substitute(kinetic, both, e * both)
    first = ca.jacobian(scaled, e)
    second = ca.jacobian(first, e)
    return sum((ca.substitute(one, e, ca.SX(0)) / by for one, by in ((scaled, 1), (first, 1), (second, 2))), ca.SX(0))
