"""Steps generated models through time. Knows nothing of SymPy or of how the equations were derived.

The packages, from what everything stands on to what stands on everything:

    contract    what both halves share: an emitted model, its names, units and formats
    engine      straight-line programs, interpreted or compiled
    schemes     time stepping schemes as such programs, baselines included
    results     what is kept of a run and computed from it
    operating   equilibria, steady motion, and the linear systems about them
    views       what people look at
    solutions   the result of a run as users have it
    start       where a motion starts
    baselines   established integrators on the same equations
    running     a run: its loop, its checks, singular positions, checkpoints
    export      a model handed on: plain C, FMUs, JAX
    gradients   derivatives of a run, and fits by them
    orbits      motions that repeat: shooting, Floquet, branches, sensitivity
    studies     many runs: ensembles, stability, work-precision, advice
    model       the model as users have it

The names below are public; each is imported when it is first asked for.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from runtime.baselines.scipy_methods import reference_solution
    from runtime.contract.consistent_state import InitialStateError
    from runtime.contract.errors import ArgumentError, ModelError, NoResult, SymgenError
    from runtime.contract.files import OutputError
    from runtime.contract.records import Group
    from runtime.contract.status import Status
    from runtime.gradients.differentiable_run import DifferentiableRun, gradient, output_jacobian
    from runtime.gradients.fit import fit
    from runtime.gradients.run_in_jax import as_jax
    from runtime.gradients.run_in_torch import as_torch
    from runtime.model import Model, load_model
    from runtime.operating.campbell import campbell
    from runtime.operating.equilibrium import Equilibrium, NoEquilibrium, equilibrium
    from runtime.operating.linearisation import Linearisation
    from runtime.operating.linearise import linearise
    from runtime.operating.modes import modes
    from runtime.operating.unbalance import unbalance_response
    from runtime.orbits.continuation import periodic_over
    from runtime.orbits.periodic import periodic
    from runtime.running.driven import quasi_static_motion
    from runtime.running.inputs import Sampled
    from runtime.running.resume import resume
    from runtime.running.simulate import simulate
    from runtime.schemes.catalogue import SCHEMES
    from runtime.schemes.options import Options, SchemeError
    from runtime.solutions.mode_motion import mode_motion
    from runtime.solutions.solution import Solution
    from runtime.studies.ensemble.ensemble import ensemble
    from runtime.views import animation, plots

__all__ = [
    "SCHEMES",
    "ArgumentError",
    "DifferentiableRun",
    "Equilibrium",
    "Group",
    "InitialStateError",
    "Linearisation",
    "Model",
    "ModelError",
    "NoEquilibrium",
    "NoResult",
    "Options",
    "Sampled",
    "OutputError",
    "SchemeError",
    "Solution",
    "Status",
    "SymgenError",
    "animation",
    "as_jax",
    "as_torch",
    "campbell",
    "ensemble",
    "equilibrium",
    "fit",
    "gradient",
    "linearise",
    "load_model",
    "mode_motion",
    "modes",
    "output_jacobian",
    "periodic",
    "periodic_over",
    "plots",
    "quasi_static_motion",
    "reference_solution",
    "resume",
    "simulate",
    "unbalance_response",
]

_HOMES = {
    "reference_solution": "baselines.scipy_methods",
    "InitialStateError": "contract.consistent_state",
    "ArgumentError": "contract.errors",
    "NoResult": "contract.errors",
    "SymgenError": "contract.errors",
    "OutputError": "contract.files",
    "load_model": "model",
    "Group": "contract.records",
    "Model": "model",
    "ModelError": "contract.errors",
    "Status": "contract.status",
    "DifferentiableRun": "gradients.differentiable_run",
    "fit": "gradients.fit",
    "as_jax": "gradients.run_in_jax",
    "as_torch": "gradients.run_in_torch",
    "gradient": "gradients.differentiable_run",
    "output_jacobian": "gradients.differentiable_run",
    "Equilibrium": "operating.equilibrium",
    "NoEquilibrium": "operating.equilibrium",
    "equilibrium": "operating.equilibrium",
    "Linearisation": "operating.linearisation",
    "linearise": "operating.linearise",
    "modes": "operating.modes",
    "campbell": "operating.campbell",
    "mode_motion": "solutions.mode_motion",
    "unbalance_response": "operating.unbalance",
    "periodic": "orbits.periodic",
    "periodic_over": "orbits.continuation",
    "Solution": "solutions.solution",
    "quasi_static_motion": "running.driven",
    "Sampled": "running.inputs",
    "resume": "running.resume",
    "SCHEMES": "schemes.catalogue",
    "Options": "schemes.options",
    "SchemeError": "schemes.options",
    "simulate": "running.simulate",
    "ensemble": "studies.ensemble.ensemble",
    "plots": "views",
    "animation": "views",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'runtime' has no attribute {name!r}")
    if _HOMES[name] == "views":
        return import_module(f"runtime.views.{name}")
    return getattr(import_module(f"runtime.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
