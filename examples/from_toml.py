"""A scene from TOML text: read, check, derive, simulate, and what an error looks like."""

import sys
from pathlib import Path

from runtime import plots
from symgen.scene import SceneError, SceneRecord

TEXT = """
name = "swing"
gravity = [0.0, -9.81]
parameters.length = { default = 0.8, unit = "m" }

[[bodies]]
type = "rigid"
name = "rod"
mass = 2.0
inertia = "2.0 * length**2 / 12"
center_of_mass = ["length / 2", 0.0]
markers.tip = { position = ["length", 0.0] }

[[joints]]
type = "revolute"
name = "hinge"
marker_a = "ground.origin"
marker_b = "rod.origin"
damping = 0.05

[[measures]]
type = "y"
name = "height"
of = "rod.tip"

[initial.coordinates]
"rod.theta" = -0.3

[simulation]
t_end = 2.0
scheme = "single_rate"
seen_every = 0.05
"""


def main(picture: Path | None = None) -> None:
    """The scene survives the way to TOML and back; a misspelt key is refused with a suggestion."""
    scene = SceneRecord.from_toml_text(TEXT)
    assert SceneRecord.from_toml_text(scene.to_toml()) == scene
    solution = scene.model().simulate()
    for t in (0.0, 0.5, 1.0, 1.5, 2.0):
        print(f"t = {t:.1f} s   height {solution.interpolate(t, 'height'): .4f} m")
    try:
        SceneRecord.from_toml_text(TEXT.replace("mass = 2.0", "mas = 2.0"))
    except SceneError as error:
        print(error)
    if picture:
        plots.snapshots(solution, picture, instants=[0.0, 0.1, 0.2, 0.3, 0.4, 0.5], traces=["rod.tip"])


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
