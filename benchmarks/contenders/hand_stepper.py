"""The hand-written C stepper of hand_c/slider_crank.c, compiled like the generated one and run on the same state."""

from __future__ import annotations

import ctypes
from pathlib import Path

import numpy as np

from benchmarks.cases import scenes
from benchmarks.contenders.by_c_compiler import compile_source
from runtime.engine.program import Layout

SOURCE = Path(__file__).parent / "hand_c" / "slider_crank.c"
# fields of the C struct State, and where they are in the scheme's z
FIELDS = ("x", "d", "a", "q_L", "q_L_dot", "q_L_ddot", "s", "loop", "loop_old", "loop_dot", "closure_error", "n")
SLOW_ONLY = ("q_L", "q_L_dot", "q_L_ddot")


class HandStepper:
    """Major steps of the two-mode slider-crank by hand-written C."""

    name = "hand-written C"

    def __init__(self, layout: Layout, major_step: float, ratio: int) -> None:
        self._places = np.concatenate([_places(layout, name) for name in FIELDS])
        self._data = _data(major_step, ratio)
        library = compile_source(SOURCE.read_text(encoding="utf-8"))
        self._run = ctypes.CDLL(str(library)).run
        self._run.argtypes = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_long)
        self._run.restype = None

    def state(self, z: np.ndarray) -> np.ndarray:
        """State of the C stepper from the z of the scheme."""
        return np.ascontiguousarray(z[self._places])

    def run(self, state: np.ndarray, n: int) -> None:
        """n major steps in place."""
        self._run(state.ctypes.data, self._data.ctypes.data, n)


def _places(layout: Layout, name: str) -> np.ndarray:
    part = layout.slice(name)
    return np.arange(part.start, part.start + 1 if name in SLOW_ONLY else part.stop)


def _data(major_step: float, ratio: int) -> np.ndarray:
    rod = scenes.pinned_rod()
    crank = scenes.CRANK_INERTIA + scenes.CRANK_MASS * scenes.CRANK_CENTER**2 + rod["mass"] * scenes.CRANK_LENGTH**2
    e1, e2 = rod["rho_cross_phi"]
    K1, K2 = np.diag(rod["K_ff"])
    return np.array(
        [
            scenes.CRANK_LENGTH,
            scenes.ROD_LENGTH,
            rod["first_moment"][0],
            rod["phi_integral"][1, 0],
            e1,
            e2,
            rod["M_ff"][0, 0],
            rod["inertia"],
            crank,
            scenes.SLIDER_MASS,
            K1,
            K2,
            major_step,
            major_step / ratio,
            ratio - 1,
        ]
    )
