"""The schemes by name: class, options, what m means, order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from runtime.contract.model import Model
from runtime.schemes.baselines.generalized_alpha import GeneralizedAlpha, HilberHughesTaylor
from runtime.schemes.baselines.radau import Radau
from runtime.schemes.baselines.runge_kutta import ClassicalRungeKutta, DormandPrince8
from runtime.schemes.central_difference import CentralDifference
from runtime.schemes.coupled import Coupled
from runtime.schemes.decoupled import Decoupled
from runtime.schemes.exponential import Exponential
from runtime.schemes.grid import make_grid
from runtime.schemes.linearised import Linearised
from runtime.schemes.options import Options, SchemeError
from runtime.schemes.scheme import Scheme

Ratios = Literal["none", "groups", "sub_steps"]
CENTRAL = ("common_velocity", "newton_iterations", "closure_iterations")
NEWTON = ("eps", "max_iterations")
SWEEP = ("common_update", "guess", "slow_interpolation", "sub_step_velocity", "eps", "stopping", "max_iterations")


@dataclass(frozen=True)
class SchemeKind:
    """A scheme that can be asked for by name.

    ratios: what m is. `groups`: one ratio between each two groups of the partition; `sub_steps`: one number of
    sub-steps for all coordinates; `none`: no m. takes: the options that change anything. defaults: its Options.
    default_m: m where neither the user nor the scene gives one that fits.
    """

    make: type[Scheme]
    title: str
    ratios: Ratios
    takes: tuple[str, ...]
    defaults: Options = field(default_factory=Options)
    default_m: int = 1

    @property
    def multirate(self) -> bool:
        """Does it take sub-steps?"""
        return self.ratios != "none"

    def build(self, name: str, model: Model, dt: Any, m: list[Any] | None, changes: Mapping[str, Any]) -> Scheme:
        """The scheme on a model. Raises SchemeError for a step, ratios or options that cannot be used."""
        for option in changes:
            if option not in self.takes:
                raise SchemeError(f"{name} has no option {option!r}; its options are {', '.join(sorted(self.takes))}")
        if self.ratios == "none" and m:
            raise SchemeError(
                f"{name} takes one step for all coordinates; leave m = {m!r} out, or choose another scheme"
            )
        if m is None:
            m = self._usual_m(model)
        groups = [list(group.positions) for group in model.groups]
        if self.ratios != "groups":
            groups = [list(range(len(model.q_i)))]
        names = ", ".join(group.name for group in model.groups) if self.ratios == "groups" else name
        grid = make_grid(
            groups, dt, m, 0 if self.ratios == "none" else 1 if self.ratios == "sub_steps" else len(groups) - 1, names
        )
        return self.make(model, grid, replace(self.defaults, **changes))

    def _usual_m(self, model: Model) -> list[int]:
        """m of the scene where it has the right number of ratios, else default_m."""
        if self.ratios == "none":
            return []
        if self.ratios == "sub_steps":
            return [self.default_m]
        given = list(model.simulation.get("m", []))
        needed = len(model.groups) - 1
        return given if len(given) == needed else [self.default_m] * needed


SCHEMES: dict[str, SchemeKind] = {
    "single_rate": SchemeKind(CentralDifference, "central difference, one step for all coordinates", "none", CENTRAL),
    "printed": SchemeKind(
        CentralDifference, "the paper's sub-cycling", "groups", CENTRAL + SWEEP, Options(common_update="fixed_point")
    ),
    "coupled": SchemeKind(Coupled, "sub-steps that solve the coupled system", "groups", ("closure_iterations",)),
    "decoupled": SchemeKind(
        Decoupled, "sub-steps on an inertially decoupled slow coordinate", "groups", ("closure_iterations",)
    ),
    "linearised": SchemeKind(
        Linearised,
        "sub-steps of the system linearised at the midpoint",
        "sub_steps",
        ("propagation", "closure_iterations", "corrections"),
        default_m=4,
    ),
    "exponential": SchemeKind(
        Exponential, "exponential Rosenbrock, order 4", "sub_steps", ("propagation", "closure_iterations"), default_m=4
    ),
    "rk4": SchemeKind(
        ClassicalRungeKutta,
        "classical Runge-Kutta, order 4",
        "none",
        ("closure_iterations",),
        Options(closure_iterations=1),
    ),
    "dop853": SchemeKind(
        DormandPrince8,
        "Dormand-Prince, order 8, fixed step",
        "none",
        ("closure_iterations",),
        Options(closure_iterations=1),
    ),
    "radau": SchemeKind(
        Radau,
        "Radau IIA, order 5, fixed step",
        "none",
        NEWTON + ("closure_iterations",),
        Options(eps=(1e-10,), max_iterations=15, closure_iterations=1),
    ),
    "generalized_alpha": SchemeKind(
        GeneralizedAlpha,
        "generalized-alpha on all coordinates, order 2",
        "none",
        (*NEWTON, "rho_inf"),
        Options(eps=(1e-7,), max_iterations=15),
    ),
    "hht": SchemeKind(
        HilberHughesTaylor,
        "Hilber-Hughes-Taylor on all coordinates, order 2",
        "none",
        (*NEWTON, "alpha"),
        Options(eps=(1e-7,), max_iterations=15),
    ),
}


def scheme_kind(name: str) -> SchemeKind:
    """A kind by name. Raises SchemeError."""
    if name not in SCHEMES:
        raise SchemeError(f"there is no scheme {name!r}; choose one of {', '.join(SCHEMES)}")
    return SCHEMES[name]
