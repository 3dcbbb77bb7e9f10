"""Mechanisms in space: tops, rings, governors, chains, a slider-crank with a rod from finite elements."""

from __future__ import annotations

import json
from collections.abc import Sequence
from math import pi, sqrt
from pathlib import Path

from symgen.mechanism.builder import Scene
from symgen.mechanism.scene import SceneRecord
from symgen.scene.bodies import Orientation


def heavy_top(orientation: Orientation = "euler_parameters") -> SceneRecord:
    """Spin 150 rad/s about the axis through its centre of mass, which starts level.

    orientation: Euler parameters, or Euler angles about three different axes, by which the start is given then.
    """
    builder = Scene("heavy_top", space="spatial", title="Heavy top").gravity(0.0, 0.0, -9.81)
    builder.rigid(
        "top",
        mass=15.0,
        inertia=[0.234375, 0.46875, 0.234375],
        orientation=orientation,
        markers={"foot": {"position": [0, -1, 0]}},
    )
    builder.joint("spherical", "foot", "ground.origin", "top.foot")
    about = (0.0, 150.0, -4.61538)
    parameters = orientation == "euler_parameters"
    names = ["e1", "e2", "e3"] if parameters else [f"theta{orientation.index(axis) + 1}" for axis in "xyz"]
    share = 0.5 if parameters else 1.0
    builder.initial({"top.y": 1.0}).rates({f"top.{name}": share * w for name, w in zip(names, about, strict=True)})
    return builder.simulation(t_end=1.0, dt=1e-4, scheme="rk4", seen_every=0.001).build()


def tumbling_body(e: Sequence[float] = (1.0, 0.0, 0.0, 0.0), omega: Sequence[float] = (0.01, 1.0, 0.01)) -> SceneRecord:
    """Inertia (1, 2, 3) kg m^2; e: Euler parameters at the start, omega: angular velocity in body axes [rad/s]."""
    builder = Scene("tumbling_body", space="spatial", title="Free body turning over")
    builder.rigid(
        "body",
        mass=1.0,
        inertia=[1.0, 2.0, 3.0],
        free=True,
        markers={"tip_x": {"position": [1, 0, 0]}, "tip_y": {"position": [0, 1, 0]}},
    )
    e0, e1, e2, e3 = e
    x, y, z = omega
    rates = (
        -(e1 * x + e2 * y + e3 * z) / 2,
        (e0 * x - e3 * y + e2 * z) / 2,
        (e3 * x + e0 * y - e1 * z) / 2,
        (-e2 * x + e1 * y + e0 * z) / 2,
    )
    builder.initial({f"body.e{k}": value for k, value in enumerate(e)})
    builder.rates({f"body.e{k}": value for k, value in enumerate(rates)})
    return builder.simulation(t_end=100.0, dt=0.01, scheme="rk4", seen_every=0.1).build()


def bricard() -> SceneRecord:
    """Case A04 of the IFToMM benchmark library: five bars between P0 and P5, the sixth is the ground; at rest."""
    mass, length, side = 1.0, 1.0, 0.1
    points = ((0, 0, 0), (1, 0, 0), (1, -1, 0), (1, -1, 1), (0, -1, 1), (0, 0, 1))
    axes = ((0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0))
    builder = Scene("bricard", space="spatial", title="Bricard mechanism").gravity(0.0, -9.81, 0.0)
    builder.ground(markers={f"P{k}": {"position": points[k], "axis": axes[k]} for k in (0, 5)})
    across, along = mass * (length**2 + side**2) / 12, mass * side**2 / 6
    coordinates: dict[str, float] = {}
    for k in range(5):
        start, end = points[k], points[k + 1]
        span = [b - a for a, b in zip(start, end, strict=True)]
        builder.rigid(
            f"bar{k + 1}",
            mass=mass,
            inertia=[along if d else across for d in span],
            center_of_mass=[d / 2 for d in span],
            markers={"start": {"axis": axes[k]}, "end": {"position": span, "axis": axes[k + 1]}},
        )
        coordinates |= {f"bar{k + 1}.{axis}": float(value) for axis, value in zip("xyz", start, strict=True)}
        builder.joint("revolute", f"hinge{k}", f"bar{k}.end" if k else "ground.P0", f"bar{k + 1}.start")
    builder.joint("revolute", "hinge5", "bar5.end", "ground.P5")
    builder.measure("P3_x", "x", "bar3.end").measure("P3_y", "y", "bar3.end").measure("P3_z", "z", "bar3.end")
    builder.initial(coordinates)
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="single_rate").build()


def flyball_governor() -> SceneRecord:
    """Case A05 of the IFToMM benchmark library: the shaft turns about z, the rods hang on hinges beside it."""
    builder = Scene("flyball_governor", space="spatial", title="Stiff flyball governor")
    builder.gravity(0.0, 0.0, -9.81)
    _governor(builder)
    builder.joint("revolute", "spin", "ground.origin", "shaft.origin")
    builder.joint("prismatic", "height", "shaft.origin", "slider.origin")
    for side in ("right", "left"):
        builder.joint("revolute", f"{side}_swing", f"shaft.{side}", f"{side}_rod.hinge")
        builder.spring_damper(
            f"{side}_spring",
            f"{side}_rod.middle",
            f"slider.{side}",
            stiffness=8e5,
            damping=4e4,
            free_length=0.5,
        )
    builder.initial({"height.travel": 0.5, "right_swing.angle": pi / 6, "left_swing.angle": pi / 6})
    builder.rates({"spin.angle": 2 * pi})
    return builder.simulation(t_end=10.0, dt=1e-3, scheme="radau", seen_every=0.01).build()


def _governor(builder: Scene) -> None:
    """Shaft, slider, and two rods with a ball at the end."""
    density, length, width, side, ball, offset = 3000.0, 1.0, 0.01, 0.1, 5.0, 0.05
    rod = density * width**2 * length
    across, along = rod * (length**2 + width**2) / 12, rod * width**2 / 6
    builder.rigid(
        "shaft",
        mass=rod,
        inertia=[across, across, along],
        center_of_mass=[0, 0, length / 2],
        markers={
            "right": {"position": [offset, 0, length], "axis": [0, 1, 0]},
            "left": {"position": [-offset, 0, length], "axis": [0, -1, 0], "x_axis": [-1, 0, 0]},
        },
    )
    cube = density * side**3
    builder.rigid(
        "slider",
        mass=cube,
        inertia=[cube * side**2 / 6] * 3,
        markers={"right": {"position": [offset, 0, 0]}, "left": {"position": [-offset, 0, 0]}},
    )
    mass = rod + ball
    center = (rod * length / 2 + ball * length) / mass
    about = across + rod * (center - length / 2) ** 2 + ball * (length - center) ** 2
    for name in ("right_rod", "left_rod"):
        builder.rigid(
            name,
            mass=mass,
            inertia=[along, about, about],
            center_of_mass=[center, 0, 0],
            markers={
                "hinge": {"axis": [0, 1, 0]},
                "middle": {"position": [length / 2, 0, 0]},
                "ball": {"position": [length, 0, 0]},
            },
        )


def spatial_chain(links: int = 3, modes: int = 0, orientation: Orientation = "zyx") -> SceneRecord:
    """Links along their own x-axis, the first one starting level along x; Euler angles zyx by default."""
    length, side = 0.2, 0.008
    builder = Scene("spatial_chain", space="spatial", title=f"Chain of {links} links in space")
    builder.gravity(0.0, 0.0, -9.81)
    mass, across = 2700 * side**2 * length, side**2 / 12
    slender = length**2 / 12 + across
    for k in range(links):
        link = f"link{k + 1}"
        if modes:
            builder.beam(
                link,
                length=length,
                density=2700.0,
                area=side**2,
                second_moment=side**4 / 12,
                second_moment_z=side**4 / 12,
                youngs_modulus=7e10,
                orientation=orientation,
                lateral={"ends": "clamped-free", "modes": modes - modes // 2},
                lateral_z={"ends": "clamped-free", "modes": modes // 2} if modes > 1 else None,
            )
        else:
            builder.rigid(
                link,
                mass=mass,
                inertia=[mass * 2 * across, mass * slender, mass * slender],
                center_of_mass=[length / 2, 0, 0],
                orientation=orientation,
                markers={"start": {}, "end": {"position": [length, 0, 0]}},
            )
        builder.joint("spherical", f"joint{k + 1}", f"link{k}.end" if k else "ground.origin", f"{link}.start")
    builder.rates({"link1.theta1": 1.0} if orientation == "zyx" else {})
    return builder.simulation(t_end=1.0, dt=1e-4, scheme="single_rate").build()


ROD = Path(__file__).with_name("connecting_rod.json")  # written by examples/mesh_connecting_rod.py


def spatial_slider_crank() -> SceneRecord:
    """The crank turns about x beside the slider's line, so that the rod sweeps through space and bends both ways."""
    crank, height, aside, length = 0.05, 0.04, 0.01, 0.3
    title = "Slider-crank in space, rod from finite elements"
    builder = Scene("spatial_slider_crank", space="spatial", title=title).gravity(0.0, 0.0, -9.81)
    along = {"axis": [1, 0, 0], "x_axis": [0, 1, 0]}
    builder.ground(
        markers={"axle": {"position": [0, 0, height], **along}, "guide": {"position": [0, aside, 0], **along}}
    )
    builder.rigid(
        "crank",
        mass=0.6,
        inertia=[6e-4, 3e-4, 4e-4],
        center_of_mass=[0, 0.01, 0],
        markers={"axle": along, "pin": {"position": [0, crank, 0]}},
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
    x = sqrt(length**2 - (crank - aside) ** 2 - height**2)
    builder.initial(
        {"axle.angle": {"value": 0.0, "fixed": True}, "guide.travel": x, "fork.angle1": 3.0, "fork.angle2": -0.13}
    )
    builder.rates({"axle.angle": {"value": 60.0, "fixed": True}})
    return builder.simulation(
        t_end=0.2, dt=1e-4, m=[4], scheme="coupled", seen_every=0.0004, start="quasi_static"
    ).build()
