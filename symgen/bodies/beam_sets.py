"""The mode sets of a beam of the scene (Eqs. 15-20).

Forces and moments in a section of a beam by the strains of its shapes: E A u', -E I w''', E I w'', G J tau'.

What a beam's shapes leave out of the static answer to the loads that its ends carry.

Moments M_0, M_L at the two ends, held in balance by transverse forces there, bend a beam of length L by
M(x) = -M_0 (1 - x/L) + M_L x/L. Their work is the same in every frame of the body, so shapes of any frame can be
judged: they give the bending energy f^T (B^T K^-1 B) f / 2 where f^T F f / 2 is exact,
F = (L / 6 EI) [[2, -1], [-1, 2]].
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import casadi as ca
import numpy as np
from scipy.linalg import eigh

from runtime.contract.flexible import panels_for
from runtime.contract.records import ModeSetRecord
from symgen.algebra.parameters import ParameterTable
from symgen.algebra.scalar import add, mul
from symgen.modes.beam import BeamIntegrals, BeamModes, ModeSets, beam_integrals, exact_bending, exact_stretching
from symgen.scene import BeamBody, lateral_ends
from symgen.scene.attachments import StaticResidual

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord

BENDING_AXES = (1, 2)


class SetChoice(NamedTuple):
    """axis: direction of the displacements, 0 = x (stretching), 1 = y, 2 = z; 3 = torsion about x."""

    axis: int
    ends: str
    modes: int


def set_choices(body: BeamBody) -> tuple[SetChoice, ...]:
    """The sets that a beam asks for, in the order of its coordinates. Its `ends` are filled in."""
    found = []
    for axis, modes in ((1, body.lateral), (2, body.lateral_z), (0, body.axial), (3, body.torsion)):
        if modes is not None:
            assert modes.ends is not None, "ends are filled in where the scene is left behind"
            found.append(SetChoice(axis, modes.ends, modes.modes))
    return tuple(found)


def mode_sets(body: BeamBody) -> ModeSets:
    """(axis, shapes) of each set."""
    return beam_integrals_of(body).sets


def beam_integrals_of(body: BeamBody) -> BeamIntegrals:
    """Dimensionless integrals of a beam's mode sets (numbers); equal sets are computed once."""
    return _integrals(set_choices(body))


@lru_cache(maxsize=64)
def _integrals(choices: tuple[SetChoice, ...]) -> BeamIntegrals:
    panels = panels_for(max((one.modes for one in choices), default=0))
    return beam_integrals(
        tuple(
            (one.axis, (exact_bending if one.axis in BENDING_AXES else exact_stretching)(one.ends, one.modes, panels))
            for one in choices
        )
    )


def set_records(body: BeamBody) -> list[ModeSetRecord]:
    """The sets as the runtime knows them: names from which it has the same shapes."""
    return [ModeSetRecord(*one) for one in set_choices(body)]


# kind -> axis of the shapes (x, y, z, 3 for torsion) and order of their derivative by xi
KINDS = {
    "normal_force": (0, 1),
    "shear_force": (1, 3),
    "bending_moment": (1, 2),
    "shear_force_z": (2, 3),
    "bending_moment_y": (2, 2),
    "torsion_moment": (3, 1),
}


def section_force(body: BeamBody, mesh: str, kind: str, at: float, q_f: list[ca.SX], table: ParameterTable) -> ca.SX:
    """The force [N] or moment [N m] at the fraction `at` of the length by q_f; mesh: key of the shapes."""
    wanted, order = KINDS[kind]
    first, value = 0, ca.SX(0)
    for axis, modes in mode_sets(body):
        if axis == wanted:
            rates = modes.functions.at(np.array([at]), order)
            data = table.data(rates, f"{mesh}@{at!r}.{kind}", "1", "derivative of the shapes at a section")
            for a in range(modes.modes):
                value = add(value, mul(data[0, a], q_f[first + a]))
        first += modes.modes
    length, modulus = table.of(body, "length"), table.of(body, "youngs_modulus")
    if kind == "torsion_moment":
        return table.of(body, "shear_modulus") * table.of(body, "torsion_constant") / length * value
    if kind == "normal_force":
        return modulus * table.of(body, "area") / length * value
    bending = modulus * table.of(body, "second_moment" if wanted == 1 else "second_moment_z")
    factor = bending / length**order
    return factor * value if kind == "bending_moment" else -factor * value


EXACT = np.array([[2.0, -1.0], [-1.0, 2.0]]) / 6.0  # for L = EI = 1
LOADED = {"welded-welded": [0, 1], "welded-pinned": [0], "pinned-welded": [1]}  # which of M_0, M_L the ends carry
REPORTED_RESIDUAL_SHARE = 1e-3


def static_residuals(scene: SceneRecord) -> list[StaticResidual]:
    """Of all beams of a scene whose `ends` are filled in: those that miss more than 0.1 %."""
    found = []
    for body in scene.moving_bodies:
        if not isinstance(body, BeamBody):
            continue
        for (axis, ends, count), (_, modes) in zip(set_choices(body), mode_sets(body), strict=True):
            if axis not in BENDING_AXES:
                continue
            plane = "lateral" if axis == 1 else "lateral_z"
            asked = lateral_ends(scene, body, plane)
            share = missing_share(modes, LOADED[asked]) if asked in LOADED else 0.0
            if share > REPORTED_RESIDUAL_SHARE:
                found.append(StaticResidual(body.name, plane, ends, count, asked, share))
    return found


def missing_share(modes: BeamModes, moments: list[int]) -> float:
    """Part of the exact bending energy that the shapes miss, for the worst end moments of those in `moments`."""
    start, end = modes.at(0.0), modes.at(1.0)
    balance = start.phi - end.phi
    B = np.stack([start.slope + balance, end.slope + balance], axis=1)[:, moments]
    modal = B.T @ (B / np.diag(modes.kappa)[:, None])
    kept = eigh(modal, EXACT[np.ix_(moments, moments)], eigvals_only=True)
    return float(1.0 - kept[0])
