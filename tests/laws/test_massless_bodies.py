"""Bodies without mass and inertia: legal between joints that leave M_hat regular, else refused by name."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import reference_solution, simulate
from runtime.model import Model
from symgen import SceneError
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
CRANK, ROD = 0.2, 0.6


def slider_crank(mass: float) -> Scene:
    """A crank and a slider of 1 kg, joined by a rod of this mass."""
    scene = Scene("slider_crank").gravity(0, 0)
    scene.rigid("crank", mass=1.0, inertia=0.1, markers={"tip": {"position": (CRANK, 0)}})
    scene.rigid("rod", mass=mass, inertia=mass, center_of_mass=(0.3, 0), markers={"tip": {"position": (ROD, 0)}})
    scene.rigid("slider", mass=1.0, inertia=0.1).revolute("a", "ground.origin", "crank.origin")
    scene.revolute("b", "crank.tip", "rod.origin").revolute("c", "rod.tip", "slider.origin")
    scene.prismatic("d", "ground.origin", "slider.origin").initial({"crank.theta": 0.5}).rates({"crank.theta": 3.0})
    return scene


def slide(theta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Place of the slider of the crank's angle, and its derivative by the angle."""
    root = np.sqrt(ROD**2 - (CRANK * np.sin(theta)) ** 2)
    return CRANK * np.cos(theta) + root, -CRANK * np.sin(theta) * (1 + CRANK * np.cos(theta) / root)


def test_a_connecting_rod_without_mass(model_of: Build) -> None:
    """One coordinate: the energy (I + m (ds/dtheta)^2) theta'^2 / 2 is constant."""
    run = simulate(model_of(slider_crank(0.0).build()), scheme="dopri5", tolerance=1e-8, t_end=2.0)
    assert run.status.ok and np.ptp(run["crank.theta"]) > 4
    place, slope = slide(run["crank.theta"])
    np.testing.assert_allclose(run["slider.x"], place, atol=1e-9)
    energy = (0.1 + slope**2) * run.rate("crank.theta") ** 2 / 2
    np.testing.assert_allclose(energy, energy[0], rtol=1e-7)


def test_equations_in_all_coordinates_take_it(model_of: Build) -> None:
    """Multipliers and a singular M give the motion of the condensed equations."""
    model = model_of(slider_crank(0.0).build())
    run = simulate(model, scheme="dop853", dt=1e-3, t_end=0.5)
    exact = reference_solution(model, t_end=0.5, times=run.t)
    np.testing.assert_allclose(run.q, exact.q, atol=1e-9)


@pytest.mark.parametrize("coordinate", ["rod.theta", "only.theta"])
def test_what_has_no_inertia_at_all_is_refused(model_of: Build, coordinate: str) -> None:
    scene = Scene("loose").gravity(0, -9.81)
    scene.rigid("first", mass=1.0, inertia=0.1, markers={"tip": {"position": (CRANK, 0)}})
    scene.revolute("a", "ground.origin", "first.origin")
    name = coordinate.partition(".")[0]
    scene.rigid(name, mass=0.0, inertia=0.0, center_of_mass=(0.1, 0))
    scene.revolute("b", "first.tip" if name == "rod" else "ground.origin", f"{name}.origin")
    with pytest.raises(SceneError, match=f"{coordinate}.*no inertia"):
        model_of(scene.build())


def test_a_light_beam_is_found_and_one_without_mass_says_what_to_do(model_of: Build) -> None:
    """1 kg at the end of a strut that hangs as a pendulum: a strut of 1e-12 kg changes nothing; none is refused."""

    def strut(density: float) -> Scene:
        scene = Scene("strut").gravity(0, -9.81).initial({"strut.theta": -1.0})
        scene.beam(
            "strut",
            length=1.0,
            density=density,
            area=1e-6,
            second_moment=1e-9,
            youngs_modulus=7e10,
            lateral={"modes": 1},
        )
        scene.rigid("ball", mass=1.0, inertia=0.0)
        return scene.revolute("a", "ground.origin", "strut.start").weld("w", "strut.end", "ball.origin")

    run = simulate(model_of(strut(1e-6).build()), tolerance=1e-6, t_end=1.0)
    twin = Scene("twin").gravity(0, -9.81).initial({"ball.theta": -1.0})
    twin.rigid("ball", mass=1.0, inertia=0.0, center_of_mass=(1.0, 0)).revolute("a", "ground.origin", "ball.origin")
    exact = simulate(model_of(twin.build()), tolerance=1e-9, t_end=1.0)
    assert run.status.name == "completed" and run["strut.theta"][-1] == pytest.approx(exact["ball.theta"][-1], abs=1e-5)
    with pytest.raises(SceneError, match="density 0.0 must be positive; .*rigid body with mass = 0"):
        strut(0.0).build()


def test_a_mass_that_a_run_takes_away_ends_by_name(model_of: Build) -> None:
    """A parameter may be zero as well: where nothing is left that is inert, the run says so."""
    scene = Scene("light").gravity(0, -9.81).rigid("arm", mass=1.0, inertia=0.1, center_of_mass=(0.1, 0))
    model = model_of(scene.revolute("a", "ground.origin", "arm.origin").build())
    run = simulate(model, scheme="rk4", dt=1e-3, t_end=0.1, parameters={"arm.mass": 0.0, "arm.inertia": 0.0})
    assert run.status.name == "mass_not_positive"


@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_nothing_between_two_hinges_of_one_axis_has_no_inertia(space: str) -> None:
    """The hinges share what they turn: the massless body between them may take any angle."""
    spatial = space == "spatial"
    scene = Scene("between", space=space).gravity(*((0, 0, -9.81) if spatial else (0, -9.81)))
    scene.rigid("nothing", mass=0.0, inertia=(0, 0, 0) if spatial else 0.0)
    center = (0.5, 0, 0) if spatial else (0.5, 0)
    scene.rigid("rod", mass=1.0, inertia=(0.1, 0.1, 0.1) if spatial else 0.1, center_of_mass=center)
    scene.revolute("inner", "ground.origin", "nothing.origin").revolute("outer", "nothing.origin", "rod.origin")
    with pytest.raises(SceneError, match="has no inertia.*give the body an inertia"):
        scene.model()
