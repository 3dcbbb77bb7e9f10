"""Threads of BLAS while a run looks at large matrices."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from threadpoolctl import threadpool_info, threadpool_limits

from runtime.contract.consistent_state import ROWS_OF_ONE_THREAD, dense_eigenvalues, one_thread


def threads() -> list[int]:
    return [library["num_threads"] for library in threadpool_info() if library["user_api"] == "blas"]


@pytest.fixture
def before() -> Iterator[list[int]]:
    """Threads of each library: two."""
    with threadpool_limits(2, "blas"):
        found = threads()
        assert found and set(found) == {2}
        yield found


def test_large_matrices_take_one_thread(before: list[int]) -> None:
    """For as long as it lasts; small ones do not ask."""
    with one_thread(ROWS_OF_ONE_THREAD):
        assert threads() == before
    with one_thread(ROWS_OF_ONE_THREAD + 1):
        assert threads() == [1] * len(before)
    assert threads() == before
    A = np.diag(np.arange(100.0))
    assert np.array_equal(np.sort(dense_eigenvalues(A)), np.arange(100.0))


def test_who_leaves_last_gives_the_threads_back(before: list[int]) -> None:
    """Two that overlap, as in two threads: the first to come leaves first."""
    first, second = one_thread(ROWS_OF_ONE_THREAD + 1), one_thread(ROWS_OF_ONE_THREAD + 1)
    first.__enter__()
    second.__enter__()
    first.__exit__(None, None, None)
    assert threads() == [1] * len(before)
    second.__exit__(None, None, None)
    assert threads() == before
