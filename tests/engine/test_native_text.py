"""C whose LLVM IR is checked in: the two belong together, and the text is for any processor."""

from __future__ import annotations

import re
from importlib.metadata import PackageNotFoundError, version

import pytest

from runtime.engine.native_text import compiled, sources

ZIG = "0.17.1"  # whose Clang wrote the texts


def _zig() -> str:
    try:
        return version("ziglang")
    except PackageNotFoundError:
        return "none"


@pytest.mark.parametrize("source", sources(), ids=lambda path: path.name)
def test_text_has_nothing_of_one_processor(source) -> None:
    text = source.with_suffix(".ll").read_text(encoding="utf-8")
    assert not re.search(r"^target |^attributes|^!|#\d|@llvm\.lifetime|!\d", text, re.M)


@pytest.mark.parametrize("source", sources(), ids=lambda path: path.name)
@pytest.mark.skipif(_zig() != ZIG, reason=f"ziglang {ZIG} wrote the texts; {_zig()} is here")
def test_text_is_that_of_its_c(source) -> None:
    assert source.with_suffix(".ll").read_text(encoding="utf-8") == compiled(source)
