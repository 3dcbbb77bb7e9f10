"""Two-link manipulator with motors behind stiff joint springs."""

from symgen.scene import Scene, SceneRecord

LENGTH, MASSES = 0.5, (4.0, 3.0)  # m, kg
ROTOR, STIFFNESS = 8e-3, 3e4  # kg m^2 and N m/rad, both on the link's side of the gear


def flexible_joint_arm() -> SceneRecord:
    """A hanging two-link arm swung by two motors, each rotor behind a stiff undamped joint spring.

    Slow and fast coordinates are coupled by stiffness, not by inertia: the springs stand in the rows of the links too.
    """
    builder = Scene("flexible_joint_arm", title="Manipulator with flexible joints").gravity(0, -9.81)
    builder.parameter("shoulder_torque", 25.0, "N m", "amplitude of the first motor")
    builder.parameter("elbow_torque", 6.0, "N m", "amplitude of the second motor")
    previous = "ground.origin"
    for k, mass in enumerate(MASSES, start=1):
        builder.rigid(
            f"link{k}",
            mass=mass,
            inertia=mass * LENGTH**2 / 12,
            center_of_mass=(LENGTH / 2, 0),
            markers={"tip": {"position": (LENGTH, 0)}},
        )
        builder.rigid(f"rotor{k}", mass=0.5, inertia=ROTOR)
        builder.revolute(f"joint{k}", previous, f"link{k}.origin").revolute(f"motor{k}", previous, f"rotor{k}.origin")
        builder.rotational_spring_damper(f"gear{k}", f"rotor{k}.origin", f"link{k}.origin", stiffness=STIFFNESS)
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
