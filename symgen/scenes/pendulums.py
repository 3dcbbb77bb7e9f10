"""Pendulums, chains and oscillators of rigid bodies, or of beams."""

from symgen.mechanism.builder import Scene
from symgen.mechanism.scene import SceneRecord


def pendulum() -> SceneRecord:
    """A point mass on a massless rod, released horizontally (case P1)."""
    return (
        Scene(
            "pendulum",
            title="Simple pendulum",
            description="1 kg at 1 m on a massless rod, released at rest. Period 2.36784194757624 s.",
        )
        .parameter("length", 1.0, "m", "length of the rod")
        .gravity(0, -9.81)
        .rigid("rod", mass=1.0, inertia=0.0, center_of_mass=("length", 0), markers={"tip": {"position": ("length", 0)}})
        .revolute("hinge", "ground.origin", "rod.origin")
        .measure("tip_x", "x", of="rod.tip")
        .measure("tip_y", "y", of="rod.tip")
        .initial({"rod.theta": 3.141592653589793})
        .simulation(t_end=10.0, dt=1e-3, scheme="single_rate", seen_every=0.01)
        .build()
    )


def double_pendulum() -> SceneRecord:
    """Two uniform rods of 1 m and 1 kg, released from the horizontal."""
    return (
        Scene("double_pendulum", title="Double pendulum")
        .gravity(0, -9.81)
        .rigid("upper", mass=1.0, inertia=1 / 12, center_of_mass=(0.5, 0), markers={"tip": {"position": (1.0, 0)}})
        .rigid("lower", mass=1.0, inertia=1 / 12, center_of_mass=(0.5, 0), markers={"tip": {"position": (1.0, 0)}})
        .revolute("shoulder", "ground.origin", "upper.origin")
        .revolute("elbow", "upper.tip", "lower.origin")
        .initial({"upper.theta": 0.0, "lower.theta": 0.0})
        .simulation(t_end=5.0, dt=5e-4, scheme="single_rate", seen_every=0.01)
        .build()
    )


def elastic_pendulum() -> SceneRecord:
    """A body hung on a stiff spring: a slow swing and a fast stretch without joints."""
    return (
        Scene(
            "elastic_pendulum",
            title="Elastic pendulum",
            description="A body on a spring: slow swinging, fast stretching, no joint at all.",
        )
        .gravity(0, -9.81)
        .rigid("bob", mass=1.0, inertia=0.01, free=True)
        .spring_damper("spring", "ground.origin", "bob.origin", stiffness=1000.0, damping=0.5, free_length=1.0)
        .measure("stretch", "distance", of="bob.origin")
        .initial({"bob.x": 0.6, "bob.y": -0.8})
        .simulation(t_end=10.0, dt=1e-3, scheme="single_rate", seen_every=0.01)
        .build()
    )


def overdamped_joint() -> SceneRecord:
    """A pendulum carries a 20 g finger on a joint spring with a damper some 30 times the critical one.

    The finger's fast rate is damping / inertia = 2e4 1/s, its slow one stiffness / damping, about 4 1/s, as slow as the
    pendulum. So the damper, not the spring, limits the step of a scheme that takes velocities explicitly.
    """
    finger = {"mass": 0.02, "length": 0.1}
    inertia = finger["mass"] * finger["length"] ** 2 / 3  # about the joint
    return (
        Scene("overdamped_joint", title="Pendulum with an overdamped joint")
        .gravity(0, -9.81)
        .rigid(
            "rod", mass=0.5, inertia=0.5 * 0.4**2 / 12, center_of_mass=(0.2, 0), markers={"tip": {"position": (0.4, 0)}}
        )
        .rigid("finger", mass=finger["mass"], inertia=inertia / 4, center_of_mass=(finger["length"] / 2, 0))
        .revolute("hinge", "ground.origin", "rod.origin")
        .revolute("knuckle", "rod.tip", "finger.origin")
        .rotational_spring_damper("spring", "rod.origin", "finger.origin", stiffness=5.0, damping=2e4 * inertia)
        .groups(L=["rod.theta"], S=["finger.theta"])
        .initial({"rod.theta": 0.0, "finger.theta": 0.0})
        .simulation(t_end=3.0, dt=5e-5, m=[1], scheme="single_rate", seen_every=0.005)
        .build()
    )


def flexible_joint_arm() -> SceneRecord:
    """A hanging two-link arm swung by two motors, each rotor behind a stiff undamped joint spring.

    Slow and fast coordinates are coupled by stiffness, not by inertia: the springs stand in the rows of the links too.
    """
    length, masses = 0.5, (4.0, 3.0)  # m, kg
    rotor, stiffness = 8e-3, 3e4  # kg m^2 and N m/rad, both on the link's side of the gear
    builder = Scene("flexible_joint_arm", title="Manipulator with flexible joints").gravity(0, -9.81)
    builder.parameter("shoulder_torque", 25.0, "N m", "amplitude of the first motor")
    builder.parameter("elbow_torque", 6.0, "N m", "amplitude of the second motor")
    previous = "ground.origin"
    for k, mass in enumerate(masses, start=1):
        builder.rigid(
            f"link{k}",
            mass=mass,
            inertia=mass * length**2 / 12,
            center_of_mass=(length / 2, 0),
            markers={"tip": {"position": (length, 0)}},
        )
        builder.rigid(f"rotor{k}", mass=0.5, inertia=rotor)
        builder.revolute(f"joint{k}", previous, f"link{k}.origin").revolute(f"motor{k}", previous, f"rotor{k}.origin")
        builder.rotational_spring_damper(f"gear{k}", f"rotor{k}.origin", f"link{k}.origin", stiffness=stiffness)
        previous = f"link{k}.tip"
    down = {f"{body}{k}.theta": -1.5707963267948966 for k in (1, 2) for body in ("link", "rotor")}
    return (
        builder.torque("shoulder", "rotor1.origin", "shoulder_torque * sin(pi * t)")
        .torque("elbow", "rotor2.origin", "elbow_torque * sin(2 * pi * t)", reaction="link1.origin")
        .groups(L=["link*.theta"], S=["rotor*.theta"])
        .initial(down)
        .simulation(t_end=2.0, dt=2e-4, m=[1], scheme="single_rate", seen_every=0.004)
        .build()
    )


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
