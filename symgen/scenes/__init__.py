"""Built-in scenes, one file each. `SCENES` maps a name to a function that returns the Scene."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from symgen.scene import Scene
from symgen.scenes.bricard import bricard
from symgen.scenes.chain import chain
from symgen.scenes.double_pendulum import double_pendulum
from symgen.scenes.elastic_pendulum import elastic_pendulum
from symgen.scenes.flexible_four_bar import flexible_four_bar
from symgen.scenes.flexible_joint_arm import flexible_joint_arm
from symgen.scenes.flexible_slider_crank import (
    flexible_slider_crank,
    flexible_slider_crank_free,
    flexible_slider_crank_torque,
    physical_slider_crank,
    stiff_slider_crank,
)
from symgen.scenes.flyball_governor import flyball_governor
from symgen.scenes.four_bar import four_bar
from symgen.scenes.heavy_top import heavy_top
from symgen.scenes.hub_beam import hub_beam
from symgen.scenes.n_four_bar import n_four_bar
from symgen.scenes.near_singular_slider_crank import near_singular_slider_crank
from symgen.scenes.overdamped_joint import overdamped_joint
from symgen.scenes.pendulum import pendulum
from symgen.scenes.slider_crank import slider_crank
from symgen.scenes.spatial_chain import spatial_chain
from symgen.scenes.spatial_slider_crank import spatial_slider_crank
from symgen.scenes.spin_up_beam import spin_up_beam
from symgen.scenes.tumbling_body import tumbling_body
from symgen.scenes.two_oscillators import two_oscillators

SCENES: dict[str, Callable[..., Scene]] = {
    function.__name__: function
    for function in (
        pendulum,
        double_pendulum,
        elastic_pendulum,
        four_bar,
        slider_crank,
        flexible_slider_crank,
        flexible_slider_crank_free,
        flexible_slider_crank_torque,
        hub_beam,
        spin_up_beam,
        chain,
        two_oscillators,
        physical_slider_crank,
        stiff_slider_crank,
        near_singular_slider_crank,
        flexible_four_bar,
        flexible_joint_arm,
        overdamped_joint,
        n_four_bar,
        heavy_top,
        tumbling_body,
        bricard,
        flyball_governor,
        spatial_chain,
        spatial_slider_crank,
    )
}


def kept_folder(name: str) -> Path:
    """What the repository keeps of a built-in scene, beside this package: without its code where that is large."""
    return Path(__file__).resolve().parents[2] / "generated" / name


def generated_folder(name: str) -> Path:
    """Folder of the emitted code of a built-in scene; a large one is generated into the cache on first use."""
    folder = kept_folder(name)
    if (folder / "model.py").is_file():
        return folder
    from symgen.generate import completed  # brings in SymPy

    return completed(SCENES[name](), folder)
