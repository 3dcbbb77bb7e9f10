"""N-four-bar mechanism: windows side by side that share their uprights (IFToMM benchmark A02)."""

import math

from symgen.scene import Scene, SceneError, SceneRecord


def n_four_bar(windows: int = 2) -> SceneRecord:
    """2 N + 1 bars of 1 m and 1 kg, uprights vertical at the start, their tips moving at 1 m/s along x.

    Each time all bars lie in one line the mechanism has more than one freedom: a singular position.
    """
    if windows < 1:
        raise SceneError("windows", f"{windows} windows are no mechanism", "give at least 1")
    builder = Scene("n_four_bar", title=f"{windows} four-bar windows side by side").gravity(0, -9.81)
    builder.ground(markers={f"foot{k}": {"position": (k, 0)} for k in range(1, windows + 1)})
    _bar(builder, "upright0")
    builder.revolute("A0", "ground.origin", "upright0.origin")
    for k in range(1, windows + 1):
        _bar(builder, f"top{k}")
        _bar(builder, f"upright{k}")
        builder.revolute(f"B{k - 1}", f"upright{k - 1}.tip", f"top{k}.origin")
        builder.revolute(f"C{k}", f"top{k}.tip", f"upright{k}.tip")
        builder.revolute(f"A{k}", f"ground.foot{k}", f"upright{k}.origin")
    uprights = [f"upright{k}.theta" for k in range(windows + 1)]
    builder.initial(dict.fromkeys(uprights, math.pi / 2)).rates(dict.fromkeys(uprights, -1.0))
    return builder.simulation(t_end=10.0, dt=1e-3, scheme="single_rate", seen_every=0.01).build()


def _bar(builder: Scene, name: str) -> None:
    builder.rigid(name, mass=1.0, inertia="1 / 12", center_of_mass=(0.5, 0), markers={"tip": {"position": (1, 0)}})
