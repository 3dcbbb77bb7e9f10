"""Units by record: every coordinate and measure the unit of what it is."""

from __future__ import annotations

from symgen.scene import Scene


def test_units_do_not_depend_on_how_something_is_called(model_of) -> None:
    """A body, a joint and a mode may have any name: a hinge "e0", a slide "theta", a beam "angle"."""
    builder = Scene("odd_names", space="spatial").gravity(0.0, 0.0, -9.81)
    builder.rigid("theta", mass=1.0, inertia=[1.0, 1.0, 1.0], free=True)
    builder.beam("angle", length=1.0, density=10.0, area=0.1, youngs_modulus=1e6, second_moment=1e-3,
                 second_moment_z=1e-3, lateral={"ends": "clamped-free", "modes": 2})  # fmt: skip
    builder.revolute("e0", "theta.origin", "angle.start")
    records = {entry.name: entry for entry in model_of(builder.build()).description.coordinates}
    assert {name: entry.unit for name, entry in records.items() if entry.owner == "theta"} == {
        **dict.fromkeys(("theta.x", "theta.y", "theta.z"), "m"),
        **dict.fromkeys(("theta.e0", "theta.e1", "theta.e2", "theta.e3"), "1"),
    }
    assert (records["e0.angle"].unit, records["e0.angle"].owner) == ("rad", "e0")
    assert (records["angle.q2"].unit, records["angle.q2"].kind) == ("m", "modal")
    assert records["theta.e0"].at_rest == 1.0 and records["theta.e1"].at_rest == 0.0
    assert records["e0.angle"].unit_of(2) == "rad/s^2"
