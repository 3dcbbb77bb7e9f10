"""The page of a run for those who were not there: what came of it, how exact it is, how to get it again."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import isnan
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, cast

import numpy as np
from matplotlib.figure import Figure

from runtime.contract.arguments import PLACE, require
from runtime.contract.cards import Html, html
from runtime.contract.errors import ArgumentError, ModelError, SymgenError
from runtime.results.key_figures import (
    Peak,
    Reaction,
    deflection_peaks,
    drive_peaks,
    joint_peaks,
    kept_peaks,
    load_peaks,
    motion_peaks,
    peak,
    section_peaks,
    stress_peaks,
)
from runtime.results.run_settings import set_by_events, settings_of
from runtime.views import curves, plots
from runtime.views.animation import snapshots
from runtime.views.curves import Curves
from runtime.views.document import (
    badge,
    code,
    document,
    folded,
    frame,
    made_with,
    paragraph,
    peak_table,
    picture,
    quantity,
    table,
    time_of,
)
from runtime.views.figure import grid, panel
from runtime.views.mechanism import GROUND
from runtime.views.viewer.page import View, shown, view

if TYPE_CHECKING:
    from runtime.solutions.solution import Solution
    from runtime.studies.convergence import Convergence

FRAMES = 200  # of the moving view
INSTANTS = 4  # of the picture
MOST_PANELS = 8  # of outputs
MOST_SCENE = 60_000  # characters of a scene that are shown
PLURALS = {"body": "bodies", "joint": "joints", "coordinate": "coordinates"}
IMPULSES = {"m/s": "N s", "rad/s": "N m s"}  # units, by those of speeds
HALF, ALL, OFF = "half", "all", "off"
KNOBS_OF: dict[str, list[str] | None] = {HALF: [HALF], ALL: None, OFF: []}  # what is turned, by the word for it
PEAKS = "Peaks are the largest magnitudes among the saved samples."


class Studied(Protocol):
    """A model with the study of its error, which stands above the views."""

    def convergence(self, *, run: Solution, knobs: Sequence[str] | None) -> Convergence:
        """What `runtime.studies.convergence` tells of a run."""
        ...


@dataclass(frozen=True)
class NotEstimated:
    """Why the error of the model of a run is not estimated."""

    why: str


def page(
    solution: Solution, path: str | Path | None = None, convergence: Convergence | NotEstimated | str = HALF
) -> View:
    """Write a report of a run as one page to read, send and print.

    Parameters
    ----------
    solution : Solution
        N samples.
    path : str or Path, optional
        An .html file; if left out the page is shown in the notebook, or opened.
    convergence : {"half", "all", "off"} or Convergence, optional
        The error of the model beside that of the steps: by half the pieces and elements (the default, for each beam
        less than the run again), by all usual knobs (for each one to seven times the run), not at all, or what
        `model.convergence` found.

    Returns
    -------
    View
        The page: status and errors, the mechanism, key figures with time and place, curves, reactions, stresses,
        impacts, events, parameters, and how to get the run again. It needs no network.

    Raises
    ------
    OutputError
        For a place that cannot be written.
    ArgumentError
        For another word for convergence.

    Notes
    -----
    Peaks are those of the saved samples. Section forces and stresses are by equilibrium (Eqs. 22, 37).
    """
    require(PLACE, or_none=True, path=path)
    sections = [
        ("Result", _result(solution, modelling_error(solution, convergence))),
        ("Mechanism", _mechanism(solution)),
        ("Key figures", _key_figures(solution)),
        ("Curves", _curves(solution)),
        # a run with `outputs` keeps the rest at its ends only, where no peak is
        ("Reactions and loads", Html() if solution.outputs else _reactions(solution)),
        ("Stresses and section forces", Html() if solution.outputs else _stresses(solution)),
        ("Impacts", _impacts(solution)),
        ("Events", _events(solution)),
        ("Parameters", _parameters(solution)),
        ("How to reproduce it", _reproduce(solution)),
    ]
    return shown(document(solution.model.title or solution.model.name, _about(solution), sections), path)


def modelling_error(
    solution: Solution, convergence: Convergence | NotEstimated | str = HALF
) -> Convergence | NotEstimated:
    """Estimate the error of the model of a run.

    Parameters
    ----------
    solution : Solution
        The run.
    convergence : {"half", "all", "off"}, Convergence or NotEstimated, optional
        What is turned, as for `page`; what was found already is given back.

    Returns
    -------
    Convergence or NotEstimated
        NotEstimated: of a model without its scene, of a run that failed or whose own error is not known.

    Raises
    ------
    ArgumentError
        For another word.
    """
    if not isinstance(convergence, str):
        return convergence
    if convergence not in KNOBS_OF:
        raise ArgumentError("convergence", f"cannot be {convergence!r}", f"give one of {', '.join(KNOBS_OF)}")
    if convergence == OFF:
        return NotEstimated("it was switched off")
    model = cast(Studied, solution.model)
    try:
        return model.convergence(run=solution, knobs=KNOBS_OF[convergence])
    except SymgenError as error:
        return NotEstimated(str(error).splitlines()[0])


def _about(solution: Solution) -> str:
    described = solution.model.description
    counts = {
        "body": sum(one.name != GROUND for one in described.bodies),
        "joint": len(described.joints),
        "coordinate": len(solution.model.q_i),
    }
    words = [f"{n} {PLURALS[what] if n != 1 else what}" for what, n in counts.items() if n]
    return ", ".join(words).replace("coordinate", "independent coordinate")


# ---- How it ended, and how far it is off.


def _result(solution: Solution, convergence: Convergence | NotEstimated) -> Html:
    status, stats = solution.status, solution.stats
    where = f" at t = {status.time:.6g} s" + (f", coordinate {status.coordinate}" if status.coordinate else "")
    why = f". {status.cause}. {status.advice}" if status.cause else ""
    ended = html(badge(status.name, status.ok), "" if status.ok else where + why)
    m = f", m = {', '.join(map(str, solution.m))}" if solution.m else ""
    rows = [
        ("status", ended),
        ("motion", f"t = {solution.t[0]:.6g} to {solution.t[-1]:.6g} s, {len(solution.t)} samples saved"),
        (
            "method",
            f"{solution.scheme}, {solution.step}{m}" + (f", {stats['steps']} steps" if "steps" in stats else ""),
        ),
        ("error of the steps", _stepping_error(solution)),
        ("error of the model", _modelling_error(convergence)),
        ("energy", _energy(solution)),
        ("constraints", f"largest error {float(solution.constraint_error.max(initial=0.0)):.2g}"),
    ]
    rows += [("remark", str(stats["remark"]))] if "remark" in stats else []
    return html(Html('<div class="facts">'), table((), rows), Html("</div>"), _modelling_table(convergence))


def _stepping_error(solution: Solution) -> str:
    error = solution.error
    if not error.measured:
        return f"not estimated: {error.reason}"
    return f"{error.largest:.2g} of the amplitude of {error.of}, estimated with other steps"


def _modelling_error(convergence: Convergence | NotEstimated) -> str:
    if isinstance(convergence, NotEstimated):
        return f"not estimated: {convergence.why}"
    if convergence.errors and all(isnan(one.error) for one in convergence.errors.values()):
        return f"not told: {convergence.why_nothing()}"
    return f"of the {convergence.of}, estimated with other models: see the table"


def _modelling_table(convergence: Convergence | NotEstimated) -> Html:
    if isinstance(convergence, NotEstimated):
        return Html()
    rows = [
        (
            name,
            quantity(one.value, one.unit),
            "not told" if isnan(one.error) else quantity(one.error, one.unit) + _share(one.relative),
            "not known" if isnan(one.stepping) else quantity(one.stepping, one.unit),
            one.knob or "-",
        )
        for name, one in convergence.errors.items()
    ]
    told = table(("output", "value", "error of the model", "of the steps", "most by"), rows, (1, 2, 3))
    return html(told, *(paragraph(line) for line in convergence.remarks()))


def _share(relative: float) -> str:
    """Of an error, in per cent; nothing where it is not known."""
    return "" if isnan(relative) else f" ({100 * relative:.2g} %)"


def _energy(solution: Solution) -> str:
    total = f"{quantity(float(solution.total_energy[-1]), 'J')} at the end"
    if len(solution.t) < 3:
        return total
    return f"{total}; largest error of the balance of energy and work {solution.balance}"


# ---- What it looks like.


def _mechanism(solution: Solution) -> Html:
    """The mechanism at some instants, and the moving view; nothing where there is nothing to draw."""
    if solution.outputs:
        return Html()
    instants = INSTANTS if len(solution.t) > 1 else 1
    try:
        still = picture(
            snapshots(solution, instants=instants), "The mechanism at some instants; later ones are darker."
        )
        moving = frame(view(solution, frames=FRAMES, alone=False))
    except ModelError:
        return Html()
    hint = paragraph("Interactive view: drag to turn it, use the wheel to zoom, play the motion.")
    return html(still, Html('<div class="screen">'), hint, moving, Html("</div>"))


def _key_figures(solution: Solution) -> Html:
    if solution.outputs:
        peaks = kept_peaks(solution)
    else:
        names = [name for group in curves.motion(solution) for name in group.names]
        peaks = [*motion_peaks(solution, names), *_deflections(solution), *drive_peaks(solution)]
    return peak_table(peaks, PEAKS)


def _deflections(solution: Solution) -> list[Peak]:
    """Of beams where they are known, of other flexible bodies among the points that are drawn."""
    found = deflection_peaks(solution)
    names = [one.quantity for one in found]
    drawn = {f"deflection of {body}": values for body, values in curves.drawn_deflections(solution).items()}
    return found + [peak(name, "m", solution.t, values) for name, values in drawn.items() if name not in names]


def _curves(solution: Solution) -> Html:
    if solution.outputs:
        return picture(_outputs(solution), "The outputs that the run kept.")
    if len(solution.t) < 2:
        return Html()
    drawn: list[tuple[str, Callable[[Solution], Figure]]] = [("Motion.", plots.motion)]
    drawn += [("Deformation.", plots.deformation)] if curves.deformation(solution) else []
    drawn += [("Forces and moments.", plots.forces)] if curves.forces(solution) else []
    drawn.append(("Energy, and the error of its balance.", plots.energy_balance))
    return html(*(picture(draw(solution), caption) for caption, draw in drawn))


def _outputs(solution: Solution) -> Figure:
    units = {one.quantity: one.unit for one in kept_peaks(solution)}
    names = list(units)[:MOST_PANELS]
    figure, axes = grid(len(names), "")
    for ax, name in zip(axes, names, strict=True):
        panel(ax, solution.outputs["t"], Curves("", units[name], [name], solution.outputs[name][None]))
    return figure


# ---- Forces and stresses.


def _reactions(solution: Solution) -> Html:
    axes = ("x", "y", "z")[: 2 if solution.joint_forces.shape[-1] == 3 else 3]
    parts: list[str] = []
    for title, found in (("joint", joint_peaks(solution)), ("load", load_peaks(solution))):
        header = (title, "largest force", "at t [s]", f"components {', '.join(axes)}", "largest moment", "at t [s]")
        parts.append(table(header, [_reaction(one) for one in found], range(1, 6)))
    if not any(parts):
        return Html()
    return html(*parts, paragraph("Of joints on their body b, of loads on their marker or marker b; in world axes."))


def _reaction(one: Reaction) -> tuple[str, ...]:
    components = ", ".join(quantity(value, "N") for value in one.components)
    force = (quantity(one.force, "N"), time_of(one.t_force), components) if one.force else ("-", "-", "-")
    moment = (quantity(one.moment, "N m"), time_of(one.t_moment)) if one.moment else ("-", "-")
    return (one.name, *force, *moment)


def _stresses(solution: Solution) -> Html:
    rows = [_place(one) for one in (*stress_peaks(solution), *section_peaks(solution))]
    return table(("quantity", "peak", "at t [s]", "place"), rows, (1, 2))


def _place(one: Peak) -> tuple[str, ...]:
    return one.quantity, quantity(one.value, one.unit), time_of(one.t), one.place


def _impacts(solution: Solution) -> Html:
    """Of stops, play and contacts; a line below for what all of them lose."""
    found = solution.impacts()
    rows = [
        (
            f"{one.time:.6g}",
            one.where,
            f"{one.speed_before:.4g} {one.unit}",
            f"{one.speed_after:.4g} {one.unit}",
            quantity(one.impulse, IMPULSES[one.unit]),
            quantity(one.energy_lost, "J"),
            f"{one.duration:.3g}" if one.duration else "-",
        )
        for one in found
    ]
    header = ("t [s]", "where", "speed before", "speed after", "impulse", "energy lost", "duration [s]")
    unknown = sum(isnan(one.energy_lost) for one in found)
    few = f", without {unknown} of too few samples (save more often: seen_every)" if unknown else ""
    lost = quantity(float(np.nansum([one.energy_lost for one in found])), "J")
    note = paragraph(f"{len(rows)} impact{'s' if len(rows) > 1 else ''}; energy lost in all: {lost}{few}.")
    return html(table(header, rows, (0, 2, 3, 4, 5, 6)), note) if rows else Html()


def _events(solution: Solution) -> Html:
    """What else happened; impacts have a table of their own."""
    rows = [
        (f"{one.time:.6g}", one.kind.replace("_", " "), one.text) for one in solution.events if one.kind != "impact"
    ]
    return table(("t [s]", "kind", "what happened"), rows, (0,))


# ---- What it was made of, and how to make it again.


def _parameters(solution: Solution) -> Html:
    """What a person declared; data of shapes and what the run decided stay out, values of a call are marked."""
    decided = {*solution.driven, *set_by_events(solution)}
    values = zip(solution.model.parameters, solution.parameters, strict=True)
    rows = [
        (
            entry.name,
            html(Html("<b>"), f"{value:.6g}", Html("</b>")) if value != entry.default else f"{value:.6g}",
            f"{entry.default:.6g}",
            entry.unit,
            entry.meaning,
        )
        for entry, value in values
        if entry.kind != "data" and entry.name not in decided and (not entry.array or value != entry.default)
    ]
    return table(("parameter", "value", "in the scene", "unit", "meaning"), rows, (1, 2))


def _reproduce(solution: Solution) -> Html:
    """Versions, the command and the lines, and the scene itself."""
    scene, settings, driven = solution.model.scene_toml, settings_of(solution), sorted(solution.driven)
    command = _command(settings) if not driven else ""
    parts = [code(command), paragraph("or in Python:")] if command else []
    parts.append(code(_lines(settings)))
    if driven:
        parts.append(paragraph(f"Inputs that Python drove, and that these lines lack: {', '.join(driven)}."))
    if acted := sorted(set_by_events(solution)):
        parts.append(paragraph(f"Set by events, and at the start as the scene has them: {', '.join(acted)}."))
    if 0 < len(scene) <= MOST_SCENE:
        parts.append(folded("scene.toml", code(scene)))
    else:
        parts.append(paragraph("scene.toml is in the folder model/ beside the results of symgen simulate --out."))
    return html(made_with(), *parts)


def _command(settings: Mapping[str, Any]) -> str:
    """The words of `symgen simulate`; nothing where the command line has none for a setting."""
    if settings.keys() & {"t0", "inputs"}:
        return ""
    words = ["symgen simulate scene.toml"]
    for name, value in settings.items():
        flag = {"parameters": "--set", "options": "--option"}.get(name, "--" + name.replace("_", "-"))
        if isinstance(value, dict):
            words += [f"{flag} {shlex.quote(f'{key}={_word(one)}')}" for key, one in value.items()]
        else:
            words.append(f"{flag} {_word(value)}")
    return " ".join([*words, "--out results"])


def _word(value: Any) -> str:
    return ",".join(map(str, value)) if isinstance(value, list) else str(value)


def _lines(settings: Mapping[str, Any]) -> str:
    given = "".join(f"    {name}={value!r},\n" for name, value in settings.items())
    return (
        "from symgen import SceneRecord\n\n"
        'model = SceneRecord.from_toml("scene.toml").model()\n'
        f"run = model.simulate(\n{given})\n"
        'run.page("page.html")'
    )
