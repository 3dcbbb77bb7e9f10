"""`symgen advise`: which method and step suit a scene."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from symgen.cli.arguments import add_accuracy_options, add_command, add_motion_options, add_scene, motion_words
from symgen.cli.outcome import Outcome
from symgen.cli.progress import Progress

if TYPE_CHECKING:
    from runtime.studies.advice.advise import Advice


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "advise",
        run,
        "Find the method and step that suit a scene.",
        "Frequencies and damping over the motion, groups by the widest gap, then every method is tried on the motion "
        "until it meets the tolerance; the fastest that keeps its stability limit is advised.",
    )
    add_scene(command)
    add_accuracy_options(command)
    add_motion_options(command)


def run(arguments: argparse.Namespace) -> Outcome:
    """The advice, with what it rests on."""
    from runtime.studies.advice.advise import advise
    from runtime.studies.advice.words import advice_data, advice_lines
    from symgen.cli.sources import opened_model

    model = opened_model(arguments.scene, arguments.made_with)
    with Progress(f"symgen {model.name}") as progress:
        advice: Advice = advise(
            model,
            tolerance=arguments.tolerance,
            graded=arguments.graded,
            t_end=arguments.t_end,
            parameters=dict(arguments.set),
            initial=dict(arguments.initial),
            start=arguments.start,
            note=progress.note,
        )
    return Outcome({"advice": advice_data(advice)}, advice_lines(advice, motion_words(arguments)))
