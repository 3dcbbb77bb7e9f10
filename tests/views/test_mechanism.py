"""What pictures are made of: bodies meet at their joints, whatever the exaggeration; the undeformed body is rigid."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
import pytest

from runtime import Solution, load_model, simulate
from runtime.views.film import shortest_tree
from runtime.views.mechanism import Points, bodies, exaggerated, following, scenery
from symgen.scenes import generated_folder

MEETING = ("revolute", "spherical", "universal", "weld")  # joints that hold two points together


@cache
def solution(name: str) -> Solution:
    return simulate(load_model(generated_folder(name)), t_end=0.02)


@pytest.mark.every_push("flexible_slider_crank-0.5", "flexible_four_bar-0.5")
@pytest.mark.parametrize("factor", [0.5, 1.0, 100.0])
@pytest.mark.parametrize("name", ["flexible_slider_crank", "spatial_slider_crank", "flexible_four_bar", "bricard"])
def test_exaggeration_opens_no_gap_at_a_joint(name: str, factor: float) -> None:
    """Constraints hold to 1e-8 m or better; so must the pictures of the two markers of each joint."""
    shown = scenery(solution(name), np.linspace(0.0, 0.02, 9))
    joints = [joint for joint in shown.joints if joint["type"] in MEETING]
    assert joints
    for joint in joints:
        a, b = (shown.place(joint[key], factor) for key in ("marker_a", "marker_b"))
        assert np.abs(a - b).max() < 2e-8 * max(1.0, shown.size())


def test_a_factor_of_one_is_the_true_motion() -> None:
    """The beam's tip, foreshortening included, is where the emitted measures say; its last station is its end."""
    run = simulate(load_model(generated_folder("hub_beam")), t_end=0.3)
    shown = scenery(run, run.t)
    tip = shown.place("beam.end", 1.0)
    assert np.abs(tip[:, 0] - run["tip_x"]).max() < 1e-12 and np.abs(tip[:, 1] - run["tip_y"]).max() < 1e-12
    beam = next(body for body in shown.bodies if body.name == "beam")
    stations = shown.world(beam, beam.stations, 1.0)
    assert np.abs(stations[:, -1] - tip).max() < 1e-12
    assert float(np.abs(beam.stations.shortening(shown.q_f(beam))).max()) > 1e-6


def test_sections_have_the_area_and_the_second_moment_of_the_beam() -> None:
    model = load_model(generated_folder("hub_beam"))
    beam = next(body for body in bodies(model, model.parameter_vector()) if body.section)
    height, width = beam.section
    assert height * width == pytest.approx(7.2968e-05, rel=1e-12)
    assert width * height**3 / 12 == pytest.approx(8.2189e-09, rel=1e-12)


def test_a_body_held_at_one_marker_follows_its_rotation() -> None:
    """A mode that only turns the body about its marker is a rigid motion: nothing of it is exaggerated."""
    x = np.array([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]])
    turning = np.zeros((2, 3, 1))
    turning[1, 1, 0] = 2.0
    turns = np.zeros((2, 3, 1))
    turns[:, 2, 0] = 1.0
    points = Points(["a", "b"], x, np.stack([np.eye(3)] * 2), turning, turns, np.zeros((2, 1, 1)))
    shown = exaggerated(points, following(points, [0]), np.array([[0.01]]), 50.0)
    assert np.allclose(shown[0], [[0, 0, 0], [2, 0.02, 0]], atol=1e-15)


def test_rods_of_a_body_are_the_shortest_tree() -> None:
    """Corners of a 1 x 3 rectangle in a zigzag order: two short sides and one long, never a diagonal."""
    corners = np.array([[0.0, 0, 0], [3.0, 1, 0], [0.0, 1, 0], [3.0, 0, 0]])
    edges = shortest_tree(corners)
    lengths = sorted(float(np.linalg.norm(corners[a] - corners[b])) for a, b in edges)
    assert lengths == [1.0, 1.0, 3.0]
    line = np.array([[x, 0.0, 0.0] for x in (0.0, 2.0, 1.0, 3.0)])
    assert {frozenset(edge) for edge in shortest_tree(line)} == {frozenset(e) for e in pairwise((0, 2, 1, 3))}
