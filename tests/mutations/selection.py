"""Which tests look at a room, those that see most first. The comparison with checked-in code is not among them."""

from __future__ import annotations

DERIVED = ["tests/laws/test_single_terms.py", "tests/hand_derived", "tests/laws"]
LAST = ["tests"]
ROOMS = {
    "symgen/scene": ["tests/scene", "tests/bad_scenes", "tests/house/test_trust.py"],
    "symgen/modes": ["tests/derivation", "tests/fe", *DERIVED],
    "symgen/fe": ["tests/fe"],
    "symgen": DERIVED,
    "runtime/contract": ["tests/house", "tests/emission", "tests/running", "tests/laws"],
    "runtime/results": ["tests/running", "tests/views", "tests/laws"],
    "runtime/running": ["tests/running", "tests/cases"],
    "runtime/schemes": ["tests/laws", "tests/running"],
    "runtime/studies": ["tests/studies", "tests/laws", "tests/cli"],
    "runtime": ["tests/laws", "tests/running", "tests/studies"],
}
# rooms whose faults a person sees at once, or that only say things
LEFT_OUT = ("symgen/cli", "symgen/scenes", "runtime/views", "runtime/moved.py", "symgen/notation.py")


def selected(path: str) -> list[str]:
    """Test folders for a file, in the order in which to run them."""
    room = max((room for room in ROOMS if path.startswith(room)), key=len)
    return [*dict.fromkeys([*ROOMS[room], *LAST])]
