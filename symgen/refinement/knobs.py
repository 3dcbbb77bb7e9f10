"""What of a scene's modelling can be turned, each by scenes in which nothing else differs.

The runtime finds `refinements` as the entry point `symgen.refinements` and never imports this package.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from functools import partial
from typing import Any

from symgen.mechanism.scene import SceneRecord
from symgen.refinement.pieces import CannotCut, Chain, chains_of, recut
from symgen.schema.errors import SceneError

Data = dict[str, Any]
LARGEST_SET = 500  # modes of a set, as the schema has it
FAMILIES = ("lateral", "lateral_z", "axial", "torsion")  # in the order of a beam's coordinates
OF_THE_MOTION = ("t_end", "seen_every", "start")  # of `simulation`: how steps are made is said by who makes them
SHAPES, PIECES, SWITCH = 4 / 3, 2, 1.0  # the factor of more shapes; the order of pieces and meshes; a switch is itself
MATRICES = {
    "mesh": "the scene holds its matrices, no mesh: give a model by another mesh in coarser= or finer=",
    "modes": "the scene holds no other shapes of it: give a model with twice as many in finer=",
}
NO_SHEAR = "beams have no shear deformation (Euler-Bernoulli): for stocky ones take a finite-element body"


def refinements(scene_toml_text: str, steps: int = 1) -> list[Data]:
    """The knobs of a scene, as plain values.

    Parameters
    ----------
    scene_toml_text : str
        The scene.
    steps : int, optional
        How often each knob is turned.

    Returns
    -------
    list of dict
        Each with `name` ("rod.modes"), `kind`, `now`; `levels`, a list of {"to", "scene" (TOML text)}, ever further
        away, each with `renamed`, elastic coordinates that have another name there; `factor`, by which the difference
        to the first level is the error; `order`, by which errors fall with the size, 0 of a switch; `unlike`, bodies
        whose coordinates mean something else there; or, in place of levels, `blind`, why it cannot be turned.

    Raises
    ------
    SceneError
        For a bad scene.
    """
    data = SceneRecord.from_toml_text(scene_toml_text).to_dict()
    found: list[Data] = []
    for chain in chains_of(data):
        found += _of_beams(data, chain, steps)
    for body in data.get("bodies", []):
        if body["type"] in ("flexible", "modal"):
            found += [_blind(body["name"], kind, why) for kind, why in MATRICES.items()]
    return found


def _of_beams(data: Data, chain: Chain, steps: int) -> Iterator[Data]:
    """The knobs of a beam, or of equal beams welded into one."""
    body, name = chain.first, chain.first["name"]
    lumped = body.get("mesh") == "lumped"
    yield _modes(data, chain, steps)
    if lumped:
        yield _elements(data, chain, steps)
        yield _blind(name, "pieces", "a lumped mesh is not cut: its elements are turned")
    else:
        yield _pieces(data, chain, steps)
    if not body.get("stiffening") and ("lateral" in body or "lateral_z" in body):
        yield _switched(data, chain, "stiffening", "off", "on", {"stiffening": True})
    spatial = data.get("space") == "spatial"
    for family in FAMILIES:
        if family in body or (family in ("lateral_z", "torsion") and not spatial):
            continue
        count = body.get("lateral", {"modes": 1})["modes"]
        yield _switched(data, chain, family, "0", str(count), {family: {"modes": count}})
    yield _blind(name, "shear", NO_SHEAR)


def _modes(data: Data, chain: Chain, steps: int) -> Data:
    body = chain.first
    sets = [(family, body[family]["modes"]) for family in FAMILIES if family in body]
    counts = [dict(sets)]
    for _ in range(steps):
        counts.append({family: min(max(2 * n, n + 2), LARGEST_SET) for family, n in counts[-1].items()})

    def level(k: int) -> Data:
        scene = _bare(data)
        for one in chain.members(scene):
            for family, n in counts[k].items():
                one[family]["modes"] = n
        return _renamed(scene, _moved(chain, sets, counts[k]))

    shown = [" + ".join(str(n) for n in one.values()) for one in counts]
    found = _knob(chain, "modes", shown[0], shown[1:], [partial(level, k) for k in range(1, steps + 1)])
    for entry, one in zip(found.get("levels", []), counts[1:], strict=False):
        entry["renamed"] = _moved(chain, sets, one)
    return found | {"factor": SHAPES, "order": 2}


def _moved(chain: Chain, sets: Sequence[tuple[str, int]], counts: dict[str, int]) -> dict[str, str]:
    """Elastic coordinates whose number is another one, since sets before theirs are larger."""
    moved: dict[int, int] = {}
    old = new = 0
    for family, n in sets:
        moved |= {old + k: new + k for k in range(1, n + 1)}
        old, new = old + n, new + counts[family]
    return {f"{name}.q{k}": f"{name}.q{to}" for name in chain.names for k, to in moved.items() if k != to}


def _renamed(scene: Data, names: dict[str, str]) -> Data:
    """The scene with other names of coordinates, wherever they stand."""
    if not names:
        return scene
    pattern = re.compile(r"\b(" + "|".join(re.escape(name) for name in names) + r")\b")

    def walked(value: Any) -> Any:
        if isinstance(value, dict):
            return {walked(key): walked(one) for key, one in value.items()}
        if isinstance(value, list):
            return [walked(one) for one in value]
        return pattern.sub(lambda found: names[found[0]], value) if isinstance(value, str) else value

    keys = set(scene) - {"name", "title", "description"}
    return {key: walked(value) if key in keys else value for key, value in scene.items()}


def _elements(data: Data, chain: Chain, steps: int) -> Data:
    """Half the elements; twice as many where half cannot have the modes."""
    n = int(chain.first["elements"])

    def level(count: int) -> Data:
        scene = _bare(data)
        for one in chain.members(scene):
            one["elements"] = count
        return scene

    tried = {}
    for half in (True, False):
        counts = [n // 2**k if half else n * 2**k for k in range(1, steps + 1)]
        tried = _sized(chain, "elements", n, counts, level)
        if tried.get("levels"):
            return tried
    return tried


def _pieces(data: Data, chain: Chain, steps: int) -> Data:
    """Half the pieces of welded ones, two of a single one."""
    n = len(chain.names)
    counts: list[int] = []
    for _ in range(steps):
        last = counts[-1] if counts else n
        counts.append(2 * last if n == 1 else (last + 1) // 2)
    if n > 1 and len(set(counts)) < steps:
        return _blind(chain.first["name"], "pieces", f"{n} pieces cannot be halved {steps} times")
    found = _sized(chain, "pieces", n, counts, lambda count: recut(_bare(data), chain, count))
    return found | {"unlike": chain.names}


def _sized(chain: Chain, kind: str, n: int, counts: list[int], level: Callable[[int], Data]) -> Data:
    """A knob whose error falls with the square of the size: the first level tells the error of n by Richardson."""
    ratio = counts[0] / n if counts[0] else 1.0
    factor = 1 / (ratio**-PIECES - 1) if ratio < 1 else 1 / (1 - ratio**-PIECES) if ratio > 1 else 1.0
    makes = [partial(level, count) for count in counts]
    return _knob(chain, kind, str(n), [str(count) for count in counts], makes) | {"factor": factor, "order": PIECES}


def _switched(data: Data, chain: Chain, kind: str, now: str, to: str, change: Data) -> Data:
    """Something that is left out of the beams, put in."""

    def level() -> Data:
        scene = _bare(data)
        for one in chain.members(scene):
            one |= deepcopy(change)
        return scene

    return _knob(chain, kind, now, [to], [level]) | {"factor": SWITCH, "order": 0}


def _knob(chain: Chain, kind: str, now: str, to: Sequence[str], makes: Sequence[Callable[[], Data]]) -> Data:
    """A knob with its scenes, or why one of them cannot be."""
    name = chain.first["name"]
    try:
        texts = [SceneRecord.from_dict(make()).to_toml() for make in makes]
    except (SceneError, CannotCut) as error:
        return _blind(name, kind, str(error))
    levels = [{"to": one, "scene": text, "renamed": {}} for one, text in zip(to, texts, strict=True)]
    return {"name": f"{name}.{kind}", "kind": kind, "now": now, "levels": levels, "unlike": []}


def _blind(name: str, kind: str, why: str) -> Data:
    return {"name": f"{name}.{kind}", "kind": kind, "blind": why}


def _bare(data: Data) -> Data:
    """The scene without what chooses coordinates, groups and steps, which another number of shapes would not fit."""
    found = {key: value for key, value in deepcopy(data).items() if key not in ("partition", "simulation")}
    kept = {key: value for key, value in data.get("simulation", {}).items() if key in OF_THE_MOTION}
    return found | ({"simulation": kept} if kept else {})
