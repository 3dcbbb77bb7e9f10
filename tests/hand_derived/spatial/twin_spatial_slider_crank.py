"""Spatial slider-crank with one degree of freedom, q_i = (phi,): the crank's angle about the world x-axis.

Bodies and joints
    crank   frame origin on its axis at (0, 0, z0); revolute joint about world x; A_c = R_x(phi); the crank pin is at
            (0, r, 0) in its frame, in the world P = (0, r cos phi, z0 + r sin phi).
    slider  prismatic joint along world x on the line y = y0, z = 0; A_s = 1; its origin is S = (x, y0, 0), x > 0.
    rod     frame origin at S (universal joint), its x-axis towards the pin (spherical joint at (l, 0, 0) in its
            frame, P). Universal joint: marker a on the slider with axes U = [e_y, -e_x, e_z] (columns, world), first
            turn alpha about a's z, then beta about b's x; marker b on the rod has the axes B = [-e_y, e_x, e_z]
            (columns, rod components): A_r B = U R_z(alpha) R_x(beta), which is the cross condition
            (a's z) . (b's x) = 0, that is e_z . (A_r e_y) = 0.
    Written out, A_r = R_z(alpha + pi) R_y(-beta): x-axis d = (-cos alpha cos beta, -sin alpha cos beta, sin beta).

Derivation. D = P - S = (-x, r cos phi - y0, z0 + r sin phi) = l d. With Y = D_y, Z = D_z and ' = d/dphi:
    x = sqrt(l^2 - Y^2 - Z^2),  x x' = -(Y Y' + Z Z'),  x x'' = -(Y'^2 + Y Y'' + Z'^2 + Z Z'') - x'^2
    sin beta = Z/l:        beta' = Z'/(l cos beta),  beta'' = (Z'' + l sin beta beta'^2)/(l cos beta)
    tan alpha = -Y/x:      alpha' = (Y x' - x Y')/n, n = x^2 + Y^2 = (l cos beta)^2,
                           alpha'' = (Y x'' - x Y'')/n - alpha' n'/n,  n' = 2 (x x' + Y Y') = -2 Z Z'
    rod: omega = (e_z alpha' + b beta') phi_dot, b = A_r (-e_y) = (-sin alpha, cos alpha, 0) (U R_z(alpha) e_x is
         that vector: e_y cos alpha - e_x sin alpha); d omega = bias phi_dot^2 with
         bias = e_z alpha'' + b beta'' + alpha' beta' e_z x b
    centre of the rod c_r = S + A_r r_c:  velocity (e_x x' + w x A_r r_c) phi_dot with w = e_z alpha' + b beta',
         acceleration bias e_x x'' + bias x A_r r_c + w x (w x A_r r_c)
    The crank turns about a fixed axis: J_x = inertia about x through its centre + m |e_x x c|^2.
    Q_hat by Jourdain with gravity, a torque on the crank, a force and a damper c on the slider (world x).
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tests.hand_derived.spatial.twin_spatial import E_X, E_Y, E_Z, Part, Pose, jourdain, rot_x, rot_y, rot_z
from tests.hand_derived.twin_common import Array


def _matrix(*rows: list[float]) -> Array:
    return np.array(rows)


@dataclass(frozen=True, eq=False)
class Params:
    """SI units; inertias (3, 3) about the centres of mass in body axes; centres (3,) in body frames."""

    r: float = 0.2
    l: float = 0.7  # noqa: E741
    z0: float = 0.15
    y0: float = 0.05
    crank_mass: float = 1.2
    crank_inertia: Array = field(
        default_factory=lambda: _matrix([0.02, 0.001, 0.002], [0.001, 0.015, -0.001], [0.002, -0.001, 0.018])
    )
    crank_centre: Array = field(default_factory=lambda: np.array([0.03, 0.08, -0.02]))
    rod_mass: float = 0.9
    rod_inertia: Array = field(
        default_factory=lambda: _matrix([0.008, 0.001, -0.0015], [0.001, 0.04, 0.002], [-0.0015, 0.002, 0.038])
    )
    rod_centre: Array = field(default_factory=lambda: np.array([0.33, 0.02, -0.015]))
    slider_mass: float = 2.1
    gravity: Array = field(default_factory=lambda: np.array([0.3, -0.7, -9.81]))
    torque: float = 1.5  # on the crank, about world x
    force: float = -4.0  # on the slider, along world x
    c: float = 3.0  # damper on the slider


def coordinates(params: Params) -> list[str]:
    return ["crank.phi"]


def _motion(p: Params, phi: complex) -> dict[str, complex]:
    """x, alpha, beta and their first (1) and second (2) derivatives with respect to phi."""
    Y, Y1, Y2 = p.r * np.cos(phi) - p.y0, -p.r * np.sin(phi), -p.r * np.cos(phi)
    Z, Z1, Z2 = p.z0 + p.r * np.sin(phi), p.r * np.cos(phi), -p.r * np.sin(phi)
    x = np.sqrt(p.l**2 - Y**2 - Z**2)
    x1 = -(Y * Y1 + Z * Z1) / x
    x2 = -(Y1**2 + Y * Y2 + Z1**2 + Z * Z2 + x1**2) / x
    beta = np.arcsin(Z / p.l)
    b1 = Z1 / (p.l * np.cos(beta))
    b2 = (Z2 + Z * b1**2) / (p.l * np.cos(beta))
    n = x**2 + Y**2
    a1 = (Y * x1 - x * Y1) / n
    a2 = (Y * x2 - x * Y2 + 2 * a1 * Z * Z1) / n
    return dict(x=x, x1=x1, x2=x2, alpha=np.arctan(-Y / x), a1=a1, a2=a2, beta=beta, b1=b1, b2=b2)


def crank_pin(params: Params, phi: complex) -> Array:
    """P, world."""
    return np.array([0 * phi, params.r * np.cos(phi), params.z0 + params.r * np.sin(phi)])


def universal_angles(params: Params, q_i: Array) -> tuple[complex, complex]:
    """(alpha, beta) of the universal joint."""
    m = _motion(params, q_i[0])
    return m["alpha"], m["beta"]


def origins(params: Params, q_i: Array) -> tuple[Array, Array, Array]:
    """World positions of the frames of crank, rod, slider (rod and slider coincide)."""
    slider = np.array([_motion(params, q_i[0])["x"], params.y0, 0.0])
    return np.array([0.0, 0.0, params.z0]), slider, slider


def rod_A(params: Params, q_i: Array) -> Array:
    """A of the rod."""
    alpha, beta = universal_angles(params, q_i)
    return rot_z(alpha + np.pi) @ rot_y(-beta)


def poses(params: Params, q_i: Array, t: float) -> list[Pose]:
    """Crank, rod, slider (the slider does not turn: no inertia)."""
    p, A_c, A_r = params, rot_x(q_i[0]), rod_A(params, q_i)
    crank, rod, slider = origins(p, q_i)
    return [
        Pose(p.crank_mass, p.crank_inertia, crank + A_c @ p.crank_centre, A_c),
        Pose(p.rod_mass, p.rod_inertia, rod + A_r @ p.rod_centre, A_r),
        Pose(p.slider_mass, np.zeros((3, 3)), slider, np.eye(3)),
    ]


def _parts(p: Params, q_i: Array, rate: complex) -> list[Part]:
    m, A_c, A_r, none = _motion(p, q_i[0]), rot_x(q_i[0]), rod_A(p, q_i), np.zeros(3)
    c = A_c @ p.crank_centre
    crank = Part(
        p.crank_mass,
        A_c @ p.crank_inertia @ A_c.T,
        np.cross(E_X, c)[:, None],
        E_X[:, None],
        E_X * rate,
        np.cross(E_X, np.cross(E_X, c)) * rate**2,
        none,
        p.crank_mass * p.gravity,
        p.torque * E_X,
    )
    b = E_Y * np.cos(m["alpha"]) - E_X * np.sin(m["alpha"])
    arm, w = A_r @ p.rod_centre, E_Z * m["a1"] + b * m["b1"]
    bias = E_Z * m["a2"] + b * m["b2"] + m["a1"] * m["b1"] * np.cross(E_Z, b)
    bias_v = E_X * m["x2"] + np.cross(bias, arm) + np.cross(w, np.cross(w, arm))
    rod = Part(
        p.rod_mass,
        A_r @ p.rod_inertia @ A_r.T,
        (E_X * m["x1"] + np.cross(w, arm))[:, None],
        w[:, None],
        w * rate,
        bias_v * rate**2,
        bias * rate**2,
        p.rod_mass * p.gravity,
        none,
    )
    on_slider = p.slider_mass * p.gravity + (p.force - p.c * m["x1"] * rate) * E_X
    slider = Part(
        p.slider_mass,
        np.zeros((3, 3)),
        (E_X * m["x1"])[:, None],
        none[:, None],
        none,
        E_X * m["x2"] * rate**2,
        none,
        on_slider,
        none,
    )
    return [crank, rod, slider]


def M_hat(params: Params, q_i: Array, t: float) -> Array:
    return jourdain(_parts(params, q_i, 0.0))[0]


def Q_hat(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    return jourdain(_parts(params, q_i, q_i_dot[0]))[1]


def Q_applied(params: Params, q_i: Array, q_i_dot: Array, t: float) -> Array:
    """Torque on the crank, force and damper on the slider."""
    x1 = _motion(params, q_i[0])["x1"]
    return np.array([params.torque + (params.force - params.c * x1 * q_i_dot[0]) * x1])


def energy(params: Params, q_i: Array, q_i_dot: Array, t: float) -> tuple[complex, complex]:
    weight = sum(b.mass * params.gravity @ b.R_c for b in poses(params, q_i, t))
    return 0.5 * q_i_dot @ M_hat(params, q_i, t) @ q_i_dot, -weight
