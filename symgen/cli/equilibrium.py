"""`symgen equilibrium`: where a scene rests or turns steadily."""

from __future__ import annotations

import argparse
from typing import Any

from symgen.cli.arguments import add_command, add_scene
from symgen.cli.operating_options import add_operating_options, equilibrium_data, found_equilibrium
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "equilibrium",
        run,
        "Find where a scene rests, or turns at constant rates.",
        "Tells the coordinates, whether the state is stable, and the forces that hold what is held or turns.",
    )
    add_scene(command)
    add_operating_options(command)


def run(arguments: argparse.Namespace) -> Outcome:
    """The state, a coordinate a line."""
    from runtime.operating.equilibrium import force_unit
    from symgen.cli.sources import opened_model

    model = opened_model(arguments.scene, arguments.made_with)
    found = found_equilibrium(model, arguments)
    lines = [f"{model.name}: {'stable' if found.stable else 'unstable'} {found.kind}"]
    if not found.steady:
        lines.append("the forces change with time or along the motion: this is the state of one instant")
    lines += [f"  {name} = {found[name]:.9g} {model.coordinate(name).unit}" for name in model.coordinates]
    lines += [f"  {name} needs {force:.9g} {force_unit(model, name)}" for name, force in found.holding.items()]
    return Outcome({"scene": model.name, "equilibrium": equilibrium_data(found)}, lines)
