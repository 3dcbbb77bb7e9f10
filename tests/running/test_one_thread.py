"""Threads of BLAS while a run looks at large matrices."""

from __future__ import annotations

import numpy as np
from threadpoolctl import threadpool_info

from runtime.contract.one_thread import SMALL, dense_eigenvalues, one_thread


def threads() -> list[int]:
    return [library["num_threads"] for library in threadpool_info() if library["user_api"] == "blas"]


def test_large_matrices_take_one_thread() -> None:
    """For as long as it lasts; small ones do not ask."""
    before = threads()
    with one_thread(SMALL):
        assert threads() == before
    with one_thread(SMALL + 1):
        assert threads() == [1] * len(before)
    assert threads() == before and before
    A = np.diag(np.arange(100.0))
    assert np.array_equal(np.sort(dense_eigenvalues(A)), np.arange(100.0))
