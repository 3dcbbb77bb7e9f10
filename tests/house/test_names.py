"""The tables of names: what the code has is in them, and what is in them the code has."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Callable
from pathlib import Path

from benchmarks.scenes.arm import arm
from runtime import SCHEMES
from runtime.model import Model
from runtime.schemes.stage_equations import LinearisedEquations
from symgen.notation.fields import FIELDS
from symgen.notation.symbols import SYMBOLS, Notation, table
from symgen.scene import Scene, SceneRecord

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "theory" / "names.md"
LAST_EQUATION = 72

Load = Callable[[str], Model]
# with loops, groups, bodies in space, and none of them
MODELS = ("flexible_slider_crank", "flyball_governor", "two_oscillators", "chain")


def codes(entries: tuple[Notation, ...]) -> set[str]:
    return {entry.code for entry in entries}


def words_of_the_code() -> set[str]:
    sources = [
        path
        for folder in ("symgen", "runtime", "generated")
        for path in (ROOT / folder).rglob("*.py")
        if path.parent.name != "notation"
    ]
    return {word for path in sources for word in re.findall(r"[A-Za-z_]\w*", path.read_text(encoding="utf-8"))}


def emitted_names(model: Model) -> set[str]:
    """Inputs and outputs of every emitted function."""
    kernels = [model.kernel(name) for name in model.builders]
    return {name for kernel in kernels for name in (*kernel.name_in(), *kernel.name_out())}


def fields_of_z(model: Model) -> set[str]:
    """Fields of every scheme that the model can be stepped with, for every word of every option."""
    found: set[str] = set()
    for name, kind in SCHEMES.items():
        choices = [{}]
        if "order" in kind.options.names():
            choices.append({"order": 5})
        if "tolerance" in kind.options.names():
            choices.append({"tolerance": 1e-3})
        for options in choices:
            scheme = kind.build(name, model, 1.0, None, options)
            found |= set(scheme.layout.sizes)
    return found


def test_entries_stand_once_and_cite_equations_that_exist() -> None:
    for entries in (SYMBOLS, FIELDS):
        assert len(codes(entries)) == len(entries)
        for entry in entries:
            cited = [int(number) for number in re.findall(r"\d+", entry.equation)]
            assert all(1 <= number <= LAST_EQUATION for number in cited), entry.code
            assert bool(cited) == bool(entry.paper), entry.code
            assert entry.shape and entry.unit and entry.meaning


def test_symbols_are_names_of_the_code() -> None:
    """Vectors of a template stand there by components: M_Rtheta is M_Rtheta_x and M_Rtheta_y."""
    words = words_of_the_code()
    assert not {code for code in codes(SYMBOLS) if not {code, f"{code}_x"} & words}


def test_emitted_names_are_symbols(built_in: Load) -> None:
    """Every input and output of every function of planar and spatial scenes is in the table."""
    for scene in (*MODELS, "bricard", "n_four_bar", "spin_up_beam", "heavy_top"):
        assert not emitted_names(built_in(scene)) - codes(SYMBOLS), scene


def test_blocks_of_the_mass_matrix_are_symbols() -> None:
    """Of a body, and those of the linearised equations."""
    found = {field.name for field in dataclasses.fields(LinearisedEquations)} - {"a"}
    for name in ("planar_body", "spatial_body"):
        text = (ROOT / "symgen" / "bodies" / f"{name}.py").read_text(encoding="utf-8")
        found |= set(re.findall(r"\bM_[A-Za-z]+\b", text))
    assert not found - codes(SYMBOLS), found - codes(SYMBOLS)


def test_fields_of_z_are_the_table(built_in: Load, model_of: Callable[[SceneRecord], Model]) -> None:
    """Both ways: every field of every scheme is in the table, and every entry is a field of some scheme."""
    pushed = Scene("pushed").input("push").rigid("block", mass=1.0, inertia=1.0, free=True)
    pushed.measure("x", "x", of="block.origin").force("force", "block.origin", "push + step(x - 1)", 0.0)
    pushed.event("late", "t - 1", action={"push": 1.0}, cool_down=1.0)
    models = [*(built_in(name) for name in MODELS), model_of(pushed.build()), model_of(arm(10))]
    found = set().union(*map(fields_of_z, models))
    assert not emitted_names(models[-1]) - codes(SYMBOLS)
    found |= set(SCHEMES["rk4"].build("rk4", built_in("heavy_top"), 1e-3, None, {}).layout.sizes)
    assert not (found ^ codes(FIELDS)), found ^ codes(FIELDS)


def test_the_page_of_names_holds_the_table() -> None:
    assert table(SYMBOLS) in PAGE.read_text(encoding="utf-8")
