"""One family of errors: what a user can mend is a SymgenError, and nothing else is taken for the user's mistake."""

from __future__ import annotations

import importlib
import inspect
import json
import pickle
import pkgutil

import pytest

import runtime
import symgen
from runtime import NoResult, SymgenError
from symgen.cli import main
from symgen.cli.table import COMMANDS
from symgen.scene import SceneError

# control flow within one file or two: caught there, never seen by a user
INTERNAL = {
    "BranchLost",
    "CannotCut",
    "EndlessInput",
    "NoInertia",
    "NotPositiveDefinite",
    "TooLarge",
    "UnknownInterface",
}


def exceptions() -> set[type]:
    """Every class of an exception that the project defines; warnings are none."""
    found = set()
    for package in (runtime, symgen):
        for module in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            if module.name.endswith("__main__"):
                continue
            members = vars(importlib.import_module(module.name)).values()
            found |= {one for one in members if inspect.isclass(one) and issubclass(one, BaseException)}
    own = {one for one in found if one.__module__.partition(".")[0] in ("runtime", "symgen")}
    return {one for one in own if not issubclass(one, Warning)}


def test_all_errors_are_of_one_family() -> None:
    found = exceptions()
    assert {one.__name__ for one in found if not issubclass(one, SymgenError)} == INTERNAL
    assert len(found) > 12


def test_an_error_says_item_problem_and_remedy() -> None:
    error = SceneError("bodies[2] 'rod'.density", "is negative", "give a positive density")
    assert str(error) == "bodies[2] 'rod'.density: is negative; give a positive density"
    again = pickle.loads(pickle.dumps(error))  # as tests and workers send it
    assert (again.item, again.problem, again.remedy, again.also) == (error.item, error.problem, error.remedy, ())
    assert isinstance(error, ValueError) and isinstance(NoResult("nothing"), RuntimeError)


@pytest.mark.parametrize(
    ("raised", "code"),
    [
        (ValueError("a number of ours"), 3),
        (KeyError("gone"), 3),
        (OSError(5, "broken"), 3),
        (SymgenError("x", "is wrong", "correct it"), 2),
        (NoResult("it does not converge"), 1),
    ],
)
def test_a_fault_of_ours_is_not_called_the_users(monkeypatch, capsys, raised: Exception, code: int) -> None:
    def broken(arguments: object) -> None:
        raise raised

    monkeypatch.setitem(COMMANDS, "list", (broken, ()))
    assert main(["list", "--json"]) == code
    captured = capsys.readouterr()
    error = json.loads(captured.out)["error"]
    assert error["kind"] == type(raised).__name__
    assert ("in broken" in error.get("traceback", "")) == (code == 3)  # where it broke
    assert ("please report" in captured.err) == (code == 3)
    assert ("Traceback" in captured.err) == (code == 3)
