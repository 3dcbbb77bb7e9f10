"""Fields of a record that are computed when somebody asks for them."""

from __future__ import annotations

from collections.abc import Callable
from threading import Lock
from typing import Any, Self


class Later:
    """A value that is computed once, at the first call."""

    def __init__(self, compute: Callable[[], Any]) -> None:
        self._compute: Callable[[], Any] | None = compute
        self._value: Any = None
        self._lock = Lock()

    def __call__(self) -> Any:
        with self._lock:
            if self._compute is not None:
                self._value, self._compute = self._compute(), None
        return self._value

    def part(self, key: Any) -> Later:
        """An entry of the value."""
        return Later(lambda: self()[key])


class WithLater:
    """A dataclass some of whose fields may be given as `Later`: they are computed when they are read."""

    def __post_init__(self) -> None:
        own = vars(self)
        own["_later"] = {name: value for name, value in own.items() if isinstance(value, Later)}
        for name in own["_later"]:
            del own[name]

    def __getattr__(self, name: str) -> Any:
        later = vars(self).get("_later", {})
        if name not in later:
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        value = later[name]()
        vars(self)[name] = value
        return value

    def __getstate__(self) -> dict[str, Any]:
        for name in vars(self).get("_later", {}):
            getattr(self, name)
        return {**vars(self), "_later": {}}

    def but(self, **changes: Any) -> Self:
        """A copy with other values of some fields; what is computed later stays so."""
        found = object.__new__(type(self))
        vars(found).update(vars(self))
        vars(found)["_later"] = {name: one for name, one in vars(self)["_later"].items() if name not in changes}
        vars(found).update(changes)
        return found
