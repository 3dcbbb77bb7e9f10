"""Options of generalized-alpha and of the method of Hilber, Hughes and Taylor, and the weights that they lead to."""

from __future__ import annotations

from dataclasses import dataclass

from runtime.schemes.options import MOST_ITERATIONS, Options, share, tolerances, whole_number


@dataclass(frozen=True)
class Weights:
    """alpha_m and alpha_f; the others make the method of order 2 with the strongest damping of fast modes."""

    alpha_m: float
    alpha_f: float

    @property
    def gamma(self) -> float:
        """Newmark's gamma."""
        return 0.5 + self.alpha_f - self.alpha_m

    @property
    def beta(self) -> float:
        """Newmark's beta."""
        return (self.gamma + 0.5) ** 2 / 4


@dataclass(frozen=True)
class AlphaMethodOptions(Options):
    """eps: relative correction after which the iteration stops. max_iterations: the most iterations of a step."""

    eps: tuple[float, ...] = tolerances(1e-7)
    max_iterations: int = whole_number(15, most=MOST_ITERATIONS)


@dataclass(frozen=True)
class GeneralizedAlphaOptions(AlphaMethodOptions):
    """eps, max_iterations: see AlphaMethodOptions.

    rho_inf: the amplitude that a step leaves of an infinitely fast mode; 1 is without dissipation.
    """

    rho_inf: float = share(0.9, most=1.0)


@dataclass(frozen=True)
class HilberHughesTaylorOptions(AlphaMethodOptions):
    """eps, max_iterations: see AlphaMethodOptions. alpha: the dissipation; 0 is the trapezoidal rule."""

    alpha: float = share(0.05, most=1 / 3)
