"""Beams that carry something at their ends: the rod of a fast slider-crank in pieces, and a right-angled frame."""

from __future__ import annotations

import math
from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

from runtime import modes, simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord

pytestmark = pytest.mark.long

Array = np.ndarray
Build = Callable[[SceneRecord], Model]
CRANK, ROD, HEIGHT, DEPTH = 0.15, 0.3, 0.006, 0.007
STEEL = {"density": 7870.0, "area": HEIGHT * DEPTH, "second_moment": DEPTH * HEIGHT**3 / 12, "youngs_modulus": 2e11}
EXACT = 3.155e-3  # m, geometrically exact elements; a pinned rod of three modes gives the same


def fast_slider_crank(pieces: int, shapes: int) -> SceneRecord:
    """Crank at 150 rad/s, running freely; the rod in welded pieces; its ends and its middle are measured."""
    builder = Scene("fast", title="Fast slider-crank")
    builder.rigid("crank", mass=0.36, inertia=0.01, markers={"tip": {"position": (CRANK, 0.0)}})
    independent = ["crank.theta"]
    for k in range(pieces):
        builder.beam(
            f"rod{k}", length=ROD / pieces, **STEEL, lateral={"modes": shapes}, stiffening=True,
            markers={"middle": {"at": 0.5}},
        )  # fmt: skip
        independent += [f"rod{k}.q{n + 1}" for n in range(shapes)]
        if k:
            builder.weld(f"weld{k}", f"rod{k - 1}.end", f"rod{k}.start")
    last, half = f"rod{pieces - 1}.end", f"rod{pieces // 2}.{'start' if pieces % 2 == 0 else 'middle'}"
    builder.rigid("slider", mass=STEEL["density"] * STEEL["area"] * ROD / 2, inertia=1e-5)
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod0.start")
    builder.prismatic("slide", "ground.origin", "slider.origin").revolute("C", last, "slider.origin")
    for name, marker in (("a", "rod0.start"), ("b", last), ("m", half)):
        builder.measure(f"{name}_x", "x", of=marker).measure(f"{name}_y", "y", of=marker)
    start = {"crank.theta": 0.0} | {f"rod{k}.theta": 0.0 for k in range(pieces)}
    return builder.independent(*independent).initial(start).rates({"crank.theta": 150.0}).build()


@pytest.mark.parametrize(("pieces", "shapes", "dt"), [(1, 3, 2e-5), (2, 2, 1e-5)])
def test_rod_of_a_fast_slider_crank(model_of: Build, pieces: int, shapes: int, dt: float) -> None:
    """Largest deflection of the middle from the chord on a 1 ms grid, to 0.2 %; two halves of two shapes each."""
    every = round(1e-3 / dt)
    run = simulate(model_of(fast_slider_crank(pieces, shapes)), scheme="rk4", dt=dt, t_end=0.05, seen_every=every * dt)
    a, b, m = (np.column_stack([run[f"{name}_x"], run[f"{name}_y"]]) for name in "abm")
    chord, arm = b - a, m - a
    off = (chord[:, 0] * arm[:, 1] - chord[:, 1] * arm[:, 0]) / np.hypot(*chord.T)
    assert run.status.name == "completed" and np.abs(off).max() == pytest.approx(EXACT, rel=2e-3)


def frame(shapes: int) -> SceneRecord:
    """Two arms at a right angle, 1 and 0.6 long, on an axis through the free end of the longer one."""
    unit = {"density": 1.0, "area": 1.0, "second_moment": 1.0, "youngs_modulus": 1.0, "stiffening": True}
    return (
        Scene("frame")
        .parameter("omega", 1.0, "rad/s", "speed")
        .beam("one", length=1.0, **unit, lateral={"modes": shapes},
              markers={"corner": {"at": 1.0, "angle": math.pi / 2}})
        .beam("two", length=0.6, **unit, lateral={"modes": shapes})
        .revolute("axis", "ground.origin", "one.start")
        .prescribed_angle("drive", "ground.origin", "one.start", motion="omega * t")
        .weld("corner", "one.corner", "two.start")
        .initial({"two.theta": math.pi / 2})
        .build()
    )  # fmt: skip


def exact_frame(n: int, speed: float) -> Array:
    """Frequencies of 2 n geometrically exact elements of two nodes (x, y, angle), lumped masses, turning with `speed`.

    Energy of an element EA/2 e^2 + GA/2 g^2 + EI/2 k^2 with strains in the middle, EA = GA = 1e6 EI / L^2 (nearly
    inextensible, no shear); equilibrium in the turning frame by Newton's method, then M x'' + 2 w G x' + K x = 0.
    """
    x = ca.SX.sym("x", 3 * (2 * n + 1))
    energy, mass, place = ca.SX(0), np.zeros(x.numel()), np.zeros((2 * n + 1, 3))
    for k in range(2 * n):
        h, base = (1.0 / n, 0.0) if k < n else (0.6 / n, math.pi / 2)
        a, b = x[3 * k : 3 * k + 3], x[3 * k + 3 : 3 * k + 6]
        angle, d = base + (a[2] + b[2]) / 2, (b[:2] - a[:2]) / h
        e = ca.cos(angle) * d[0] + ca.sin(angle) * d[1] - 1
        g = ca.cos(angle) * d[1] - ca.sin(angle) * d[0]
        energy += h / 2 * (1e6 * e**2 + 1e6 * g**2 + ((b[2] - a[2]) / h) ** 2)
        place[k + 1] = place[k] + [h * math.cos(base), h * math.sin(base), 0.0]
        mass[np.r_[3 * k : 3 * k + 2, 3 * k + 3 : 3 * k + 5]] += h / 2
    potential = energy - speed**2 / 2 * ca.dot(ca.SX(mass), x**2)
    slopes = ca.Function("slopes", [x], [ca.gradient(potential, x), ca.hessian(potential, x)[0]])
    q = place.ravel()
    for _ in range(12):
        force, K = (np.asarray(value) for value in slopes(q))
        q[3:] -= np.linalg.solve(K[3:, 3:], force.ravel()[3:])
    K, mass = np.asarray(slopes(q)[1])[3:, 3:], mass[3:]
    moves, turns = np.flatnonzero(mass), np.flatnonzero(mass == 0.0)
    K = K[np.ix_(moves, moves)] - K[np.ix_(moves, turns)] @ np.linalg.solve(
        K[np.ix_(turns, turns)], K[np.ix_(turns, moves)]
    )
    size = len(moves)
    coriolis = 2 * speed * np.kron(np.eye(size // 2), [[0.0, 1.0], [-1.0, 0.0]])
    system = np.block([[np.zeros((size, size)), np.eye(size)], [-K / mass[moves][:, None], coriolis]])
    return np.sort(np.abs(np.linalg.eigvals(system).imag))[::2][:3]


@pytest.mark.parametrize("speed", [0.0, 1.0])
def test_frequencies_of_a_right_angled_frame(model_of: Build, speed: float) -> None:
    """To 0.5 % with three shapes an arm, at rest and turning; with two, the first two frequencies.

    The reference converges with the square of the element: 10 and 20 an arm, extrapolated.
    """
    coarse, fine = exact_frame(10, speed), exact_frame(20, speed)
    exact = (4 * fine - coarse) / 3
    for shapes, count, worst in ((3, 3, 5e-3), (2, 2, 5e-3)):
        found = modes(model_of(frame(shapes)), parameters={"omega": speed}).frequencies[:count]
        np.testing.assert_allclose(found, exact[:count], rtol=worst)


def damped_pieces(count: int, **damping: float) -> SceneRecord:
    """A cantilever of 1 m welded of pieces."""
    builder, last = Scene("pieces"), "ground.origin"
    for k in range(count):
        ends = "welded-heavy" if k == count - 1 else "welded-welded"
        builder.beam(f"piece{k}", length=1.0 / count, **STEEL, lateral={"ends": ends, "modes": 3}, **damping)
        builder.weld(f"weld{k}", last, f"piece{k}.start")
        last = f"piece{k}.end"
    return builder.build()


def test_welded_pieces_have_the_damping_of_the_whole(model_of: Build) -> None:
    """With the ratio 0.05 at the whole's first frequency; the second mode has 6.267 times as much, as w / w_1 says.

    A ratio of 1 of each piece's own modes is no more than 0.03 of the whole's first.
    """
    own = modes(model_of(damped_pieces(5, damping_ratio=1.0)))
    assert own.damping_ratios[0] == pytest.approx(0.030, abs=1e-3)
    first = math.sqrt(2e11 * STEEL["second_moment"] / (STEEL["density"] * STEEL["area"])) * 1.8751041**2
    found = modes(model_of(damped_pieces(5, damping_ratio=0.05, damping_frequency=first)))
    assert found.damping_ratios[0] == pytest.approx(0.05, rel=2e-3)
    assert found.damping_ratios[1] == pytest.approx(0.05 * 6.26689, rel=2e-3)
