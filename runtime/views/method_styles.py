"""How methods are drawn: each has a colour and a marker of its own, the same in every picture.

A family of methods has a marker and shades of one colour, for steps without sub-steps, with two, and with more.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import prod
from typing import Any, Protocol


class Method(Protocol):
    """What a method is drawn by."""

    @property
    def scheme(self) -> str:
        """The name of its scheme."""

    @property
    def m(self) -> tuple[int, ...] | None:
        """Ratios of steps."""

    @property
    def options(self) -> Mapping[str, Any]:
        """Changes to those of the scheme."""

    @property
    def label(self) -> str:
        """What reports call it."""


@dataclass(frozen=True)
class MethodOfRun:
    """The scheme and ratios that a run was made with."""

    scheme: str
    m: tuple[int, ...] | None = None
    options: Mapping[str, Any] = field(default_factory=dict)

    @property
    def label(self) -> str:
        """Both."""
        return f"{self.scheme} m={self.m}"


@dataclass(frozen=True)
class Family:
    """marker: of matplotlib; colours: of its methods with one sub-step, two, and more of them, in their order."""

    marker: str
    colours: tuple[str, ...]


FAMILIES = {
    "single_rate": Family("o", ("#111111",)),
    "single_rate predictor": Family("H", ("#8c8c8c",)),
    "printed": Family("*", ("#e3170a", "#ff7043", "#9e0b00", "#ffab91")),
    "coupled": Family("D", ("#b8860b", "#e6a800", "#8a5a00", "#f5d36b")),
    "exponential": Family("s", ("#0072b2", "#56b4e9", "#08306b", "#9ecae1")),
    "exponential order=5": Family("P", ("#6a4c93", "#b39ddb")),
    "exponential_rk4": Family("^", ("#009e73",)),
    "exponential_adams": Family("v", ("#7cb342",)),
    "rk4": Family("<", ("#cc79a7",)),
    "dopri5": Family("d", ("#ff4fa3",)),
    "dop853": Family(">", ("#7a0177",)),
    "radau": Family("X", ("#8d6e63",)),
}
FILLS = ("full", "none", "bottom", "left")  # of a family's markers, in the same order


def method_styles(methods: Sequence[Method]) -> dict[str, dict[str, Any]]:
    """Colour, marker, and how it is filled, by label: what matplotlib's lines take."""
    members: dict[str, list[Method]] = {}
    for method in methods:
        members.setdefault(family_of(method), []).append(method)
    found: dict[str, dict[str, Any]] = {}
    for name, own in members.items():
        family = FAMILIES[name]
        for method, place in zip(own, _places(own), strict=True):
            colour = family.colours[place % len(family.colours)]
            found[method.label] = {
                "color": colour,
                "marker": family.marker,
                "fillstyle": FILLS[place % len(FILLS)],
                "linestyle": "-" if place < len(family.colours) else (0, (4, 2)),
                "zorder": 3 if name == "printed" else 2,
            }
    return found


def family_of(method: Method) -> str:
    """The name in FAMILIES."""
    own = f"{method.scheme} order={method.options['order']}" if "order" in method.options else method.scheme
    if method.options.get("common_velocity") == "predictor":
        own = f"{method.scheme} predictor"
    return own if own in FAMILIES else method.scheme


def _places(methods: Sequence[Method]) -> list[int]:
    """Of methods of a family among its colours: by their sub-steps, whatever their order in a picture."""
    sub_steps = [prod(method.m or (1,)) for method in methods]
    order = sorted({(max(count, 1), method.label) for count, method in zip(sub_steps, methods, strict=True)})
    found, taken = dict[str, int](), set[int]()
    for count, label in order:
        place = next(k for k in range(min(count, 3) - 1, len(order) + 3) if k not in taken)
        found[label] = place
        taken.add(place)
    return [found[method.label] for method in methods]
