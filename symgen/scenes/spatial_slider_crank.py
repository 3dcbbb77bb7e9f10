"""Slider-crank in space with a connecting rod from finite elements: 5,205 degrees of freedom reduced to six modes."""

from __future__ import annotations

import json
from math import sqrt
from pathlib import Path

from symgen.scene import Scene, SceneRecord

ROD = Path(__file__).with_name("connecting_rod.json")  # written by examples/mesh_connecting_rod.py
CRANK, HEIGHT, ASIDE, LENGTH = 0.05, 0.04, 0.01, 0.3


def spatial_slider_crank() -> SceneRecord:
    """The crank turns about x beside the slider's line, so that the rod sweeps through space and bends both ways."""
    title = "Slider-crank in space, rod from finite elements"
    builder = Scene("spatial_slider_crank", space="spatial", title=title).gravity(0.0, 0.0, -9.81)
    along = {"axis": [1, 0, 0], "x_axis": [0, 1, 0]}
    builder.ground(
        markers={"axle": {"position": [0, 0, HEIGHT], **along}, "guide": {"position": [0, ASIDE, 0], **along}}
    )
    builder.rigid(
        "crank",
        mass=0.6,
        inertia=[6e-4, 3e-4, 4e-4],
        center_of_mass=[0, 0.01, 0],
        markers={"axle": along, "pin": {"position": [0, CRANK, 0]}},
    )
    builder.rigid(
        "slider",
        mass=0.4,
        inertia=[2e-4, 2e-4, 2e-4],
        markers={"guide": along, "fork": {"axis": [0, 0, 1], "x_axis": [0, 1, 0]}},
    )
    data = json.loads(ROD.read_text(encoding="utf-8"))
    data["markers"]["small_end"] |= {"axis": [0, 0, 1], "x_axis": [0, -1, 0]}
    builder.flexible("rod", **data)
    builder.joint("revolute", "axle", "ground.axle", "crank.axle")
    builder.joint("prismatic", "guide", "ground.guide", "slider.guide", damping=2.0)
    builder.joint("universal", "fork", "slider.fork", "rod.small_end")
    builder.joint("spherical", "pin", "crank.pin", "rod.big_end")
    builder.independent("axle.angle", *(f"rod.q{k + 1}" for k in range(len(data["M_ff"]))))
    x = sqrt(LENGTH**2 - (CRANK - ASIDE) ** 2 - HEIGHT**2)
    builder.initial(
        {"axle.angle": {"value": 0.0, "fixed": True}, "guide.travel": x, "fork.angle1": 3.0, "fork.angle2": -0.13}
    )
    builder.rates({"axle.angle": {"value": 60.0, "fixed": True}})
    return builder.simulation(
        t_end=0.2, dt=1e-4, m=[4], scheme="coupled", seen_every=0.0004, start="quasi_static"
    ).build()
