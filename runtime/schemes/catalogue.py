"""The schemes by name: class, options, what m means. A scheme is imported when a run takes it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any, Literal, cast, get_type_hints

from runtime.contract.model import EmittedModel
from runtime.schemes.options import Options, SchemeError, make_grid
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.watched import watch_events

Ratios = Literal["none", "groups", "sub_steps"]


@dataclass(frozen=True)
class SchemeKind:
    """A scheme that can be asked for by name.

    ratios: what m is. `groups`: one ratio between each two groups of the partition; `sub_steps`: one number of
    sub-steps for all coordinates; `none`: no m. default_m: m where neither the user nor the scene gives one that fits.
    load: what imports the class.
    """

    load: Callable[[], type[Scheme]]
    title: str
    ratios: Ratios
    default_m: int = 1

    @property
    def make(self) -> type[Scheme]:
        """The class."""
        return self.load()

    @property
    def options(self) -> type[Options]:
        """The record of its options, defaults in it: what the class says of its `options`."""
        return cast(type[Options], get_type_hints(self.make)["options"])

    @property
    def multirate(self) -> bool:
        """Does it take sub-steps?"""
        return self.ratios != "none"

    def build(self, name: str, model: EmittedModel, dt: Any, m: list[Any] | None, changes: Mapping[str, Any]) -> Scheme:
        """The scheme on a model, which keeps what does not depend on the step for the next one who asks.

        Raises SchemeError for a step, ratios or options that cannot be used.
        """
        options = self.chosen(name, changes)
        if self.ratios == "none" and m:
            raise SchemeError(
                f"{name} takes one step for all coordinates; leave m = {m!r} out, or choose another scheme"
            )
        if m is None:
            m = self._usual_m(model, options)
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
            if getattr(options, "tolerance", 0.0) > 0:
                from runtime.schemes.adaptive_scheme import AdaptiveScheme
                from runtime.schemes.one_step import Method

                assert isinstance(built, Method)  # no other has this option
                built = AdaptiveScheme(built)
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

    def _usual_m(self, model: EmittedModel, options: Options) -> list[int]:
        """m of the scene where it has the right number of ratios, else default_m."""
        if self.ratios == "none":
            return []
        if self.ratios == "sub_steps":
            return [min(self.default_m, options.most_sub_steps)]
        given = list(model.simulation.get("m", []))
        needed = len(model.groups) - 1
        return given if len(given) == needed else [self.default_m] * needed


def _single_rate() -> type[Scheme]:
    from runtime.schemes.central_difference import SingleRate

    return SingleRate


def _printed() -> type[Scheme]:
    from runtime.schemes.printed import Printed

    return Printed


def _coupled() -> type[Scheme]:
    from runtime.schemes.coupled import Coupled

    return Coupled


def _exponential() -> type[Scheme]:
    from runtime.schemes.exponential import Exponential

    return Exponential


def _exponential_runge_kutta() -> type[Scheme]:
    from runtime.schemes.exponential_rk4 import ExponentialRungeKutta

    return ExponentialRungeKutta


def _exponential_adams() -> type[Scheme]:
    from runtime.schemes.exponential_adams import ExponentialAdams

    return ExponentialAdams


def _classical_runge_kutta() -> type[Scheme]:
    from runtime.schemes.runge_kutta import ClassicalRungeKutta

    return ClassicalRungeKutta


def _dormand_prince_5() -> type[Scheme]:
    from runtime.schemes.runge_kutta import DormandPrince5

    return DormandPrince5


def _dormand_prince_8() -> type[Scheme]:
    from runtime.schemes.runge_kutta import DormandPrince8

    return DormandPrince8


def _radau() -> type[Scheme]:
    from runtime.schemes.radau import Radau

    return Radau


SCHEMES: dict[str, SchemeKind] = {
    "single_rate": SchemeKind(_single_rate, "central difference, one step for all coordinates", "none"),
    "printed": SchemeKind(_printed, "the paper's sub-cycling", "groups"),
    "coupled": SchemeKind(_coupled, "sub-steps that solve the coupled system", "groups"),
    "exponential": SchemeKind(_exponential, "exponential Rosenbrock, order 4 or 5", "sub_steps", default_m=4),
    "exponential_rk4": SchemeKind(
        _exponential_runge_kutta, "exponential Runge-Kutta on the stiff deflections, order 4", "none"
    ),
    "exponential_adams": SchemeKind(
        _exponential_adams,
        "exponential Adams on the stiff deflections with a point inside the step, order 4",
        "none",
    ),
    "rk4": SchemeKind(_classical_runge_kutta, "classical Runge-Kutta, order 4", "none"),
    "dopri5": SchemeKind(_dormand_prince_5, "Dormand-Prince, order 5(4)", "none"),
    "dop853": SchemeKind(_dormand_prince_8, "Dormand-Prince, order 8, fixed step", "none"),
    "radau": SchemeKind(_radau, "Radau IIA, order 5, fixed step", "none"),
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
