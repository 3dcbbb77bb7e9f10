"""The error of the stages after the scene: what was asked for cannot be derived."""

from __future__ import annotations

from runtime.contract.errors import SymgenError


class DerivationError(SymgenError):
    """Names the item, what is wrong with it, and what to do; the pipeline gives it to the user as a SceneError."""
