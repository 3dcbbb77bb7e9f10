"""Two oscillators with inertia coupling (case L1): the smallest system that shows what a sub-cycling scheme does."""

from symgen.scene import Scene, SceneRecord


def two_oscillators() -> SceneRecord:
    """M = [[1, c], [c, 1]], K = diag(k_L, w^2), damping 2 zeta w on the fast one (case L1; Eqs. 3-14)."""
    builder = Scene("two_oscillators", title="Two coupled oscillators (L1)")
    builder.parameter("c", 0.5, "1", "inertia coupling")
    builder.parameter("k_L", 1.0, "1/s^2", "stiffness of the slow oscillator")
    builder.parameter("w", 20.0, "rad/s", "frequency of the fast oscillator alone")
    builder.parameter("zeta", 0.02, "1", "damping ratio of the fast oscillator")
    builder.structure(
        coordinates=["x_L", "x_S"],
        mass=[[1.0, "c"], ["c", 1.0]],
        stiffness=[["k_L", 0.0], [0.0, "w**2"]],
        damping=[[0.0, 0.0], [0.0, "2 * zeta * w"]],
    )
    builder.groups(L=["x_L"], S=["x_S"])
    return (
        builder.initial({"x_L": 1.0, "x_S": 0.1})
        .simulation(t_end=20.0, dt=0.01, m=[4], scheme="printed", seen_every=0.1)
        .build()
    )
