"""Tapes that are made when they are first looked at."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping

from runtime.contract.tape import Tape


class TapesOnDemand(Mapping[str, Tape]):
    """By name, from what makes each; made once."""

    def __init__(self, makers: Mapping[str, Callable[[], Tape]]) -> None:
        self._makers = makers
        self._made: dict[str, Tape] = {}

    def __getitem__(self, name: str) -> Tape:
        if name not in self._made:
            self._made[name] = self._makers[name]()
        return self._made[name]

    def made(self, always: Collection[str] = ()) -> dict[str, Tape]:
        """Those that were looked at and those of these names, in the order of all."""
        return {name: self[name] for name in self._makers if name in self._made or name in always}

    def __contains__(self, name: object) -> bool:  # without making it
        return name in self._makers

    def __iter__(self) -> Iterator[str]:
        return iter(self._makers)

    def __len__(self) -> int:
        return len(self._makers)
