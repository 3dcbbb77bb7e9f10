"""Binaries of FMUs for other platforms run here, by wine and qemu, with the bits of this one; skipped without them."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import pytest

from runtime.export.c_bundle import exported
from runtime.export.fmu import PLATFORMS, this_platform, write_fmu
from runtime.model import Model
from symgen.scene import SceneRecord
from tests.export.test_c_rigid_stops import links

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
ARM = "/usr/aarch64-linux-gnu"  # Debian: libc6-arm64-cross
HOW = {  # Debian: wine64, qemu-user-static
    "win64": shutil.which("wine") and ["wine"],
    "aarch64": Path(ARM).exists() and shutil.which("qemu-aarch64-static") and ["qemu-aarch64-static", "-L", ARM],
}
pytestmark = [
    pytest.mark.long,
    pytest.mark.skipif(find_spec("ziglang") is None or this_platform() != "linux64", reason="no zig, or not Linux"),
]


@pytest.mark.parametrize(
    "platform",
    [pytest.param(name, marks=pytest.mark.skipif(not run, reason=f"nothing runs {name}")) for name, run in HOW.items()],
)
@pytest.mark.parametrize(("scene", "steps", "dt"), [("links", 300, 0.005), ("flexible_slider_crank_free", 500, 1e-4)])
def test_other_platforms_have_the_bits_of_this_one(
    built_in: Load, model_of: Build, tmp_path: Path, scene: str, steps: int, dt: float, platform: str
) -> None:
    """All outputs, across impacts, sticking and jumps, and of a flexible mechanism with a loop."""
    rubs = links().simulation(t_end=1.5, dt=dt, scheme="rk4")
    model = model_of(rubs.build()) if scene == "links" else built_in(scene)
    one = exported(model, dt=dt)
    written = write_fmu(one, tmp_path / "unit.fmu", 2, ["linux64", platform])
    assert not written.missing
    with zipfile.ZipFile(written.path) as unit:
        unit.extractall(tmp_path)
    token = re.findall(r'guid="(\w+)"', (tmp_path / "modelDescription.xml").read_text())[0]
    zig, source = [sys.executable, "-m", "ziglang", "cc", "-w"], str(Path(__file__).parent / "drive_fmu.c")
    found, own = {}, os.environ | {"ZIG_GLOBAL_CACHE_DIR": str(Path(tempfile.gettempdir()) / "symgen-zig")}
    own |= {"WINEPREFIX": str(Path(tempfile.gettempdir()) / "symgen-wine"), "WINEDEBUG": "-all"}
    for name in ("linux64", platform):
        target, program = PLATFORMS[name], tmp_path / f"drive.{name}.exe"
        subprocess.run([*zig, "-target", target.target, source, "-o", str(program)], cwd=tmp_path, check=True, env=own)
        library = f"binaries/{target.second}/{one.prefix[:-1]}.{target.ending}"
        runs = [*(HOW.get(name) or []), str(program), library, token, str(steps), repr(dt)]
        done = subprocess.run(
            [*runs, str(1 + len(one.p)), str(len(one.outputs))], cwd=tmp_path, capture_output=True, text=True,
            env=own,
        )  # fmt: skip
        assert done.returncode == 0, done.stdout + done.stderr
        found[name] = done.stdout.split()
    assert found["linux64"] == found[platform] and len(found[platform]) == 2 * len(one.outputs)
