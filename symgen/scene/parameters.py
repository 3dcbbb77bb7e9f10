"""Parameters: named run-time inputs of the emitted functions."""

from __future__ import annotations

from symgen.schema.fields import Number, StrictModel, Text


class DeclaredParameter(StrictModel):
    """A number that stays an input of the emitted functions.

    ``default`` is in SI units (``unit`` names them for people). Expressions use the parameter by its name.
    """

    default: Number
    unit: Text = ""
    description: Text = ""
