"""What may be chosen about a scheme, every reading of the paper by name."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from runtime.contract.errors import SymgenError
from runtime.schemes.slow_interpolation import INTERPOLATIONS

LARGE_SYSTEM = 12  # independent coordinates beyond which the Jacobian by velocity costs more than it gives


class SchemeError(SymgenError, ValueError):
    """A scheme, step or option that cannot be used."""


@dataclass(frozen=True)
class Options:
    """Readings of the paper (docs/theory/schemes.md lists them) and tolerances.

    common_update: `fixed_point` is the sweep (52)-(55) with the test (56)-(57); `direct` solves (39) at once, with
        Newton on dQ_hat/dq_i_dot where forces depend on velocity.
    guess: `taylor` (50)-(51) or `previous` (48)-(49).
    common_velocity: `newton` solves (41), (43) for q_dot with the emitted Jacobian, `predictor` takes the last q_ddot
        (explicit, second order); `auto` is newton up to LARGE_SYSTEM independent coordinates, predictor beyond.
    slow_interpolation: how slow variables move during sub-steps, see slow_interpolation.py.
    sub_step_velocity: `predictor` takes q_S_dot with the last acceleration (explicit, second order); `newton` solves
        (43) with the emitted Jacobian.
    eps: one tolerance per group, slow to fast (eps_L, eps_S); a single one serves all.
    stopping: `relative` compares the change of q(t + h) by a sweep with the group's largest h^2 q_ddot, so that
        small steps converge too; `absolute` is (56)-(57) as printed, in the coordinates' own unit.
    corrections: how often a linearised step is taken again from a better midpoint.
    propagation: sub-steps of a linearised system, `rational` (of order 6, stable for any stiffness) or
        `central_difference`.
    rho_inf: amplitude that generalized-alpha leaves of an infinitely fast mode in a step; 1 is without dissipation.
    alpha: dissipation of the method of Hilber, Hughes and Taylor; 0 is the trapezoidal rule.
    """

    common_update: Literal["fixed_point", "direct"] = "direct"
    guess: Literal["taylor", "previous"] = "taylor"
    common_velocity: Literal["auto", "newton", "predictor"] = "auto"
    slow_interpolation: str = "end_point_sum"
    sub_step_velocity: Literal["predictor", "newton"] = "predictor"
    eps: tuple[float, ...] = (1e-13,)
    stopping: Literal["relative", "absolute"] = "relative"
    max_iterations: int = 500
    newton_iterations: int = 1
    closure_iterations: int = 2
    corrections: int = 0
    propagation: Literal["rational", "central_difference"] = "rational"
    rho_inf: float = 0.9
    alpha: float = 0.05

    def checked(self, groups: int) -> Options:
        """Options with one eps per group. Raises SchemeError for anything that makes no sense."""
        choices = {
            "common_update": ("fixed_point", "direct"),
            "guess": ("taylor", "previous"),
            "propagation": ("rational", "central_difference"),
            "stopping": ("relative", "absolute"),
            "common_velocity": ("auto", "newton", "predictor"),
            "sub_step_velocity": ("predictor", "newton"),
            "slow_interpolation": tuple(INTERPOLATIONS),
        }
        for name, allowed in choices.items():
            if getattr(self, name) not in allowed:
                raise SchemeError(f"{name} must be one of {', '.join(allowed)}, not {getattr(self, name)!r}")
        for name in ("max_iterations", "newton_iterations", "closure_iterations"):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int) or value < 1:
                raise SchemeError(f"{name} must be a whole number of at least 1, not {value!r}")
        corrections = self.corrections
        if isinstance(corrections, bool) or not isinstance(corrections, int) or not 0 <= corrections <= 100:
            raise SchemeError(f"corrections must be a whole number from 0 to 100, not {corrections!r}")
        for name, largest in (("rho_inf", 1.0), ("alpha", 1 / 3)):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value <= largest:
                raise SchemeError(f"{name} must be a number from 0 to {largest:.3g}, not {value!r}")
        try:
            given = tuple(float(value) for value in (self.eps if isinstance(self.eps, tuple | list) else (self.eps,)))
        except (TypeError, ValueError):
            given = ()
        eps = given * groups if len(given) == 1 else given
        if len(eps) != groups or not all(value > 0 for value in eps):
            raise SchemeError(f"eps needs one positive tolerance per group ({groups}), not {self.eps}")
        return replace(self, eps=eps)
