"""Faults put into the generator at random that nothing else saw: one law or hand figure each."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest
import sympy as sp

from runtime.contract.model import Model
from runtime.contract.tape import UNUSED
from symgen.emission.write import compare_model
from symgen.fe.report import RigidCheck, body_report
from symgen.joints import JOINTS
from symgen.modes import axial_modes, lateral_modes
from symgen.modes.spatial_beam import spatial_beam
from symgen.scene import Scene, SceneError, SceneRecord
from symgen.schema.expressions import parse_expression
from symgen.system.joint_templates import PlanarMarkers, r_a, r_b, t_a
from symgen.tapes.graph import Graph, without_negations
from tests.support.model_values import evaluate, random_states

Build = Callable[[SceneRecord], Model]


def test_numbers_gather_behind_what_varies() -> None:
    """(x 3) 5 is x 15: one product of x, and 15 = 3 * 5 is taken once, outside."""
    graph = Graph()
    x = graph.entry(1, 0, False)
    found = graph.nodes[graph.apply(ca.OP_MUL, graph.apply(ca.OP_MUL, x, graph.constant(3.0)), graph.constant(5.0))]
    assert found.op == ca.OP_MUL and found.a == x and graph.of_p[found.b]


def test_signs_go_into_what_nothing_else_uses() -> None:
    """-(x - y) is y - x and -(3 x + y) is -3 x - y, but where x - y is an output too it is negated as it is."""
    graph = Graph()
    x, y = graph.entry(1, 0, False), graph.entry(1, 1, False)
    less, more = graph.apply(ca.OP_SUB, x, y), graph.apply(ca.OP_ADD, graph.apply(ca.OP_MUL, x, graph.constant(3.0)), y)
    roots = [graph.rebuilt(ca.OP_NEG, k, UNUSED) for k in (less, more)]
    first, second = (graph.nodes[k] for k in without_negations(graph, [roots])[0])
    assert (first.op, first.a, first.b) == (ca.OP_SUB, y, x)
    assert (second.op, graph.nodes[graph.nodes[second.a].b].value, second.b) == (ca.OP_SUB, -3.0, y)
    assert without_negations(graph, [[roots[0], less]]) == [[roots[0], less]]


def test_a_slide_measures_across_and_along() -> None:
    """b = a + s t + w n with t at angle phi, n at phi + 90 degrees: w across, s along."""
    phi, a, s, w = 0.7, (0.3, -0.2), 1.3, 0.4
    t, n = (math.cos(phi), math.sin(phi)), (-math.sin(phi), math.cos(phi))
    values = dict(zip((*r_a, *t_a), (*a, *t), strict=True))
    values |= dict(zip(r_b, (a[k] + s * t[k] + w * n[k] for k in range(2)), strict=True))
    across, along = (
        JOINTS[joint].rows_in_plane(PlanarMarkers(None))[0].C for joint in ("point_on_line", "prescribed_displacement")
    )
    assert float(across.subs(values)) == pytest.approx(w)
    assert float(along.subs({**values, sp.Symbol("f"): 0.0})) == pytest.approx(s)


def test_sections_of_a_beam_in_space_stay_across_it() -> None:
    """d(shape)/dx = turn x e_x: a deflection along y turns about z by its slope, one along z about -y."""
    beam = spatial_beam(
        (
            (0, axial_modes(20, "fixed-free", 1)),
            (1, lateral_modes(20, "clamped-free", 2)),
            (2, lateral_modes(20, "pinned-pinned", 1)),
        )
    )
    h = 1e-6
    for at in (0.31, 0.77):
        slope = (beam.point(at + h).shape - beam.point(at - h).shape) / (2 * h)
        across = np.cross(beam.point(at).turn.T, [1.0, 0.0, 0.0]).T
        assert np.abs(across[1:]).max(axis=1).min() > 0.1
        assert across[1:] == pytest.approx(slope[1:], abs=1e-6) and np.all(across[0] == 0)


@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_weight_is_the_slope_of_its_potential(model_of: Build, space: str) -> None:
    """A free body of 2 kg, centre of mass aside, gravity (3, -4[, 5]): -dU/dq = Q, and U = -m g . r of the centre."""
    three, inertia = (space == "spatial"), 0.3
    off, g = (0.2, -0.1, 0.3)[: 2 + three], (3.0, -4.0, 5.0)[: 2 + three]
    moments: Any = [inertia] * 3 if three else inertia
    builder = Scene("thrown", space=space).gravity(*g)
    builder.rigid("m", mass=2.0, inertia=moments, center_of_mass=off, free=True)
    for axis in "xyz"[: 2 + three]:
        builder.measure(axis, axis, "m.center")
    model = model_of(builder.simulation(t_end=0.1, dt=0.01, scheme="printed").build())
    c = model.constants(model.parameter_vector())
    at = random_states(model, 1, rate=0.0)[0]

    def potential(q: np.ndarray) -> float:
        return float(model.evaluate("energy", q=q, q_dot=0 * q, t=0.0, c=c)["potential"])

    force = evaluate(model, "condensed", **at.values())["Q_hat"]
    moved = [name for name in model.q_i if name in ("m.x", "m.y", "m.z", "m.theta")]
    for name in moved:
        row, k = model.q_i.index(name), model.coordinates.index(name)
        step = 1e-5 * np.eye(len(at.q))[k]
        assert force[row] == pytest.approx((potential(at.q - step) - potential(at.q + step)) / 2e-5, abs=1e-7)
    x = at.q[[model.coordinates.index(f"m.{axis}") for axis in "xyz"[: 2 + three]]]
    straight = model.initial_q.copy()
    straight[: len(x)] = x
    assert potential(straight) == pytest.approx(-2.0 * np.dot(g, x + off))


def test_the_distance_between_two_points_of_a_plane(model_of: Build) -> None:
    """3 along x and 4 along y: 5."""
    builder = Scene("apart").rigid("m", mass=1.0, inertia=1.0, free=True).initial({"m.x": 3.0, "m.y": 4.0})
    model = model_of(
        builder.measure("gap", "distance", "m.origin").simulation(t_end=0.1, dt=0.01, scheme="printed").build()
    )
    at = random_states(model, 1, rigid=0.0, rate=0.0)[0]
    c = model.constants(model.parameter_vector())
    found = model.evaluate("measures", q=at.q, q_dot=at.q_dot, t=0.0, c=c)
    assert float(np.ravel(np.asarray(found["measures"]))[model.measures.index("gap")]) == pytest.approx(5.0)


def test_the_axis_of_x_is_across_that_of_the_joint() -> None:
    """In the plane of x and y too: (2, 2, 0) is along (1, 1, 0)."""
    for x_axis, fine in (((2.0, 2.0, 0.0), False), ((1.0, -1.0, 0.0), True)):
        builder = Scene("axes", space="spatial").rigid("m", mass=1, inertia=[1, 1, 1])
        builder.ground(markers={"pin": {"axis": (1.0, 1.0, 0.0), "x_axis": x_axis}})
        builder.revolute("hinge", "ground.pin", "m.origin")
        if fine:
            builder.build()
        else:
            with pytest.raises(SceneError, match="along the axis"):
                builder.build()


def test_the_largest_of_twenty_is_the_limit() -> None:
    for name in ("min", "max"):
        parse_expression(f"{name}({', '.join(map(str, range(20)))})", frozenset(), "item")
        with pytest.raises(SceneError, match="20"):
            parse_expression(f"{name}({', '.join(map(str, range(21)))})", frozenset(), "item")


def test_a_folder_that_agrees_but_for_versions_is_current(tmp_path: Path) -> None:
    """Versions of a manifest belong to the machine; what differs, is missing or surplus is said."""
    manifest = {"format": 1, "versions": {"casadi": "1"}, "sha256": "a"}
    files = {"model.py": "x = 1\n", "manifest.json": json.dumps(manifest)}
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "__init__.py").write_text("")
    assert compare_model(files, tmp_path) == ""
    other = {**files, "manifest.json": json.dumps({**manifest, "versions": {"casadi": "2"}, "sha256": "b"})}
    assert compare_model(other, tmp_path) == ""
    assert "format" in compare_model({**files, "manifest.json": json.dumps({**manifest, "format": 2})}, tmp_path)
    assert "-x = 1" in compare_model({**files, "model.py": "x = 2\n"}, tmp_path)
    (tmp_path / "notes.txt").write_text("")
    assert compare_model(files, tmp_path) == f"only in {tmp_path}: notes.txt\n"


def test_effective_masses_that_are_not_represented() -> None:
    """Shares 60 % and 30 % along x add up to 90 %; 10 % are left."""
    shares = np.array([[0.6, 0.0, 0.0], [0.3, 0.2, 0.0]])
    text = body_report("rod", np.array([1.0, 2.0]), shares, None, [], RigidCheck(6, 0.1, 1.0, 1e-9))
    assert "| sum |  | 90 % | 20 % | 0 % |" in text and "| not represented |  | 10 % | 80 % | 100 % |" in text
