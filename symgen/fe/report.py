"""The report of a flexible body: frequencies, effective masses, what truncation loses, the check of rigid modes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symgen.fe.losses import FlexibilityLoss
from symgen.fe.rigid_check import RigidCheck
from symgen.modes.cleaning import Array

NO_MASS = 1e-9  # share of the mass that counts as none
CLOSE = 1e-3  # relative distance of frequencies below which shapes are badly determined
DIRECTIONS = ("x", "y", "z")
LOADS = ("Fx", "Fy", "Fz", "Mx", "My", "Mz")


def body_report(
    title: str,
    hertz: Array,
    shares: Array,
    held: tuple[Array, Array] | None,
    losses: Sequence[FlexibilityLoss],
    check: RigidCheck,
) -> str:
    """Markdown.

    hertz (nf,); shares (nf, 3): effective modal masses over total mass; held: the same two of the normal modes
    with held interfaces (Craig-Bampton), or None.
    """
    rigid = (
        f"Rigid-body check: {check.zero_modes} zero modes (up to {check.highest_zero:.2g} Hz, lowest elastic "
        f"{check.lowest_elastic:.5g} Hz); rigid motions leave {check.residual:.1g} of the stiffness forces."
    )
    parts = [f"# {title}", "", rigid, "", "## Modes", "", *_mode_table(hertz, shares)]
    if np.max(shares, initial=0.0) < NO_MASS:
        parts += ["", "The modes are free of rigid motion: the frame carries all the mass, the modes none."]
    for a in np.flatnonzero(np.diff(hertz) < CLOSE * hertz[:-1]):
        parts += ["", f"Modes {a + 1} and {a + 2} have nearly the same frequency: their shapes depend on round-off."]
    if held is not None and len(held[0]):
        parts += ["", "## Normal modes with held interfaces", "", *_mode_table(*held)]
    parts += [
        "",
        "## Static flexibility at the interfaces: share lost",
        "",
        _row("interface", *LOADS),
        _row(*["---"] * (1 + len(LOADS))),
    ]
    parts += [_row(loss.name, *(_percent(value) for value in loss.loss)) for loss in losses]
    return "\n".join(parts) + "\n"


def _mode_table(hertz: Array, shares: Array) -> list[str]:
    lines = [_row("mode", "frequency [Hz]", *(f"effective mass {axis}" for axis in DIRECTIONS)), _row(*["---"] * 5)]
    lines += [_row(a + 1, f"{value:.6g}", *(_percent(share) for share in shares[a])) for a, value in enumerate(hertz)]
    total = np.sum(shares, axis=0)
    if np.max(total, initial=0.0) < NO_MASS:
        return lines
    return [
        *lines,
        _row("sum", "", *(_percent(share) for share in total)),
        _row("not represented", "", *(_percent(1.0 - share) for share in total)),
    ]


def _percent(value: float) -> str:
    return f"{100.0 * value:.3g} %" if abs(value) >= 1e-9 else "0 %"


def _row(*cells: object) -> str:
    return "| " + " | ".join(str(cell) for cell in cells) + " |"
