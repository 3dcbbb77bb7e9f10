"""Who does not look for events refuses models that have them."""

from __future__ import annotations

from runtime.contract.model import Model, ModelError


def refuse_events(model: Model, who: str) -> None:
    """Raises ModelError for a model with events."""
    names = [event.name for event in model.description.events]
    if names:
        raise ModelError(
            f"events {', '.join(names)} of model {model.name}",
            f"are not looked for by {who}",
            "take simulate with steps of one length, or a scene without events",
        )
