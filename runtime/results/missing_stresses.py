"""How much of the stress at the gauges of a body the sum of modal stresses leaves out, as it is loaded in a motion.

A scene's measures of stress are that sum. What stretches a turning blade, for instance, is among none of its bending
modes. Equilibrium has it; the difference is told.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.model import ModelError
from runtime.contract.status import Event
from runtime.results.stresses import stresses, von_mises

if TYPE_CHECKING:
    from runtime.results.samples import Samples

LOOKS = 100  # samples at most
WORTH_A_WORD = 0.05


def missing_stresses(solution: Samples) -> tuple[dict[str, float], list[Event]]:
    """`missing_stress.body`: largest von Mises stress of what the modes leave out over the largest one.

    In words where the scene measures stresses.
    """
    shares, events = {}, []
    rows = np.unique(np.linspace(0, len(solution.t) - 1, LOOKS).astype(int))
    series = {key: getattr(solution, key)[rows] for key in ("t", "q", "q_dot", "q_ddot", "lam")}
    for body in dict.fromkeys(one.body for one in solution.model.description.gauges):
        try:
            some = replace(solution, **series)
            whole, modal = stresses(some, body), stresses(some, body, way="modes")
        except ModelError:  # gauges without the causes, or loads whose place on the body is not known
            continue
        lacking, largest = von_mises(whole.components - modal.components), whole.largest()
        if not (np.isfinite(lacking).all() and largest.value > 0.0):
            continue
        share = float(lacking.max()) / largest.value
        shares[f"missing_stress.{body}"] = share
        if share > WORTH_A_WORD and any(one.unit == "Pa" for one in solution.model.description.measures):
            sample, place = np.unravel_index(int(lacking.argmax()), lacking.shape)
            text = (
                f"measures of stress at {whole.gauges[int(place)]} of {body} leave out up to {100 * share:.2g} % of "
                f"its largest stress, which its modes do not hold; solution.stresses('{body}') has it, or give it "
                "the static shapes of its loads, static=[...] of FlexibleBody"
            )
            events.append(Event(float(whole.t[int(sample)]), "stresses_missing", text))
    return shares, events
