"""Truck of 32 coordinates in space: suspensions and tyres as soft as they are, the cab on two stiff bushings."""

from __future__ import annotations

from typing import Any

from symgen.scene import Scene, SceneRecord

CORNERS = {"fl": (1.5, 0.9), "fr": (1.5, -0.9), "rl": (-1.5, 0.9), "rr": (-1.5, -0.9)}  # of the wheels, x and y [m]
ARM = 0.4  # length of a trailing arm [m]
PLACES = {  # centres of mass of the bodies that move freely, at the start [m]
    "chassis": (0.0, 0.0, 0.0),
    "cab": (1.4, 0.0, 0.7),
    "engine": (1.2, 0.0, 0.0),
    "load": (-1.2, 0.0, 0.8),
}
ACROSS: dict[str, Any] = {"axis": [0, 1, 0], "x_axis": [1, 0, 0]}


def vehicle(stiffness: float = 5e7) -> SceneRecord:
    """It comes down on its wheels with a bump under one of them; x ahead, z up, heights from the middle of the wheels.

    stiffness [N/m]: of the two bushings between chassis and cab, along each axis.
    """
    builder = Scene("vehicle", space="spatial", title="Truck with a cab on stiff bushings").gravity(0, 0, -9.81)
    places = {"front": (2.0, 0.0, 0.2), "rear": (0.8, 0.0, 0.2), "engine": (1.2, 0.0, 0.0), "bed": (-1.2, 0.0, 0.2)}
    markers: dict[str, Any] = {name: {"position": list(place)} for name, place in places.items()}
    for key, (x, y) in CORNERS.items():
        markers |= {f"pivot_{key}": {"position": [x + ARM, y, 0.0], **ACROSS}, f"seat_{key}": {"position": [x, y, 0.4]}}
    held = {"front": {"position": [0.6, 0, -0.5]}, "rear": {"position": [-0.6, 0, -0.5]}}
    free: dict[str, Any] = {"free": True, "orientation": "zyx"}
    builder.rigid("chassis", mass=900, inertia=[300, 900, 1000], markers=markers, **free)
    builder.rigid("cab", mass=400, inertia=[120, 140, 160], markers=held, **free)
    builder.rigid("engine", mass=350, inertia=[20, 40, 40], markers={"mount": {}}, **free)
    below = {"bottom": {"position": [0, 0, -0.6]}}
    builder.rigid("load", mass=1500, inertia=[500, 900, 1200], markers=below, **free)
    for end in ("front", "rear"):
        turning = {"rotational_stiffness": [1e5] * 3, "rotational_damping": [100.0] * 3}
        builder.bushing(end, f"chassis.{end}", f"cab.{end}", stiffness=[stiffness] * 3, damping=[5e3] * 3, **turning)
    soft = {"stiffness": [4e5] * 3, "damping": [4e3] * 3, "rotational_stiffness": [4e5] * 3}
    builder.bushing("mount", "chassis.engine", "engine.mount", **soft)
    builder.bushing("bed", "chassis.bed", "load.bottom", **soft)
    builder.ground(markers={f"road_{key}": {"position": [x, y, -0.4]} for key, (x, y) in CORNERS.items()})
    for key in CORNERS:
        _corner(builder, key)
    builder.force("bump", "arm_fl.end", 0.0, 0.0, "4000 * sin(40 * t) * exp(-10 * t)")
    builder.initial({f"{name}.{axis}": {"value": value, "fixed": True} for name, axis, value in _starts()})
    builder.rates({f"spin_{key}.angle": 20.0 for key in CORNERS})
    return builder.simulation(t_end=0.5, dt=1e-4, scheme="single_rate").build()


def _starts() -> list[tuple[str, str, float]]:
    """(body, coordinate, value) of the bodies that move freely."""
    names = ("x", "y", "z", "theta1", "theta2", "theta3")
    return [
        (body, name, value)
        for body, place in PLACES.items()
        for name, value in zip(names, (*place, 0.0, 0.0, 0.0), strict=True)
    ]


def _corner(builder: Scene, key: str) -> None:
    """Trailing arm with a spring, a wheel at its end, and the tyre below."""
    arm, wheel = f"arm_{key}", f"wheel_{key}"
    builder.rigid(
        arm,
        mass=15,
        inertia=[0.05, 0.3, 0.3],
        center_of_mass=[-ARM / 2, 0, 0],
        markers={"pivot": ACROSS, "end": {"position": [-ARM, 0, 0], **ACROSS}},
    )
    builder.rigid(wheel, mass=30, inertia=[1.0, 2.0, 1.0], markers={"axle": ACROSS})
    builder.joint("revolute", f"trail_{key}", f"chassis.pivot_{key}", f"{arm}.pivot")
    builder.joint("revolute", f"spin_{key}", f"{arm}.end", f"{wheel}.axle")
    strut = {"stiffness": 8e4, "damping": 4e3, "free_length": 0.48}
    builder.spring_damper(f"strut_{key}", f"chassis.seat_{key}", f"{arm}.end", **strut)
    builder.spring_damper(
        f"tyre_{key}", f"ground.road_{key}", f"{arm}.end", stiffness=3e5, damping=500.0, free_length=0.42
    )
