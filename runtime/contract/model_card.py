"""A model in a notebook: coordinates, partition, joints, measures, constraints, operations, parameters."""

from __future__ import annotations

from runtime.contract.cards import card, fold, table
from runtime.contract.records import Description


def model_card(described: Description, sketch: str = "") -> str:
    """HTML of a model's description; sketch: a drawing of it, as SVG."""
    elastic = sum(entry.elastic for entry in described.coordinates)
    about = (
        f"{described.name}: {len(described.coordinates)} coordinates, {elastic} elastic, "
        f"{len(described.q_i)} independent, {len(described.constraints)} constraints"
    )
    rows = [("bodies", ", ".join(f"{body.name} ({body.type})" for body in described.bodies))]
    rows += [("joints", ", ".join(f"{joint.name} ({joint.type})" for joint in described.joints))]
    rows += [("loads", ", ".join(f"{load.name} ({load.type})" for load in described.loads))]
    rows += [("measures", ", ".join(f"{entry.name} [{entry.unit}]" for entry in described.measures))]
    rows += [
        (f"group {group.name}", ", ".join(described.q_i[k] for k in group.positions)) for group in described.groups
    ]
    rows += [("solved by Newton", ", ".join(described.loop_unknowns))]
    operations = [(f.name, str(f.operations), f.meaning) for f in described.functions]
    shown = [entry for entry in described.parameters if entry.kind != "data"]
    parameters = [(entry.name, f"{entry.default:.6g}", entry.unit, entry.meaning) for entry in shown]
    return card(
        described.title or described.name,
        about,
        sketch,
        table([row for row in rows if row[1]]),
        fold(f"{len(parameters)} parameters", table(parameters, ("name", "default", "unit", "meaning"))),
        fold(f"{len(operations)} functions", table(operations, ("function", "operations", "what it gives"))),
    )
