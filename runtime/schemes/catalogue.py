"""The schemes by name: class, options, what m means. A scheme is imported when a run takes it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any, Literal, cast

from runtime.contract.doors import opened
from runtime.contract.model import Model
from runtime.schemes.options import HALVES, Options, SchemeError, make_grid
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.watched import watch_events

Ratios = Literal["none", "groups", "sub_steps"]


@dataclass(frozen=True)
class SchemeKind:
    """A scheme that can be asked for by name.

    ratios: what m is. `groups`: one ratio between each two groups of the partition; `sub_steps`: one number of
    sub-steps for all coordinates; `none`: no m. default_m: m where neither the user nor the scene gives one that fits.
    By their places, `file:name` of this folder: the class and the record of its options. varying: may steps be as long
    as its estimate of their error asks for?
    """

    class_at: str
    title: str
    ratios: Ratios
    options_at: str
    default_m: int = 1
    varying: bool = False

    @property
    def make(self) -> type[Scheme]:
        """The class."""
        return cast(type[Scheme], opened(f"runtime.schemes.{self.class_at}"))

    @property
    def options(self) -> type[Options]:
        """The record of its options, defaults in it."""
        return cast(type[Options], opened(f"runtime.schemes.{self.options_at}"))

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
        adaptive = self.varying and getattr(options, "tolerance", 0.0) > 0
        if m is None:
            m = self._usual_m(model, options) if not adaptive or self.ratios == "none" else [HALVES]
        groups = [list(group.positions) for group in model.groups]
        if self.ratios != "groups":
            groups = [list(range(len(model.q_i)))]
        names = ", ".join(group.name for group in model.groups) if self.ratios == "groups" else name
        grid = make_grid(
            groups, dt, m, 0 if self.ratios == "none" else 1 if self.ratios == "sub_steps" else len(groups) - 1, names
        )
        key = (name, repr(groups), repr(grid.m), repr(options))
        if key not in model.schemes:
            built: Scheme = self.make(model, grid, options)
            if adaptive:
                built = opened("runtime.schemes.adaptive.adaptive_steps:AdaptiveSteps")(built)
            watch_events(built)
            model.schemes[key] = built
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
        "central_difference:SingleRate",
        "central difference, one step for all coordinates",
        "none",
        "central_difference:CentralDifferenceOptions",
    ),
    "printed": SchemeKind("printed:Printed", "the paper's sub-cycling", "groups", "printed:PrintedOptions"),
    "coupled": SchemeKind(
        "coupled:Coupled", "sub-steps that solve the coupled system", "groups", "options:ClosureOptions"
    ),
    "exponential": SchemeKind(
        "exponential:Exponential",
        "exponential Rosenbrock, order 4 or 5",
        "sub_steps",
        "exponential:ExponentialOptions",
        default_m=4,
        varying=True,
    ),
    "exponential_rk4": SchemeKind(
        "exponential_rk4:ExponentialRungeKutta",
        "exponential Runge-Kutta on the stiff deflections, order 4",
        "none",
        "exponential_rk4:ExponentialRungeKuttaOptions",
        varying=True,
    ),
    "exponential_adams": SchemeKind(
        "exponential_adams:ExponentialAdams",
        "exponential Adams on the stiff deflections with a point inside the step, order 4",
        "none",
        "exponential_adams:ExponentialAdamsOptions",
    ),
    "rk4": SchemeKind(
        "baselines.runge_kutta:ClassicalRungeKutta",
        "classical Runge-Kutta, order 4",
        "none",
        "options:SingleClosureOptions",
    ),
    "dopri5": SchemeKind(
        "baselines.runge_kutta:DormandPrince5",
        "Dormand-Prince, order 5(4)",
        "none",
        "options:AdaptiveOptions",
        varying=True,
    ),
    "dop853": SchemeKind(
        "baselines.runge_kutta:DormandPrince8",
        "Dormand-Prince, order 8, fixed step",
        "none",
        "options:SingleClosureOptions",
    ),
    "radau": SchemeKind(
        "baselines.radau:Radau", "Radau IIA, order 5, fixed step", "none", "baselines.radau:RadauOptions"
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
