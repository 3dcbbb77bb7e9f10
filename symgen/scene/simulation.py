"""Partition into groups, initial state, and how the scene is stepped.

Events: what happens when a value of the motion passes zero.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field, Strict, model_validator

from runtime.contract.records import SchemeName
from symgen.schema.fields import Coordinate, Flag, Meaning, Name, Number, Quantity, Scope, StrictModel, Text, refuse

MAX_STEPS = 10**9


class CoordinateGroup(StrictModel):
    """Coordinates that share a step size; names, or patterns with * and ? such as ``rod.q*``."""

    name: Name
    coordinates: tuple[Coordinate, ...]


class Partition(StrictModel):
    """Which coordinates are independent (Eq. 29) and how they are grouped, from slow to fast (Eq. 39, 72).

    stiff: which elastic coordinates and rotational springs the exponential schemes take for stiff; all by default.
    """

    independent: tuple[Coordinate, ...] | None = None
    groups: tuple[CoordinateGroup, ...] | None = None
    stiff: tuple[Coordinate, ...] | None = None


class InitialValue(StrictModel):
    """A starting value; ``fixed`` keeps it as it is when the initial state is made consistent."""

    value: Number
    fixed: Flag = False


def _as_initial_value(value: Any) -> Any:
    return value if isinstance(value, dict | InitialValue) else {"value": value}


InitialEntry = Annotated[InitialValue, BeforeValidator(_as_initial_value, json_schema_input_type=float | InitialValue)]


class Initial(StrictModel):
    """Starting values by coordinate name: coordinates [m, rad] and rates [m/s, rad/s]; may be partial.

    A number ``v`` is short for ``{value = v, fixed = false}`` and is stored in that form.
    """

    coordinates: dict[Coordinate, InitialEntry] = Field(default_factory=dict)
    rates: dict[Coordinate, InitialEntry] = Field(default_factory=dict)


class Baumgarte(StrictModel):
    """Stabilisation terms of the augmented form: gamma - 2 alpha C_dot - beta^2 C, alpha and beta [1/s]."""

    alpha: Annotated[float, Strict(), Field(ge=0, le=1e12)]
    beta: Annotated[float, Strict(), Field(ge=0, le=1e12)]


class Simulation(StrictModel):
    """t_end [s]; dt [s]: the major step dt_L of a scheme that is named; m: step ratio of each next group.

    scheme: a stepper's name; left out it is `auto`, which chooses a method and its steps for a tolerance.
    tolerance: of the error of the motion, relative to its amplitudes, in place of dt; of `auto` 1e-3 where left out.
    start: `given` takes the initial state as it is, `quasi_static` puts elastic coordinates into stable equilibrium
    with it, `quasi_static_unstable` into any; `equilibrium`: every coordinate settles but those that turn.
    """

    t_end: Number = 1.0
    dt: Number = 1e-3
    m: tuple[Annotated[int, Strict(), Field(ge=1, le=10_000)], ...] = ()
    scheme: SchemeName = "auto"
    tolerance: Annotated[float, Strict(), Field(gt=0, le=0.1)] | None = None
    save_every: Annotated[int, Strict(), Field(ge=1, le=MAX_STEPS)] = 1
    start: Literal["given", "quasi_static", "quasi_static_unstable", "equilibrium"] = "given"

    @model_validator(mode="after")
    def _ratios_of_a_scheme(self) -> Simulation:
        if self.m and self.scheme == "auto":
            raise ValueError('ratios m belong to a scheme: name it, such as scheme = "printed", or leave m out')
        return self


def _not_negative(value: float) -> float:
    if value < 0:
        raise refuse(f"a time of {value:g} s is negative", "give 0 or more seconds")
    return value


Duration = Annotated[Number, AfterValidator(_not_negative)]


class DeclaredEvent(StrictModel):
    """A time at which ``when`` passes zero, rising, falling or either way; a step ends there.

    ``terminal`` ends the run. ``action`` gives inputs and parameters other values from then on, by name. For
    ``cool_down`` seconds after it has happened it is not looked for.
    """

    when: Annotated[Quantity, Meaning("value that passes zero", "any", scope=Scope.MEASURES)]
    direction: Literal["rising", "falling", "either"] = "either"
    terminal: Flag = False
    action: Annotated[dict[Name, Quantity], Meaning("value of an input", "its unit", scope=Scope.MEASURES)] = Field(
        default_factory=dict
    )
    cool_down: Duration = 0.0
    description: Text = ""
