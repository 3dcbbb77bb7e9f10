"""The same scene with other independent coordinates, for a run that leaves the region of its first choice.

The runtime finds `generate_variant` as the entry point `symgen.variants` and never imports this package.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from symgen.emission.files import emit
from symgen.emission.write import write_model
from symgen.mechanism.scene import SceneRecord
from symgen.pipeline import Configuration, derive
from symgen.scene import SceneError

OF_THE_MOTION = ("t_end", "seen_every", "start")  # of `simulation`: how steps are made says who makes them


def generate_variant(
    scene_toml_text: str,
    independent: Sequence[str],
    groups: Sequence[tuple[str, Sequence[str]]],
    folder: Path,
    state: Mapping[str, float] | None = None,
    redundant: Sequence[str] = (),
    functions: Sequence[str] | None = None,
) -> Path:
    """Derive a scene with q_i = independent and emit it into `folder`, which `runtime.load_model` reads.

    groups: (name, coordinates) from slow to fast. state: all coordinates [m, rad] where the variant is wanted, taken
    as they are; its loop unknowns are chosen there, and it becomes the variant's initial state, at rest. redundant:
    labels of the rows that the first derivation found redundant; they stay out, as the rank at `state` may be lower.
    The scheme of the scene, its step, ratios and tolerance stay behind: a run brings its own.
    functions: names of the functions to emit, all by default. Without state the scene's own initial state is taken,
    and redundant rows are found anew. Returns the folder. Raises SceneError if q_i cannot be independent there, for
    an incomplete state, and for a folder that cannot be written.
    """
    data = SceneRecord.from_toml_text(scene_toml_text).to_dict()
    data["partition"] = {
        **{key: value for key, value in data.get("partition", {}).items() if key == "stiff"},
        "independent": list(independent),
        "groups": [{"name": name, "coordinates": list(names)} for name, names in groups],
    }
    data["simulation"] = {key: value for key, value in data.get("simulation", {}).items() if key in OF_THE_MOTION}
    at = None
    if state is not None:
        data["initial"] = {"coordinates": dict(state)}
        at = Configuration(state, frozenset(redundant))
    scene = SceneRecord.from_dict(data)
    missing = sorted(set(scene.coordinates()) - set(state)) if state is not None else []
    if missing:
        raise SceneError("state", f"has no value for {', '.join(missing)}", "give all coordinates")
    wanted = None if functions is None else frozenset(functions)
    write_model(emit(derive(scene, wanted, at)), Path(folder))
    return Path(folder)
