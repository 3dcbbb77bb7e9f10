"""The scene that `symgen new` writes: a small working mechanism, with the other choices as comments."""

TEMPLATE = """\
# A scene of symgen. All numbers are in SI units: m, kg, s, N, rad. Angles are absolute and counter-clockwise.
# Look at it:    symgen show @FILE@
# Simulate it:   symgen simulate @FILE@ --out results
# Watch it:      symgen animate results
name = "@NAME@"
title = "Crank with a flexible rod"
description = "A torque turns a rigid crank; a flexible rod swings from its tip."
gravity = [0.0, -9.81]

# Parameters are inputs of the generated code: change them at run time with --set torque=0.2.
# Wherever a number stands below, an expression in parameters may stand too, in quotes: "0.5*crank_length".
[parameters]
torque = { default = 0.1, unit = "N m", description = "drive torque on the crank" }
crank_length = { default = 0.2, unit = "m", description = "distance between the crank's pins" }

# --- Bodies --------------------------------------------------------------------------------------------------
# The ground is there without being mentioned; its marker "ground.origin" is the point (0, 0).
# [[bodies]]
# type = "ground"
# name = "ground"
# markers.support = { position = [0.5, 0.0], angle = 0.0 }

[[bodies]]
type = "rigid"
name = "crank"
mass = 0.5
inertia = 0.002                                  # about the centre of mass
center_of_mass = ["0.5*crank_length", 0.0]
markers.tip = { position = ["crank_length", 0.0] }

[[bodies]]
type = "beam"                                    # uniform; markers "rod.start" and "rod.end" are always there
name = "rod"
length = 0.5
density = 2700.0
area = 4e-5
second_moment = 5.3e-11
youngs_modulus = 7e10
elements = 20                                    # the paper's lumped mesh; leave it out for exact shapes
lateral = { ends = "clamped-free", modes = 2 }   # also pinned-pinned, free-free, clamped-pinned, clamped-clamped
# axial = { ends = "fixed-free", modes = 1 }
damping_ratio = 0.01                             # of every mode
stiffening = true                                # geometric stiffening: keep it for bodies that turn fast

# --- Joints: revolute, prismatic, weld, point_on_line, distance, prescribed_angle, prescribed_displacement ----
[[joints]]
type = "revolute"
name = "hinge"
marker_a = "ground.origin"
marker_b = "crank.origin"
damping = 0.01

[[joints]]
type = "revolute"
name = "pin"
marker_a = "crank.tip"
marker_b = "rod.start"

# [[joints]]
# type = "prescribed_angle"
# name = "drive"
# marker_a = "ground.origin"
# marker_b = "crank.origin"
# motion = "2*pi*t"

# --- Loads: force, torque, effort, spring_damper, rotational_spring_damper; gravity is set above ---------------
[[loads]]
type = "torque"
name = "drive"
marker = "crank.origin"
value = "torque*sin(pi*t)"                       # of t, parameters, measures and their rates (swing_dot)

# --- Measures: angle, distance, x, y between two markers; coordinate; forces and moments in beams -------------
[[measures]]
type = "angle"
name = "swing"
marker_a = "crank.origin"
marker_b = "rod.start"

# --- Groups of coordinates that share a step size, slow to fast -----------------------------------------------
[partition]
independent = ["crank.theta", "rod.theta", "rod.q1", "rod.q2"]
groups = [
    { name = "slow", coordinates = ["*.theta"] },
    { name = "fast", coordinates = ["rod.q*"] },
]

# --- Start: what is left out is found from the joints ---------------------------------------------------------
[initial]
coordinates."crank.theta" = { value = 0.0, fixed = true }
coordinates."rod.theta" = -1.0

# --- How to step it -------------------------------------------------------------------------------------------
# scheme "single_rate" steps everything with dt. With "printed" (the paper's sub-cycling) dt is the step of the slow
# group and m = [10] gives the next group ten sub-steps in it; this rod is coupled so strongly to its angle that the
# paper's sweep hardly converges, so solve its equations at once: --option common_update=direct
[simulation]
t_end = 1.0
dt = 2e-4
scheme = "single_rate"
save_every = 10
# Instead of a step: scheme = "auto" and tolerance = 1e-3; dt is then the time between the states that are saved.
"""


def scene_text(name: str, file: str) -> str:
    """The template for a scene called `name`, kept in `file`."""
    return TEMPLATE.replace("@NAME@", name).replace("@FILE@", file)
