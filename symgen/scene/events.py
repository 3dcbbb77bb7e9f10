"""Events: what happens when a value of the motion passes zero."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Field

from symgen.schema.fields import Flag, Meaning, Name, Number, Quantity, Scope, StrictModel, Text, refuse


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
