"""The error of a model as `convergence` tells it against the true one, of outputs whose limit is known.

Limits are closed forms, series, the equation of the elastica, a Ritz solution in polynomials, or ten times as fine.
Outputs that a model has to rounding are left out: of them nothing is told, and nothing is wrong.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
import pytest
import skfem
from scipy.integrate import solve_bvp, solve_ivp
from scipy.linalg import eigh
from scipy.optimize import root

from runtime import Model
from symgen.fe import FlexibleBody, LineMesh, Material, Section
from symgen.scene import Scene

pytestmark = pytest.mark.long

MASS, EI, L = 0.5, 25.0, 1.0  # kg/m, N m^2, m
BEAM = {"density": 7850.0, "area": MASS / 7850.0, "second_moment": EI / 2.1e11, "youngs_modulus": 2.1e11}
UNIT = float(np.sqrt(EI / MASS / L**4))  # rad/s
LOAD = 1e-3  # N, N/m: small deflections
EXACT, FACTOR = 1e-6, 3.0  # of an output: what a model has; of the true error
Limits = Mapping[str, float | np.ndarray]


class Row(NamedTuple):
    """An output of a case; NaN where nothing is told."""

    case: str
    told: float
    true: float


def at_rest(case: str, scene: Scene, limits: Limits, size: float = 0.0, **asked: Any) -> Iterator[Row]:
    """size: of what deflects, where the limit is not that."""
    found = scene.model().convergence(list(limits), of="equilibrium", **asked)
    for name, limit in limits.items():
        one = found[name]
        if abs(one.value - limit) > EXACT * (size or abs(limit)):
            yield Row(f"{case}: {name}", one.error, abs(one.value - float(limit)))


def of_models(
    case: str, model: Model, of: Callable[[Model], dict[str, float]], limits: Limits, **asked: Any
) -> Iterator[Row]:
    found = model.convergence(of, **asked)
    for name, limit in limits.items():
        if abs(found[name].value - limit) > EXACT * abs(limit):
            yield Row(f"{case}: {name}", found[name].error, abs(found[name].value - float(limit)))


# ---- statics ------------------------------------------------------------------------------------------------------


def supported(n: int, ends: str, load: str) -> Scene:
    """A beam clamped at its start, or pinned at both ends, under a force at the tip or a load along it."""
    scene = Scene("supported").beam(
        "arm", length=L, **BEAM, lateral={"ends": ends, "modes": n}, markers={"middle": {"at": 0.5}}
    )
    if ends == "clamped-free":
        scene.weld("wall", "ground.origin", "arm.start").measure("tip", "y", of="arm.end")
        scene.measure("slope", "angle", of="arm.end").measure("moment", "bending_moment", of="arm.start")
    else:
        scene.ground(markers={"far": {"position": [L, 0.0]}}).revolute("pin", "ground.origin", "arm.start")
        scene.point_on_line("roller", "ground.far", "arm.end")
        scene.measure("slope", "angle", of="arm.end").measure("moment", "bending_moment", of="arm.middle")
    scene.measure("middle", "y", of="arm.middle")
    if load == "tip":
        return scene.force("load", "arm.end", 0.0, -LOAD)
    return scene.distributed("load", "arm", [0.0, -LOAD])


def statics() -> Iterator[Row]:
    tip = {"tip": -1 / 3, "slope": -1 / 2, "middle": -5 / 48}
    along = {"tip": -1 / 8, "slope": -1 / 6, "middle": -17 / 384}
    pinned = {"middle": -5 / 384, "slope": 1 / 24}
    for n in (1, 2, 3):
        for ends, load, shares, moment in (
            ("clamped-free", "tip", tip, -1.0), ("clamped-free", "along", along, -1 / 2),
            ("pinned-pinned", "along", pinned, 1 / 8),
        ):  # fmt: skip
            limits = {name: share * LOAD / EI for name, share in shares.items()} | {"moment": moment * LOAD}
            yield from at_rest(f"{ends}, {load}, {n} shapes", supported(n, ends, load), limits)


def elastica(load: float) -> Limits:
    """EI theta'' = -P cos(theta), theta(0) = theta'(L) = 0: where the tip is."""
    s = np.linspace(0.0, L, 201)

    def slopes(_: Any, y: np.ndarray) -> np.ndarray:
        return np.vstack([y[1], -load / EI * np.cos(y[0]), np.cos(y[0]), np.sin(y[0])])

    def ends(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.array([a[0], b[1], a[2], a[3]])

    found = solve_bvp(slopes, ends, s, np.vstack([0.3 * s, 0 * s, s, 0.1 * s]), tol=1e-10, max_nodes=100000)
    theta, _, x, y = found.sol(L)
    return {"x": x, "y": y, "angle": theta}


def pieces(count: int, load: float, **more: Any) -> Scene:
    scene, last = Scene("elastica"), "ground.origin"
    for k in range(count):
        scene.beam(f"piece{k}", length=L / count, **BEAM, lateral={"modes": 2}, **more)
        scene.weld(f"weld{k}", last, f"piece{k}.start")
        last = f"piece{k}.end"
    for kind in ("x", "y", "angle"):
        scene.measure(kind, kind, of=last)
    return scene.force("load", last, 0.0, load)


def elasticas() -> Iterator[Row]:
    for share in (0.5, 1.0):
        limits = elastica(share * EI)
        for count in (2, 4, 8):
            yield from at_rest(f"elastica {share}, {count} pieces", pieces(count, share * EI), limits)
        yield from at_rest(f"elastica {share}, one beam", pieces(1, share * EI), limits)
        yield from at_rest(f"elastica {share}, one beam, stiffening", pieces(1, share * EI, stiffening=True), limits)


def frames() -> Iterator[Row]:
    """A post of 0.6 m on an arm of 1 m under a load w along the post: w a^4 / 8 EI + w a^3 L / 2 EI at its top."""
    a = 0.6
    for n in (2, 3):
        scene = Scene("frame").beam(
            "arm",
            length=L,
            **BEAM,
            lateral={"modes": n, "ends": "clamped-free"},
            markers={"corner": {"at": 1.0, "angle": np.pi / 2}},
        )
        scene.beam("post", length=a, **BEAM, lateral={"modes": n, "ends": "clamped-free"}).initial(
            {"post.theta": np.pi / 2}
        )
        scene.weld("wall", "ground.origin", "arm.start").weld("joint", "arm.corner", "post.start")
        scene.distributed("wind", "post", [LOAD, 0.0]).distributed("weight", "arm", [0.0, -LOAD])
        scene.measure("top", "x", of="post.end").measure("slope", "angle", of="post.end").measure(
            "corner", "y", of="arm.end"
        )
        turned = -(a**2 / 2 * L + L**3 / 6) * LOAD / EI
        limits = {"top": L + LOAD * a**4 / 8 / EI - a * turned, "slope": np.pi / 2 + turned - LOAD * a**3 / 6 / EI}
        limits["corner"] = -(a**2 / 4 * L**2 + L**4 / 8) * LOAD / EI
        yield from at_rest(f"frame, {n} shapes", scene, limits, size=LOAD / EI)


def in_space() -> Iterator[Row]:
    """A clamped beam under loads along it in both planes: w L^4 / 8 EI each."""
    for n in (1, 2):
        shapes = {"ends": "clamped-free", "modes": n}
        more = {"second_moment_z": 2 * EI / 2.1e11, "lateral_z": shapes, "lateral": shapes}
        scene = Scene("space", space="spatial").beam("arm", length=L, **BEAM, **more)
        scene.weld("wall", "ground.origin", "arm.start").distributed("load", "arm", [0.0, -LOAD, -LOAD])
        scene.measure("y", "y", of="arm.end").measure("z", "z", of="arm.end")
        yield from at_rest(f"in space, {n} shapes", scene, {"y": -LOAD / 8 / EI, "z": -LOAD / 16 / EI})


def follower(load: float) -> Limits:
    """A cantilever under a force P that stays across its tip: EI phi'' = -P cos(phi), phi to the tangent of the tip.

    The initial-value problem has no unknown: phi = phi' = 0 at the tip; the root turns the picture.
    """

    def slopes(_: float, y: np.ndarray) -> np.ndarray:
        return np.array([y[1], -load / EI * np.cos(y[0]), np.cos(y[0]), np.sin(y[0])])

    phi, _, x, y = solve_ivp(slopes, (0.0, L), np.zeros(4), rtol=1e-11, atol=1e-13).y[:, -1]
    turn = np.array([[np.cos(phi), np.sin(phi)], [-np.sin(phi), np.cos(phi)]]) @ [x, y]  # in the axes of the root
    return {"x": turn[0], "y": turn[1], "angle": -phi}


def followers() -> Iterator[Row]:
    """The force of a tip's own axes: a column of pieces, which modes alone do not see."""
    for share in (0.5, 1.5):
        limits = follower(share * EI)
        for count in (4, 8):
            scene = pieces(count, 0.0)
            scene.force("along", f"piece{count - 1}.end", 0.0, share * EI, frame="body")
            yield from at_rest(f"follower {share}, {count} pieces", scene, limits)


PRINCETON = {
    "length": 0.508,
    "height": 12.377e-3,
    "thick": 3.2024e-3,
    "E": 71.7e9,
    "nu": 0.31,
}  # Dowell and Traybar 1975


def princeton_stiffness() -> np.ndarray:
    """GJ (of a thin rectangle, by its series), EI of bending out of the thin side and out of the high one [N m^2]."""
    h, b, E = PRINCETON["height"], PRINCETON["thick"], PRINCETON["E"]
    odd = np.arange(1, 40, 2)
    J = h * b**3 / 3 * (1 - 192 / np.pi**5 * b / h * np.sum(np.tanh(odd * np.pi * h / (2 * b)) / odd**5))
    return np.array([E / 2 / (1 + PRINCETON["nu"]) * J, E * b**3 * h / 12, E * b * h**3 / 12])


def kirchhoff(load: np.ndarray) -> Limits:
    """The tip of a clamped Kirchhoff rod along x under a dead force: m' = F x t, R' = R skew(D^-1 R^T m), m(L) = 0."""
    stiff, length = princeton_stiffness(), PRINCETON["length"]

    def slopes(_: float, y: np.ndarray) -> np.ndarray:
        R, m = y[3:12].reshape(3, 3), y[12:]
        k = (R.T @ m) / stiff
        skew = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
        return np.concatenate([R[:, 0], (R @ skew).ravel(), np.cross(load, R[:, 0])])

    def tip(m: np.ndarray) -> np.ndarray:
        start = np.concatenate([np.zeros(3), np.eye(3).ravel(), m])
        found: np.ndarray = solve_ivp(slopes, (0.0, length), start, rtol=1e-10, atol=1e-13).y[:, -1]
        return found

    guess = np.cross([length, 0.0, 0.0], load)
    end = tip(root(lambda m: tip(m)[12:], guess, tol=1e-12).x)
    return dict(zip("xyz", end[:3], strict=True))


def princeton(count: int, load: np.ndarray) -> Scene:
    GJ, out, high = princeton_stiffness()
    E, area = PRINCETON["E"], PRINCETON["height"] * PRINCETON["thick"]
    scene, last = Scene("princeton", space="spatial"), "ground.origin"
    sets = {key: {"modes": n} for key, n in (("lateral", 2), ("lateral_z", 2), ("torsion", 1))}
    for k in range(count):
        scene.beam(
            f"piece{k}", length=PRINCETON["length"] / count, density=2800.0, area=area, youngs_modulus=E,
            second_moment=high / E, second_moment_z=out / E, shear_modulus=E / 2.62, torsion_constant=GJ * 2.62 / E,
            **sets,
        )  # fmt: skip
        scene.weld(f"weld{k}", last, f"piece{k}.start")
        last = f"piece{k}.end"
    for kind in "xyz":
        scene.measure(kind, kind, of=last)
    return scene.force("weight", last, *load.tolist())


def princetons() -> Iterator[Row]:
    """The Princeton beam: a weight of 8.9 N at 45 degrees to the high side of the section."""
    load = 8.896 * np.sqrt(0.5) * np.array([0.0, -1.0, -1.0])
    yield from at_rest("Princeton beam, 4 pieces", princeton(4, load), kirchhoff(load))


# ---- frequencies --------------------------------------------------------------------------------------------------


def first_two(model: Model) -> dict[str, float]:
    found = model.modes(model.equilibrium(at_time=0.0)).frequencies
    return {"first": float(found[0]), "second": float(found[1])}


def spinning(n: int, speed: float, stiffening: bool = True) -> Scene:
    lateral = {"ends": "clamped-free", "modes": n}
    scene = Scene("spinning").beam("arm", length=L, **BEAM, lateral=lateral, stiffening=stiffening)
    return scene.prescribed_angle("drive", "ground.origin", "arm.start", motion=f"{speed!r} * t").revolute(
        "axis", "ground.origin", "arm.start"
    )


def ritz(speed: float) -> Limits:
    """EI w'''' - (T w')' = m (lambda^2 + speed^2) w, T = m speed^2 (L^2 - x^2) / 2, by x^2 times polynomials of x."""
    x, weights = np.polynomial.legendre.leggauss(40)
    x, weights = (x + 1) / 2, weights / 2
    basis = [
        np.polynomial.Polynomial([0, 0, 1])
        * np.polynomial.Legendre.basis(k, [0, 1]).convert(kind=np.polynomial.Polynomial)
        for k in range(12)
    ]
    w, w1, w2 = (np.column_stack([one.deriv(order)(x) if order else one(x) for one in basis]) for order in (0, 1, 2))
    T = MASS * speed**2 * (1 - x**2) / 2
    K = EI * w2.T @ (weights[:, None] * w2) + w1.T @ ((weights * T)[:, None] * w1)
    M = MASS * w.T @ (weights[:, None] * w)
    found = np.sqrt(eigh(K - speed**2 * M, M, eigvals_only=True)[:2])
    return {"first": found[0], "second": found[1]}


def spins() -> Iterator[Row]:
    for speed in (2 * UNIT, 6 * UNIT):
        for n in (2, 3):
            yield from of_models(
                f"spinning {speed:.3g}, {n} shapes", spinning(n, speed).model(), first_two, ritz(speed)
            )
        soft = spinning(3, speed, stiffening=False).model() if speed < 3 * UNIT else None
        if soft is not None:
            yield from of_models(f"spinning {speed:.3g}, no stiffening", soft, first_two, ritz(speed))


def lumped() -> Iterator[Row]:
    limits = {"first": 1.8751040687**2 * UNIT, "second": 4.6940911330**2 * UNIT}
    for elements in (4, 8, 16):
        lateral = {"ends": "clamped-free", "modes": 2}
        scene = Scene("mesh").beam("arm", length=L, **BEAM, lateral=lateral, mesh="lumped", elements=elements)
        model = scene.weld("wall", "ground.origin", "arm.start").model()
        yield from of_models(f"lumped mesh, {elements} elements", model, first_two, limits)


def bar(cells: int) -> Model:
    """A bar of square section, clamped at the top, by solid elements without lateral contraction."""
    mesh = skfem.MeshHex.init_tensor(np.linspace(0, L, cells + 1), np.linspace(0, 0.02, 2), np.linspace(0, 0.02, 2))
    ends = {"top": lambda at: at[:, 0] < 1e-9, "bottom": lambda at: at[:, 0] > L - 1e-9}
    body = FlexibleBody.from_mesh(
        mesh, Material(E=2e11, nu=0.0, rho=8000.0), order=1, modes=12, mode_set="mixed", fixed=["top"], origin="top",
        interface=ends,
    )  # fmt: skip
    scene = Scene("bar", space="spatial").flexible("rod", **body.fields()).weld("wall", "ground.origin", "rod.top")
    return scene.model()


def reduced(modes: int) -> Model:
    """A rod of 1 m by 160 elements of beams, reduced by Craig and Bampton."""
    nodes = [(k / 160, 0.0, 0.0) for k in range(161)]
    mesh = LineMesh(nodes, [(k, k + 1) for k in range(160)], Section.rectangle(0.02, 0.01))
    ends = {"pin": [0], "slot": [160]}
    body = FlexibleBody.from_mesh(mesh, Material(E=2e11, nu=0.3, rho=8000.0), modes=modes, mode_set="fixed_interface",
                                  interface=ends)  # fmt: skip
    scene = Scene("reduced", space="spatial").flexible("rod", **body.fields())
    return scene.weld("wall", "ground.origin", "rod.pin").model()


def four(model: Model) -> dict[str, float]:
    found = model.modes(model.equilibrium()).frequencies
    return {f"mode {k}": float(found[k]) for k in range(4)}


def craig_bamptons() -> Iterator[Row]:
    """Against the rod that is hardly reduced, 36 modes of each set of matrices, held at one end."""
    limits = four(reduced(36))
    for modes in (4, 8):  # of two, and two more, none moves out of the plane of the lowest: not told
        yield from of_models(f"Craig-Bampton, {modes} modes", reduced(modes), four, limits,
                             finer={"rod.modes": reduced(2 * modes)})  # fmt: skip


def stretching(model: Model) -> dict[str, float]:
    """The frequency near that of stretching."""
    found = model.modes(model.equilibrium()).frequencies
    return {"stretching": float(found[np.argmin(np.abs(found - np.pi / 2 * 5000.0))])}


def meshes() -> Iterator[Row]:
    """c / 4 L of stretching, c = sqrt(E / rho) = 5000 m/s."""
    for cells in (6, 12):
        limits = {"stretching": np.pi / 2 * 5000.0 / L}
        yield from of_models(
            f"FE bar, {cells} cells", bar(cells), stretching, limits, coarser={"rod.mesh": bar(cells // 2)}
        )


# ---- motions ------------------------------------------------------------------------------------------------------


def crossing(n: int, speed: float) -> Scene:
    """A force of 1 N that goes over a beam on two supports."""
    scene = Scene("bridge").beam(
        "deck", length=L, **BEAM, lateral={"ends": "pinned-pinned", "modes": n},
        markers={"middle": {"at": 0.5}, "quarter": {"at": 0.25}},
    )  # fmt: skip
    scene.ground(markers={"far": {"position": [L, 0.0]}}).revolute("pin", "ground.origin", "deck.start")
    scene.point_on_line("roller", "ground.far", "deck.end")
    scene.moving_force("wheel", "deck", place=f"{speed!r} * t", components=[0.0, -1.0])
    scene.measure("middle", "y", of="deck.middle").measure("quarter", "y", of="deck.quarter")
    return scene.measure("moment", "bending_moment", of="deck.middle")


def series(speed: float, t: np.ndarray) -> Limits:
    """400 terms of the sum over the modes of a beam on two supports."""
    k = np.arange(1, 401)[:, None]
    w, drive = (k * np.pi) ** 2 * UNIT, k * np.pi * speed
    q = -2 / MASS * (np.sin(drive * t) - drive / w * np.sin(w * t)) / (w**2 - drive**2)
    sines = {name: np.sin(k * np.pi * at) for name, at in (("middle", 0.5), ("quarter", 0.25))}
    found = {name: (q * sine).sum(axis=0) for name, sine in sines.items()}
    return found | {"moment": (-EI * (k * np.pi) ** 2 * q * sines["middle"]).sum(axis=0)}


def moved(case: str, scene: Scene, t_end: float, limits: Callable[[np.ndarray], Limits], **asked: Any) -> Iterator[Row]:
    """RMS over the motion, and of the largest magnitude."""
    model = scene.model()
    run = model.simulate(scheme="auto", tolerance=1e-6, t_end=t_end, samples=400)
    known = limits(run.t)
    found = model.convergence({name: ["motion", "peak"] for name in known}, t_end=t_end, **asked)
    for name, limit in known.items():
        size = float(np.sqrt(np.mean(limit**2)))
        true = float(np.sqrt(np.mean((run[name] - limit) ** 2)))
        if true > 1e-5 * size:
            yield Row(f"{case}: {name}", found[name].error, true)
        peak = abs(float(np.abs(run[name]).max() - np.abs(limit).max()))
        if peak > 1e-5 * size:
            yield Row(f"{case}: {name} peak", found[f"{name} peak"].error, peak)


def crossings() -> Iterator[Row]:
    speed = 1.0
    for n in (1, 2, 3):
        yield from moved(
            f"moving load, {n} shapes", crossing(n, speed), 0.999 / speed, lambda t: series(speed, t), knobs=["modes"]
        )


def slider_crank(n: int, count: int = 1) -> Scene:
    """A crank at constant speed, a rod of beams, a slider."""
    scene = Scene("crank").rigid("crank", mass=0.2, inertia=1e-3, markers={"tip": {"position": (0.1, 0.0)}})
    last = "crank.tip"
    for k in range(count):
        scene.beam(
            f"rod{k}",
            length=0.4 / count,
            **BEAM,
            lateral={"modes": n},
            stiffening=True,
            markers={"middle": {"at": 0.5}},
        )
        scene.joint("revolute" if k == 0 else "weld", f"B{k}", last, f"rod{k}.start")
        last = f"rod{k}.end"
    middle = f"rod{count // 2}.{'middle' if count % 2 else 'start'}"
    scene.rigid("slider", mass=0.2, inertia=1e-4).prismatic("slide", "ground.origin", "slider.origin")
    scene.revolute("C", last, "slider.origin").revolute("A", "ground.origin", "crank.origin")
    scene.prescribed_angle("drive", "ground.origin", "crank.origin", motion="60 * t")
    scene.measure("mx", "x", of=middle).measure("my", "y", of=middle).measure("sx", "x", of="slider.origin")
    return scene.initial({f"rod{k}.theta": 0.0 for k in range(count)})


def cranks() -> Iterator[Row]:
    fine = slider_crank(3, 4).model().simulate(scheme="auto", tolerance=1e-7, t_end=0.1, samples=400)
    limits = {name: fine[name] for name in ("mx", "my", "sx")}
    for n in (1, 2):
        yield from moved(f"slider-crank, {n} shapes", slider_crank(n), 0.1, lambda t: limits)


def spin_up(n: int, count: int = 1) -> Scene:
    """A beam that is brought to speed in half a second, on an axis at its start."""
    scene, last = Scene("spin_up"), "ground.origin"
    for k in range(count):
        ends = {"ends": "clamped-free"} if count == 1 else {}
        scene.beam(f"arm{k}", length=L / count, **BEAM, lateral={"modes": n, **ends}, stiffening=True)
        if k:
            scene.weld(f"weld{k}", last, f"arm{k}.start")
        last = f"arm{k}.end"
    scene.prescribed_angle("drive", "ground.origin", "arm0.start", motion="10 * t**2")
    scene.revolute("axis", "ground.origin", "arm0.start")
    return (
        scene.measure("x", "x", of=last)
        .measure("y", "y", of=last)
        .initial({f"arm{k}.theta": 0.0 for k in range(count)})
    )


def spin_ups() -> Iterator[Row]:
    fine = spin_up(3, 6).model().simulate(scheme="auto", tolerance=1e-7, t_end=0.5, samples=400)
    limits = {name: fine[name] for name in ("x", "y")}
    for n in (1, 2):
        yield from moved(f"spin-up, {n} shapes", spin_up(n), 0.5, lambda t: limits)


def four_bar(n: int, count: int = 1) -> Scene:
    """A crank at constant speed, a stiff rocker, a coupler of beams between them."""
    scene = Scene("four_bar").ground(markers={"far": {"position": (0.5, 0.0)}})
    scene.rigid("crank", mass=0.2, inertia=1e-3, markers={"tip": {"position": (0.1, 0.0)}})
    scene.rigid("rocker", mass=0.4, inertia=1e-2, markers={"tip": {"position": (0.0, 0.4)}})
    scene.initial({"rocker.theta": 0.0, "crank.theta": 0.0})
    last, angle = "crank.tip", np.pi / 4
    for k in range(count):
        scene.beam(f"coupler{k}", length=0.4 * np.sqrt(2) / count, **BEAM, lateral={"modes": n}, stiffening=True,
                   markers={"middle": {"at": 0.5}})  # fmt: skip
        scene.joint("weld" if k else "revolute", f"B{k}", last, f"coupler{k}.start")
        scene.initial({f"coupler{k}.theta": float(angle)})
        last = f"coupler{k}.end"
    middle = f"coupler{count // 2}.{'middle' if count % 2 else 'start'}"
    scene.revolute("C", last, "rocker.tip").revolute("D", "ground.far", "rocker.origin")
    scene.revolute("A", "ground.origin", "crank.origin")
    scene.prescribed_angle("drive", "ground.origin", "crank.origin", motion="60 * t")
    scene.measure("mx", "x", of=middle).measure("my", "y", of=middle)
    return scene.measure("rocker", "angle", of="rocker.origin")


def four_bars() -> Iterator[Row]:
    fine = four_bar(3, 4).model().simulate(scheme="auto", tolerance=1e-7, t_end=0.1, samples=400)
    limits = {name: fine[name] for name in ("mx", "my", "rocker")}
    for n in (1, 2):
        yield from moved(f"four-bar, {n} shapes", four_bar(n), 0.1, lambda t: limits)


CASES = [
    statics,
    elasticas,
    followers,
    princetons,
    four_bars,
    craig_bamptons,
    frames,
    in_space,
    spins,
    lumped,
    meshes,
    crossings,
    cranks,
    spin_ups,
]


@pytest.fixture(scope="module")
def rows() -> dict[str, list[Row]]:
    return {case.__name__: list(case()) for case in CASES}


def test_modelling_errors_are_told_within_a_factor_of_three(rows: dict[str, list[Row]]) -> None:
    every = [row for one in rows.values() for row in one]
    ratios = np.array([row.told / row.true for row in every])
    held = (ratios >= 1 / FACTOR) & (ratios <= FACTOR)
    print(f"{held.sum()} of {len(every)} within a factor {FACTOR:g}; median told / true {np.nanmedian(ratios):.3g}")
    for row, ratio in zip(every, ratios, strict=True):
        if not 1 / FACTOR <= ratio <= FACTOR:
            print(f"  {row.case}: {ratio:.3g}")
    assert len(every) >= 60 and held.mean() >= 0.95


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.__name__)
def test_something_is_told_of_every_output(rows: dict[str, list[Row]], case: Callable[[], Iterator[Row]]) -> None:
    assert rows[case.__name__] and all(np.isfinite(row.told) for row in rows[case.__name__])
