"""Loads along beams, forces and masses that move over them: static formulas, modal solutions by hand, laws."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import equilibrium, simulate
from symgen.generate import model_of
from symgen.scene import Scene, SceneError

SPACES = ("planar", "spatial")
L, RHO_A, EI = 2.0, 10.0, 100.0


def beam(space: str, modes: int, ends: str, **more: Any) -> Scene:
    """A beam with E I = 100 N m^2 and 10 kg/m, 2 m long, and in space the same across."""
    builder = Scene("beam", space=space)
    across = {} if space == "planar" else {"second_moment_z": 1e-4, "lateral_z": {"modes": modes, "ends": ends}}
    section = {"density": 1000.0, "area": 1e-2, "second_moment": 1e-4, "youngs_modulus": 1e6, **across}
    lateral = {"lateral": {"modes": modes, "ends": ends}}
    along = {} if space == "planar" else {"axis": [1.0, 0.0, 0.0], "x_axis": [0.0, 1.0, 0.0]}
    markers = {"mid": {"at": 0.5}, "tip": {"at": 1.0, **along}}
    return builder.beam("rod", length=L, **section, **lateral, markers=markers, **more)


def vector(space: str, x: object, y: object) -> list[object]:
    return [x, y] if space == "planar" else [x, y, 0.0]


def tip(builder: Scene) -> float:
    """Deflection of the tip at rest."""
    builder.weld("root", "ground.origin", "rod.start").measure("tip", "y", "rod.end")
    found = equilibrium(model_of(builder.build()))
    return float(simulate(found.model, t_end=1e-6, dt=1e-6, scheme="rk4", initial=found)["tip"][0])


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", SPACES)
@pytest.mark.parametrize(
    ("load", "part", "exact"),
    [
        ("-2", (0.0, 1.0), 2 * L**4 / (8 * EI)),
        ("-2*s/2", (0.0, 1.0), 11 * 2 * L**4 / (120 * EI)),
        ("-2", (0.0, 0.5), 2 * L * 1.0**3 / (6 * EI) - 2 * 1.0**4 / (24 * EI)),
        ("-2*exp(s)*0 - 2*cosh(s)/cosh(s)", (0.0, 1.0), 2 * L**4 / (8 * EI)),
    ],
)
def test_a_cantilever_under_a_distributed_load(space: str, load: str, part: tuple[float, float], exact: float) -> None:
    """Formulas, with the two cubics of a loaded end: uniform, growing from the root, half, by points."""
    builder = beam(space, 2, "welded-welded")
    builder.distributed("snow", "rod", vector(space, 0.0, load), start=part[0], end=part[1])
    assert tip(builder) == pytest.approx(-exact, rel=1e-10)


HELD = {  # under 1 N/m: ends, modes, joint of the end, deflection over L^4 / E I and moment over L^2 at x = u L
    "cantilever": ("clamped-free", 2, "", lambda u: u**2 * (6 - 4 * u + u**2) / 24, lambda u: (1 - u) ** 2 / 2),
    "hinged": (
        "pinned-pinned",
        1,
        "point_on_line",
        lambda u: u * (1 - 2 * u**2 + u**3) / 24,
        lambda u: u * (u - 1) / 2,
    ),
    "propped": (
        *("welded-pinned", 2, "point_on_line"),
        lambda u: u**2 * (3 - 5 * u + 2 * u**2) / 48,
        lambda u: 1 / 8 - 5 * u / 8 + u**2 / 2,
    ),
    "guided": (
        *("welded-welded", 3, "prismatic"),
        lambda u: u**2 * (1 - u) ** 2 / 24,
        lambda u: 1 / 12 - u / 2 + u**2 / 2,
    ),
}


@pytest.mark.every_push("propped-planar", "hinged-spatial")
@pytest.mark.parametrize("space", SPACES)
@pytest.mark.parametrize("kind", HELD)
def test_static_deflections_and_moments_are_exact_with_any_shapes(kind: str, space: str) -> None:
    """A uniform load on beams that are clamped, hinged, propped, guided: formulas, with shapes that lack the load."""
    ends, modes, joint, bent, moment = HELD[kind]
    builder, line = (
        beam(space, modes, ends),
        {} if space == "planar" else {"axis": [1.0, 0.0, 0.0], "x_axis": [0.0, 1.0, 0.0]},
    )
    builder.ground(markers={"far": {"position": vector(space, L, 0.0), **line}})
    builder.joint("revolute" if kind == "hinged" else "weld", "root", "ground.origin", "rod.start")
    if joint:
        builder.joint(joint, "guide", "ground.far", "rod.tip")
    p = 1e-4
    builder.distributed("snow", "rod", vector(space, 0.0, -p))
    found = equilibrium(model_of(builder.build()))
    run = simulate(found.model, t_end=1e-6, dt=1e-6, scheme="rk4", initial=found)
    u = np.array([0.1, 0.5, 0.8, 1.0])
    sag = run.deflections("rod", at=u)
    assert -sag.y[0] == pytest.approx(p * L**4 / EI * bent(u), abs=1e-10 * p * L**4 / EI)
    assert np.abs(sag.z).max() < 1e-10 * p * L**4 / EI
    assert -run.section_forces("rod", at=u).moment[0] == pytest.approx(p * L**2 * moment(u), abs=1e-10 * p * L**2)
    shapes = run.deflections("rod", at=u, way="modes").y[0]
    assert np.abs(shapes - sag.y[0]).max() > 5e-4 * np.abs(sag.y).max()  # what the shapes lack


def test_deflections_across_are_exact_under_forces_at_places() -> None:
    """A force at 0.8 m of a cantilever by its place, one at a marker, along z: x^2 (3 a - x) / 6 E I before a."""
    builder = beam("spatial", 2, "clamped-free").weld("root", "ground.origin", "rod.start")
    builder.moving_force("wheel", "rod", "0.8 + 0*t", [0.0, 0.0, -1e-4]).force("push", "rod.mid", 0.0, 0.0, -1e-4)
    found = equilibrium(model_of(builder.build()))
    run = simulate(found.model, t_end=1e-6, dt=1e-6, scheme="rk4", initial=found)
    x = np.array([0.4, 0.9, 1.4, 2.0])
    exact = sum(1e-4 * np.where(x < a, x**2 * (3 * a - x), a**2 * (3 * x - a)) / (6 * EI) for a in (0.8, 1.0))
    assert -run.deflections("rod", at=x / L).z[0] == pytest.approx(exact, rel=1e-10)


@pytest.mark.long
@pytest.mark.parametrize(("frame", "share"), [("world", np.cos(0.6)), ("body", 1.0)])
def test_loads_have_fixed_directions_or_follow(frame: str, share: float) -> None:
    """On a cantilever that stands at 0.6 rad: a fixed direction bends it by its part across, others by all."""
    builder = beam("planar", 2, "clamped-free").ground(markers={"root": {"angle": 0.6}})
    builder.weld("root", "ground.root", "rod.start").distributed("wind", "rod", [0.0, -1e-6], frame=frame)
    found = equilibrium(model_of(builder.build()))
    run = simulate(found.model, t_end=1e-6, dt=1e-6, scheme="rk4", initial=found)
    assert run.deflections("rod", at=1.0).y[0, 0] == pytest.approx(-share * 1e-6 * L**4 / (8 * EI), rel=1e-8)


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", SPACES)
def test_section_forces_have_the_load_on_the_part_beyond(space: str) -> None:
    """p = -(2 + 3 s)/10^4 from 0.5 m to 2 m on a cantilever: shear and moment by integration, at any section."""
    builder = beam(space, 3, "welded-welded").weld("root", "ground.origin", "rod.start")
    builder.distributed("snow", "rod", vector(space, 0.0, "1e-4*(-2 - 3*s)"), start=0.25)
    found = equilibrium(model_of(builder.build()))
    run = simulate(found.model, t_end=1e-6, dt=1e-6, scheme="rk4", initial=found)
    at = np.array([0.0, 0.1, 0.25, 0.4, 0.7, 1.0])
    x, low = at * L, np.maximum(at * L, 0.5)
    force = 1e-4 * (-2 * (L - low) - 1.5 * (L**2 - low**2))
    first = 1e-4 * (-(L**2 - low**2) - (L**3 - low**3))
    forces = run.section_forces("rod", at=at)
    assert forces.shear[0] == pytest.approx(force, abs=1e-13)
    assert forces.moment[0] == pytest.approx(first - x * force, abs=1e-13)


@pytest.mark.long
def test_section_axes_turn_with_the_section() -> None:
    """A pressure of 1 N/m does what a vertical load does to first order, and pushes the tip back to second."""
    along = {}
    for frame in ("world", "body", "section"):
        builder = beam("planar", 3, "clamped-free", axial={"modes": 1, "ends": "fixed-free"})
        builder.distributed("wind", "rod", [0.0, -1.0], frame=frame).weld("root", "ground.origin", "rod.start")
        found = equilibrium(model_of(builder.build()))
        along[frame] = (found.q[model_of(builder.build()).coordinates.index("rod.q1")], found.q[-1])
    assert along["section"][0] == pytest.approx(along["world"][0], rel=1e-3)
    assert along["world"] == pytest.approx(along["body"], rel=1e-12)
    # int p w' phi dx / (E A kappa) by the first stretching shape sin(pi x / 2 L): pushed towards -w'
    assert along["section"][1] != 0.0 and abs(along["world"][1]) < 1e-15


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", SPACES)
def test_the_weight_of_a_swinging_beam_is_a_distributed_load(space: str) -> None:
    """Gravity against the same as a load, while the beam turns and bends: the same motion, and the power adds up."""
    runs = []
    for kind in ("gravity", "load"):
        builder = beam(space, 2, "pinned-free", stiffening=True).revolute("pin", "ground.origin", "rod.start")
        if kind == "gravity":
            builder.gravity(*vector(space, 0.0, -9.81))
        else:
            builder.distributed("weight", "rod", vector(space, 0.0, "-9.81*10*(1 + 0*t)"))
        runs.append(simulate(model_of(builder.build()), t_end=0.5, dt=1e-3, scheme="rk4"))
    name = "rod.theta" if space == "planar" else "pin.angle"
    assert runs[1][name] == pytest.approx(runs[0][name], abs=1e-11)
    assert runs[1]["rod.q2"] == pytest.approx(runs[0]["rod.q2"], abs=1e-11)
    assert np.abs(runs[1].balance.error).max() < 1e-6 * runs[1].energy["kinetic"].max()


def pinned(space: str, modes: int) -> Scene:
    """Between a hinge and a bearing that slides along x; the mark "along" has its line along x."""
    line = {} if space == "planar" else {"axis": [1.0, 0.0, 0.0]}
    far, along = ({"position": vector(space, x, 0.0), **line} for x in (L, 0.0))
    builder = beam(space, modes, "pinned-pinned").ground(markers={"far": far, "along": along})
    builder.revolute("left", "ground.origin", "rod.start").point_on_line("right", "ground.far", "rod.end")
    return builder.measure("mid", "y", "rod.mid")


@pytest.mark.long
def test_a_force_moves_over_a_beam() -> None:
    """Modes by hand: q_k'' + w_k^2 q_k = (2 P / m L) sin(k pi v t / L), then free once the force has left."""
    modes, P, v = 5, 50.0, 0.5 * np.pi / L * (EI / RHO_A) ** 0.5
    builder = pinned("planar", modes).moving_force("wheel", "rod", f"{v!r}*t", [0.0, -P])
    run = simulate(model_of(builder.build()), t_end=1.4 * L / v, dt=L / v / 1200, scheme="dopri5")
    w = (np.arange(1, modes + 1) * np.pi / L) ** 2 * np.sqrt(EI / RHO_A)
    force, W = 2 * P / (RHO_A * L), np.arange(1, modes + 1) * np.pi * v / L
    k = np.arange(1, modes + 1)

    def on(t: np.ndarray) -> np.ndarray:
        return force / (w**2 - W**2) * (np.sin(np.outer(t, W)) - W / w * np.sin(np.outer(t, w)))

    off = L / v
    left, rate = on(np.array([off]))[0], force / (w**2 - W**2) * W * (np.cos(W * off) - np.cos(w * off))
    late = (run.t - off)[:, None]
    q = np.where(late < 0, on(run.t), left * np.cos(w * late) + rate / w * np.sin(w * late))
    exact = -(q * np.sin(k * np.pi / 2)).sum(axis=1)
    assert np.abs(run["mid"] - exact).max() < 1e-9 * np.abs(exact).max()
    assert run.view() is not None  # a load at no marker has no arrow
    assert np.abs(run.balance.error).max() < 1e-4 * run.energy["elastic"].max()


@pytest.mark.long
def test_the_static_rest_under_a_moving_force_is_the_published_deflection() -> None:
    """Five modes: the middle over P L^3 / 48 E I at places v t / L, alpha = 1/2, and at alpha = 1 at the end."""
    published = {0.5: {0.25: 0.2644641941, 0.5: 1.3288777963, 0.6665: 1.70544468, 0.75: 1.5746103802}}
    published[1.0] = {1.0: 1.5480736528}
    off = {"equilibrium": 0.0, "modes": 0.0}
    for alpha, values in published.items():
        v = alpha * np.pi / L * (EI / RHO_A) ** 0.5
        builder = pinned("planar", 5).moving_force("wheel", "rod", f"{v!r}*t", [0.0, -1.0])
        run = simulate(model_of(builder.build()), t_end=L / v, dt=L / v / 2000, scheme="rk4")
        at = [int(np.abs(run.t - place * L / v).argmin()) for place in values]
        assert run.t[at] * v / L == pytest.approx(list(values), abs=1e-12)
        for way in off:
            middle = -run.deflections("rod", at=0.5, way=way).y[at, 0] * 48 * EI / L**3
            off[way] = max(off[way], np.abs(middle - list(values.values())).max())
    assert off["equilibrium"] < 6e-5 < 5e-4 < off["modes"]


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", SPACES)
@pytest.mark.parametrize("place", [0.3, 0.5])
def test_what_slides_on_a_beam_presses_where_it_is(space: str, place: float) -> None:
    """A trolley stands on a girder of one mode: moments a b P / L, and the deflection of a beam on two hinges."""
    builder, P, a = pinned(space, 1).gravity(*vector(space, 0.0, -1e-4)), 5.0 * 1e-4, place * L
    builder.rigid("trolley", mass=5.0, inertia=1.0 if space == "planar" else [1.0, 1.0, 1.0])
    builder.slides_on("rail", "rod.start", "trolley.center")
    builder.prescribed_displacement("drive", "ground.along", "trolley.center", f"{a!r} + 0*t")
    builder.initial({"trolley.x": a})
    found = equilibrium(model_of(builder.build()))
    run = simulate(found.model, t_end=1e-6, dt=1e-6, scheme="rk4", initial=found)
    u, weight = np.array([0.1, 0.2, 0.4, 0.9]), RHO_A * 1e-4
    x, b = u * L, L - a
    moment = P * np.where(x < a, b * x, a * (L - x)) / L + weight * x * (L - x) / 2
    near, far = b * x * (L**2 - b**2 - x**2), a * (L - x) * (L**2 - a**2 - (L - x) ** 2)
    sag = P * np.where(x < a, near, far) / (6 * L * EI) + weight * x * (L**3 - 2 * L * x**2 + x**3) / (24 * EI)
    assert run.section_forces("rod", at=u).moment[0] == pytest.approx(moment, rel=1e-6)
    assert -run.deflections("rod", at=u).y[0] == pytest.approx(sag, rel=1e-6)


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", SPACES)
def test_a_mass_moves_over_a_beam(space: str) -> None:
    """M_ff + m phi phi^T with the drift of phi(s(t)): a mass of half the modal one at half the critical speed."""
    modes, m, v = 3, 0.5 * RHO_A * L / 2, 0.5 * np.pi / L * (EI / RHO_A) ** 0.5
    builder = pinned(space, modes).gravity(*vector(space, 0.0, -1e-3))
    builder.rigid("trolley", mass=m, inertia=1.0 if space == "planar" else [1.0, 1.0, 1.0])
    builder.slides_on("rail", "rod.start", "trolley.center").measure("travel", "x", "trolley.center")
    builder.prescribed_displacement("drive", "ground.along", "trolley.center", f"{v!r}*t")
    run = simulate(model_of(builder.build()), t_end=0.9 * L / v, dt=L / v / 2000, scheme="rk4")
    k = np.arange(1, modes + 1)

    def rates(t: float, z: np.ndarray) -> np.ndarray:
        q, p, b = z[:modes], z[modes:], k * np.pi / L
        phi, d1, d2 = np.sin(b * v * t), b * np.cos(b * v * t), -(b**2) * np.sin(b * v * t)
        M = RHO_A * L / 2 * np.eye(modes) + m * np.outer(phi, phi)
        weight = -1e-3 * RHO_A * L * np.where(k % 2, 2 / (np.pi * k), 0.0)
        load = phi * m * (-1e-3 - 2 * v * d1 @ p - v**2 * d2 @ q) + weight
        return np.concatenate([p, np.linalg.solve(M, load - EI * L / 2 * b**4 * q)])

    exact = solve_ivp(rates, (0, run.t[-1]), np.zeros(2 * modes), "DOP853", t_eval=run.t, rtol=1e-11, atol=1e-14).y
    mid = (exact[:modes].T * np.sin(k * np.pi / 2)).sum(axis=1)
    assert np.abs(run["mid"] - mid).max() < 1e-7 * np.abs(mid).max()


def test_a_crane_is_its_twin() -> None:
    """A trolley runs over a girder of three modes, a load swings from it: Newton's equations by hand for q and theta.

    y = phi(x) q of the trolley at x(t), N = m (y'' + g) + M (y'' + g + l (sin(theta) theta'' + cos(theta) theta'^2)),
    rho A L / 2 q'' + k q = weight - phi N, l theta'' + cos(theta) x'' + sin(theta) (y'' + g) = 0.
    """
    modes, m, M, rope, g = 3, 5.0, 8.0, 0.7, 1.0
    builder = pinned("planar", modes).gravity(0.0, -g).rigid("trolley", mass=m, inertia=1.0)
    builder.rigid("load", mass=M, inertia=0.0, center_of_mass=(0.0, -rope))
    builder.slides_on("wheels", "rod.start", "trolley.origin").revolute("rope", "trolley.origin", "load.origin")
    builder.prescribed_angle("upright", "ground.along", "trolley.origin", "0")
    builder.prescribed_displacement("drive", "ground.along", "trolley.origin", "0.5 + 0.4*t + 0.1*sin(3*t)")
    builder.initial({"trolley.x": 0.5})
    run = simulate(model_of(builder.build()), t_end=1.5, dt=1e-3, scheme="rk4")
    b = np.arange(1, modes + 1) * np.pi / L
    weight = -g * RHO_A * L * np.where(np.arange(1, modes + 1) % 2, 2 / (b * L), 0.0)

    def rates(t: float, z: np.ndarray) -> np.ndarray:
        q, p, theta, w = z[:modes], z[modes : 2 * modes], z[-2], z[-1]
        x, v, a = 0.5 + 0.4 * t + 0.1 * np.sin(3 * t), 0.4 + 0.3 * np.cos(3 * t), -0.9 * np.sin(3 * t)
        phi, d1, d2 = np.sin(b * x), b * np.cos(b * x), -(b**2) * np.sin(b * x)
        s, c = np.sin(theta), np.cos(theta)
        known = 2 * v * d1 @ p + v**2 * d2 @ q + a * d1 @ q + g  # y'' + g = phi q'' + known
        A = np.zeros((modes + 1, modes + 1))
        A[:-1, :-1] = RHO_A * L / 2 * np.eye(modes) + (m + M) * np.outer(phi, phi)
        A[:-1, -1], A[-1, :-1], A[-1, -1] = M * rope * s * phi, s * phi, rope
        held = (m + M) * known + M * rope * c * w**2
        force = np.append(weight - EI * L / 2 * b**4 * q - phi * held, -c * a - s * known)
        found = np.linalg.solve(A, force)
        return np.concatenate([p, found[:-1], [w, found[-1]]])

    exact = solve_ivp(rates, (0, 1.5), np.zeros(2 * modes + 2), "DOP853", t_eval=run.t, rtol=1e-11, atol=1e-13).y
    for k in range(modes):
        assert np.abs(run[f"rod.q{k + 1}"] - exact[k]).max() < 1e-8
    assert np.abs(run["load.theta"] - exact[-2]).max() < 1e-8 < np.ptp(exact[-2])


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", SPACES)
def test_a_bead_on_a_beam_that_flies_keeps_energy_and_momenta(space: str) -> None:
    """Free beam, free bead: nothing acts from outside, however the beam turns and bends."""
    builder = beam(space, 3, "free-free", free=True)
    builder.rigid("bead", mass=3.0, inertia=0.2 if space == "planar" else [0.2, 0.3, 0.4])
    builder.slides_on("rail", "rod.start", "bead.center")
    spin = {"rod.theta": 2.0} if space == "planar" else {"rod.omega_z": 2.0, "rod.omega_y": -0.7}
    builder.initial({"bead.x": 0.6}).rates({**spin, "rod.q1": 0.3, "rod.y": 0.4, "bead.x": 0.9})
    run = simulate(model_of(builder.build()), t_end=0.5, dt=2e-4, scheme="rk4")
    total = run.energy["kinetic"] + run.energy["elastic"]
    assert np.abs(total - total[0]).max() < 1e-9 * total[0]
    assert np.ptp(run["bead.x"]) > 0.1


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", SPACES)
def test_what_leaves_a_beam_is_not_completed(space: str) -> None:
    """A bead at 1 m/s from 1.5 m: it is at the end after half a second."""
    builder = beam(space, 2, "clamped-free").weld("root", "ground.origin", "rod.start")
    builder.rigid("bead", mass=1e-6, inertia=1.0 if space == "planar" else [1.0, 1.0, 1.0])
    builder.slides_on("rail", "rod.start", "bead.center").initial({"bead.x": 1.5}).rates({"bead.x": 1.0})
    run = simulate(model_of(builder.build()), t_end=0.7, dt=1e-3, scheme="rk4")
    assert run.status.name == "off_the_beam" and run.status.coordinate == "rail"
    assert run.status.time == pytest.approx(0.5, abs=2e-3)
    assert "along rod, which is 2 m long" in run.status.cause
    assert simulate(run.model, t_end=0.4, dt=1e-3, scheme="rk4").status.name == "completed"


@pytest.mark.parametrize(
    ("add", "said"),
    [
        (lambda b: b.distributed("d", "rood", [0.0, 1.0]), "there is no body 'rood'"),
        (lambda b: b.distributed("d", "rod", [0.0, 1.0], start=0.5, end=1.5), "1.5 is outside the beam"),
        (lambda b: b.distributed("d", "rod", [0.0, 1.0], start=0.5, end=0.2), "is not beyond start"),
        (lambda b: b.distributed("d", "rod", [0.0, 1.0, 0.0]), "3 components"),
        (lambda b: b.moving_force("d", "ball", "t", [0.0, 1.0]), "is not a beam"),
        (lambda b: b.moving_force("d", "rod", 5.0, [0.0, 1.0]), "'d'.place: is off 'rod', which is 2 m long"),
        (lambda b: b.slides_on("d", "ball.origin", "rod.start"), "is not a beam"),
    ],
)
def test_bad_loads_on_beams_are_refused_by_name(add, said: str) -> None:  # type: ignore[no-untyped-def]
    builder = beam("planar", 2, "clamped-free").weld("root", "ground.origin", "rod.start")
    with pytest.raises(SceneError, match=said):
        add(builder.rigid("ball", mass=1.0, inertia=1.0, free=True)).build()
