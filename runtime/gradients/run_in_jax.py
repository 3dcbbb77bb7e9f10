"""A run as one operation of JAX: its values and its vector-Jacobian product are computed by the run itself."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from threading import Lock
from typing import Any

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.errors import ArgumentError
from runtime.contract.jax_library import import_jax, require_64_bits
from runtime.gradients.differentiable_run import DIFFERENTIABLE, DifferentiableRun
from runtime.gradients.recorded_run import RecordedRun

RUNS_KEPT = 16  # on tapes, between their way forward and their way back


@arguments(run=DIFFERENTIABLE)
def as_jax(run: DifferentiableRun, mode: str = "auto") -> Callable[[Any], Any]:
    """Give a run as a function of JAX: x (n,) -> outputs (N, n_y), for jit, vmap and grad.

    Parameters
    ----------
    run : DifferentiableRun
        Its `by` are the entries of x, its `outputs` at the times `t` what comes out.
    mode : str
        How derivatives are found, as of `DifferentiableRun.gradient`: ``forward``, ``reverse`` or ``auto``.

    Returns
    -------
    callable
        A pure function of x (n,) in 64 bits, SI units.

    Raises
    ------
    ImportError
        If JAX is not installed (extra `jax`).
    ArgumentError
        If JAX computes with 32 bits, here or at a call, and for an x of another length.

    Notes
    -----
    JAX calls the compiled run on the host by `pure_callback`, so a GPU waits for it, and cases of `vmap` run one after
    another. The derivative is a `custom_vjp`, that of the discrete steps: `jax.grad`, `value_and_grad` and `jacrev` go
    through it, `jvp` and `jacfwd` are refused by JAX. A run that has no result (`NoResult`) or an x that cannot be used
    raises JAX's own error, whose text ends with ours.

    References
    ----------
    A. Griewank and A. Walther, Evaluating Derivatives, 2nd ed., SIAM, 2008.
    """
    jax, chosen = import_jax(), run.mode_of(mode)
    require_64_bits("as_jax")
    host = _Host(run, chosen)
    product = _by_jacobian(jax, run, host) if chosen == "forward" else _by_tapes(jax, run, host)

    def function(x: Any) -> Any:
        require_64_bits("as_jax")
        x = jax.numpy.asarray(x)
        if x.shape != (len(run.by),):
            wanted = f"give {len(run.by)} values: {', '.join(run.by)}; take jax.vmap for many of them"
            raise ArgumentError("x", f"has shape {x.shape}", wanted)
        return product(x.astype(np.float64))

    return function


def _by_jacobian(jax: Any, run: DifferentiableRun, host: _Host) -> Any:
    """One way forward along all directions: what goes back is a product of arrays, of which the host knows nothing."""
    y = jax.ShapeDtypeStruct((len(run.t), len(run.outputs)), np.float64)
    slopes = jax.ShapeDtypeStruct((*y.shape, len(run.by)), np.float64)

    def values(x: Any) -> Any:
        return jax.pure_callback(host.values, y, x, vmap_method="sequential")

    def forward(x: Any) -> tuple[Any, Any]:
        return tuple(jax.pure_callback(host.jacobian, (y, slopes), x, vmap_method="sequential"))

    def back(found: Any, bars: Any) -> tuple[Any]:
        return (jax.numpy.einsum("ny,nyk->k", bars, found),)

    product = jax.custom_vjp(values)
    product.defvjp(forward, back)
    return product


def _by_tapes(jax: Any, run: DifferentiableRun, host: _Host) -> Any:
    """The host keeps the latest runs on tapes for the way back; one that is gone is made again, with the same bits."""
    y = jax.ShapeDtypeStruct((len(run.t), len(run.outputs)), np.float64)
    x_bar = jax.ShapeDtypeStruct((len(run.by),), np.float64)

    def values(x: Any) -> Any:
        return jax.pure_callback(host.values, y, x, vmap_method="sequential")

    def forward(x: Any) -> tuple[Any, Any]:
        return jax.pure_callback(host.recorded_values, y, x, vmap_method="sequential"), x

    def back(x: Any, bars: Any) -> tuple[Any]:
        return (jax.pure_callback(host.pulled_back, x_bar, x, bars, vmap_method="sequential"),)

    product = jax.custom_vjp(values)
    product.defvjp(forward, back)
    return product


class _Host:
    """What JAX calls, one call at a time: a run has its work arrays once."""

    def __init__(self, run: DifferentiableRun, mode: str) -> None:
        self._run, self._mode, self._lock = run, mode, Lock()
        self._kept: OrderedDict[bytes, RecordedRun] = OrderedDict()

    def values(self, x: Any) -> np.ndarray:
        with self._lock:
            return self._run.values(np.asarray(x))

    def jacobian(self, x: Any) -> tuple[np.ndarray, np.ndarray]:
        with self._lock:
            found = self._run.jacobian(np.asarray(x))
        return found.values, found.derivatives

    def recorded_values(self, x: Any) -> np.ndarray:
        with self._lock:
            return self._recorded(np.asarray(x)).values

    def pulled_back(self, x: Any, bars: Any) -> np.ndarray:
        with self._lock:
            return self._recorded(np.asarray(x)).pull_back(np.asarray(bars))

    def _recorded(self, x: np.ndarray) -> RecordedRun:
        key = x.tobytes()
        if key not in self._kept:
            self._kept[key] = self._run.record(x, self._mode)
            while len(self._kept) > RUNS_KEPT:
                self._kept.popitem(last=False)
        self._kept.move_to_end(key)
        return self._kept[key]
