"""The scenes of the spatial hand-derived twins, set up from bodies and joints."""

from __future__ import annotations

from typing import Any

import numpy as np

from symgen.scene import Scene, SceneRecord
from tests.hand_derived.spatial import (
    twin_free_body,
    twin_free_flexible,
    twin_governor,
    twin_heavy_top,
    twin_spatial_double_pendulum,
    twin_spatial_hub_beam,
    twin_spatial_slider_crank,
)
from tests.hand_derived.spatial.twin_flexible_nodes import Nodes


def inertia(tensor: Any) -> dict[str, list[float]]:
    """Moments and products of an inertia tensor."""
    return {"inertia": np.diag(tensor), "products": [tensor[0, 1], tensor[0, 2], tensor[1, 2]]}


def marker(position: Any, axes: Any = None) -> dict[str, Any]:
    """A marker whose axes are the columns of a matrix."""
    turned = {} if axes is None else {"axis": axes[:, 2], "x_axis": axes[:, 0]}
    return {"position": position, **turned}


def flexible(nodes: Nodes) -> dict[str, Any]:
    """Shape integrals of lumped nodes."""
    m, x, phi = nodes.masses, nodes.positions, nodes.shapes
    return {
        "mass": float(m.sum()),
        "first_moment": m @ x,
        "inertia_moments": np.einsum("k,ki,kj->ij", m, x, x),
        "M_ff": np.einsum("k,kia,kib->ab", m, phi, phi),
        "K_ff": nodes.K_ff,
        "D_ff": nodes.D_ff,
        "phi_integral": np.einsum("k,kia->ia", m, phi),
        "rho_phi": np.einsum("k,ki,kja->aij", m, x, phi),
        "phi_phi": np.einsum("k,kia,kjb->abij", m, phi, phi),
    }


def free_body(p: twin_free_body.Params) -> SceneRecord:
    builder = Scene("free_body", space="spatial").gravity(*p.gravity)
    unit = np.eye(3)
    builder.rigid(
        "body",
        mass=p.mass,
        **inertia(p.inertia),
        center_of_mass=p.centre,
        orientation=p.sequence,
        free=True,
        markers={
            "point": marker(p.point),
            "about_x": {"axis": unit[0]},
            "about_y": {"axis": unit[1]},
            "about_z": {"axis": unit[2]},
        },
    )
    builder.force("pull", "body.point", *p.force)
    for axis, value in zip("xyz", p.moment, strict=True):
        builder.torque(f"turn_{axis}", f"body.about_{axis}", value)
    return builder.initial({"body.theta2": 0.7}).build()


def heavy_top(p: twin_heavy_top.Params) -> SceneRecord:
    builder = Scene("heavy_top", space="spatial").gravity(*p.gravity)
    builder.ground(markers={"pivot": marker(p.pivot)})
    builder.rigid("top", mass=p.mass, **inertia(p.inertia), center_of_mass=p.centre, orientation=p.sequence)
    builder.joint("spherical", "pivot", "ground.pivot", "top.origin")
    return builder.initial({"top.theta2": 0.7}).build()


def double_pendulum(p: twin_spatial_double_pendulum.Params) -> SceneRecord:
    builder = Scene("double", space="spatial").gravity(*p.gravity)
    builder.ground(markers={"a": marker(p.pivot1, p.A_1a)})
    builder.rigid(
        "one",
        mass=p.mass1,
        **inertia(p.inertia1),
        center_of_mass=p.centre1,
        markers={"b": marker(p.u_1b, p.B_1b), "a": marker(p.u_2a, p.B_2a)},
    )
    builder.rigid(
        "two", mass=p.mass2, **inertia(p.inertia2), center_of_mass=p.centre2, markers={"b": marker(p.u_2b, p.B_2b)}
    )
    builder.joint("revolute", "joint1", "ground.a", "one.b", damping=p.c1)
    builder.joint("revolute", "joint2", "one.a", "two.b", damping=p.c2)
    builder.rotational_spring_damper("spring1", "ground.a", "one.b", stiffness=p.k1)
    builder.rotational_spring_damper("spring2", "one.a", "two.b", stiffness=p.k2)
    return builder.build()


def governor(p: twin_governor.Params) -> SceneRecord:
    """The shaft turns about z; rods hang on hinges about the shaft's y, one along x and one along -x."""
    builder = Scene("governor", space="spatial").gravity(0, 0, -p.g)
    across = p.width**2 / 12
    shaft, rod = p.shaft_mass, p.rod_mass
    long = p.length**2 / 12 + across
    y, minus_y = [0, 1, 0], [0, -1, 0]
    builder.rigid(
        "shaft",
        mass=shaft,
        inertia=[shaft * long, shaft * long, shaft * 2 * across],
        center_of_mass=[0, 0, p.length / 2],
        markers={
            "right": {"position": [p.a, 0, p.height], "axis": y},
            "left": {"position": [-p.a, 0, p.height], "axis": minus_y, "x_axis": [-1, 0, 0]},
        },
    )
    cube = p.slider_mass * p.cube**2 / 6
    builder.rigid(
        "slider",
        mass=p.slider_mass,
        inertia=[cube, cube, cube],
        markers={"right": {"position": [p.b, 0, 0]}, "left": {"position": [-p.b, 0, 0]}},
    )
    total = rod + p.ball_mass
    centre = (rod * p.length / 2 + p.ball_mass * p.length) / total
    slender = rod * long + rod * (centre - p.length / 2) ** 2 + p.ball_mass * (p.length - centre) ** 2
    for name in ("rod1", "rod2"):
        builder.rigid(
            name,
            mass=total,
            inertia=[rod * 2 * across, slender, slender],
            center_of_mass=[centre, 0, 0],
            markers={"hinge": {"axis": y}, "middle": {"position": [p.length / 2, 0, 0]}},
        )
    builder.joint("revolute", "spin", "ground.origin", "shaft.origin")
    builder.joint("prismatic", "height", "shaft.origin", "slider.origin")
    builder.joint("revolute", "swing1", "shaft.right", "rod1.hinge")
    builder.joint("revolute", "swing2", "shaft.left", "rod2.hinge")
    for side, name in (("right", "rod1"), ("left", "rod2")):
        builder.spring_damper(
            f"spring_{side}", f"{name}.middle", f"slider.{side}", stiffness=p.k, damping=p.c, free_length=p.l0
        )
    builder.initial({"height.travel": 0.5, "swing1.angle": np.pi / 6, "swing2.angle": np.pi / 6})
    return builder.rates({"spin.angle": 2 * np.pi}).build()


def hub_beam(p: twin_spatial_hub_beam.Params) -> SceneRecord:
    builder = Scene("hub", space="spatial").gravity(*p.gravity)
    builder.ground(markers={"axle": marker(p.pivot, p.A_a)})
    builder.rigid(
        "hub",
        mass=p.hub_mass,
        **inertia(p.hub_inertia),
        center_of_mass=p.hub_centre,
        markers={"axle": marker([0, 0, 0], p.B_b), "clamp": marker(p.clamp, p.B_c)},
    )
    builder.flexible("beam", **flexible(p.beam))
    builder.joint("revolute", "axle", "ground.axle", "hub.axle", damping=p.damper)
    builder.joint("weld", "clamp", "hub.clamp", "beam.origin")
    builder.torque("motor", "hub.axle", p.torque)
    return builder.build()


def free_flexible(p: twin_free_flexible.Params, orientation: str) -> SceneRecord:
    builder = Scene("free_flexible", space="spatial").gravity(*p.gravity)
    builder.flexible(
        "body",
        **flexible(p.body),
        orientation=orientation,
        free=True,
        markers={"node": {"position": p.body.positions[p.loaded], "shape": p.body.shapes[p.loaded]}},
    )
    return builder.force("pull", "body.node", *p.force).build()


def slider_crank(p: twin_spatial_slider_crank.Params) -> SceneRecord:
    """The joints of crank, slider and rod along the tree; the spherical one closes the loop."""
    builder = Scene("spatial_slider_crank", space="spatial").gravity(*p.gravity)
    along = {"axis": [1, 0, 0], "x_axis": [0, 1, 0]}
    builder.ground(markers={"axle": {"position": [0, 0, p.z0], **along}, "guide": {"position": [0, p.y0, 0], **along}})
    builder.rigid(
        "crank",
        mass=p.crank_mass,
        **inertia(p.crank_inertia),
        center_of_mass=p.crank_centre,
        markers={"axle": along, "pin": {"position": [0, p.r, 0]}},
    )
    builder.rigid(
        "slider",
        mass=p.slider_mass,
        inertia=[0.01, 0.01, 0.01],
        markers={"guide": along, "fork": {"axis": [0, 0, 1], "x_axis": [0, 1, 0]}},
    )
    builder.rigid(
        "rod",
        mass=p.rod_mass,
        **inertia(p.rod_inertia),
        center_of_mass=p.rod_centre,
        markers={"fork": {"axis": [0, 0, 1], "x_axis": [0, -1, 0]}, "pin": {"position": [p.l, 0, 0]}},
    )
    builder.joint("revolute", "crank_axle", "ground.axle", "crank.axle")
    builder.joint("prismatic", "guide", "ground.guide", "slider.guide", damping=p.c)
    builder.joint("universal", "fork", "slider.fork", "rod.fork")
    builder.joint("spherical", "pin", "crank.pin", "rod.pin")
    builder.torque("motor", "crank.axle", p.torque).force("push", "slider.origin", p.force, 0, 0)
    x = float(np.sqrt(p.l**2 - (p.r - p.y0) ** 2 - p.z0**2))
    builder.initial(
        {"guide.travel": x, "crank_axle.angle": {"value": 0.0, "fixed": True}, "fork.angle1": -0.2, "fork.angle2": 0.2}
    )
    return builder.independent("crank_axle.angle").build()
