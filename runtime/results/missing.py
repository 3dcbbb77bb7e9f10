"""What a motion has missed: what shapes of flexible bodies leave out of deflections, section forces and stresses.

Deflections are asked only of beams whose shapes cannot carry what is attached to them.
"""

from __future__ import annotations

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.records import BeamRecord
from runtime.contract.status import Event
from runtime.results.samples import Samples

MOST_SAMPLES_LOOKED_AT = 100  # samples at most
WORTH_OF_SHAPES = 1e-3  # of a deflection
REPORTED_MISSING_SHARE = 0.05  # of a stress or a force


def looked_at(solution: Samples) -> Samples:
    """Samples that are looked at, evenly spread, the first and the last among them."""
    rows = sorted({int(row) for row in np.linspace(0, len(solution.t) - 1, MOST_SAMPLES_LOOKED_AT)})
    return solution.but(
        **{key: getattr(solution, key)[rows] for key in ("t", "q", "q_dot", "q_ddot", "lam", "measures")}
    )


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
        if share > WORTH_OF_SHAPES:
            text = (
                f"the shapes of {record.body} leave out up to {100 * share:.2g} % of its deflection, since they do not "
                "hold what its ends carry; leave `ends` out of its mode set, or give more modes"
            )
            events.append(Event(time, "shapes_missing", text))
    return shares, events


def missing_deflection(solution: Samples, body: str) -> tuple[float, float]:
    """(largest deflection from the chord that the shapes lack over the largest one, its time [s])."""
    some = looked_at(solution)
    whole, shapes = (some.deflections(body, way=way) for way in ("equilibrium", "modes"))
    pairs = (whole.y - shapes.y, whole.z - shapes.z), (whole.y, whole.z)
    lacking, deflection = (np.hypot(*(_from_chord(w, whole.at) for w in pair)) for pair in pairs)
    worst = lacking.max(axis=1)
    largest = float(deflection.max())
    if not (np.isfinite(worst).all() and largest > 0.0):
        return 0.0, float(some.t[0])
    return float(worst.max()) / largest, float(some.t[int(worst.argmax())])


def _from_chord(w: np.ndarray, at: np.ndarray) -> np.ndarray:
    return np.asarray(w - (1 - at) * w[:, :1] - at * w[:, -1:])


SAME_SUM = 1e-9  # of its largest value: the sum over shapes that a measure is
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
    some = looked_at(solution)
    for record in described.beams:
        try:
            at = _markers(solution, record.body)
            whole, shapes = (some.section_forces(record.body, at, way) for way in ("equilibrium", "modes"))
        except ModelError:  # loads whose place on the beam is not known
            continue
        for name, parts in wanted.items():
            measured = some[name]
            size = float(np.abs(measured).max())
            for part in parts if size > 0.0 else ():
                apart = np.abs(getattr(shapes, part) - measured[:, None]).max(axis=0)
                for place in np.flatnonzero(apart <= SAME_SUM * size)[:1]:
                    exact = getattr(whole, part)[:, place]
                    lacking = np.abs(exact - measured)
                    shares[f"missing_force.{name}"] = share = float(lacking.max() / max(np.abs(exact).max(), size))
                    if share > REPORTED_MISSING_SHARE:
                        text = (
                            f"measure {name} leaves out up to {100 * share:.2g} % of the {WORDS[part]} of "
                            f"{record.body} there, which its shapes do not hold; give more modes, or take "
                            f"solution.section_forces('{record.body}')"
                        )
                        events.append(Event(float(some.t[int(lacking.argmax())]), "sections_missing", text))
    return shares, events


def _markers(solution: Samples, body: str) -> list[float]:
    """Fractions of the length at which the beam has markers."""
    own = [one for one in solution.model.drawn_points(solution.parameters) if one.body == body]
    length = max(float(one.place[0]) for one in own)
    return sorted({float(one.place[0]) / length for one in own if one.name})


def missing_stresses(solution: Samples) -> tuple[dict[str, float], list[Event]]:
    """`missing_stress.body`: largest von Mises stress of what the modes leave out over the largest one.

    `mesh_error.body` [Pa]: what the mesh leaves unknown of the largest stress.

    In words where the scene measures stresses. Of beams `missing_stress.measure`, the like of their largest moment.
    """
    shares: dict[str, float] = {}
    events: list[Event] = []
    for record in solution.model.description.beams:
        if record.stresses:
            _missing_of_beam(solution, record, shares, events)
    if not solution.model.description.gauges:
        return shares, events
    few = looked_at(solution)
    for body in dict.fromkeys(one.body for one in solution.model.description.gauges):
        try:
            whole, modal = few.stresses(body), few.stresses(body, way="modes")
        except ModelError:  # gauges without the causes, or loads whose place on the body is not known
            continue
        from runtime.results.stresses import von_mises

        lacking, largest = (
            von_mises(whole.components - modal.components),
            whole.largest(),
        )
        if not (np.isfinite(lacking).all() and largest.value > 0.0):
            continue
        if np.isfinite(largest.mesh_error):
            shares[f"mesh_error.{body}"] = largest.mesh_error
        share = float(lacking.max()) / largest.value
        shares[f"missing_stress.{body}"] = share
        if share > REPORTED_MISSING_SHARE and any(one.unit == "Pa" for one in solution.model.description.measures):
            sample, place = np.unravel_index(int(lacking.argmax()), lacking.shape)
            text = (
                f"measures of stress at {whole.gauges[int(place)]} of {body} leave out up to {100 * share:.2g} % of "
                f"its largest stress, which its modes do not hold; solution.stresses('{body}') has it, or give it "
                "the static shapes of its loads, static=[...] of FlexibleBody"
            )
            events.append(Event(float(whole.t[int(sample)]), "stresses_missing", text))
    return shares, events


def _missing_of_beam(solution: Samples, record: BeamRecord, shares: dict[str, float], events: list[Event]) -> None:
    """Adds the share of the measures of a beam's stress, and the event."""
    from runtime.results.stresses import sum_of_shapes

    some = looked_at(solution)
    try:
        whole, shapes = some.beam_stresses(record.body).von_mises, sum_of_shapes(some, record.body).von_mises
    except ModelError:  # loads whose place on the beam is not known, or a section that is not
        return
    largest = float(whole.max(initial=0.0))
    if not (np.isfinite(whole).all() and largest > 0.0):
        return
    lacking = np.abs(whole - shapes).max(axis=1)
    share = float(lacking.max()) / largest
    shares |= {f"missing_stress.{name}": share for name in record.stresses}
    if share > REPORTED_MISSING_SHARE:
        text = (
            f"{', '.join(record.stresses)}: up to {100 * share:.2g} % of the largest stress of {record.body} are not "
            "in it, for its shapes do not hold it; "
            f"solution.beam_stresses('{record.body}') has it by equilibrium, or give more modes"
        )
        events.append(Event(float(some.t[int(lacking.argmax())]), "stresses_missing", text))
