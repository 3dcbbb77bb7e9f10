"""A free body that spins about its middle axis of inertia, turns over again and again, and meets every orientation."""

from collections.abc import Sequence

from symgen.scene import Scene, SceneRecord


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
