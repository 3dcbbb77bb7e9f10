"""Describe a mechanism with rigid and flexible bodies, get its equations and its motion.

    run = Scene("arm")...model().simulate(t_end=1.0)

Behind `Scene` is a compiler from scenes to straight-line code. Its stages are its folders, in this order: `scene`
(what is there), `system` (equations in all coordinates, with the topology), `choice` (dependent coordinates and
groups), `condensed` (the dependent ones substituted), `kernels` (named functions), `tapes` (straight-line code),
`emission` (files). Bodies, joints and loads state what a system is made of, in the `algebra` of templates; `modes`
and `fe` compute numbers for scenes; `urdf` reads robots; `scenes` are built in; `cli` is the command line, `schema`
what the text of scenes is made of. `pipeline.py` says the same with equation numbers, `notation` names the symbols.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from runtime.model import load_model
    from symgen.mechanism.builder import Scene
    from symgen.mechanism.scene import SceneRecord
    from symgen.schema.errors import SceneError

__all__ = ["Scene", "SceneError", "SceneRecord", "load_model"]

_HOMES = {
    "Scene": "symgen.mechanism.builder",
    "SceneError": "symgen.schema.errors",
    "SceneRecord": "symgen.mechanism.scene",
    "load_model": "runtime.model",
}


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("symgen")
    if name not in _HOMES:
        raise AttributeError(f"module 'symgen' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
