"""Motion along a beam and the balance of the part beyond each section: forces on it less its inertia forces."""

from __future__ import annotations

import math

import numpy as np

from runtime.contract.flexible import cross_matrix, gauss_points, panels_for
from runtime.results.beam_shapes import ALONG_Y, ALONG_Z, STRETCHING, TORSION, Beam
from runtime.results.frame_motion import FrameMotion

Rates = tuple[np.ndarray, np.ndarray, np.ndarray]


class SectionField:
    """Positions and accelerations along a beam, at the sections xi (ascending) and at points of the mass between them.

    Vectors are (3, N, points) in the beam's axes; the planar beam has none along z.
    """

    def __init__(self, beam: Beam, xi: np.ndarray) -> None:
        self.beam, self.sections = beam, xi
        borders, panels = [*xi, 1.0], panels_for(max((len(one.columns) for one in beam.sets.values()), default=0))
        spans = [b - a for a, b in zip(borders, borders[1:], strict=False)]
        parts = [gauss_points(max(1, math.ceil(panels * span)), span) for span in spans]
        points = [a + part[0] for a, part in zip(xi, parts, strict=True)]
        self.mass = [beam.mass * part[1] for part in parts]
        self.sizes = np.cumsum([len(xi), *(len(part) for part in points)])
        self.xi = np.concatenate([xi, *points])
        self.values = {axis: one.functions.at(self.xi) for axis, one in beam.sets.items()}
        self.slopes = {axis: one.functions.at(xi, 1) / beam.length for axis, one in beam.sets.items()}
        polar = float(beam.radii.sum())
        scales = {ALONG_Y: 1.0, ALONG_Z: 1.0, TORSION: polar} if beam.stiffened else {}
        self.H = {axis: self._shortening(axis) * scales[axis] / beam.length for axis in scales if axis in beam.sets}

    def _shortening(self, axis: int) -> np.ndarray:
        """(points, n, n) integral of phi'^T phi' from the start to each point."""
        functions = self.beam.sets[axis].functions
        H = np.zeros((len(self.xi), functions.count, functions.count))
        last, total = 0.0, np.zeros(H.shape[1:])
        for k in np.argsort(self.xi):
            points, weights = gauss_points(1, float(self.xi[k]) - last)
            rate = functions.at(last + points, 1)
            total = total + rate.T @ (weights[:, None] * rate)
            H[k], last = total, float(self.xi[k])
        return H

    def forces(
        self, moved: Rates, frame: FrameMotion, a_o: np.ndarray, loads: list[tuple[float, np.ndarray]]
    ) -> np.ndarray:
        """(6, N, n): N, Q_y, Q_z, T, M_y, M_z along the axes of the sections.

        moved: q, q_dot, q_ddot (N, .); a_o (N, 3): acceleration of the frame less gravity, body axes; loads: place, and
        force and moment about the frame origin (N, 6) of each, body axes.
        """
        rho, a, spin = self._motion(moved, frame, a_o)
        n = len(self.sections)
        force, moment = np.zeros((2, 3, len(a_o), n))  # moment about the frame origin
        for k in range(n - 1, -1, -1):
            own = slice(self.sizes[k], self.sizes[k + 1])
            push = self.mass[k] * a[:, :, own]
            turning = np.cross(rho[:, :, own], push, axis=0) + self.mass[k] * spin[:, :, own]
            force[:, :, k], moment[:, :, k] = -push.sum(axis=2), -turning.sum(axis=2)
            if k + 1 < n:
                force[:, :, k] += force[:, :, k + 1]
                moment[:, :, k] += moment[:, :, k + 1]
        for place, wrench in loads:
            beyond = (place > self.sections) | ((place == 1.0) & (self.sections == 1.0))
            force += wrench.T[:3, :, None] * beyond
            moment += wrench.T[3:, :, None] * beyond
        moment -= np.cross(rho[:, :, :n], force, axis=0)
        R = self._axes(moved[0])
        return np.concatenate([np.einsum("snij,isn->jsn", R, vector) for vector in (force, moment)])

    def _motion(self, moved: Rates, frame: FrameMotion, a_o: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """rho [m], acceleration less gravity [m/s^2], and rate of spin of the sections a mass [m^2/s^2]."""
        rho, rate, a = (np.zeros((3, len(a_o), len(self.xi))) for _ in range(3))
        for axis, phi in self.values.items():
            if axis != TORSION:
                for vector, values in zip((rho, rate, a), moved, strict=True):
                    vector[axis] = values[:, self.beam.sets[axis].columns] @ phi.T
        rho[0] += self.xi * self.beam.length
        for axis, H in self.H.items():
            b, b_dot, b_ddot = (values[:, self.beam.sets[axis].columns] for values in moved)
            rho[0] -= 0.5 * _form(b, H, b)
            rate[0] -= _form(b, H, b_dot)
            a[0] -= _form(b_dot, H, b_dot) + _form(b, H, b_ddot)
        omega, alpha = cross_matrix(frame.omega), cross_matrix(frame.alpha)
        a += np.einsum("sij,jsk->isk", alpha + omega @ omega, rho) + 2 * np.einsum("sij,jsk->isk", omega, rate)
        return rho, a + a_o.T[:, :, None], self._spin(moved, frame)

    def _spin(self, moved: Rates, frame: FrameMotion) -> np.ndarray:
        """J omega' + omega x J omega of sections that turn and twist, over the mass; none in the plane."""
        found = np.zeros((3, len(frame.omega), len(self.xi)))
        if self.beam.planar:
            return found
        tau, tau_dot, tau_ddot = np.zeros((3, *found.shape[1:]))
        if TORSION in self.beam.sets:
            own = self.beam.sets[TORSION].columns
            tau, tau_dot, tau_ddot = (values[:, own] @ self.values[TORSION].T for values in moved)
        (x, y, z), (x_dot, y_dot, z_dot) = (vector.T[:, :, None] for vector in (frame.omega, frame.alpha))
        c, s, (ry, rz) = np.cos(tau), np.sin(tau), self.beam.radii
        yy, zz, yz = ry * c**2 + rz * s**2, ry * s**2 + rz * c**2, (ry - rz) * s * c
        J = np.array([[ry + rz + 0 * yy, 0 * yy, 0 * yy], [0 * yy, zz, -yz], [0 * yy, -yz, yy]])
        w = np.stack([x + tau_dot, y + 0 * tau, z + 0 * tau])
        w_dot = np.stack([x_dot + tau_ddot, y_dot + z * tau_dot, z_dot - y * tau_dot])
        found = np.einsum("ijsk,jsk->isk", J, w_dot)
        return np.asarray(found + np.cross(w, np.einsum("ijsk,jsk->isk", J, w), axis=0))

    def _axes(self, q: np.ndarray) -> np.ndarray:
        """(N, n, 3, 3): columns are the axes of the sections, turned as a marker there is."""
        turns = {axis: q[:, one.columns] @ self.slopes[axis].T for axis, one in self.beam.sets.items()}
        none = np.zeros((len(q), len(self.sections)))
        if self.beam.planar:
            turn = turns.get(ALONG_Y, none)
            psi = np.stack([none, none, 2 * np.tan(0.5 * turn)], axis=-1)
        else:
            angle = none
            if TORSION in turns:
                own = self.beam.sets[TORSION]
                angle = q[:, own.columns] @ own.functions.at(self.sections).T
            psi = np.stack([angle, -turns.get(ALONG_Z, none), turns.get(ALONG_Y, none)], axis=-1)
        tilde = cross_matrix(psi.reshape(-1, 3)).reshape(*none.shape, 3, 3)
        k = 1 + 0.25 * np.square(psi).sum(axis=-1)[:, :, None, None]
        return np.asarray(np.eye(3) + (tilde + 0.5 * tilde @ tilde) / k)

    def of_shapes(self, q: np.ndarray) -> np.ndarray:
        """(6, N, n): N, Q_y, Q_z, T, M_y, M_z by the strains of the shapes; NaN where there are none."""
        beam = self.beam
        found = np.full((6, len(q), len(self.sections)), np.nan)
        if beam.planar:
            found[2:5] = 0.0
        for axis, order, row, factor in (
            (STRETCHING, 1, 0, 1.0),
            (ALONG_Y, 3, 1, -1.0),
            (ALONG_Z, 3, 2, -1.0),
            (TORSION, 1, 3, 1.0),
            (ALONG_Z, 2, 4, -beam.length),
            (ALONG_Y, 2, 5, beam.length),
        ):
            if axis in beam.sets:
                one = beam.sets[axis]
                found[row] = factor * one.stiffness * q[:, one.columns] @ one.functions.at(self.sections, order).T
        return found


def _form(left: np.ndarray, H: np.ndarray, right: np.ndarray) -> np.ndarray:
    return np.asarray(np.einsum("sa,kab,sb->sk", left, H, right, optimize=True))
