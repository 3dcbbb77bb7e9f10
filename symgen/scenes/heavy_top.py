"""Heavy top: a fast spinning body on a spherical joint."""

from symgen.scene import Scene, SceneRecord


def heavy_top(orientation: str = "euler_parameters") -> SceneRecord:
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
