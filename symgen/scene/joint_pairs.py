"""Joints between the same two markers that together leave nothing free; one joint twice is redundant, not wrong."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from symgen.joints.joint import Joint, Slide, Turn
from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError


def joint_pair_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Two whose free motions have none in common."""
    between: dict[frozenset[str], list[tuple[int, Joint]]] = {}
    for index, joint in enumerate(scene.joints):
        between.setdefault(frozenset((joint.marker_a, joint.marker_b)), []).append((index, joint))
    for joints in between.values():
        for (_, first), (index, second) in combinations(joints, 2):
            path = item_path("joints", index, second.name)
            if _nothing_left(first, second):
                what = f"a {second.type} joint and the {first.type} joint '{first.name}' of the same markers"
                yield SceneError(
                    path, f"{what} leave nothing free", "remove one of them, or take one weld if that is meant"
                )


def _nothing_left(first: Joint, second: Joint) -> bool:
    one, other = _free(first), _free(second)
    return one is not None and other is not None and not one & other


def _free(joint: Joint) -> set[tuple[type[Turn] | type[Slide], int, str]] | None:
    """The motions that a joint leaves free: turn or slide, its axis, the lead of a screw; None where they are no list.

    A drive prescribes what another joint leaves free, and is no such joint.
    """
    if joint.motions is None or joint.drives:
        return None
    return {(type(motion), motion.axis, motion.lead) for motion in joint.motions}
