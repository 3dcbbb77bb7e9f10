"""The parameters of a model as a list that prints those which somebody would change."""

from __future__ import annotations

from runtime.contract.records import Parameter


class ParameterList(list[Parameter]):
    """In the order of p; printed without the numbers of shapes, tables and meshes."""

    def __repr__(self) -> str:
        own = [one for one in self if one.kind != "data" and not one.array]
        width = max((len(one.name) for one in own), default=0)
        lines = [f"{one.name:<{width}}  {one.default:<12.9g} {one.unit:<8} {one.meaning}".rstrip() for one in own]
        hidden = len(self) - len(own)
        return "\n".join(
            [*lines, *([f"and {hidden} numbers of shapes, tables and meshes (kind data)"] if hidden else [])]
        )
