"""Stresses as colours of a page: a cantilever by hand, von Mises in the browser by principal stresses."""

from __future__ import annotations

import base64
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import load_model, simulate
from runtime.model import Model
from runtime.views.viewer.page import view
from runtime.views.viewer.record import torsion_factors, view_record
from symgen.scene import Scene, SceneError, SceneRecord
from symgen.scenes import SCENES, generated_folder
from tests.support.browser import used

pytestmark = pytest.mark.long


@pytest.mark.parametrize("aside", [0.0, -0.02])
def test_a_cantilever_under_a_force(model_of: Callable[[SceneRecord], Model], aside: float) -> None:
    """Hand, to first order: sigma = P / A - F_y (L - x) y / I_z - F_z (L - x) z / I_y at corners and middles of sides,
    tau = 3 F / (2 A) in the middles along F and T / (0.246 h w^2), 0.795 of it on the short sides, of torsion (tables
    for 2 : 1): sqrt(sigma^2 + 3 tau^2). In space with F_z and T.
    """
    length, height, width, force, pull, twist = 0.5, 0.02, 0.01, 0.03, 4.0, 2e-2
    builder = Scene("cantilever", space="spatial" if aside else "planar")
    across: dict[str, Any] = {}
    if aside:
        across = {"second_moment_z": height * width**3 / 12, "lateral_z": {"modes": 2}, "torsion": {"modes": 1}}
        across |= {"shear_modulus": 8e10, "torsion_constant": 0.229 * height * width**3}
        across |= {"markers": {"key": {"at": 1.0, "axis": (1.0, 0.0, 0.0)}}}
    builder.beam("beam", length=length, density=7800.0, youngs_modulus=2e11, area=width * height,
                 second_moment=width * height**3 / 12, axial={"modes": 1}, lateral={"modes": 2}, **across)  # fmt: skip
    builder.weld("wall", "ground.origin", "beam.start").force(
        "tip", "beam.end", *(pull, force, aside)[: 3 if aside else 2]
    )
    if aside:
        builder.torque("twist", "beam.key", twist)
    run = simulate(model_of(builder.simulation(t_end=2e-6, dt=1e-6, scheme="rk4", start="quasi_static").build()))
    record = view_record(run)
    (beam,) = (body for body in record["bodies"] if body["name"] == "beam")
    places = np.frombuffer(base64.b64decode(beam["mesh"]["x"]), "<f4").reshape(-1, 8, 3)
    levels = np.frombuffer(base64.b64decode(beam["stress"]["vertices"]), "u1").reshape(-1, len(places), 8)
    stresses = levels / 255 * record["stress"]
    x, y, z = np.moveaxis(places, 2, 0)
    bent = force * (length - x) * y / (width * height**3) + aside * (length - x) * z / (height * width**3)
    normal = pull / (width * height) - 12 * bent
    on_y, on_z = np.sign(np.round(y, 6)), np.sign(np.round(z, 6))
    torsion = twist / (0.246 * height * width**2) if aside else 0.0
    along_y = np.where(on_y == 0, 1.5 * force / (width * height) - on_z * torsion, 0.0)
    along_z = np.where(on_z == 0, 1.5 * aside / (width * height) + on_y * 0.795 * torsion, 0.0)
    expected = np.sqrt(normal**2 + 3 * (along_y**2 + along_z**2))
    assert (expected - np.abs(normal)).max() > (0.1 if aside else 1e-5) * expected.max()
    half_a_level = 0.5 / 255  # of the largest stress: they are sent as bytes
    np.testing.assert_allclose(stresses[0], expected, atol=(2e-3 + half_a_level) * expected.max())


def test_torsion_of_a_square_and_a_strip() -> None:
    """T / (0.208 a^3) in the middle of each side; 3 T / (h w^2) on those of a strip, 0.74 of it at its ends."""
    assert np.array(torsion_factors(0.3, 0.3)) * 0.3**3 == pytest.approx(1 / 0.208, rel=1e-3)
    of_short, of_long = torsion_factors(1.0, 0.002)
    assert of_long == pytest.approx(3 / 0.002**2, rel=2e-3) and of_short / of_long == pytest.approx(0.7425, rel=1e-3)
    assert torsion_factors(0.1, 0.2) == torsion_factors(0.2, 0.1)[::-1]


def test_the_page_computes_von_mises(tmp_path: Path) -> None:
    """sqrt(((s1 - s2)^2 + (s2 - s3)^2 + (s3 - s1)^2) / 2) of the principal stresses, at every vertex of the rod."""
    run = simulate(load_model(generated_folder("spatial_slider_crank")), t_end=0.02)
    record = view_record(run)
    place, rod = next((k, body) for k, body in enumerate(record["bodies"]) if body["name"] == "rod")
    t = np.frombuffer(base64.b64decode(record["t"]))[120]
    probe = f"symgenView.show({t}); document.documentElement.dataset.probe = JSON.stringify("
    probe += f"Array.from(symgenView.run.bodies[{place}].strained));"
    found = used(view(run).text, tmp_path, probe, "with=colour%3A%20stress")
    assert "error" not in found
    q_f = run.interpolate(np.array([t]), "q")[0, [one.elastic for one in run.model.description.coordinates]]
    modes = np.frombuffer(base64.b64decode(rod["stress"]["modes"]), "<f4").reshape(-1, 6, len(q_f))
    xx, yy, zz, yz, xz, xy = (modes @ q_f).T
    one, two, three = np.linalg.eigvalsh(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).transpose(2, 0, 1)).T
    expected = np.sqrt(((one - two) ** 2 + (two - three) ** 2 + (three - one) ** 2) / 2)
    np.testing.assert_allclose(found["probe"], expected, rtol=1e-4, atol=1e-6 * expected.max())
    assert expected.max() <= record["stress"] * (1 + 1e-6)


def test_the_page_has_the_stress_of_a_beam_from_its_levels(tmp_path: Path) -> None:
    """The bytes that are sent, over 255, are shares of the largest stress; they are those of the frame."""
    run = simulate(load_model(generated_folder("hub_beam")), t_end=0.5)
    record = view_record(run)
    place, beam = next((k, body) for k, body in enumerate(record["bodies"]) if body["name"] == "beam")
    t = np.frombuffer(base64.b64decode(record["t"]))
    levels = np.frombuffer(base64.b64decode(beam["stress"]["vertices"]), "u1").reshape(len(t), -1)
    assert levels.max() == 255
    frame = int(levels.max(axis=1).argmax())
    probe = f"symgenView.show({t[frame]}); document.documentElement.dataset.probe = JSON.stringify("
    probe += f"Array.from(symgenView.run.bodies[{place}].strained));"
    found = used(view(run).text, tmp_path, probe, "with=colour%3A%20stress")
    assert "error" not in found
    np.testing.assert_allclose(found["probe"], levels[frame] / 255 * record["stress"], rtol=1e-6)


def test_a_surface_that_does_not_fit_is_refused_with_the_scene() -> None:
    plain = SCENES["spatial_slider_crank"]().to_dict()
    rod = next(body for body in plain["bodies"] if body["name"] == "rod")
    good = dict(rod["surface"])
    for change, words in (
        ({"vertices": [[0.0, 0.0, 0.0]]}, "for 6 modes"),
        ({"triangles": [[0, 1, 310]]}, "from 0 to 310 of 310"),
        ({"shapes": "no numbers"}, "neither numbers nor their packed text"),
        ({"stresses": [float("nan")]}, "not finite"),
    ):
        rod["surface"] = {**good, **change}
        with pytest.raises(SceneError, match=words):
            SceneRecord.from_dict(plain)
