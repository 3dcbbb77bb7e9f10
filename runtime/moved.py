"""Modules that users imported by an older path: they are found at the new one, with a warning, for one release."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Sequence
from importlib import import_module
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

# as documented up to version 0.3
MOVED = {
    "runtime.advice.advise": "runtime.studies.advice.advise",
    "runtime.animation": "runtime.views.animation",
    "runtime.compare.contender": "runtime.studies.work_precision.prepared_method",
    "runtime.export": "runtime.results.export",
    "runtime.loading": "runtime.contract.loading",
    "runtime.model": "runtime.contract.model",
    "runtime.modes.modes": "runtime.operating.mode_solver",
    "runtime.opponents": "runtime.baselines",
    "runtime.plots": "runtime.views.plots",
    "runtime.reference": "runtime.baselines.reference",
    "runtime.report": "runtime.views.report",
    "runtime.running.stream": "runtime.results.stream",
    "runtime.simulate": "runtime.running.simulate",
    "runtime.solution": "runtime.results.solution",
    "runtime.stability.chart": "runtime.studies.stability.chart",
    "runtime.stability.modes": "runtime.operating.mode_solver",
    "runtime.stability.spectrum": "runtime.studies.stability.spectrum",
    "runtime.status": "runtime.contract.status",
    "runtime.stepper": "runtime.schemes.stepper",
}
# classes whose names changed: by the module that had them, old name -> (module, name)
RENAMED = {
    "runtime.compare.contender": {"Contender": ("runtime.studies.work_precision.prepared_method", "PreparedMethod")},
    "runtime.status": {"NoResult": ("runtime.contract.errors", "NoResult")},
}
PARENTS = frozenset(name.rpartition(".")[0] for name in MOVED if name.count(".") > 1) - {"runtime.running"}


class _CallablePackage(ModuleType):
    """The empty package `runtime.modes`, which must not hide the function of that name once it is imported."""

    def __call__(self, *arguments: Any, **named: Any) -> Any:
        return import_module("runtime.operating.modes").modes(*arguments, **named)


class _Redirect(MetaPathFinder, Loader):
    """Finds the modules of MOVED, and empty packages where they stood."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if fullname in MOVED or fullname in PARENTS:
            return ModuleSpec(fullname, self, is_package=fullname in PARENTS)
        return None

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        if spec.name in PARENTS:
            return _CallablePackage(spec.name) if spec.name == "runtime.modes" else None
        new = MOVED[spec.name]
        warnings.warn(f"{spec.name} is {new} since 0.4; the old name goes with 0.5", DeprecationWarning, stacklevel=2)
        module = import_module(new)
        for old, (home, name) in RENAMED.get(spec.name, {}).items():
            setattr(module, old, getattr(import_module(home), name))
        self._spec = module.__spec__
        return module

    def exec_module(self, module: ModuleType) -> None:
        if module.__name__ not in PARENTS:  # the import system has put the old spec on the module of the new name
            module.__spec__ = self._spec


def redirect() -> None:
    """Let the old paths be imported. Once a process."""
    if not any(isinstance(finder, _Redirect) for finder in sys.meta_path):
        sys.meta_path.append(_Redirect())
