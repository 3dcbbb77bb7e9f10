"""Sines and cosines of angles that do not wait for each other, side by side in the lanes of one vector.

A sine with its cosine is some 45 instructions, more than all that is done with them on a planar link. In lanes they
have the same bits.
"""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from runtime.contract.tape import UNUSED, Node, below

WIDTHS = (8, 4, 2)  # of vectors; filled to more than half
TRIGONOMETRIC = (ca.OP_SIN, ca.OP_COS)
Group = tuple[int, ...]  # nodes of angles


def side_by_side(nodes: Sequence[Node], order: Sequence[int]) -> tuple[list[int], dict[int, Group]]:
    """(an order in which all angles of a group are known before the first use, {sine or cosine: its group})."""
    groups = _groups(nodes, order)
    if not groups:
        return list(order), {}
    members: dict[Group, list[int]] = {}
    for k in order:
        if k in groups:
            members.setdefault(groups[k], []).append(k)
    inside, placed, found = set(order), set[int](), list[int]()

    def place(wanted: Sequence[int]) -> None:
        for k in wanted:
            if k in placed or k not in inside:
                continue
            if k in groups:
                place(below(list(nodes), groups[k], lambda one: one in placed))
            together = members[groups[k]] if k in groups else [k]
            found.extend(together)
            placed.update(together)

    place(order)
    return found, groups


def _groups(nodes: Sequence[Node], order: Sequence[int]) -> dict[int, Group]:
    """Groups of angles that wait for equally many sines and cosines, one after another."""
    level: dict[int, int] = {}
    angles: dict[int, list[int]] = {}
    for k in order:
        node = nodes[k]
        used = [one for one in (node.a, node.b) if one != UNUSED and one in level]
        level[k] = max((level[one] + (nodes[one].op in TRIGONOMETRIC) for one in used), default=0)
        if node.op in TRIGONOMETRIC:
            known = angles.setdefault(level[k], [])
            if node.a not in known:
                known.append(node.a)
    group_of: dict[int, Group] = {}
    for known in angles.values():
        while len(known) > 1:
            width = next(one for one in WIDTHS if one < 2 * len(known))
            group, known = tuple(known[:width]), known[width:]
            group_of |= dict.fromkeys(group, group)
    found = ((k, group_of.get(nodes[k].a)) for k in order if nodes[k].op in TRIGONOMETRIC)
    return {k: group for k, group in found if group is not None}
