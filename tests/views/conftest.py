"""The browser that looks at pages ends with the tests."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.support.browser import leave


@pytest.fixture(scope="session", autouse=True)
def browser_ends() -> Iterator[None]:
    yield
    leave()
