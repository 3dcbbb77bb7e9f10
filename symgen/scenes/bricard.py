"""Bricard's mechanism: a closed ring of six hinges in space that moves although it has one constraint too many."""

from symgen.scene import Scene, SceneRecord

MASS, LENGTH, SIDE = 1.0, 1.0, 0.1
POINTS = ((0, 0, 0), (1, 0, 0), (1, -1, 0), (1, -1, 1), (0, -1, 1), (0, 0, 1))
AXES = ((0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0))


def bricard() -> SceneRecord:
    """Case A04 of the IFToMM benchmark library: five bars between P0 and P5, the sixth is the ground; at rest."""
    builder = Scene("bricard", space="spatial", title="Bricard mechanism").gravity(0.0, -9.81, 0.0)
    builder.ground(markers={f"P{k}": {"position": POINTS[k], "axis": AXES[k]} for k in (0, 5)})
    across, along = MASS * (LENGTH**2 + SIDE**2) / 12, MASS * SIDE**2 / 6
    coordinates: dict[str, float] = {}
    for k in range(5):
        start, end = POINTS[k], POINTS[k + 1]
        span = [b - a for a, b in zip(start, end, strict=True)]
        builder.rigid(
            f"bar{k + 1}",
            mass=MASS,
            inertia=[along if d else across for d in span],
            center_of_mass=[d / 2 for d in span],
            markers={"start": {"axis": AXES[k]}, "end": {"position": span, "axis": AXES[k + 1]}},
        )
        coordinates |= {f"bar{k + 1}.{axis}": float(value) for axis, value in zip("xyz", start, strict=True)}
        builder.joint("revolute", f"hinge{k}", f"bar{k}.end" if k else "ground.P0", f"bar{k + 1}.start")
    builder.joint("revolute", "hinge5", "bar5.end", "ground.P5")
    builder.measure("P3_x", "x", "bar3.end").measure("P3_y", "y", "bar3.end").measure("P3_z", "z", "bar3.end")
    builder.initial(coordinates)
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="single_rate").build()
