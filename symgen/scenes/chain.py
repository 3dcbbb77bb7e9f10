"""N-link chain hanging from the ground, rigid or flexible."""

from symgen.scene import Scene, SceneRecord


def chain(links: int = 10, modes: int = 0) -> SceneRecord:
    """A hanging chain of `links` uniform links of 0.5 m, each with `modes` lateral modes (0: rigid)."""
    builder = Scene("chain", title=f"Chain of {links} links").gravity(0, -9.81)
    builder.parameter("link_length", 0.5, "m", "length of a link")
    previous = "ground.origin"
    for k in range(1, links + 1):
        name = f"link{k}"
        if modes:
            builder.beam(
                name,
                length="link_length",
                density=7800.0,
                area=2e-5,
                second_moment=1e-11,
                youngs_modulus=2e11,
                lateral={"ends": "clamped-free", "modes": modes},
            )
            start, end = f"{name}.start", f"{name}.end"
        else:
            builder.rigid(
                name,
                mass=0.078,
                inertia="0.078 * link_length**2 / 12",
                center_of_mass=("link_length / 2", 0),
                markers={"end": {"position": ("link_length", 0)}},
            )
            start, end = f"{name}.origin", f"{name}.end"
        builder.revolute(f"hinge{k}", previous, start)
        previous = end
    angles = {f"link{k}.theta": -1.2 for k in range(1, links + 1)}
    m = [1] if modes else []
    return builder.initial(angles).simulation(t_end=2.0, dt=2e-4, m=m, scheme="single_rate", seen_every=0.01).build()
