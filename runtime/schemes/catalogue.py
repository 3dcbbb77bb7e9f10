"""The schemes by name: class, options, what m means, order."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any, Literal

from runtime.contract.model import Model
from runtime.schemes.adaptive.exponential_adams import AdaptiveExponentialAdams
from runtime.schemes.adaptive.linearised import AdaptiveLinearised
from runtime.schemes.adaptive.methods import (
    AdaptiveDormandPrince,
    AdaptiveExponential,
    AdaptiveExponentialRungeKutta,
)
from runtime.schemes.baselines.alpha_options import GeneralizedAlphaOptions, HilberHughesTaylorOptions
from runtime.schemes.baselines.dormand_prince import DormandPrince5
from runtime.schemes.baselines.generalized_alpha import GeneralizedAlpha, HilberHughesTaylor
from runtime.schemes.baselines.radau import Radau, RadauOptions
from runtime.schemes.baselines.runge_kutta import ClassicalRungeKutta, DormandPrince8
from runtime.schemes.central_difference import CentralDifferenceOptions
from runtime.schemes.coupled import Coupled, CoupledOptions
from runtime.schemes.decoupled import Decoupled, DecoupledOptions
from runtime.schemes.exponential import Exponential, ExponentialOptions
from runtime.schemes.exponential_adams import ExponentialAdams, fitting
from runtime.schemes.exponential_midpoint import ExponentialMidpoint, ExponentialMidpointOptions
from runtime.schemes.exponential_rk4 import ExponentialRungeKutta, ExponentialRungeKuttaOptions
from runtime.schemes.grid import Grid, make_grid
from runtime.schemes.linear_sub_steps import HALVES
from runtime.schemes.linearised import Linearised, LinearisedOptions
from runtime.schemes.options import AdaptiveOptions, Options, SchemeError, SingleClosureOptions
from runtime.schemes.printed import Printed, PrintedOptions
from runtime.schemes.remembering_step import ExponentialAdamsOptions
from runtime.schemes.scheme import Scheme
from runtime.schemes.single_rate import SingleRate

Ratios = Literal["none", "groups", "sub_steps"]


@dataclass(frozen=True)
class SchemeKind:
    """A scheme that can be asked for by name.

    ratios: what m is. `groups`: one ratio between each two groups of the partition; `sub_steps`: one number of
    sub-steps for all coordinates; `none`: no m. options: the record of its options, defaults in it.
    default_m: m where neither the user nor the scene gives one that fits. adaptive: the class for a tolerance.
    fitting: who makes it, where there are several of a kind, among which `make` is one.
    """

    make: type[Scheme]
    title: str
    ratios: Ratios
    options: type[Options]
    default_m: int = 1
    adaptive: type[Scheme] | None = None
    fitting: Callable[[Model, Grid, Options], Scheme] | None = None

    @property
    def multirate(self) -> bool:
        """Does it take sub-steps?"""
        return self.ratios != "none"

    def build(self, name: str, model: Model, dt: Any, m: list[Any] | None, changes: Mapping[str, Any]) -> Scheme:
        """The scheme on a model, which keeps what does not depend on the step for the next one who asks.

        Raises SchemeError for a step, ratios or options that cannot be used.
        """
        options = self.chosen(name, changes)
        if self.ratios == "none" and m:
            raise SchemeError(
                f"{name} takes one step for all coordinates; leave m = {m!r} out, or choose another scheme"
            )
        adaptive = self.adaptive if getattr(options, "tolerance", False) else None
        if m is None:
            m = self._usual_m(model, options) if adaptive is None or self.ratios == "none" else [HALVES]
        groups = [list(group.positions) for group in model.groups]
        if self.ratios != "groups":
            groups = [list(range(len(model.q_i)))]
        names = ", ".join(group.name for group in model.groups) if self.ratios == "groups" else name
        grid = make_grid(
            groups, dt, m, 0 if self.ratios == "none" else 1 if self.ratios == "sub_steps" else len(groups) - 1, names
        )
        key = (name, repr(groups), repr(grid.m), repr(options))
        if key not in model.schemes:
            model.schemes[key] = (adaptive or self.fitting or self.make)(model, grid, options)
        found: Scheme = model.schemes[key]
        return found.on(grid)

    def chosen(self, name: str, changes: Mapping[str, Any]) -> Options:
        """The options with some changed by name, their values not checked yet. Raises SchemeError for other names."""
        known = self.options.names()
        for option in changes:
            if option not in known:
                raise SchemeError(f"{name} has no option {option!r}{_meant(option, known)}")
        return self.options(**changes)

    def _usual_m(self, model: Model, options: Options) -> list[int]:
        """m of the scene where it has the right number of ratios, else default_m."""
        if self.ratios == "none":
            return []
        if self.ratios == "sub_steps":
            return [min(self.default_m, options.most_sub_steps)]
        given = list(model.simulation.get("m", []))
        needed = len(model.groups) - 1
        return given if len(given) == needed else [self.default_m] * needed


SCHEMES: dict[str, SchemeKind] = {
    "single_rate": SchemeKind(
        SingleRate, "central difference, one step for all coordinates", "none", CentralDifferenceOptions
    ),
    "printed": SchemeKind(Printed, "the paper's sub-cycling", "groups", PrintedOptions),
    "coupled": SchemeKind(Coupled, "sub-steps that solve the coupled system", "groups", CoupledOptions),
    "decoupled": SchemeKind(
        Decoupled, "sub-steps on an inertially decoupled slow coordinate", "groups", DecoupledOptions
    ),
    "linearised": SchemeKind(
        Linearised,
        "sub-steps of the system linearised at the midpoint",
        "sub_steps",
        LinearisedOptions,
        default_m=4,
        adaptive=AdaptiveLinearised,
    ),
    "exponential": SchemeKind(
        Exponential,
        "exponential Rosenbrock, order 4 or 5",
        "sub_steps",
        ExponentialOptions,
        default_m=4,
        adaptive=AdaptiveExponential,
    ),
    "exponential_rk4": SchemeKind(
        ExponentialRungeKutta,
        "exponential Runge-Kutta on the stiff deflections, order 4",
        "none",
        ExponentialRungeKuttaOptions,
        adaptive=AdaptiveExponentialRungeKutta,
    ),
    "exponential_adams": SchemeKind(
        ExponentialAdams,
        "exponential Adams on the stiff deflections or all coordinates with a point inside the step, order 4",
        "none",
        ExponentialAdamsOptions,
        fitting=fitting,
        adaptive=AdaptiveExponentialAdams,
    ),
    "exponential_midpoint": SchemeKind(
        ExponentialMidpoint,
        "symmetric exponential midpoint on the stiff deflections, order 2",
        "none",
        ExponentialMidpointOptions,
    ),
    "rk4": SchemeKind(ClassicalRungeKutta, "classical Runge-Kutta, order 4", "none", SingleClosureOptions),
    "dopri5": SchemeKind(
        DormandPrince5, "Dormand-Prince, order 5(4)", "none", AdaptiveOptions, adaptive=AdaptiveDormandPrince
    ),
    "dop853": SchemeKind(DormandPrince8, "Dormand-Prince, order 8, fixed step", "none", SingleClosureOptions),
    "radau": SchemeKind(Radau, "Radau IIA, order 5, fixed step", "none", RadauOptions),
    "generalized_alpha": SchemeKind(
        GeneralizedAlpha, "generalized-alpha on all coordinates, order 2", "none", GeneralizedAlphaOptions
    ),
    "hht": SchemeKind(
        HilberHughesTaylor, "Hilber-Hughes-Taylor on all coordinates, order 2", "none", HilberHughesTaylorOptions
    ),
}


def _meant(option: str, known: tuple[str, ...]) -> str:
    """What is to be said after the name of an option that a scheme does not take."""
    near = get_close_matches(option, known, 1)
    takers = [name for name, kind in SCHEMES.items() if option in kind.options.names()]
    hint = f" (did you mean {near[0]!r}?)" if near else f" ({', '.join(takers)} would take it)" if takers else ""
    return f"{hint}; its options are {', '.join(sorted(known))}"


def scheme_kind(name: str) -> SchemeKind:
    """A kind by name. Raises SchemeError."""
    if name not in SCHEMES:
        raise SchemeError(f"there is no scheme {name!r}; choose one of {', '.join(SCHEMES)}")
    return SCHEMES[name]
