"""What a step over a singular position may leave open, on a point that passes it: each limit from both sides.

The point moves as x = t (or as asked), and the determinant is a given function of time with its zero at t = 1.
"""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from runtime import Model, simulate
from runtime.running.singular.crossing import BranchLost, Crossing, TightIntegrator, cross
from runtime.running.singular.exchange import best_exchange
from runtime.running.singular.singularity_monitor import SingularityMonitor

pytestmark = pytest.mark.long

Course = Callable[[float], tuple[float, float]]


def straight(t: float) -> tuple[float, float]:
    """1 - t and its rate."""
    return 1.0 - t, -1.0


def cubic(t: float) -> tuple[float, float]:
    """A cubic with its zero at 1."""
    s = 1.0 - t
    return s + 4.0 * s * s * s, -1.0 - 12.0 * s * s


class Point:
    """Stands for a TightIntegrator: y = (x, x'), x'' = force(t); errors are put into what is observed behind it."""

    def __init__(
        self, course: Course = straight, force: Callable[[float], float] = lambda t: 0.0, **errors: float
    ) -> None:
        self.course, self.force, self.errors = course, force, errors
        self.loops = SimpleNamespace(determinants=lambda t, q, q_dot: self.determinants(t, q))

    def determinants(self, t: float, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        value, rate = self.course(t)
        return np.array([value]), np.array([rate])

    def time_left(self, t: float, y: np.ndarray, block: int) -> float:
        value, rate = self.course(t)
        return -value / rate if value * rate < 0 else np.inf

    def solved(self, t: float, y: np.ndarray, t_end: float) -> Any:
        return SimpleNamespace(y=np.array([[y[0] + (t_end - t) * y[1]], [y[1]]]))

    def until(
        self, t: float, y: np.ndarray, t_end: float, block: int, height: float, sign: int
    ) -> tuple[float, np.ndarray]:
        low, high = t, 1.0
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if self.course(middle)[0] > height else (low, middle)
        return low, self.solved(t, y, low).y[:, -1]

    def slope(self, t: float, y: np.ndarray) -> np.ndarray:
        return np.array([y[1], self.force(t)])

    def observed(self, t: np.ndarray, y: np.ndarray) -> Any:
        q, v, off = y[:, :1].copy(), y[:, 1:], self.errors
        q[1] += off.get("gap", 0.0)
        still, power = np.zeros(2), np.array([0.0, off.get("power", 0.0)])
        energy = {"kinetic": np.ones(2), "elastic": still, "power_applied": power}
        energy |= {"power_driven": still, "power_dissipated": still}
        return SimpleNamespace(
            t=t,
            q=q,
            q_dot=v,
            q_ddot=np.array([[self.force(one)] for one in t]),
            constraint_error=np.array([0.0, off.get("open", 0.0)]),
            energy=energy,
            energy_balance=lambda: np.array([0.0, off.get("energy", 0.0)]),
        )


def crossed(point: Point) -> Crossing:
    return cross(point, 0.0, np.array([0.0, 1.0]), 0, 1.0)  # type: ignore[arg-type]


@pytest.mark.parametrize("course", [straight, cubic])
def test_the_singular_time_lies_in_the_gap_between_the_nodes(course: Course) -> None:
    """In the middle between the nodes 1/3 and 0.6 of the step, however the determinant bends."""
    found = crossed(Point(course))
    assert found.t_s == pytest.approx(1.0, abs=1e-12)
    assert (found.t_s - found.t_near) / (found.t - found.t_near) == pytest.approx(7 / 15, rel=1e-6)
    assert course(found.t_near)[0] == pytest.approx(
        0.1, rel=1e-6
    )  # of the largest determinant: the first that is tried


def test_a_determinant_that_misleads_is_not_followed() -> None:
    """A root of order six: at its present rate the zero is a sixth of its way ahead, outside the gap of a step."""
    with pytest.raises(BranchLost, match="not where the determinant leads"):
        crossed(Point(lambda t: ((1.0 - t) ** 6, -6.0 * (1.0 - t) ** 5)))


# (what is off, refused, accepted): 1 J and 1 m/s; the step takes 3/14 s
LIMITS = [
    ("open", 1e-7, 1e-10),  # m: constraint error behind the step
    ("gap", 2e-5, 1e-7),  # m: q against the integral of q_dot
    ("energy", 1e-6, 1e-9),  # J, without power
]


@pytest.mark.parametrize("what, refused, accepted", LIMITS)
def test_what_a_step_may_leave_open(what: str, refused: float, accepted: float) -> None:
    assert crossed(Point(**{what: accepted})).t_s == pytest.approx(1.0)
    with pytest.raises(BranchLost):
        crossed(Point(**{what: refused}))


def test_a_change_of_power_excuses_a_little_energy() -> None:
    """A hundredth of the change of power over the step: of 1 W, 2 mJ for the longest step, 20 uJ for the shortest."""
    assert crossed(Point(power=1.0, energy=1e-5)).t_s == pytest.approx(1.0)
    with pytest.raises(BranchLost, match="energy changes"):
        crossed(Point(power=1.0, energy=1e-2))


def test_a_step_over_it_is_accurate() -> None:
    """A force with a ripple between the nodes: its error estimate is 1e-7 at 1e-4 N, and 1e-10 at 1e-7 N."""
    for size, fine in ((1e-7, True), (1e-4, False)):
        point = Point(force=lambda t, size=size: size * np.sin(4e4 * t))  # type: ignore[misc]
        if fine:
            assert crossed(point).t_s == pytest.approx(1.0)
        else:
            with pytest.raises(BranchLost, match="not accurate"):
                crossed(point)


def test_a_small_determinant_is_near_singular() -> None:
    """At 0.15 of the largest so far; then at 0.3 of that; given up, only at 3e-5; and where the sign changes."""
    monitor = SingularityMonitor.of(1)
    monitor.accept(np.ones(1), np.ones(1))

    def near_singular(share: float) -> bool:
        return monitor.near_singular(np.array([share]), np.ones(1))

    assert near_singular(0.14) and not near_singular(0.16) and monitor.near_singular(np.array([-0.5]), np.array([-0.5]))
    monitor.lower()
    assert near_singular(0.04) and not near_singular(0.05)
    monitor.give_up()
    assert near_singular(2e-5) and not near_singular(4e-5)
    monitor.passed()
    assert near_singular(0.14) and not near_singular(0.16) and not monitor.near_singular(-np.ones(1), -np.ones(1))


def test_a_loop_unknown_takes_the_place_that_it_nearly_deserves() -> None:
    """Of two lengths that gain 10 and 8 the second, a loop unknown, so that the first stays a closed form; not of 10
    and 4."""
    for gain, chosen in ((8.0, "loop"), (4.0, "closed")):
        entry = SimpleNamespace(turns=False)
        model: Any = SimpleNamespace(
            coordinates=["lead", "closed", "loop"],
            constraints=["first", "second"],
            q_i=["lead"],
            q_d=["closed", "loop"],
            loop_unknowns=["loop"],
            elastic=[],
            kept_rows=np.arange(2),
            places=SimpleNamespace(parameters=np.zeros((0, 4), dtype=int)),
            description=SimpleNamespace(
                coordinates=[entry] * 3, constraints=[SimpleNamespace(unit="m")] * 2, orientations=[]
            ),
        )
        found = best_exchange(model, np.zeros(3), np.array([[-10.0, 1.0, 0.0], [-gain, 0.0, 1.0]]))
        assert found is not None and (found.into, found.gain) == (chosen, 10.0 if chosen == "closed" else gain)
        assert found.apply(["lead", "other"]) == [chosen, "other"]


def test_ways_near_a_singular_position_are_followed_tightly(built_in: Callable[[str], Model]) -> None:
    """There and back again over 0.1 s of a free mechanism: to 1e-9 of the way."""
    model = built_in("slider_crank")
    p = model.parameter_vector()
    integrator = TightIntegrator(model, p, model.constants(p))
    y = integrator.pack(model.initial_q, model.initial_q_dot)
    there = integrator.solved(0.0, y, 0.1).y[:, -1]
    back = integrator.solved(0.1, there, 0.0).y[:, -1]
    assert np.abs(there - y).max() > 0.1 and np.abs(back - y).max() < 1e-9 * np.abs(there - y).max()


def test_a_motion_that_turns_before_a_singular_position_is_no_passage(built_in: Callable[[str], Model]) -> None:
    """Bars let go 0.025 rad from one line: a pendulum that turns as far from it on the other side; the determinant
    is a fortieth of its largest there. Who follows the motion to a tenth only takes it for one that passes.
    """
    start = {"upright0.theta": -0.025, "upright0.theta_dot": 0.0}
    run = simulate(built_in("n_four_bar"), initial=start, t_end=2.0, dt=1e-3)
    assert run.status.ok and {event.kind for event in run.events} <= {"assembled"}
    assert run["upright0.theta"].min() == pytest.approx(-np.pi + 0.025, abs=1e-4)
