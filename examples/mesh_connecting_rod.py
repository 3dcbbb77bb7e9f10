"""Mesh a connecting rod with hexahedra, reduce it to six modes, and write its modal data for a scene.

The built-in scene spatial_slider_crank uses the data that this writes to symgen/scenes/connecting_rod.json.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from symgen.fe.connecting_rod import connecting_rod


def main() -> None:
    """Write the data and say what the reduction keeps and loses."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("connecting_rod.json"))
    path = parser.parse_args().out
    rod = connecting_rod(modes=6)
    path.write_text(json.dumps(rod.fields(damping_ratio=0.002), indent=1) + "\n", encoding="utf-8")
    print(rod.report())
    print(f"wrote {path}")


if __name__ == "__main__":
    main()
