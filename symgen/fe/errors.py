"""The one error that finite-element data can raise."""

from __future__ import annotations

from runtime.contract.errors import SymgenError


class FiniteElementError(SymgenError, ValueError):
    """Something in finite-element data is wrong; says where, what, and what to do.

    Args:
        item: what is wrong, such as ``stiffness`` or ``interface 'pin'``.
        problem: what is wrong with it.
        remedy: what to do about it.
    """
