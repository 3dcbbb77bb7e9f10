"""The options that say at which state a model is looked at."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from symgen.cli.arguments import assignment, names, number

if TYPE_CHECKING:
    from runtime.contract.model import Model
    from runtime.operating.equilibrium import Equilibrium


def add_operating_options(command: argparse.ArgumentParser) -> None:
    """What is held, what turns, and from where the equilibrium is sought."""
    group = command.add_argument_group("state", "The equilibrium that is reached from the scene's initial state.")
    for option, text in (
        ("--held", "clamp a coordinate at a value; may be repeated"),
        ("--rate", "let a coordinate go on at a constant rate, such as hub.omega=6; may be repeated"),
        ("--set", "change a parameter; may be repeated"),
        ("--initial", "change a starting coordinate; may be repeated"),
    ):
        group.add_argument(option, action="append", type=assignment, default=[], metavar="NAME=VALUE", help=text)
    group.add_argument(
        "--time", type=number, default=0.0, metavar="SECONDS", help="when loads and motions are taken (default: 0)"
    )


def add_locked(command: argparse.ArgumentParser) -> None:
    """Which coordinates the linear system leaves out."""
    command.add_argument("--locked", type=names, metavar="NAMES", help="coordinates that stay as they are")


def found_equilibrium(model: Model, arguments: argparse.Namespace) -> Equilibrium:
    """The equilibrium that the options ask for; without --rate at the rates that the scene starts with."""
    from runtime.operating.equilibrium import equilibrium
    from runtime.operating.linearise import starting_rates

    return equilibrium(
        model,
        held=dict(arguments.held),
        rates=dict(arguments.rate) or starting_rates(model),
        parameters=dict(arguments.set),
        initial=dict(arguments.initial),
        t=arguments.time,
    )


def equilibrium_data(found: Equilibrium) -> dict[str, Any]:
    """An equilibrium for --json."""
    return {
        "coordinates": {name: found[name] for name in found.model.coordinates},
        "rates": {name: found[f"{name}_dot"] for name in found.turning},
        "holding": found.holding,
        "stable": found.stable,
        "steady": found.steady,
    }
