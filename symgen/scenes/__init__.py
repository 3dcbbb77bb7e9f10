"""Built-in scenes, one file each. `SCENES` maps a name to a function that returns the Scene."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from symgen.scene import Scene
from symgen.scenes.chain import chain
from symgen.scenes.double_pendulum import double_pendulum
from symgen.scenes.elastic_pendulum import elastic_pendulum
from symgen.scenes.flexible_slider_crank import (
    flexible_slider_crank,
    flexible_slider_crank_free,
    flexible_slider_crank_torque,
)
from symgen.scenes.four_bar import four_bar
from symgen.scenes.hub_beam import hub_beam
from symgen.scenes.pendulum import pendulum
from symgen.scenes.slider_crank import slider_crank
from symgen.scenes.spin_up_beam import spin_up_beam
from symgen.scenes.two_oscillators import two_oscillators

SCENES: dict[str, Callable[..., Scene]] = {
    function.__name__: function
    for function in (
        pendulum, double_pendulum, elastic_pendulum, four_bar, slider_crank, flexible_slider_crank,
        flexible_slider_crank_free, flexible_slider_crank_torque, hub_beam, spin_up_beam, chain, two_oscillators,
    )
}


def generated_folder(name: str) -> Path:
    """Folder of the emitted code of a built-in scene, beside this package."""
    return Path(__file__).resolve().parents[2] / "generated" / name
