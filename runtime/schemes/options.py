"""What may be chosen about a scheme: each scheme has a record of its own, and each field of it brings its check."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from typing import Any, Self

from runtime.contract.errors import SymgenError

MOST_ITERATIONS = 100_000  # of an update that repeats itself until it has converged
MOST_UNROLLED = 50  # Newton steps that are written out one after another in a stage
LARGEST_TOLERANCE = 0.1  # of a step's error, relative to the amplitudes
LARGE_SYSTEM = 12  # independent coordinates beyond which the Jacobian by velocity costs more than it gives

Check = Callable[[str, Any, int], Any]  # (name, given value, groups) -> the value to use; raises SchemeError

HALVES = 2  # sub-steps of a step that follows an estimate


class SchemeError(SymgenError, ValueError):
    """A scheme, step or option that cannot be used."""


@dataclass(frozen=True)
class Options:
    """The options of a scheme by name; the record of each scheme is a subclass beside it."""

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


def one_of(default: str, *others: str) -> Any:
    """An option that is one of several words."""
    allowed = (default, *others)

    def check(name: str, value: Any, groups: int) -> Any:
        if value not in allowed:
            raise SchemeError(f"{name} must be one of {', '.join(allowed)}, not {value!r}")
        return value

    return field(default=default, metadata={"check": check})


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
    error_of: what the tolerance is of: the error of the `motion` (RMS), where trials of all of it tell with which
        tolerance of its steps it comes to that, or that of each `step`, without trials.
    """

    tolerance: float = share(0.0, LARGEST_TOLERANCE)
    error_of: str = one_of("motion", "step")


@dataclass(frozen=True)
class SingleClosureOptions(ClosureOptions):
    """closure_iterations: one is enough where the loop unknowns are integrated with the order of the scheme."""

    closure_iterations: int = whole_number(1, most=MOST_UNROLLED)
