"""Events: what happens when a value of the motion passes zero."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from symgen.scene.fields import Flag, Meaning, Name, Quantity, Scope, StrictModel, Text


class DeclaredEvent(StrictModel):
    """A time at which ``when`` passes zero, rising, falling or either way; a step ends there.

    ``terminal`` ends the run. ``action`` gives inputs other values from then on, by name.
    """

    when: Annotated[Quantity, Meaning("value that passes zero", "any", scope=Scope.MEASURES)]
    direction: Literal["rising", "falling", "either"] = "either"
    terminal: Flag = False
    action: Annotated[dict[Name, Quantity], Meaning("value of an input", "its unit", scope=Scope.MEASURES)] = Field(
        default_factory=dict
    )
    description: Text = ""
