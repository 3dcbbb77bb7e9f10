"""Mesh a connecting rod with hexahedra, reduce it to six modes, and write its modal data for a scene (--out).

The built-in scene spatial_slider_crank uses the data that this writes to symgen/scenes/connecting_rod.json.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import numpy as np

from symgen.fe.connecting_rod import connecting_rod


def main() -> None:
    """Say what the reduction keeps and loses, and write the data where --out says."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, help="JSON file to write")
    path = parser.parse_args().out
    rod = connecting_rod(modes=6)
    print(rod.report())
    if path is not None:
        path.write_text(json.dumps(rod.fields(damping_ratio=0.002), indent=1) + "\n", encoding="utf-8")
        print(f"wrote {path}")
        surface = path.with_name(f"{path.stem}_surface.npz")
        np.savez_compressed(surface, **rod.surface(max_triangles=2000))
        print(f"wrote {surface}, which solution.view and symgen view --surface rod={surface.name} show")


if __name__ == "__main__":
    main()
