"""Parameters: named run-time inputs of the emitted functions.

States: numbers of controllers, filters and actuators that follow first-order equations of their own.

Inputs: named numbers that come from outside during a run, arguments u of the emitted functions.
"""

from __future__ import annotations

from typing import Annotated

from pydantic import AfterValidator

from symgen.schema.fields import Flag, Meaning, Number, Quantity, Scope, StrictModel, Text, refuse


class DeclaredParameter(StrictModel):
    """A number that stays an input of the emitted functions.

    ``default`` is in SI units (``unit`` names them for people). Expressions use the parameter by its name.
    """

    default: Number
    unit: Text = ""
    description: Text = ""


class DeclaredState(StrictModel):
    """s' = rate: an integrator, a filter, an actuator. Expressions of loads and of other states use s by its name.

    ``initial`` is its value at the start, ``unit`` that of s, for people.
    """

    rate: Annotated[Quantity, Meaning("rate of the state", "its unit a second", scope=Scope.STATES)]
    initial: Number = 0.0
    unit: Text = ""
    description: Text = ""


def _positive(value: float) -> float:
    if value <= 0:
        raise refuse(f"the filter's frequency {value:g} is not positive", "give rad/s, or leave the filter out")
    return value


Frequency = Annotated[Number, AfterValidator(_positive)]


class DeclaredInput(StrictModel):
    """A number that may change during a run; expressions of loads and prescribed motions use it by its name.

    ``default`` is in SI units (``unit`` names them for people). With ``rates`` it comes with its rate and acceleration,
    ``<name>_dot`` and ``<name>_ddot``, as a prescribed motion needs. With ``filter`` [rad/s] what is given from outside
    is the target r of x'' = filter^2 (r - x) - 2 filter x', and the name stands for x, with x' and x''.
    """

    default: Number = 0.0
    unit: Text = ""
    description: Text = ""
    rates: Flag = False
    filter: Frequency | None = None

    def names(self, name: str) -> list[str]:
        """The entries of u: the value, then rate and acceleration where it has them."""
        return [name, f"{name}_dot", f"{name}_ddot"] if self.has_rates else [name]

    @property
    def has_rates(self) -> bool:
        """Does it come with its rate and acceleration, given or filtered?"""
        return self.rates or self.filter is not None
