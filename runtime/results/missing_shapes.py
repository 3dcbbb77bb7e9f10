"""How much of a beam's deflection its shapes leave out, as it is loaded in a motion.

The bending moment from equilibrium less that of the shapes is what the shapes lack; both are integrated twice to
deflections from the chord, w'' = M / EI. Asked only of beams whose shapes cannot carry what is attached to them.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.model import ModelError
from runtime.contract.status import Event
from runtime.results.beam_shapes import beam_of
from runtime.results.section_forces import STATIONS, section_forces

if TYPE_CHECKING:
    from runtime.results.samples import Samples

LOOKS = 100  # samples at most
WORTH_A_WORD = 1e-3


def missing_shapes(solution: Samples) -> tuple[dict[str, float], list[Event]]:
    """Share of the largest deflection that the shapes of a beam leave out, by `missing_shapes.body`; and in words."""
    shares, events = {}, []
    for record in solution.model.description.beams:
        if record.missing == 0.0 or not record.sets:
            continue
        try:
            share, time = missing_deflection(solution, record.body)
        except ModelError:  # a model without the functions, or loads that cannot be told apart
            continue
        shares[f"missing_shapes.{record.body}"] = share
        if share > WORTH_A_WORD:
            text = (
                f"the shapes of {record.body} leave out up to {100 * share:.2g} % of its deflection, since they do not "
                "hold what its ends carry; leave `ends` out of its mode set, or give more modes"
            )
            events.append(Event(time, "shapes_missing", text))
    return shares, events


def missing_deflection(solution: Samples, body: str) -> tuple[float, float]:
    """(largest deflection from the chord that the shapes lack over the largest one, its time [s])."""
    rows = np.unique(np.linspace(0, len(solution.t) - 1, LOOKS).astype(int))
    series = {key: getattr(solution, key)[rows] for key in ("t", "q", "q_dot", "q_ddot", "lam")}
    some = replace(solution, **series)
    whole, shapes = (section_forces(some, body, way=way) for way in ("equilibrium", "modes"))
    radii = beam_of(solution.model, body, solution.parameters).radii
    pairs = [(whole.moment, shapes.moment, radii[0]), (whole.moment_y, shapes.moment_y, radii[1])]
    known = [(all_, found, radius) for all_, found, radius in pairs if np.isfinite(found).all()]
    lacking, bent = (
        np.sqrt(sum(np.square(_deflections(moment) / radius) for moment, radius in of))
        for of in ([(all_ - found, radius) for all_, found, radius in known], [(a, radius) for a, _, radius in known])
    )
    worst = lacking.max(axis=1)
    largest = float(bent.max())
    if not (np.isfinite(worst).all() and largest > 0.0):
        return 0.0, float(some.t[0])
    return float(worst.max()) / largest, float(some.t[int(worst.argmax())])


def _deflections(moment: np.ndarray) -> np.ndarray:
    """(N, n) w with w'' = moment (N, n) at equidistant stations, by finite differences; zero at both ends."""
    n, h = len(STATIONS), STATIONS[1] - STATIONS[0]
    second = (np.diag(np.full(n - 3, 1.0), 1) + np.diag(np.full(n - 3, 1.0), -1) - 2.0 * np.eye(n - 2)) / h**2
    return np.asarray(np.linalg.solve(second, moment[:, 1:-1].T).T)
