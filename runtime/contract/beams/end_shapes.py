"""Which shapes a beam's ends ask for: static shapes of loaded ends and the modes between held ends (Craig-Bampton).

A force or a moment at an end bends the beam into a cubic. Modes of free vibration alone have no moment (or no force)
at a free end and so add up to that cubic very slowly; with the cubic among the shapes the static answer is exact, and
the modes with the loaded ends held add what inertia bends.
"""

from __future__ import annotations

from dataclasses import dataclass

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
