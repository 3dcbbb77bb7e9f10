"""Mass matrices, as checks look at them."""

from __future__ import annotations

import numpy as np

from runtime.contract.consistent_state import one_thread


def positive_definite(M_hat: np.ndarray) -> bool:
    """Is M_hat (n_i x n_i) finite, and are its eigenvalues positive?"""
    with one_thread(len(M_hat)):
        return bool(np.isfinite(M_hat).all() and np.linalg.eigvalsh(M_hat)[0] > 0)
