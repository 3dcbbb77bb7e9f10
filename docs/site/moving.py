"""Pages of examples that move: the scene that a script builds, run as the scene says."""

import runpy
import tempfile
from dataclasses import dataclass
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


@dataclass(frozen=True)
class Moving:
    """How an example is shown: until when it is run [s], the moment and view of the page; scene: a built-in one."""

    state: str
    t_end: float | None = None
    scene: str = ""


STRESS = "with=colour%3A%20stress"
FRONT = Moving("t=0.06", 0.3, "flexible_slider_crank_torque")
MOVING = {
    "build_slider_crank": Moving(f"t=0.045&{STRESS}", 0.1),
    "five_bar_robot": Moving("t=0.3&trace=tool.origin"),
    "quick_return": Moving("t=0.2&trace=rocker.end"),
    "double_wishbone": Moving("t=1.6"),
    "gyroscope": Moving("t=0.4&trace=disk.hub"),
    "spinning_satellite": Moving("t=2", 10.0),
    "mesh_connecting_rod": Moving(f"t=0.02&{STRESS}", 0.105, "spatial_slider_crank"),
}


def write(name: str, path: Path, moving: Moving) -> None:
    """Run the example's scene and write its page."""
    from runtime import load_model, simulate
    from symgen.generate import generate
    from symgen.scenes import generated_folder

    with tempfile.TemporaryDirectory() as folder:
        if moving.scene:
            model = load_model(generated_folder(moving.scene))
        else:
            model = load_model(generate(runpy.run_path(str(EXAMPLES / f"{name}.py"))["build"](), folder))
        simulate(model, t_end=moving.t_end).view(path)
