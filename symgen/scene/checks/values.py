"""Values: every expression parses, is finite at the parameters' defaults, and has the sign it must have."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from symgen.scene.parts import SceneParts
from symgen.scene.translate import SECTIONS, item_path
from symgen.schema.errors import SceneError
from symgen.schema.expression_values import table_name
from symgen.schema.expressions import parse_expression
from symgen.schema.fields import Bound, Meaning, Scope, quantities


def value_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Expressions that do not parse, have no finite value at t = 0, or a value of the wrong sign."""
    reader = _QuantityCheck(scene)
    for path, value, meaning in scene_quantities(scene):
        try:
            reader.check(path, value, meaning)
        except SceneError as error:
            yield error


def scene_quantities(scene: SceneParts) -> Iterator[tuple[str, float | str, Meaning]]:
    """Every quantity of the scene: (item path, value, meaning)."""
    for path, value, meaning in quantities(scene, "scene"):
        yield path.removeprefix("scene."), value, meaning
    for section in SECTIONS:
        for index, entry in enumerate(getattr(scene, section)):
            yield from quantities(entry, item_path(section, index, entry.name))


WORD = re.compile(r"[A-Za-z]\w*")


class _QuantityCheck:
    def __init__(self, scene: SceneParts) -> None:
        self.switched = scene.switched_parameters()
        self.defaults, inputs = scene.parameter_defaults(), scene.input_defaults()
        tables = {table_name(name): table.value for name, table in scene.tables.items()}
        self.known: dict[str, Any] = {**self.defaults, **inputs, **tables, "t": 0.0}
        states = [name for state in scene.states for name in (state, f"{state}_dot")]
        self.states = frozenset(states)
        measured = [name for measure in scene.measures for name in (measure.name, f"{measure.name}_dot")]
        self.names = {
            Scope.PARAMETERS: frozenset((*self.defaults, *tables)),
            Scope.TIME: frozenset((*self.defaults, *inputs, *tables, "t")),
            Scope.MEASURES: frozenset((*self.defaults, *inputs, *tables, "t", *measured, *states)),
            Scope.LINE: frozenset((*self.defaults, *inputs, *tables, "t", *measured, *states, "length", "rate")),
            Scope.STATES: frozenset((*self.defaults, *inputs, *tables, "t", *measured, *scene.states)),
        }

    def check(self, path: str, value: float | str, meaning: Meaning) -> None:
        if meaning.scope is Scope.TIME and isinstance(value, str) and self.states & set(WORD.findall(value)):
            raise SceneError(
                path, "uses a state, which would have to be driven by the mechanism's own motor",
                "let an input with rates or a filter give the motion, or a load in place of the motion",
            )  # fmt: skip
        if meaning.scope is Scope.PARAMETERS and isinstance(value, str):
            for name in sorted(self.switched & set(WORD.findall(value))):
                raise SceneError(
                    path, f"uses '{name}', which an event sets during the run, and must stay as it is",
                    "let the expression of a load use it, or name another parameter here",
                )  # fmt: skip
        expression = parse_expression(value, self.names[meaning.scope], path)
        if not expression.names <= self.known.keys():
            return  # it uses measures, whose values are not known before the motion is
        number = expression.evaluate(self.known)
        wrong = {Bound.ANY: False, Bound.POSITIVE: number <= 0, Bound.NON_NEGATIVE: number < 0}[meaning.bound]
        if wrong:
            shown = f"{number!r}" if not isinstance(value, str) else f"'{value[:60]}' = {number!r}"
            raise SceneError(
                path, f"the {meaning.description} {shown} must be {meaning.bound.value}",
                f"give a value in {meaning.unit} that is {meaning.bound.value}",
            )  # fmt: skip
