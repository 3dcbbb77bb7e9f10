"""Scene in; a folder of generated code out, or a model whose functions are derived when they are first asked for.

A run asks for few functions, and those that grow with the square of a long chain's length are not among them. Functions
on demand read p itself, c = p: what depends on parameters only is taken out of a step by the run's own preparation
(runtime/engine/prepare.py). So values agree with those of the emitted text to rounding. What a run asked for can be
written behind it (`leave`); the rest is derived when the folder that was written is asked for it.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.tape import as_function
from runtime.model import Model
from symgen.emission.description import clean, describe
from symgen.emission.files import emit
from symgen.emission.write import compare_model, write_model
from symgen.pipeline import Derived, derive, derive_on_demand, looked_at

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord

LARGEST_COMPLETE = 200  # coordinates of a scene that `generate` writes with all functions where nothing else is said
QUADRATIC = {
    "condensed", "augmented", "blocks", "dQ_hat_dq_i", "dQ_hat_dq_i_dot", "residual_jacobian", "deflections",
    "deflection_response",
}  # fmt: skip


def generate(
    scene: SceneRecord,
    folder: str | Path,
    functions: frozenset[str] | None = None,
    complete: bool = False,
    largest: int = LARGEST_COMPLETE,
) -> Path:
    """Derive, condense and emit a scene into a folder.

    Parameters
    ----------
    scene : SceneRecord
        The mechanism.
    folder : path
        Where the code goes.
    functions : frozenset of str, optional
        Names of the functions to emit. By default all, but for a tree of more than `largest` coordinates those that
        grow
        with its length, not with the square of it; the folder says which these are, and the others are derived when a
        model loaded from it is asked for them.
    complete : bool, optional
        All functions, whatever the length.
    largest : int, optional
        Coordinates up to which all functions are emitted.

    Returns
    -------
    Path
        The folder.

    Raises
    ------
    SceneError
        For bad scenes, and for a folder that cannot be written.
    """
    target = Path(folder)
    write_model(emit(_derived(scene, functions, complete, largest)), target)
    return target


def check(
    scene: SceneRecord,
    folder: str | Path,
    functions: frozenset[str] | None = None,
    complete: bool = False,
) -> str:
    """Unified diff between `folder` and what the generator emits now; empty if they agree.

    A folder that says what it leaves out is compared with the functions that it has, unless others are named or it is
    to be complete.
    """
    left_out = _left_out(Path(folder)) if functions is None and not complete else []
    if left_out:
        found = derive_on_demand(scene)
        files = emit(looked_at(found, [name for name in found.tapes if name not in left_out]))
    else:
        files = emit(_derived(scene, functions, complete))
    return compare_model(files, Path(folder))


def _left_out(folder: Path) -> list[str]:
    """Names of the functions that a folder says it leaves out; none where it says nothing."""
    try:
        found = json.loads((folder / "manifest.json").read_text(encoding="utf-8")).get("left_out", [])
        return [str(name) for name in found]
    except (OSError, ValueError, AttributeError, TypeError):
        return []


def _derived(
    scene: SceneRecord, functions: frozenset[str] | None, complete: bool, largest: int = LARGEST_COMPLETE
) -> Derived:
    if functions is not None or complete or len(scene.coordinates()) <= largest:
        return derive(scene, functions)
    found = derive_on_demand(scene)
    if "forward_dynamics" not in found.tapes:
        return derive(scene)
    short = [name for name in found.tapes if name not in QUADRATIC and not name.startswith("substep_")]
    return looked_at(found, short)


def model_of(scene: SceneRecord) -> Model:
    """The model of a scene, its functions derived on demand; for what is to be kept or sent elsewhere: `generate`.

    Raises SceneError for a bad scene; what only a function shows is raised when that is asked for.
    """
    derived = derive_on_demand(scene)
    text, initial = scene.to_toml(), derived.initial
    return Model(
        description=describe(derived, functions=()),
        initial_q=np.array([clean(value) for value in initial.q]),
        initial_q_dot=np.array([clean(value) for value in initial.q_dot]),
        builders=FunctionsOnDemand(derived),
        initial_changes=initial.changed,
        assembly=tuple(text for _, text in initial.reported),
        digest=digest_on_demand(text),
        scene_toml=text,
    )


def digest_on_demand(scene_toml: str) -> str:
    """What stands for the hash of a manifest: of the scene's text and of what derives from it."""
    parts = ["on demand", *(version(package) for package in ("casadi", "sympy", "symgen")), scene_toml]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def leave(model: EmittedModel, folder: str | Path) -> Path:
    """Write a model of `model_of` with the functions that were asked of it until now; returns the folder.

    model.md and the manifest say which were left out: a model that is loaded from the folder has these derived when
    they are asked for. Raises SceneError for a folder that cannot be written or holds files of somebody else, and
    ModelError for a model that was not derived on demand.
    """
    if not isinstance(model.builders, FunctionsOnDemand):
        raise ModelError(
            model.name, "its functions were not derived on demand", "copy its folder, or generate the scene"
        )
    write_model(emit(looked_at(model.builders.derived)), Path(folder))
    return Path(folder)


class FunctionsOnDemand(Mapping[str, Callable[[], ca.Function]]):
    """What builds each function of a scene that was derived on demand, by name."""

    def __init__(self, derived: Derived) -> None:
        self.derived = derived

    def __getitem__(self, name: str) -> Callable[[], ca.Function]:
        if name not in self:
            raise KeyError(name)
        return lambda: as_function(name, self.derived.tapes[name])

    def __contains__(self, name: object) -> bool:
        return name in self.derived.tapes

    def __iter__(self) -> Iterator[str]:
        return iter(self.derived.tapes)

    def __len__(self) -> int:
        return len(self.derived.tapes)
