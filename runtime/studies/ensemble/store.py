"""The answer of a long ensemble on disk: a Zarr store that is written part by part, so that memory holds one part."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.errors import ArgumentError, NoResult
from runtime.contract.files import OutputError
from runtime.studies.ensemble.ensemble_result import ensemble_result
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.lane_runs import LaneResults

STORE = "results.zarr"
WRITING = "results-being-written.zarr"


def check_store(folder: str | Path | None) -> None:
    """Can results stay on disk? Raises ArgumentError without a folder, NoResult without the libraries."""
    if folder is None:
        raise ArgumentError("on_disk", "keeps the results in a folder, and none is given", "give folder, too")
    missing = [name for name in ("xarray", "zarr") if find_spec(name) is None]
    if missing:
        raise NoResult("on_disk", f"{' and '.join(missing)} not installed", "pip install 'symgen[zarr]'")


def stored(
    spec: EnsembleSpec,
    table: np.ndarray,
    folder: str | Path,
    chunk: int,
    read: Callable[[int, int], LaneResults | None],
) -> Any:
    """Write parts that `read(first, count)` gives into the store of a folder, and open it.

    Parts that are not there are `interrupted`. Returns an xarray.Dataset whose variables are read when they are asked
    for. Raises OutputError.
    """
    import xarray

    place, aside = Path(folder) / STORE, Path(folder) / WRITING
    try:
        for old in (place, aside):
            if old.exists():
                shutil.rmtree(old)
        for first in range(0, len(table), chunk):
            samples = table[first : first + chunk]
            part = read(first, len(samples)) or LaneResults.none_yet(spec, len(samples))
            piece = ensemble_result(spec, samples, part, first)
            added: dict[str, Any] = {"append_dim": "case"} if first else {"mode": "w"}
            piece.to_zarr(aside, zarr_format=2, consolidated=False, **added)  # 3 has no texts of one length
        aside.rename(place)
        return xarray.open_zarr(place, consolidated=False, chunks=None)
    except OSError as error:
        raise OutputError(f"{place} cannot be written: {error}") from error
