"""Generated flexible mechanisms equal their hand-derived twins: slider-crank (free and driven), hub with beam."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from runtime.model import Model
from symgen.modes.beam import exact_bending
from symgen.scene import Scene, SceneRecord
from tests.hand_derived import twin_driven_slider_crank, twin_flexible_slider_crank, twin_hub_beam
from tests.hand_derived import twin_rod_data as rod_data
from tests.hand_derived.generated_comparison import compare
from tests.hand_derived.twin_rod_tree import Params as RodParams

Build = Callable[[SceneRecord], Model]
TIMES = (0.0, 0.2, 0.37, 0.9)
SMALL, TIP = 1e-3, 3 * [5e-3]  # modal amplitudes [m]: of the pinned rod, of the one whose end moves


def slider_crank(p: RodParams, driven: bool) -> SceneRecord:
    rod, gravity = p.rod, np.asarray(p.gravity)
    builder = Scene("twin_flexible_slider_crank").gravity(*gravity)
    builder.rigid("crank", mass=p.m1, inertia=p.J1, center_of_mass=(p.a1, 0), markers={"tip": {"position": (p.l1, 0)}})
    builder.modal(
        "rod",
        mass=rod.mass,
        first_moment=rod.first_moment,
        inertia=rod.inertia,
        M_ff=rod.M_ff,
        K_ff=rod.K_ff,
        D_ff=rod.D_ff,
        phi_integral=rod.phi_integral,
        rho_dot_phi=rod.rho_dot_phi,
        rho_cross_phi=rod.rho_cross_phi,
        phi_cross_phi=rod.phi_cross_phi,
        markers={"end": {"position": (rod.length, 0), "shape_x": rod.shape_x, "shape_y": rod.shape_y}},
    )
    builder.rigid("slider", mass=p.m3, inertia=p.J3)
    builder.revolute("A", "ground.origin", "crank.origin")
    modes = [f"rod.q{k + 1}" for k in range(len(rod.K_ff))]
    if driven:
        builder.parameter("omega", p.Omega, "rad/s")
        builder.prescribed_angle("drive", "ground.origin", "crank.origin", motion="omega * t").independent(*modes)
    else:
        builder.torque("motor", "crank.origin", p.torque).independent("crank.theta", *modes)
    builder.revolute("B", "crank.tip", "rod.origin").prismatic("slide", "ground.origin", "slider.origin")
    builder.revolute("C", "rod.end", "slider.origin")
    return builder.initial({"crank.theta": 0.0, "rod.theta": 0.0}).build()


def general(seed: int = 0, nf: int = 3) -> RodParams:
    """Every integral non-zero, coupled weakly enough that the body's mass matrix is positive definite."""
    params = rod_data.general_params(seed, nf)
    rod = params.rod
    weaker = {name: 0.2 * getattr(rod, name) for name in ("phi_integral", "rho_dot_phi", "rho_cross_phi")}
    return replace(params, rod=replace(rod, **weaker))


WEIGHT = np.array([1.3, -9.81])
RODS: dict[str, tuple[RodParams, Any, Any]] = {
    "general": (general(), TIP, 3 * [1.0]),
    "f1": (rod_data.f1_params(gravity=WEIGHT), 4 * [SMALL], 4 * [1.0]),
    "two_pinned_modes": (
        RodParams(rod=rod_data.pinned_sine_rod(2, damping_ratio=0.02), gravity=WEIGHT, torque=0.4),
        2 * [SMALL],
        2 * [1.0],
    ),
}


@pytest.mark.every_push("f1")
@pytest.mark.parametrize("case", RODS)
def test_slider_crank_free(model_of: Build, case: str) -> None:
    params, scale, rate = RODS[case]
    compare(
        model_of(slider_crank(params, False)),
        twin_flexible_slider_crank,
        params,
        np.array([3.0, *scale]),
        np.array([20.0, *rate]),
        TIMES,
    )


@pytest.mark.every_push("general")
@pytest.mark.parametrize("case", RODS)
def test_slider_crank_driven(model_of: Build, case: str) -> None:
    params, scale, rate = RODS[case]
    compare(
        model_of(slider_crank(params, True)), twin_driven_slider_crank, params, np.array(scale), np.array(rate), TIMES
    )


LENGTH, DENSITY, AREA, SECOND, MODULUS = 8.0, 2766.7, 7.2968e-5, 8.2189e-9, 6.8952e10  # case F2
MODES, ZETA = 3, 0.01


def hub_params(stiffening: bool) -> twin_hub_beam.Params:
    """The twin with the generator's own shapes: masses at Gauss points, shapes, stiffness and foreshortening there."""
    modes = exact_bending("clamped-free", MODES)
    K_ff = MODULUS * SECOND / LENGTH**3 * modes.kappa
    M_ff = DENSITY * AREA * LENGTH * modes.mass
    return twin_hub_beam.Params(
        masses=DENSITY * AREA * LENGTH * modes.mu,
        positions=LENGTH * modes.xi,
        shapes=modes.phi,
        K_ff=K_ff,
        D_ff=np.diag(2 * ZETA * np.sqrt(np.diag(K_ff) * np.diag(M_ff))),
        foreshortening=np.array([modes.at(xi).eta for xi in modes.xi]) / LENGTH if stiffening else None,
        J_hub=10.0,
        m_hub=5.0,
        torque=lambda t: 10.0 * np.sin(np.pi * t),
        gravity=np.array([0.7, -9.81]),
    )


@pytest.mark.parametrize("stiffening", [False, True], ids=["linear", "stiffening"])
def test_hub_beam(model_of: Build, stiffening: bool) -> None:
    params = hub_params(stiffening)
    builder = Scene("twin_hub_beam").gravity(*params.gravity).rigid("hub", mass=5.0, inertia=10.0)
    builder.beam(
        "beam",
        length=LENGTH,
        density=DENSITY,
        area=AREA,
        second_moment=SECOND,
        youngs_modulus=MODULUS,
        lateral={"ends": "clamped-free", "modes": MODES},
        stiffening=stiffening,
        damping_ratio=ZETA,
    )
    builder.revolute("pivot", "ground.origin", "hub.origin").weld("clamp", "hub.origin", "beam.start")
    builder.torque("motor", "hub.origin", "10 * sin(pi * t)")
    scale, rate = np.array([3.0, 0.3, 0.3, 0.3]), np.ones(4)
    compare(model_of(builder.build()), twin_hub_beam, params, scale, rate, TIMES)


@pytest.mark.long
def test_random_rods(model_of: Build) -> None:
    """More rods with every integral non-zero: no accidental zero hides a term."""
    for seed in (1, 2):
        params = replace(general(seed, nf=2), torque=-1.1)
        model = model_of(slider_crank(params, False))
        scale, rate = np.array([3.0, 5e-3, 5e-3]), np.array([20.0, 1.0, 1.0])
        compare(model, twin_flexible_slider_crank, params, scale, rate, TIMES)
