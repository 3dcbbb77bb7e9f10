"""Equal beams that are welded into one, cut into another number of pieces."""

from __future__ import annotations

import re
from collections.abc import Iterator
from copy import deepcopy
from dataclasses import dataclass
from typing import Any

Data = dict[str, Any]
ROUNDED = 12  # digits of a place along the beams
TURNS = ("theta", "e0", "e1", "e2", "e3", "omega_x", "omega_y", "omega_z")  # what straight pieces have in common
PLACES = ("x", "y", "z")
FAMILIES = {"lateral": 2, "lateral_z": 2, "axial": 1, "torsion": 1}  # and the static shapes of ends that are welded


class CannotCut(Exception):
    """Beams that cannot be cut otherwise: the message says why."""


@dataclass(frozen=True)
class Chain:
    """Equal beams, each welded with its start to the end of the one before; bodies: their entries in the scene."""

    bodies: list[Data]
    welds: list[str]

    @property
    def first(self) -> Data:
        """The entry of the first."""
        return self.bodies[0]

    @property
    def names(self) -> list[str]:
        """Of the beams."""
        return [str(one["name"]) for one in self.bodies]

    def members(self, scene: Data) -> Iterator[Data]:
        """Their entries in a copy of the scene."""
        yield from (one for one in scene["bodies"] if one["name"] in self.names)


def chains_of(data: Data) -> list[Chain]:
    """All beams of a scene, those that are welded pieces of one together."""
    beams = {one["name"]: one for one in data.get("bodies", []) if one["type"] == "beam"}
    after: dict[str, tuple[str, str]] = {}
    for joint in data.get("joints", []):
        if joint["type"] != "weld":
            continue
        ends = {marker.partition(".")[2]: marker.partition(".")[0] for marker in (joint["marker_a"], joint["marker_b"])}
        if set(ends) != {"end", "start"}:
            continue
        a, b = (beams.get(ends[key]) for key in ("end", "start"))
        if a is not None and b is not None and a is not b and _alike(a, b):
            after[a["name"]] = (b["name"], joint["name"])
    seconds = {name for name, _ in after.values()}
    found = []
    for name in beams:
        if name in seconds:
            continue
        names, welds = [name], []
        while names[-1] in after:
            following, weld = after[names[-1]]
            names.append(following)
            welds.append(weld)
        found.append(Chain([beams[one] for one in names], welds))
    return found


def _alike(a: Data, b: Data) -> bool:
    """Are two beams of the same section, length and shapes, their own markers at the ends untouched?"""
    return _section(a) == _section(b) and "end" not in a.get("markers", {}) and "start" not in b.get("markers", {})


def _section(body: Data) -> Data:
    kept = {key: value for key, value in body.items() if key not in ("name", "markers", "free")}
    for key, value in kept.items():
        if isinstance(value, dict) and "ends" in value:  # of the last piece it may be another one
            kept[key] = {name: one for name, one in value.items() if name != "ends"}
    return kept


def recut(scene: Data, chain: Chain, count: int) -> Data:
    """The scene with the beams of a chain cut into `count` equal ones, each with the shapes of one of before.

    Those of a single beam have the static shapes of their welded ends, too: with fewer they would not be finer. Ends
    are what joints and loads ask for. Markers, distributed loads and the start follow. Raises CannotCut.
    """
    return _Cut(scene, chain, count).scene


class _Cut:
    """Another number of pieces: u is the place along all beams, in lengths of one of before."""

    def __init__(self, scene: Data, chain: Chain, count: int) -> None:
        self.scene, self.chain, self.count = scene, chain, count
        self.before = len(chain.names)
        self.first = chain.names[0]
        taken = {one["name"] for key in ("bodies", "joints", "loads", "measures") for one in scene.get(key, [])}
        own = [chain.names[k] if k < self.before else f"{self.first}_piece{k + 1}" for k in range(count)]
        if clash := sorted(taken & set(own[self.before :])):
            raise CannotCut(f"the scene has a '{clash[0]}'")
        self.names = own
        if chain.first.get("damping_ratio") and "damping_frequency" not in chain.first:
            raise CannotCut("damping_ratio is that of each shape of a piece: give damping_frequency, then it is kept")
        self.markers: dict[str, Data] = {name: {} for name in own}
        self.references = self._markers()
        self._cut_bodies()
        self._cut_joints()
        self._cut_loads()
        self._cut_start()
        self._refuse_what_is_left()
        self.scene = self._referred(self.scene)

    def _place(self, u: float, start: bool) -> tuple[int, float]:
        """The piece that holds u, and the fraction of its length; start: between two pieces the second one."""
        s = round(u * self.count / self.before, ROUNDED)
        k = min(int(s), self.count - 1)
        if k and s == k and not start:
            k -= 1
        return k, s - k

    def _markers(self) -> dict[str, str]:
        """New references of markers by the old ones; puts the markers into their pieces."""
        found: dict[str, str] = {}
        for i, body in enumerate(self.chain.bodies):
            listed = {"start": {"at": 0.0}, "end": {"at": 1.0}} | body.get("markers", {})
            for name, marker in listed.items():
                at = float(marker["at"])
                k, place = self._place(i + at, start=at == 0.0)
                end = {0.0: "start", 1.0: "end"}.get(place)
                plain = set(marker) == {"at"}
                new = end if plain and end else f"{body['name']}_{name}"
                if not (plain and end):
                    self.markers[self.names[k]][new] = {**marker, "at": place}
                found[f"{body['name']}.{name}"] = f"{self.names[k]}.{new}"
        return found

    def _cut_bodies(self) -> None:
        length = self.chain.first["length"]
        share = self.before / self.count
        cut = f"({length}) * {share!r}" if isinstance(length, str) else length * share
        pieces = []
        for k, name in enumerate(self.names):
            piece = {**deepcopy(self.chain.first), "name": name, "length": cut}
            piece.pop("markers", None)
            if k:
                piece.pop("free", None)
            for key in FAMILIES.keys() & piece.keys():
                piece[key].pop("ends", None)
                if self.before == 1:
                    piece[key]["modes"] += FAMILIES[key]
            pieces.append(piece | ({"markers": self.markers[name]} if self.markers[name] else {}))
        bodies = self.scene["bodies"]
        at = next(k for k, one in enumerate(bodies) if one["name"] == self.first)
        others = [one for one in bodies if one["name"] not in self.chain.names]
        at -= sum(one["name"] in self.chain.names for one in bodies[:at])
        self.scene["bodies"] = [*others[:at], *pieces, *others[at:]]

    def _cut_joints(self) -> None:
        joints = [one for one in self.scene.get("joints", []) if one["name"] not in self.chain.welds]
        welds = [
            {"type": "weld", "name": f"{self.first}_weld{k + 1}", "marker_a": f"{a}.end", "marker_b": f"{b}.start"}
            for k, (a, b) in enumerate(zip(self.names, self.names[1:], strict=False))
        ]
        self.scene["joints"] = [*joints, *welds]

    def _cut_loads(self) -> None:
        loads: list[Data] = []
        for load in self.scene.get("loads", []):
            if load.get("beam") in self.chain.names:
                loads += self._cut_load(load)
            else:
                loads.append(load)
        if loads:
            self.scene["loads"] = loads

    def _cut_load(self, load: Data) -> Iterator[Data]:
        """A distributed load on each piece that it reaches."""
        if load["type"] != "distributed":
            raise CannotCut(f"load '{load['name']}' has places along '{load['beam']}'")
        if load.get("frame") == "body":
            raise CannotCut(
                f"load '{load['name']}' turns with the frame of '{load['beam']}', and pieces have their own"
            )
        if any(isinstance(one, str) and re.search(r"\bs\b", one) for one in load["components"]):
            raise CannotCut(f"load '{load['name']}' is an expression of the place along '{load['beam']}'")
        i = self.chain.names.index(load["beam"])
        scale = self.count / self.before
        begin, end = ((i + load.get(key, usual)) * scale for key, usual in (("start", 0.0), ("end", 1.0)))
        for k, name in enumerate(self.names):
            low, high = (round(min(max(one - k, 0.0), 1.0), ROUNDED) for one in (begin, end))
            if high > low:
                yield {**load, "name": f"{load['name']}_{name}", "beam": name, "start": low, "end": high}

    def _cut_start(self) -> None:
        """Pieces begin as straight as the beam did: turned alike, the first one where it was, without deflections."""
        start = self.scene.get("initial", {})
        for section, values in start.items():
            own = {name: one for name, one in values.items() if name.partition(".")[0] in self.chain.names}
            start[section] = {name: one for name, one in values.items() if name not in own}
            common: dict[str, Any] = {}
            for name, one in own.items():
                body, _, key = name.partition(".")
                value = one["value"] if isinstance(one, dict) else one
                if key in TURNS:
                    if common.setdefault(key, one) != one:
                        raise CannotCut("its pieces do not begin in line")
                elif key in PLACES:
                    if body == self.first:
                        start[section][name] = one
                elif value != 0.0:
                    raise CannotCut(f"'{name}' begins with {value:g}, which other shapes do not have")
            for key, one in common.items():
                value = one["value"] if isinstance(one, dict) else one
                start[section][f"{self.first}.{key}"] = one
                start[section] |= {f"{name}.{key}": value for name in self.names[1:]}

    def _refuse_what_is_left(self) -> None:
        """Coordinates of the beams, and the beams themselves, named where no marker is meant."""
        names = re.compile(r"\b(" + "|".join(map(re.escape, self.chain.names)) + r")\b(\.\w+)?")
        own = {"bodies", "initial", "name", "title", "description"}
        welds = {f"{self.first}_weld{k + 1}" for k in range(self.count)}
        for section, entries in self.scene.items():
            listed = entries if isinstance(entries, list) else [entries]
            for entry in listed if section not in own else ():
                called = entry.get("name", section) if isinstance(entry, dict) else section
                if called in welds or (isinstance(entry, dict) and entry.get("beam") in self.names):
                    continue
                for text in _texts(entry, ("name", "title", "description", "type", "unit")):
                    found = names.search(text)
                    if found and text not in self.references:
                        raise CannotCut(f"'{called}' names '{found[0]}', which is another thing of a piece")

    def _referred(self, scene: Data) -> Data:
        """The scene with the new references to markers, of joints, loads and measures."""

        def walked(value: Any) -> Any:
            if isinstance(value, dict):
                return {key: walked(one) for key, one in value.items()}
            if isinstance(value, list):
                return [walked(one) for one in value]
            return self.references.get(value, value) if isinstance(value, str) else value

        welds = {f"{self.first}_weld{k + 1}" for k in range(self.count)}
        for section in ("joints", "loads", "measures", "couplings"):
            if section in scene:
                scene[section] = [one if one["name"] in welds else walked(one) for one in scene[section]]
        return scene


def _texts(value: Any, without: tuple[str, ...] = ()) -> Iterator[str]:
    """All texts in an entry."""
    if isinstance(value, dict):
        for key, one in value.items():
            if key not in without:
                yield from _texts(one)
    elif isinstance(value, list):
        for one in value:
            yield from _texts(one)
    elif isinstance(value, str):
        yield value
