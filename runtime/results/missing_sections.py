"""How much of a section force a scene's measure leaves out, since the shapes of the beam do not hold it.

Measures are sums over shapes. Two cubics, for instance, hold what the ends carry and nothing of a weight in between:
the moment at the root of a cantilever then lacks a sixth. Equilibrium has it; the difference is told.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.model import ModelError
from runtime.contract.status import Event
from runtime.results.section_forces import section_forces

if TYPE_CHECKING:
    from runtime.results.samples import Samples

LOOKS = 100  # samples at most
WORTH_A_WORD = 0.05
SAME = 1e-9  # of its largest value: the sum over shapes that a measure is
WORDS = {
    "normal": "normal force",
    "shear": "shear force",
    "shear_z": "shear force along z",
    "moment": "bending moment",
    "moment_y": "bending moment about y",
    "torsion": "torsion",
}
PARTS = {"N": ("normal", "shear", "shear_z"), "N m": ("moment", "moment_y", "torsion")}


def missing_sections(solution: Samples) -> tuple[dict[str, float], list[Event]]:
    """`missing_force.measure`: the largest difference to equilibrium over the largest value there; and in words."""
    described = solution.model.description
    others = {one.name for one in described.inputs} | {one.owner for one in described.coordinates}  # states, too
    wanted = {one.name: PARTS[one.unit] for one in described.measures if one.unit in PARTS and one.name not in others}
    if not wanted or not described.beams:
        return {}, []
    shares: dict[str, float] = {}
    events = []
    rows = np.unique(np.linspace(0, len(solution.t) - 1, LOOKS).astype(int))
    series = {key: getattr(solution, key)[rows] for key in ("t", "q", "q_dot", "q_ddot", "lam", "measures")}
    some = replace(solution, **series)
    for record in described.beams:
        try:
            at = _markers(solution, record.body)
            whole, shapes = (section_forces(some, record.body, at, way) for way in ("equilibrium", "modes"))
        except ModelError:  # loads whose place on the beam is not known
            continue
        for name, parts in wanted.items():
            measured = some[name]
            size = float(np.abs(measured).max())
            for part in parts if size > 0.0 else ():
                apart = np.abs(getattr(shapes, part) - measured[:, None]).max(axis=0)
                for place in np.flatnonzero(apart <= SAME * size)[:1]:
                    exact = getattr(whole, part)[:, place]
                    lacking = np.abs(exact - measured)
                    shares[f"missing_force.{name}"] = share = float(lacking.max() / max(np.abs(exact).max(), size))
                    if share > WORTH_A_WORD:
                        text = (
                            f"measure {name} leaves out up to {100 * share:.2g} % of the {WORDS[part]} of "
                            f"{record.body} there, which its shapes do not hold; give more modes, or take "
                            f"solution.section_forces('{record.body}')"
                        )
                        events.append(Event(float(some.t[int(lacking.argmax())]), "sections_missing", text))
    return shares, events


def _markers(solution: Samples, body: str) -> list[float]:
    """Fractions of the length at which the beam has markers."""
    geometry = np.asarray(solution.model.kernel("geometry")(p=solution.parameters)["positions"])
    own = [k for k, one in enumerate(solution.model.description.drawing.points) if one.body == body]
    points = [solution.model.description.drawing.points[k] for k in own]
    length = float(geometry[0, own].max())
    return sorted({float(geometry[0, k]) / length for k, one in zip(own, points, strict=True) if one.name})
