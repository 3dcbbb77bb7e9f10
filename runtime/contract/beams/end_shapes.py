"""Which shapes a beam's ends ask for: static shapes of loaded ends and the modes between held ends (Craig-Bampton).

A force or a moment at an end bends the beam into a cubic. Modes of free vibration alone have no moment (or no force)
at a free end and so add up to that cubic very slowly; with the cubic among the shapes the static answer is exact, and
the modes with the loaded ends held add what inertia bends.
"""

from __future__ import annotations

from dataclasses import dataclass

Cubic = tuple[float, float, float, float]  # coefficients of 1, xi, xi^2, xi^3


@dataclass(frozen=True)
class EndShapes:
    """static: cubics of unit displacements of the loaded ends. start, end: how the ends of the modes are held."""

    static: tuple[Cubic, ...]
    start: str
    end: str


DEFLECTION, SLOPE = (0.0, 0.0, 3.0, -2.0), (0.0, 0.0, -1.0, 1.0)

# "welded" ends carry a force and a moment, "pinned" ends a force. Deflection and slope of a welded start are zero; of
# a pinned start the deflection is, and then that of the end where there is something (else the mean rotation).
BENDING: dict[str, EndShapes] = {
    "welded-welded": EndShapes((DEFLECTION, SLOPE), "clamped", "clamped"),
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
