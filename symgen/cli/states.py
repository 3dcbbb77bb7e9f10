"""`symgen equilibrium`, `modes`, `campbell`, `response`: where a scene rests or turns, and what it does about that."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from math import isnan
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.outcome import Outcome, left
from symgen.cli.sources import opened_model
from symgen.cli.words import UsageError, settings

if TYPE_CHECKING:
    from runtime.model import Model
    from runtime.operating.equilibrium import Equilibrium


def equilibrium(arguments: argparse.Namespace) -> Outcome:
    """Find where a scene rests, or turns at constant rates.

    Tells the coordinates, whether the state is stable, and the forces that hold what is held or turns.
    """
    from runtime.operating.equilibrium import force_unit

    model = opened_model(arguments.scene, arguments.made_with)
    found = found_equilibrium(model, arguments, arguments.moving)
    lines = [f"{model.name}: {'stable' if found.stable else 'unstable'} {found.kind}"]
    if found.drives:
        lines.append(f"prescribed motions: {found.drives} as at t = {found.state.t:g} s")
    if not found.steady:
        lines.append("the forces change with time or along the motion: this is the state of one instant")
    lines += [f"  {name} = {found[name]:.9g} {model.coordinate(name).unit}" for name in model.coordinates]
    lines += [f"  {name} needs {force:.9g} {force_unit(model, name)}" for name, force in found.holding.items()]
    return Outcome({"scene": model.name, "equilibrium": equilibrium_data(found)}, lines)


def found_equilibrium(model: Model, arguments: argparse.Namespace, moving: bool = True) -> Equilibrium:
    """The equilibrium that the options ask for; without --rate at the rates that the scene starts with.

    moving: do prescribed motions move, or are they held?
    """
    from runtime.operating.equilibrium import equilibrium
    from runtime.operating.linearise import starting_rates

    rates = arguments.rates or starting_rates(model)
    when = {"at_time" if moving else "t": arguments.time}
    return equilibrium(model, rates=rates, **when, **settings(arguments, ("held", "parameters", "initial")))


def equilibrium_data(found: Equilibrium) -> dict[str, Any]:
    """An equilibrium for --json."""
    return {
        "coordinates": {name: found[name] for name in found.model.coordinates},
        "drives": found.drives,
        "rates": {name: found[f"{name}_dot"] for name in found.turning},
        "holding": found.holding,
        "stable": found.stable,
        "steady": found.steady,
    }


def modes(arguments: argparse.Namespace) -> Outcome:
    """Compute the modes about an equilibrium or a steady rotation.

    Damping, gyroscopic and geometric terms included; rigid-body modes are named. With --out each mode leaves a
    period of its motion as a solution, mode1.npz and so on.
    """
    from runtime.operating.modes import modes
    from runtime.solutions.mode_motion import mode_motion

    model = opened_model(arguments.scene, arguments.made_with)
    point = found_equilibrium(model, arguments)
    found = modes(model, point, locked=arguments.locked)
    files = []
    for k in range(len(found)) if arguments.out else ():
        path = Path(arguments.out) / f"mode{k + 1}.npz"
        mode_motion(found.system, k).save(path)
        files.append(str(path))
    remarks = found.remarks()
    data = {"scene": model.name, "equilibrium": equilibrium_data(point), "modes": found.table(), "remarks": remarks}
    head = f"{'mode':>4}  {'rad/s':>12}  {'Hz':>12}  {'damping':>10}  coordinate"
    rows = [
        f"{row['mode']:>4}  {row['frequency']:>12.6g}  {row['frequency_Hz']:>12.6g}  {row['damping_ratio']:>10.4g}"
        f"  {row['name']}"
        for row in found.table()
    ]
    lines = [f"{model.name}: {len(found)} modes about {point!r}", head, *rows, *remarks]
    return Outcome({**data, "files": files}, [*lines, *left(files)])


def campbell(arguments: argparse.Namespace) -> Outcome:
    """Follow the modes along a speed or a parameter.

    Each mode is followed by the likeness of its shape, through crossings. With --out it leaves campbell.csv and
    campbell.png.
    """
    import numpy as np

    from runtime.operating.campbell import campbell
    from runtime.views.plots import campbell_picture

    if arguments.points < 2:
        raise UsageError("--points must be at least 2")
    if arguments.initial:
        raise UsageError("--initial does not apply here: every equilibrium starts from the one before")
    name, first, last = arguments.over
    model = opened_model(arguments.scene, arguments.made_with)
    how = settings(arguments, ("held", "rates", "parameters", "locked"))
    found = campbell(model, name, np.linspace(first, last, arguments.points), t=arguments.time, **how)
    files = []
    if arguments.out:
        files = [str(Path(arguments.out) / file) for file in ("campbell.csv", "campbell.png")]
        found.write_csv(Path(files[0]))
        campbell_picture(found, Path(files[1]))
    speeds = [{"mode": mode + 1, "value": value} for mode, value in found.crossings()]
    data = {
        "scene": model.name,
        "over": name,
        "values": found.values.tolist(),
        "modes": [
            {"name": mode, "frequencies": _where_there(frequencies), "damping": _where_there(damping)}
            for mode, frequencies, damping in zip(found.names, found.frequencies.T, found.damping_ratios.T, strict=True)
        ],
        "critical_speeds": speeds,
        "remarks": found.remarks(),
        "files": files,
    }
    lines = [f"{model.name} along {name}", f"{'mode':>4}  {f'at {first:g}':>12}  {f'at {last:g}':>12}  [rad/s]"]
    ends = zip(found.names, found.frequencies[0], found.frequencies[-1], strict=True)
    lines += [f"{k:>4}  {_shown(one)}  {_shown(other)}  {mode}" for k, (mode, one, other) in enumerate(ends, 1)]
    if found.is_speed:
        lines += [f"critical speed {speed['value']:.6g} rad/s of mode {speed['mode']}" for speed in speeds]
    return Outcome(data, [*lines, *found.remarks()[-3:], *left(files)])


def _shown(frequency: float) -> str:
    return f"{'-':>12}" if isnan(frequency) else f"{frequency:>12.6g}"


def _where_there(values: Iterable[float]) -> list[float | None]:
    """Of a mode that comes or goes, None where it is not."""
    return [None if isnan(value) else float(value) for value in values]


def response(arguments: argparse.Namespace) -> Outcome:
    """Frequency response of outputs to inputs about an equilibrium.

    With --out it leaves response.csv: amplitude and phase of each output.
    """
    import numpy as np

    from runtime.contract.files import write_text
    from runtime.operating.linearise import linearise

    if arguments.points < 2:
        raise UsageError("--points must be at least 2")
    model = opened_model(arguments.scene, arguments.made_with)
    found = found_equilibrium(model, arguments)
    system = linearise(model, found, inputs=arguments.input, outputs=arguments.output, locked=arguments.locked)
    first, last = arguments.frequencies
    values = np.geomspace(first, last, arguments.points)
    labels = [f"{output} / {given}" for output in system.output_names for given in system.input_names]
    answers = system.frequency_response(values).reshape(len(values), -1)
    largest = np.abs(answers).argmax(axis=0)
    lines = [f"{model.name}: largest of {len(values)} from {values[0]:g} to {values[-1]:g} rad/s"]
    lines += [
        f"{label:<32} {abs(answers[k, column]):>12.6g} at {values[k]:.6g} rad/s"
        for column, (label, k) in enumerate(zip(labels, largest, strict=True))
    ]
    amplitudes, phases, files = np.abs(answers), np.angle(answers), []
    if arguments.out:
        header = ["omega [rad/s]", *(f"{part} {label}" for label in labels for part in ("amplitude", "phase [rad]"))]
        rows = np.column_stack([values, np.stack([amplitudes, phases], axis=2).reshape(len(values), -1)])
        files = [str(Path(arguments.out) / "response.csv")]
        write_text(files[0], "\n".join([",".join(header), *(",".join(map(repr, row)) for row in rows.tolist())]) + "\n")
    responses = [
        {"name": label, "amplitude": amplitude, "phase": phase}
        for label, amplitude, phase in zip(labels, amplitudes.T.tolist(), phases.T.tolist(), strict=True)
    ]
    data = {"scene": model.name, "omega": values.tolist(), "responses": responses, "files": files}
    return Outcome(data, [*lines, *left(files)])
