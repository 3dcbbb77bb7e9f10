"""The options that commands share, and how their values are read."""

from __future__ import annotations

import argparse
import math
import shlex
from collections.abc import Callable
from typing import Any, NoReturn

from runtime.contract.errors import SymgenError
from symgen.cli.suggestions import explained, unknown_words

SCENE: dict[str, Any] = {"metavar": "SCENE", "help": "built-in name, .toml file, or generated folder"}


class UsageError(SymgenError):
    """Wrong words on the command line."""


class Parser(argparse.ArgumentParser):
    """An ArgumentParser that raises UsageError, in one line with what was probably meant."""

    def error(self, message: str) -> NoReturn:
        """Raise UsageError with the message."""
        raise UsageError(explained(message, self.prog))

    def parse_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Parse all words; those that nothing takes are refused in the name of the command that got them."""
        parsed, further = self.parse_known_args(args, namespace)
        if further:
            commands = next((a.choices for a in self._actions if isinstance(a, argparse._SubParsersAction)), {})
            raise UsageError(unknown_words(further, commands.get(getattr(parsed, "command", ""), self)))
        return parsed


def add_command(
    subparsers: Any, name: str, run: Callable[[argparse.Namespace], Any], summary: str, details: str = ""
) -> argparse.ArgumentParser:
    """A subcommand with the option every command has."""
    command: argparse.ArgumentParser = subparsers.add_parser(name, help=summary, description=f"{summary} {details}")
    command.add_argument("--json", action="store_true", help="write one JSON object to standard output, nothing else")
    command.add_argument("-q", "--quiet", action="store_true", help="write nothing but errors")
    command.add_argument("-v", "--verbose", action="store_true", help="also write what the run counted and took")
    command.set_defaults(run=run)
    return command


def add_scene(command: argparse.ArgumentParser, **options: Any) -> None:
    """The word that names a scene, and what built-in scenes can be made with."""
    command.add_argument("scene", **{**SCENE, **options})
    command.add_argument(
        "--with",
        action="append",
        type=assignment,
        default=[],
        dest="made_with",
        metavar="NAME=VALUE",
        help="what a built-in scene is made with, for instance links=50 for chain; may be repeated",
    )


def add_motion_options(command: argparse.ArgumentParser) -> None:
    """Which motion of the scene is meant; what is not given comes from the scene."""
    group = command.add_argument_group("motion", "What is not given comes from the scene's [simulation].")
    group.add_argument("--t-end", type=number, metavar="SECONDS", help="end of the motion")
    group.add_argument(
        "--set",
        action="append",
        type=assignment,
        default=[],
        metavar="NAME=VALUE",
        help="change a parameter; may be repeated",
    )
    group.add_argument(
        "--initial",
        action="append",
        type=assignment,
        default=[],
        metavar="NAME=VALUE",
        help="change a starting coordinate, or a rate by NAME_dot; may be repeated",
    )
    group.add_argument(
        "--start",
        choices=("given", "quasi_static", "quasi_static_unstable"),
        help="elastic coordinates as given, or in equilibrium with the rigid motion (stable, or any)",
    )


def motion_words(arguments: argparse.Namespace, scene: str = "") -> str:
    """The scene and its motion in the words that they were given in, for a command that is to be run again."""
    words = [shlex.quote(scene or arguments.scene)]
    for option, given in (("--with", arguments.made_with), ("--set", arguments.set), ("--initial", arguments.initial)):
        words += [f"{option} {shlex.quote(f'{name}={value:.12g}')}" for name, value in given]
    words += [f"--t-end {arguments.t_end:.12g}"] if arguments.t_end is not None else []
    words += [f"--start {arguments.start}"] if arguments.start is not None else []
    return " ".join(words)


def add_accuracy_options(command: argparse.ArgumentParser) -> None:
    """What is graded, and how well it has to be met."""
    command.add_argument(
        "--tolerance",
        type=positive,
        default=1e-3,
        metavar="ERROR",
        help="RMS error over the motion relative to each amplitude (default: %(default)s)",
    )
    command.add_argument(
        "--graded",
        type=names,
        metavar="NAMES",
        help="coordinates that are graded, separated by commas (default: all independent ones)",
    )


def add_run_options(command: argparse.ArgumentParser) -> None:
    """How a scene is stepped; what is not given comes from the scene."""
    add_motion_options(command)
    group = command.add_argument_group("run", "What is not given comes from the scene's [simulation].")
    group.add_argument("--dt", type=number, metavar="SECONDS", help="major step dt_L")
    group.add_argument("--m", type=ratios, metavar="10,4", help="ratio of each next group's step, slow to fast")
    group.add_argument(
        "--scheme",
        help="time stepping scheme, for instance exponential or single_rate; auto takes "
        "steps that follow from --tolerance, by the method that the stiffness of the motion asks for",
    )
    group.add_argument(
        "--tolerance",
        type=positive,
        metavar="ERROR",
        help="relative error instead of a step: steps as long as it allows (with auto, the default then: 1e-3)",
    )
    group.add_argument(
        "--option",
        action="append",
        type=option,
        default=[],
        metavar="NAME=VALUE",
        help="change a reading or tolerance of the scheme, such as common_update=direct; repeatable",
    )
    group.add_argument("--force", action="store_true", help="run although the step is above its limit at the start")
    group.add_argument("--save-every", type=int, metavar="STEPS", help="keep one of so many major steps")
    add_engine(group)


def add_engine(group: Any) -> None:
    """What steps a run."""
    group.add_argument(
        "--engine",
        choices=("auto", "compiled", "interpreted", "compiled-library", "c"),
        default="auto",
        help="compiled (by LLVM; auto means this where it is there), interpreted (by CasADi), compiled-library "
        "(equal to it bit for bit), c (by the machine's C compiler)",
    )


def add_checkpoint_options(command: argparse.ArgumentParser) -> None:
    """What of a long run is left on the disk while it goes on."""
    group = command.add_argument_group("long runs")
    group.add_argument(
        "--checkpoint-every",
        type=int,
        metavar="STEPS",
        help="major steps between two checkpoints (default: one a minute)",
    )
    group.add_argument("--stream", metavar="DIR", help="folder that takes the samples instead of memory")


def names(text: str) -> list[str]:
    """Comma-separated names."""
    found = [part.strip() for part in text.split(",") if part.strip()]
    if not found:
        raise argparse.ArgumentTypeError("at least one name is needed")
    return found


def option(text: str) -> tuple[str, Any]:
    """NAME=VALUE with a word, a number, or numbers separated by commas as the value."""
    name, equals, value = text.partition("=")
    if not equals or not name:
        raise argparse.ArgumentTypeError(f"{text!r} is not NAME=VALUE")
    parsed = [_word_or_number(part) for part in value.split(",")]
    return name, parsed[0] if len(parsed) == 1 else tuple(parsed)


def _word_or_number(text: str) -> str | int | float:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return text


def number(text: str) -> float:
    """A finite float."""
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a number; give it in SI units without the unit, such as 1"
        ) from None
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text!r} is not a finite number")
    return value


def positive(text: str) -> float:
    """A finite float above zero."""
    value = number(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not above zero")
    return value


def ratios(text: str) -> list[int]:
    """Comma-separated whole numbers; an empty text is an empty list."""
    try:
        return [int(part) for part in text.split(",")] if text.strip() else []
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a list of whole numbers such as 10,4") from None


def assignment(text: str) -> tuple[str, float]:
    """NAME=VALUE with a finite number."""
    name, equals, value = text.partition("=")
    try:
        if name.strip() and equals:
            return name.strip(), number(value)
    except (ValueError, argparse.ArgumentTypeError):
        pass
    raise argparse.ArgumentTypeError(f"{text!r} is not NAME=VALUE with a finite number")
