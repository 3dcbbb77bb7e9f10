"""`symgen response`: frequency responses between inputs and outputs, and to an unbalance."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symgen.cli.arguments import UsageError, add_command, add_scene, names, number
from symgen.cli.campbell import span
from symgen.cli.operating_options import add_locked, add_operating_options, found_equilibrium
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "response",
        run,
        "Frequency response about an equilibrium, or the whirl of a rotor under an unbalance.",
        "With --out it leaves response.csv: amplitude and phase of each output.",
    )
    add_scene(command)
    group = command.add_argument_group("what is asked")
    group.add_argument(
        "--input", type=names, metavar="NAMES", help="inputs, parameters or coordinates (a force on them)"
    )
    group.add_argument("--output", type=names, metavar="NAMES", help="measures, coordinates or rates")
    group.add_argument("--frequencies", type=frequencies, metavar="FROM:TO", help="rad/s, spaced logarithmically")
    group.add_argument("--over", type=span, metavar="NAME=FROM:TO", help="speeds of a rotor, such as disk.omega=10:100")
    group.add_argument("--unbalance", type=number, metavar="KG_M", help="mass times eccentricity, with --over and --at")
    group.add_argument("--at", type=names, metavar="X,Y", help="the two coordinates across the axle that it pulls at")
    group.add_argument(
        "--points", type=int, default=200, help="frequencies or speeds to look at (default: %(default)s)"
    )
    add_operating_options(command)
    add_locked(command)
    command.add_argument("--out", metavar="DIR", help="folder for response.csv")


def frequencies(text: str) -> tuple[float, float]:
    """FROM:TO with positive numbers, rising."""
    first, colon, last = text.partition(":")
    try:
        if colon and 0 < number(first) < number(last):
            return number(first), number(last)
    except (ValueError, argparse.ArgumentTypeError):
        pass
    raise argparse.ArgumentTypeError(f"{text!r} is not FROM:TO with positive numbers, rising")


def run(arguments: argparse.Namespace) -> Outcome:
    """The largest amplitude of each output, and where."""
    import numpy as np

    from runtime.contract.files import write_text

    if arguments.points < 2:
        raise UsageError("--points must be at least 2")
    name, values, labels, answers = _unbalance(arguments) if arguments.unbalance is not None else _response(arguments)
    largest = np.abs(answers).argmax(axis=0)
    lines = [f"{name}: largest of {len(values)} from {values[0]:g} to {values[-1]:g} rad/s"]
    lines += [
        f"{label:<32} {abs(answers[k, column]):>12.6g} at {values[k]:.6g} rad/s"
        for column, (label, k) in enumerate(zip(labels, largest, strict=True))
    ]
    files = []
    if arguments.out:
        header = ["omega [rad/s]", *(f"{part} {label}" for label in labels for part in ("amplitude", "phase [rad]"))]
        rows = np.stack([np.abs(answers), np.angle(answers)], axis=2).reshape(len(values), -1)
        table = [",".join(map(repr, row)) for row in np.column_stack([values, rows]).tolist()]
        files = [str(Path(arguments.out) / "response.csv")]
        write_text(Path(files[0]), "\n".join([",".join(header), *table]) + "\n")
    data = {
        "scene": name,
        "omega": values.tolist(),
        "responses": [
            {
                "name": label,
                "amplitude": np.abs(answers[:, column]).tolist(),
                "phase": np.angle(answers[:, column]).tolist(),
            }
            for column, label in enumerate(labels)
        ],
        "files": files,
    }
    return Outcome(data, [*lines, *(f"left {path}" for path in files)])


def _response(arguments: argparse.Namespace) -> Any:
    """(model's name, frequencies (N,), labels, complex answers (N, k)) of each output to each input."""
    import numpy as np

    from runtime.operating.linearise import linearise
    from symgen.cli.sources import opened_model

    if not arguments.input or not arguments.frequencies or arguments.over or arguments.at:
        raise UsageError("give --input and --frequencies, or --unbalance with --over and --at")
    model = opened_model(arguments.scene, arguments.made_with)
    found = found_equilibrium(model, arguments)
    system = linearise(model, found, inputs=arguments.input, outputs=arguments.output, locked=arguments.locked)
    first, last = arguments.frequencies
    values = np.geomspace(first, last, arguments.points)
    labels = [f"{output} / {given}" for output in system.output_names for given in system.input_names]
    return model.name, values, labels, system.frequency_response(values).reshape(len(values), -1)


def _unbalance(arguments: argparse.Namespace) -> Any:
    """The same of a rotor at each speed."""
    import numpy as np

    from runtime.operating.unbalance import unbalance_response
    from symgen.cli.sources import opened_model

    if not arguments.over or not arguments.at or len(arguments.at) != 2 or arguments.input or arguments.frequencies:
        raise UsageError("--unbalance needs --over NAME=FROM:TO and --at X,Y, and neither --input nor --frequencies")
    if arguments.rate or arguments.initial:
        raise UsageError("--rate and --initial have no place here: --over turns the rotor from the scene's own start")
    name, first, last = arguments.over
    model = opened_model(arguments.scene, arguments.made_with)
    found = unbalance_response(
        model,
        name,
        np.linspace(first, last, arguments.points),
        at=(arguments.at[0], arguments.at[1]),
        unbalance=arguments.unbalance,
        outputs=arguments.output,
        held=dict(arguments.held),
        parameters=dict(arguments.set),
        locked=arguments.locked,
    )
    return model.name, found.speeds, found.outputs, found.amplitudes
