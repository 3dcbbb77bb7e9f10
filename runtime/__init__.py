"""Steps generated models through time. Knows nothing of SymPy or of how the equations were derived."""

from runtime.augmented import augmented_solution
from runtime.initial import InitialStateError
from runtime.loading import load_model
from runtime.model import Group, Model, ModelError
from runtime.reference import reference_solution
from runtime.schemes.catalogue import SCHEMES
from runtime.schemes.options import Options, SchemeError
from runtime.simulate import resume, simulate
from runtime.solution import Solution
from runtime.status import Status

__all__ = ["SCHEMES", "Group", "InitialStateError", "Model", "ModelError", "Options", "SchemeError", "Solution",
           "Status", "augmented_solution", "load_model", "reference_solution", "resume", "simulate"]
