"""Functions that a folder leaves out: derived from its scene when they are asked for.

Deriving needs the generator, which this package does not have: it is found by its entry point `symgen.functions`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cache, partial
from pathlib import Path

import casadi as ca

from runtime.contract.errors import ModelError, SymgenError
from runtime.contract.records import Description

ENTRY_POINTS = "symgen.functions"
Builders = Mapping[str, Callable[[], ca.Function]]
SAME = ("coordinates", "q_i", "q_d", "groups", "constraints", "redundant", "bounded", "inputs")


def left_out(folder: Path, names: Iterable[str], described: Description, scene_toml: str) -> Builders:
    """What builds each function of these names, with the arguments of the emitted ones, c = p among them.

    A builder raises ModelError where no generator is installed, where it refuses the scene, and where the installed
    one chooses other coordinates or parameters than the folder has.
    """

    @cache
    def builders() -> Builders:
        from importlib.metadata import entry_points  # takes as long to import as a short run

        found = next(iter(entry_points(group=ENTRY_POINTS)), None)
        if found is None:
            raise _refusal(folder, "no generator is installed", "install symgen beside the runtime")
        try:
            model = found.load()(scene_toml)
        except SymgenError as error:
            raise _refusal(folder, str(error), "generate the folder anew") from error
        own = [entry.name for entry in described.parameters]
        if own != [entry.name for entry in model.description.parameters] or any(
            getattr(model.description, what) != getattr(described, what) for what in SAME
        ):
            raise _refusal(folder, "the installed version derives another model of its scene", "generate it anew")
        derived: Builders = model.builders
        return derived

    def build(name: str) -> ca.Function:
        return builders()[name]()

    return {name: partial(build, name) for name in names}


def _refusal(folder: Path, problem: str, remedy: str) -> ModelError:
    item = f"{folder} leaves out functions that it was not asked for when it was written"
    return ModelError(item, problem, f"{remedy}, or write all with: symgen generate {folder} --complete")
