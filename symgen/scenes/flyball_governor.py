"""Flyball governor: two rods on a spinning shaft lift a slider through stiff springs with strong dampers."""

from math import pi

from symgen.scene import Scene, SceneRecord

GRAVITY, DENSITY, LENGTH, WIDTH, CUBE, BALL = 9.81, 3000.0, 1.0, 0.01, 0.1, 5.0
OFFSET, STIFFNESS, DAMPING, FREE = 0.05, 8e5, 4e4, 0.5


def flyball_governor() -> SceneRecord:
    """Case A05 of the IFToMM benchmark library: the shaft turns about z, the rods hang on hinges beside it."""
    builder = Scene("flyball_governor", space="spatial", title="Stiff flyball governor")
    builder.gravity(0.0, 0.0, -GRAVITY)
    _bodies(builder)
    builder.joint("revolute", "spin", "ground.origin", "shaft.origin")
    builder.joint("prismatic", "height", "shaft.origin", "slider.origin")
    for side in ("right", "left"):
        builder.joint("revolute", f"{side}_swing", f"shaft.{side}", f"{side}_rod.hinge")
        builder.spring_damper(
            f"{side}_spring",
            f"{side}_rod.middle",
            f"slider.{side}",
            stiffness=STIFFNESS,
            damping=DAMPING,
            free_length=FREE,
        )
    builder.initial({"height.travel": 0.5, "right_swing.angle": pi / 6, "left_swing.angle": pi / 6})
    builder.rates({"spin.angle": 2 * pi})
    return builder.simulation(t_end=10.0, dt=1e-3, scheme="radau", seen_every=0.01).build()


def _bodies(builder: Scene) -> None:
    """Shaft, slider, and two rods with a ball at the end."""
    rod = DENSITY * WIDTH**2 * LENGTH
    across, along = rod * (LENGTH**2 + WIDTH**2) / 12, rod * WIDTH**2 / 6
    builder.rigid(
        "shaft",
        mass=rod,
        inertia=[across, across, along],
        center_of_mass=[0, 0, LENGTH / 2],
        markers={
            "right": {"position": [OFFSET, 0, LENGTH], "axis": [0, 1, 0]},
            "left": {"position": [-OFFSET, 0, LENGTH], "axis": [0, -1, 0], "x_axis": [-1, 0, 0]},
        },
    )
    cube = DENSITY * CUBE**3
    builder.rigid(
        "slider",
        mass=cube,
        inertia=[cube * CUBE**2 / 6] * 3,
        markers={"right": {"position": [OFFSET, 0, 0]}, "left": {"position": [-OFFSET, 0, 0]}},
    )
    mass = rod + BALL
    center = (rod * LENGTH / 2 + BALL * LENGTH) / mass
    about = across + rod * (center - LENGTH / 2) ** 2 + BALL * (LENGTH - center) ** 2
    for name in ("right_rod", "left_rod"):
        builder.rigid(
            name,
            mass=mass,
            inertia=[along, about, about],
            center_of_mass=[center, 0, 0],
            markers={
                "hinge": {"axis": [0, 1, 0]},
                "middle": {"position": [LENGTH / 2, 0, 0]},
                "ball": {"position": [LENGTH, 0, 0]},
            },
        )
