"""Gears, belts, racks, differentials and rotors of motors against hand-derived motions, in the plane and in space."""

from __future__ import annotations

import numpy as np
import pytest

from runtime import Solution, simulate
from runtime.views.film import film
from runtime.views.viewer.record import view_record
from symgen.generate import model_of
from symgen.scene import Scene, SceneError, SceneRecord, s_curve

J_A, J_B = 0.0302378293, 0.4838052687  # kg m^2, published case of a gear of ratio 10
SPACES = ("planar", "spatial")


def shafts(space: str, *inertias: float) -> Scene:
    """Shafts a, b, ... on hinges h_a, h_b, ... to the ground."""
    builder = Scene("shafts", space=space)
    places = {
        f"m{k}": {"position": [float(k), 0.0, 0.0][: 2 if space == "planar" else 3]} for k in range(len(inertias))
    }
    builder.ground(markers=places)
    for k, inertia in enumerate(inertias):
        name = "abcd"[k]
        builder.rigid(name, mass=1.0, inertia=inertia if space == "planar" else [1.0, 1.0, inertia])
        builder.revolute(f"h_{name}", f"ground.m{k}", f"{name}.origin")
    return builder


def turned(run: Solution, shaft: str) -> np.ndarray:
    return run[f"{shaft}.theta" if f"{shaft}.theta" in run.model.coordinates else f"h_{shaft}.angle"]


@pytest.mark.every_push("planar-a", "spatial-b")
@pytest.mark.parametrize("chosen", ["", "a", "b"])
@pytest.mark.parametrize("space", SPACES)
def test_a_gear_over_a_hundred_turns(space: str, chosen: str) -> None:
    """Torque 2 sin 2 pi t + 0.05 on a: phi_b = n integral integral of it / (n^2 J_a + J_b)."""
    builder = shafts(space, J_A, J_B).gear("mesh", "h_a.angle", "h_b.angle", 10.0)
    builder.torque("drive", "a.origin", "2*sin(2*pi*t) + 0.5")
    if chosen:
        builder.independent(f"{chosen}.theta" if space == "planar" else f"h_{chosen}.angle")
    run = simulate(model_of(builder.build()), t_end=10.0, dt=0.01, scheme="dopri5")
    w, t = 2 * np.pi, run.t
    impulse = 2 * (t / w - np.sin(w * t) / w**2) + 0.25 * t**2
    exact = 10.0 * impulse / (100.0 * J_A + J_B)
    assert 10 * exact[-1] / w > 100.0
    assert np.abs(turned(run, "b") / exact[-1] - exact / exact[-1]).max() < 1e-11
    assert np.abs(turned(run, "a") - 10 * turned(run, "b")).max() < 1e-13 * 10 * exact[-1]
    # torque on wheel a by the mesh: J_a phi_a'' - drive
    torque = J_A * 10 * 10 * (2 * np.sin(w * t) + 0.5) / (100 * J_A + J_B) - 2 * np.sin(w * t) - 0.5
    assert run.joint_force("mesh")[:, -1] == pytest.approx(torque, abs=1e-11)
    assert np.abs(run.balance.error).max() < 1e-7 * run.balance.work.max()


@pytest.mark.parametrize("space", SPACES)
def test_a_belt_and_a_crossed_belt(space: str) -> None:
    for crossed in (False, True):
        builder = shafts(space, 0.1, 0.4).belt("belt", "h_a.angle", "h_b.angle", 0.05, 0.2, crossed=crossed)
        run = simulate(model_of(builder.torque("drive", "b.origin", 3.0).build()), t_end=1.0, dt=0.01, scheme="rk4")
        ratio = -4.0 if crossed else 4.0
        exact = 0.5 * 3.0 / (0.4 + 16 * 0.1) * run.t**2
        assert turned(run, "b") == pytest.approx(exact, abs=1e-12)
        assert turned(run, "a") == pytest.approx(ratio * exact, abs=1e-12)


@pytest.mark.parametrize("space", SPACES)
def test_a_differential_shares_the_torque_equally(space: str) -> None:
    """Lagrange's equations by hand, with the input angle = 3 (a + b) / 2 eliminated."""
    builder = shafts(space, 0.02, 0.3, 0.5)
    builder.differential("axle", "h_a.angle", "h_b.angle", "h_c.angle", ratio=3.0)
    builder.torque("engine", "a.origin", "1 + t").torque("brake", "c.origin", -0.4)
    run = simulate(model_of(builder.build()), t_end=2.0, dt=0.02, scheme="dopri5")
    share = 2.25 * 0.02
    M = np.array([[0.3 + share, share], [share, 0.5 + share]])
    force = 1.5 * np.array([[1.0, 1.0], [1.0, 1.0]]), np.array([0.0, -0.4])
    start, slope = np.linalg.solve(M, force[0][0] + force[1]), np.linalg.solve(M, force[0][1])
    exact = np.outer(run.t**2 / 2, start) + np.outer(run.t**3 / 6, slope)
    assert np.stack([turned(run, "b"), turned(run, "c")], axis=1) == pytest.approx(exact, abs=1e-11)
    assert turned(run, "a") == pytest.approx(1.5 * exact.sum(axis=1), abs=1e-11)


@pytest.mark.parametrize("space", SPACES)
def test_a_rack_and_its_pinion(space: str) -> None:
    """A rack that falls and turns a pinion: (m + J/r^2) a = m g, with any phase at the start."""
    flat = space == "planar"
    down = {"angle": -np.pi / 2} if flat else {"axis": [0.0, -1.0, 0.0]}
    builder = Scene("rack", space=space).gravity(0.0, -9.81)
    builder.ground(markers={"guide": {"position": [0.1, 0.0] if flat else [0.1, 0.0, 0.0], **down}})
    builder.rigid("rack", mass=2.0, inertia=0.1 if flat else [0.1] * 3, markers={"along": down})
    builder.rigid("wheel", mass=1.0, inertia=0.05 if flat else [0.1, 0.1, 0.05])
    builder.prismatic("slide", "ground.guide", "rack.along").revolute("hinge", "ground.origin", "wheel.origin")
    builder.rack("teeth", "slide.travel", "hinge.angle", 0.1)
    builder.initial({"wheel.theta" if flat else "hinge.angle": 0.7})
    builder.measure("drop", "y", "rack.origin")
    run = simulate(model_of(builder.build()), t_end=1.0, dt=0.01, scheme="rk4")
    fall = 0.5 * 2.0 * 9.81 / (2.0 + 0.05 / 0.01) * run.t**2
    assert run["drop"] == pytest.approx(-fall, abs=1e-11)
    assert run["wheel.theta" if flat else "hinge.angle"] == pytest.approx(0.7 + fall / 0.1, abs=1e-10)


def test_a_planet_rolls_about_a_fixed_sun() -> None:
    """Hinges on a carrier count against it: with a held sun the planet turns 1 + z_s/z_p times the carrier."""
    builder = Scene("planet").ground()
    builder.rigid("sun", mass=1.0, inertia=1.0).rigid(
        "carrier", mass=1.0, inertia=0.3, markers={"pin": {"position": [0.3, 0.0]}}
    )
    builder.rigid("planet", mass=0.5, inertia=0.01)
    builder.revolute("bearing", "ground.origin", "carrier.origin").revolute("shaft", "carrier.origin", "sun.origin")
    builder.revolute("pin", "carrier.pin", "planet.origin").prescribed_angle("held", "ground.origin", "sun.origin", 0.0)
    builder.gear("mesh", "pin.angle", "shaft.angle", -2.0).torque("drive", "carrier.origin", 0.8)
    run = simulate(model_of(builder.build()), t_end=2.0, dt=0.01, scheme="rk4")
    exact = 0.4 / (0.3 + 0.5 * 0.09 + 9 * 0.01) * run.t**2
    assert run["carrier.theta"] == pytest.approx(exact, abs=1e-11)
    assert run["planet.theta"] == pytest.approx(3 * exact, abs=1e-10)


def turret(rotor: str) -> Scene:
    """An arm on a turret that turns too, about another axis; its rotor as a body with a gear, or as a motor."""
    x_axis = {"position": [0.1, 0.0, 0.4], "axis": [0.6, 0.0, 0.8]}
    motor = {"motor": {"inertia": 2e-3, "ratio": 20.0}} if rotor == "motor" else {}
    builder = Scene("turret", space="spatial").gravity(0.0, -9.81, -2.0).ground()
    builder.rigid("base", mass=2.0, inertia=[0.1, 0.1, 0.1], markers={"elbow": x_axis})
    arm = {"position": [0.0, 0.0, 0.0], "axis": [0.6, 0.0, 0.8]}
    builder.rigid("arm", mass=1.0, center_of_mass=[0.0, 0.3, 0.1], inertia=[0.02, 0.01, 0.02], markers={"end": arm})
    builder.revolute("swivel", "ground.origin", "base.origin").revolute("elbow", "base.elbow", "arm.end", **motor)
    spin = 2e-3 if rotor == "body" else 0.0
    builder.rigid("disc", mass=0.5, inertia=[0.01, 0.01, spin])
    if rotor == "body":
        builder.revolute("spin", "base.elbow", "disc.origin").gear("mesh", "spin.angle", "elbow.angle", 20.0)
    else:
        builder.weld("case", "base.elbow", "disc.origin")
    return builder.rates({"swivel.angle": 1.5, "elbow.angle": -2.0})


def test_a_rotor_behind_a_ratio_is_a_geared_body() -> None:
    """With the moment of its spin while the turret turns, and its energy."""
    runs = [simulate(model_of(turret(kind).build()), t_end=1.0, dt=2e-3, scheme="rk4") for kind in ("body", "motor")]
    for name in ("swivel.angle", "elbow.angle"):
        assert runs[1][name] == pytest.approx(runs[0][name], abs=1e-9)
    assert np.ptp(runs[0]["swivel.angle"]) > 0.3
    assert runs[1].energy["kinetic"] == pytest.approx(runs[0].energy["kinetic"], rel=1e-8)
    assert np.abs(runs[1].balance.error).max() < 1e-8


def test_a_rotor_in_the_plane() -> None:
    """Two links: T has J (phi_1' + n (phi_2' - phi_1'))^2 / 2, against the same as a geared body at the elbow."""
    runs = []
    for kind in ("body", "motor"):
        builder = Scene("arm").gravity(0.0, -9.81).ground()
        builder.rigid(
            "one", mass=2.0, inertia=0.1, center_of_mass=[0.2, 0.0], markers={"elbow": {"position": [0.5, 0.0]}}
        )
        builder.rigid("two", mass=1.0, inertia=0.05, center_of_mass=[0.3, 0.0])
        motor = {"motor": {"inertia": 1e-3, "ratio": 30.0}} if kind == "motor" else {}
        builder.revolute("shoulder", "ground.origin", "one.origin").revolute(
            "elbow", "one.elbow", "two.origin", **motor
        )
        builder.rigid("disc", mass=0.4, inertia=1e-3 if kind == "body" else 1e-9, free=False)
        builder.revolute("spin", "one.elbow", "disc.origin")
        if kind == "body":
            builder.gear("mesh", "spin.angle", "elbow.angle", 30.0)
        runs.append(simulate(model_of(builder.build()), t_end=1.0, dt=2e-3, scheme="rk4"))
    for name in ("one.theta", "two.theta"):
        assert runs[1][name] == pytest.approx(runs[0][name], abs=1e-8)


@pytest.mark.parametrize(
    ("add", "said"),
    [
        (lambda b: b.gear("g", "h_a.angle", "h_b.angle", 0.0), "ratio"),
        (lambda b: b.gear("g", "h_a.angle", "h_c.angle", 2.0), "there is no joint 'h_c'"),
        (lambda b: b.gear("g", "h_a.angle", "h_a.angle", 2.0), "the same coordinate twice"),
        (lambda b: b.rack("g", "h_a.angle", "h_b.angle", 2.0), "is not a travel"),
        (lambda b: b.gear("h_a", "h_a.angle", "h_b.angle", 2.0), "has the name of a joint"),
        (lambda b: b.belt("g", "h_a.angle", "h_b.angle", 0.0, 1.0), "must be positive"),
    ],
)
def test_what_couples_nothing_is_refused_by_name(add, said: str) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(SceneError, match=said):
        add(shafts("planar", 1.0, 1.0)).build()


def machine(space: str) -> Scene:
    """A gear, a belt, a rack, a differential, a mimic, a motor, driven by a profile on a base that a table shakes."""
    flat = space == "planar"
    across = {} if flat else {"axis": [1.0, 0.0, 0.0], "x_axis": [0.0, 1.0, 0.0]}
    builder = Scene("machine", space=space).table("shake", x=[0.0, 0.2, 0.5, 1.0], y=[0.0, 1e-2, -1e-2, 0.0])
    places = {f"m{k}": {"position": [0.5 * k, 0.0, 0.0][: 2 if flat else 3]} for k in range(7)}
    builder.table("way", **s_curve(0.5, speed=1.0, acceleration=2.0, jerk=20.0))
    builder.ground(markers={"floor": across})
    rail = {"rail": {"position": [0.0, 1.0, 0.0][: 2 if flat else 3], **across}, "floor": across}
    builder.rigid("base", mass=5.0, inertia=1.0 if flat else [1.0] * 3, markers={**places, **rail})
    builder.prismatic("guide", "ground.floor", "base.floor")
    builder.prescribed_displacement("shaker", "ground.floor", "base.floor", "table('shake', t)")
    motor = {"motor": {"inertia": 1e-3, "ratio": 5.0}}
    for k in range(7):
        inertia = 0.1 + 0.05 * k
        builder.rigid(f"w{k}", mass=1.0, inertia=inertia if flat else [1.0, 1.0, inertia])
        builder.revolute(f"h{k}", f"base.m{k}", f"w{k}.origin", **(motor if k == 1 else {}))
    builder.rigid("rack", mass=1.0, inertia=0.1 if flat else [0.1] * 3, markers={"rail": across})
    builder.prismatic("slide", "base.rail", "rack.rail").prescribed_angle(
        "drive", "base.m0", "w0.origin", "table('way', t)"
    )
    builder.gear("gear", "h1.angle", "h0.angle", -2.0).belt("belt", "h2.angle", "h0.angle", 0.1, 0.3)
    builder.rack("teeth", "slide.travel", "h0.angle", 0.2).mimic(
        "follow", "h3.angle", "h0.angle", multiplier=-1.5, offset=0.25
    )
    return builder.differential("axle", "h4.angle", "h5.angle", "h6.angle", ratio=3.0)


@pytest.mark.every_push("planar")
@pytest.mark.parametrize("space", SPACES)
def test_every_coupling_from_a_file_holds_and_is_drawn(space: str) -> None:
    """A machine that was written to TOML and read again: ratios by hand, inertia of the motor, lines in pictures."""
    scene = SceneRecord.from_toml_text(machine(space).build().to_toml())
    run = simulate(model_of(scene), t_end=1.2, dt=5e-3, scheme="rk4")
    angle = [run[f"w{k}.theta" if space == "planar" else f"h{k}.angle"] for k in range(7)]
    turn = angle[0]
    assert turn[-1] == pytest.approx(0.5, abs=1e-12)  # the profile has arrived
    assert angle[1] == pytest.approx(-2.0 * turn, abs=1e-12)
    assert angle[2] == pytest.approx(3.0 * turn, abs=1e-12)
    assert angle[3] == pytest.approx(0.25 - 1.5 * turn, abs=1e-12)
    assert np.abs(angle[4] - 1.5 * (angle[5] + angle[6])).max() < 1e-12
    travel = run["rack.x"] - run["base.x"] if space == "planar" else run["slide.travel"]
    assert travel == pytest.approx(0.2 * turn, abs=1e-12)
    assert np.ptp(run["base.x" if space == "planar" else "guide.travel"]) > 1e-2
    drawn = {line.name for line in film(run).lines if line.kind == "rod"}
    assert drawn == {"gear", "belt", "teeth", "follow", "axle"}
    joints = {joint["name"]: joint for joint in view_record(run)["joints"]}
    assert all(joints[name]["shown"] and (joints[name]["line"] or joints[name]["wheels"]) for name in drawn)
