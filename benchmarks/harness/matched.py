"""What two programs need for the same error: settings from loose to tight, and the time in between by powers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import inf, isfinite, log


@dataclass(frozen=True)
class Attempt:
    """A run with a setting (steps, or a tolerance): its error, CPU seconds and steps; failure says why it has none.

    own: the share of the time that evaluating the equations took, where that is known.
    """

    setting: float
    error: float
    seconds: float
    steps: int
    failure: str = ""
    own: float = inf

    def told(self, per: float) -> str:
        """In words; per: seconds of motion."""
        return f"{self.error:.1e} in {self.steps} steps, {self.seconds * 1e3 / per:.3g} ms/s"


@dataclass(frozen=True)
class Matched:
    """The neighbours of an error among the attempts; coarse is missing where the loosest was enough, fine where none.

    seconds: at that error, by powers between the two; of fine alone where coarse is not.
    """

    coarse: Attempt | None
    fine: Attempt | None
    tolerance: float

    @property
    def met(self) -> bool:
        """Did any attempt come to the error?"""
        return self.fine is not None

    @property
    def seconds(self) -> float:
        """CPU time at the error; infinite if it was not met."""
        if self.fine is None:
            return inf
        share = self._share()
        return (
            self.fine.seconds if self.coarse is None else self.coarse.seconds ** (1 - share) * self.fine.seconds**share
        )

    def _share(self) -> float:
        """Where the error lies between the two, in logarithm; 1 at the fine one."""
        if self.coarse is None or self.fine is None or not isfinite(self.coarse.error):
            return 1.0
        return log(self.coarse.error / self.tolerance) / log(self.coarse.error / max(self.fine.error, 1e-300))

    def told(self, per: float) -> str:
        """Both neighbours in words, or why there is none; per: seconds of motion."""
        if self.fine is None:
            return self.coarse.failure or f"not met: {self.coarse.told(per)}" if self.coarse else "not tried"
        if self.coarse is None or not isfinite(self.coarse.error):
            return self.fine.told(per)
        return f"{self.coarse.told(per)}; {self.fine.told(per)}"


def match(
    run: Callable[[float], Attempt], settings: Sequence[float], start: int, tolerance: float, longest: float
) -> Matched:
    """The neighbours of a tolerance among settings from loose to tight, begun at one of them, and one between the two.

    Given up where an attempt that is not enough takes longer than `longest` [s].
    """
    fine = run(settings[start])
    if fine.error > tolerance:
        return _tightened(run, fine, settings[start + 1 :], tolerance, longest)
    for setting in reversed(settings[:start]):
        coarse = run(setting)
        if coarse.error > tolerance:
            return _halved(run, coarse, fine, tolerance)
        fine = coarse
    return Matched(None, fine, tolerance)


def _tightened(
    run: Callable[[float], Attempt], coarse: Attempt, settings: Sequence[float], tolerance: float, longest: float
) -> Matched:
    for setting in settings:
        if coarse.seconds > longest:
            break
        fine = run(setting)
        if fine.error <= tolerance:
            return _halved(run, coarse, fine, tolerance)
        coarse = fine
    return Matched(coarse, None, tolerance)


def _halved(run: Callable[[float], Attempt], coarse: Attempt, fine: Attempt, tolerance: float) -> Matched:
    middle = run((coarse.setting * fine.setting) ** 0.5)
    return Matched(middle, fine, tolerance) if middle.error > tolerance else Matched(coarse, middle, tolerance)
