"""The same ensemble in this process and on a Dask cluster of two workers: six thousand pendula, equal bit for bit.

Needs the extra `dask` (pip install "symgen[dask]").
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
from dask.distributed import Client, LocalCluster

from runtime.views.plots import ensemble_picture
from symgen.scenes import SCENES

CASES = 6000


def main(picture: Path | None = None) -> None:
    """Compare all values of both, and say how many workers there were."""
    model = SCENES["pendulum"]().model()
    study = {
        "parameters": {"length": np.linspace(0.9, 1.1, CASES)},
        "initial": {"rod.theta_dot": np.linspace(0.0, 2.0, CASES)},
        "t_end": 0.5,
        "outputs": ["tip_y"],
        "seen_every": 0.01,
    }
    here = model.ensemble(**study)
    with (
        tempfile.TemporaryDirectory() as scratch,
        LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, local_directory=scratch
        ) as cluster,
        Client(cluster) as client,
    ):
        there = model.ensemble(**study, executor=client.get_executor())
        print(f"{len(client.scheduler_info()['workers'])} workers, {there.sizes['case']} cases")
    print("equal bit for bit:", here.identical(there))
    if picture:
        tips = {"tip y [m]": there["tip_y"].values}
        ensemble_picture(f"{CASES} pendula", {}, tips, there["time"].values, picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
