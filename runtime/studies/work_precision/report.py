"""The work-precision report of a model in one call: methods compared, the files written."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from runtime.contract.model import Model
from runtime.running.ladder import Method
from runtime.studies.work_precision.comparison import LONGEST, Comparison, Note, work_precision
from runtime.studies.work_precision.comparison_files import write_comparison, write_tables
from runtime.studies.work_precision.methods import methods_named, usual_adaptive, usual_methods


def report(
    model: Model,
    folder: str | Path | None = None,
    *,
    methods: Sequence[str] | None = None,
    tolerance: float = 1e-3,
    longest: float = LONGEST,
    note: Note = lambda text: None,
    words: str = "",
    **motion: Any,
) -> Comparison:
    """Error against time of many methods on one motion, ranked at `tolerance`; `recommendation()` says which to take.

    folder: takes comparison.html, .md, .csv, .json and two pictures, its tables after each method. methods: names such
    as `rk4` or `coupled:4`; those that make sense if left out. longest [s]: where a method's curve ends. words: the
    scene and its motion, for a command that is shown. motion: `t_end`, `parameters`, `initial`, `start` as of
    `simulate`; `graded`: names of what is judged. Raises NoReference, and what `simulate` raises.
    """
    chosen: list[Method | str] = [*usual_methods(model), *usual_adaptive(model)]
    if methods:
        chosen = methods_named(model, list(methods))

    def keep(so_far: Comparison) -> None:
        if folder is not None:
            write_tables(so_far, folder)

    found = work_precision(model, chosen, tolerance, longest, note, keep, **motion)
    if folder is not None:
        write_comparison(found, folder, words or model.name)
    return found
