"""Frequencies along a speed or parameter: crossings, veering, whirl, unbalance, against exact figures."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from runtime import ModelError, NoResult, campbell, modes, unbalance_response
from runtime.model import Model
from runtime.views.plots import campbell_picture
from symgen.scene import Scene, SceneRecord
from tests.support.rotor_scenes import gimbal, jeffcott

Build = Callable[[SceneRecord], Model]


def two_sliders(coupling: float) -> SceneRecord:
    """1 kg on k_1 = stiff and 1 kg on 100 N/m, on two rails, joined by a weak spring."""
    return (
        Scene("two_sliders")
        .parameter("stiff", 50.0, "N/m", "stiffness of the first")
        .parameter("joint", coupling, "N/m", "stiffness between them")
        .rigid("first", mass=1.0, inertia=1.0)
        .rigid("second", mass=1.0, inertia=1.0)
        .prismatic("rail1", "ground.origin", "first.origin")
        .prismatic("rail2", "ground.origin", "second.origin")
        .measure("a", "x", of="first.origin")
        .measure("b", "x", of="second.origin")
        .force("spring1", "first.origin", "-stiff * a - joint * (a - b)", 0.0)
        .force("spring2", "second.origin", "-100 * b - joint * (b - a)", 0.0)
        .build()
    )


def test_modes_cross(model_of: Build) -> None:
    """Exact: without coupling the frequencies are sqrt(stiff) and 10, and cross; each keeps its column."""
    values = np.linspace(50.0, 150.0, 8)
    found = campbell(model_of(two_sliders(0.0)), "stiff", values)
    np.testing.assert_allclose(found.frequencies[:, 0], np.sqrt(values), rtol=1e-12)
    np.testing.assert_allclose(found.frequencies[:, 1], 10.0, rtol=1e-12)
    assert found.names == ["first.x", "second.x"]
    assert found.remarks() == modes(model_of(two_sliders(0.0))).remarks() == []


@pytest.mark.parametrize("points", [4, 41])
def test_modes_veer(model_of: Build, points: int) -> None:
    """Exact: coupled, w^2 = s/2 -+ sqrt(d^2/4 + g^2) with s, d sum and difference; shapes exchange, columns do not."""
    values, g = np.linspace(50.0, 150.0, points), 3.0
    found = campbell(model_of(two_sliders(g)), "stiff", values)
    total, apart = values + 100.0 + 2 * g, values - 100.0
    for column, sign in ((0, -1), (1, 1)):
        exact = np.sqrt(total / 2 + sign * np.sqrt(apart**2 / 4 + g**2))
        np.testing.assert_allclose(found.frequencies[:, column], exact, rtol=1e-12)


def test_whirl_along_the_speed(model_of: Build) -> None:
    """Exact: backward and forward whirl sqrt(a^2 + k / I_t) -+ a; forward stays above the speed where I_p > I_t."""
    k, I_t, I_p = 45.0, 0.02, 0.03
    speeds = np.linspace(0.0, 200.0, 41)
    found = campbell(model_of(gimbal(k, 30.0)), "spin.omega", speeds)
    a = I_p * speeds / (2 * I_t)
    rigid = found.names.index("rigid spin.angle")
    np.testing.assert_allclose(found.frequencies[:, rigid], 0.0)
    whirl = np.sort(np.delete(found.frequencies, rigid, axis=1)[1:], axis=1)
    root = np.sqrt(a**2 + k / I_t)[1:]
    np.testing.assert_allclose(whirl, np.stack([root - a[1:], root + a[1:]], axis=1), rtol=1e-9)
    columns = np.delete(found.frequencies, rigid, axis=1)
    assert sorted(np.sign(np.diff(columns[1:], axis=0)).sum(axis=0)) == [-39, 39]  # one falls, one rises, none swaps
    critical = [value for mode, value in found.crossings() if mode != rigid]
    exact = math.sqrt(k / (I_t + I_p))  # w = speed: I_t w^2 + I_p w^2 = k, backward
    assert len(critical) == 1 and critical[0] == pytest.approx(exact, rel=2e-3)


def test_the_line_of_the_speed_is_seen_beside_stiff_modes(model_of: Build) -> None:
    """Modes at 54,000 rad/s lie above the picture of speeds to 200 rad/s, which says so; the slow one stays."""
    stiff = campbell(model_of(gimbal(45.0, 30.0)), "spin.omega", np.linspace(0.0, 200.0, 5))
    high = replace(stiff, frequencies=stiff.frequencies + np.array([0.0, 0.0, 5.4e4])[np.argsort(stiff.frequencies[0])])
    (ax,) = campbell_picture(high).axes
    assert 200.0 < ax.get_ylim()[1] < 1000.0
    assert [text.get_text()[:13] for text in ax.texts] == ["1 mode above,"]


def test_steady_unbalance_response(model_of: Build) -> None:
    """Exact (Jeffcott): z = U W^2 / (k - m W^2 + i c W) turning with the disk, y a quarter of a turn behind x."""
    U, c = 2e-4, 8.0
    speeds = np.array([5.0, 20.0, 60.0])
    found = unbalance_response(
        model_of(jeffcott(c)), "disk.omega", speeds, at=("disk.x", "disk.y"), unbalance=U, outputs=["x", "y"]
    )
    exact = U * speeds**2 / (800 - 2 * speeds**2 + 1j * c * speeds)
    np.testing.assert_allclose(found.amplitudes[:, 0], exact, rtol=1e-12)
    np.testing.assert_allclose(found.amplitudes[:, 1], -1j * exact, rtol=1e-12)


def test_unbalance_of_what_nothing_holds(built_in: Callable[[str], Model], model_of: Build) -> None:
    """A free body turns about its centre of mass, U / m off; a critical speed without damping has no whirl."""
    body = built_in("tumbling_body")
    found = unbalance_response(body, "body.omega_z", [5.0, 80.0], at=("body.x", "body.y"), unbalance=1e-3)
    mass = next(one.default for one in body.parameters if one.name == "body.mass")
    np.testing.assert_allclose(found.amplitudes, np.tile([-1e-3 / mass, 1j * 1e-3 / mass], (2, 1)), rtol=1e-12)
    with pytest.raises(NoResult, match="at 20 rad/s: grows without bound"):
        unbalance_response(model_of(jeffcott(0.0)), "disk.omega", [20.0], at=("disk.x", "disk.y"), unbalance=1.0)


def test_files_and_errors(model_of: Build, tmp_path: Path) -> None:
    model = model_of(two_sliders(0.0))
    found = campbell(model, "stiff", [50.0, 60.0])
    found.write_csv(tmp_path / "campbell.csv")
    lines = (tmp_path / "campbell.csv").read_text().splitlines()
    assert lines[0].startswith("stiff,w1 [rad/s],w2 [rad/s],zeta1") and float(lines[2].split(",")[0]) == 60.0
    with pytest.raises(ModelError, match="no coordinate 'stif'"):
        campbell(model, "stif", [1.0])
    with pytest.raises(ValueError, match="at least one finite value"):
        campbell(model, "stiff", [])
    with pytest.raises(ModelError, match="no coordinate 'disk.z'"):
        unbalance_response(model, "stiff", [1.0], at=("disk.z", "first.x"), unbalance=1.0)
