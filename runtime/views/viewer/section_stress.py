"""Von Mises stress at the rim of a beam's section, which is drawn as the rectangle of its area and second moments.

sigma = N / A - M y / I_z + M_y z / I_y;  tau of shear forces by Zhuravskii, 3 Q / (2 A) at the middles of the sides
along Q and none at the others, tau of torsion by Saint-Venant's series for a rectangle; sqrt(sigma^2 + 3 tau^2).
Corners carry no shear stress.
"""

from __future__ import annotations

import numpy as np

from runtime.results.section_forces import SectionForces

# corners and middles of the sides of a section, around it, in halves of its height (along y) and width (along z)
RIM = ((-1, -1), (0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0))
TERMS = np.arange(1, 60, 2)


def rim_stress(forces: SectionForces, height: float, width: float) -> np.ndarray:
    """(N, sections, 8) [Pa] at the places of RIM; height, width [m] of the rectangle. NaN forces count as none."""
    N, Q, Q_z, T, M_y, M = (
        np.nan_to_num(values)
        for values in (forces.normal, forces.shear, forces.shear_z, forces.torsion, forces.moment_y, forces.moment)
    )
    area = height * width
    bent, aside = 6 * M / (width * height**2), 6 * M_y / (height * width**2)
    at_y, at_z = torsion_factors(height, width)
    found = []
    for y, z in RIM:
        # torsion about x: along z where y > 0, against y where z > 0
        along_y = z * z * (1 - y * y) * (1.5 * Q / area - z * T * at_z)
        along_z = y * y * (1 - z * z) * (1.5 * Q_z / area + y * T * at_y)
        found.append(np.sqrt((N / area - y * bent + z * aside) ** 2 + 3 * (along_y**2 + along_z**2)))
    return np.stack(found, axis=2)


def torsion_factors(height: float, width: float) -> tuple[float, float]:
    """Shear stress over torque [1/m^3] in the middle of the sides y = +-height / 2, then of z = +-width / 2."""
    long, short = max(height, width), min(height, width)
    ratio = long / short
    thin = np.tanh(TERMS * np.pi * ratio / 2)
    constant = long * short**3 * (1 / 3 - 64 / (np.pi**5 * ratio) * float(np.sum(thin / TERMS**5)))
    middle = 1 - 8 / np.pi**2 * float(np.sum(1 / (TERMS**2 * np.cosh(np.minimum(TERMS * np.pi * ratio / 2, 300.0)))))
    end = 8 / np.pi**2 * float(np.sum((-1.0) ** ((TERMS - 1) // 2) * thin / TERMS**2))
    of_long, of_short = middle * short / constant, end * short / constant
    return (of_short, of_long) if height >= width else (of_long, of_short)
