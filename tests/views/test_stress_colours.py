"""Stresses as colours of a page: a cantilever by hand, von Mises in the browser by principal stresses."""

from __future__ import annotations

import base64
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import load_model, simulate
from runtime.contract.model import Model, ModelError
from runtime.views.viewer import view
from runtime.views.viewer.record import view_record
from symgen.scene import Scene, SceneBuilder, SceneError
from symgen.scenes import SCENES, generated_folder
from tests.support.browser import used


@pytest.mark.parametrize("aside", [0.0, -0.02])
def test_a_cantilever_under_a_force(model_of: Callable[[Scene], Model], aside: float) -> None:
    """Hand, to first order: |P / A - F_y (L - x) y / I_z - F_z (L - x) z / I_y| at every corner; in space with F_z."""
    length, height, width, force, pull = 0.5, 0.02, 0.01, 0.03, 4.0
    builder = SceneBuilder("cantilever", space="spatial" if aside else "planar")
    across = {"second_moment_z": height * width**3 / 12, "lateral_z": {"modes": 2}} if aside else {}
    builder.beam("beam", length=length, density=7800.0, youngs_modulus=2e11, area=width * height,
                 second_moment=width * height**3 / 12, axial={"modes": 1}, lateral={"modes": 2}, **across)  # fmt: skip
    builder.weld("wall", "ground.origin", "beam.start").force(
        "tip", "beam.end", *(pull, force, aside)[: 3 if aside else 2]
    )
    run = simulate(model_of(builder.simulation(t_end=2e-6, dt=1e-6, scheme="rk4", start="quasi_static").build()))
    (beam,) = (body for body in view_record(run, {})["bodies"] if body["name"] == "beam")
    corners = np.frombuffer(base64.b64decode(beam["mesh"]["x"]), "<f4").reshape(-1, 4, 3)
    stresses = np.frombuffer(base64.b64decode(beam["stress"]["corners"]), "<f4").reshape(-1, len(corners), 4)
    x, y, z = np.moveaxis(corners, 2, 0)
    bent = force * (length - x) * y / (width * height**3) + aside * (length - x) * z / (height * width**3)
    expected = np.abs(pull / (width * height) - 12 * bent)
    np.testing.assert_allclose(stresses[0], expected, atol=1e-3 * expected.max())


def test_the_page_computes_von_mises(tmp_path: Path) -> None:
    """sqrt(((s1 - s2)^2 + (s2 - s3)^2 + (s3 - s1)^2) / 2) of the principal stresses, at every vertex of the rod."""
    run = simulate(load_model(generated_folder("spatial_slider_crank")), t_end=0.02)
    record = view_record(run, {})
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


def test_stresses_from_elsewhere_colour_a_surface() -> None:
    """von_mises of every sample and vertex, as `equilibrium_stresses(at=vertices)` gives them, linear in between."""
    run = simulate(load_model(generated_folder("spatial_slider_crank")), t_end=2e-4)
    corners = np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]])
    surface = {"vertices": corners, "triangles": [[0, 1, 2], [0, 1, 3]], "shapes": np.zeros((4, 3, 6))}
    mises = 1e6 * np.outer(run.t / run.t[-1], np.arange(4))
    record = view_record(run, {"rod": {**surface, "von_mises": mises}})
    rod = next(body for body in record["bodies"] if body["name"] == "rod")
    found = np.frombuffer(base64.b64decode(rod["stress"]["corners"]), "<f4").reshape(-1, 4)
    t = np.frombuffer(base64.b64decode(record["t"]))
    np.testing.assert_allclose(found, 1e6 * np.outer(t / run.t[-1], np.arange(4)), rtol=1e-5)
    assert record["stress"] == pytest.approx(3e6)
    for wrong, problem in ((mises[1:], "the run has"), (mises[:, 1:], r"\(samples, 4\)")):
        with pytest.raises(ModelError, match=problem):
            view_record(run, {"rod": {**surface, "von_mises": wrong}})


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
            Scene.from_dict(plain)
