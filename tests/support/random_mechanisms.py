"""Hypothesis strategies for planar mechanisms: trees of rigid, modal and beam bodies, closed four-bar loops, and beads
on beams that turn."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st

from symgen.scene import Scene, SceneRecord

Draw = Any
ANGLES = st.floats(-3.0, 3.0)
LENGTHS = st.floats(0.2, 1.0)
MASSES = st.floats(0.1, 5.0)
GRAVITY = st.tuples(st.floats(-3, 3), st.floats(-9.81, 9.81))


def add_rigid(builder: Scene, name: str, length: float, draw: Draw) -> tuple[str, str]:
    """A rigid body off its axis; returns its start and end markers."""
    mass = draw(MASSES)
    builder.rigid(
        name,
        mass=mass,
        inertia=mass * length**2 * draw(st.floats(0.05, 0.2)),
        center_of_mass=(length * draw(st.floats(0.2, 0.8)), length * draw(st.floats(-0.2, 0.2))),
        markers={"end": {"position": (length, 0.0), "angle": draw(st.floats(-1, 1))}},
    )
    return f"{name}.origin", f"{name}.end"


def add_beam(builder: Scene, name: str, length: float, draw: Draw, ends: str = "clamped-free") -> tuple[str, str]:
    """A slender beam of one or two lateral modes, perhaps with an axial one, perhaps with geometric stiffening."""
    axial = {"ends": "fixed-free", "modes": 1} if draw(st.booleans()) else None
    side = draw(st.floats(0.01, 0.03))
    builder.beam(
        name,
        length=length,
        density=draw(st.floats(1000, 8000)),
        area=side**2,
        second_moment=side**4 / 12,
        youngs_modulus=draw(st.floats(1e9, 1e11)),
        lateral={"ends": ends, "modes": draw(st.integers(1, 2))},
        axial=axial,
        stiffening=draw(st.booleans()),
    )
    return f"{name}.start", f"{name}.end"


def add_modal(builder: Scene, name: str, length: float, draw: Draw) -> tuple[str, str]:
    """A body of five mass points with random shapes: its integrals are sums over the points."""
    rng, nf = np.random.default_rng(draw(st.integers(0, 10**6))), draw(st.integers(1, 2))
    points = np.array([[0, 0.1], [0.3, -0.1], [0.5, 0.1], [0.8, -0.05], [1.0, 0.0]]) * length
    mass = rng.uniform(0.1, 1.0, 5)
    x_shape, y_shape = 0.2 * rng.uniform(-1, 1, (5, nf)), rng.uniform(-1, 1, (5, nf))
    cross = np.einsum("k,ka,kb->ab", mass, x_shape, y_shape)
    M_ff = np.einsum("k,ka,kb->ab", mass, x_shape, x_shape) + np.einsum("k,ka,kb->ab", mass, y_shape, y_shape)
    builder.modal(
        name,
        mass=mass.sum(),
        first_moment=mass @ points,
        inertia=float(mass @ (points**2).sum(axis=1)),
        M_ff=(M_ff + M_ff.T) / 2,
        K_ff=np.diag(rng.uniform(1e3, 1e5, nf)),
        phi_integral=[mass @ x_shape, mass @ y_shape],
        rho_dot_phi=(mass * points[:, 0]) @ x_shape + (mass * points[:, 1]) @ y_shape,
        rho_cross_phi=(mass * points[:, 0]) @ y_shape - (mass * points[:, 1]) @ x_shape,
        phi_cross_phi=cross - cross.T,
        markers={
            "end": {
                "position": (length, 0.0),
                "shape_x": x_shape[-1],
                "shape_y": y_shape[-1],
                "slope": rng.uniform(-1, 1, nf),
            }
        },
    )
    return f"{name}.origin", f"{name}.end"


ADD = {"rigid": add_rigid, "beam": add_beam, "modal": add_modal}
KINDS = st.sampled_from(list(ADD))


@st.composite
def trees(draw: Draw) -> SceneRecord:
    """1 to 4 bodies, each joined to the ground or to a body before it; undamped springs; gravity."""
    builder = Scene("random_tree").gravity(*draw(GRAVITY)).ground(markers={"hook": {"position": (-0.7, 0.9)}})
    ends, initial, rates = ["ground.origin"], {}, {}
    for k in range(1, draw(st.integers(1, 4)) + 1):
        name = f"body{k}"
        start, end = ADD[draw(KINDS)](builder, name, draw(LENGTHS), draw)
        joint = draw(st.sampled_from(["revolute", "prismatic", *(["revolute", "weld"] if k > 1 else [])]))
        getattr(builder, joint)(f"joint{k}", draw(st.sampled_from(ends)), start)
        ends.append(end)
        if joint == "revolute":
            initial[f"{name}.theta"], rates[f"{name}.theta"] = draw(ANGLES), draw(st.floats(-2, 2))
        if draw(st.booleans()):
            builder.rotational_spring_damper(f"turn{k}", "ground.origin", start, stiffness=draw(st.floats(1, 50)))
    if draw(st.booleans()):
        builder.spring_damper("spring", "ground.hook", ends[-1], stiffness=draw(st.floats(10, 1000)), free_length=0.1)
    return builder.initial(initial).rates(rates).build()


def _direction(angle: float) -> np.ndarray:
    return np.array([math.cos(angle), math.sin(angle)])


@st.composite
def four_bars(draw: Draw) -> SceneRecord:
    """A four-bar assembled at random angles; the coupler may bend (pinned-pinned, so that its ends stay in place)."""
    lengths = [draw(LENGTHS) for _ in range(3)]
    angles = [draw(ANGLES) for _ in range(3)]
    assume(abs(math.sin(angles[1] - angles[2])) > 0.3)  # away from a singular position
    builder = Scene("random_four_bar").gravity(*draw(GRAVITY))
    right = lengths[0] * _direction(angles[0]) + lengths[1] * _direction(angles[1]) - lengths[2] * _direction(angles[2])
    builder.ground(markers={"right": {"position": tuple(right)}})
    crank = add_rigid(builder, "crank", lengths[0], draw)
    flexible = draw(st.booleans())
    coupler = (
        add_beam(builder, "coupler", lengths[1], draw, "pinned-pinned")
        if flexible
        else add_rigid(builder, "coupler", lengths[1], draw)
    )
    rocker = add_rigid(builder, "rocker", lengths[2], draw)
    builder.revolute("A", "ground.origin", crank[0]).revolute("B", crank[1], coupler[0])
    builder.revolute("C", coupler[1], rocker[1]).revolute("D", "ground.right", rocker[0])
    bars = ("crank", "coupler", "rocker")
    builder.initial({f"{name}.theta": angle for name, angle in zip(bars, angles, strict=True)})
    return builder.rates({"crank.theta": draw(st.floats(-2, 2))}).build()


@st.composite
def beads_on_beams(draw: Draw) -> SceneRecord:
    """A bead slides along a beam that turns, perhaps on an arm; a spring keeps it there. No scheme is named.

    Which coordinates of the bead and the beam determine the others changes with the angle of the beam.
    """
    length, side = draw(st.floats(0.5, 1.5)), draw(st.floats(0.015, 0.04))
    builder, on = Scene("random_bead").gravity(*draw(GRAVITY)), "ground.origin"
    initial, rates, end = {}, {}, np.zeros(2)
    if draw(st.booleans()):
        arm = draw(st.floats(0.2, 0.6))
        builder.revolute("shoulder", on, add_rigid(builder, "arm", arm, draw)[0])
        initial["arm.theta"], rates["arm.theta"] = draw(ANGLES), draw(st.floats(-2, 2))
        on, end = "arm.end", arm * _direction(initial["arm.theta"])
    builder.beam(
        "rod",
        length=length,
        density=2700.0,
        area=side**2,
        second_moment=side**4 / 12,
        youngs_modulus=7e10,
        lateral={"ends": draw(st.sampled_from(["clamped-free", "pinned-pinned"])), "modes": draw(st.integers(1, 2))},
        damping_ratio=0.01,
    )
    builder.revolute("pivot", on, "rod.start").rigid("bead", mass=draw(st.floats(0.2, 2.0)), inertia=0.01)
    builder.slides_on("rail", "rod.start", "bead.center")
    spring = {"stiffness": draw(st.floats(300, 900)), "free_length": 0.45 * length, "damping": 1.0}
    builder.spring_damper("spring", "rod.start", "bead.center", **spring)
    angle = draw(ANGLES)
    place = end + 0.45 * length * _direction(angle)
    initial |= {"rod.theta": angle, "bead.x": float(place[0]), "bead.y": float(place[1])}
    rates["rod.theta"] = draw(st.sampled_from([-1, 1])) * draw(st.floats(2, 5))
    return builder.initial(initial).rates(rates).build()
