"""What loads a flexible body at each moment, as amounts of unit causes: mode acceleration with inertia relief.

The inertia forces -M a of the acceleration of its points, less its rigid part, and the forces at its interfaces:

    a = a_o + G rho0 + sum_a G_a phi_a,   G = alpha~ + omega~ omega~,  G_a = G q_a + 2 omega~ q_a' + 1 q_a''

All of it is linear in 9 fields x_i e_j (i slowest), 9 nf fields phi_a,i e_j (a slowest, then i), and the forces and
moments (6) of each interface. Weight and a_o are rigid: they load nothing.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from runtime.contract.body_motion import BodyMotion, cross_matrix

SAME_PLACE = 1e-9  # of the size of the body: a marker of another name there stands for the interface


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
        if np.abs(place - position).max() <= SAME_PLACE * size:
            return name
    raise UnknownInterface(marker)
