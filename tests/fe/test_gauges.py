"""Gauges: stresses of finite-element bodies as measures, outputs and reductions, against the textbook."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

from runtime import ArgumentError, ModelError, ensemble, plots, simulate
from symgen.fe import FiniteElementError, FlexibleBody, LineMesh, Section
from symgen.generate import model_of
from symgen.scene import Scene, SceneError, SceneRecord
from tests.fe.test_mode_acceleration import MATERIAL, L, Y, Z, bar

pytestmark = pytest.mark.long

PULL, TURN = 9e-4, 7e-6
PLACES = {
    "top": (L / 2, Y / 2, 0.0),
    "axis": (L / 2, 0.0, 0.0),
    "below": (3 * L / 8, -Y / 2, 0.0),
}  # away from the ends (Saint-Venant)
EXPECTED = {name: PULL / (Y * Z) - TURN * y / (Z * Y**3 / 12) for name, (_, y, _) in PLACES.items()}
SIZE = max(map(abs, EXPECTED.values()))


def pulled(fields: dict[str, Any]) -> Scene:
    """A bar on a wall, pulled by P and bent by M about z at its tip, with measures at its gauges."""
    builder = Scene("bar", space="spatial").parameter("P", PULL, "N").parameter("M", TURN, "N m")
    builder.flexible("bar", **fields).weld("wall", "ground.origin", "bar.root")
    builder.force("pull", "bar.tip", "P", 0.0, 0.0, frame="body").torque("bend", "bar.tip", "M")
    builder.measure("most", "stress", "bar.all").measure("above", "stress", "bar.top")
    return builder.measure("along", "stress", "bar.below", component="xx").measure(
        "across", "stress", "bar.axis", component="yy"
    )


def test_a_pulled_and_bent_bar() -> None:
    """P / A - M y / I at the gauges, by equilibrium and as measures, whose modes hold the static shapes of the ends."""
    fields = bar(0, mode_set="fixed_interface").fields(gauges=PLACES)
    del fields["phi_phi"]  # at rest they do nothing
    model = model_of(pulled(fields).build())
    run = simulate(model, scheme="rk4", dt=1e-9, t_end=1e-9, start="quasi_static")
    found = run.stresses("bar")
    for name, value in EXPECTED.items():
        assert_allclose(found.at(name)[0], [value, 0, 0, 0, 0, 0], atol=1e-5 * SIZE)
    assert found.largest().gauge == "below"
    assert found.largest().value == pytest.approx(EXPECTED["below"], rel=1e-5)
    assert run.events == [] and run.stats["missing_stress.bar"] < 1e-5
    for name, gauge in (("along", "below"), ("above", "top"), ("most", "below")):
        assert run[name][0] == pytest.approx(abs(EXPECTED[gauge]), rel=1e-5)
    assert abs(run["across"][0]) < 1e-5 * SIZE
    units = {one.name: one.unit for one in model.description.measures}
    assert units["most"] == "Pa" and units["most_dot"] == "Pa/s"


def test_the_largest_over_time_and_place_of_many_cases() -> None:
    """Started from rest: the measures are those of the modes; peaks of three cases grow with the load."""
    body = bar(1, cells=3, mode_set="mixed", fixed=["root"])
    model = model_of(pulled(body.fields(gauges=PLACES)).build())
    run = simulate(model, scheme="rk4", dt=2e-6, t_end=2e-4, seen_every=0.0)
    modal = run.stresses("bar", way="modes")
    assert run["most"][0] < 1e-100 and np.isfinite(run["most_dot"]).all()
    assert_allclose(run["most"], modal.von_mises.max(axis=1), rtol=1e-9, atol=1e-9)
    expected = body.stresses().at([PLACES["below"]])[0] @ np.atleast_2d(run["bar.q1"])
    drawn = plots.stresses(run, "bar").axes[0].get_lines()
    most = run.stresses("bar").largest().gauge
    assert [line.get_label() for line in drawn][:2] == [f"{most}, equilibrium", f"{most}, modes"] and len(drawn) == 6
    assert_allclose(modal.at("below"), expected.T, atol=1e-6 * np.abs(expected).max())
    factors = np.array([1.0, 2.0, 3.0])
    cases = {"P": PULL * factors, "M": TURN * factors}
    found = ensemble(model, cases, scheme="rk4", dt=2e-6, t_end=2e-4, reduce={"most": "peak"})
    assert_allclose(np.asarray(found["most_peak"]), modal.von_mises.max() * factors, rtol=1e-4)


def test_what_does_not_fit_is_named() -> None:
    body = bar(1, cells=2)
    fields = body.fields(gauges={"node": 0, "top": PLACES["top"]})
    assert fields["gauges"]["node"]["position"] == pytest.approx((body.structure.positions[0] - body.origin).tolist())
    for gauges, problem in (
        ({"a": (0.0, 1.0)}, "is not a place"),
        ({"a": 10_000}, "not in the node table"),
    ):
        with pytest.raises(FiniteElementError, match=problem):
            body.fields(gauges=gauges)
    frame = LineMesh(np.eye(3)[:1] * np.arange(9)[:, None], [(k, k + 1) for k in range(8)], Section.rectangle(0.1, 0.2))
    with pytest.raises(FiniteElementError, match="not made from a solid mesh"):
        FlexibleBody.from_mesh(frame, MATERIAL, interface={"a": [0]}, modes=1).fields(gauges={"a": 0})

    def scene(gauge: str, component: str = "von_mises", **changes: Any) -> SceneRecord:
        gauges = {"node": fields["gauges"]["node"] | changes}
        builder = Scene("bar", space="spatial").flexible("bar", **{**fields, "gauges": gauges})
        builder.rigid("head", mass=1.0, inertia=[1.0] * 3).weld("tip", "bar.tip", "head.origin")
        return (
            builder.weld("wall", "ground.origin", "bar.root").measure("s", "stress", gauge, component=component).build()
        )

    for arguments, changes, problem in (
        (("head.node",), {}, "s'.of: there is no body 'head' with gauges"),
        (("bar.nod",), {}, "s'.of: body 'bar' has no gauge 'nod'; did you mean 'node'"),
        (("bar.all", "xx"), {}, "s'.component: the largest of all gauges has no sign"),
        (("bar",), {}, "s'.of: 'bar' does not name a gauge"),
        (("bar.node",), {"shapes": [[1.0, 2.0]] * 6}, "gauges.node.shapes: is not 6 x 1"),
        (("bar.node",), {"fields": [[1.0]] * 6}, "gauges.node.fields: is not 6 x 18"),
        (("bar.node",), {"forces": {"toe": [[1.0] * 6] * 6}}, "gauges.node.forces: body 'bar' has no marker 'toe'"),
        (("bar.node",), {"forces": {"tip": [[1.0]]}}, "gauges.node.forces.tip: is not 6 x 6"),
    ):  # fmt: skip
        with pytest.raises(SceneError, match=problem):
            scene(*arguments, **changes)
    run = simulate(model_of(scene("bar.node", fields=[], forces={})), scheme="rk4", dt=1e-8, t_end=1e-8)
    assert run.stresses("bar", way="modes").gauges == ["node"]
    for call, problem in (
        (lambda: run.stresses("bar"), "gauge bar.node knows modal stresses only"),
        (lambda: run.stresses("head"), "no gauges on 'head', only on: bar"),
        (lambda: run.stresses("bar", way="modes").at("toe"), "bar has no gauge 'toe'; it has node"),
    ):
        with pytest.raises(ModelError, match=problem):
            call()
    with pytest.raises(ArgumentError, match="way 'sum' is not known"):
        run.stresses("bar", way="sum")  # type: ignore[arg-type]
    model = model_of(scene("bar.node", forces={"tip": fields["gauges"]["node"]["forces"]["tip"]}))
    with pytest.raises(ModelError, match="at the marker root, which was no interface"):
        simulate(model, scheme="rk4", dt=1e-8, t_end=1e-8).stresses("bar")
