"""States: numbers of controllers, filters and actuators that follow first-order equations of their own."""

from __future__ import annotations

from typing import Annotated

from symgen.schema.fields import Meaning, Number, Quantity, Scope, StrictModel, Text


class DeclaredState(StrictModel):
    """s' = rate: an integrator, a filter, an actuator. Expressions of loads and of other states use s by its name.

    ``initial`` is its value at the start, ``unit`` that of s, for people.
    """

    rate: Annotated[Quantity, Meaning("rate of the state", "its unit a second", scope=Scope.STATES)]
    initial: Number = 0.0
    unit: Text = ""
    description: Text = ""
