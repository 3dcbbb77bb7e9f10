"""Scripts in examples/ say figures that only right physics gives, continued: see test_examples.py."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.support.printed_numbers import line, numbers

pytestmark = pytest.mark.long

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def test_double_wishbone(said) -> None:
    text = said("double_wishbone")
    force, weight = line(text, "tyre at rest")
    assert force == pytest.approx(weight, rel=5e-4)
    assert numbers(text.splitlines()[0])[-1] < 0.4  # J, of some 400 J, by samples 5 ms apart


def test_spinning_satellite(said) -> None:
    """The momentum decides what is left: the least energy, and an axis along the momentum, 12 degrees off at first."""
    text = said("spinning_satellite")
    first, last = line(text, "angle to the angular momentum")
    assert first > 11.9 and last < 1.5
    at_first, at_last, least = line(text, "energy")
    assert least < at_last < least + 0.05 * (at_first - least)


def test_rotor_blades(said) -> None:
    rows = [numbers(row) for row in said("rotor_blades").splitlines()[1:5]]
    for _, found, published in rows:
        assert found == pytest.approx(published, rel=5e-4)


def test_tumbling_body(said) -> None:
    text = said("tumbling_body")
    found, elliptic = line(text, "turns over every")
    assert found == pytest.approx(elliptic, rel=5e-4)
    assert max(line(text, "momentum changes by")) < 1e-5


def test_gyroscope(said) -> None:
    text = said("gyroscope")
    found, closed_form = line(text, "goes round at")
    assert found == pytest.approx(closed_form, rel=1e-6)
    even, free = line(text, "nods by")
    assert even < 1e-5 and free > 30.0
    found, closed_form = line(text, "lowest tilt")
    assert found == pytest.approx(closed_form, abs=1e-2)


def test_spin_up(said) -> None:
    """The figures of case F3 in docs/evidence/cases.md."""
    text = said("spin_up")
    assert line(text, "largest lag") == pytest.approx([-0.57438, 3.64e-3], rel=3e-3)
    assert "without stiffening: deflection_too_large" in text


def test_four_bar_crossing(said) -> None:
    text = said("four_bar_crossing")
    assert "10 singular positions passed" in text
    found, integral = line(text, "one turn takes")
    assert found == pytest.approx(integral, rel=1e-4)


def test_hanging_chain(said) -> None:
    """Links of an eighth of a metre stay within 3 mm of the catenary, and the chain is as its mirror image."""
    text = said("hanging_chain")
    assert "stable: True" in text
    assert line(text, "joints off the catenary by")[0] < 3e-3
    assert line(text, "left and right alike to")[0] < 1e-9


def test_cart_pole(said) -> None:
    text = said("cart_pole")
    found, closed_form = line(text, "unstable root")
    assert found == pytest.approx(closed_form, rel=1e-6)
    assert max(map(abs, line(text, "after 5 s: cart at"))) < 1e-2


def test_finite_element_bar(said) -> None:
    """The bar rings as its mesh says, and a clamped end that holds the width makes it 0.8 % stiffer than a beam."""
    _, measured, mesh, beam = numbers(said("finite_element_bar").splitlines()[1])
    assert measured == pytest.approx(mesh, rel=1e-3)
    assert mesh == pytest.approx(beam, rel=0.012) and mesh > beam


def test_partitioned_bar(said) -> None:
    """First order against an exact treatment of the fine part; one step for all would be four times too long."""
    text = said("partitioned_bar")
    assert line(text, "printed: off d'Alembert's solution by")[0] < 0.035  # 0.0309 by the chord, its reading here
    assert line(text, "exponential: off d'Alembert's solution by")[0] < 0.006
    assert "for all: step_too_long" in text


def test_floating_frame(said) -> None:
    text = said("floating_frame")
    *found, one, two, three = line(text, "coupling M_LS")
    assert found == pytest.approx([one, two, three], rel=2e-3)
    *masses, exact = line(text, "modal masses M_SS")
    assert masses == pytest.approx([exact] * 3, rel=2e-3)


def test_monte_carlo(said) -> None:
    """Every case comes to its end; speed decides, and the linear fit leaves no more than a few percent unexplained."""
    text = said("monte_carlo")
    assert text.startswith("2000 of 2000 cases")
    middle, _, low, high = line(text, "peak deflection")
    assert 0 < low < middle < high < 1.2 * middle
    speed, *others = (numbers(row.partition(":")[2])[0] for row in text.splitlines()[2:])
    assert speed > 90 and 95 < speed + sum(others) < 101


def test_thin_coupler(said) -> None:
    """Both links end at the bound with about half the mass; stresses are those of the end of a long run."""
    text = said("thin_coupler")
    *_, before, peak_before, _ = line(text, "start")
    *heights, after, coupler, rocker = line(text, "best")
    assert (coupler, rocker) == pytest.approx((40.0, 40.0), abs=0.01) and peak_before < 40
    assert 0 < after < 0.55 * before and max(heights) < 6
    assert "terminated successfully" in text and numbers(text.splitlines()[-1])[-1] < 1e-9


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.skipif(find_spec("do_mpc") is None, reason="needs the extra mpc: pip install 'symgen[mpc]'")
def test_crane_mpc(said) -> None:
    """The load rests at the goal, and no force is above its bound."""
    _, trolley, load, force = numbers(said("crane_mpc"))
    assert trolley == pytest.approx(2.0, abs=0.01) and abs(load) < 0.01
    assert force == pytest.approx(8.0, abs=1e-3)


@pytest.mark.skipif(find_spec("jax") is None, reason="needs the extra jax: pip install 'symgen[jax]'")
def test_train_controller(said) -> None:
    """The network learns, to within 3 % of what no controller can go below."""
    first, last, _, least = line(said("train_controller"), "cost")
    assert first > 10 * least and least < last < 1.03 * least


@pytest.mark.skipif(find_spec("gymnasium") is None, reason="needs the extra gym: pip install 'symgen[gym]'")
def test_swing_up_environment(said) -> None:
    """The pendulum stands at the end, and has done for a second."""
    *_, at_the_end, _, least = line(said("swing_up_environment"), "height")
    assert 0.999 < at_the_end <= 1 and 0.999 < least <= 1


def test_quarter_car(said) -> None:
    text = said("quarter_car")
    assert numbers(text.splitlines()[0])[-1] < 1e-6  # m, off two equations by hand


def test_four_bar_300rpm(said) -> None:
    text = said("four_bar_300rpm")
    assert max(line(text, "off by hand by")) < 1e-9  # N m, of 11


def test_overhung_rotor(said) -> None:
    """Whirl of a light shaft in closed form; a slow run-up is largest a little above the critical speed."""
    text = said("overhung_rotor")
    assert line(text, "whirl off the quartic by")[0] < 1e-4
    at, critical = numbers(text.splitlines()[1])[-2:]
    assert critical == pytest.approx(58.8, abs=0.2) and critical < at < 1.15 * critical


def test_bridge_crane(said) -> None:
    found, hand = numbers(said("bridge_crane").splitlines()[0])[-2:]
    assert found == pytest.approx(hand, rel=3e-4)


def test_urdf_arm(said) -> None:
    text = said("urdf_arm")
    assert line(text, "held at rest off by hand by")[0] < 1e-12
    assert line(text, "computed torque")[0] < 0.02 < 1 < line(text, "feedback alone")[0]


def test_geared_arm(said) -> None:
    """A joint holds up to its breakaway torque, whatever the gear; at rest rates are zero and friction holds."""
    text = said("geared_arm")
    found, given = line(text, "breaks away at")
    assert found == pytest.approx(given, rel=1e-6)
    *errors, first, second = numbers(text.splitlines()[1].partition("errors")[2])
    assert len(errors) == 2 and max(map(abs, errors)) < 0.1 and first == second == 0
    shoulder, elbow, *holds = line(text, "torques beyond the weights")
    assert abs(shoulder) <= holds[0] and abs(elbow) <= holds[1] and len(holds) == 2


def test_faulty_robot(said) -> None:
    """Refused by name; taken with what was assumed; the mass matrix by hand, limits and friction of the file."""
    text = said("faulty_robot")
    assert "refused: head.urdf: link 'camera': no body has its moments" in text and "pan turns back" in text
    assert len(text.partition("taken, with\n")[2].partition("limits:")[0].splitlines()) == 6
    assert "'pan': (-2.0, 2.0, 8.0, 3.0)" in text and line(text, "mass matrix off by hand by")[0] < 1e-15


def test_identify_payload(said) -> None:
    """The log sticks and turns back; the truth is in the region that is said, which is small."""
    text = said("identify_payload")
    assert "the truth lies in the 95 % region of all" in text and line(text, "the log")[1] > 5
    low, high, truth = numbers(next(one for one in text.splitlines() if one.startswith("payload")).partition("%")[2])
    assert low < truth < high and high - low < 0.01


def test_rod_over_speed(said) -> None:
    """By the square of the speed while it is slow; beyond it as the rod's own vibration comes nearer."""
    text = said("rod_over_speed", speeds=3)
    assert numbers(text.splitlines()[1])[-1] == pytest.approx(4.0, rel=1e-3)
    shares = [numbers(row)[-1] for row in text.splitlines()[2:]]
    assert len(shares) == 3 and 1 < shares[0] < shares[1] < shares[2] < 1.1
