"""JAX, an optional library: imported when it is asked for, and refused where it computes with 32 bits."""

from __future__ import annotations

from typing import Any

from runtime.contract.errors import ArgumentError


def import_jax() -> Any:
    """The library. Raises ImportError naming the extra."""
    try:
        import jax
    except ImportError as error:
        raise ImportError("JAX is not installed; install it with: pip install 'symgen[jax]'") from error
    return jax


def require_64_bits(who: str) -> None:
    """Raises ArgumentError where JAX computes with 32 bits, which it does unless it is told."""
    if import_jax().numpy.zeros(0).dtype != "float64":
        raise ArgumentError(
            who,
            "needs 64 bits, but JAX uses 32 here",
            'call jax.config.update("jax_enable_x64", True) at the start of the program',
        )
