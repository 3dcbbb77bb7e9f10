"""URDF texts for tests."""

from __future__ import annotations

LINK = '<link name="{name}"><inertial><origin xyz="{at}" rpy="{rpy}"/><mass value="{mass}"/>{inertia}</inertial></link>'
JOINT = (
    '<joint name="{name}" type="{type}"><parent link="{parent}"/><child link="{child}"/>'
    '<origin xyz="{at}" rpy="{rpy}"/><axis xyz="{axis}"/>{more}</joint>'
)


def link(name: str, mass: float = 1.0, at: str = "0 0 0", rpy: str = "0 0 0", moments: str = "0.1 0.2 0.15") -> str:
    """A link with moments of inertia about its inertial frame's axes."""
    xx, yy, zz = moments.split()
    inertia = f'<inertia ixx="{xx}" iyy="{yy}" izz="{zz}" ixy="0" ixz="0" iyz="0"/>'
    return LINK.format(name=name, mass=mass, at=at, rpy=rpy, inertia=inertia)


def joint(
    name: str,
    type: str,
    parent: str,
    child: str,
    at: str = "0 0 0",
    rpy: str = "0 0 0",
    axis: str = "0 0 1",
    more: str = "",
) -> str:
    """A joint."""
    return JOINT.format(name=name, type=type, parent=parent, child=child, at=at, rpy=rpy, axis=axis, more=more)


def robot(*parts: str) -> str:
    """The file's text."""
    return f'<?xml version="1.0"?><robot name="test-robot">{"".join(parts)}</robot>'


PENDULUM = robot(
    '<link name="world"/>',
    link("rod", 2.0, at="0 0 -0.4", moments="0.3 0.35 0.1"),
    joint("pivot", "revolute", "world", "rod", at="0 0 1", axis="0 2 0",
          more='<limit lower="-1" effort="3" velocity="2"/>'
          '<dynamics damping="0.7" friction="0.1"/>'),
)  # fmt: skip
