"""The hard suite: scenes and starts by which a time-stepping scheme is judged, from smooth to very stiff."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from typing import Literal

from benchmarks.scenes.arm import arm
from benchmarks.scenes.spatial_arm import spatial_arm
from benchmarks.scenes.vehicle import vehicle
from symgen.scene import SceneRecord
from symgen.scenes.beams import hub_beam, spin_up_beam
from symgen.scenes.flexible_slider_crank import (
    flexible_slider_crank,
    flexible_slider_crank_free,
    flexible_slider_crank_torque,
    physical_slider_crank,
    stiff_slider_crank,
)
from symgen.scenes.linkages import flexible_four_bar, near_singular_slider_crank
from symgen.scenes.pendulums import chain, flexible_joint_arm, overdamped_joint, two_oscillators
from symgen.scenes.spatial import bricard, flyball_governor, spatial_chain, spatial_slider_crank

LINKS = 10


@dataclass(frozen=True)
class HardCase:
    """One case: a scene, how it starts, how long it runs and which coordinates are graded.

    graded: the rigid and lateral coordinates of q_i; axial ones are left out, so that a scheme may give up what is
    fast and small. start, parameters and initial are arguments of `runtime.running.simulate` and `reference_solution`.
    large: what factorises M_hat takes minutes to be made ready; benchmarks run it, and tests take a few steps only.
    """

    name: str
    make: Callable[[], SceneRecord]
    graded: tuple[str, ...]
    t_end: float
    why: str
    start: Literal["given", "quasi_static"] = "given"
    parameters: Mapping[str, float] = field(default_factory=dict)
    initial: Mapping[str, float] = field(default_factory=dict)
    large: bool = False


ROD = ("rod.q1", "rod.q2")
CRANK_AND_ROD = ("crank.theta", *ROD)
HUB = ("hub.theta", "beam.q1", "beam.q2", "beam.q3")
LINK_ANGLES = tuple(f"link{k}.theta" for k in range(1, LINKS + 1))
GOVERNOR = ("spin.angle", "height.travel", "right_swing.angle", "left_swing.angle")
IN_SPACE = tuple(f"link{k}.{name}" for k in (1, 2) for name in ("e1", "e2", "e3", "q1", "q2"))
LINK_MODES = tuple(f"link{k}.q{mode}" for k in range(1, LINKS + 1) for mode in (1, 2))


def _oscillators(ratio: int) -> HardCase:
    return HardCase(
        f"oscillators_{ratio}",
        two_oscillators,
        ("x_L",),
        10.0 if ratio < 10_000 else 4.0,
        f"frequency ratio {ratio} with strong inertia coupling and no damping; released from x_S = 0",
        parameters={"c": 0.5, "k_L": 1.0, "w": float(ratio), "zeta": 0.0},
        initial={"x_L": 1.0, "x_S": 0.0},
    )


def _arm(links: int) -> HardCase:
    return HardCase(
        f"arm_{links}",
        partial(arm, links, 3, 100.0, 0.5),
        tuple(f"link{k}.theta" for k in range(1, links + 1)),
        0.5,
        f"{links} links with a lively start and one stiff flexible link at the end: stiffness in one place",
        large=True,
    )


CASES: tuple[HardCase, ...] = (
    HardCase(
        "f1_smooth",
        flexible_slider_crank,
        ROD,
        0.1,
        "the published start, little axial vibration; the crank is prescribed, so every coordinate is elastic",
    ),
    HardCase(
        "f1_rigid",
        flexible_slider_crank,
        ROD,
        0.1,
        "starts undeformed and without elastic rates, so all modes vibrate, the axial ones included",
        initial={f"rod.q{k}{rate}": 0.0 for k in range(1, 5) for rate in ("", "_dot")},
    ),
    HardCase(
        "f1_physical",
        physical_slider_crank,
        ROD,
        0.1,
        "the physical axial mass makes the axial modes nearly three times as fast as the published ones",
        "quasi_static",
    ),
    HardCase(
        "slider_crank_free",
        flexible_slider_crank_free,
        CRANK_AND_ROD,
        0.05,
        "undamped, inertia coupling through the loop closure, all modes excited by the start",
    ),
    HardCase(
        "slider_crank_torque",
        flexible_slider_crank_torque,
        CRANK_AND_ROD,
        0.4,
        "runs up from rest to large bending; the torque is switched off at 0.15 s, a jump of the right-hand side",
    ),
    HardCase(
        "f2_heavy_hub",
        hub_beam,
        HUB,
        5.0,
        "strong inertia coupling, hub 10, beam 34 kg m^2: the lowest elastic frequency is twice the clamped one",
    ),
    HardCase(
        "f2_light_hub",
        hub_beam,
        HUB,
        5.0,
        "nearly no inertia of the hub against the beam: the lowest elastic frequency is 4.3 times the clamped one",
        parameters={"hub.inertia": 0.1},
    ),
    HardCase(
        "f3_spin_up",
        spin_up_beam,
        tuple(f"beam.q{k}" for k in range(1, 6)),
        20.0,
        "at 6 rad/s the beam stands by geometric stiffening, not by its clamped stiffness of 3.8 rad/s",
    ),
    HardCase(
        "four_bar",
        flexible_four_bar,
        ("crank.theta", "coupler.q1", "coupler.q2", "rocker.q1", "rocker.q2"),
        0.5,
        "two loop unknowns whose closure depends on four elastic coordinates through foreshortening",
        "quasi_static",
    ),
    HardCase(
        "chain",
        partial(chain, LINKS, 2),
        LINK_ANGLES + LINK_MODES,
        0.5,
        "30 coordinates in a tree, undamped, falling from a bent start",
        initial={name: -1.2 + 0.12 * k for k, name in enumerate(LINK_ANGLES)},
    ),
    HardCase(
        "overdamped",
        overdamped_joint,
        ("rod.theta", "finger.theta"),
        3.0,
        "a damper limits the explicit step; the slow part of the damped motion is as slow as the pendulum",
    ),
    *(_oscillators(ratio) for ratio in (10, 100, 1000, 10_000)),
    HardCase(
        "near_singular",
        near_singular_slider_crank,
        CRANK_AND_ROD,
        0.5,
        "sharp changes of inertia close to a change point, twice a revolution",
        "quasi_static",
    ),
    HardCase(
        "stiff_200",
        stiff_slider_crank,
        CRANK_AND_ROD,
        0.05,
        "axial modes 200 times as fast as the fastest graded one, nonlinear, undamped",
        "quasi_static",
    ),
    HardCase(
        "joint_arm",
        flexible_joint_arm,
        ("link1.theta", "link2.theta", "rotor1.theta", "rotor2.theta"),
        2.0,
        "stiff springs in the rows of the slow coordinates: coupling by stiffness, not by inertia",
    ),
    HardCase(
        "governor",
        flyball_governor,
        GOVERNOR,
        2.0,
        "in space; dampers give rates of 8100 and 1450 1/s, while the motion stays below 25 rad/s",
    ),
    HardCase(
        "spatial_chain",
        partial(spatial_chain, 2, 2),
        IN_SPACE,
        0.15,
        "two links in space on spherical joints, bending in two planes; a link's twist has hardly any inertia",
        initial={"link1.theta3_dot": 4.0, "link2.theta3_dot": -6.0},
    ),
    HardCase(
        "bricard",
        bricard,
        ("hinge0.angle",),
        1.0,
        "a spatial loop of six hinges with one constraint too many: one coordinate, four loop unknowns",
    ),
)
CASES += (
    *(_arm(links) for links in (10, 20, 40)),
    HardCase(
        "spatial_arm",
        partial(spatial_arm, 10, 2, 100.0),
        tuple(f"hinge{k}.angle" for k in range(1, LINKS + 1)),
        0.3,
        "ten links on hinges about two axes by turns, the last one flexible and stiff in both planes",
        large=True,
    ),
    HardCase(
        "spatial_loop",
        spatial_slider_crank,
        ("axle.angle", "rod.q1", "rod.q2"),
        0.2,
        "a loop in space with a flexible rod from finite elements, six modes from 1,800 to 27,000 rad/s",
        "quasi_static",
        large=True,
    ),
    HardCase(
        "vehicle",
        vehicle,
        tuple(f"{body}.{name}" for body in ("chassis", "cab") for name in ("z", "e1", "e2")),
        0.5,
        "32 coordinates: soft suspensions and tyres, and a cab on two bushings of 5e7 N/m",
        large=True,
    ),
)
HARD_SUITE: dict[str, HardCase] = {case.name: case for case in CASES}
