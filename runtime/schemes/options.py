"""What may be chosen about a scheme: each scheme has a record of its own, and each field of it brings its check."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from numbers import Real
from typing import Any, Self

from runtime.contract.errors import SymgenError

MOST_ITERATIONS = 100_000  # of an update that repeats itself until it has converged
MOST_UNROLLED = 50  # Newton steps that are written out one after another in a stage
LARGEST_TOLERANCE = 0.1  # of a step's error, relative to the amplitudes
LARGE_SYSTEM = 12  # independent coordinates beyond which the Jacobian by velocity costs more than it gives

Check = Callable[[str, Any, int], Any]  # (name, given value, groups) -> the value to use; raises SchemeError


class SchemeError(SymgenError, ValueError):
    """A scheme, step or option that cannot be used."""


def one_of(default: str, *others: str) -> Any:
    """An option that is one of several words."""
    allowed = (default, *others)

    def check(name: str, value: Any, groups: int) -> Any:
        if value not in allowed:
            raise SchemeError(f"{name} must be one of {', '.join(allowed)}, not {value!r}")
        return value

    return field(default=default, metadata={"check": check})


@dataclass(frozen=True)
class Options:
    """The options of a scheme by name; the record of each scheme is a subclass beside it.

    kinks: of loads, where the motion comes to a condition of theirs: `located`, so that steps end there, or `crossed`.
    """

    kinks: str = one_of("located", "crossed")

    @classmethod
    def names(cls) -> tuple[str, ...]:
        """Of all options, in order."""
        return tuple(one.name for one in fields(cls))

    @property
    def most_sub_steps(self) -> int:
        """The largest m that these options leave, of schemes that take sub-steps of all coordinates."""
        return MOST_ITERATIONS

    def checked(self, groups: int) -> Self:
        """The record with every value checked, and one tolerance per group. Raises SchemeError."""
        values = {one.name: one.metadata["check"](one.name, getattr(self, one.name), groups) for one in fields(self)}
        return replace(self, **values)


def whole_number(default: int, least: int = 1, most: int | None = None) -> Any:
    """An option that counts."""
    wanted = f"of at least {least}" if most is None else f"from {least} to {most}"

    def check(name: str, value: Any, groups: int) -> Any:
        whole = isinstance(value, int) and not isinstance(value, bool)
        if not whole or value < least or (most is not None and value > most):
            raise SchemeError(f"{name} must be a whole number {wanted}, not {value!r}")
        return value

    return field(default=default, metadata={"check": check})


def share(default: float, most: float) -> Any:
    """An option that is a number from 0 to `most`."""

    def check(name: str, value: Any, groups: int) -> Any:
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value <= most:
            raise SchemeError(f"{name} must be a number from 0 to {most:.3g}, not {value!r}")
        return value

    return field(default=default, metadata={"check": check})


def tolerances(default: float) -> Any:
    """An option of one positive number per group, slow to fast; a single one serves all."""

    def check(name: str, value: Any, groups: int) -> tuple[float, ...]:
        try:
            given = tuple(float(one) for one in (value if isinstance(value, tuple | list) else (value,)))
        except (TypeError, ValueError):
            given = ()
        found = given * groups if len(given) == 1 else given
        if len(found) != groups or not all(one > 0 for one in found):
            raise SchemeError(f"{name} needs one positive tolerance per group ({groups}), not {value}")
        return found

    return field(default=(default,), metadata={"check": check})


@dataclass(frozen=True)
class ClosureOptions(Options):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation."""

    closure_iterations: int = whole_number(2, most=MOST_UNROLLED)


@dataclass(frozen=True)
class AdaptiveOptions(ClosureOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation.

    tolerance: of errors relative to the amplitudes; steps then take the length that it asks for, and dt is the time
        between the states that can be seen. 0: steps of dt.
    error_of: what a tolerance of a run is of: the error of the `motion`, which is made with ever more steps of one
        length then, or the estimate of each `step`.
    """

    tolerance: float = share(0.0, LARGEST_TOLERANCE)
    error_of: str = one_of("motion", "step")


@dataclass(frozen=True)
class SingleClosureOptions(ClosureOptions):
    """closure_iterations: one is enough where the loop unknowns are integrated with the order of the scheme."""

    closure_iterations: int = whole_number(1, most=MOST_UNROLLED)


# Steps of nested groups: dt_1 = dt_S, dt_2 = m_2 dt_1, ... (Eq. 72).

MAX_RATIO = 10_000  # as in a scene


@dataclass(frozen=True)
class Grid:
    """Groups as positions in q_i, slow to fast, the steps h [s], and ratios m[g] = h[g] / h[g + 1].

    Group g has step h[g]. A scheme that sub-steps all coordinates has one group and two steps.
    """

    groups: list[list[int]]
    h: list[float]
    m: list[int]

    @property
    def dt_L(self) -> float:
        """The major step."""
        return self.h[0]

    def scaled(self, dt: float) -> Grid:
        """The same groups and ratios with a major step of dt [s]."""
        return Grid(self.groups, [h * (dt / self.h[0]) for h in self.h], self.m)

    def first_of(self, level: int) -> list[int]:
        """Positions in q_i of the groups slower than `level`."""
        return [k for group in self.groups[:level] for k in group]

    def from_level(self, level: int) -> list[int]:
        """Positions in q_i of the groups from `level` on."""
        return [k for group in self.groups[level:] for k in group]


def make_grid(groups: list[list[int]], dt: Any, m: list[Any], ratios: int, names: str) -> Grid:
    """Grid with major step dt and one more step for each ratio in m, (8) and (72).

    names: what the ratios belong to, for errors. Raises SchemeError for steps that are not positive, ratios that
    are not whole, or a wrong number of ratios.
    """
    if isinstance(dt, bool) or not isinstance(dt, Real) or not 0 < float(dt) < float("inf"):
        raise SchemeError(f"the step dt must be a positive number of seconds, not {dt!r}")
    if len(m) != ratios:
        count = "one number" if ratios == 1 else f"{ratios} numbers"
        if ratios == 0:
            raise SchemeError(f"m: {names} takes all coordinates in one step, so it has no ratio; leave m out, not {m}")
        if len(groups) > 1:
            meaning = f"how many steps each next of the groups {names} takes in one of the group before it"
        else:
            meaning = f"how many sub-steps {names} takes in one step dt"
        given = f"{len(m)} were given: {m}" if m else "none was given"
        raise SchemeError(f"m must hold {count}, {meaning}, such as {[4] * ratios}; {given}")
    for ratio in m:
        if isinstance(ratio, bool) or not isinstance(ratio, int) or not 1 <= ratio <= MAX_RATIO:
            raise SchemeError(f"m must hold whole numbers from 1 to {MAX_RATIO}, not {ratio!r}")
    steps = [float(dt)]
    for ratio in m:
        steps.append(steps[-1] / ratio)
    return Grid(groups, steps, list(m))
