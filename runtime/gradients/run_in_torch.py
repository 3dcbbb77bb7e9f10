"""A run as one operation of PyTorch: its values and its vector-Jacobian product are computed by the run itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.errors import ArgumentError
from runtime.gradients.differentiable_run import DIFFERENTIABLE, DifferentiableRun


@arguments(run=DIFFERENTIABLE)
def as_torch(run: DifferentiableRun, mode: str = "auto") -> Callable[[Any], Any]:
    """Give a run as a function of PyTorch: x (..., n) -> outputs (..., N, n_y), with its gradient.

    Parameters
    ----------
    run : DifferentiableRun
        Its `by` are the entries of x, its `outputs` at the times `t` what comes out.
    mode : str
        How derivatives are found, as of `DifferentiableRun.gradient`: ``forward``, ``reverse`` or ``auto``.

    Returns
    -------
    callable
        A function of a tensor of 64 bits, SI units; the cases of leading dimensions run one after another. The result
        is on the device of x, the run on the host.

    Raises
    ------
    ImportError
        If PyTorch is not installed (extra `torch`).
    ArgumentError
        At a call, for what is not a tensor of 64 bits with n values last.
    NoResult
        At a call, for a run without a result or without a derivative.

    Notes
    -----
    An `autograd.Function`: the derivative is that of the discrete steps, and has no derivative itself.

    References
    ----------
    A. Griewank and A. Walther, Evaluating Derivatives, 2nd ed., SIAM, 2008.
    """
    try:
        import torch
        from torch.autograd.function import once_differentiable
    except ImportError as error:
        raise ImportError("PyTorch is not installed; install it with: pip install 'symgen[torch]'") from error
    chosen, shape = run.mode_of(mode), (len(run.t), len(run.outputs))

    class Run(torch.autograd.Function):  # type: ignore[misc]  # a class of a library that may be missing
        """values forward, `pull_back` backward."""

        @staticmethod
        def forward(ctx: Any, x: Any) -> Any:
            """(..., N, n_y)."""
            cases = x.detach().cpu().numpy().reshape(-1, len(run.by))
            if ctx.needs_input_grad[0]:
                ctx.runs = [run.record(case, chosen) for case in cases]
                y = [one.values for one in ctx.runs]
            else:
                y = [run.values(case) for case in cases]
            found = np.array(y).reshape(*x.shape[:-1], *shape)
            return torch.from_numpy(found).to(x.device)

        @staticmethod
        @once_differentiable  # type: ignore[untyped-decorator]
        def backward(ctx: Any, bars: Any) -> Any:
            """(..., n)."""
            each = bars.detach().cpu().numpy().reshape(-1, *shape)
            found = np.array([one.pull_back(bar) for one, bar in zip(ctx.runs, each, strict=True)])
            return torch.from_numpy(found.reshape(*bars.shape[:-2], len(run.by))).to(bars.device)

    def function(x: Any) -> Any:
        if not isinstance(x, torch.Tensor):
            raise ArgumentError("x", f"is a {type(x).__name__}", "give a tensor of torch.float64")
        if x.dtype != torch.float64:
            raise ArgumentError("x", f"is of {x.dtype}, and a run needs 64 bits", "give x.double()")
        if not x.ndim or x.shape[-1] != len(run.by):
            wanted = f"give {len(run.by)} values last: {', '.join(run.by)}"
            raise ArgumentError("x", f"has shape {tuple(x.shape)}", wanted)
        return Run.apply(x)

    return function
