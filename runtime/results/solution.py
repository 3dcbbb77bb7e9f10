"""Where pickles of solutions of version 0.4 and older lead: they are refused."""

from runtime.contract.errors import ModelError


def __getattr__(name: str) -> None:
    if name.startswith("__"):
        raise AttributeError(name)
    remedy = "run again, and keep runs by `run.save`"
    raise ModelError("this pickle of a solution", "was written by an older version", remedy)
